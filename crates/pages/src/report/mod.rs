//! The page of `report`: the estimate with its figures and what they mean.

mod budget;
mod curves;
mod page;
mod shear;

pub use page::page;
