//! Why a figure or page was not made.

use soilctl_app::AppError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_estimator::EstimatorError;
use soilctl_figure::FigureError;
use thiserror::Error;

/// Why a figure or page was not made.
#[derive(Debug, Error)]
pub enum PageError {
    /// What is drawn has no answer, or a file cannot be written.
    #[error(transparent)]
    App(#[from] AppError),
    /// A figure.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// There is nothing to draw, or no way to write it.
    #[error("{0}")]
    Nothing(String),
}

impl From<EarthPressureError> for PageError {
    fn from(problem: EarthPressureError) -> Self {
        Self::App(problem.into())
    }
}

impl From<EstimatorError> for PageError {
    fn from(problem: EstimatorError) -> Self {
        Self::App(problem.into())
    }
}
