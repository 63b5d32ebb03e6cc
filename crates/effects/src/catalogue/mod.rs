//! The catalogue: one effect a file, and one line here.

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

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::{Effect, EffectsError};

/// Makes [`EffectId`] out of the list below: a variant, the file that defines it, whose name is the id, and a title.
macro_rules! catalogue {
    ($($variant:ident: $file:ident, $title:literal;)*) => {
        /// An effect of the catalogue.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        #[serde(try_from = "String", into = "&'static str")]
        pub enum EffectId {
            $(#[doc = concat!("`", stringify!($file), "`: ", $title, ".")] $variant,)*
        }

        impl EffectId {
            /// All effects, in the order in which answers list them.
            pub const ALL: [Self; [$(stringify!($file)),*].len()] = [$(Self::$variant),*];

            /// Id in files and answers.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => stringify!($file),)* }
            }

            /// What it is, in a few words.
            #[must_use]
            pub const fn title(self) -> &'static str {
                match self { $(Self::$variant => $title,)* }
            }

            /// What it does to a stroke.
            #[must_use]
            pub fn effect(self) -> &'static Effect {
                match self { $(Self::$variant => &$file::EFFECT,)* }
            }
        }
    };
}

catalogue! {
    StressDependentFriction: stress_dependent_friction, "friction angle falls with normal stress";
    ProgressiveFailure: progressive_failure, "force read low where failure is gradual";
    InsertionLoosening: insertion_loosening, "insertion of the plate loosens dense soil";
    Cohesion: cohesion, "the soil has cohesion";
    SurchargeHeap: surcharge_heap, "soil is heaped ahead of the plate";
    SurfaceSlope: surface_slope, "the surface is not level";
    SideEffects3d: side_effects_3d, "soil shears at the ends of the plate";
    RateEffect: rate_effect, "the force depends on speed";
    TipBearing: tip_bearing, "the edge bears on the soil at low tool angles";
    InterfaceFrictionOffset: interface_friction_offset, "interface friction differs from its set-point";
    DepthOffset: depth_offset, "depths are off by a constant";
    ToolAngleOffset: tool_angle_offset, "tool angles are off by a constant";
    ForceScale: force_scale, "the sensor's gain is off";
    ForceBias: force_bias, "the sensor's zero is off";
    ForceDrift: force_drift, "the sensor's zero drifts";
    FtCrosstalk: ft_crosstalk, "normal force leaks into the tangential channel";
    DensityGradient: density_gradient, "the soil is denser below";
    PreparationDrift: preparation_drift, "preparations drift from batch to batch";
    RadiusDependence: radius_dependence, "the reading depends on the radius";
    BaseAngleDependence: base_angle_dependence, "the reading depends on the base angle";
    AdjacentStroke: adjacent_stroke, "earlier strokes disturbed the soil";
    WallProximity: wall_proximity, "a wall of the box is near";
    MoistureDrying: moisture_drying, "moisture dries out over the campaign";
    ModelForm: model_form, "another force model holds";
    CableFlex: cable_flex, "cables stretch under load";
    Backlash: backlash, "free play between motor and joint";
    BackdriveFriction: backdrive_friction, "the drive takes force by friction";
    EncoderQuantisation: encoder_quantisation, "encoder steps are coarse";
}

impl FromStr for EffectId {
    type Err = EffectsError;

    fn from_str(id: &str) -> Result<Self, EffectsError> {
        let found = Self::ALL.into_iter().find(|known| known.name() == id);
        found.ok_or_else(|| EffectsError::UnknownEffect { id: id.to_owned() })
    }
}

impl TryFrom<String> for EffectId {
    type Error = EffectsError;

    fn try_from(id: String) -> Result<Self, EffectsError> {
        id.parse()
    }
}

impl From<EffectId> for &'static str {
    fn from(id: EffectId) -> Self {
        id.name()
    }
}

impl fmt::Display for EffectId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
