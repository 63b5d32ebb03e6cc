//! Inclination of the force while failed soil slips along the plate.

use soilctl_stats::{median, sd_of_median_abs};

use crate::trace::Trace;

/// Way after the failure, over the depth, within which the friction along the plate builds up.
const BUILDS_UP_REL: f64 = 0.1;
/// Time in s over which a value is taken, longer than an arm's vibrations.
const BLOCK_S: f64 = 0.25;
/// What no inclination is known better than, in deg: axes of the sensor, posture of the plate.
const LEAST_SD_DEG: f64 = 0.2;

/// The force's inclination against the plate's normal while the soil slips: the friction that it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slip {
    /// Inclination in deg.
    pub angle_deg: f64,
    /// Standard deviation in deg.
    pub sd_deg: f64,
}

impl Slip {
    /// What `trace` shows after the failure at `time_s`, of a plate `depth_m` deep; `None` without the channel, or if the pull
    /// ends too early.
    ///
    /// Failed soil rises along the plate, whatever inclination the controller asks for (section 5.4), once the plate has gone
    /// some way. How far the inclination still wanders then, as the friction builds up or a heap grows, is its uncertainty.
    pub(crate) fn after(trace: &Trace, time_s: f64, depth_m: f64) -> Option<Self> {
        let angles = trace.channels().friction_angle_deg.as_deref()?;
        let (t_s, way_m) = (trace.t_s(), trace.displacement_m());
        let failed = t_s.partition_point(|t| *t < time_s);
        let begins = way_m.get(failed)? + BUILDS_UP_REL * depth_m;
        let from = failed + way_m[failed..].iter().position(|way| *way >= begins)?;
        let mut blocks = Vec::new();
        let mut first = from;
        while let Some(start_s) = t_s.get(first) {
            let end = t_s.partition_point(|t| *t < start_s + BLOCK_S).max(first + 1);
            // What is left of the last block may be a single sample.
            if t_s.last().is_some_and(|last| *last >= start_s + 0.8 * BLOCK_S) {
                blocks.push(median(&mut angles[first..end].to_vec()));
            }
            first = end;
        }
        (!blocks.is_empty()).then(|| {
            let angle_deg = median(&mut blocks.clone());
            let spread = sd_of_median_abs(blocks.iter().map(|angle| angle - angle_deg));
            Self { angle_deg, sd_deg: spread.max(LEAST_SD_DEG) }
        })
    }
}
