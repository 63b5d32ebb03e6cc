use soilctl_campaign::CampaignError;
use soilctl_earth_pressure::EarthPressureError;
use soilctl_estimator::EstimatorError;
use soilctl_kinematics::KinematicsError;
use soilctl_plant::PlantError;
use soilctl_process::ProcessError;
use soilctl_soil::SoilError;
use soilctl_terrain::TerrainError;
use thiserror::Error;

/// What can be wrong with digging.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DiggingError {
    /// A number outside its range.
    #[error("{key} is {value} {unit}; it must be {allowed}")]
    OutOfRange {
        /// What it is of.
        key: &'static str,
        /// The number.
        value: f64,
        /// Its unit.
        unit: &'static str,
        /// What is allowed.
        allowed: String,
    },
    /// A stroke without a way.
    #[error("a stroke has no way; give it a length")]
    NoWay,
    /// A stroke that the arm cannot follow.
    #[error(
        "the arm cannot follow the stroke beyond {travel_m} m with its wrist held; make it shorter, or begin farther out"
    )]
    WayEnds {
        /// Way in m.
        travel_m: f64,
    },
    /// No tool angle can be reached.
    #[error(
        "the arm reaches no tool angle from {low_deg} to {high_deg} deg at a radius of {radius_m} m; move the trench, or allow other tool angles"
    )]
    OutOfReach {
        /// Radius of the insertion in m.
        radius_m: f64,
        /// Least tool angle in deg.
        low_deg: f64,
        /// Greatest tool angle in deg.
        high_deg: f64,
    },
    /// The surface.
    #[error(transparent)]
    Terrain(#[from] TerrainError),
    /// A plan or the simulated arm.
    #[error(transparent)]
    Campaign(#[from] CampaignError),
    /// The force model.
    #[error(transparent)]
    Model(#[from] EarthPressureError),
    /// An estimate.
    #[error(transparent)]
    Estimator(#[from] EstimatorError),
    /// The arm.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// The simulated plant.
    #[error(transparent)]
    Plant(#[from] PlantError),
    /// A stroke's trace.
    #[error(transparent)]
    Process(#[from] ProcessError),
    /// A soil or a plate.
    #[error(transparent)]
    Soil(#[from] SoilError),
}
