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

use soilctl_certificate::{Statement, prove_lower, prove_upper};

use crate::lower::Lower;
use crate::lower::tests::common;
use crate::mesh::{Request, generate};
use crate::problem::Problem;

use crate::accuracy;
use crate::start::Start;
use crate::topology::Topology;
use crate::upper::Upper;
use families::{Known, Random, plates, random};

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

/// Checks that both bounds of each problem agree with what is known, and that most are proven.
fn none_contradicted(problems: Vec<Known>) {
    let (count, mut proven) = (problems.len(), [0, 0]);
    let (mut gaps, mut unproven) = (Vec::new(), Vec::new());
    for Known { name, statement, value: [low, high] } in problems {
        let [lower, upper] = bounds(statement);
        let rounding = 1e-9 * high.abs();
        assert!(lower.is_none_or(|l| l <= high + rounding), "{name}: {lower:?} against {low} to {high}");
        assert!(upper.is_none_or(|u| u >= low - rounding), "{name}: {upper:?} against {low} to {high}");
        match [lower, upper] {
            [Some(l), Some(u)] => gaps.push(200.0 * (u - l) / (u + l).abs()),
            _ => unproven.push(name),
        }
        proven[0] += usize::from(lower.is_some());
        proven[1] += usize::from(upper.is_some());
    }
    gaps.sort_by(f64::total_cmp);
    println!("of {count}: {proven:?} proven, median gap {:.1} %", gaps[gaps.len() / 2]);
    println!("not proven: {unproven:?}");
    let enough = |(n, part): (usize, f64)| n as f64 >= part * count as f64;
    assert!(proven.into_iter().zip(PROVEN).all(enough), "{proven:?} of {count}: {unproven:?}");
}

#[test]
fn no_known_answer_is_contradicted() {
    let mut source = Random::new(1);
    let some = (0..44).map(|i| random(i, &mut source));
    none_contradicted(some.chain(plates().into_iter().step_by(48)).collect());
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_no_answer_of_a_thousand_is_contradicted() {
    let mut source = Random::new(2);
    let plates = plates();
    let others = (0..1000 - plates.len()).map(|i| random(i, &mut source));
    none_contradicted(others.chain(plates).collect());
}
