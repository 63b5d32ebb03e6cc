#![doc = include_str!("../README.md")]

mod error;
mod find;
mod gltf;
mod load;
mod shape;
mod stl;

pub use error::MeshError;
pub use find::{Sought, find};
pub use load::{Budget, load};
pub use shape::{MOST_BYTES, MOST_TRIANGLES, Mesh, Part};
