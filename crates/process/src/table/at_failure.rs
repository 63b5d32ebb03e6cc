use soilctl_strokes::StrokeRow;

use super::StrokeRecord;

/// A force that is known exactly has a deviation all the same, relative.
const EXACT_SD_REL: f64 = 1e-3;

impl StrokeRecord {
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

    #[test]
    fn no_more_than_the_interface_friction_is_mobilised() {
        let at = |angle| {
            let row = StrokeRow { friction_angle_deg: Some(angle), ..StrokeRow::default() };
            StrokeRecord { row, failure: FailureRow::default() }.at_failure([22.0, 24.0]).friction_angle_deg
        };
        assert_eq!([at(21.0), at(26.0), at(-1.0)], [Some(21.0), Some(24.0), Some(0.0)]);
    }
}
