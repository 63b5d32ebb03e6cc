use thiserror::Error;

/// Why there is no drawing.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A file that is malformed.
    #[error("line {line} of the drawing: {reason}")]
    Malformed {
        /// Line of the file, from 1 on.
        line: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// A file of another kind.
    #[error("the drawing cannot be read: {0}")]
    Kind(String),
    /// More than is read.
    #[error("the drawing has {count} {what}; at most {limit} are read: save the section alone")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How much there is.
        count: usize,
        /// How much may be.
        limit: usize,
    },
    /// A coordinate that is not finite, or too far away.
    #[error(
        "layer {layer} has the coordinate {value} m; coordinates must be within 1000 km: is the unit right?"
    )]
    Coordinate {
        /// Name of the layer.
        layer: String,
        /// The coordinate in metres.
        value: f64,
    },
}
