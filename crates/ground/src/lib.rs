#![doc = include_str!("../README.md")]

mod error;
mod hull;
mod kriging;
mod next;
pub mod profile;
mod same;

pub use error::GroundError;
pub use hull::{contains, convex_hull};
pub use kriging::{Between, Field, LEAST_SITES, MOST_SITES, Site, Variogram};
pub use next::next_places;
pub use same::{groups, p_of_deviations};
