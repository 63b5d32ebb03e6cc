//! What `bound` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::{Bounds, Ended, Factorisation, StoppedBy};

use super::Args;
use super::plate::Scaled;
use crate::output::Words;
use crate::text::number;
use crate::verbs::limits::{LevelAnswer, ResultsAnswer, level_table};

/// Proven bounds on the net force coefficient of an embedded plate.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BoundAnswer {
    /// Lower bound on the net coefficient per slant length, `2 F / (gamma L^2 w)`.
    pub(super) lower: f64,
    /// Upper bound on it.
    pub(super) upper: f64,
    /// `(U - L) / ((U + L) / 2)`.
    pub(super) gap: f64,
    /// Whether both bounds are proven with interval arithmetic.
    certified: bool,
    /// Triangles of the mesh of the lower bound; each has three parts.
    lower_elements: usize,
    /// Triangles of the mesh of the upper bound.
    upper_elements: usize,
    /// What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does not.
    lower_factorisation: Factorisation,
    /// The same of the upper bound.
    upper_factorisation: Factorisation,
    /// Work spent in element steps: elements of meshes times steps of the solver on them.
    work: u64,
    /// Time spent in s.
    seconds: f64,
    /// Lower bound on the force in N; null without depth, width or density.
    pub(super) force_lower_n: Option<f64>,
    /// Upper bound on the force in N; null likewise.
    pub(super) force_upper_n: Option<f64>,
    /// Why the run ended.
    pub(super) ended: Ended,
    /// What kind of limit that is. Only after `seconds` and `user` the same command may end elsewhere another time.
    stopped_by: StoppedBy,
    /// All levels, coarse to fine.
    pub(super) levels: Vec<LevelAnswer>,
    /// How far the moving soil reaches along the surface ahead of the plate's top; in the unit of `results`.
    wedge_ahead: f64,
    /// The same behind it.
    wedge_behind: f64,
    /// What the fields behind the bounds show: x along the surface from the plate's top, y across it.
    pub(super) results: ResultsAnswer,
    /// What was asked.
    pub(super) inputs: Inputs,
}

/// The inputs.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Inputs {
    /// Tool angle.
    pub(super) alpha_deg: f64,
    /// Surface slope.
    pub(super) beta_deg: f64,
    /// Friction angle of the soil.
    pub(super) phi_deg: f64,
    /// Interface friction angle.
    pub(super) delta_deg: f64,
    /// Cohesion.
    pub(super) cohesion_pa: f64,
    /// Adhesion.
    pub(super) adhesion_pa: f64,
    /// Surcharge.
    pub(super) surcharge_pa: f64,
    /// Bulk density; null if not given.
    pub(super) density_kg_m3: Option<f64>,
    /// Gravity.
    pub(super) gravity_m_s2: f64,
    /// Vertical depth of the lower edge; null if not given.
    pub(super) depth_m: Option<f64>,
    /// Width of the plate; null if not given.
    pub(super) width_m: Option<f64>,
}

impl BoundAnswer {
    pub(super) fn new(args: &Args, scaled: &Scaled, bounds: &Bounds, results: ResultsAnswer) -> Self {
        let [lower, upper] = scaled.coefficients(bounds);
        let coefficient = upper / bounds.upper.value;
        let levels = bounds.levels.iter().map(|level| LevelAnswer::new(level, coefficient)).collect();
        let newtons = scaled.newtons();
        Self {
            lower,
            upper,
            gap: bounds.gap(),
            certified: true,
            lower_elements: bounds.lower.elements,
            upper_elements: bounds.upper.elements,
            lower_factorisation: bounds.lower.factorisation,
            upper_factorisation: bounds.upper.factorisation,
            work: bounds.work,
            seconds: bounds.seconds,
            force_lower_n: newtons.map(|n| n * lower),
            force_upper_n: newtons.map(|n| n * upper),
            ended: bounds.ended,
            stopped_by: bounds.ended.stopped_by(),
            levels,
            wedge_ahead: results.reach(1.0),
            wedge_behind: results.reach(-1.0),
            results,
            inputs: Inputs {
                alpha_deg: args.alpha,
                beta_deg: args.loads.beta,
                phi_deg: args.phi,
                delta_deg: args.delta,
                cohesion_pa: args.loads.cohesion,
                adhesion_pa: args.loads.adhesion,
                surcharge_pa: args.loads.surcharge,
                density_kg_m3: args.density,
                gravity_m_s2: args.loads.gravity,
                depth_m: args.depth,
                width_m: args.width,
            },
        }
    }
}

impl soilctl_app::Answer for BoundAnswer {
    const SCHEMA: &'static str = "soilctl.bound/1";
}

impl Words for BoundAnswer {
    fn text(&self) -> String {
        let mut text = format!(
            "net coefficient per slant length, 2 F / (gamma L^2 w):\nlower  {}\nupper  {}\ngap    {} %\n",
            number(self.lower),
            number(self.upper),
            number(100.0 * self.gap)
        );
        if let (Some(lower), Some(upper)) = (self.force_lower_n, self.force_upper_n) {
            text += &format!("force  {} to {} N\n", number(lower), number(upper));
        }
        text += &format!("both bounds are proven; {:.1} s, {}\n\n", self.seconds, self.ended);
        text += &level_table(&self.levels);
        text += "\n";
        text + &self.results.text()
    }
}
