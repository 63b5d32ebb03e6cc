//! From an outline of straight lines to a graded triangulation.
//!
//! [`generate`] checks the outline ([`check`]), cuts its lines into pieces as long as the wanted size says,
//! puts fans around the corners that ask for one, weaves the guides in, refines by Delaunay insertion and smooths. The
//! triangulating itself is done by `spade`.

mod cavity;
mod check;
mod cut;
mod domain;
mod error;
mod extract;
mod fan;
mod flood;
mod generate;
mod guide;
mod place;
mod quality;
mod refine;
mod size;
mod smooth;
mod split;
mod start;
mod triangulation;
mod trim;
mod wanted;
mod weave;
mod work;

pub use domain::check;
pub use error::MeshError;
pub use extract::Mesh;
pub(crate) use extract::vertex_on_edge;
pub use fan::Fan;
pub use generate::{Request, generate};
pub use guide::Guide;
pub use quality::Quality;
pub use size::SizeField;
