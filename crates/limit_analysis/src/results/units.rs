use super::Point;

/// What one unit of a statement is, for files and pictures.
#[derive(Debug, Clone, PartialEq)]
pub struct Units {
    /// Where the statement's origin is, in units of `length`'s name.
    pub origin: Point,
    /// One unit of length.
    pub length: f64,
    /// Name of the unit of length.
    pub length_name: String,
    /// One unit of stress.
    pub stress: f64,
    /// Name of the unit of stress.
    pub stress_name: String,
}

impl Units {
    /// A point of the statement.
    #[must_use]
    pub fn point(&self, p: Point) -> Point {
        [0, 1].map(|axis| self.origin[axis] + self.length * p[axis])
    }
}
