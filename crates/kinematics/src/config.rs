//! The arm file: what a person writes and [`Arm`](crate::Arm) checks.

use serde::{Deserialize, Serialize};

/// Description of an arm as it stands in a TOML file. Unknown keys are refused.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ArmConfig {
    /// Version of the format: 1.
    pub version: u32,
    /// Name of the arm; also the robot's name in the URDF. Letters, digits, `_` and `-`.
    pub name: String,
    /// Gravity in m/s2, 0 to 30; 0 is an arm in free fall.
    pub gravity_m_s2: f64,
    /// Link lengths.
    pub links: Links,
    /// Limits and motors, by joint.
    pub joints: Joints,
    /// From joints to motors.
    pub transmission: TransmissionConfig,
    /// Masses of the links.
    pub masses: Masses,
    /// Counterweights.
    pub counterweights: Counterweights,
    /// The plate at the end of the hand.
    pub plate: PlateShape,
    /// The force sensor behind the plate.
    pub sensor: Sensor,
    /// Cable stretch.
    pub flexion: FlexionConfig,
    /// Damping near the straight wrist.
    pub wrist_singularity: WristSingularity,
}

/// Link lengths `l_0` to `l_4` in m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Links {
    /// `l_0`, table to shoulder; 0 to 10 m.
    pub base_height_m: f64,
    /// `l_1`, shoulder to elbow; above 0, at most 10 m.
    pub upper_arm_m: f64,
    /// `l_2`, elbow to twist joint; above 0, at most 10 m.
    pub forearm_m: f64,
    /// `l_3`, twist joint to wrist, along the forearm; 0 to 10 m. Hong's equations have none.
    pub twist_m: f64,
    /// `l_4`, wrist to the middle of the plate's lower edge; above 0, at most 10 m.
    pub hand_m: f64,
}

/// One entry for each joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Joints {
    /// theta_0.
    pub base: JointConfig,
    /// theta_1.
    pub shoulder: JointConfig,
    /// theta_2; its lower limit is above 0.
    pub elbow: JointConfig,
    /// theta_3; its limits are within -90 to 90 degrees.
    pub twist: JointConfig,
    /// theta_4.
    pub wrist: JointConfig,
}

impl Joints {
    /// The five entries in joint order.
    #[must_use]
    pub const fn all(&self) -> [JointConfig; 5] {
        [self.base, self.shoulder, self.elbow, self.twist, self.wrist]
    }
}

/// Limits and motor of one joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct JointConfig {
    /// Lower limit in degrees; -360 to 360.
    pub lower_deg: f64,
    /// Upper limit in degrees; above the lower one, by less than 360.
    pub upper_deg: f64,
    /// Joint angle in degrees at which the motors' coordinates are zero; within the limits.
    pub home_deg: f64,
    /// Largest speed in degrees a second; above 0.
    pub max_speed_deg_s: f64,
    /// Largest torque at the joint in N m; above 0.
    pub max_torque_nm: f64,
    /// +1 or -1: whether the motor turns with or against the joint.
    pub motor_sign: i8,
}

/// Ratios between joints and motors.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TransmissionConfig {
    /// `r_c`, how far the elbow's cables are moved by the shoulder; -10 to 10.
    pub coupling_ratio: f64,
    /// `r_d`, gear ratio of the elbow differential; 0.01 to 100.
    pub differential_ratio: f64,
    /// Motor turns per turn of the gearhead's output; 1 to 10 000.
    pub gearhead_ratio: f64,
    /// Free play at the gearhead's output in degrees; 0 to 90.
    pub gearhead_backlash_deg: f64,
    /// Counts of an external encoder per turn; at least 1.
    pub encoder_counts_per_turn: u32,
}

/// Masses of the moving parts, without counterweights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Masses {
    /// The column that turns with the base joint.
    pub base: Mass,
    /// Shoulder to elbow.
    pub upper_arm: Mass,
    /// Elbow to twist joint.
    pub forearm: Mass,
    /// What twists with the forearm.
    pub twist: Mass,
    /// Hand, force sensor and plate.
    pub hand: Mass,
}

/// A mass on the axis of its link.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mass {
    /// Mass in kg; above 0, at most 1000.
    pub mass_kg: f64,
    /// Centre of mass in m along the link from its inner joint, negative behind it; -10 to 10.
    pub com_m: f64,
}

/// The counterweights.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counterweights {
    /// On the upper arm, behind the shoulder.
    pub shoulder: Counterweight,
    /// On the forearm, behind the elbow.
    pub elbow: Counterweight,
}

/// A point mass in line with a link, behind its inner joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counterweight {
    /// Mass in kg; 0 (none) to 1000.
    pub mass_kg: f64,
    /// Distance behind the joint in m; 0 to 10.
    pub behind_m: f64,
}

/// The plate, a box at the end of the hand.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlateShape {
    /// Along its lower edge, in m; above 0, at most 10.
    pub width_m: f64,
    /// In m; above 0, at most 1.
    pub thickness_m: f64,
    /// From the lower to the upper edge, in m; above 0, at most `hand_m`.
    pub height_m: f64,
}

/// The force sensor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// From its origin along the hand to the plate's lower edge, in m; 0 to `hand_m`.
    pub before_tip_m: f64,
}

/// Stretch of the elbow's cables.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlexionConfig {
    /// Elbow torque over stretch seen at the elbow, in N m/rad; 1e-6 to 1e9.
    pub elbow_stiffness_nm_per_rad: f64,
}

/// Where and how strongly the twist joint's speed is damped.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WristSingularity {
    /// Damping acts where `|sin theta_4|` is below this; 0.001 to 0.5.
    pub sin_region: f64,
    /// Damping at `theta_4 = 0`; 0.0001 to 1.
    pub damping: f64,
}
