#![doc = include_str!("../README.md")]

mod catalogue;
mod channel;
mod conditions;
mod covariate;
mod effect;
mod empirical;
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
pub use empirical::EmpiricalTerm;
pub use error::EffectsError;
pub use force::force_n;
pub use loaded::Loaded;
pub use mechanics::{ALTERNATIVE_MODELS, DirectMechanics, Mechanics, Net};
pub use model_file::{EffectEntry, FILE_SCHEMA, HeldOut, ModelFile, ParameterValue, SoilEntry};
pub use parameter::{Parameter, Range, Shape, Sign};
pub use reference::Reference;
pub use site::{DriveSite, SensorSite, Site, SoilSite, SurfaceSite};
pub use stroke::Stroke;
