//! What `bound` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::{Bounds, Ended, Factorisation, StoppedBy};

use super::end::EndAnswer;
use super::ends::Brackets;
use super::{ProofKind, Request, ScaledPlate, WidthAnswer};
use crate::limits::{LevelAnswer, ResultsAnswer};
use crate::request::Ends;
use crate::{Outcome, plausible};

/// Proven bounds on the net force coefficient of an embedded plate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Lower bound on the net coefficient per slant length, `2 F / (gamma L^2 w)`.
    pub lower: f64,
    /// Upper bound on it.
    pub upper: f64,
    /// `(U - L) / ((U + L) / 2)`.
    pub gap: f64,
    /// Whether the plate has ends.
    pub ends: Ends,
    /// Width over vertical depth; null in plane strain.
    pub width_ratio: Option<f64>,
    /// How the lower bound is proven.
    pub lower_proof: ProofKind,
    /// How the upper bound is proven.
    pub upper_proof: ProofKind,
    /// The bracket in plane strain, which elements and levels are about.
    pub plane_strain: WidthAnswer,
    /// The same plate at other widths, narrow to wide, and plane strain last; empty if it has no ends.
    pub over_width: Vec<WidthAnswer>,
    /// The stress field in space about the plate's ends; null in plane strain.
    pub end: Option<EndAnswer>,
    /// Whether both bounds are proven with interval arithmetic.
    pub certified: bool,
    /// Triangles of the mesh of the lower bound; each has three parts.
    pub lower_elements: usize,
    /// Triangles of the mesh of the upper bound.
    pub upper_elements: usize,
    /// What factorised the solver's systems behind the lower bound; its digits may depend on that, its proof does not.
    pub lower_factorisation: Factorisation,
    /// The same of the upper bound.
    pub upper_factorisation: Factorisation,
    /// Work spent in element steps: elements of meshes times steps of the solver on them.
    pub work: u64,
    /// Time spent in s.
    pub seconds: f64,
    /// Lower bound on the force in N; null without depth, width or density.
    pub force_lower_n: Option<f64>,
    /// Upper bound on the force in N; null likewise.
    pub force_upper_n: Option<f64>,
    /// Why the run ended.
    pub ended: Ended,
    /// What kind of limit that is. Only after `seconds` and `user` the same command may end elsewhere another time.
    pub stopped_by: StoppedBy,
    /// All levels, coarse to fine.
    pub levels: Vec<LevelAnswer>,
    /// How far the moving soil reaches along the surface ahead of the plate's top; in the unit of `results`.
    pub wedge_ahead: f64,
    /// The same behind it.
    pub wedge_behind: f64,
    /// What the fields behind the bounds show: x along the surface from the plate's top, y across it.
    pub results: ResultsAnswer,
    /// What was asked.
    pub inputs: Inputs,
    /// Values of it that are possible but unusual, with what is usual and a likely cause.
    pub notes: Vec<String>,
    /// The gap asked for, which is about plane strain: more work narrows nothing else.
    #[serde(skip)]
    pub max_gap: f64,
}

/// The inputs.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Inputs {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Surface slope.
    pub beta_deg: f64,
    /// Friction angle of the soil.
    pub phi_deg: f64,
    /// How much it falls a decade of normal stress (deg); null if it is the same at all stresses.
    pub friction_law: Option<f64>,
    /// Normal stress at which it is `phi_deg` (Pa); null likewise.
    pub reference_stress_pa: Option<f64>,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Cohesion.
    pub cohesion_pa: f64,
    /// Adhesion.
    pub adhesion_pa: f64,
    /// Surcharge.
    pub surcharge_pa: f64,
    /// Bulk density; null if not given.
    pub density_kg_m3: Option<f64>,
    /// Gravity.
    pub gravity_m_s2: f64,
    /// Vertical depth of the lower edge; null if not given.
    pub depth_m: Option<f64>,
    /// Width of the plate; null if not given.
    pub width_m: Option<f64>,
}

impl Answer {
    pub(super) fn new(
        request: &Request,
        scaled: &ScaledPlate,
        bounds: &Bounds,
        (brackets, end): (Brackets, Option<EndAnswer>),
        results: ResultsAnswer,
    ) -> Self {
        let Brackets { own, plane: plane_strain, over_width } = brackets;
        let WidthAnswer { width_ratio, lower, upper, gap, lower_proof, upper_proof } = own;
        let coefficient = plane_strain.upper / bounds.upper.value;
        let levels = bounds.levels.iter().map(|level| LevelAnswer::new(level, coefficient)).collect();
        let newtons = scaled.newtons();
        let end_seconds = end.as_ref().map_or(0.0, |end| end.seconds);
        Self {
            lower,
            upper,
            gap,
            ends: if width_ratio.is_some() { Ends::Finite } else { Ends::None },
            width_ratio,
            lower_proof,
            upper_proof,
            plane_strain,
            over_width,
            end,
            certified: true,
            lower_elements: bounds.lower.elements,
            upper_elements: bounds.upper.elements,
            lower_factorisation: bounds.lower.factorisation,
            upper_factorisation: bounds.upper.factorisation,
            work: bounds.work,
            seconds: bounds.seconds + end_seconds,
            force_lower_n: newtons.map(|n| n * lower),
            force_upper_n: newtons.map(|n| n * upper),
            ended: bounds.ended,
            stopped_by: bounds.ended.stopped_by(),
            levels,
            wedge_ahead: results.reach(1.0),
            wedge_behind: results.reach(-1.0),
            results,
            inputs: Inputs {
                alpha_deg: request.alpha_deg,
                beta_deg: request.loads.beta_deg,
                phi_deg: request.phi_deg,
                friction_law: request.friction_law,
                reference_stress_pa: request.reference_stress_pa,
                delta_deg: request.delta_deg,
                cohesion_pa: request.loads.cohesion_pa,
                adhesion_pa: request.loads.adhesion_pa,
                surcharge_pa: request.loads.surcharge_pa,
                density_kg_m3: request.density_kg_m3,
                gravity_m_s2: request.loads.gravity_m_s2,
                depth_m: request.depth_m,
                width_m: request.width_m,
            },
            notes: plausible::of_plate(request),
            max_gap: request.budget.max_gap,
        }
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.bound/1";

    fn outcome(&self) -> Outcome {
        if self.plane_strain.gap <= self.max_gap { Outcome::Done } else { Outcome::Partial }
    }
}
