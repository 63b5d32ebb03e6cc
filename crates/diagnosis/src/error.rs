use soilctl_columns::ColumnsError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_effects::EffectsError;
use thiserror::Error;

/// Why there is no diagnosis.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DiagnosisError {
    /// An effect or the force model behind it.
    #[error(transparent)]
    Effects(#[from] EffectsError),
    /// A force model.
    #[error(transparent)]
    Model(#[from] EarthPressureError),
    /// A table that could not be written.
    #[error(transparent)]
    Table(#[from] ColumnsError),
    /// No strokes.
    #[error("{file} has no strokes; a diagnosis needs at least one")]
    NoStrokes {
        /// The stroke table.
        file: String,
    },
    /// The fit found no answer.
    #[error(
        "no soil explains {file} with model {model}: {problem}; check units, tool angles and the interface friction \
         angle"
    )]
    NoFit {
        /// The stroke table.
        file: String,
        /// Id of the force model.
        model: String,
        /// What went wrong.
        problem: String,
    },
}
