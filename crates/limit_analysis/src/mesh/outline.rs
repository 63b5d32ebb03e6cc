/// The geometry of a problem: corner points, straight lines between them, and regions bounded by loops of lines.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outline {
    /// Corner points, x and y.
    pub points: Vec<[f64; 2]>,
    /// Straight lines between corner points.
    pub lines: Vec<Line>,
    /// Regions of soil.
    pub regions: Vec<RegionOutline>,
}

/// A straight line between two corner points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Line {
    /// Index of the first point.
    pub from: usize,
    /// Index of the last point.
    pub to: usize,
}

/// A line as a region's boundary runs along it: in its own direction or against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LineUse {
    /// Index of the line.
    pub line: usize,
    /// Whether the boundary runs from the line's first point to its last.
    pub forward: bool,
}

/// One region: closed loops with the region on their left (outer loop counter-clockwise, holes clockwise). A line used
/// twice, once in each direction, is a slit: a thin plate.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct RegionOutline {
    /// Loops of lines, end to end.
    pub loops: Vec<Vec<LineUse>>,
}
