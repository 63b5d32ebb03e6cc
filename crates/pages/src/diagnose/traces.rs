//! Figures of traces: what was measured, and what the model says without and with the effects.

use soilctl_app::diagnose::{Diagnosed, Resimulated};
use soilctl_diagnosis::{Course, typical_course};
use soilctl_figure::{Axis, Figure, Line};

use crate::PageError;

/// Strokes that are drawn.
const MOST: usize = 3;

/// A figure with its caption for the strokes where the effects change most, each at another tool angle.
pub(super) fn figures(work: &Diagnosed) -> Result<Vec<(Figure, String)>, PageError> {
    let Some(recorded) = &work.traces else { return Ok(Vec::new()) };
    let c = &work.diagnosis.comparison;
    let mut order: Vec<usize> = (0..work.data.len()).collect();
    let change = |i: usize| (c.after[i] - c.before[i]).abs();
    order.sort_by(|&a, &b| change(b).total_cmp(&change(a)));
    let mut levels = Vec::new();
    let mut figures = Vec::new();
    for i in order {
        let Some(Some(measured)) = recorded.courses.get(i) else { continue };
        if levels.contains(&work.data.level[i]) || figures.len() == MOST {
            continue;
        }
        let Some(found) = models(work, &recorded.courses, i) else { continue };
        levels.push(work.data.level[i]);
        figures.push(figure(work, i, measured, &found)?);
    }
    Ok(figures)
}

const TYPICAL: &str = "The model gives the failure force; the way to it and what comes after are the mean of the other \
    strokes at this tool angle, scaled to the depth.";
const SIMULATED: &str = "The same commands on the simulated arm, with the soil as it was fitted.";

/// What is drawn over a measured trace: courses with their failure forces in N.
struct Models {
    before: (Course, f64),
    after: Option<(Course, f64)>,
    caption: &'static str,
}

fn models(work: &Diagnosed, courses: &[Option<Course>], i: usize) -> Option<Models> {
    let c = &work.diagnosis.comparison;
    let name = work.data.rows[i].stroke_id.as_deref().unwrap_or_default();
    let simulated = |of: &Option<Resimulated>| {
        of.as_ref()?.stroke(name).map(|(course, force_n)| (course.clone(), force_n))
    };
    if let Some(before) = simulated(&work.simulated.before) {
        return Some(Models { before, after: simulated(&work.simulated.after), caption: SIMULATED });
    }
    let typical = typical_course(&work.data.rows, courses, i)?;
    let after = (work.diagnosis.has_found()).then(|| (typical.clone(), c.after[i].exp()));
    Some(Models { before: (typical, c.before[i].exp()), after, caption: TYPICAL })
}

fn figure(
    work: &Diagnosed,
    i: usize,
    measured: &Course,
    models: &Models,
) -> Result<(Figure, String), PageError> {
    let row = &work.data.rows[i];
    let name = row.stroke_id.clone().unwrap_or_else(|| (i + 1).to_string());
    let mut figure = Figure::new(
        format!("Stroke {name}: {:.0}\u{b0}, {:.1} mm", row.alpha_deg, 1e3 * row.depth_m),
        Axis::linear("Displacement since the force began to rise (mm)"),
        Axis::linear("Force (N)"),
    );
    let line = |course: &Course, force_n: f64| -> Vec<(f64, f64)> {
        course.points.iter().map(|(x, share)| (1e3 * x * course.way_m, share * force_n)).collect()
    };
    figure.push(Line::new("measured", line(measured, row.force_n)).width(1.2))?;
    figure.push(Line::new("without effects", line(&models.before.0, models.before.1)))?;
    if let Some((course, force_n)) = &models.after {
        figure.push(Line::new("with effects", line(course, *force_n)))?;
    }
    Ok((figure, models.caption.to_owned()))
}
