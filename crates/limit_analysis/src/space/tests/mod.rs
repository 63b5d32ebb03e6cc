//! Fields about the end of a plate: elements, meshes, programs and what comes of them.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod bounds;
mod meshes;
mod states;
