//! Where readings of `process` speak of interface, zero or surface and the verdict does not, or the other way round: said, with the reason.

use soilctl_diagnosis::{Data, Diagnosis, Explanation};
use soilctl_effects::{Channel, EffectId, SensorSite, Site, SurfaceSite};
use soilctl_stats::{Line, median, sd_of_median_abs};

/// What is not told apart from chance, in standard deviations.
const SIGNIFICANT: f64 = 3.0;
/// Differences that matter to nobody: interface friction (deg), zero of the sensor over a campaign (N), height of the surface (m).
const MATTERS: [f64; 3] = [1.0, 0.1, 1e-3];
/// What all strokes share of an inclination, in deg: the sensor's axes, the posture of the plate.
const COMMON_DEG: f64 = 0.3;
/// Standard deviation of a median over that of a mean, for normal values.
const OF_MEDIAN: f64 = 1.2533;

/// Strokes that fail the soil on the simulated arm and did not on the measured one, from which that is no chance: at least so many, and this part of them.
const SANK: (usize, f64) = (3, 0.2);

/// All of them, in words; `without` is the campaign on the simulated arm without effects.
pub(super) fn disagreements(
    data: &Data,
    diagnosis: &Diagnosis,
    known: &[EffectId],
    without: Option<&Data>,
) -> Vec<String> {
    let names = |acts: &dyn Fn(Site) -> bool| {
        let set = diagnosis.equivalence_set.iter().filter_map(|explanation| match explanation {
            Explanation::Effect(id) => Some(*id),
            Explanation::Unknown(_) => None,
        });
        let found = diagnosis.effects.iter().map(|found| found.id);
        set.chain(found).chain(known.iter().copied()).any(|id| acts(id.effect().site))
    };
    let sank = without.and_then(|without| sank(data, without, &names));
    [interface(data, &names), zero(data, &names), surface(data, &names), sank].into_iter().flatten().collect()
}

/// Whether an effect at a site is named, in the equivalence set, or known.
type Names<'a> = &'a dyn Fn(&dyn Fn(Site) -> bool) -> bool;

/// Effects that change the angle of the force which the controller holds.
fn turns_the_force(site: Site) -> bool {
    matches!(site, Site::Interface | Site::Sensor(SensorSite::Crosstalk))
}

fn interface(data: &Data, names: Names<'_>) -> Option<String> {
    let cells = data.channels.get(&Channel::SlipAngle)?;
    let lifts: Vec<f64> = cells
        .iter()
        .enumerate()
        .filter_map(|(i, cell)| Some((*cell)? - data.rows[i].delta_set_deg?))
        .collect();
    let (lift_deg, sd_deg) = middle(&lifts)?;
    let sd_deg = sd_deg.hypot(COMMON_DEG);
    let named = names(&turns_the_force);
    let lifted = lift_deg.abs() > MATTERS[0] && lift_deg.abs() > SIGNIFICANT * sd_deg;
    let set_deg = median(&mut data.rows.iter().filter_map(|row| row.delta_set_deg).collect::<Vec<_>>());
    (lifted && !named).then(|| {
        format!(
            "interface friction: while failed soil slips the force lies {lift_deg:+.1} +- {sd_deg:.1} deg beyond the set-point, near {:.1} deg, \
             which `process` takes for the interface friction, and no effect is named for it; at failure the controller holds the set-point, \
             so forces at failure do not show it, and heaps, or readings of the sensor along the plate that are off, turn it as well",
            set_deg + lift_deg
        )
    })
}

fn sank(data: &Data, without: &Data, names: Names<'_>) -> Option<String> {
    let all = without.rows.len();
    let missing = without.rows.iter().filter(|row| data.place_of(row).is_none()).count();
    let many = missing >= SANK.0 && missing as f64 > SANK.1 * all as f64;
    (many && !names(&turns_the_force)).then(|| {
        format!(
            "soil failure: {missing} of the {all} strokes that fail the soil on the simulated arm are not in the table, and no effect is named for that; a \
             plate sinks instead where the interface friction is below the set-point, or where readings of the sensor along the plate are too small \
             (cross-talk). A set-point that is some degrees lower tells: where the soil then fails, slipping soil shows the interface friction"
        )
    })
}

fn zero(data: &Data, names: Names<'_>) -> Option<String> {
    let points: Vec<(f64, f64, f64)> = data
        .rows
        .iter()
        .zip(&data.strokes)
        .filter_map(|(row, stroke)| Some((stroke.time_fraction?, row.tare_before_n?, 1.0)))
        .collect();
    // Directions of the force, and with them shares of the tool's weight, go with the tool angle and not with time.
    let line = Line::fit(&points);
    let left: Vec<f64> = points.iter().map(|(x, y, _)| y - line.at(*x)).collect();
    let sd_n = sd_of_median_abs(left.into_iter()) / line.sxx.sqrt();
    let drifts = points.len() > 5 && line.slope.abs() > MATTERS[1] && line.slope.abs() > SIGNIFICANT * sd_n;
    let named = names(&|site| matches!(site, Site::Sensor(SensorSite::ForceZeroDrift)));
    (drifts && !named).then(|| {
        format!(
            "zero of the force sensor: free-air readings go {:+.2} +- {sd_n:.2} N from the first stroke to the last, and no drift is named; \
             where they are taken off each stroke, as `process` does, no force shows it, and only logs, which are run again on the simulated arm, say what \
             they should read",
            line.slope
        )
    })
}

fn surface(data: &Data, names: Names<'_>) -> Option<String> {
    let cells: Vec<f64> = data.rows.iter().filter_map(|row| row.touch_z_m).collect();
    let (off_m, sd_m) = middle(&cells)?;
    let off = off_m.abs() > MATTERS[2] && off_m.abs() > SIGNIFICANT * sd_m;
    let named = names(&|site| matches!(site, Site::Surface(SurfaceSite::Height)));
    (off && !named).then(|| {
        format!(
            "depth: the plate met the soil {:+.1} +- {:.1} mm above where the log states the surface, and no depth offset is named; depths of \
             `process` count from where the plate met it, so that forces do not show the difference",
            1e3 * off_m,
            1e3 * sd_m
        )
    })
}

/// Median with its standard deviation; `None` of fewer than three values.
fn middle(values: &[f64]) -> Option<(f64, f64)> {
    (values.len() >= 3).then(|| {
        let middle = median(&mut values.to_vec());
        let spread = sd_of_median_abs(values.iter().map(|value| value - middle));
        (middle, OF_MEDIAN * spread / (values.len() as f64).sqrt())
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// Ten strokes fail the soil on the simulated arm: seven of them in the table are said to be few, eight are not, and nothing is said where an effect
    /// is named for it.
    #[test]
    fn strokes_that_sink_are_said() {
        let table = |count: usize| {
            let row = |i: usize| StrokeRow {
                stroke_id: Some(format!("batch_000-{i}")),
                alpha_deg: 90.0,
                depth_m: 0.02,
                width_m: 0.1,
                force_n: 5.0,
                ..StrokeRow::default()
            };
            Data::new("t", (0..count).map(row).collect(), Campaign::default()).unwrap()
        };
        let said = |count: usize, site: Site| sank(&table(count), &table(10), &|acts| acts(site));
        let other = Site::Sensor(SensorSite::ForceZeroDrift);
        assert!(said(7, other).unwrap().starts_with("soil failure: 3 of the 10 strokes"));
        assert_eq!(said(8, other), None);
        assert_eq!(said(1, Site::Interface), None);
    }
}
