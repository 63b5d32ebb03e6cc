use std::path::Path;

use crate::config::ArmConfig;
use crate::transmission::Transmission;
use crate::validate::validate;
use crate::{JointAngles, KinematicsError};

/// How far outside its limits an angle may lie and still count as inside, in rad: rounding, far below an encoder
/// step.
///
/// Such an angle is returned as it is, not moved onto the limit.
pub const LIMIT_TOLERANCE_RAD: f64 = 1e-9;

/// An arm whose description has been checked; every computation starts from one.
///
/// The methods that a control loop calls (`forward`, `frames`, `jacobian`, `inverse`, `inverse_velocity`,
/// `gravity_torques`, `tip_force` and those of [`Transmission`]) do a fixed amount of work, allocate nothing and do
/// not panic on any input. Their sines, cosines and arctangents come from `libm`, whose bits are the same on every
/// machine.
#[derive(Debug, Clone, PartialEq)]
pub struct Arm {
    config: ArmConfig,
    lower: JointAngles,
    upper: JointAngles,
    transmission: Transmission,
}

impl Arm {
    /// An arm from its description.
    ///
    /// # Errors
    /// [`KinematicsError::Config`] or [`KinematicsError::Syntax`] naming the first key that is not allowed.
    pub fn new(config: ArmConfig) -> Result<Self, KinematicsError> {
        Self::from_config(config, "arm")
    }

    /// An arm from the text of a TOML file; `file` is named in messages.
    ///
    /// # Errors
    /// [`KinematicsError::Syntax`] if the text is not such a file (with line and column), or
    /// [`KinematicsError::Config`] if a value is not allowed (with its key).
    pub fn from_toml(text: &str, file: &str) -> Result<Self, KinematicsError> {
        let config = toml::from_str(text).map_err(|error| KinematicsError::Syntax {
            file: file.to_owned(),
            problem: error.to_string().trim_end().to_owned(),
        })?;
        Self::from_config(config, file)
    }

    /// An arm from a TOML file.
    ///
    /// # Errors
    /// [`KinematicsError::Io`] if it cannot be read, otherwise as [`Arm::from_toml`].
    pub fn read(path: &Path) -> Result<Self, KinematicsError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|error| KinematicsError::Io { file: file.clone(), reason: error.to_string() })?;
        Self::from_toml(&text, &file)
    }

    /// The arm of Hong (2001), from `data/arm/thesis.toml`; that file says which numbers are printed and which
    /// assumed.
    ///
    /// # Panics
    /// Never: a test reads the same text.
    #[must_use]
    pub fn thesis() -> Self {
        const TEXT: &str = include_str!("../../../data/arm/thesis.toml");
        match Self::from_toml(TEXT, "data/arm/thesis.toml") {
            Ok(arm) => arm,
            Err(error) => unreachable!("{error}"),
        }
    }

    fn from_config(config: ArmConfig, file: &str) -> Result<Self, KinematicsError> {
        validate(&config, file)?;
        let joints = config.joints.all();
        let transmission = Transmission::new(
            joints.map(|joint| f64::from(joint.motor_sign)),
            JointAngles::from_degrees(joints.map(|joint| joint.home_deg)),
            config.transmission.coupling_ratio,
            config.transmission.differential_ratio,
        );
        Ok(Self {
            lower: JointAngles::from_degrees(joints.map(|joint| joint.lower_deg)),
            upper: JointAngles::from_degrees(joints.map(|joint| joint.upper_deg)),
            transmission,
            config,
        })
    }

    /// The description that this arm was made from.
    #[must_use]
    pub const fn config(&self) -> &ArmConfig {
        &self.config
    }

    /// Lower limits of the joints.
    #[must_use]
    pub const fn lower_limits(&self) -> JointAngles {
        self.lower
    }

    /// Upper limits of the joints.
    #[must_use]
    pub const fn upper_limits(&self) -> JointAngles {
        self.upper
    }

    /// The map between joints and motors.
    #[must_use]
    pub const fn transmission(&self) -> &Transmission {
        &self.transmission
    }

    /// Elbow to wrist in m: `l_2 + l_3`, since the twist joint turns about that line.
    pub(crate) fn forearm_m(&self) -> f64 {
        self.config.links.forearm_m + self.config.links.twist_m
    }

    /// Refuses angles outside the limits; the first offending joint is named.
    ///
    /// # Errors
    /// [`KinematicsError::OutOfLimits`], or [`KinematicsError::NonFinite`] and [`KinematicsError::OutOfRange`] for
    /// numbers that are no angles.
    pub fn check_limits(&self, joints: &JointAngles) -> Result<(), KinematicsError> {
        let angles = joints.checked()?;
        for joint in crate::Joint::ALL {
            let i = joint.index();
            let (lower, upper) = (self.lower.0[i], self.upper.0[i]);
            if angles[i] < lower - LIMIT_TOLERANCE_RAD || angles[i] > upper + LIMIT_TOLERANCE_RAD {
                return Err(KinematicsError::OutOfLimits {
                    joint,
                    angle_deg: angles[i].to_degrees(),
                    lower_deg: lower.to_degrees(),
                    upper_deg: upper.to_degrees(),
                });
            }
        }
        Ok(())
    }
}
