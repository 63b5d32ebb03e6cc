//! Effects that an experiment with a plate in soil can hide, and the model file that carries them.
//!
//! A plain force model knows weight, friction and geometry. Real strokes know more: soil that is denser below, a
//! sensor off its zero, a wall that is too near. Each such [`Effect`] says, for one stroke, what it changes: the
//! [`Conditions`] under which the soil fails (angles, depth, loads), a factor on the force, a bias of the reading,
//! and the shift of columns derived from the trace ([`Channel`]). [`force_n`] puts a force model and any number of
//! effects together.
//!
//! Every effect has one amplitude with a plausible [`Range`], and some have a shape (a decay length, an azimuth),
//! chosen from a short list. An amplitude of zero is exactly the plain model.
//!
//! A [`ModelFile`] holds soil, effects and where they come from, and is what `--model-file` loads.

mod catalogue;
mod channel;
mod conditions;
mod covariate;
mod effect;
mod error;
mod force;
mod loaded;
mod mechanics;
mod model_file;
mod parameter;
mod reference;
mod site;
mod stroke;

pub use catalogue::EffectId;
pub use channel::Channel;
pub use conditions::{Base, Conditions};
pub use covariate::Covariate;
pub use effect::{Acting, Active, Effect, Reading, Response};
pub use error::EffectsError;
pub use force::force_n;
pub use loaded::Loaded;
pub use mechanics::{ALTERNATIVE_MODELS, DirectMechanics, Mechanics, Net};
pub use model_file::{EffectEntry, FILE_SCHEMA, HeldOut, ModelFile, ParameterValue, SoilEntry};
pub use parameter::{Parameter, Range, Shape, Sign};
pub use reference::Reference;
pub use site::{DriveSite, SensorSite, Site, SoilSite, SurfaceSite};
pub use stroke::Stroke;
