use thiserror::Error;

/// What can go wrong with places.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum GroundError {
    /// Too few places, or too many.
    #[error("there are {count} places with an estimate; what lies between them takes {least} to {most}")]
    Count {
        /// How many there are.
        count: usize,
        /// How many are needed.
        least: usize,
        /// How many are taken.
        most: usize,
    },
    /// Two places at one point.
    #[error(
        "two places are at ({x_m}, {y_m}) m; give the strokes there one name of a place, or other coordinates"
    )]
    SamePoint {
        /// Where, along x in m.
        x_m: f64,
        /// Along y in m.
        y_m: f64,
    },
    /// A value that is no interval, or no finite number.
    #[error(
        "a place at ({x_m}, {y_m}) m has the interval {low} to {high}; it must be two finite numbers, the first below the second"
    )]
    BadSite {
        /// Where, along x in m.
        x_m: f64,
        /// Along y in m.
        y_m: f64,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// Places whose distances differ by more than double precision bears.
    #[error(
        "the distances of the places differ too much to weigh them; leave out one of two that are close together"
    )]
    Unsolvable,
}
