use soilctl_soil::{Plate, Stroke};

use crate::EstimatorError;
use crate::stress_level::SlipStresses;

/// What one measurement says about the failure force: it lies in an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Observation {
    label: String,
    stroke: Stroke,
    low_n: f64,
    high_n: f64,
    slip_stresses: SlipStresses,
}

impl Observation {
    /// A measured force with an absolute uncertainty (both N, force > 0, half width >= 0): the interval is
    /// `force -/+ half_width`, cut at 0 because a failure force is positive.
    ///
    /// # Errors
    /// [`EstimatorError::Soil`] if the force is not positive or a value is not finite.
    pub fn new(
        label: impl Into<String>,
        plate: Plate,
        force_n: f64,
        half_width_n: f64,
    ) -> Result<Self, EstimatorError> {
        Self::from_bounds(label, plate, force_n, force_n - half_width_n, force_n + half_width_n)
    }

    /// A measured force (> 0 N) with the bounds of its interval in N.
    ///
    /// # Errors
    /// [`EstimatorError::Soil`] if the force is not positive, [`EstimatorError::BadInterval`] if the bounds do not
    /// enclose it.
    pub fn from_bounds(
        label: impl Into<String>,
        plate: Plate,
        force_n: f64,
        low_n: f64,
        high_n: f64,
    ) -> Result<Self, EstimatorError> {
        let stroke = Stroke::new(plate, force_n)?;
        if !(low_n <= force_n && force_n <= high_n && high_n.is_finite() && low_n.is_finite()) {
            return Err(EstimatorError::BadInterval {
                quantity: "the failure force",
                low: low_n,
                high: high_n,
                unit: "N",
                allowed: format!("a finite interval around {force_n} N"),
            });
        }
        let slip_stresses = SlipStresses::of(plate);
        Ok(Self { label: label.into(), stroke, low_n: low_n.max(0.0), high_n, slip_stresses })
    }

    /// Name for messages and figures.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// The plate that measured.
    #[must_use]
    pub const fn plate(&self) -> &Plate {
        self.stroke.plate()
    }

    /// Measured force in N.
    #[must_use]
    pub const fn force_n(&self) -> f64 {
        self.stroke.force_n()
    }

    /// Lower end of the interval in N.
    #[must_use]
    pub const fn low_n(&self) -> f64 {
        self.low_n
    }

    /// Upper end of the interval in N.
    #[must_use]
    pub const fn high_n(&self) -> f64 {
        self.high_n
    }

    pub(crate) const fn slip_stresses(&self) -> &SlipStresses {
        &self.slip_stresses
    }

    /// The same measurement with its interval scaled about the force.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let low_n = (self.force_n() - factor * (self.force_n() - self.low_n)).max(0.0);
        let high_n = self.force_n() + factor * (self.high_n - self.force_n());
        Self { low_n, high_n, ..self.clone() }
    }

    /// The same measurement, allowing that the true failure force is up to `fraction` higher than read.
    ///
    /// Gradual failures, typical of tool angles of 90 deg and more, are read before friction is fully mobilised;
    /// Hong (2001, section 7.5.1) allows 10 % for them.
    #[must_use]
    pub fn read_low_by(&self, fraction: f64) -> Self {
        Self { high_n: self.high_n * (1.0 + fraction), ..self.clone() }
    }
}
