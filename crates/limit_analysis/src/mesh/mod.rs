//! From an outline of straight lines to a graded triangulation.
//!
//! [`generate`] checks the outline ([`Outline::check`]), cuts its lines into pieces as long as the wanted size says,
//! puts fans around the corners that ask for one, weaves the guides in, refines by Delaunay insertion and smooths. The
//! triangulating itself is done by `spade`. [`structured`] makes the classic meshes of cells instead, and [`files`]
//! writes meshes for other programs and reads those of gmsh.

mod cavity;
mod check;
mod cut;
mod domain;
mod error;
mod extract;
mod fan;
pub mod files;
mod flood;
mod generate;
mod guide;
mod outline;
mod place;
mod quality;
mod refine;
mod size;
mod smooth;
mod split;
mod start;
pub mod structured;
mod triangulation;
mod trim;
mod vector;
mod wanted;
mod weave;
mod work;

pub use error::MeshError;
pub use extract::{Mesh, Place, Triangle, Vertex};
pub use fan::Fan;
pub use generate::{Request, generate};
pub use guide::Guide;
pub use outline::{Line, LineUse, Outline, RegionOutline};
pub use quality::Quality;
pub use size::SizeField;
