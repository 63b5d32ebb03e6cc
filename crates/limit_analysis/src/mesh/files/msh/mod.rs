//! The format of gmsh, MSH: versions 4.1 and 2.2 in, 4.1 out, as ASCII.

mod build;
mod edges;
mod elements;
mod loops;
mod parts;
mod read;
mod runs;
mod scan;
mod write;

pub use build::{Group, Imported, read_msh};
pub use write::write_msh;

/// Name of the physical group of curves that holds guide edges.
const GUIDES: &str = "guides";
