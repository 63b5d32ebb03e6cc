use soilctl_earth_pressure::{Case, ChenLiu, EarthPressureError, ForceModel as _};
use soilctl_soil::Angle;
use soilctl_strokes::{Campaign, StrokeRow};

use super::StrokeRecord;

/// Set-points of the strokes that count, in deg from the interface friction: far below it the soil fails with another friction
/// on the plate, above it the plate slips along the soil, which does not fail.
const SET_DEG: std::ops::RangeInclusive<f64> = -3.5..=1.5;
/// A plate that sank or rose by more of its depth before the soil failed was not pulled through it as the models have it.
const MOST_DRIFT: f64 = 0.1;
/// Relative deviation of a true force from the model's on level ground: the heap ahead, the law of the friction on the plate.
const SOIL_SD_REL: f64 = 0.03;
/// The arm turns the plate by about a degree until the soil fails, and the force goes with it. It is carried back by Chen and Liu's
/// model at this friction angle in deg; at 30 or 45 deg the correction of some per cent is a tenth of itself different.
const TURN_PHI_DEG: f64 = 40.0;

impl StrokeRecord {
    /// Whether the soil failed as force models have it, with an interface friction in an interval in deg.
    #[must_use]
    pub fn failed_as_modelled(&self, delta_deg: [f64; 2]) -> bool {
        let middle = f64::midpoint(delta_deg[0], delta_deg[1]);
        self.row.delta_set_deg.is_some_and(|set| SET_DEG.contains(&(set - middle)))
            && self.row.z_drift_m.is_none_or(|drift| drift.abs() < MOST_DRIFT * self.row.depth_m)
    }

    /// The stroke as a measurement of the soil: with the force that it would have needed at the tool angle it was asked for; with the
    /// inclination of the force as the friction on the plate, since less than the interface friction, up to `delta_deg[1]`, may be
    /// mobilised when the soil fails, never more; and with an uncertainty that holds what depth, density of a preparation and
    /// model add.
    ///
    /// # Errors
    /// [`EarthPressureError`] if no force can be said at the tool angle.
    pub fn at_failure(
        &self,
        delta_deg: [f64; 2],
        campaign: &Campaign,
    ) -> Result<StrokeRow, EarthPressureError> {
        let share = together(&[
            self.row.force_sd_n.unwrap_or(0.0) / self.row.force_n,
            // The force goes with the square of the depth.
            2.0 * campaign.depth_sd_m / self.row.depth_m,
            campaign.density_sd_rel,
            SOIL_SD_REL,
        ]);
        self.measured(self.row.force_n, self.row.depth_m, share, delta_deg)
    }

    /// The same with the force in N and the depth in m that were true: what is left of the uncertainty is the soil's own.
    ///
    /// # Errors
    /// As [`StrokeRecord::at_failure`].
    pub fn in_truth(
        &self,
        force_n: f64,
        depth_m: f64,
        delta_deg: [f64; 2],
        campaign: &Campaign,
    ) -> Result<StrokeRow, EarthPressureError> {
        self.measured(force_n, depth_m, together(&[SOIL_SD_REL, campaign.density_sd_rel]), delta_deg)
    }

    fn measured(
        &self,
        force_n: f64,
        depth_m: f64,
        sd_rel: f64,
        delta_deg: [f64; 2],
    ) -> Result<StrokeRow, EarthPressureError> {
        let row = &self.row;
        let mobilised_deg = row.friction_angle_deg.map(|angle| angle.clamp(0.0, delta_deg[1]));
        let delta_set_deg = mobilised_deg.or(row.delta_set_deg);
        let factor = |alpha_deg: f64| {
            let case = Case {
                tool_angle: Angle::from_degrees(alpha_deg),
                surface_slope: Angle::ZERO,
                friction: Angle::from_degrees(TURN_PHI_DEG),
                interface: Angle::from_degrees(delta_set_deg.unwrap_or(0.0).min(TURN_PHI_DEG)),
            };
            ChenLiu.predict(&case).map(|prediction| prediction.net.weight)
        };
        let turned_deg = self.failure.turned_deg.unwrap_or(0.0);
        let force_n = force_n * factor(row.alpha_deg)? / factor(row.alpha_deg + turned_deg)?;
        Ok(StrokeRow { force_n, depth_m, force_sd_n: Some(sd_rel * force_n), delta_set_deg, ..row.clone() })
    }
}

/// Independent relative deviations together.
fn together(shares: &[f64]) -> f64 {
    shares.iter().map(|share| share * share).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use crate::table::FailureRow;

    use super::*;

    fn stroke(turned_deg: f64, friction_angle_deg: f64, z_drift_m: f64) -> StrokeRecord {
        let row = StrokeRow {
            alpha_deg: 90.0,
            depth_m: 0.025,
            width_m: 0.127,
            force_n: 8.0,
            delta_set_deg: Some(22.0),
            friction_angle_deg: Some(friction_angle_deg),
            z_drift_m: Some(z_drift_m),
            ..StrokeRow::default()
        };
        let failure = FailureRow { turned_deg: Some(turned_deg), ..FailureRow::default() };
        StrokeRecord { row, failure }
    }

    fn at_failure(turned_deg: f64, friction_angle_deg: f64) -> StrokeRow {
        let stroke = stroke(turned_deg, friction_angle_deg, 0.0);
        stroke.at_failure([22.0, 24.0], &Campaign::default()).unwrap()
    }

    /// A steeper plate meets more soil, so one that turned back would have needed more force where it began.
    #[test]
    fn a_force_is_carried_back_over_the_turn() {
        let at = |turned_deg| at_failure(turned_deg, 22.0).force_n;
        assert_eq!(at(0.0), 8.0);
        let share = at(-1.0) / 8.0 - 1.0;
        assert!((0.01..0.06).contains(&share), "{share}");
        assert!(at(1.0) < 8.0);
    }

    #[test]
    fn no_more_than_the_interface_friction_is_mobilised() {
        let at = |angle| at_failure(0.0, angle).delta_set_deg;
        assert_eq!([at(21.0), at(26.0), at(-1.0)], [Some(21.0), Some(24.0), Some(0.0)]);
    }

    #[test]
    fn plates_that_sank_do_not_count() {
        let counts = |z_drift_m| stroke(0.0, 22.0, z_drift_m).failed_as_modelled([22.0, 24.0]);
        assert_eq!([-0.001, -0.004, 0.004].map(counts), [true, false, false]);
    }
}
