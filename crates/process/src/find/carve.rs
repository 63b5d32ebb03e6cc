//! The stroke within a contact: what lies between insertion and pull-out.

use soilctl_stats::median;

use super::{Contact, FindSettings, Recorded};
use crate::robot::RobotSample;

/// The stroke, or how far the plate travelled if it is none.
pub(super) fn stroke(
    samples: Vec<RobotSample>,
    tare: Option<[f64; 6]>,
    tare_after: Option<[f64; 6]>,
    settings: &FindSettings,
) -> Result<Contact, f64> {
    let mut heights: Vec<f64> = samples.iter().map(|s| s.tip_m[2]).collect();
    heights.sort_by(f64::total_cmp);
    // Not the very lowest: encoders jump.
    let lowest = heights.get(heights.len() / 20).copied().ok_or(0.0)?;
    let inserted = samples.iter().position(|s| s.tip_m[2] <= lowest + settings.lowest_m).ok_or(0.0)?;
    let out = samples[inserted..].iter().position(|s| s.tip_m[2] > lowest + settings.out_m);
    let end = out.map_or(samples.len(), |steps| inserted + steps);
    // The last of the insertion: until the plate is as low as it is most of the time.
    let mut below: Vec<f64> = samples[inserted..end].iter().map(|s| s.tip_m[2]).collect();
    let usual = median(&mut below) + 0.1 * settings.lowest_m;
    let inserted = inserted + samples[inserted..end].iter().position(|s| s.tip_m[2] <= usual).unwrap_or(0);
    let down = &samples[inserted..end];
    let start = mean_place(down.get(..(down.len() / 50).max(1)).unwrap_or(down)).ok_or(0.0)?;
    let travel = |s: &RobotSample| (s.tip_m[0] - start[0]).hypot(s.tip_m[1] - start[1]);
    let far = (0..down.len()).max_by(|a, b| travel(&down[*a]).total_cmp(&travel(&down[*b]))).ok_or(0.0)?;
    let travel_m = travel(&down[far]);
    if !(travel_m.is_finite() && travel_m >= settings.least_travel_m) {
        return Err(travel_m);
    }
    let direction = [(down[far].tip_m[0] - start[0]) / travel_m, (down[far].tip_m[1] - start[1]) / travel_m];
    let taken = tare.unwrap_or_default();
    // Until the plate is furthest: afterwards it is pulled back.
    let samples = down[..=far]
        .iter()
        .map(|s| RobotSample { wrench: std::array::from_fn(|i| s.wrench[i] - taken[i]), ..*s })
        .collect();
    Ok(Contact::Stroke(Recorded { samples, direction, tare_before: tare, tare_after }))
}

fn mean_place(samples: &[RobotSample]) -> Option<[f64; 2]> {
    (!samples.is_empty())
        .then(|| [0, 1].map(|i| median(&mut samples.iter().map(|s| s.tip_m[i]).collect::<Vec<f64>>())))
}
