use soilctl_stats::median;

use crate::error::ProcessError;

/// Tool angles at which lift tells the interface friction, in deg: at 70 deg the thick edge bears on the soil, at
/// 100 deg the soil's motion along the plate hardly shows (section 5.4).
pub const SWEEP_ALPHA_DEG: [f64; 2] = [79.0, 91.0];

/// One stroke of a friction sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SweepStroke {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Interface friction angle that the controller was set to, in deg.
    pub set_deg: f64,
    /// Inclination of the force above the set-point while the failed soil slips, in deg.
    pub lift_deg: f64,
    /// Its standard deviation in deg, above 0.
    pub lift_sd_deg: f64,
}

/// Interface friction by how much the force's inclination lifts when the soil fails.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepEstimate {
    /// Highest set-point with a significant lift in deg: friction is above it.
    pub above_deg: Option<f64>,
    /// Lowest set-point without one, above the former, in deg: friction is below it, as far as a missing lift can tell.
    pub below_deg: Option<f64>,
    /// Estimate in deg.
    pub delta_deg: f64,
    /// Its standard deviation in deg.
    pub sd_deg: f64,
    /// Lift for each degree that the set-point is too low, by the fit.
    pub lift_per_deg: f64,
    /// Lift over its standard deviation, for each stroke that was used.
    pub significance: Vec<f64>,
    /// Strokes at other tool angles, left out (indices into the input).
    pub left_out: Vec<usize>,
}

/// Lifts are significant from this many standard deviations.
const SIGNIFICANT: f64 = 3.0;
/// Step of the search for the angle in deg.
const STEP_DEG: f64 = 0.02;
/// What strokes share, in deg: the sensor's axes, the posture of the plate.
pub(crate) const COMMON_SD_DEG: f64 = 0.3;
/// The force turns by at most what is missing, and by no less than this share of it: the rest would be other causes.
const LEAST_RATE: f64 = 0.3;
/// Searched so far beyond the set-points, in deg.
const BEYOND_DEG: f64 = 6.0;

/// Estimates the interface friction angle from strokes with different set-points.
///
/// When soil slips up along the plate, the force turns to the true friction angle, so a set-point that is too low shows a
/// lift and one that is too high none (section 5.4, figure 5-14). The lift is taken as proportional to what is missing,
/// `max(0, k (delta - set))`; the estimate is the mean over all `delta` and the best `k` for each, weighted by how well
/// they explain the lifts. A stroke that is slipped through has its force at the friction angle, so `k` comes near 1; it is
/// smaller where a stroke ends early.
///
/// # Errors
/// [`ProcessError::TooFew`] with fewer than three strokes at 80-90 deg or fewer than two set-points among them;
/// [`ProcessError::OutOfRange`] of a number that is not finite, or a standard deviation not above 0.
pub fn interface_friction(strokes: &[SweepStroke]) -> Result<SweepEstimate, ProcessError> {
    let mut used = Vec::new();
    let mut left_out = Vec::new();
    for (index, stroke) in strokes.iter().enumerate() {
        check(stroke)?;
        if (SWEEP_ALPHA_DEG[0]..=SWEEP_ALPHA_DEG[1]).contains(&stroke.alpha_deg) {
            used.push(SweepStroke { lift_sd_deg: stroke.lift_sd_deg.hypot(COMMON_SD_DEG), ..*stroke });
        } else {
            left_out.push(index);
        }
    }
    let (low, high) = used
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(s.set_deg), h.max(s.set_deg)));
    if used.len() < 3 {
        return Err(ProcessError::TooFew { what: "strokes at 80 to 90 deg", found: used.len(), least: 3 });
    }
    if high <= low {
        return Err(ProcessError::TooFew { what: "different set-point", found: 1, least: 2 });
    }
    let candidates = search(&used, low, high);
    let least = candidates.iter().map(|c| c.misfit).fold(f64::INFINITY, f64::min);
    let freedom = (used.len() as f64 - 2.0).max(1.0);
    // Lifts scatter more than their own errors say, if the best fit says so.
    let inflation = (least / freedom).max(1.0);
    let weight = |c: &Candidate| (-(c.misfit - least) / (2.0 * inflation)).exp();
    let total: f64 = candidates.iter().map(weight).sum();
    let mean = |value: &dyn Fn(&Candidate) -> f64| {
        candidates.iter().map(|c| weight(c) * value(c)).sum::<f64>() / total
    };
    let delta_deg = mean(&|c| c.delta_deg);
    let sd_deg = mean(&|c| (c.delta_deg - delta_deg).powi(2)).sqrt().hypot(COMMON_SD_DEG);
    let lifted = |s: &SweepStroke| s.lift_deg > SIGNIFICANT * s.lift_sd_deg * inflation.sqrt();
    let above_deg = used.iter().filter(|s| lifted(s)).map(|s| s.set_deg).max_by(f64::total_cmp);
    let below_deg = used
        .iter()
        .filter(|s| !lifted(s) && above_deg.is_none_or(|above| s.set_deg > above))
        .map(|s| s.set_deg)
        .min_by(f64::total_cmp);
    Ok(SweepEstimate {
        above_deg,
        below_deg,
        delta_deg,
        sd_deg,
        lift_per_deg: mean(&|c| c.rate),
        significance: used.iter().map(|s| s.lift_deg / s.lift_sd_deg).collect(),
        left_out,
    })
}

fn check(stroke: &SweepStroke) -> Result<(), ProcessError> {
    let numbers =
        [("tool angle", stroke.alpha_deg), ("set-point", stroke.set_deg), ("lift", stroke.lift_deg)];
    for (what, value) in numbers {
        if !value.is_finite() {
            return Err(ProcessError::OutOfRange { what, value, unit: "deg", allowed: "a finite number" });
        }
    }
    crate::error::positive("standard deviation of the lift", stroke.lift_sd_deg, "deg").map(|_| ())
}

struct Candidate {
    delta_deg: f64,
    rate: f64,
    misfit: f64,
}

fn search(used: &[SweepStroke], low: f64, high: f64) -> Vec<Candidate> {
    let steps = ((high - low + 2.0 * BEYOND_DEG) / STEP_DEG).round().min(1e5) as usize;
    (0..=steps)
        .map(|k| {
            let delta_deg = low - BEYOND_DEG + (high - low + 2.0 * BEYOND_DEG) * k as f64 / steps as f64;
            let (mut xy, mut xx) = (0.0, 0.0);
            for s in used {
                let x = (delta_deg - s.set_deg).max(0.0);
                xy += x * s.lift_deg / s.lift_sd_deg.powi(2);
                xx += x * x / s.lift_sd_deg.powi(2);
            }
            let rate = if xx > 0.0 { (xy / xx).clamp(LEAST_RATE, 1.0) } else { LEAST_RATE };
            let misfit = used
                .iter()
                .map(|s| {
                    let missing = delta_deg - s.set_deg;
                    let off = s.lift_deg - rate * missing.max(0.0);
                    // A force that was asked to lie too steeply falls back when the soil slips: that is no misfit.
                    let off = if missing <= 0.0 { off.max(0.0) } else { off };
                    (off / s.lift_sd_deg).powi(2)
                })
                .sum();
            Candidate { delta_deg, rate, misfit }
        })
        .collect()
}

/// Peak friction angle while a sand-covered plate is rubbed over the tool (figure 5-15).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RubbingPeak {
    /// Median of the peaks in deg; friction between soil and plate is near or above it.
    pub peak_deg: f64,
    /// Spread of the peaks in deg, from the 16th to the 84th percentile.
    pub range_deg: [f64; 2],
    /// Number of peaks.
    pub peaks: usize,
}

/// Time in s in which a rub has one peak.
const RUB_S: f64 = 0.5;

/// Peaks of the friction angle while the normal force presses.
///
/// `friction_angle_deg` and `normal_n` have one value a sample of `t_s`; samples with less than `least_normal_n` of
/// normal force don't count. The size of the angle counts, whichever way the plate is rubbed.
///
/// # Errors
/// [`ProcessError::Lengths`], [`ProcessError::NotFinite`], [`ProcessError::OutOfRange`] of the least force, and
/// [`ProcessError::TooFew`] with fewer than three half-seconds of contact.
pub fn rubbing_peak(
    t_s: &[f64],
    friction_angle_deg: &[f64],
    normal_n: &[f64],
    least_normal_n: f64,
) -> Result<RubbingPeak, ProcessError> {
    crate::error::positive("least normal force", least_normal_n, "N")?;
    for (column, values) in [("friction_angle_deg", friction_angle_deg), ("normal_n", normal_n), ("t_s", t_s)]
    {
        if values.len() != t_s.len() {
            return Err(ProcessError::Lengths { column, found: values.len(), expected: t_s.len() });
        }
        if let Some((index, &value)) = values.iter().enumerate().find(|(_, v)| !v.is_finite()) {
            return Err(ProcessError::NotFinite { column, index, value });
        }
    }
    let mut peaks: Vec<f64> = Vec::new();
    let mut window = None;
    for ((t, angle), normal) in t_s.iter().zip(friction_angle_deg).zip(normal_n) {
        if *normal < least_normal_n {
            continue;
        }
        let this = (t / RUB_S).floor();
        match peaks.last_mut() {
            Some(peak) if window == Some(this) => *peak = peak.max(angle.abs()),
            _ => peaks.push(angle.abs()),
        }
        window = Some(this);
    }
    if peaks.len() < 3 {
        return Err(ProcessError::TooFew { what: "half-seconds of contact", found: peaks.len(), least: 3 });
    }
    let peak_deg = median(&mut peaks);
    let at = |share: f64| {
        peaks.get((share * (peaks.len() - 1) as f64).round() as usize).copied().unwrap_or(peak_deg)
    };
    Ok(RubbingPeak { peak_deg, range_deg: [at(0.16), at(0.84)], peaks: peaks.len() })
}
