//! Figures of a diagnosis.

use soilctl_app::diagnose::Diagnosed;
use soilctl_figure::{Axis, Figure, Points, RefLine};

use crate::PageError;

type Get = fn(&soilctl_strokes::StrokeRow) -> Option<f64>;

/// Covariates that a residual may be drawn over: column, label, value.
const AXES: [(&str, &str, Get); 11] = [
    ("alpha_deg", "Tool angle (deg)", |r| Some(r.alpha_deg)),
    ("depth_m", "Depth (mm)", |r| Some(1e3 * r.depth_m)),
    ("width_m", "Width (mm)", |r| Some(1e3 * r.width_m)),
    ("speed_mps", "Speed (mm/s)", |r| r.speed_mps.map(|v| 1e3 * v)),
    ("radius_m", "Radius (mm)", |r| r.radius_m.map(|v| 1e3 * v)),
    ("base_deg", "Base angle (deg)", |r| r.base_deg),
    ("gap_prior_m", "Distance to the nearest earlier stroke (mm)", |r| r.gap_prior_m.map(|v| 1e3 * v)),
    ("wall_m", "Distance to the wall (mm)", |r| r.wall_m.map(|v| 1e3 * v)),
    ("delta_set_deg", "Set interface friction (deg)", |r| r.delta_set_deg),
    ("order", "Order within the batch", |r| r.order.map(f64::from)),
    ("time_s", "Time (h)", |r| r.time_s.map(|v| v / 3600.0)),
];

/// Relative difference of measured and predicted force over a covariate, before and after; `None` if it is not known.
pub(super) fn residuals(work: &Diagnosed, covariate: &str) -> Result<Option<Figure>, PageError> {
    let Some((_, label, get)) = AXES.iter().find(|(column, ..)| *column == covariate) else {
        return Ok(None);
    };
    let c = &work.diagnosis.comparison;
    let of = |ln_model: &[f64], shift: f64| -> Vec<(f64, f64)> {
        let known: Vec<f64> = work.data.rows.iter().filter_map(get).collect();
        let low = known.iter().copied().fold(f64::INFINITY, f64::min);
        let high = known.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        work.data
            .rows
            .iter()
            .enumerate()
            .filter_map(|(i, row)| {
                // Set side by side, so that points at the same level do not hide each other.
                let x = get(row)? + shift * (high - low);
                Some((x, 100.0 * ((work.data.ln_force[i] - ln_model[i]).exp() - 1.0)))
            })
            .collect()
    };
    let before = of(&c.before, -0.006);
    if before.is_empty() {
        return Ok(None);
    }
    let (name, _) = label.split_once(" (").unwrap_or((label, ""));
    let title = format!("Measured over predicted force, by {}", name.to_lowercase());
    let mut figure = Figure::new(title, Axis::linear(*label), Axis::linear("Difference (%)"));
    figure.push(RefLine::horizontal("", 0.0))?;
    figure.push(Points::new("without effects", before))?;
    if work.diagnosis.has_found() {
        figure.push(Points::new("with effects", of(&c.after, 0.006)))?;
    }
    Ok(Some(figure))
}

/// Measured against predicted force.
pub(super) fn forces(work: &Diagnosed) -> Result<Figure, PageError> {
    let c = &work.diagnosis.comparison;
    let of = |ln_model: &[f64]| -> Vec<(f64, f64)> {
        ln_model.iter().zip(&work.data.ln_force).map(|(model, force)| (model.exp(), force.exp())).collect()
    };
    let mut figure = Figure::new(
        "Measured and predicted force",
        Axis::log("Predicted force (N)"),
        Axis::log("Measured force (N)"),
    );
    let all: Vec<f64> = work.data.ln_force.iter().chain(&c.before).copied().collect();
    let low = all.iter().copied().fold(f64::INFINITY, f64::min).exp();
    let high = all.iter().copied().fold(f64::NEG_INFINITY, f64::max).exp();
    figure.push(soilctl_figure::Line::new("equal", [(low, low), (high, high)]).color(6).width(1.0))?;
    figure.push(Points::new("without effects", of(&c.before)).color(0))?;
    if work.diagnosis.has_found() {
        figure.push(Points::new("with effects", of(&c.after)).color(1))?;
    }
    Ok(figure)
}
