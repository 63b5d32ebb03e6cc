//! What is answered of a tool's ends.

use schemars::JsonSchema;
use serde::Serialize;

use super::Above;
use crate::bound::ProofKind;

/// A plate that stands for the tool in the upper bound: all of tool and side plates lie behind it, with soil that moves along, and it is as rough as the
/// soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct FrontAnswer {
    /// Its tool angle.
    pub alpha_deg: f64,
    /// Its vertical depth; more than the tool's where the tool's underside is flatter than the friction angle.
    pub depth_m: f64,
    /// Its width: that of the tool, and what soil beside it is dragged along.
    pub width_m: f64,
}

/// The bracket of a tool with ends.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct EndsAnswer {
    /// Width of the tool.
    pub width_m: f64,
    /// Whether it has side plates.
    pub side_plates: bool,
    /// Lower bound on the force of the whole tool (N).
    pub lower_n: f64,
    /// Upper bound on it (N).
    pub upper_n: f64,
    /// How the lower bound is proven.
    pub lower_proof: ProofKind,
    /// How the upper bound is proven.
    pub upper_proof: ProofKind,
    /// The plate that the blocks of the upper bound are of; null where that is the tool itself.
    pub front: Option<FrontAnswer>,
    /// Lower bound in plane strain, as without --width (N/m).
    pub plane_lower_n_per_m: f64,
    /// Upper bound in plane strain (N/m), which is none with ends.
    pub plane_upper_n_per_m: f64,
    /// The gap in plane strain, which --max-gap is about; null if the bounds are on both sides of zero.
    pub plane_gap: Option<f64>,
}

impl EndsAnswer {
    /// From bounds in plane strain (N/m), the lower of which holds for every width.
    pub(in crate::tool) fn new(
        above: &Above,
        width_m: f64,
        side_plates: bool,
        [plane_lower_n_per_m, plane_upper_n_per_m]: [f64; 2],
        plane_gap: Option<f64>,
    ) -> Self {
        let lower = plane_lower_n_per_m * width_m;
        let front = above.front.map(|front| FrontAnswer {
            alpha_deg: front.alpha_deg,
            depth_m: front.depth_m,
            width_m: front.width_m,
        });
        Self {
            width_m,
            side_plates,
            lower_n: lower - 2.0 * f64::EPSILON * lower.abs(),
            upper_n: above.upper_n,
            lower_proof: ProofKind::Splice,
            upper_proof: ProofKind::Mechanism,
            front,
            plane_lower_n_per_m,
            plane_upper_n_per_m,
            plane_gap,
        }
    }

    /// Both bounds per metre of the tool's width.
    pub(in crate::tool) fn per_metre(&self) -> [f64; 2] {
        let upper = self.upper_n / self.width_m;
        [self.plane_lower_n_per_m, upper + f64::EPSILON * upper.abs()]
    }

    /// Difference of the bounds over their mean; none if they are on both sides of zero.
    pub(in crate::tool) fn gap(&self) -> Option<f64> {
        let [lower, upper] = [self.lower_n, self.upper_n];
        (lower * upper > 0.0).then(|| (2.0 * (upper - lower) / (upper + lower)).abs())
    }
}
