//! Shows, builds, extends, unites and checks prediction tables.

mod answer;
mod bounds;
mod brackets;
pub mod build;
pub mod check;
mod check_brackets;
mod grid;
mod growth;
pub mod merge;
pub mod show;
mod source;

pub use answer::{Answer, Head, TableCell, Violation};
pub use bounds::{BoundsOptions, BuiltBounds, EmptyNode, Plan};
pub use brackets::{BracketCell, Gaps};
pub use check_brackets::{BracketFindings, Contradiction};
pub use grid::{Grid, Nodes};
pub use source::Source;
