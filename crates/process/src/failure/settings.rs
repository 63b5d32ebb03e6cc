use crate::error::{ProcessError, positive};

/// What counts as a failure. [`FailureSettings::for_depth`] has values that suit sand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FailureSettings {
    /// Vertical depth of the plate's lower edge in m: the scale for displacements.
    pub depth_m: f64,
    /// A drop is a fall by this fraction of the force, above 0 and below 1, from which the force does not come back.
    pub drop_rel: f64,
    /// A plate runs away when it moves by this fraction of the depth...
    pub run_away_rel: f64,
    /// ...within this time in s...
    pub run_away_s: f64,
    /// ...so many times faster than it usually did before.
    pub run_away_speed_ratio: f64,
    /// Forces below are no stroke, in N.
    pub least_force_n: f64,
    /// A stroke that mobilised less of the limit force than this fraction is incomplete.
    pub least_mobilised: f64,
    /// Late slope over early slope, above which there is no break to speak of.
    pub most_slope_ratio: f64,
    /// A force less certain than this fraction of it (one standard deviation) is not given.
    pub most_sd_rel: f64,
    /// What no curve of a gradual failure shows: laws of mobilisation that none of the fitted ones resembles. Relative standard
    /// deviation, added in quadrature.
    pub floor_sd_rel: f64,
    /// The same of a drastic failure, which extrapolates nothing: how sharp the peak is, gain of the sensor.
    pub drastic_floor_sd_rel: f64,
    /// Noise of the force as it is known from free air; without it what the curve itself shows.
    pub noise: Option<ForceNoise>,
}

/// Noise of a force: white, or as behind a filter of first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceNoise {
    /// Standard deviation of one sample in N.
    pub sd_n: f64,
    /// Time between samples in s.
    pub interval_s: f64,
    /// Corner frequency in Hz; `None` if the noise is white.
    pub corner_hz: Option<f64>,
}

impl ForceNoise {
    /// Standard deviation in N of the mean over some time in s.
    ///
    /// Behind a filter of first order with the time constant `c` the variance of a mean over `T` is `2 c/T (1 - c/T (1 - exp(-T/c)))` of
    /// that of a sample.
    #[must_use]
    pub fn of_mean(&self, time_s: f64) -> f64 {
        let white = (self.interval_s / time_s.max(self.interval_s)).min(1.0);
        let share = self.corner_hz.map_or(white, |corner_hz| {
            let c = 1.0 / (std::f64::consts::TAU * corner_hz * time_s.max(self.interval_s));
            white.max((2.0 * c * (1.0 - c * (-(-1.0 / c).exp_m1()))).min(1.0))
        });
        self.sd_n * share.sqrt()
    }
}

impl FailureSettings {
    /// Usual settings for a plate's depth in m.
    ///
    /// # Errors
    /// [`ProcessError::OutOfRange`] unless the depth is finite and above 0.
    pub fn for_depth(depth_m: f64) -> Result<Self, ProcessError> {
        Ok(Self {
            depth_m: positive("depth", depth_m, "m")?,
            drop_rel: 0.08,
            run_away_rel: 0.06,
            run_away_s: 0.1,
            run_away_speed_ratio: 10.0,
            least_force_n: 0.1,
            least_mobilised: 0.7,
            most_slope_ratio: 0.5,
            most_sd_rel: 0.09,
            floor_sd_rel: 0.0125,
            drastic_floor_sd_rel: 0.005,
            noise: None,
        })
    }
}
