use soilctl_earth_pressure::EarthPressureError;
use soilctl_soil::Rounded;
use thiserror::Error;

use crate::EffectId;

/// Why an effect or a model file gives no answer.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum EffectsError {
    /// The force model.
    #[error(transparent)]
    Model(#[from] EarthPressureError),
    /// Effects together leave no force.
    #[error(
        "with these effects the force comes out as {} N; it must be above 0 N, so the amplitudes are too large for \
         this stroke",
        Rounded(*.force_n)
    )]
    NoForce {
        /// The force in N.
        force_n: f64,
    },
    /// No such effect.
    #[error("there is no effect called {id:?}; the effects are {}", EffectId::ALL.map(EffectId::name).join(", "))]
    UnknownEffect {
        /// What was asked for.
        id: String,
    },
    /// A file that cannot be read or written.
    #[error("{file}: {problem}")]
    File {
        /// The file.
        file: String,
        /// What the system says.
        problem: String,
    },
    /// A model file whose content is wrong.
    #[error("{file}: {problem}")]
    BadFile {
        /// The file.
        file: String,
        /// What is wrong: the key, the value and what is allowed.
        problem: String,
    },
}
