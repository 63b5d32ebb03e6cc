//! What `shear` answers.

use schemars::JsonSchema;
use serde::Serialize;

use super::at::AngleAt;
use super::equivalent::StrokeAnswer;
use super::raw_answer::RawAnswer;

/// Friction angle against normal stress, soil by soil. Every angle outside the stresses of its curve is marked as
/// extrapolated.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The power laws are fitted to the loads below this normal stress.
    pub fit_limit_pa: f64,
    /// One entry a soil, in the order of the file.
    pub soils: Vec<SoilAnswer>,
    /// What the raw records show; only with raw records.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raw: Option<RawAnswer>,
    /// What to know about these numbers.
    pub warnings: Vec<String>,
}

/// The tests of one soil and the curves through them; a curve that cannot be fitted is null.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SoilAnswer {
    /// Name of the soil; null if it has none.
    pub soil: Option<String>,
    /// The tests, in increasing order of stress.
    pub points: Vec<Point>,
    /// `phi = a sigma^b`, sigma in psi, through the loads below `fit_limit_pa`.
    pub power_law: Option<PowerLaw>,
    /// A fall with the logarithm of stress down to a floor, through all loads. With raw records a load counts as often
    /// as runs were kept, here and in the constant.
    pub slope_floor: Option<SlopeFloor>,
    /// One angle for all loads, for comparison.
    pub constant: Option<Constant>,
    /// Which curve describes all loads best, in words; null if they are too few to compare.
    pub best: Option<String>,
    /// Angles at the stresses asked for, one entry a stress and curve.
    pub at: Vec<AngleAt>,
    /// Angles at the stresses of a plate's stroke; null if it was not asked for or no curve gives an answer.
    pub stroke: Option<StrokeAnswer>,
}

/// One test, or the mean of the tests at one load.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Point {
    /// Normal stress.
    pub normal_stress_pa: f64,
    /// Measured friction angle.
    pub friction_angle_deg: f64,
    /// Angle of the power law there, extrapolated or not; null without power law.
    pub power_law_deg: Option<f64>,
    /// Angle of slope and floor there; null without them.
    pub slope_floor_deg: Option<f64>,
}

/// `phi = a sigma^b` with phi in degrees and sigma in psi.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PowerLaw {
    /// Friction angle at 1 psi.
    pub a_deg_at_1_psi: f64,
    /// Exponent.
    pub b: f64,
    /// Standard error of ln a, which is the relative one of a; null with two loads.
    pub ln_a_standard_error: Option<f64>,
    /// Standard error of b; null with two loads.
    pub b_standard_error: Option<f64>,
    /// Number of points fitted.
    pub points: usize,
    /// Root mean square of the residuals.
    pub rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub stress_range_pa: [f64; 2],
}

/// `phi = floor + slope max(0, log10(floor stress / sigma))`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SlopeFloor {
    /// Friction angle at and above the floor stress.
    pub floor_deg: f64,
    /// Fall of the friction angle for each factor of ten in stress.
    pub slope_deg_per_decade: f64,
    /// Stress above which the angle is constant.
    pub floor_stress_pa: f64,
    /// Whether the tests settle the floor stress.
    pub floor_stress_settled: bool,
    /// Number of points fitted.
    pub points: usize,
    /// Root mean square of the residuals.
    pub rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub stress_range_pa: [f64; 2],
}

/// One angle for every stress.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Constant {
    /// The angle.
    pub friction_angle_deg: f64,
    /// Number of points fitted.
    pub points: usize,
    /// Root mean square of the residuals.
    pub rms_deg: f64,
    /// Residual of largest size, measured minus fitted.
    pub worst_residual_deg: f64,
    /// Lowest and highest fitted stress.
    pub stress_range_pa: [f64; 2],
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.shear/1";
}
