use spade::InsertionError;
use thiserror::Error;

/// Why there is no mesh. Points, lines, regions and loops are named by their index in the outline.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// Nothing to mesh.
    #[error("the outline has no {what}; give at least one region bounded by at least three lines")]
    Empty {
        /// What is missing.
        what: &'static str,
    },
    /// More input than is taken.
    #[error("the outline has {count} {what}, the limit is {limit}; simplify it")]
    TooMuch {
        /// What there is too much of.
        what: &'static str,
        /// How many were given.
        count: usize,
        /// How many are taken.
        limit: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("point {point} is at ({x}, {y}); coordinates must be finite numbers")]
    NotFinite {
        /// The point.
        point: usize,
        /// Its first coordinate.
        x: f64,
        /// Its second coordinate.
        y: f64,
    },
    /// Coordinates too large or too small to compute with.
    #[error("the largest coordinate is {magnitude:e}; it must be between 1e-30 and 1e30, use SI units")]
    Magnitude {
        /// Largest absolute coordinate.
        magnitude: f64,
    },
    /// A line names a point that does not exist.
    #[error("line {line} uses point {point}, but there are {count} points (0 to {count} - 1)")]
    NoSuchPoint {
        /// The line.
        line: usize,
        /// The point it names.
        point: usize,
        /// How many points there are.
        count: usize,
    },
    /// A loop names a line that does not exist.
    #[error("region {region}, loop {ring} uses line {line}, but there are {count} lines (0 to {count} - 1)")]
    NoSuchLine {
        /// The region.
        region: usize,
        /// The loop.
        ring: usize,
        /// The line it names.
        line: usize,
        /// How many lines there are.
        count: usize,
    },
    /// A line has no length, or next to none.
    #[error(
        "line {line} is {length:e} m long; it must be longer than {least:e} m, 1e-9 of the outline; merge its ends"
    )]
    ShortLine {
        /// The line.
        line: usize,
        /// Its length.
        length: f64,
        /// The least length.
        least: f64,
    },
    /// Two points at one place.
    #[error(
        "points {first} and {second} are both at ({x}, {y}), closer than {least:e} m; use one point for both"
    )]
    CoincidentPoints {
        /// One point.
        first: usize,
        /// The other point.
        second: usize,
        /// Where.
        x: f64,
        /// Where.
        y: f64,
        /// Least distance.
        least: f64,
    },
    /// Lines of a loop are not end to end.
    #[error(
        "region {region}, loop {ring}: line {line} ends at point {end}, but the next line, {next}, starts at point \
         {start}; loops must be closed, each line starting where the one before ends"
    )]
    OpenLoop {
        /// The region.
        region: usize,
        /// The loop.
        ring: usize,
        /// The line at whose end there is a gap.
        line: usize,
        /// The point where it ends.
        end: usize,
        /// The line after it.
        next: usize,
        /// The point where that starts.
        start: usize,
    },
    /// One side of a line bounds two regions, or one region twice.
    #[error(
        "line {line} is used twice {direction} (by regions {first} and {second}); each side of a line bounds one region"
    )]
    UsedTwice {
        /// The line.
        line: usize,
        /// "forwards" or "backwards".
        direction: &'static str,
        /// The region that used it first.
        first: usize,
        /// The region that used it again.
        second: usize,
    },
    /// A line that no loop uses.
    #[error("line {line} is in no loop; a line inside a region is a slit: use it once in each direction")]
    UnusedLine {
        /// The line.
        line: usize,
    },
    /// A region is negative: its loops run the wrong way round.
    #[error(
        "region {region} has the area {area} m2; it must be positive: outer loops counter-clockwise, holes clockwise"
    )]
    Orientation {
        /// The region.
        region: usize,
        /// Its area as given.
        area: f64,
    },
    /// Lines cross.
    #[error("lines {first} and {second} cross; lines may meet only in common points, cut both there")]
    Crossing {
        /// One line.
        first: usize,
        /// The other line.
        second: usize,
    },
    /// Two lines between the same points.
    #[error("lines {first} and {second} join the same points; use one line for both")]
    DoubleLine {
        /// One line.
        first: usize,
        /// The other line.
        second: usize,
    },
    /// A point lies on a line that it does not belong to.
    #[error(
        "point {point} at ({x}, {y}) lies on line {line} (closer than {least:e} m) without being an end of it; cut \
         the line there"
    )]
    Touching {
        /// The line.
        line: usize,
        /// The point.
        point: usize,
        /// Where.
        x: f64,
        /// Where.
        y: f64,
        /// Least distance.
        least: f64,
    },
    /// Two regions, or a region and the outside, claim the same ground.
    #[error(
        "{first} on one side of line {first_line} overlaps {second} on one side of line {second_line}; regions must \
         not overlap, outer loops are counter-clockwise and holes clockwise"
    )]
    Overlap {
        /// One claim: "region 3" or "the outside".
        first: String,
        /// The other claim.
        second: String,
        /// A line where the first claim is made.
        first_line: usize,
        /// A line where the second claim is made.
        second_line: usize,
    },
    /// The wanted size is not a length.
    #[error("the wanted size at ({x}, {y}) is {size} m; it must be positive")]
    BadSize {
        /// Where.
        x: f64,
        /// Where.
        y: f64,
        /// The size.
        size: f64,
    },
    /// Samples from which no size field can be made.
    #[error("size field: {what} is {value}; it must be {allowed}")]
    BadField {
        /// Which input.
        what: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A guide has a coordinate that is not finite.
    #[error("guide {guide}, point {point} is at ({x}, {y}); coordinates must be finite numbers")]
    BadGuide {
        /// The guide.
        guide: usize,
        /// The point in it.
        point: usize,
        /// Its first coordinate.
        x: f64,
        /// Its second coordinate.
        y: f64,
    },
    /// A fan that cannot be made.
    #[error("fan {fan}: {what} is {value}; it must be {allowed}")]
    BadFan {
        /// The fan.
        fan: usize,
        /// Which input.
        what: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The wanted size asks for more triangles than are allowed.
    #[error(
        "the mesh needs more than {limit} triangles (there were {count} when it stopped); ask for larger elements or \
         allow more triangles"
    )]
    TooManyTriangles {
        /// Triangles, or what they come to by estimate, when the work stopped.
        count: usize,
        /// The largest number allowed.
        limit: usize,
    },
    /// Rounding errors got the better of the triangulation.
    #[error("cannot triangulate near ({x}, {y}): {reason}; the outline has details too small for its extent")]
    Numerical {
        /// Where.
        x: f64,
        /// Where.
        y: f64,
        /// What happened.
        reason: String,
    },
}

impl MeshError {
    pub(super) fn insertion(at: [f64; 2], source: InsertionError) -> Self {
        Self::Numerical { x: at[0], y: at[1], reason: source.to_string() }
    }
}
