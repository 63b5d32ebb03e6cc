//! What the logs of a simulated campaign know and no experimenter does: when and at which force the soil failed.

use std::collections::BTreeMap;
use std::path::Path;

use soilctl_kinematics::JointAngles;
use soilctl_plant::{BuriedBlock, block_gap_m};
use soilctl_session::messages::{JointState, SoilTruth, decode};
use soilctl_session::read::{Item, scan};
use soilctl_session::{CONFIGURATION_RECORD, STROKE_RECORD, topics};

use crate::{CampaignError, Plan};

/// Soil counts as failed once this share of the most that it bears in a stroke is mobilised.
const FAILED: f64 = 0.99;
/// A stroke that mobilises less of the soil's strength has not failed it: its plate slips along it instead. An insertion that
/// has failed dense soil already leaves less than all of it.
const LEAST_SHARE: f64 = 0.9;

/// Over so long, in s, the limit force is a mean: a failure is found within it.
const JUST_BEFORE_S: f64 = 0.5;

/// What is true of a batch, from its log.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BatchTruth {
    /// Density of the preparation as weighed in kg/m3, within 1 %; the one entry that an experimenter has too.
    pub weighed_density_kg_m3: Option<f64>,
    /// Its strokes, in order.
    pub strokes: Vec<StrokeTruth>,
}

/// What is true of a stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct StrokeTruth {
    /// Number in the plan, from 0; `None` of a stroke that belongs to none.
    pub plan_index: Option<usize>,
    /// When it began, in s on the log's clock.
    pub start_s: f64,
    /// When it ended.
    pub end_s: f64,
    /// The failure of the soil; `None` if it did not fail.
    pub failure: Option<TrueFailure>,
    /// Times in s and the most that the soil bore then, where the plate was, in N.
    limits: Vec<(f64, f64)>,
    /// Times in s and the way ahead then to a buried block in m, while there is one.
    gaps: Vec<(f64, f64)>,
}

impl StrokeTruth {
    /// The most that the soil bore in N where the plate was at a time in s on the log's clock, a mean of the half second before.
    #[must_use]
    pub fn limit_force_n(&self, time_s: f64) -> Option<f64> {
        let to = self.limits.partition_point(|limit| limit.0 <= time_s);
        let from = self.limits.partition_point(|limit| limit.0 <= time_s - JUST_BEFORE_S);
        let near = self.limits.get(from..to).filter(|near| !near.is_empty())?;
        Some(near.iter().map(|limit| limit.1).sum::<f64>() / near.len() as f64)
    }
}

impl StrokeTruth {
    /// Way ahead of the plate in m to a buried block that is not below it, at a time in s on the log's clock; below 0 by how far it was entered.
    /// `None` if there is none.
    #[must_use]
    pub fn block_gap_m(&self, time_s: f64) -> Option<f64> {
        let to = self.gaps.partition_point(|gap| gap.0 <= time_s);
        let (at_s, gap_m) = self.gaps.get(to.checked_sub(1)?)?;
        // The truth of every step is logged.
        (time_s - at_s < JUST_BEFORE_S).then_some(*gap_m)
    }
}

/// The moment at which the soil failed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrueFailure {
    /// Time on the log's clock in s.
    pub time_s: f64,
    /// Force of the soil on the plate in its vertical plane in N.
    pub force_n: f64,
    /// Depth of the plate's lower edge below the surface in m.
    pub depth_m: f64,
    /// Inclination of the force to the plate's normal in deg.
    pub friction_angle_deg: f64,
}

/// One step of a stroke.
#[derive(Debug, Clone, Copy)]
struct Sample {
    time_s: f64,
    soil: SoilTruth,
}

/// Reads what is true from a log of [`simulate`](crate::simulate).
///
/// # Errors
/// [`CampaignError::Session`] if the log cannot be read.
pub fn read_truth(log: &Path) -> Result<BatchTruth, CampaignError> {
    let mut batch = BatchTruth::default();
    let mut samples: Vec<Sample> = Vec::new();
    let mut blocks = Blocks::default();
    scan::<CampaignError>(log, &mut |item| {
        match item {
            Item::Metadata { name: CONFIGURATION_RECORD, content } => {
                batch.weighed_density_kg_m3 = number(content, "density_kg_m3");
                blocks = Blocks::of(content).unwrap_or_default();
            }
            // The record of a stroke comes after its messages.
            Item::Metadata { name: STROKE_RECORD, content } => {
                batch.strokes.extend(stroke(content, &samples, &blocks.gaps));
                samples.clear();
                blocks.gaps.clear();
            }
            Item::Message(message) if message.channel.topic == topics::TRUE_SOIL => {
                if let Ok(soil) = decode::<SoilTruth>(message.data) {
                    #[allow(clippy::cast_precision_loss, reason = "exact below 2^53 ns")]
                    let time_s = message.log_time_ns as f64 * 1e-9;
                    samples.push(Sample { time_s, soil });
                }
            }
            Item::Message(message) if message.channel.topic == topics::TRUE_JOINTS => {
                if let Ok(joints) = decode::<JointState>(message.data) {
                    #[allow(clippy::cast_precision_loss, reason = "exact below 2^53 ns")]
                    let time_s = message.log_time_ns as f64 * 1e-9;
                    blocks.note(time_s, &joints);
                }
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(batch)
}

/// The blocks in the soil of a log, and how far ahead they are.
#[derive(Default)]
struct Blocks {
    plan: Option<(Plan, Vec<BuriedBlock>)>,
    gaps: Vec<(f64, f64)>,
}

impl Blocks {
    /// By the plan that stands in the log; `None` if it has none in this batch.
    fn of(configuration: &BTreeMap<String, String>) -> Option<Self> {
        let plan = Plan::from_record(configuration.get("plan")?)?;
        let blocks = plan.blocks_of(configuration.get("batch")?.parse().ok()?);
        (!blocks.is_empty()).then(|| Self { plan: Some((plan, blocks)), gaps: Vec::new() })
    }

    fn note(&mut self, time_s: f64, joints: &JointState) {
        let Some((plan, blocks)) = &self.plan else { return };
        let Some(angles) = joints.position.first_chunk() else { return };
        let arm = plan.params().arm();
        let Ok(frames) = arm.frames(&JointAngles(*angles)) else { return };
        let tip = frames.plate_tip;
        let ahead = [tip.rotation[0][0], tip.rotation[1][0]];
        let length = libm::hypot(ahead[0], ahead[1]);
        let depth_m = plan.controller().site.surface_z_m - tip.origin_m[2];
        if length < 0.1 || depth_m <= 0.0 {
            return;
        }
        let place = [tip.origin_m[0], tip.origin_m[1]];
        let width_m = arm.config().plate.width_m;
        let gap = block_gap_m(blocks, place, ahead.map(|part| part / length), width_m, depth_m);
        self.gaps.extend(gap.map(|gap_m| (time_s, gap_m)));
    }
}

fn number(record: &BTreeMap<String, String>, key: &str) -> Option<f64> {
    record.get(key)?.parse().ok().filter(|value: &f64| value.is_finite())
}

fn stroke(record: &BTreeMap<String, String>, samples: &[Sample], gaps: &[(f64, f64)]) -> Option<StrokeTruth> {
    let (start_s, end_s) = (number(record, "start_s")?, number(record, "end_s")?);
    let from = samples.partition_point(|sample| sample.time_s < start_s);
    let to = samples.partition_point(|sample| sample.time_s <= end_s);
    let alpha_deg = number(record, "alpha_deg")?;
    let samples = samples.get(from..to).unwrap_or_default();
    Some(StrokeTruth {
        plan_index: record.get("plan_index").and_then(|text| text.parse().ok()),
        start_s,
        end_s,
        failure: failure(samples, alpha_deg.to_radians()),
        limits: samples.iter().map(|s| (s.time_s, s.soil.limit_force_now_n)).collect(),
        gaps: gaps.iter().filter(|gap| (start_s..=end_s).contains(&gap.0)).copied().collect(),
    })
}

/// The first moment at which the soil bears what it bears at most, in relation to its limit force; of the longest time in which
/// it nearly does, since an insertion may load it for a moment.
fn failure(samples: &[Sample], alpha_rad: f64) -> Option<TrueFailure> {
    let most = samples.iter().map(|sample| sample.soil.mobilisation).fold(0.0, f64::max);
    if most < LEAST_SHARE {
        return None;
    }
    let loaded = samples
        .chunk_by(|a, b| {
            (a.soil.mobilisation < LEAST_SHARE * most) == (b.soil.mobilisation < LEAST_SHARE * most)
        })
        .filter(|part| part.iter().any(|sample| sample.soil.mobilisation >= FAILED * most))
        .max_by_key(|part| part.len())?;
    let found = loaded.iter().find(|sample| sample.soil.mobilisation >= FAILED * most)?;
    let [radial, _, up] = found.soil.force_rtz_n;
    let (sin, cos) = (libm::sin(alpha_rad), libm::cos(alpha_rad));
    let [across, along] = [radial * sin - up * cos, radial * cos + up * sin];
    Some(TrueFailure {
        time_s: found.time_s,
        force_n: libm::hypot(across, along),
        depth_m: found.soil.depth_m,
        friction_angle_deg: libm::atan2(along, across).to_degrees(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stroke whose share of the limit force is `mobilised(t)`, inclined at `delta`, on a plate that sinks.
    fn samples(alpha: f64, delta: f64, mobilised: impl Fn(f64) -> f64) -> Vec<Sample> {
        (0..1000)
            .map(|i| {
                let time_s = f64::from(i) * 0.01;
                let depth_m = 0.02 + 0.0002 * time_s;
                let (mobilisation, limit_force_n) = (mobilised(time_s), 1e4 * depth_m * depth_m);
                let force = mobilisation * limit_force_n;
                // Outwards and down across the plate, outwards and up along it.
                let [n, t] = [force * libm::cos(delta), force * libm::sin(delta)];
                let force_rtz_n = [
                    n * libm::sin(alpha) + t * libm::cos(alpha),
                    0.0,
                    -n * libm::cos(alpha) + t * libm::sin(alpha),
                ];
                let soil =
                    SoilTruth { depth_m, limit_force_n, force_rtz_n, mobilisation, ..SoilTruth::default() };
                Sample { time_s, soil }
            })
            .collect()
    }

    /// Limit force and depth grow on after failure; the moment of failure is when nothing more is mobilised.
    #[test]
    fn a_plate_that_sinks_fails_when_all_is_mobilised() {
        for (alpha, delta) in [(1.2, 0.4), (std::f64::consts::FRAC_PI_2, 0.2), (1.75, 0.45)] {
            let course = samples(alpha, delta, |t| (t / 6.0).min(1.0));
            let found = failure(&course, alpha).unwrap();
            assert!((found.time_s - 5.94).abs() < 0.02, "{found:?}");
            assert!((found.force_n / (0.99 * 1e4 * found.depth_m.powi(2)) - 1.0).abs() < 2e-3);
            assert!((found.friction_angle_deg - delta.to_degrees()).abs() < 1e-9);
        }
    }

    /// Dense soil: the peak counts, not what is left.
    #[test]
    fn a_peak_is_found_where_it_is() {
        let curve = |t: f64| if t < 4.0 { t / 4.0 } else { 1.0 - 0.05 * (t - 4.0) };
        let found = failure(&samples(1.4, 0.4, curve), 1.4).unwrap();
        assert!((found.time_s - 3.96).abs() < 0.02);
    }

    #[test]
    fn a_moment_after_the_insertion_does_not_count() {
        let curve = |t: f64| if (0.5..0.7).contains(&t) { 1.0 } else { (t / 6.0).min(1.0) };
        let found = failure(&samples(1.4, 0.4, curve), 1.4).unwrap();
        assert!((found.time_s - 5.94).abs() < 0.02);
    }

    #[test]
    fn the_limit_is_that_just_before() {
        let limits = (0..1000).map(|i| (f64::from(i) * 0.01, f64::from(i))).collect();
        let stroke = StrokeTruth {
            plan_index: None,
            start_s: 0.0,
            end_s: 10.0,
            failure: None,
            limits,
            gaps: Vec::new(),
        };
        assert!((stroke.limit_force_n(5.001).unwrap() - 475.5).abs() < 1e-9);
        assert_eq!((stroke.limit_force_n(-0.1), stroke.limit_force_n(11.0)), (None, None));
    }

    #[test]
    fn soil_that_is_not_failed_has_no_failure() {
        for most in [0.0, 0.5, 0.89] {
            assert_eq!(failure(&samples(1.4, 0.4, |t| (t / 6.0).min(most)), 1.4), None);
        }
        assert_eq!(failure(&[], 1.4), None);
    }
}
