//! One axis: its label, scale and range.

use serde::Serialize;

use crate::error::{FigureError, MAX_MAGNITUDE, MIN_POSITIVE};

/// How values are spread along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Scale {
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios (base 10).
    Log,
}

/// One axis of a figure.
///
/// The label should carry the unit, because it also introduces the value in the hover text:
///
/// ```
/// use soilctl_figure::Axis;
///
/// # fn main() -> Result<(), soilctl_figure::FigureError> {
/// let axis = Axis::linear("Shear displacement (mm)").range(0.0, 12.0)?;
/// assert!(Axis::log("Time (s)").range(0.0, 10.0).is_err());
/// # let _ = axis; Ok(()) }
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Axis {
    pub(crate) label: String,
    pub(crate) scale: Scale,
    pub(crate) range: Option<(f64, f64)>,
}

impl Axis {
    /// A linear axis; `label` names the quantity and its unit.
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, range: None }
    }

    /// A logarithmic (base 10) axis; `label` names the quantity and its unit.
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Log, range: None }
    }

    /// Fixes the range instead of deriving it from the data with 5 % padding.
    ///
    /// # Errors
    ///
    /// [`FigureError::BadRangeEnd`] for ends that are not finite, or not positive on a logarithmic
    /// axis; [`FigureError::Inverted`] unless `low` is below `high` by more than rounding noise.
    pub fn range(mut self, low: f64, high: f64) -> Result<Self, FigureError> {
        for value in [low, high] {
            let allowed = match self.scale {
                Scale::Linear if !(value.is_finite() && value.abs() <= MAX_MAGNITUDE) => {
                    "pass finite values between -1e100 and 1e100"
                }
                Scale::Log if !(MIN_POSITIVE..=MAX_MAGNITUDE).contains(&value) => {
                    "pass values between 1e-100 and 1e100 on a logarithmic axis"
                }
                _ => continue,
            };
            return Err(FigureError::BadRangeEnd { axis: self.label, value, allowed });
        }
        if high - low <= narrowest(low, high) {
            return Err(FigureError::Inverted { what: format!("axis \"{}\"", self.label), low, high });
        }
        self.range = Some((low, high));
        Ok(self)
    }

    /// The label, with its unit.
    pub fn label(&self) -> &str {
        &self.label
    }

    /// The scale.
    pub fn scale(&self) -> Scale {
        self.scale
    }
}

/// Width below which a range cannot be divided into distinct ticks in double precision.
pub(crate) fn narrowest(low: f64, high: f64) -> f64 {
    (low.abs().max(high.abs()) * 1e-11).max(1e-200)
}
