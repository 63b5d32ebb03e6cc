//! The catalogue: one effect a file.

mod adjacent_stroke;
mod backdrive_friction;
mod backlash;
mod base_angle_dependence;
mod cable_flex;
mod cohesion;
mod density_gradient;
mod depth_offset;
mod distance;
mod encoder_quantisation;
mod force_bias;
mod force_drift;
mod force_scale;
mod ft_crosstalk;
mod insertion_loosening;
mod interface_friction_offset;
mod model_form;
mod moisture_drying;
mod preparation_drift;
mod progressive_failure;
mod radius_dependence;
mod rate_effect;
mod side_effects_3d;
mod stress_dependent_friction;
mod surcharge_heap;
mod surface_slope;
mod tip_bearing;
mod tool_angle_offset;
mod wall_proximity;

use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Force models that `model_form` may put in the place of the one in use.
pub const ALTERNATIVE_MODELS: [&str; 4] = ["coulomb", "chen", "log-spiral", "caquot"];

/// Readings of a stroke that shifts of channels depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Measured failure force, N.
    pub force_n: f64,
    /// Interface friction angle, deg.
    pub delta_deg: f64,
    /// Unit weight of the soil, N/m3.
    pub unit_weight_n_m3: f64,
    /// Step of the external encoders at the tip, m.
    pub encoder_step_m: f64,
}

/// A channel in which an effect shows with a strength that its amplitude does not fix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// The channel.
    pub channel: Channel,
    /// Mean of the strength, in the unit of the channel.
    pub mean: f64,
    /// Standard deviation of the strength.
    pub sd: f64,
}

/// One effect: what it does to a stroke.
pub trait Effect: Sync {
    /// Id in files and answers.
    fn id(&self) -> &'static str;

    /// What it is, in a few words.
    fn title(&self) -> &'static str;

    /// The parameter that is its amplitude.
    fn parameter(&self) -> Parameter;

    /// Plausible amplitudes.
    fn range(&self) -> Range;

    /// What the amplitude leaves open; `None` if nothing.
    fn shape(&self) -> Option<Shape> {
        None
    }

    /// Whether the failure force depends on it.
    fn acts_on_force(&self) -> bool {
        true
    }

    /// Changes the conditions of a stroke. Nothing changes at amplitude 0.
    ///
    /// # Errors
    /// [`EffectsError`] where the force model has no answer.
    fn apply(
        &self,
        amplitude: f64,
        shape: f64,
        stroke: &Stroke,
        reference: &Reference,
        conditions: &mut Conditions,
        mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        let _ = (amplitude, shape, stroke, reference, conditions, mechanics);
        Ok(())
    }

    /// Channels that shift by an amount that the amplitude fixes.
    fn linked(&self) -> &'static [Channel] {
        &[]
    }

    /// Shift of a linked channel, in its unit.
    fn shift(&self, channel: Channel, amplitude: f64, shape: f64, stroke: &Stroke, reading: &Reading) -> f64 {
        let _ = (channel, amplitude, shape, stroke, reading);
        0.0
    }

    /// A channel without which a shape means the same as another one; `None` if there is no such channel.
    fn needs(&self, shape: f64) -> Option<Channel> {
        let _ = shape;
        None
    }

    /// Channels that show it with a strength of their own.
    fn responses(&self) -> &'static [Response] {
        &[]
    }

    /// Pattern over the strokes with which a channel responds; to be multiplied by the strength.
    fn response(&self, channel: Channel, shape: f64, stroke: &Stroke, reference: &Reference) -> f64 {
        let _ = (channel, shape, stroke, reference);
        0.0
    }
}

static CATALOGUE: [&dyn Effect; 28] = [
    &stress_dependent_friction::StressDependentFriction,
    &progressive_failure::ProgressiveFailure,
    &insertion_loosening::InsertionLoosening,
    &cohesion::Cohesion,
    &surcharge_heap::SurchargeHeap,
    &surface_slope::SurfaceSlope,
    &side_effects_3d::SideEffects,
    &rate_effect::RateEffect,
    &tip_bearing::TipBearing,
    &interface_friction_offset::InterfaceFrictionOffset,
    &depth_offset::DepthOffset,
    &tool_angle_offset::ToolAngleOffset,
    &force_scale::ForceScale,
    &force_bias::ForceBias,
    &force_drift::ForceDrift,
    &ft_crosstalk::FtCrosstalk,
    &density_gradient::DensityGradient,
    &preparation_drift::PreparationDrift,
    &radius_dependence::RadiusDependence,
    &base_angle_dependence::BaseAngleDependence,
    &adjacent_stroke::AdjacentStroke,
    &wall_proximity::WallProximity,
    &moisture_drying::MoistureDrying,
    &model_form::ModelForm,
    &cable_flex::CableFlex,
    &backlash::Backlash,
    &backdrive_friction::BackdriveFriction,
    &encoder_quantisation::EncoderQuantisation,
];

/// All effects.
#[must_use]
pub fn catalogue() -> &'static [&'static dyn Effect] {
    &CATALOGUE
}

/// The effect with an id.
#[must_use]
pub fn effect(id: &str) -> Option<&'static dyn Effect> {
    CATALOGUE.iter().copied().find(|effect| effect.id() == id)
}
