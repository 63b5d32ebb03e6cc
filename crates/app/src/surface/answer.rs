//! What a failure surface says, as plain data.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_estimator::Ring;

use super::extent::Surface;
use crate::Outcome;
use crate::estimate::Estimation;

/// Whether the surface and the forces speak of one soil, by a model of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Agreement {
    /// Some friction angle explains both.
    Agrees,
    /// The ground breaks nearer to the plate than for any soil that explains the forces.
    Nearer,
    /// It breaks farther away.
    Farther,
    /// No friction angle explains all break distances together.
    NoFriction,
    /// No soil explains the forces, so there is nothing to hold the surface against.
    NoForce,
}

/// What a model of the surface says.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Said {
    /// The model.
    pub surface: Surface,
    /// Friction angles (deg) that explain all break distances; null if none does.
    pub phi_deg: Option<[f64; 2]>,
    /// Whether forces agree.
    pub agreement: Agreement,
    /// Friction angles (deg) that explain forces and break distances; null if there are none.
    pub phi_both_deg: Option<[f64; 2]>,
    /// Densities (kg/m3) that forces leave for these; null if there are none.
    pub density_both_kg_m3: Option<[f64; 2]>,
}

/// What forces say.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ByForce {
    /// Force model.
    pub model: String,
    /// Range of the friction angle (deg); null if no soil explains the forces.
    pub phi_deg: Option<[f64; 2]>,
    /// Range of the density (kg/m3); null if no soil explains the forces.
    pub density_kg_m3: Option<[f64; 2]>,
}

impl ByForce {
    pub(super) fn of(found: &Estimation) -> Self {
        let answer = &found.answer;
        Self { model: answer.model.clone(), phi_deg: answer.phi_deg, density_kg_m3: answer.density_kg_m3 }
    }
}

/// A stroke with a break distance.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Stroke {
    /// Its line in the table.
    pub line: usize,
    /// Its name, tool angle and depth.
    pub label: String,
    /// Measured distance (m) along the surface, from the plate's face to where the ground broke.
    pub distance_m: f64,
    /// Its standard deviation (m).
    pub sd_m: f64,
    /// What each of `models` predicts (m), from least to most, for the friction angles that forces leave, or if they leave none, that the
    /// surface leaves; null where the model has no answer.
    pub predicted_m: Vec<Option<[f64; 2]>>,
}

/// The answer.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// Probability with which all bands of break distances together hold their true values; null for bounds.
    pub confidence: Option<f64>,
    /// Standard deviations that a band reaches on either side.
    pub deviations: f64,
    /// What is known of the friction on the plate (deg).
    pub delta_deg: [f64; 2],
    /// What forces say.
    pub force: ByForce,
    /// Strokes with a break distance.
    pub strokes: Vec<Stroke>,
    /// How many strokes have none.
    pub not_measured: usize,
    /// What models of the surface say.
    pub models: Vec<Said>,
    /// The result in words.
    pub verdict: String,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.surface/1";

    /// Negative if by no model forces and surface speak of one soil.
    fn outcome(&self) -> Outcome {
        let agrees = self.models.iter().any(|said| said.agreement == Agreement::Agrees);
        if agrees { Outcome::Done } else { Outcome::Negative }
    }
}

/// Least and greatest density of a region of [phi, density] between two friction angles.
pub(super) fn densities(region: &[Vec<Ring>], phi_deg: [f64; 2]) -> Option<[f64; 2]> {
    let mut hull: Option<[f64; 2]> = None;
    let mut take = |y: f64| hull = Some(hull.map_or([y, y], |[low, high]| [low.min(y), high.max(y)]));
    for ring in region.iter().flatten() {
        for (i, a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            if (phi_deg[0]..=phi_deg[1]).contains(&a[0]) {
                take(a[1]);
            }
            for phi in phi_deg {
                if (a[0] < phi) != (b[0] < phi) {
                    take(a[1] + (phi - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
                }
            }
        }
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_strip_of_a_triangle() {
        let region = vec![vec![vec![[30.0, 1000.0], [40.0, 1000.0], [40.0, 2000.0]]]];
        assert_eq!(densities(&region, [32.0, 35.0]), Some([1000.0, 1500.0]));
        assert_eq!(densities(&region, [20.0, 25.0]), None);
    }
}
