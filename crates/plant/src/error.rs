use soilctl_earth_pressure::EarthPressureError;
use soilctl_kinematics::KinematicsError;
use soilctl_soil::{Rounded, SoilError};
use soilctl_terrain::TerrainError;
use thiserror::Error;

/// What can be wrong with a plant.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PlantError {
    /// A file could not be read.
    #[error("cannot read {file}: {reason}; check the path and the permissions")]
    Io {
        /// The file as it was asked for.
        file: String,
        /// What the operating system said.
        reason: String,
    },
    /// A file is not the TOML that is expected.
    #[error("{file}: {problem}")]
    Syntax {
        /// The file.
        file: String,
        /// What the parser said, with line and column.
        problem: String,
    },
    /// A key holds a value that is not allowed.
    #[error("{file}: `{key}` is {}{}{unit}; it must be {allowed}", Rounded(*.value), if .unit.is_empty() { "" } else { " " })]
    Config {
        /// The file.
        file: String,
        /// Full name of the key, with the place in a list if it is one.
        key: String,
        /// The value found, in `unit`.
        value: f64,
        /// Unit of `value`.
        unit: &'static str,
        /// The allowed range.
        allowed: String,
    },
    /// There is no soil preset of this name.
    #[error("there is no soil `{name}`; use one of {known}")]
    UnknownSoil {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// The rigid bodies could not be put together.
    #[error("the rigid bodies cannot be put together: {problem}; check the arm file")]
    Bodies {
        /// What is wrong.
        problem: &'static str,
    },
    /// Arm and soil are on different planets.
    #[error(
        "the soil is under {} m/s2, but the arm under {} m/s2; give the arm the soil's gravity (PlantParams::under_gravity)",
        Rounded(*.soil_m_s2), Rounded(*.arm_m_s2)
    )]
    GravityDiffers {
        /// Gravity of the soil in m/s2.
        soil_m_s2: f64,
        /// Gravity of the arm in m/s2.
        arm_m_s2: f64,
    },
    /// A number of the motion is not finite; the simulated time is over.
    #[error(
        "the simulated arm left all bounds at tick {tick}: {quantity} is not finite; lower gains or raise the substeps"
    )]
    Diverged {
        /// The tick.
        tick: u64,
        /// What is not finite.
        quantity: &'static str,
    },
    /// A posture that the arm does not have.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
    /// A soil that does not exist.
    #[error(transparent)]
    Soil(#[from] SoilError),
    /// A box that has no surface.
    #[error(transparent)]
    Terrain(#[from] TerrainError),
    /// A force model has no answer for this soil.
    #[error(transparent)]
    Force(#[from] EarthPressureError),
}
