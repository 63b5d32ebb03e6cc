//! Meshes in the file formats of other programs: VTU for ParaView, MSH of gmsh, SVG for the eye.
//!
//! Everything is made from and to text in memory. The same mesh gives the same text.

mod arrays;
mod base64;
mod error;
mod msh;
mod svg;
mod vtu;

pub use error::FileError;
pub use msh::{Group, Imported, read_msh, write_msh};
pub use svg::Svg;
pub use vtu::{Encoding, Field, Layout, Vtu};
