//! Bounds on many problems with known answers, on one coarse mesh each: no answer is contradicted.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]
#![allow(clippy::print_stdout, reason = "how many bounds were proven")]

mod families;
#[path = "../../tests/exact/grounds.rs"]
#[allow(dead_code, reason = "shared with tests that use more of it")]
mod grounds;
#[path = "../../tests/exact/infinite.rs"]
#[allow(dead_code, reason = "shared with tests that use more of it")]
mod infinite;
#[path = "../../tests/exact/prandtl.rs"]
mod prandtl;

use std::sync::atomic::{AtomicUsize, Ordering};

use soilctl_certificate::{Statement, prove_lower, prove_upper};

use crate::lower::Lower;
use crate::lower::tests::common;
use crate::mesh::{Request, generate};
use crate::problem::Problem;

use crate::accuracy;
use crate::start::Start;
use crate::topology::Topology;
use crate::upper::Upper;
use families::{Known, plates, random};

/// Edges are so many times as long as on the first mesh of a run, where they are not the longest there are.
const COARSER: f64 = 2.0;

/// Part of the lower and of the upper bounds that must be proven on meshes as coarse as that.
const PROVEN: [f64; 2] = [0.8, 0.95];

const TIGHTENING: [f64; 3] = [1e-6, 1e-5, 1e-4];
const LOWER_TIGHTENING: [f64; 3] = [3e-9, 3e-7, 1e-5];

/// What is proven about a problem from its first mesh, made coarser.
fn bounds(statement: Statement) -> [Option<f64>; 2] {
    let problem = Problem::new(statement).unwrap();
    problem.covered().unwrap();
    let begin = Start::new(&problem);
    let mobile = begin.mobile(0, &begin.guides);
    let mut guides = begin.guides.clone();
    guides.extend(mobile.guide());
    let mesh = generate(&Request {
        statement: problem.statement(),
        guides: &guides,
        fans: &begin.fans(0),
        size: &|p| (COARSER * begin.size(p)).min(begin.largest),
        max_triangles: 20_000,
    })
    .unwrap();
    let topology = Topology::new(&mesh);
    let lower = LOWER_TIGHTENING.into_iter().find_map(|tightening| {
        let lower = Lower::new(&problem, &mesh, &topology, tightening);
        let x = lower
            .drawn_inside(&accuracy::solve_through(&lower.program, accuracy::STRESS).x, -0.5 * tightening);
        let field = lower.function.saved(&mesh, &topology, &problem, &x);
        prove_lower(problem.statement(), &field).ok()
    });
    let still = mobile.still(&mesh);
    let upper = TIGHTENING.into_iter().find_map(|tightening| {
        let upper = Upper::new(&problem, &mesh, &topology, &still, tightening);
        let field = upper.saved(&mesh, &accuracy::solve_through(&upper.program, accuracy::FLOW).x);
        prove_upper(problem.statement(), &field).ok()
    });
    [lower, upper]
}

/// What was proven about one problem.
struct Checked {
    proven: [bool; 2],
    gap_percent: Option<f64>,
    /// Its name, if a bound is missing.
    unproven: Option<String>,
}

/// Checks that both bounds of a problem agree with what is known.
fn check(Known { name, statement, value: [low, high] }: Known) -> Checked {
    let [lower, upper] = bounds(statement);
    let rounding = 1e-9 * high.abs();
    assert!(lower.is_none_or(|l| l <= high + rounding), "{name}: {lower:?} against {low} to {high}");
    assert!(upper.is_none_or(|u| u >= low - rounding), "{name}: {upper:?} against {low} to {high}");
    let gap_percent = lower.zip(upper).map(|(l, u)| 200.0 * (u - l) / (u + l).abs());
    let unproven = gap_percent.is_none().then_some(name);
    Checked { proven: [lower.is_some(), upper.is_some()], gap_percent, unproven }
}

/// Checks all problems, on all cores, and that most bounds are proven and a third of the problems has soil without cohesion.
fn none_contradicted(count: usize, problem: impl Fn(usize) -> Known + Sync) {
    let (next, sands) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let work = || {
        let mut all = Vec::new();
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            if place >= count {
                break all;
            }
            let known = problem(place);
            sands.fetch_add(usize::from(known.has_sand()), Ordering::Relaxed);
            all.push(check(known));
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let all: Vec<Checked> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    let proven = [0, 1].map(|side| all.iter().filter(|one| one.proven[side]).count());
    let mut gaps: Vec<f64> = all.iter().filter_map(|one| one.gap_percent).collect();
    gaps.sort_by(f64::total_cmp);
    let mut unproven: Vec<&String> = all.iter().filter_map(|one| one.unproven.as_ref()).collect();
    unproven.sort();
    let sands = sands.into_inner();
    println!(
        "of {count}, {sands} with soil without cohesion: {proven:?} proven, median gap {:.1} %",
        gaps[gaps.len() / 2]
    );
    println!("not proven: {unproven:?}");
    assert!(3 * sands >= count, "{sands} of {count}");
    let enough = |(n, part): (usize, f64)| n as f64 >= part * count as f64;
    assert!(proven.into_iter().zip(PROVEN).all(enough), "{proven:?} of {count}: {unproven:?}");
}

#[test]
fn no_known_answer_is_contradicted() {
    let some: Vec<Known> = plates().into_iter().step_by(96).collect();
    none_contradicted(some.len() + 24, |place| some.get(place).cloned().unwrap_or_else(|| random(place, 1)));
}

/// As many problems as the environment says, 1,000 without it, among them all plates of Hong (2001).
#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_no_answer_of_thousands_is_contradicted() {
    let count = std::env::var("KNOWN").map_or(1000, |count| count.parse().unwrap());
    let plates = plates();
    none_contradicted(count, |place| plates.get(place).cloned().unwrap_or_else(|| random(place, 2)));
}
