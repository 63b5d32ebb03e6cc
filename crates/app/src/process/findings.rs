//! What the strokes say together, as the answer tells it.

use schemars::JsonSchema;
use serde::Serialize;

/// What the strokes say together.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Analysis {
    /// Interface friction by the lift at failure; null without a sweep.
    pub friction: Option<Friction>,
    /// Why there is none.
    pub no_friction: Option<String>,
    /// The check by rubbing; null without such a log.
    pub rubbing: Option<Rubbing>,
    /// Force as a power of depth, for each tool angle with several depths.
    pub depth_laws: Vec<Law>,
    /// Slant length to which forces are scaled in m.
    pub slant_m: f64,
    /// Forces by tool angle, at that slant length.
    pub groups: Vec<Group>,
    /// Whether forces depend on the radius; null if it does not vary.
    pub radius: Option<Effect>,
    /// Whether forces depend on the base angle; null if it does not vary.
    pub base_angle: Option<Effect>,
    /// What the model's forces were compared for; null without --density.
    pub comparison: Option<Comparison>,
}

/// Interface friction by a sweep of set-points.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Friction {
    /// Estimate in deg.
    pub delta_deg: f64,
    /// Its standard deviation in deg.
    pub sd_deg: f64,
    /// Highest set-point with a significant lift; friction is above it.
    pub above_deg: Option<f64>,
    /// Lowest set-point above that without one; friction is below it.
    pub below_deg: Option<f64>,
    /// Lift for each degree that the set-point is too low.
    pub lift_per_deg: f64,
    /// Strokes at 80 to 90 deg, which count.
    pub strokes: Vec<Lift>,
    /// Strokes at other tool angles, or without a measured lift.
    pub left_out: Vec<String>,
}

/// Lift at failure of one stroke.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Lift {
    /// Name of the stroke.
    pub stroke_id: String,
    /// Set-point of the interface friction in deg.
    pub set_deg: f64,
    /// Lift in deg.
    pub lift_deg: f64,
    /// Its standard deviation in deg.
    pub lift_sd_deg: f64,
    /// Lift over its standard deviation.
    pub significance: f64,
}

/// The check by rubbing a sand-covered plate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Rubbing {
    /// Median of the peaks of the friction angle in deg.
    pub peak_deg: f64,
    /// Range that holds two thirds of the peaks in deg.
    pub range_deg: [f64; 2],
    /// How many peaks.
    pub peaks: usize,
    /// Time in s and friction angle in deg, for the figure.
    #[serde(skip)]
    pub course: Vec<(f64, f64)>,
}

/// Force as a power of depth.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Law {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Strokes.
    pub strokes: usize,
    /// The power; 2 in soil without cohesion.
    pub exponent: f64,
    /// Ends of its 95 % confidence interval.
    pub exponent_95: [f64; 2],
    /// F/H^2 of the fit through zero in N/m2.
    pub quadratic_n_per_m2: f64,
    /// Whether the interval holds 2.
    pub agrees_with_square: bool,
}

/// Forces at one tool angle.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Group {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Strokes, outliers included.
    pub strokes: usize,
    /// Mean without outliers in N.
    pub mean_n: f64,
    /// Standard deviation without outliers in N; null of one stroke.
    pub sd_n: Option<f64>,
    /// Standard deviation over mean.
    pub coefficient_of_variation: Option<f64>,
    /// Strokes that do not belong (generalised extreme Studentised deviate test, 5 %).
    pub outliers: Vec<String>,
    /// Force of the model for the given friction angle in N.
    pub model_n: Option<f64>,
    /// Mean over that force, minus 1.
    pub model_difference: Option<f64>,
    /// Friction angle at which the model gives the mean in deg; null if none does.
    pub matched_phi_deg: Option<f64>,
}

/// How forces depend on the arm's configuration.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Effect {
    /// Relative change of force from the least to the greatest value.
    pub effect_rel: f64,
    /// Its standard error.
    pub effect_se: f64,
    /// Probability of such an effect by chance.
    pub p: f64,
    /// Least and greatest value, in m or deg.
    pub range: [f64; 2],
    /// In words.
    pub verdict: String,
}

/// What model forces are for.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Comparison {
    /// Name of the model.
    pub model: String,
    /// Density in kg/m3.
    pub density_kg_m3: f64,
    /// Interface friction in deg.
    pub delta_deg: f64,
    /// Friction angle in deg of `model_n`; null without --phi.
    pub phi_deg: Option<f64>,
}
