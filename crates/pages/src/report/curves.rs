//! All models at one tool angle against the friction angle, with what was measured.

use soilctl_app::estimate::Estimation;
use soilctl_app::text::number;
use soilctl_earth_pressure::{Case, model};
use soilctl_figure::{Axis, Band, Figure, Line, Span};
use soilctl_soil::{Angle, WidthRatio};

use crate::PageError;

const MODELS: [(&str, &str); 4] = [
    ("coulomb", "Coulomb"),
    ("log-spiral", "log-spiral"),
    ("caquot", "Caquot & Kerisel"),
    ("chen", "Chen & Liu"),
];
const STEPS: usize = 60;

/// `None` if no model has an answer there.
pub(super) fn against_phi(work: &Estimation, alpha_deg: f64) -> Result<Option<Figure>, PageError> {
    let setup = work.setup()?;
    let delta = f64::midpoint(setup.delta_deg.0, setup.delta_deg.1);
    let (low, high) = (delta.max(25.0), 50.0);
    let phi = |i: usize| low + (high - low) * i as f64 / STEPS as f64;
    let predict = |id: &str| -> Result<Vec<(f64, f64, f64)>, PageError> {
        let model = model(id)?;
        let at = |p: f64| {
            let case = Case {
                tool_angle: Angle::from_degrees(alpha_deg),
                surface_slope: Angle::from_degrees(work.request.loads.beta_deg),
                width_ratio: WidthRatio::PLANE_STRAIN,
                friction: Angle::from_degrees(p),
                interface: Angle::from_degrees(delta),
            };
            model.predict(&case).ok().map(|found| (p, found.net_lower.0, found.net_upper.0))
        };
        // A curve ends where its model ends: Coulomb's runs to infinity.
        Ok((0..=STEPS).map(phi).map_while(at).filter(|point| point.2 < 300.0).collect())
    };
    let title = format!("Net coefficient at α = {}°, δ = {}°", number(alpha_deg), number(delta));
    let mut figure =
        Figure::new(title, Axis::linear("Friction angle φ (deg)"), Axis::log("Net coefficient K"));
    let bracket = predict("table")?;
    if bracket.len() > 1 {
        let column = |f: fn(&(f64, f64, f64)) -> f64| bracket.iter().map(f).collect::<Vec<_>>();
        figure.push(
            Band::new("numerical bounds", column(|c| c.0), column(|c| c.1), column(|c| c.2)).color(4),
        )?;
    }
    for (color, (id, name)) in MODELS.into_iter().enumerate() {
        let curve = predict(id)?;
        if curve.len() > 1 {
            figure
                .push(Line::new(name, curve.iter().map(|c| (c.0, c.1)).collect::<Vec<_>>()).color(color))?;
        }
    }
    if figure.layers().is_empty() {
        return Ok(None);
    }
    let density = match (&work.answer.best_estimate, work.inputs.density_kg_m3) {
        (_, Some((low, high))) => f64::midpoint(low, high),
        (Some(best), None) => best.density_kg_m3,
        (None, None) => return Ok(Some(figure)),
    };
    for o in setup.observations.iter().filter(|o| (o.plate().tool_angle().degrees() - alpha_deg).abs() < 1e-9)
    {
        let plate = o.plate();
        let scale = 0.5 * density * setup.gravity_m_s2 * plate.slant_length_m().powi(2) * plate.width_m();
        if o.low_n() > 0.0 {
            let name = format!("measured, at {density:.0} kg/m³");
            figure.push(Span::horizontal(name, o.low_n() / scale, o.high_n() / scale).color(5))?;
        }
    }
    Ok(Some(figure))
}
