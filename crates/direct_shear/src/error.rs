use soilctl_soil::SoilError;
use thiserror::Error;

/// Everything that can be wrong with a direct-shear table, a raw record, a fit or a question put to a fit.
///
/// Messages name the file, line and column where there is one, the value, its unit, what is allowed and
/// what to do about it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DirectShearError {
    /// A file could not be read.
    #[error("cannot read {file}: {source}; check the path and the permissions")]
    Io {
        /// The file as it was asked for.
        file: String,
        /// What the operating system said.
        source: std::io::Error,
    },
    /// A file is not UTF-8 text.
    #[error("{file}, line {line}: not UTF-8 text; save the table as CSV in UTF-8")]
    NotUtf8 {
        /// The file.
        file: String,
        /// Line of the first bad byte, counted from 1.
        line: u64,
    },
    /// A line does not have as many cells as the header.
    #[error(
        "{file}, line {line}: {found} cells, but the header has {expected}; \
         separate cells by commas and write decimals with a point"
    )]
    RaggedLine {
        /// The file.
        file: String,
        /// The line, counted from 1.
        line: u64,
        /// Cells in the header.
        expected: u64,
        /// Cells in the line.
        found: u64,
    },
    /// The columns of a table are not the expected ones.
    #[error("{file}, line {line}: {problem}; the columns present are {present}")]
    Columns {
        /// The file.
        file: String,
        /// Line of the header, counted from 1.
        line: u64,
        /// What is wrong and what to do.
        problem: String,
        /// The columns found.
        present: String,
    },
    /// A cell holds something that is not allowed there.
    #[error("{file}, line {line}, column `{column}`: \"{value}\" is not allowed; it must be {allowed}")]
    Cell {
        /// The file.
        file: String,
        /// The line, counted from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The text of the cell.
        value: String,
        /// What is allowed, with its unit.
        allowed: String,
    },
    /// A table has a header but no rows.
    #[error("{file}: no rows; at least one line is needed below the header")]
    Empty {
        /// The file.
        file: String,
    },
    /// A quantity is outside its range.
    #[error("{quantity} is {value} {unit}; it must be {allowed}")]
    OutOfRange {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range in words.
        allowed: &'static str,
    },
    /// Too few different normal stresses for a curve.
    #[error(
        "{curve} needs at least {needed} different normal stresses, but {found} of the points can be used \
         ({selection}); test at more loads"
    )]
    TooFewStresses {
        /// The curve.
        curve: &'static str,
        /// How many are needed.
        needed: usize,
        /// How many were found.
        found: usize,
        /// Which points were looked at.
        selection: String,
    },
    /// As many weights as points are needed.
    #[error("{weights} weights for {points} points; give one weight for each point")]
    WeightCount {
        /// Number of weights.
        weights: usize,
        /// Number of points.
        points: usize,
    },
    /// The points are so extreme that the fitted numbers overflow.
    #[error("{curve}: the fitted numbers overflow; check the units of the normal stresses and angles")]
    Overflow {
        /// The curve.
        curve: &'static str,
    },
    /// A fitted curve gives an impossible friction angle at a stress.
    #[error(
        "{curve} gives a friction angle of {friction_deg} deg at {normal_stress_pa} Pa; it must be above 0 and \
         below 90 deg: that stress is too far from the tested ones for this curve"
    )]
    ImpossibleFriction {
        /// The curve.
        curve: &'static str,
        /// The stress asked for.
        normal_stress_pa: f64,
        /// The angle in degrees.
        friction_deg: f64,
    },
    /// The iteration between friction angle and stress did not settle.
    #[error(
        "friction angle and normal stress did not become consistent after {iterations} iterations (last change \
         {last_change_deg} deg); give the friction angle instead, or use a curve that is less steep"
    )]
    NotConverged {
        /// Iterations made.
        iterations: usize,
        /// Change of the angle in the last one, in degrees.
        last_change_deg: f64,
    },
    /// A shear-box run cannot be evaluated.
    #[error("run `{run_id}`: {problem}")]
    Run {
        /// The run.
        run_id: String,
        /// What is wrong and what to do.
        problem: String,
    },
    /// A friction-loop record cannot be evaluated.
    #[error("{file}: {problem}")]
    Loop {
        /// The file.
        file: String,
        /// What is wrong and what to do.
        problem: String,
    },
    /// A soil, plate or interface is impossible.
    #[error(transparent)]
    Soil(#[from] SoilError),
}

/// `value` if it is finite and satisfies `ok`, otherwise the error that says what is allowed.
pub(crate) fn check(
    quantity: &'static str,
    value: f64,
    unit: &'static str,
    allowed: &'static str,
    ok: impl Fn(f64) -> bool,
) -> Result<f64, DirectShearError> {
    if value.is_finite() && ok(value) {
        Ok(value)
    } else {
        Err(DirectShearError::OutOfRange { quantity, value, unit, allowed })
    }
}
