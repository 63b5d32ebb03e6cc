//! Figures and page of the strokes of logs.

pub(crate) mod figures;
mod page;

pub use figures::{Kind, figure};
pub use page::page;
