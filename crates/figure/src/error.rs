//! The one error type of this crate.

/// Largest magnitude of a coordinate that can be drawn.
pub(crate) const MAX_MAGNITUDE: f64 = 1e100;
/// Smallest positive value accepted on a logarithmic axis.
pub(crate) const MIN_POSITIVE: f64 = 1e-100;

/// Why a figure or a report part was refused.
///
/// Every message names the offending value, what is allowed and what to do.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FigureError {
    /// A coordinate is NaN, infinite or of absurd magnitude.
    #[error(
        "layer \"{layer}\": {what}[{index}] = {value} cannot be drawn; allowed are finite values \
         between -1e100 and 1e100; remove or repair this value"
    )]
    NotFinite {
        /// Name of the layer.
        layer: String,
        /// Which sequence of the layer the value is in.
        what: &'static str,
        /// Position in that sequence.
        index: usize,
        /// The value itself.
        value: f64,
    },
    /// A value at or below zero meets a logarithmic axis.
    #[error(
        "layer \"{layer}\": {what}[{index}] = {value} lies on a logarithmic axis; allowed are values \
         of at least 1e-100; drop the value or use a linear axis"
    )]
    NotPositive {
        /// Name of the layer.
        layer: String,
        /// Which sequence of the layer the value is in.
        what: &'static str,
        /// Position in that sequence.
        index: usize,
        /// The value itself.
        value: f64,
    },
    /// Two sequences that belong together differ in length.
    #[error(
        "layer \"{layer}\": {what} has {found} entries, but {expected} are needed (one per point); \
         pass sequences of equal length"
    )]
    LengthMismatch {
        /// Name of the layer.
        layer: String,
        /// The sequence of the wrong length.
        what: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries found.
        found: usize,
    },
    /// A layer has too few points to show anything.
    #[error(
        "layer \"{layer}\": {what} has {found} points, but at least {needed} are needed; leave the \
         layer out if there is nothing to show"
    )]
    TooFewPoints {
        /// Name of the layer.
        layer: String,
        /// The sequence in question.
        what: &'static str,
        /// Points needed.
        needed: usize,
        /// Points found.
        found: usize,
    },
    /// The two ends of something are equal or in the wrong order.
    #[error("{what}: low end {low} is not below high end {high}; pass the smaller value first")]
    Inverted {
        /// What the ends belong to.
        what: String,
        /// The end given as low.
        low: f64,
        /// The end given as high.
        high: f64,
    },
    /// An axis range has ends that cannot be drawn on the axis' scale.
    #[error("axis \"{axis}\": range end {value} is not allowed; {allowed}")]
    BadRangeEnd {
        /// Label of the axis.
        axis: String,
        /// The refused end.
        value: f64,
        /// What would be accepted.
        allowed: &'static str,
    },
    /// An error bar of negative or non-finite length.
    #[error(
        "layer \"{layer}\": error bar length [{index}] = {value} is not allowed; pass finite distances \
         of at least 0 below and above the point"
    )]
    BadErrorBar {
        /// Name of the layer.
        layer: String,
        /// Index of the point.
        index: usize,
        /// The refused length.
        value: f64,
    },
    /// A line width outside of what is legible.
    #[error("layer \"{layer}\": line width {value} is not allowed; choose a width between {least} and 12 px")]
    BadWidth {
        /// Name of the layer.
        layer: String,
        /// The refused width.
        value: f64,
        /// The smallest allowed.
        least: f64,
    },
    /// Equal aspect was asked for with a logarithmic axis.
    #[error(
        "equal aspect needs two linear axes, but axis \"{axis}\" is logarithmic; use linear axes or \
         drop the equal aspect"
    )]
    EqualAspectOnLog {
        /// Label of the logarithmic axis.
        axis: String,
    },
    /// A page size that is too small to read or too large to render.
    #[error("size {width} x {height} px is not allowed; choose {min} to 2000 px for both sides")]
    BadSize {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
        /// Smallest side allowed.
        min: u32,
    },
    /// A figure without any layer.
    #[error("figure \"{title}\" has 0 layers, but at least 1 is needed; push a layer before rendering")]
    EmptyFigure {
        /// Title of the figure.
        title: String,
    },
    /// A grid without figures or columns.
    #[error(
        "a grid of {figures} figures in {columns} columns cannot be laid out; pass at least 1 figure \
         and between 1 and 12 columns"
    )]
    BadGrid {
        /// Number of figures.
        figures: usize,
        /// Number of columns.
        columns: usize,
    },
    /// A table row with the wrong number of cells.
    #[error(
        "table \"{table}\": a row has {found} cells, but the table has {expected} columns; pass one cell per column"
    )]
    BadRow {
        /// Caption of the table.
        table: String,
        /// Number of columns.
        expected: usize,
        /// Number of cells.
        found: usize,
    },
    /// The drawing backend failed.
    #[error("drawing failed: {0}; please report this together with the figure's data")]
    Backend(String),
}
