use crate::trace::Trace;

/// What other channels did at the failure: the mean shortly after minus that before, and how many standard errors
/// that is. None of it decides; it tells whether the force-displacement curve is right (section 5.5).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Evidence {
    /// Inclination of the force in deg.
    pub friction_angle_deg: Option<Change>,
    /// Height of the plate's lower edge in m.
    pub z_m: Option<Change>,
    /// Point where the force acts along the plate in m.
    pub centre_m: Option<Change>,
}

/// A change across the failure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Mean just before.
    pub before: f64,
    /// Mean after minus mean before.
    pub change: f64,
    /// Change over its standard error.
    pub significance: f64,
}

/// Longest time that is compared before and after, in s.
const WINDOW_S: f64 = 0.5;
/// Left out on either side of the failure, in s: it is not that exactly known.
const MARGIN_S: f64 = 0.04;

impl Evidence {
    pub(super) fn at(trace: &Trace, time_s: f64) -> Self {
        let of = |values: &Option<Vec<f64>>| change(trace.t_s(), values.as_deref()?, time_s);
        let channels = trace.channels();
        Self {
            friction_angle_deg: of(&channels.friction_angle_deg),
            z_m: of(&channels.z_m),
            centre_m: of(&channels.centre_m),
        }
    }
}

fn change(t_s: &[f64], values: &[f64], time_s: f64) -> Option<Change> {
    let window = |from: f64, to: f64| {
        let (first, last) = (t_s.partition_point(|t| *t < from), t_s.partition_point(|t| *t < to));
        values.get(first..last).filter(|part| part.len() >= 3)
    };
    let before = window(time_s - MARGIN_S - WINDOW_S, time_s - MARGIN_S)?;
    let after = window(time_s + MARGIN_S, time_s + MARGIN_S + WINDOW_S)?;
    let moments = |part: &[f64]| {
        let n = part.len() as f64;
        let mean = part.iter().sum::<f64>() / n;
        (mean, part.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0) / n)
    };
    let ((mean, square), (mean_after, square_after)) = (moments(before), moments(after));
    let change = mean_after - mean;
    let error = (square + square_after).sqrt();
    // Without any scatter a change is certain, and none is none.
    let significance =
        if error > 0.0 { (change / error).clamp(-1e6, 1e6) } else { 1e6 * f64::from(change != 0.0) };
    Some(Change { before: mean, change, significance })
}
