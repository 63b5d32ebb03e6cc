//! What the page of a plate tells.

use super::BoundAnswer;
use crate::error::CliError;
use crate::text::{number, rounded_down, rounded_up};
use crate::verbs::limits::{Told, bounds_table, level_page_table, proven};

impl BoundAnswer {
    pub(super) fn told(&self, max_gap: f64) -> Result<Told, CliError> {
        let mut bounds = bounds_table();
        bounds.row([
            "Net coefficient per slant length K = 2F/(γL²w)".into(),
            number(self.lower),
            number(self.upper),
        ])?;
        if let (Some(lower), Some(upper)) = (self.force_lower_n, self.force_upper_n) {
            bounds.row(["Force (N)".into(), number(lower), number(upper)])?;
        }
        let (kind, text) = proven(Some(self.gap), max_gap, self.ended);
        let title = match (self.force_lower_n, self.force_upper_n) {
            (Some(lower), Some(upper)) => {
                format!("The force lies between {} and {} N", rounded_down(lower), rounded_up(upper))
            }
            _ => format!("K lies between {} and {}", rounded_down(self.lower), rounded_up(self.upper)),
        };
        Ok(Told {
            kind: "Bounds on a plate's force",
            subtitle: "An embedded plate is pushed through soil; what it bears just before the soil fails"
                .into(),
            verdict: (kind, title, text),
            bounds,
            given: self.given(),
            steps: level_page_table(&self.levels)?,
        })
    }

    fn given(&self) -> Vec<(&'static str, String)> {
        let i = &self.inputs;
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
}
