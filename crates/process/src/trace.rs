use std::ops::Range;

use crate::error::ProcessError;

/// The fewest samples a trace may have.
pub const FEWEST_SAMPLES: usize = 50;

/// One recorded stroke, one value a sample in each column.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    t_s: Vec<f64>,
    displacement_m: Vec<f64>,
    force_n: Vec<f64>,
    channels: Channels,
}

/// What may have been recorded beside force and displacement; it supports the failure point and is never needed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Channels {
    /// Inclination of the force to the plate's normal in deg.
    pub friction_angle_deg: Option<Vec<f64>>,
    /// Height of the plate's lower edge in m, up positive.
    pub z_m: Option<Vec<f64>>,
    /// Where the force acts along the plate, in m from any fixed point.
    pub centre_m: Option<Vec<f64>>,
}

impl Trace {
    /// Checks and keeps the columns: time in s, strictly increasing; displacement of the plate along the stroke in m,
    /// compensated for flexion; force on the plate in N, the magnitude of the in-plane resultant with the tare removed.
    ///
    /// # Errors
    /// [`ProcessError::TooFew`] under [`FEWEST_SAMPLES`] samples, [`ProcessError::Lengths`],
    /// [`ProcessError::NotFinite`], [`ProcessError::Time`].
    pub fn new(
        t_s: Vec<f64>,
        displacement_m: Vec<f64>,
        force_n: Vec<f64>,
        channels: Channels,
    ) -> Result<Self, ProcessError> {
        let n = t_s.len();
        if n < FEWEST_SAMPLES {
            return Err(ProcessError::TooFew {
                what: "samples in the trace",
                found: n,
                least: FEWEST_SAMPLES,
            });
        }
        let columns: [(&'static str, Option<&[f64]>); 6] = [
            ("t_s", Some(&t_s)),
            ("displacement_m", Some(&displacement_m)),
            ("force_n", Some(&force_n)),
            ("friction_angle_deg", channels.friction_angle_deg.as_deref()),
            ("z_m", channels.z_m.as_deref()),
            ("centre_m", channels.centre_m.as_deref()),
        ];
        for (column, values) in columns {
            let Some(values) = values else { continue };
            if values.len() != n {
                return Err(ProcessError::Lengths { column, found: values.len(), expected: n });
            }
            if let Some((index, &value)) = values.iter().enumerate().find(|(_, value)| !value.is_finite()) {
                return Err(ProcessError::NotFinite { column, index, value });
            }
        }
        for (index, pair) in t_s.windows(2).enumerate() {
            if let &[before, after] = pair
                && after <= before
            {
                return Err(ProcessError::Time { index: index + 1, before, after });
            }
        }
        Ok(Self { t_s, displacement_m, force_n, channels })
    }

    /// Some of the samples.
    ///
    /// # Errors
    /// [`ProcessError::TooFew`] of fewer than [`FEWEST_SAMPLES`].
    pub(crate) fn part(&self, samples: Range<usize>) -> Result<Self, ProcessError> {
        let cut = |values: &[f64]| values.get(samples.clone()).unwrap_or_default().to_vec();
        let channels = Channels {
            friction_angle_deg: self.channels.friction_angle_deg.as_deref().map(cut),
            z_m: self.channels.z_m.as_deref().map(cut),
            centre_m: self.channels.centre_m.as_deref().map(cut),
        };
        Self::new(cut(&self.t_s), cut(&self.displacement_m), cut(&self.force_n), channels)
    }

    /// Time of each sample in s.
    #[must_use]
    pub fn t_s(&self) -> &[f64] {
        &self.t_s
    }

    /// Displacement of the plate along the stroke in m.
    #[must_use]
    pub fn displacement_m(&self) -> &[f64] {
        &self.displacement_m
    }

    /// Force on the plate in N.
    #[must_use]
    pub fn force_n(&self) -> &[f64] {
        &self.force_n
    }

    /// What else was recorded.
    #[must_use]
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// Time from the first to the last sample in s.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        match (self.t_s.first(), self.t_s.last()) {
            (Some(first), Some(last)) => last - first,
            _ => 0.0,
        }
    }
}
