//! What `predict` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::ValidRange;
use soilctl_soil::Provenance;

use super::law::LawPrediction;
use crate::request::Ends;

/// Force and coefficients of a plate from a named model. Coefficients are null when a stroke table was given.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Id of the model.
    pub model: String,
    /// Passive coefficient per slant length, `2 F / (gamma L^2 w)`; null where a table has no split.
    pub k_passive: Option<f64>,
    /// Active coefficient per slant length; null where a table has no split.
    pub k_active: Option<f64>,
    /// Passive minus active, per slant length; for the bracket, the geometric mean of its ends.
    pub k_net: Option<f64>,
    /// The same per vertical depth, `2 F / (gamma H^2 w)`.
    pub k_net_depth: Option<f64>,
    /// Lower end of the bracket on `k_net`; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k_net_lower: Option<f64>,
    /// Upper end of the bracket on `k_net`; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k_net_upper: Option<f64>,
    /// Where the ends of the bracket come from; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub k_net_provenance: Option<BracketEnds>,
    /// Whether the plate has ends.
    pub ends: Ends,
    /// Width over vertical depth; null in plane strain and where it comes from the strokes.
    pub width_ratio: Option<f64>,
    /// Failure force in N with all loads; null without depth, width or density.
    pub force_n: Option<f64>,
    /// What a law of stress makes of it; null without one.
    pub friction_law: Option<LawPrediction>,
    /// Change of `k_net` in per cent when one angle grows by 1 deg and the others stay; null with a stroke table.
    pub sensitivity_percent_per_deg: Option<Sensitivity>,
    /// What was asked.
    pub inputs: Inputs,
    /// By how much, relatively, interpolation in a table may be wrong (the largest over the strokes); 0 for a
    /// formula or a solved cell.
    pub interpolation_margin: f64,
    /// What to know about these numbers.
    pub notes: Vec<String>,
    /// Where the model comes from.
    pub reference: String,
    /// Angles for which the model answers.
    pub valid_range: Range,
    /// One prediction a stroke; only with a stroke table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strokes: Option<Vec<StrokePrediction>>,
}

/// Where the ends of a bracket come from.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BracketEnds {
    /// The lower end.
    pub lower: String,
    /// The upper end.
    pub upper: String,
}

impl From<&Provenance> for BracketEnds {
    fn from(provenance: &Provenance) -> Self {
        Self { lower: provenance.lower.clone(), upper: provenance.upper.clone() }
    }
}

/// Sensitivity to each angle; null where the model has no answer a degree further.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Sensitivity {
    /// To the tool angle.
    pub alpha: Option<f64>,
    /// To the surface slope.
    pub beta: Option<f64>,
    /// To the friction angle of the soil.
    pub phi: Option<f64>,
    /// To the interface friction angle.
    pub delta: Option<f64>,
}

/// The inputs of a prediction.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Inputs {
    /// Tool angle; null if it comes from the strokes.
    pub alpha_deg: Option<f64>,
    /// Surface slope.
    pub beta_deg: f64,
    /// Friction angle of the soil.
    pub phi_deg: f64,
    /// Interface friction angle; null if it comes from the strokes.
    pub delta_deg: Option<f64>,
    /// Cohesion.
    pub cohesion_pa: f64,
    /// Adhesion.
    pub adhesion_pa: f64,
    /// Surcharge.
    pub surcharge_pa: f64,
    /// Bulk density; null if not given or if it comes from the strokes.
    pub density_kg_m3: Option<f64>,
    /// Gravity.
    pub gravity_m_s2: f64,
    /// Vertical depth of the lower edge; null if not given or if it comes from the strokes.
    pub depth_m: Option<f64>,
    /// Width of the plate; null if not given or if it comes from the strokes.
    pub width_m: Option<f64>,
}

/// Angles for which a model answers, lowest and highest, in degrees. Interface friction is at most the friction of
/// the soil as well.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Range {
    /// Tool angle.
    pub alpha_deg: [f64; 2],
    /// Surface slope.
    pub beta_deg: [f64; 2],
    /// Friction angle of the soil.
    pub phi_deg: [f64; 2],
    /// Interface friction angle.
    pub delta_deg: [f64; 2],
}

impl From<ValidRange> for Range {
    fn from(range: ValidRange) -> Self {
        Self {
            alpha_deg: range.alpha_deg.into(),
            beta_deg: range.beta_deg.into(),
            phi_deg: range.phi_deg.into(),
            delta_deg: range.delta_deg.into(),
        }
    }
}

/// The prediction of one stroke.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StrokePrediction {
    /// Line in the file.
    pub line: usize,
    /// Name of the stroke.
    pub stroke_id: Option<String>,
    /// Tool angle.
    pub alpha_deg: f64,
    /// Vertical depth of the lower edge.
    pub depth_m: f64,
    /// Net coefficient per slant length.
    pub k_net: f64,
    /// Predicted force; null without density.
    pub force_n: Option<f64>,
    /// Measured force.
    pub measured_n: f64,
    /// Predicted over measured force; null without density.
    pub ratio: Option<f64>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.predict/1";
}
