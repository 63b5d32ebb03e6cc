//! Where in a trace the force rises, the soil fails, and what counts as after.

use std::ops::Range;

use soilctl_stats::median;
use soilctl_strokes::{StrokeRow, TraceSample};

/// Share of the failure force at which it begins to rise. Empirical, as are all others here.
const RISEN: f64 = 0.1;
/// Share of the failure force at which the soil counts as failed, for the table's force comes from a fit.
const FAILED: f64 = 0.97;
/// A trace that does not reach this share of the failure force is of another stroke.
const LEAST: f64 = 0.7;
/// Half width of the phase of failure and length of the phase after it, over the depth.
const ABOUT: f64 = 0.03;
const AFTER: f64 = 0.55;
/// Fewest samples of a trace and of a phase.
const FEWEST: usize = 20;
const FEWEST_OF_PHASE: usize = 3;
/// Samples over which a median is taken.
const SMOOTH: usize = 5;

/// A trace and its phases.
pub(super) struct Parts<'a> {
    pub(super) samples: &'a [TraceSample],
    /// Force across the plate (or whole, where its inclination was not recorded) over that at failure, smoothed.
    pub(super) share: Vec<f64>,
    pub(super) rise: usize,
    pub(super) failure: usize,
    /// Depth in m.
    pub(super) depth_m: f64,
}

impl<'a> Parts<'a> {
    /// `None` of a trace that is too short or does not reach the failure force.
    pub(super) fn of(
        samples: &'a [TraceSample],
        row: &StrokeRow,
        failure_time_s: Option<f64>,
    ) -> Option<Self> {
        if samples.len() < FEWEST {
            return None;
        }
        // An insertion leaves a load along the plate of up to twice the failure force; what fails the soil acts across it.
        let inclined = samples.iter().all(|s| s.friction_angle_deg.is_some());
        let across: Vec<f64> = samples
            .iter()
            .map(|s| match s.friction_angle_deg.filter(|_| inclined) {
                Some(angle) => s.force_n * angle.to_radians().cos(),
                None => s.force_n,
            })
            .collect();
        let smooth = smoothed(&across);
        let angle = row.friction_angle_deg.or(row.delta_set_deg).filter(|_| inclined).unwrap_or(0.0);
        let full = row.force_n * angle.to_radians().cos();
        let share: Vec<f64> = smooth.iter().map(|force| force / full).collect();
        let known = failure_time_s.and_then(|time_s| {
            let at = samples.partition_point(|s| s.t_s < time_s);
            (at > 0 && at < samples.len() && share[at] > LEAST).then_some(at)
        });
        let highest = || {
            let mut best = 0;
            for (i, value) in share.iter().enumerate() {
                if *value > share[best] {
                    best = i;
                }
            }
            (share[best] >= LEAST).then_some(best)
        };
        let failure = known.or_else(|| share.iter().position(|s| *s >= FAILED)).or_else(highest)?;
        let rise = share[..failure].iter().rposition(|s| *s < RISEN).unwrap_or(0);
        (failure > rise + FEWEST_OF_PHASE).then_some(Self {
            samples,
            share,
            rise,
            failure,
            depth_m: row.depth_m,
        })
    }

    /// Samples before the force rises.
    pub(super) fn before(&self) -> Range<usize> {
        0..self.rise
    }

    /// From the rise to the phase of failure.
    pub(super) fn loading(&self) -> Range<usize> {
        self.rise..self.about().start.max(self.rise)
    }

    /// About failure.
    pub(super) fn about(&self) -> Range<usize> {
        let at = self.samples[self.failure].x_ext_m;
        let near = ABOUT * self.depth_m;
        let from = self.samples[..self.failure].iter().rposition(|s| s.x_ext_m < at - near);
        let from = from.map_or(self.rise, |i| i + 1).max(self.rise).min(self.failure.saturating_sub(2));
        from..self.failure + 1
    }

    /// After failure, up to half a depth on.
    pub(super) fn after(&self) -> Range<usize> {
        let at = self.samples[self.failure].x_ext_m;
        let rest = &self.samples[self.failure..];
        let from = rest.iter().position(|s| s.x_ext_m > at + ABOUT * self.depth_m);
        let Some(from) = from else { return 0..0 };
        let to = rest.iter().position(|s| s.x_ext_m > at + AFTER * self.depth_m).unwrap_or(rest.len());
        // Whoever lifts the plate out ends the stroke: the force falls away.
        let end = rest[..to].iter().enumerate().position(|(i, _)| self.share[self.failure + i] < 0.2);
        let to = end.unwrap_or(to);
        self.failure + from.min(to)..self.failure + to
    }

    /// Median of a reading in a part; `None` of less than three readings.
    pub(super) fn median(
        &self,
        part: Range<usize>,
        value: impl Fn(&TraceSample) -> Option<f64>,
    ) -> Option<f64> {
        let mut values: Vec<f64> = self.samples.get(part)?.iter().filter_map(value).collect();
        (values.len() >= FEWEST_OF_PHASE).then(|| median(&mut values))
    }

    /// Displacement since the rise over that at failure, and share of the failure force.
    pub(super) fn course(&self, most: usize) -> Vec<(f64, f64)> {
        let origin = self.samples[self.rise].x_ext_m;
        let way = self.samples[self.failure].x_ext_m - origin;
        let end = self.after().end.max(self.failure + 1);
        let every = ((end - self.rise) / most.max(1)).max(1);
        let steps = (self.rise..end).step_by(every).filter(|_| way > 0.0);
        steps.map(|i| ((self.samples[i].x_ext_m - origin) / way, self.share[i])).collect()
    }
}

/// Moving median.
fn smoothed(values: &[f64]) -> Vec<f64> {
    let half = SMOOTH / 2;
    (0..values.len())
        .map(|i| median(&mut values[i.saturating_sub(half)..(i + half + 1).min(values.len())].to_vec()))
        .collect()
}
