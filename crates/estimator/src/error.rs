use soilctl_earth_pressure::EarthPressureError;
use soilctl_soil::SoilError;
use thiserror::Error;

/// What can go wrong in an estimate.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum EstimatorError {
    /// No measurement at all.
    #[error("there is no measurement; give at least one stroke")]
    NoMeasurement,
    /// A model that takes too long for an estimate.
    #[error(
        "model {model} seeks its mechanism anew for each soil, and an estimate asks for thousands of soils; use \
         perumpral, mckyes or godwin-spoor for plates with ends, or table"
    )]
    SlowModel {
        /// Id of the model.
        model: &'static str,
    },
    /// More distinct measurements than the estimator takes.
    #[error(
        "there are {count} distinct measurements, the limit is {limit}; group strokes by tool angle and depth"
    )]
    TooManyMeasurements {
        /// How many were given.
        count: usize,
        /// How many are taken.
        limit: usize,
    },
    /// An interval of knowledge is not an interval.
    #[error("{quantity} is known as {low} to {high} {unit}; it must be {allowed}")]
    BadInterval {
        /// Name of the quantity.
        quantity: &'static str,
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
        /// Unit.
        unit: &'static str,
        /// What is allowed, in words.
        allowed: String,
    },
    /// A measurement has no width, so bands would be lines.
    #[error(
        "measurement {label} has no uncertainty (force {force_n} N exactly); give a positive standard deviation, \
         or treat the data as exact"
    )]
    NoUncertainty {
        /// The measurement.
        label: String,
        /// Its force.
        force_n: f64,
    },
    /// A task that knows one friction angle only.
    #[error("{task} knows one friction angle for all stresses; leave it out, or the law of stress")]
    OneFrictionOnly {
        /// What was asked for.
        task: &'static str,
    },
    /// A task that does not know cohesion, adhesion, surcharge or slope as unknowns.
    #[error(
        "{task} takes cohesion, adhesion, surcharge and the slope of the surface as known; leave it out, or give each as one number"
    )]
    KnownLoadsOnly {
        /// What was asked for.
        task: &'static str,
    },
    /// A surface that may be steeper than the soil's friction.
    #[error(
        "the surface may slope by {steepest_deg} deg, and friction angles are searched from {least_deg} deg on: a surface steeper than the friction angle slides by \
         itself; search from above {steepest_deg} deg on, or give a narrower interval of the slope"
    )]
    SteepSurface {
        /// Steepest slope in degrees.
        steepest_deg: f64,
        /// Least friction angle searched, in degrees.
        least_deg: f64,
    },
    /// Too little data for what was asked.
    #[error("{task} needs {needed}, but there {found}")]
    TooLittle {
        /// What was asked for.
        task: &'static str,
        /// What it needs.
        needed: &'static str,
        /// What there is.
        found: String,
    },
    /// The force model refuses an input.
    #[error("{context}{source}")]
    Model {
        /// Which measurement, with a colon, or nothing.
        context: String,
        /// What the model says.
        source: EarthPressureError,
    },
    /// A vocabulary value is not valid.
    #[error(transparent)]
    Soil(#[from] SoilError),
}

impl From<EarthPressureError> for EstimatorError {
    fn from(source: EarthPressureError) -> Self {
        Self::Model { context: String::new(), source }
    }
}
