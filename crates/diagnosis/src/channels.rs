//! What a trace-derived column reads when no effect is there.
//!
//! Standard deviations of baselines are parts of what `campaign.json` says of the instrument: empirical, as are the means and
//! standard deviations of what depends on the soil (displacement, slope and residual after the break), which are those of
//! loose and dense sand in strokes of this size.

use soilctl_effects::{Active, Channel};
use soilctl_stats::median_absolute_deviation;

use crate::data::{Data, Prior};

/// How far baselines may be from those of a simulated arm, over what they may be without one. Empirical.
const SIMULATED: f64 = 0.5;

/// How far the stretch of the drives may be from a simulated arm's, relative: it was measured, and what is beyond is an effect, `cable_flex`. Empirical.
const STRETCH_SD: f64 = 0.05;

/// How far readings that are only ever compared with a simulated arm may be from that arm, all strokes alike: the surface as touched (m),
/// the force of an insertion (relative), the inclination of the motors' force (deg; the same again for 10 deg of tool angle), and the play that
/// a load takes up (deg). The force of an insertion goes by Reissner's N_q, which a degree of friction changes by 15 %, and an effect moves the fitted friction by two, and the motors' force has
/// their friction in it, by 4 deg from stroke to stroke. Empirical.
const TOUCH_SD_M: f64 = 3e-4;
const INSERTION_SD_REL: f64 = 0.3;
const MOTOR_ANGLE_SD_DEG: f64 = 2.0;
const LOOP_SD_DEG: f64 = 0.02;

/// Baseline and scatter of a channel.
#[derive(Clone)]
pub(crate) struct Baseline {
    /// What is subtracted before anything is fitted, by stroke.
    pub(crate) known: Vec<f64>,
    /// Regressors with the prior of their coefficients.
    pub(crate) terms: Vec<(Vec<f64>, Prior)>,
    /// Prior of ln scatter.
    pub(crate) ln_scatter: Prior,
    /// Whether the interface friction angle itself is read.
    pub(crate) reads_delta: bool,
}

impl Baseline {
    /// The baseline of a channel in a campaign.
    ///
    /// Columns that read zero on a perfect instrument may be off by a fraction of what the instrument scatters; columns
    /// that depend on the soil have free baselines.
    pub(crate) fn of(channel: Channel, data: &Data) -> Self {
        let n = data.len();
        let one = || vec![1.0; n];
        let zero = |sd: f64| Prior { mean: 0.0, sd };
        let instrument = &data.campaign.instrument;
        let depth: Vec<f64> = data.rows.iter().map(|row| row.depth_m).collect();
        let force: Vec<f64> = data.rows.iter().map(|row| row.force_n).collect();
        let tens_of_deg: Vec<f64> =
            data.rows.iter().map(|row| (row.alpha_deg - data.reference.alpha_deg) / 10.0).collect();
        let cells = data.beyond_expected(channel);
        // No reading is more exact than its last written digit, nor than a ten-thousandth of itself.
        let largest = cells.iter().fold(0.0_f64, |most, cell| most.max(cell.abs()));
        let spread = spread(&cells).max(1e-4 * largest).max(1e-9);
        let given = |sd: f64| Prior { mean: if sd > 0.0 { sd } else { spread }.ln(), sd: 0.5 };
        // Where readings scatter by far more than the instrument does, the arm moves for reasons of its own, and nobody knows
        // about which mean.
        let beyond = |sd: f64| (spread - 1.3 * sd).max(0.0);
        let own = Prior { mean: (0.7 * spread).ln(), sd: 0.7 };
        // Relative to the stretch of the drives as it was measured.
        let stretch_sd = if data.expected.contains_key(&channel) { STRETCH_SD / SIMULATED } else { 1.0 };
        let (mut terms, ln_scatter): (Vec<(Vec<f64>, Prior)>, Prior) = match channel {
            Channel::TareBefore | Channel::TareAfter => {
                (vec![(one(), zero((0.5 * instrument.tare_sd).max(0.02)))], given(instrument.tare_sd))
            }
            Channel::CmdMinusForce => {
                let mean = force.iter().sum::<f64>() / n as f64;
                let relative = force.iter().map(|f| f / mean - 1.0).collect();
                let sd = (0.25 * instrument.cmd_sd).max(0.2).hypot(beyond(instrument.cmd_sd));
                (vec![(one(), zero(sd)), (relative, zero(sd))], given(instrument.cmd_sd))
            }
            Channel::FrictionAngle | Channel::SlipAngle => {
                (vec![(one(), zero(0.4))], given(instrument.friction_angle_sd))
            }
            Channel::ZDrift => {
                let sd = (0.25 * instrument.z_sd).max(1e-5).hypot(beyond(instrument.z_sd));
                (vec![(one(), zero(sd))], given(instrument.z_sd))
            }
            Channel::HeapHeight => {
                (vec![(one(), zero((0.25 * instrument.heap_sd).max(2e-4)))], given(instrument.heap_sd))
            }
            Channel::MotorExtGap => {
                let stretch = force.iter().map(|f| f / instrument.joint_stiffness_n_per_m).collect();
                let sd = (0.25 * instrument.gap_sd).max(6e-5);
                (
                    vec![(one(), zero(sd)), (stretch, Prior { mean: 1.0, sd: stretch_sd })],
                    given(instrument.gap_sd),
                )
            }
            Channel::XStep => {
                let sd = (0.05 * instrument.encoder_step_m).max(1e-5);
                let nominal = Prior { mean: instrument.encoder_step_m, sd };
                (
                    vec![(one(), nominal)],
                    Prior { mean: (0.05 * instrument.encoder_step_m).max(1e-6).ln(), sd: 1.0 },
                )
            }
            Channel::Displacement => (
                vec![
                    (one(), zero(0.001)),
                    (depth, Prior { mean: 0.12, sd: 0.12 }),
                    (
                        tens_of_deg.iter().zip(&data.rows).map(|(x, row)| x * row.depth_m).collect(),
                        zero(0.01),
                    ),
                ],
                own,
            ),
            Channel::GapSlope => {
                let stretch = 1.0 / instrument.joint_stiffness_n_per_m;
                (vec![(one(), Prior { mean: stretch, sd: stretch_sd * stretch })], own)
            }
            Channel::PostSlope => {
                let mean = if data.campaign.dense_preparation { -0.6 } else { -0.1 };
                let terms = [(one(), Prior { mean, sd: 0.4 }), (tens_of_deg, zero(0.03))];
                (terms.into_iter().chain(after_failure(data, instrument.post_slope_sd)).collect(), own)
            }
            Channel::AirAcross | Channel::AirAlong => {
                (vec![(one(), zero((0.5 * instrument.tare_sd).max(0.02)))], own)
            }
            // What is soft or rough at the top of a real soil, a simulated one does not have.
            Channel::TouchHeight => (vec![(one(), zero(TOUCH_SD_M))], own),
            Channel::InsertionForce => {
                let expected = data.expected.get(&channel).cloned().unwrap_or_else(one);
                (vec![(expected, zero(INSERTION_SD_REL))], own)
            }
            Channel::MotorAngle => {
                (vec![(one(), zero(MOTOR_ANGLE_SD_DEG)), (tens_of_deg, zero(MOTOR_ANGLE_SD_DEG))], own)
            }
            Channel::ShoulderLoop | Channel::ElbowLoop => (vec![(one(), zero(LOOP_SD_DEG))], own),
            Channel::ResidualRatio => {
                let mean = if data.campaign.dense_preparation { 0.75 } else { 0.95 };
                let terms = [(one(), Prior { mean, sd: 0.12 }), (tens_of_deg, zero(0.01))];
                // Half a depth further.
                (terms.into_iter().chain(after_failure(data, 0.5 * instrument.post_slope_sd)).collect(), own)
            }
        };
        if channel == Channel::Displacement && data.derived.contains(&channel) {
            // A trace has the encoders' reading; whether it holds the stretch of the drives depends on where they sit.
            let stretch = force.iter().map(|f| f / instrument.joint_stiffness_n_per_m).collect();
            terms.push((stretch, Prior { mean: 0.5, sd: 0.5 * stretch_sd }));
        }
        let reads_delta = reads_delta(channel);
        let mut known: Vec<f64> =
            if reads_delta { (0..n).map(|i| data.delta_set_deg(i)).collect() } else { vec![0.0; n] };
        let responses = |terms: &mut Vec<(Vec<f64>, Prior)>| {
            for &Active { effect, shape, .. } in data.known_responses() {
                for response in effect.responses.iter().filter(|response| response.channel == channel) {
                    let at = |stroke| effect.response(channel, shape, stroke, &data.reference);
                    let prior = Prior { mean: response.mean, sd: response.sd };
                    terms.push((data.strokes.iter().map(at).collect(), prior));
                }
            }
        };
        let simulated = data.expected.get(&channel);
        let shown = simulated.is_some() && data.expected_shows_known;
        if shown {
            responses(&mut terms);
        }
        if let Some(expected) = simulated {
            // What is left of a baseline is how far the simulated arm is from the real one.
            // The interface friction that the soil is fitted with counts from the set-point.
            let offset_deg = if reads_delta { data.expected_delta_offset_deg } else { 0.0 };
            known = expected.iter().map(|value| value - offset_deg).collect();
            for (_, prior) in terms.iter_mut().filter(|_| !channel.is_compared_only()) {
                *prior = Prior { mean: 0.0, sd: SIMULATED * prior.sd };
            }
        }
        if !shown {
            responses(&mut terms);
            for &Active { effect, amplitude, shape } in data.known_linked(channel) {
                for (i, value) in known.iter_mut().enumerate() {
                    *value += effect.shift(channel, amplitude, shape, &data.reading(i));
                }
            }
        }
        Self { known, terms, ln_scatter, reads_delta }
    }
}

/// What a slope after the break may follow in an arm whose plate rises or dives: the tool angle, each (to the nearest 5 deg) with a level of
/// its own, and the depth, in tenths of its mean. Nothing if the instrument has no such deviation.
fn after_failure(data: &Data, sd: f64) -> Vec<(Vec<f64>, Prior)> {
    if sd <= 0.0 {
        return Vec::new();
    }
    let near: Vec<f64> = data.rows.iter().map(|row| (row.alpha_deg / 5.0).round()).collect();
    let mut angles = near.clone();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let level = |angle: f64| near.iter().map(|a| f64::from(u8::from(*a == angle))).collect();
    let mean_m = data.rows.iter().map(|row| row.depth_m).sum::<f64>() / data.len().max(1) as f64;
    let depth = data.rows.iter().map(|row| 10.0 * (row.depth_m / mean_m - 1.0)).collect();
    angles.into_iter().map(level).chain([depth]).map(|term| (term, Prior { mean: 0.0, sd })).collect()
}

/// Whether a column reads the interface friction angle itself.
pub(crate) const fn reads_delta(channel: Channel) -> bool {
    matches!(channel, Channel::FrictionAngle | Channel::SlipAngle)
}

/// Standard deviation that an outlier does not move much: 1.4826 times the median absolute deviation, as for normal values
/// (Rousseeuw & Croux 1993).
pub(crate) fn spread(values: &[f64]) -> f64 {
    if values.len() < 2 { 0.0 } else { 1.4826 * median_absolute_deviation(values) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    /// Without a simulated arm the stretch of the drives may be off by all of it, beside one by a twentieth: the rest is `cable_flex`.
    #[test]
    fn the_stretch_is_known_beside_a_simulated_arm() {
        let row = StrokeRow {
            stroke_id: Some("s".to_owned()),
            alpha_deg: 90.0,
            depth_m: 0.025,
            width_m: 0.1,
            force_n: 5.0,
            motor_ext_gap_m: Some(1e-3),
            ..StrokeRow::default()
        };
        let mut data = Data::new("t", vec![row], Campaign::default()).unwrap();
        let stretch_sd = |data: &Data| Baseline::of(Channel::MotorExtGap, data).terms[1].1.sd;
        assert_eq!(stretch_sd(&data), 1.0);
        data.expect(&data.clone(), false, 0.0);
        assert!((stretch_sd(&data) - 0.05).abs() < 1e-15);
    }
}
