//! What `shear` answers.

use schemars::JsonSchema;
use serde::Serialize;

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

/// The friction angle that a curve gives at a normal stress.
#[derive(Debug, Serialize, JsonSchema)]
pub struct AngleAt {
    /// The normal stress asked for.
    pub normal_stress_pa: f64,
    /// The angle there.
    pub friction_angle_deg: f64,
    /// Whether the stress lies outside those that the curve was fitted to.
    pub extrapolated: bool,
    /// `power law` or `slope and floor`; `constant angle` if neither could be fitted.
    pub curve: String,
    /// Standard error of predicting one further test there from the scatter about the curve; null where there is no
    /// theory for it. Extrapolated, the true error is larger.
    pub standard_error_deg: Option<f64>,
}

/// Friction angles at the normal stresses of a stroke (Hong 2001, section 6.6.1).
#[derive(Debug, Serialize, JsonSchema)]
pub struct StrokeAnswer {
    /// The stroke.
    pub inputs: Inputs,
    /// One entry a point beside the plate and curve.
    pub points: Vec<StrokePoint>,
    /// What happens to the angles at another stress; only with such a stress.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub carried: Option<Vec<Carried>>,
}

/// A stroke of a plate in a level, cohesionless soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Inputs {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Vertical depth of the lower edge.
    pub depth_m: f64,
    /// Width of the plate.
    pub width_m: f64,
    /// Bulk density.
    pub density_kg_m3: f64,
    /// Gravity.
    pub gravity_m_s2: f64,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Failure force.
    pub force_n: f64,
    /// Friction angle that the stresses were computed with; null if angle and stress were made consistent.
    pub phi_deg: Option<f64>,
}

/// Stresses and angles at one point beside the plate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StrokePoint {
    /// Depth of the point as a fraction of the plate's depth.
    pub point_fraction: f64,
    /// Depth of the point.
    pub point_depth_m: f64,
    /// Pressure of the plate at that depth, along the resultant.
    pub plate_pressure_pa: f64,
    /// The curve that the angles are read from.
    pub curve: String,
    /// `sigma_L`: normal stress on the failure surface far from the plate.
    pub low_stress_pa: f64,
    /// `sigma_U`: normal stress on the failure surface beside the plate.
    pub high_stress_pa: f64,
    /// Friction angle at `sigma_L`.
    pub friction_at_low_stress_deg: f64,
    /// Friction angle at `sigma_U`.
    pub friction_at_high_stress_deg: f64,
    /// Whether `sigma_L` lies outside the stresses of the curve.
    pub low_extrapolated: bool,
    /// Whether `sigma_U` lies outside the stresses of the curve.
    pub high_extrapolated: bool,
    /// Iterations until angle and stress agreed; 0 with a given angle.
    pub iterations: usize,
    /// What to keep in mind with these numbers.
    pub note: String,
}

/// The shift of the friction angle from a stress of the stroke to another one (Hong 2001, section 6.7.3).
#[derive(Debug, Serialize, JsonSchema)]
pub struct Carried {
    /// Depth of the point as a fraction of the plate's depth.
    pub point_fraction: f64,
    /// `sigma_L` or `sigma_U`.
    pub from: String,
    /// The curve: the one with a floor if it could be fitted, because a power law falls for ever.
    pub curve: String,
    /// Stress of the stroke.
    pub measured_stress_pa: f64,
    /// Stress at which the angle is to be used.
    pub used_stress_pa: f64,
    /// To be added to the angle of the stroke.
    pub shift_deg: f64,
    /// Whether the stress of the stroke lies outside those of the curve.
    pub measured_extrapolated: bool,
    /// Whether the stress of use lies outside those of the curve.
    pub used_extrapolated: bool,
    /// The same in words.
    pub warning: String,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.shear/1";
}
