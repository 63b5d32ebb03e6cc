#![doc = include_str!("../README.md")]

mod distributions;
mod false_discovery;
mod least_squares;
mod line;
mod order;

pub use distributions::{chi_square_tail, normal_quantile, normal_tail, t_quantile, two_sided_p};
pub use false_discovery::benjamini_hochberg;
pub use least_squares::{Solved, huber, least_squares};
pub use line::Line;
pub use order::{mean_and_sd, median, median_absolute_deviation, noise, quantile, sd_of_median_abs};
