//! Lower bounds on the force of an upright plate with ends, by stress fields in space.
//!
//! A plate of some width is moved ahead in soil with friction and weight only. About its end tetrahedra carry a stress, between
//! its ends triangles, the same across; what both are, and why they prove a bound, is told by
//! [`prove_end`](soilctl_certificate::prove_end). Units are the plate's depth and the soil's weight; x is ahead, s across, z
//! upwards; pressures are positive.
//!
//! # The program
//!
//! Unknowns are the tractions on the faces of tetrahedra and the edges of triangles at their vertices, in units of the pressure
//! of the ground at rest. From them follow stresses that are linear in each part of a simplex cut at its centroid ([`element`]).
//!
//! ```text
//! maximise    (2 F + (w - 2 b) h)/w                  F on the plate in the box, h on the section, b the reach of the box
//! subject to  forces and moments of each simplex balance, with the weight
//!             P - t >= 0,  K t - P >= 0              at each vertex of each part, with a number t there
//!             tan(delta) P_xx >= |(P_xs, P_xz)|      at each vertex on either side of the plate
//!             d/K <= p <= K d                        in planes of the box, with the ground at rest beyond
//! ```
//!
//! where `>= 0` of a matrix says that it has no negative eigenvalue, and `K = (1 + sin(phi))/(1 - sin(phi))`. In the section `P`
//! has `P_ss = f`, the pressure on the side of the box, and no shear across: so `P - t` is a second-order cone and `f - t >= 0`.
//!
//! # Meshes
//!
//! The first is coarse. The multipliers of `P - t` and `K t - P` are the two parts of the rate of yielding, which differ where the
//! soil yields: tetrahedra and triangles in which it yields most are bisected, and the next program is solved ([`adapt`]). The
//! field with the greatest force is returned. All is on one thread; the same input gives the same bits on a machine of the same
//! kind, unless it is stopped or limited in time.
//!
//! # What they find
//!
//! `K = 2 F/cos(delta)` per unit width, proven, with the tetrahedra of the last of six meshes; without ends, nearly exactly; by a
//! mechanism of blocks in space, from above:
//!
//! | phi, delta | width | tetrahedra | K | without ends | from above |
//! |---|---|---|---|---|---|
//! | 30, 15 | 2 | 1,203 | 5.516 | 4.311 | 6.383 |
//! | 30, 15 | 5 | 1,210 | 4.794 | 4.311 | 5.196 |
//! | 40, 25 | 5 | 2,007 | 13.172 | 11.332 | 15.396 |
//! | 40, 25 | 10 | 2,002 | 12.227 | 11.332 | 13.664 |
//!
//! # Sources
//!
//! - Johnson & Mercier (1978), Some equilibrium finite element methods for two-dimensional elasticity problems. Numer. Math. 30,
//!   103-116; Krizek (1982), An equilibrium finite element method in three-dimensional elasticity. Apl. Mat. 27, 46-75: the
//!   elements.
//! - Krabbenhoft, Lyamin & Sloan (2008), Three-dimensional Mohr-Coulomb limit analysis using semidefinite programming. Commun.
//!   Numer. Methods Eng. 24, 1107-1119; Martin & Makrodimopoulos (2008), Finite-element limit analysis of Mohr-Coulomb materials in
//!   3D using semidefinite programming. J. Eng. Mech. 134, 339-347: strength by two semidefinite cones.
//! - Rivara (1991), Local modification of meshes for adaptive and/or multigrid finite-element methods. J. Comput. Appl. Math. 36,
//!   79-89: bisection.

mod adapt;
mod complex;
mod corners;
mod element;
mod field;
mod options;
mod program;
mod region;
mod response;
mod section;
mod shake;
mod sheets;
mod simplices;
mod strength;
#[cfg(all(test, target_os = "linux", target_pointer_width = "64"))]
mod tests;

use std::sync::atomic::Ordering;

use soilctl_conic::{Factorisation, How, Status, solve};
use web_time::Instant;

use crate::accuracy::SPACE;
use crate::error::{LimitError, in_range};
use adapt::Lengths;
use complex::Complex;
use program::Assembled;
use region::Region;
use simplices::Simplices;
use strength::{Strengths, force};

pub use options::{EndLevel, EndLower, EndOptions};

/// Looks for the stress field that proves most of the force of a thin upright plate with two ends, moved ahead, in soil with
/// weight and friction only, at one width over its depth. The field holds at every width that is not below the part about both
/// ends. The callback is told of each mesh that was solved.
///
/// # Errors
///
/// An angle or the width is out of range: friction of the soil from 5 to 50 degrees, of the plate up to that of the soil, and a
/// width of at least a tenth of the depth. The system is not Linux with addresses of 64 bits. No field was found before the time was up or a stop was set, or by numerical trouble.
pub fn end_lower(
    phi_deg: f64,
    delta_deg: f64,
    width_ratio: f64,
    options: &EndOptions,
    progress: &mut dyn FnMut(&EndLevel),
) -> Result<EndLower, LimitError> {
    in_range("friction angle of the soil", phi_deg, 5.0, 50.0_f64.next_up(), "degrees")?;
    in_range("friction angle of the plate", delta_deg, 0.0, phi_deg.next_up(), "degrees")?;
    in_range("width over depth", width_ratio, 0.1, 1e6_f64.next_up(), "")?;
    let start = Instant::now();
    let strengths = Strengths::new(phi_deg, delta_deg);
    let region = Region::new(phi_deg, width_ratio);
    let mut mesh = region.first();
    let mut lengths = Lengths::default();
    let (mut best, mut levels) = (None::<EndLower>, Vec::new());
    let first = mesh.cells.len() as f64;
    for step in 1..=options.steps + 1 {
        let complex = Complex::new(&mesh);
        let section = section::cut(&complex, &lengths);
        let assembled = Assembled::new(complex, &section, &strengths, width_ratio);
        let seconds = options.max_seconds.map(|most| (most - start.elapsed().as_secs_f64()).max(0.0));
        let how = How { accuracy: SPACE, factorisation: Some(FACTORISATION), seconds, dump: None };
        let answer = solve(&assembled.program, how, options.stops.each_ref())?;
        let value = assembled.force.value(&answer.x);
        let level = EndLevel {
            tetrahedra: mesh.cells.len(),
            triangles: section.cells.len(),
            value,
            between: force(&assembled.section.0, &assembled.section.1).value(&answer.x),
            status: answer.status,
            iterations: answer.iterations,
            seconds: start.elapsed().as_secs_f64(),
        };
        progress(&level);
        levels.push(level);
        if !matches!(answer.status, Status::Solved | Status::Almost) {
            break;
        }
        if best.as_ref().is_none_or(|best| best.value < value) {
            let field = field::field(&assembled, &section, &answer.x);
            best = Some(EndLower { field, value, levels: Vec::new() });
        }
        let is_stopped = options.stops.iter().any(|stop| stop.load(Ordering::Relaxed));
        if is_stopped || step > options.steps {
            break;
        }
        let growth = (options.tetrahedra as f64 / first).max(1.0).powf(step as f64 / options.steps as f64);
        refine(&mut mesh, &region, &assembled, &answer.multipliers, (first * growth) as usize);
        lengths = Lengths::new(&section, &assembled, &answer.multipliers);
    }
    match best {
        Some(best) => Ok(EndLower { levels, ..best }),
        None => Err(no_field(levels.last().map(|level| level.status))),
    }
}

/// Programs of this kind are connected so much that faer, which works by blocks, is several times as fast at all sizes.
const FACTORISATION: Factorisation =
    if cfg!(target_pointer_width = "64") { Factorisation::Faer } else { Factorisation::Qdldl };

/// Cuts tetrahedra where the soil yields, and moves the new vertices a little.
fn refine(
    mesh: &mut Simplices<3, 4>,
    region: &Region,
    assembled: &Assembled,
    multipliers: &[f64],
    most: usize,
) {
    let from = mesh.vertices.len();
    adapt::refine(mesh, assembled, multipliers, most);
    shake::shake(mesh, region, from);
}

fn no_field(status: Option<Status>) -> LimitError {
    let (why, advice) = match status {
        Some(Status::Stopped) => ("the run was stopped, or its time was up, too early", "allow more time"),
        // Soil at rest has a field, and the force on the plate a limit: a program that denies either is rounding.
        None
        | Some(Status::Failed | Status::Infeasible | Status::Unbounded | Status::Solved | Status::Almost) => {
            ("the solver ended in numerical trouble", "try another width, or angles that differ a little")
        }
    };
    LimitError::NoField { why, advice }
}
