//! Figures of section 5.4 and 5.6 and of chapter 6.

use clap::ValueEnum;
use soilctl_app::process::Analysis;
use soilctl_figure::{Axis, Figure, Line, Points, RefLine, Span};
use soilctl_process::table::StrokeRecord;

use crate::PageError;

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Lift of the force's angle at failure against set-point (figure 5-14)
    Friction,
    /// Friction angle while the plate is rubbed (figure 5-15)
    Rubbing,
    /// F/H^2 against depth
    Depth,
    /// Forces at the nominal depth against tool angle
    Campaign,
}

/// The figure that was asked for.
///
/// # Errors
/// [`PageError::Nothing`] if the strokes do not tell it.
pub fn figure(kind: Kind, analysis: &Analysis, strokes: &[StrokeRecord]) -> Result<Figure, PageError> {
    let missing = |what: &str| PageError::Nothing(format!("there is nothing to plot: {what}"));
    match kind {
        Kind::Friction => friction(analysis)?.ok_or_else(|| {
            missing(analysis.no_friction.as_deref().unwrap_or("there is no sweep of set-points"))
        }),
        Kind::Rubbing => rubbing(analysis)?.ok_or_else(|| missing("give a log of rubbing with --rubbing")),
        Kind::Depth => depth(analysis, strokes)?
            .ok_or_else(|| missing("no tool angle has three strokes at different depths")),
        Kind::Campaign => campaign(analysis, strokes)?.ok_or_else(|| missing("there are no strokes")),
    }
}

/// Figure 5-14: lift at failure against set-point; `None` without a sweep.
pub(crate) fn friction(analysis: &Analysis) -> Result<Option<Figure>, PageError> {
    let Some(found) = &analysis.friction else { return Ok(None) };
    let mut figure = Figure::new(
        "Lift at failure",
        Axis::linear("Set-point of the interface friction (deg)"),
        Axis::linear("Inclination above the set-point after failure (deg)"),
    );
    let half = 2.0 * found.sd_deg;
    figure.push(Span::vertical("estimate ± 2 sd", found.delta_deg - half, found.delta_deg + half))?;
    let points: Vec<(f64, f64)> = found.strokes.iter().map(|s| (s.set_deg, s.lift_deg)).collect();
    let (low, high) = points
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.0), high.max(p.0)));
    let at = |set: f64| (found.lift_per_deg * (found.delta_deg - set)).max(0.0);
    let mut ends: Vec<f64> = vec![low - 1.0, found.delta_deg, high + 1.0];
    ends.sort_by(f64::total_cmp);
    let line: Vec<(f64, f64)> = ends.into_iter().map(|set| (set, at(set))).collect();
    figure.push(Line::new("fit", line))?;
    let bars: Vec<(f64, f64)> = found.strokes.iter().map(|s| (s.lift_sd_deg, s.lift_sd_deg)).collect();
    let labels = found.strokes.iter().map(|s| s.stroke_id.clone());
    figure.push(Points::new("strokes", points).y_error(bars).labels(labels))?;
    figure.push(RefLine::horizontal("", 0.0))?;
    Ok(Some(figure))
}

/// Figure 5-15: friction angle while a sand-covered plate is rubbed.
pub(crate) fn rubbing(analysis: &Analysis) -> Result<Option<Figure>, PageError> {
    let Some(found) = &analysis.rubbing else { return Ok(None) };
    let mut figure = Figure::new("Rubbing", Axis::linear("Time (s)"), Axis::linear("Friction angle (deg)"));
    figure.push(Span::horizontal("two thirds of the peaks", found.range_deg[0], found.range_deg[1]))?;
    figure.push(Line::new("friction angle", found.course.clone()).width(1.0))?;
    figure.push(RefLine::horizontal("median of the peaks", found.peak_deg))?;
    Ok(Some(figure))
}

/// F/H^2 against depth.
pub(crate) fn depth(analysis: &Analysis, strokes: &[StrokeRecord]) -> Result<Option<Figure>, PageError> {
    if analysis.depth_laws.is_empty() {
        return Ok(None);
    }
    let mut figure = Figure::new(
        "Force over the square of depth",
        Axis::linear("Depth H (mm)"),
        Axis::linear("F/H² (N/cm²)"),
    );
    for (color, law) in analysis.depth_laws.iter().enumerate() {
        let of: Vec<&StrokeRecord> = strokes.iter().filter(|s| s.row.alpha_deg == law.alpha_deg).collect();
        let points: Vec<(f64, f64)> =
            of.iter().map(|s| (s.row.depth_m * 1e3, per_square(s, s.row.force_n))).collect();
        let bars: Vec<(f64, f64)> =
            of.iter().map(|s| per_square(s, s.row.force_sd_n.unwrap_or(0.0))).map(|sd| (sd, sd)).collect();
        let name = format!("{:.0}°, n = {:.2}", law.alpha_deg, law.exponent);
        figure.push(Points::new(name, points.clone()).y_error(bars).color(color))?;
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p.0), high.max(p.0)));
        let level = law.quadratic_n_per_m2 * 1e-4;
        figure.push(Line::new("", [(low, level), (high, level)]).color(color))?;
    }
    Ok(Some(figure))
}

/// A force over the square of the stroke's depth in N/cm2.
fn per_square(stroke: &StrokeRecord, force_n: f64) -> f64 {
    force_n / (stroke.row.depth_m * stroke.row.depth_m) * 1e-4
}

/// Forces at the nominal depth, means with their scatter, and the model.
pub(crate) fn campaign(analysis: &Analysis, strokes: &[StrokeRecord]) -> Result<Option<Figure>, PageError> {
    if analysis.groups.is_empty() {
        return Ok(None);
    }
    let mut figure = Figure::new(
        "Failure forces of the campaign",
        Axis::linear("Tool angle (deg)"),
        Axis::linear(format!("Force at a slant length of {:.1} mm (N)", analysis.slant_m * 1e3)),
    );
    let scaled = |s: &StrokeRecord| {
        let nominal_m = analysis.slant_m * s.row.alpha_deg.to_radians().sin();
        s.row.force_n * (nominal_m / s.row.depth_m).powi(2)
    };
    let outlier =
        |s: &&StrokeRecord| analysis.groups.iter().any(|g| g.outliers.iter().any(|name| name == s.name()));
    let (out, kept): (Vec<&StrokeRecord>, Vec<&StrokeRecord>) = strokes.iter().partition(outlier);
    for (name, of) in [("strokes", kept), ("outliers", out)] {
        if !of.is_empty() {
            let points: Vec<(f64, f64)> = of.iter().map(|s| (s.row.alpha_deg, scaled(s))).collect();
            let labels = of.iter().map(|s| s.name().to_owned());
            figure.push(Points::new(name, points).labels(labels))?;
        }
    }
    let means: Vec<(f64, f64)> = analysis.groups.iter().map(|g| (g.alpha_deg, g.mean_n)).collect();
    let bars: Vec<(f64, f64)> =
        analysis.groups.iter().map(|g| g.sd_n.unwrap_or(0.0)).map(|sd| (sd, sd)).collect();
    figure.push(Points::new("means ± sd", means).y_error(bars))?;
    let model: Vec<(f64, f64)> =
        analysis.groups.iter().filter_map(|g| Some((g.alpha_deg, g.model_n?))).collect();
    if let Some(comparison) = analysis.comparison.as_ref().filter(|_| model.len() > 1) {
        figure.push(Line::new(format!("model {}", comparison.model), model))?;
    }
    Ok(Some(figure))
}
