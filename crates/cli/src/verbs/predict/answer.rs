//! What `predict` answers, in data and in words.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::ValidRange;
use soilctl_soil::Provenance;

use crate::output::Answer;
use crate::text::{columns, number, number_or_dash};

/// Force and coefficients of a plate from a named model. Coefficients are null when a stroke table was given.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Prediction {
    /// Id of the model.
    pub(super) model: String,
    /// Passive coefficient per slant length, `2 F / (gamma L^2 w)`; null where a table has no split.
    pub(super) k_passive: Option<f64>,
    /// Active coefficient per slant length; null where a table has no split.
    pub(super) k_active: Option<f64>,
    /// Passive minus active, per slant length; for the bracket, the geometric mean of its ends.
    pub(super) k_net: Option<f64>,
    /// The same per vertical depth, `2 F / (gamma H^2 w)`.
    pub(super) k_net_depth: Option<f64>,
    /// Lower end of the bracket on `k_net`; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) k_net_lower: Option<f64>,
    /// Upper end of the bracket on `k_net`; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) k_net_upper: Option<f64>,
    /// Where the ends of the bracket come from; only for the model `table`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) k_net_provenance: Option<Ends>,
    /// Failure force in N with all loads; null without depth, width or density.
    pub(super) force_n: Option<f64>,
    /// Change of `k_net` in per cent when one angle grows by 1 deg and the others stay; null with a stroke table.
    pub(super) sensitivity_percent_per_deg: Option<Sensitivity>,
    /// What was asked.
    pub(super) inputs: Inputs,
    /// By how much, relatively, interpolation in a table may be wrong (the largest over the strokes); 0 for a
    /// formula or a solved cell.
    pub(super) interpolation_margin: f64,
    /// What to know about these numbers.
    pub(super) notes: Vec<String>,
    /// Where the model comes from.
    pub(super) reference: String,
    /// Angles for which the model answers.
    pub(super) valid_range: Range,
    /// One prediction a stroke; only with a stroke table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) strokes: Option<Vec<StrokePrediction>>,
}

/// Where the ends of a bracket come from.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Ends {
    /// The lower end.
    pub(super) lower: String,
    /// The upper end.
    pub(super) upper: String,
}

impl From<&Provenance> for Ends {
    fn from(provenance: &Provenance) -> Self {
        Self { lower: provenance.lower.clone(), upper: provenance.upper.clone() }
    }
}

/// Sensitivity to each angle; null where the model has no answer a degree further.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Sensitivity {
    /// To the tool angle.
    pub(super) alpha: Option<f64>,
    /// To the surface slope.
    pub(super) beta: Option<f64>,
    /// To the friction angle of the soil.
    pub(super) phi: Option<f64>,
    /// To the interface friction angle.
    pub(super) delta: Option<f64>,
}

/// The inputs of a prediction.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Inputs {
    /// Tool angle; null if it comes from the strokes.
    pub(super) alpha_deg: Option<f64>,
    /// Surface slope.
    pub(super) beta_deg: f64,
    /// Friction angle of the soil.
    pub(super) phi_deg: f64,
    /// Interface friction angle; null if it comes from the strokes.
    pub(super) delta_deg: Option<f64>,
    /// Cohesion.
    pub(super) cohesion_pa: f64,
    /// Adhesion.
    pub(super) adhesion_pa: f64,
    /// Surcharge.
    pub(super) surcharge_pa: f64,
    /// Bulk density; null if not given or if it comes from the strokes.
    pub(super) density_kg_m3: Option<f64>,
    /// Gravity.
    pub(super) gravity_m_s2: f64,
    /// Vertical depth of the lower edge; null if not given or if it comes from the strokes.
    pub(super) depth_m: Option<f64>,
    /// Width of the plate; null if not given or if it comes from the strokes.
    pub(super) width_m: Option<f64>,
}

/// Angles for which a model answers, lowest and highest, in degrees. Interface friction is at most the friction of
/// the soil as well.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Range {
    /// Tool angle.
    pub(super) alpha_deg: [f64; 2],
    /// Surface slope.
    pub(super) beta_deg: [f64; 2],
    /// Friction angle of the soil.
    pub(super) phi_deg: [f64; 2],
    /// Interface friction angle.
    pub(super) delta_deg: [f64; 2],
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
pub(crate) struct StrokePrediction {
    /// Line in the file.
    pub(super) line: usize,
    /// Name of the stroke.
    pub(super) stroke_id: Option<String>,
    /// Tool angle.
    pub(super) alpha_deg: f64,
    /// Vertical depth of the lower edge.
    pub(super) depth_m: f64,
    /// Net coefficient per slant length.
    pub(super) k_net: f64,
    /// Predicted force; null without density.
    pub(super) force_n: Option<f64>,
    /// Measured force.
    pub(super) measured_n: f64,
    /// Predicted over measured force; null without density.
    pub(super) ratio: Option<f64>,
}

impl Answer for Prediction {
    const SCHEMA: &'static str = "soilctl.predict/1";

    fn text(&self) -> String {
        let mut text = format!("{}: {}\n", self.model, self.reference);
        match &self.strokes {
            Some(strokes) => text += &strokes_text(strokes),
            None => text += &self.coefficients_text(),
        }
        if self.interpolation_margin > 0.0 {
            let per_cent = number(100.0 * self.interpolation_margin);
            text += &format!("interpolation may be off by up to {per_cent} %\n");
        }
        for note in &self.notes {
            text += &format!("note: {note}\n");
        }
        text
    }
}

impl Prediction {
    fn coefficients_text(&self) -> String {
        let mut text = String::new();
        let mut line = |key: &str, value: String, meaning: &str| {
            text += format!("{key:<12} {value:<12} {meaning}").trim_end();
            text += "\n";
        };
        let value = number_or_dash;
        line("k_passive", value(self.k_passive), "");
        line("k_active", value(self.k_active), "");
        line("k_net", value(self.k_net), "passive minus active, per slant length: 2 F / (gamma L^2 w)");
        if self.k_net_lower.is_some() {
            line("k_net_lower", value(self.k_net_lower), "lower end of the bracket");
            line("k_net_upper", value(self.k_net_upper), "upper end of the bracket");
        }
        line("k_net_depth", value(self.k_net_depth), "the same per depth: 2 F / (gamma H^2 w)");
        if let Some(s) = &self.sensitivity_percent_per_deg {
            for (key, change) in
                [("d_alpha", s.alpha), ("d_beta", s.beta), ("d_phi", s.phi), ("d_delta", s.delta)]
            {
                line(key, value(change), "% of k_net for one degree more");
            }
        }
        match self.force_n {
            Some(force) => line("force_n", number(force), "N, with all loads"),
            None => line("force_n", "-".into(), "needs --depth, --width and --density"),
        }
        text
    }
}

fn strokes_text(strokes: &[StrokePrediction]) -> String {
    let header = ["line", "stroke_id", "alpha_deg", "depth_m", "k_net", "force_n", "measured_n", "ratio"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    rows.extend(strokes.iter().map(|stroke| {
        vec![
            stroke.line.to_string(),
            stroke.stroke_id.clone().unwrap_or_else(|| "-".into()),
            number(stroke.alpha_deg),
            number(stroke.depth_m),
            number(stroke.k_net),
            number_or_dash(stroke.force_n),
            number(stroke.measured_n),
            number_or_dash(stroke.ratio),
        ]
    }));
    columns(&rows)
}
