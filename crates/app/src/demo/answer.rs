//! What a demonstration answers.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Outcome;

/// The estimate with the density unknown.
pub(super) const DENSITY_UNKNOWN: &str = "density unknown";
/// The one with the density that was weighed.
pub(super) const DENSITY_WEIGHED: &str = "density weighed";
/// The one from the true forces.
pub const TRUE_FORCES: &str = "true forces";

/// A simulated campaign from the soil to the estimate, and how far that is from the truth.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Name of the soil.
    pub soil: String,
    /// The soil in words.
    pub title: String,
    /// Force model of the simulated soil and of the estimate.
    pub model: String,
    /// Seed of noise and scatter.
    pub seed: u64,
    /// Whether everything ran to its end; otherwise the same command goes on.
    pub complete: bool,
    /// What was found, beside the truth, in words; empty if the work was stopped.
    pub found: String,
    /// What is true of the soil. Only comparisons use it.
    pub truth: Truth,
    /// What became of the strokes.
    pub strokes: StrokeCount,
    /// Published interface friction (deg), around which the set-points lie. The estimate from the sweep does not use it.
    pub delta_guess_deg: f64,
    /// Interface friction from the sweep; null if there is none.
    pub delta: Option<Delta>,
    /// Why there is none, or why it does not count; null if it does.
    pub no_delta: Option<String>,
    /// Interval of the interface friction (deg): from the sweep if it tells, else around the published one; null if there is no
    /// estimate. The estimate takes the inclination of each stroke's force at failure, up to the end of the interval.
    pub delta_used_deg: Option<[f64; 2]>,
    /// Friction angle and density from the forces, nothing known of the density; null if there is no estimate.
    pub density_unknown: Option<Region>,
    /// The same with the density that was weighed; null if there is no estimate.
    pub density_weighed: Option<Region>,
    /// The estimate that the same strokes would give with the forces and depths that are true and the density unknown: what is
    /// lost by reading them from the logs; null if there is none.
    pub true_forces: Option<Region>,
    /// Why there is no estimate.
    pub no_estimate: Option<String>,
    /// Failure forces against the truth; null without a stroke to compare.
    pub forces: Option<Forces>,
    /// Every stroke of the plan.
    pub each: Vec<EachStroke>,
    /// What was not recovered, in words; empty if everything was.
    pub not_recovered: Vec<String>,
    /// Where everything is.
    pub files: Files,
}

/// What is true of the soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Truth {
    /// Friction angle (deg).
    pub phi_deg: f64,
    /// Friction angle between soil and plate (deg).
    pub delta_deg: f64,
    /// Bulk density (kg/m3).
    pub density_kg_m3: f64,
    /// Cohesion (Pa); the estimate takes it as known.
    pub cohesion_pa: f64,
    /// Gravity (m/s2); the estimate takes it as known.
    pub gravity_m_s2: f64,
    /// Part of what the plate's ends add at most, by the proven bounds, that they add; 0 in plane strain.
    pub end_factor: f64,
}

/// How many strokes there are.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct StrokeCount {
    /// In the plan.
    pub asked: usize,
    /// Made by the arm to their end.
    pub made: usize,
    /// With a failure force.
    pub with_force: usize,
    /// Used for the interface friction.
    pub used_for_delta: usize,
    /// Used for friction angle and density.
    pub used_for_phi: usize,
}

/// Interface friction from the sweep of set-points.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Delta {
    /// Estimate (deg).
    pub delta_deg: f64,
    /// Its standard deviation (deg).
    pub sd_deg: f64,
    /// Two standard deviations on either side, at least 1 (deg).
    pub interval_deg: [f64; 2],
    /// Highest set-point with a significant lift (deg).
    pub above_deg: Option<f64>,
    /// Lowest set-point above that without one (deg).
    pub below_deg: Option<f64>,
    /// Estimate minus truth (deg).
    pub error_deg: f64,
    /// Whether the truth lies in the interval.
    pub holds_truth: bool,
    /// Whether the sweep tells: a set-point lifts significantly, and the standard deviation is at most 2 deg.
    pub determined: bool,
}

/// Every soil that explains the forces.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Region {
    /// Whether any soil does.
    pub consistent: bool,
    /// Probability with which all bands together hold their true forces.
    pub confidence: Option<f64>,
    /// Range of the friction angle (deg); null if inconsistent.
    pub phi_deg: Option<[f64; 2]>,
    /// Range of the density (kg/m3); null if inconsistent.
    pub density_kg_m3: Option<[f64; 2]>,
    /// What was known of the density (kg/m3).
    pub density_known_kg_m3: Option<[f64; 2]>,
    /// Whether the true friction angle lies in its range.
    pub phi_holds_truth: bool,
    /// Whether the true density lies in its range.
    pub density_holds_truth: bool,
    /// Whether true friction angle and density together lie in the region.
    pub holds_truth: bool,
    /// The result in words.
    pub verdict: String,
}

/// Failure forces against the truth.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Forces {
    /// Strokes that were compared.
    pub compared: usize,
    /// Median of the relative errors' sizes.
    pub median_error: f64,
    /// Their 95th percentile.
    pub percentile_95_error: f64,
    /// Share of the strokes that are within 10 %.
    pub share_within_10_percent: f64,
    /// Median of the relative errors with their sign.
    pub median_signed_error: f64,
    /// Share of the errors that are within one stated standard deviation; 0.68 if they are calibrated.
    pub share_within_one_sd: f64,
}

/// A stroke of the plan.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct EachStroke {
    /// Number in the plan, from 1.
    pub number: usize,
    /// Preparation, from 1.
    pub batch: usize,
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Depth that was wanted (m).
    pub depth_m: f64,
    /// Set-point of the interface friction (deg).
    pub delta_set_deg: f64,
    /// Its name in the stroke table; null if it has no failure force.
    pub stroke_id: Option<String>,
    /// Failure force that was found (N).
    pub force_n: Option<f64>,
    /// Its standard deviation (N).
    pub force_sd_n: Option<f64>,
    /// Force of the soil when it failed in truth (N); null if it did not fail.
    pub true_force_n: Option<f64>,
    /// The most that the soil bore where and when the failure was found (N).
    pub limit_force_n: Option<f64>,
    /// The force that was found over that, minus 1.
    pub error: Option<f64>,
    /// Depth that was measured (m).
    pub measured_depth_m: Option<f64>,
    /// Depth at which the soil failed in truth (m).
    pub true_depth_m: Option<f64>,
    /// Whether it was used for the interface friction.
    pub used_for_delta: bool,
    /// Whether it was used for friction angle and density.
    pub used_for_phi: bool,
    /// Why it has no failure force; null if it has one.
    pub why_none: Option<String>,
    /// Its name in the traces, for the figure.
    #[serde(skip)]
    pub trace_id: Option<String>,
    /// When the failure was found, on the log's clock in s.
    #[serde(skip)]
    pub found_at_s: Option<f64>,
    /// When the soil failed in truth.
    #[serde(skip)]
    pub true_at_s: Option<f64>,
}

/// Where everything is.
#[derive(Debug, Clone, Default, Serialize, JsonSchema)]
pub struct Files {
    /// The folder.
    pub folder: String,
    /// The campaign plan.
    pub plan: String,
    /// The logs.
    pub logs: Vec<String>,
    /// The stroke table; null without a failure force.
    pub strokes: Option<String>,
    /// What of it the estimate used, with its error budget; null without an estimate.
    pub measurements: Option<String>,
    /// The estimates in JSON.
    pub estimates: Vec<String>,
    /// The figures.
    pub figures: Vec<String>,
    /// The page; null if the work was stopped before it.
    pub report: Option<String>,
}

impl Answer {
    /// The regions with their names, as far as there are.
    pub fn regions(&self) -> impl Iterator<Item = (&'static str, &Region)> {
        let named = [
            (DENSITY_UNKNOWN, &self.density_unknown),
            (DENSITY_WEIGHED, &self.density_weighed),
            (TRUE_FORCES, &self.true_forces),
        ];
        named.into_iter().filter_map(|(name, region)| Some((name, region.as_ref()?)))
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.demo/1";

    fn outcome(&self) -> Outcome {
        let consistent = self.density_unknown.as_ref().is_some_and(|region| region.consistent);
        if self.complete && !consistent {
            Outcome::Negative
        } else if !self.complete || self.strokes.made < self.strokes.asked {
            Outcome::Partial
        } else {
            Outcome::Done
        }
    }
}
