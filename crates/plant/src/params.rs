use std::path::Path;

use soilctl_kinematics::Arm;

use crate::PlantError;
use crate::config::PlantConfig;
use crate::validate::validate;

/// The plant of the thesis's arm, `data/plant/default.toml`.
const DEFAULT: &str = include_str!("../../../data/plant/default.toml");

/// An arm and the description of its simulated plant, checked.
#[derive(Debug, Clone, PartialEq)]
pub struct PlantParams {
    arm: Arm,
    config: PlantConfig,
}

impl PlantParams {
    /// Parameters from a description that was made in a program.
    ///
    /// # Errors
    /// [`PlantError::Config`] naming the first key that is not allowed.
    pub fn new(arm: Arm, config: PlantConfig) -> Result<Self, PlantError> {
        validate(&config, "plant")?;
        Ok(Self { arm, config })
    }

    /// Parameters from the text of a plant file; `file` is named in messages.
    ///
    /// # Errors
    /// [`PlantError::Syntax`] if the text is not such a file, otherwise as [`PlantParams::new`].
    pub fn from_toml(arm: Arm, text: &str, file: &str) -> Result<Self, PlantError> {
        let config = toml::from_str(text).map_err(|error| PlantError::Syntax {
            file: file.to_owned(),
            problem: error.to_string().trim_end().to_owned(),
        })?;
        validate(&config, file)?;
        Ok(Self { arm, config })
    }

    /// Parameters from a plant file.
    ///
    /// # Errors
    /// [`PlantError::Io`] if it cannot be read, otherwise as [`PlantParams::from_toml`].
    pub fn read(arm: Arm, path: &Path) -> Result<Self, PlantError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|error| PlantError::Io { file: file.clone(), reason: error.to_string() })?;
        Self::from_toml(arm, &text, &file)
    }

    /// The thesis's arm with `data/plant/default.toml`, whose comments say what is printed and what assumed.
    ///
    /// # Panics
    /// Never: a test reads the same text.
    #[must_use]
    pub fn thesis() -> Self {
        match Self::from_toml(Arm::thesis(), DEFAULT, "data/plant/default.toml") {
            Ok(params) => params,
            Err(error) => unreachable!("{error}"),
        }
    }

    /// The arm.
    #[must_use]
    pub const fn arm(&self) -> &Arm {
        &self.arm
    }

    /// The description.
    #[must_use]
    pub const fn config(&self) -> &PlantConfig {
        &self.config
    }

    /// Length of a substep in s.
    #[must_use]
    pub fn substep_s(&self) -> f64 {
        soilctl_controller::TICK_S / f64::from(self.config.bodies.substeps)
    }
}
