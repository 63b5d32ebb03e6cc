//! Upper bounds on problems whose exact answer is known.

mod clay;
mod gap;
mod grounds;
mod layers;
mod sand;

use soilctl_certificate::{Statement, prove_upper};

use super::Upper;
use crate::accuracy::{self, solve_through};
use crate::adapt::wanted_sizes;
use crate::fields::{Piece, VelocityField};
use crate::mesh::{Guide, Request, SizeField, generate};
use crate::problem::Problem;
use crate::start::Start;
use crate::topology::Topology;
use crate::vector::twice_area;

/// A bound as it was proven, with what the program made of it.
struct Found {
    proven: f64,
    objective: f64,
    elements: usize,
}

/// What is not matched is most where the strain rate varies.
fn roughness(velocity: &VelocityField) -> Vec<f64> {
    let of = |piece: &Piece| {
        let [a, b, c] = piece.rates;
        let far = |p: [f64; 4], q: [f64; 4]| (0..3).map(|i| (p[i] - q[i]).abs()).sum::<f64>();
        let [p, q, r] = piece.corners;
        twice_area([p, q, r]) * (far(a, b) + far(b, c) + far(c, a))
    };
    velocity.pieces.iter().map(|pieces| pieces.iter().map(of).sum()).collect()
}

/// Solves and proves on a first mesh and on ones of about so many elements, with the slip lines of one mesh on the next.
fn bounds(statement: &Statement, targets: &[usize]) -> Vec<Found> {
    let problem = Problem::new(statement.clone()).unwrap();
    let start = Start::new(&problem);
    let mut guides: Vec<Guide> = start.guides.clone();
    let mut found = Vec::new();
    let mut sizes = None;
    for level in 0..=targets.len() {
        let mobile = start.mobile(level, &guides);
        let mut all = guides.clone();
        all.extend(mobile.guide());
        let request = Request {
            statement: problem.statement(),
            guides: &all,
            fans: &start.fans(level),
            size: &|p| sizes.as_ref().map_or_else(|| start.size(p), |f: &SizeField| f.size(p)),
            max_triangles: 100_000,
        };
        let mesh = generate(&request).unwrap();
        let topology = Topology::new(&mesh);
        for tightening in [1e-6, 1e-5, 1e-4] {
            let upper = Upper::new(&problem, &mesh, &topology, &mobile.still(&mesh), tightening);
            let answer = solve_through(&upper.program, accuracy::FLOW);
            let field = upper.saved(&mesh, &answer.x);
            let (elements, objective) = (mesh.triangles.len(), upper.force.value(&answer.x));
            let proven = prove_upper(statement, &field);
            println!(
                "{elements} elements, {} unknowns, {} rows, tightened {tightening:e}: {:?}, {} steps, {:.2} s: \
                 {objective:.6} {proven:?}",
                upper.program.unknowns,
                upper.program.rows.len(),
                answer.status,
                answer.iterations,
                answer.seconds
            );
            let velocity = VelocityField::new(&upper, &answer.x);
            guides = crate::slip::guides(&problem, &mesh, &topology, &velocity, &start.tips);
            if let Some(target) = targets.get(level) {
                let shares = roughness(&velocity);
                sizes = Some(wanted_sizes(&mesh, &shares, *target, start.largest).unwrap());
            }
            if let Ok(proven) = proven {
                found.push(Found { proven, objective, elements });
                break;
            }
        }
        assert_eq!(found.len(), level + 1, "nothing was proven");
    }
    found
}

/// Checks that all bounds are above the exact value, as the programs say, and the last one by no more than a fraction.
fn near_from_above(found: &[Found], exact: f64, fraction: f64) {
    for f in found {
        assert!(f.proven >= exact * (1.0 - 1e-9), "{} {exact}", f.proven);
        assert!((f.proven - f.objective).abs() < 1e-4 * exact, "{} {}", f.proven, f.objective);
    }
    let last = found.last().unwrap();
    assert!(last.proven <= exact * (1.0 + fraction), "{} {exact}, {} elements", last.proven, last.elements);
}
