use soilctl_strokes::StrokeRow;

use super::StrokeRecord;

/// Set-points of the strokes that count, in deg from the interface friction: far below it the soil fails with another friction
/// on the plate, above it the plate slips along the soil, which does not fail.
const SET_DEG: std::ops::RangeInclusive<f64> = -3.5..=1.5;
/// A plate that sank or rose by more of its depth before the soil failed was not pulled through it as the models have it.
const MOST_DRIFT: f64 = 0.1;
/// A force that is known exactly has a deviation all the same, relative.
const EXACT_SD_REL: f64 = 1e-3;

impl StrokeRecord {
    /// Whether the soil failed as force models have it, with an interface friction in an interval in deg.
    #[must_use]
    pub fn failed_as_modelled(&self, delta_deg: [f64; 2]) -> bool {
        let middle = f64::midpoint(delta_deg[0], delta_deg[1]);
        self.row.delta_set_deg.is_some_and(|set| SET_DEG.contains(&(set - middle)))
            && self.row.z_drift_m.is_none_or(|drift| drift.abs() < MOST_DRIFT * self.row.depth_m)
    }

    /// The stroke as a measurement of the soil: less than the interface friction, up to `delta_deg[1]`, may be mobilised on the plate when
    /// the soil fails, never more.
    #[must_use]
    pub fn at_failure(&self, delta_deg: [f64; 2]) -> StrokeRow {
        let friction_angle_deg = self.row.friction_angle_deg.map(|angle| angle.clamp(0.0, delta_deg[1]));
        StrokeRow { friction_angle_deg, ..self.row.clone() }
    }

    /// The same with the force in N and the depth in m that were true: what is left of the uncertainty is the soil's own.
    #[must_use]
    pub fn in_truth(&self, force_n: f64, depth_m: f64, delta_deg: [f64; 2]) -> StrokeRow {
        let force_sd_n = Some(EXACT_SD_REL * force_n);
        StrokeRow { force_n, force_sd_n, depth_m, depth_sd_m: Some(0.0), ..self.at_failure(delta_deg) }
    }
}

#[cfg(test)]
mod tests {
    use crate::table::FailureRow;

    use super::*;

    fn stroke(friction_angle_deg: f64, z_drift_m: f64) -> StrokeRecord {
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
        StrokeRecord { row, failure: FailureRow::default() }
    }

    #[test]
    fn no_more_than_the_interface_friction_is_mobilised() {
        let at = |angle| stroke(angle, 0.0).at_failure([22.0, 24.0]).friction_angle_deg;
        assert_eq!([at(21.0), at(26.0), at(-1.0)], [Some(21.0), Some(24.0), Some(0.0)]);
    }

    #[test]
    fn plates_that_sank_do_not_count() {
        let counts = |z_drift_m| stroke(22.0, z_drift_m).failed_as_modelled([22.0, 24.0]);
        assert_eq!([-0.001, -0.004, 0.004].map(counts), [true, false, false]);
    }
}
