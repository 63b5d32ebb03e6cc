//! The page of bounds on a plate's force.

use soilctl_app::bound::{Answer, Bounded, Inputs};
use soilctl_app::text::{number, rounded_down, rounded_up};
use soilctl_figure::HtmlReport;

use crate::PageError;
use crate::limits::{self, PageContent, bounds_table, level_table, proven, round};
use crate::problem::Scene;

/// The page of bounds on a plate's force.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(found: &Bounded) -> Result<HtmlReport, PageError> {
    let fields = &found.fields;
    // The statement lies along the surface.
    let slope = found.answer.inputs.beta_deg;
    let scene = Scene::of_statement(fields.statement()?, &fields.units, &fields.title, slope);
    limits::page(fields, &scene, content(&found.answer)?, &found.answer.results)
}

fn content(answer: &Answer) -> Result<PageContent, PageError> {
    let mut bounds = bounds_table();
    bounds.row([
        "Net coefficient per slant length K = 2F/(γL²w)".into(),
        number(answer.lower),
        number(answer.upper),
    ])?;
    if let (Some(lower), Some(upper)) = (answer.force_lower_n, answer.force_upper_n) {
        bounds.row(["Force (N)".into(), number(lower), number(upper)])?;
    }
    for row in &answer.over_width {
        let name = row.width_ratio.map_or_else(
            || "K in plane strain, as if the plate had no ends".to_owned(),
            |ratio| format!("K of a plate {} times as wide as deep", number(ratio)),
        );
        bounds.row([name, number(row.lower), number(row.upper)])?;
    }
    let (kind, mut text) = proven(Some(answer.plane_strain.gap), answer.max_gap, answer.ended);
    if answer.width_ratio.is_some() {
        text = format!(
            "Both bounds are proven with interval arithmetic, the lower by {}, the upper by {}. They are {} % apart, in plane \
             strain {} %: the rest is what the ends may add.",
            answer.lower_proof.words(),
            answer.upper_proof.words(),
            number(round(100.0 * answer.gap)),
            number(round(100.0 * answer.plane_strain.gap)),
        );
    }
    let title = match (answer.force_lower_n, answer.force_upper_n) {
        (Some(lower), Some(upper)) => {
            format!("The force lies between {} and {} N", rounded_down(lower), rounded_up(upper))
        }
        _ => format!("K lies between {} and {}", rounded_down(answer.lower), rounded_up(answer.upper)),
    };
    Ok(PageContent {
        kind: "Bounds on a plate's force",
        subtitle: "An embedded plate is pushed through soil; what it bears just before the soil fails".into(),
        verdict: (kind, title, text),
        bounds,
        inputs: Vec::new(),
        given: given(&answer.inputs),
        steps: level_table(&answer.levels)?,
    })
}

fn given(i: &Inputs) -> Vec<(&'static str, String)> {
    let known = |value: Option<f64>, unit: &str| {
        value.map_or_else(|| "not given".into(), |value| format!("{} {unit}", number(value)))
    };
    vec![
        ("Tool angle α", format!("{}°", number(i.alpha_deg))),
        ("Slope of the surface β", format!("{}°", number(i.beta_deg))),
        ("Friction angle φ", format!("{}°", number(i.phi_deg))),
        ("Friction between soil and plate δ", format!("{}°", number(i.delta_deg))),
        ("Cohesion", format!("{} Pa", number(i.cohesion_pa))),
        ("Adhesion", format!("{} Pa", number(i.adhesion_pa))),
        ("Surcharge", format!("{} Pa", number(i.surcharge_pa))),
        ("Density", known(i.density_kg_m3, "kg/m³")),
        ("Gravity", format!("{} m/s²", number(i.gravity_m_s2))),
        ("Depth", known(i.depth_m, "m")),
        ("Width", known(i.width_m, "m")),
    ]
}
