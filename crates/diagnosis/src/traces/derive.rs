//! Readings of a stroke out of its trace.

use soilctl_effects::Channel;
use soilctl_stats::{Line, median};
use soilctl_strokes::{StrokeRow, TraceSample};

use super::phase::Parts;
use super::step::repeated_step;
use super::{Phase, PhaseKey};

/// Share of the depth after failure within which the residual is read: half a depth on, within a tenth. Empirical, as are the
/// next three.
const RESIDUAL: [f64; 2] = [0.45, 0.55];
/// Least range of the force, over the failure force, from which a slope over it means something.
const LEAST_RANGE: f64 = 0.4;
/// Fewest samples of a line.
const FEWEST: usize = 6;
/// Least way after failure over the depth from which a slope means something.
const LEAST_WAY: f64 = 0.05;

fn gap(sample: &TraceSample) -> Option<f64> {
    Some(sample.x_mtr_m? - sample.x_ext_m)
}

/// What a trace says of columns that the stroke table may lack.
pub(super) fn channels(parts: &Parts<'_>, row: &StrokeRow) -> Vec<(Channel, f64)> {
    let samples = parts.samples;
    let failure = &samples[parts.failure];
    let start = parts.before().start..(parts.rise + 1).max(3);
    let height = |sample: &TraceSample| sample.z_m;
    let positions: Vec<f64> = samples.iter().map(|s| s.x_ext_m).collect();
    let (slope, residual) = after(parts);
    let found = [
        (Channel::FrictionAngle, parts.median(parts.about(), |s| s.friction_angle_deg)),
        (
            Channel::ZDrift,
            parts
                .median(parts.about(), height)
                .zip(parts.median(start, height))
                .map(|(end, start)| end - start),
        ),
        (Channel::Displacement, Some(failure.x_ext_m - samples[parts.rise].x_ext_m)),
        (Channel::PostSlope, slope),
        (Channel::ResidualRatio, residual),
        (Channel::MotorExtGap, parts.median(parts.about(), gap)),
        (Channel::GapSlope, gap_slope(parts, row.force_n)),
        (Channel::SlipAngle, parts.median(parts.after(), |s| s.friction_angle_deg)),
        (Channel::XStep, repeated_step(&positions)),
    ];
    found
        .into_iter()
        .filter_map(|(channel, value)| Some((channel, value.filter(|v| v.is_finite())?)))
        .collect()
}

/// Readings by phase, of the columns that they belong to.
pub(super) fn phases(parts: &Parts<'_>) -> Vec<(PhaseKey, f64)> {
    let median_of = |part: std::ops::Range<usize>| {
        let mut values = parts.share.get(part).unwrap_or_default().to_vec();
        (values.len() >= 3).then(|| median(&mut values))
    };
    let difference = |a: Option<f64>, b: Option<f64>| Some(a? - b?);
    let angle = |sample: &TraceSample| sample.friction_angle_deg;
    let height = |sample: &TraceSample| sample.z_m;
    let at_failure = parts.median(parts.about(), gap);
    let found = [
        (("force_n", Phase::Loading), fullness(parts)),
        (("force_n", Phase::After), median_of(parts.after())),
        (("motor_ext_gap_m", Phase::After), difference(parts.median(parts.after(), gap), at_failure)),
        (("friction_angle_deg", Phase::Loading), parts.median(parts.loading(), angle)),
        (
            ("z_m", Phase::After),
            difference(parts.median(parts.after(), height), parts.median(parts.about(), height)),
        ),
    ];
    found.into_iter().filter_map(|(key, value)| Some((key, value.filter(|v| v.is_finite())?))).collect()
}

/// Mean share of the failure force on the way to it: a half if the force rises evenly, more if it rises early.
fn fullness(parts: &Parts<'_>) -> Option<f64> {
    let (mut area, mut way) = (0.0, 0.0);
    for i in parts.rise..parts.failure {
        let step = parts.samples[i + 1].x_ext_m - parts.samples[i].x_ext_m;
        area += 0.5 * step * (parts.share[i] + parts.share[i + 1]);
        way += step;
    }
    (way > 0.0).then(|| area / way)
}

/// Change of motor-side minus external position with the force while it rises, in m/N: what stretches between the two.
/// Free play is taken up at once and does not count.
fn gap_slope(parts: &Parts<'_>, force_n: f64) -> Option<f64> {
    let points: Vec<(f64, f64)> = (parts.rise..=parts.failure)
        .filter_map(|i| Some((parts.share[i] * force_n, gap(&parts.samples[i])?)))
        .collect();
    let (low, high) = points.iter().fold((f64::INFINITY, 0.0_f64), |(l, h), p| (l.min(p.0), h.max(p.0)));
    (points.len() >= FEWEST && high - low >= LEAST_RANGE * force_n).then(|| slope(&points)).flatten()
}

/// Slope after failure, scaled by depth and failure force, and the share that is left half a depth on.
fn after(parts: &Parts<'_>) -> (Option<f64>, Option<f64>) {
    let at = parts.samples[parts.failure].x_ext_m;
    let points: Vec<(f64, f64)> =
        parts.after().map(|i| ((parts.samples[i].x_ext_m - at) / parts.depth_m, parts.share[i])).collect();
    let way = points.iter().map(|p| p.0).fold(0.0, f64::max);
    let slope = (points.len() >= FEWEST && way >= LEAST_WAY).then(|| slope(&points)).flatten();
    let mut half: Vec<f64> =
        points.iter().filter(|p| (RESIDUAL[0]..=RESIDUAL[1]).contains(&p.0)).map(|p| p.1).collect();
    (slope, (!half.is_empty()).then(|| median(&mut half)))
}

/// Slope of a straight line by least squares; `None` where nothing varies.
fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let line = Line::fit(&points.iter().map(|&(x, y)| (x, y, 1.0)).collect::<Vec<_>>());
    (line.sxx > 0.0 && line.slope.is_finite()).then_some(line.slope)
}
