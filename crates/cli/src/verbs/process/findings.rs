//! What the strokes say together, as the answer tells it.

use schemars::JsonSchema;
use serde::Serialize;

/// What the strokes say together.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub(crate) struct Analysis {
    /// Interface friction by the lift at failure; null without a sweep.
    pub(crate) friction: Option<Friction>,
    /// Why there is none.
    pub(crate) no_friction: Option<String>,
    /// The check by rubbing; null without such a log.
    pub(crate) rubbing: Option<Rubbing>,
    /// Force as a power of depth, for each tool angle with several depths.
    pub(crate) depth_laws: Vec<Law>,
    /// Slant length to which forces are scaled in m.
    pub(crate) slant_m: f64,
    /// Forces by tool angle, at that slant length.
    pub(crate) groups: Vec<Group>,
    /// Whether forces depend on the radius; null if it does not vary.
    pub(crate) radius: Option<Effect>,
    /// Whether forces depend on the base angle; null if it does not vary.
    pub(crate) base_angle: Option<Effect>,
    /// What the model's forces were compared for; null without --density.
    pub(crate) comparison: Option<Comparison>,
}

/// Interface friction by a sweep of set-points.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Friction {
    /// Estimate in deg.
    pub(crate) delta_deg: f64,
    /// Its standard deviation in deg.
    pub(crate) sd_deg: f64,
    /// Highest set-point with a significant lift; friction is above it.
    pub(crate) above_deg: Option<f64>,
    /// Lowest set-point above that without one; friction is below it.
    pub(crate) below_deg: Option<f64>,
    /// Lift for each degree that the set-point is too low.
    pub(crate) lift_per_deg: f64,
    /// Strokes at 80 to 90 deg, which count.
    pub(crate) strokes: Vec<Lift>,
    /// Strokes at other tool angles, or without a measured lift.
    pub(crate) left_out: Vec<String>,
}

/// Lift at failure of one stroke.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Lift {
    pub(crate) stroke_id: String,
    pub(crate) set_deg: f64,
    pub(crate) lift_deg: f64,
    pub(crate) lift_sd_deg: f64,
    /// Lift over its standard deviation.
    pub(crate) significance: f64,
}

/// The check by rubbing a sand-covered plate.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Rubbing {
    /// Median of the peaks of the friction angle in deg.
    pub(crate) peak_deg: f64,
    /// Range that holds two thirds of the peaks in deg.
    pub(crate) range_deg: [f64; 2],
    /// How many peaks.
    pub(crate) peaks: usize,
    /// Time in s and friction angle in deg, for the figure.
    #[serde(skip)]
    pub(crate) course: Vec<(f64, f64)>,
}

/// Force as a power of depth.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Law {
    /// Tool angle in deg.
    pub(crate) alpha_deg: f64,
    /// Strokes.
    pub(crate) strokes: usize,
    /// The power; 2 in soil without cohesion.
    pub(crate) exponent: f64,
    /// Ends of its 95 % confidence interval.
    pub(crate) exponent_95: [f64; 2],
    /// F/H^2 of the fit through zero in N/m2.
    pub(crate) quadratic_n_per_m2: f64,
    /// Whether the interval holds 2.
    pub(crate) agrees_with_square: bool,
}

/// Forces at one tool angle.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Group {
    /// Tool angle in deg.
    pub(crate) alpha_deg: f64,
    /// Strokes, outliers included.
    pub(crate) strokes: usize,
    /// Mean without outliers in N.
    pub(crate) mean_n: f64,
    /// Standard deviation without outliers in N; null of one stroke.
    pub(crate) sd_n: Option<f64>,
    /// Standard deviation over mean.
    pub(crate) coefficient_of_variation: Option<f64>,
    /// Strokes that do not belong (generalised extreme Studentised deviate test, 5 %).
    pub(crate) outliers: Vec<String>,
    /// Force of the model for the given friction angle in N.
    pub(crate) model_n: Option<f64>,
    /// Mean over that force, minus 1.
    pub(crate) model_difference: Option<f64>,
    /// Friction angle at which the model gives the mean in deg; null if none does.
    pub(crate) matched_phi_deg: Option<f64>,
}

/// How forces depend on the arm's configuration.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Effect {
    /// Relative change of force from the least to the greatest value.
    pub(crate) effect_rel: f64,
    /// Its standard error.
    pub(crate) effect_se: f64,
    /// Probability of such an effect by chance.
    pub(crate) p: f64,
    /// Least and greatest value, in m or deg.
    pub(crate) range: [f64; 2],
    /// In words.
    pub(crate) verdict: String,
}

/// What model forces are for.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Comparison {
    /// Name of the model.
    pub(crate) model: String,
    /// Density in kg/m3.
    pub(crate) density_kg_m3: f64,
    /// Interface friction in deg.
    pub(crate) delta_deg: f64,
    /// Friction angle in deg of `model_n`; null without --phi.
    pub(crate) phi_deg: Option<f64>,
}
