//! Lower and upper bounds on plane-strain collapse loads, by finite-element limit analysis.
//!
//! A rigid structure is pushed through soil that obeys Mohr and Coulomb with associated flow. The lower bound is the
//! largest force of any stress field in equilibrium that the soil can bear; the upper bound the least of any flow that
//! dilates as friction demands. Both are cone programs on triangular meshes, solved by Clarabel; what is reported is
//! never the solver's objective but what [`soilctl_certificate`] proves about the field that the solver found.
//!
//! ```no_run
//! use soilctl_limit_analysis::{EmbeddedPlate, Options, bound};
//!
//! let plate = EmbeddedPlate { alpha_deg: 90.0, phi_deg: 30.0, delta_deg: 15.0, ..EmbeddedPlate::default() };
//! let bounds = bound(&plate.problem()?, &Options::default(), &mut |_, _| {})?;
//! println!("{} to {}", bounds.lower.value, bounds.upper.value);
//! # Ok::<(), soilctl_limit_analysis::LimitError>(())
//! ```

mod adapt;
mod bound;
mod bowl;
pub mod describe;
mod error;
mod fields;
mod form;
mod gap;
#[cfg(test)]
mod known;
mod lower;
pub mod mesh;
mod plate;
mod problem;
mod program;
pub mod results;
mod runs;
mod singular;
mod slip;
mod solver;
mod start;
mod strength;
mod topology;
mod upper;

pub use bound::{Bound, Bounds, Ended, IDENTITY, Level, Options, Solve, StoppedBy, bound};
pub use describe::{Described, Description, DescriptionError};
pub use error::LimitError;
pub use plate::{EmbeddedPlate, MAX_ANGLE_SUM_DEG};
pub use problem::Problem;
pub use solver::{Factorisation, Status};
pub use strength::{SafetyBounds, SafetyProof, Trial, factor_of_safety};

/// A mesh as certificates store it.
fn saved_mesh(mesh: &mesh::Mesh) -> soilctl_certificate::Mesh {
    let place = |place: mesh::Place| match place {
        mesh::Place::Corner(point) => soilctl_certificate::Place::Corner { point },
        mesh::Place::OnLine { line, s } => soilctl_certificate::Place::OnLine { line, s },
        mesh::Place::Inside => soilctl_certificate::Place::Inside,
    };
    soilctl_certificate::Mesh {
        vertices: mesh
            .vertices
            .iter()
            .map(|v| soilctl_certificate::Vertex { position: v.position, place: place(v.place) })
            .collect(),
        triangles: mesh
            .triangles
            .iter()
            .map(|t| soilctl_certificate::Triangle { corners: t.corners, region: t.region })
            .collect(),
    }
}
