//! Figures and pages of solutions of limit analysis.

mod blocks;
mod contact;
mod end;
mod field;
mod frame;
mod interfaces;
mod mechanism;
mod members;
mod page;
mod plot;
mod trails;

pub(crate) use interfaces::{between_soils, water_table};
pub(crate) use page::{PageContent, bounds_table, level_table, page, proven, round};
pub use plot::{Kind, check, save};
