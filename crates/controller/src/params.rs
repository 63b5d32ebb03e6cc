use std::f64::consts::TAU;
use std::path::Path;

use soilctl_kinematics::{Arm, CylindricalStiffness, JointAngles};

use crate::config::ControllerConfig;
use crate::laws::SafeForceSet;
use crate::validate::validate;
use crate::{ControllerError, StrokePlan};

/// Steps in a second.
pub const TICK_RATE_HZ: f64 = 500.0;
/// Time between two steps in s.
pub const TICK_S: f64 = 1.0 / TICK_RATE_HZ;

/// Everything that a step needs and does not change: arm, settings, stroke plan. Checked when made.
#[derive(Debug, Clone, PartialEq)]
pub struct Params {
    arm: Arm,
    config: ControllerConfig,
    plan: StrokePlan,
    safe_force: SafeForceSet,
    pub(crate) stiffness: CylindricalStiffness,
    pub(crate) motor_rad_per_count: [f64; 5],
    pub(crate) external_rad_per_count: [f64; 5],
    pub(crate) elbow_rad_per_nm: f64,
    pub(crate) motor_smoothing: f64,
    pub(crate) external_smoothing: f64,
    pub(crate) velocity_smoothing: f64,
    pub(crate) force_smoothing: f64,
    pub(crate) stroke_smoothing: f64,
    pub(crate) max_joint_speed_rad_s: [f64; 5],
    pub(crate) tracking_error_rad: [f64; 5],
    pub(crate) disagreement_rad: [f64; 5],
    pub(crate) touch_error_rad: [f64; 5],
    pub(crate) touch_speed_rad_s: [f64; 5],
    pub(crate) setpoint_step_rad: f64,
    pub(crate) joint_margin_rad: f64,
    pub(crate) max_joint_torque_nm: [f64; 5],
    pub(crate) park: JointAngles,
}

impl Params {
    /// Parameters from settings that were made in a program.
    ///
    /// # Errors
    /// [`ControllerError::Config`] naming the first key that is not allowed, or [`ControllerError::Unreachable`] for a
    /// stroke of the plan that the arm cannot make.
    pub fn new(arm: Arm, config: ControllerConfig, plan: StrokePlan) -> Result<Self, ControllerError> {
        Self::from_config(arm, config, plan, "controller settings")
    }

    /// Parameters from the text of a settings file; `file` is named in messages.
    ///
    /// # Errors
    /// [`ControllerError::Syntax`] if the text is not such a file, otherwise as [`Params::new`].
    pub fn from_toml(arm: Arm, text: &str, file: &str, plan: StrokePlan) -> Result<Self, ControllerError> {
        let config = toml::from_str(text).map_err(|error| ControllerError::Syntax {
            file: file.to_owned(),
            problem: error.to_string().trim_end().to_owned(),
        })?;
        Self::from_config(arm, config, plan, file)
    }

    /// Parameters from a settings file.
    ///
    /// # Errors
    /// [`ControllerError::Io`] if it cannot be read, otherwise as [`Params::from_toml`].
    pub fn read(arm: Arm, path: &Path, plan: StrokePlan) -> Result<Self, ControllerError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|error| ControllerError::Io { file: file.clone(), reason: error.to_string() })?;
        Self::from_toml(arm, &text, &file, plan)
    }

    /// The thesis's arm with `data/controller/default.toml`, whose comments say what is printed and what assumed, and
    /// an empty stroke plan.
    ///
    /// # Panics
    /// Never: a test reads the same text.
    #[must_use]
    pub fn thesis() -> Self {
        match Self::from_toml(Arm::thesis(), DEFAULT, "data/controller/default.toml", StrokePlan::default()) {
            Ok(params) => params,
            Err(error) => unreachable!("{error}"),
        }
    }

    fn from_config(
        arm: Arm,
        config: ControllerConfig,
        plan: StrokePlan,
        file: &str,
    ) -> Result<Self, ControllerError> {
        validate(&config, &arm, file)?;
        plan.check_reach(&arm, &config.site)?;
        let [r, t, z] = config.gains.stiffness_n_per_m;
        let (encoders, safety, touch) = (&config.encoders, &config.safety, &config.touch);
        let joints = arm.config().joints.all();
        Ok(Self {
            safe_force: SafeForceSet::new(&config.stroke.safe_force),
            stiffness: CylindricalStiffness::diagonal([r, t, z, 0.0, 0.0]),
            motor_rad_per_count: encoders.motor_counts_per_turn.map(|counts| TAU / counts),
            external_rad_per_count: encoders.external_counts_per_turn.map(|counts| TAU / counts),
            elbow_rad_per_nm: arm.elbow_compliance().rad_per_nm[1][1],
            motor_smoothing: smoothing(encoders.motor_filter_hz),
            external_smoothing: smoothing(encoders.external_filter_hz),
            velocity_smoothing: smoothing(encoders.velocity_filter_hz),
            force_smoothing: smoothing(config.force_sensor.filter_hz),
            stroke_smoothing: smoothing(config.stroke.position_filter_hz),
            max_joint_speed_rad_s: joints
                .map(|joint| joint.max_speed_deg_s.to_radians() * safety.joint_speed_factor),
            tracking_error_rad: safety.tracking_error_deg.map(f64::to_radians),
            disagreement_rad: safety.disagreement_deg.map(f64::to_radians),
            touch_error_rad: touch.joint_error_deg.map(f64::to_radians),
            touch_speed_rad_s: touch.joint_speed_deg_s.map(f64::to_radians),
            setpoint_step_rad: safety.setpoint_step_deg.to_radians(),
            joint_margin_rad: safety.joint_margin_deg.to_radians(),
            max_joint_torque_nm: joints.map(|joint| joint.max_torque_nm),
            park: JointAngles::from_degrees(config.site.park_deg),
            arm,
            config,
            plan,
        })
    }

    /// The arm.
    #[must_use]
    pub const fn arm(&self) -> &Arm {
        &self.arm
    }

    /// The settings.
    #[must_use]
    pub const fn config(&self) -> &ControllerConfig {
        &self.config
    }

    /// The stroke plan.
    #[must_use]
    pub const fn plan(&self) -> &StrokePlan {
        &self.plan
    }

    /// Forces that the soil bears (section 5.3.3).
    #[must_use]
    pub const fn safe_force(&self) -> &SafeForceSet {
        &self.safe_force
    }
}

/// The settings file of the thesis's arm, `data/controller/default.toml`.
pub const DEFAULT: &str = include_str!("../../../data/controller/default.toml");

/// Weight of a new value in a first-order low-pass with this corner.
fn smoothing(corner_hz: f64) -> f64 {
    1.0 - libm::exp(-TAU * corner_hz * TICK_S)
}
