//! What `shear` answers.

use schemars::JsonSchema;
use serde::Serialize;

use super::at::AngleAt;
use super::equivalent::StrokeAnswer;
use super::raw_answer::RawAnswer;
use super::words::text;
use crate::output::Answer;

/// Friction angle against normal stress, soil by soil. Every angle outside the stresses of its curve is marked as
/// extrapolated.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ShearAnswer {
    /// The power laws are fitted to the loads below this normal stress.
    pub(super) fit_limit_pa: f64,
    /// One entry a soil, in the order of the file.
    pub(super) soils: Vec<SoilAnswer>,
    /// What the raw records show; only with raw records.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) raw: Option<RawAnswer>,
    /// What to know about these numbers.
    pub(super) warnings: Vec<String>,
}

/// The tests of one soil and the curves through them; a curve that cannot be fitted is null.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SoilAnswer {
    /// Name of the soil; null if it has none.
    pub(super) soil: Option<String>,
    /// The tests, in increasing order of stress.
    pub(super) points: Vec<Point>,
    /// `phi = a sigma^b`, sigma in psi, through the loads below `fit_limit_pa`.
    pub(super) power_law: Option<PowerLaw>,
    /// A fall with the logarithm of stress down to a floor, through all loads. With raw records a load counts as often
    /// as runs were kept, here and in the constant.
    pub(super) slope_floor: Option<SlopeFloor>,
    /// One angle for all loads, for comparison.
    pub(super) constant: Option<Constant>,
    /// Which curve describes all loads best, in words; null if they are too few to compare.
    pub(super) best: Option<String>,
    /// Angles at the stresses asked for, one entry a stress and curve.
    pub(super) at: Vec<AngleAt>,
    /// Angles at the stresses of a plate's stroke; null if it was not asked for or no curve gives an answer.
    pub(super) stroke: Option<StrokeAnswer>,
}

/// One test, or the mean of the tests at one load.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Point {
    /// Normal stress.
    pub(super) normal_stress_pa: f64,
    /// Measured friction angle.
    pub(super) friction_angle_deg: f64,
    /// Angle of the power law there, extrapolated or not; null without power law.
    pub(super) power_law_deg: Option<f64>,
    /// Angle of slope and floor there; null without them.
    pub(super) slope_floor_deg: Option<f64>,
}

/// `phi = a sigma^b` with phi in degrees and sigma in psi.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct PowerLaw {
    /// Friction angle at 1 psi.
    pub(super) a_deg_at_1_psi: f64,
    /// Exponent.
    pub(super) b: f64,
    /// Standard error of ln a, which is the relative one of a; null with two loads.
    pub(super) ln_a_standard_error: Option<f64>,
    /// Standard error of b; null with two loads.
    pub(super) b_standard_error: Option<f64>,
    /// Number of points fitted.
    pub(super) points: usize,
    /// Root mean square of the residuals.
    pub(super) rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub(super) worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub(super) stress_range_pa: [f64; 2],
}

/// `phi = floor + slope max(0, log10(floor stress / sigma))`.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SlopeFloor {
    /// Friction angle at and above the floor stress.
    pub(super) floor_deg: f64,
    /// Fall of the friction angle for each factor of ten in stress.
    pub(super) slope_deg_per_decade: f64,
    /// Stress above which the angle is constant.
    pub(super) floor_stress_pa: f64,
    /// Whether the tests settle the floor stress.
    pub(super) floor_stress_settled: bool,
    /// Number of points fitted.
    pub(super) points: usize,
    /// Root mean square of the residuals.
    pub(super) rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub(super) worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub(super) stress_range_pa: [f64; 2],
}

/// One angle for every stress.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Constant {
    /// The angle.
    pub(super) friction_angle_deg: f64,
    /// Number of points fitted.
    pub(super) points: usize,
    /// Root mean square of the residuals.
    pub(super) rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub(super) worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub(super) stress_range_pa: [f64; 2],
}

impl Answer for ShearAnswer {
    const SCHEMA: &'static str = "soilctl.shear/1";

    fn text(&self) -> String {
        text(self)
    }
}
