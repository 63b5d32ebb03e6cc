//! How the force of a stroke rises and falls, to be drawn.

use soilctl_strokes::{StrokeRow, TraceTable};

use super::phase::Parts;

/// Most points of a course.
const MOST_POINTS: usize = 400;
/// Steps of a mean course from the rise to failure, and up to how many such ways it goes.
const STEPS: usize = 40;
const MOST_WAYS: f64 = 8.0;

/// The course of a stroke from where its force begins to rise to half a depth after failure.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Displacement from the rise to failure in m, above 0.
    pub way_m: f64,
    /// Displacement since the rise over that at failure, and force over the failure force.
    pub points: Vec<(f64, f64)>,
}

/// The courses of strokes; `None` where there is no trace in which the failure was found. `failure_time_s` as for
/// [`crate::Data::add_traces`].
#[must_use]
pub fn courses(
    rows: &[StrokeRow],
    traces: &TraceTable,
    failure_time_s: &[Option<f64>],
) -> Vec<Option<Course>> {
    let of = |(i, row): (usize, &StrokeRow)| {
        let samples = traces.get(row.stroke_id.as_deref()?)?;
        let parts = Parts::of(samples, row, failure_time_s.get(i).copied().flatten())?;
        let way_m = samples[parts.failure].x_ext_m - samples[parts.rise].x_ext_m;
        (way_m > 0.0).then(|| Course { way_m, points: parts.course(MOST_POINTS) })
    };
    rows.iter().enumerate().map(of).collect()
}

/// The mean course of the other strokes at the tool angle of a stroke: what its own is to be compared with. `None` if there
/// is no other one.
#[must_use]
pub fn typical_course(rows: &[StrokeRow], courses: &[Option<Course>], stroke: usize) -> Option<Course> {
    let alpha_deg = rows.get(stroke)?.alpha_deg;
    let like = |i: usize| i != stroke && (rows[i].alpha_deg - alpha_deg).abs() < 1.0;
    let found: Vec<(usize, &Course)> =
        courses.iter().enumerate().filter_map(|(i, c)| Some((i, c.as_ref().filter(|_| like(i))?))).collect();
    let count = found.len() as f64;
    let way_rel = found.iter().map(|(i, course)| course.way_m / rows[*i].depth_m).sum::<f64>() / count;
    let mut points = Vec::new();
    for step in 0.. {
        let x = f64::from(step) / STEPS as f64;
        let values: Option<Vec<f64>> = found.iter().map(|(_, course)| at(&course.points, x)).collect();
        let Some(values) = values.filter(|values| !values.is_empty() && x <= MOST_WAYS) else { break };
        points.push((x, values.iter().sum::<f64>() / values.len() as f64));
    }
    (points.len() > 1).then(|| Course { way_m: way_rel * rows[stroke].depth_m, points })
}

/// Value at a place of a course, the mean of the samples about it; `None` beyond its end.
fn at(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let half = 0.5 / STEPS as f64;
    let near: Vec<f64> = points.iter().filter(|p| (p.0 - x).abs() <= half).map(|p| p.1).collect();
    if !near.is_empty() {
        return Some(near.iter().sum::<f64>() / near.len() as f64);
    }
    // An encoder with large steps leaves holes.
    let after = points.iter().position(|p| p.0 > x)?;
    let (b, a) = (points[after], points[after.checked_sub(1)?]);
    (b.0 > a.0).then(|| a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0))
}
