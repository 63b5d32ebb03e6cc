//! The plant file: what a person writes and [`PlantParams`](crate::PlantParams) checks.

use serde::{Deserialize, Serialize};

/// Description of a plant as it stands in a TOML file. Unknown keys are refused. Lists of five go by joint or motor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlantConfig {
    /// Version of the format: 1.
    pub version: u32,
    /// Links and joints.
    pub bodies: BodiesConfig,
    /// The box of sand.
    #[serde(rename = "box")]
    pub sandbox: BoxConfig,
    /// Motors and gears.
    pub drives: DrivesConfig,
    /// Encoders.
    pub encoders: EncodersConfig,
    /// Force sensor.
    pub force_sensor: ForceSensorConfig,
    /// Amplifiers.
    pub amplifiers: AmplifiersConfig,
    /// How sand resists.
    pub ground: GroundConfig,
}

/// Links and joints.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodiesConfig {
    /// Substeps in a tick of 2 ms; 1 to 1000.
    pub substeps: u32,
    /// Rapier's solver iterations in a substep; 1 to 100.
    pub solver_iterations: usize,
    /// Viscous friction of the joints in N m s/rad; 0 to 100.
    pub joint_damping_nms_per_rad: [f64; 5],
    /// Inertia that turns with a joint beside its link in kg m2; 0 to 10.
    pub joint_armature_kg_m2: [f64; 5],
    /// Friction coefficient between plate and box; 0 to 10.
    pub wall_friction: f64,
}

/// Inner faces of the box, in the base frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BoxConfig {
    /// Walls across x in m; -10 to 10, rising.
    pub x_m: [f64; 2],
    /// Walls across y in m; -10 to 10, rising.
    pub y_m: [f64; 2],
    /// Floor in m; -10 to 10.
    pub floor_z_m: f64,
    /// Upper edge of the walls in m; above the floor.
    pub top_z_m: f64,
}

/// Motors and gears, by motor coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DrivesConfig {
    /// Inertia of rotor and gears in kg m2; above 0, at most 100.
    pub rotor_inertia_kg_m2: [f64; 5],
    /// Free play, end to end, in degrees; 0 to 20.
    pub free_play_deg: [f64; 5],
    /// Stiffness of gears and cables in N m/rad; above 0, at most 1e5.
    pub stiffness_nm_per_rad: [f64; 5],
    /// Damping of engaged gears and cables in N m s/rad; 0 to 1000.
    pub damping_nms_per_rad: [f64; 5],
    /// Dry friction on the rotor in N m; 0 to 100.
    pub friction_nm: [f64; 5],
    /// Dry friction as a share of the torque that the gears carry; 0 to 10.
    pub load_friction: [f64; 5],
    /// Viscous friction on the rotor in N m s/rad; 0 to 100.
    pub viscous_nms_per_rad: [f64; 5],
    /// Dry friction of a rotor at rest over that of one that turns (Stribeck); 1 to 3. Left out: 1, Coulomb's friction.
    #[serde(default = "one")]
    pub breakaway: f64,
    /// Speed in rad/s at which what friction at rest is above sliding friction has fallen to 1/e; 1e-4 to 10. Left out: 0.01.
    #[serde(default = "stribeck_rad_s")]
    pub stribeck_rad_s: f64,
}

const fn one() -> f64 {
    1.0
}

const fn stribeck_rad_s() -> f64 {
    0.01
}

/// Encoders, in motor coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EncodersConfig {
    /// Counts in one turn of each motor coordinate; 1 to 1e9, or negative.
    pub motor_counts_per_turn: [f64; 5],
    /// Counts in one turn of each external encoder; 1 to 1e9, or negative.
    pub external_counts_per_turn: [f64; 5],
    /// On the joint, behind backlash and stretch; else behind the backlash only.
    pub external_on_joint: [bool; 5],
    /// Counts of the motor encoders at the stops.
    pub motor_offset_counts: [i32; 5],
    /// Counts of the external encoders at the stops.
    pub external_offset_counts: [i32; 5],
}

/// The force sensor. Six channels: force along x, y, z, moments about them, in the frame `ft_sensor`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceSensorConfig {
    /// Range along x and y in N; above 0, at most 1e5. A reading stays at the end of the range and reports an overload.
    pub shear_range_n: f64,
    /// Range along z in N; above 0, at most 1e5.
    pub normal_range_n: f64,
    /// Range of the moments in N m; above 0, at most 1e4.
    pub moment_range_nm: f64,
    /// Bits of a channel, from one end of the range to the other; 4 to 32.
    pub bits: u32,
    /// Standard deviation of a force reading in N; 0 to 100.
    pub noise_n: f64,
    /// Standard deviation of a moment reading in N m; 0 to 10.
    pub noise_nm: f64,
    /// Correlation of the noise of two readings that follow each other (an autoregressive process of first order, whose spectrum falls with
    /// frequency); 0 to 0.999. Left out: 0, white noise.
    #[serde(default)]
    pub noise_correlation: f64,
    /// Reading without load in N and N m; within the range.
    pub bias: [f64; 6],
    /// Reading over load; 0.5 to 2.
    pub scale: [f64; 6],
    /// Load along x or y in N that damages the sensor: from then on it reports an overload; at least the range.
    pub overload_shear_n: f64,
    /// The same along z in N.
    pub overload_normal_n: f64,
    /// The same about any axis in N m.
    pub overload_moment_nm: f64,
    /// Mass that the sensor carries in kg, taken in the middle of the plate; 0 to 100. Its weight is sensed.
    pub mass_behind_kg: f64,
}

/// Amplifiers, by motor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AmplifiersConfig {
    /// Current for 1 N m of the motor coordinate in A; above 0, at most 100.
    pub current_a_per_nm: [f64; 5],
    /// Standard deviation of a current reading in A; 0 to 10.
    pub current_noise_a: f64,
    /// Supply in V; 0 to 1000.
    pub supply_v: f64,
    /// Standard deviation of a voltage reading in V; 0 to 100.
    pub supply_noise_v: f64,
}

/// How what is mobilised of the strength across the plate grows with its way. Each begins with the same stiffness and fails after the same way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MobilisationLaw {
    /// Stiffness falls as 1 less a power of what is mobilised: it goes to nothing at failure.
    #[default]
    Power,
    /// A hyperbola (Kondner 1963) that ends at failure while it still rises (the failure ratio of Duncan and Chang 1970).
    Hyperbola,
}

/// How dense soil loses strength after its peak; each loses it over the same way in the mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LossLaw {
    /// What is left to be lost falls exponentially.
    #[default]
    Exponential,
    /// In proportion to the way, until all is lost.
    Linear,
}

/// How friction along the plate is mobilised.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TangentLaw {
    /// A spring that slips.
    #[default]
    Spring,
    /// A hyperbola of the same first stiffness (Clough and Duncan 1971).
    Hyperbola,
}

/// How sand resists, beyond the limit force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GroundConfig {
    /// Where in a bracket the true coefficient lies: 0 lower, 1 upper end.
    pub bracket_fraction: f64,
    /// Cell of the height field in m; 0.002 to 0.1.
    pub cell_m: f64,
    /// Way to failure over depth in the loosest soil; 0.001 to 1.
    pub loose_mobilisation: f64,
    /// The same in the densest soil; 0.001 to 1.
    pub dense_mobilisation: f64,
    /// Tool angle in degrees above which the force bends over gradually; 0 to 180.
    pub gradual_above_deg: f64,
    /// Sharpness of the bend above that angle; 1 to 100.
    pub gradual_exponent: f64,
    /// Sharpness of the bend 10 degrees and more below it; 1 to 100.
    pub drastic_exponent: f64,
    /// What the densest soil loses of its peak; 0 to 0.9.
    pub residual_drop: f64,
    /// Way after the peak over which it is lost, to 1/e, in m; 1e-4 to 1.
    pub residual_way_m: f64,
    /// Elastic way along the plate and sideways in m; 1e-5 to 0.1.
    pub tangent_way_m: f64,
    /// Time in s in which the wedge ahead of the plate follows the inclination of the force; 0 to 10.
    pub wedge_time_s: f64,
    /// Factor on Reissner's N_q for the plate's edge; 0 to 10.
    pub bearing_shape: f64,
    /// Sideways way of the soil for each m of depth, times cos(alpha) / cos(45 deg); -10 to 10.
    pub insertion_drift: f64,
    /// Sideways way of the soil for each m of depth at any angle; -10 to 10.
    pub misalignment_drift: f64,
    /// Damping at a depth of 25.4 mm in N s/m; 0 to 1000.
    pub damping_ns_per_m: f64,
    /// Slant lengths ahead of the plate over which moved soil is heaped; 0.5 to 10.
    pub heap_length: f64,
    /// Share of the moved soil that runs past the plate and is left in windrows beside it; 0 to 0.9. Left out: 0.
    #[serde(default)]
    pub heap_past: f64,
    /// How strength is mobilised across the plate. Left out: `power`.
    #[serde(default)]
    pub mobilisation_law: MobilisationLaw,
    /// How it is lost after the peak. Left out: `exponential`.
    #[serde(default)]
    pub loss_law: LossLaw,
    /// How friction along the plate is mobilised. Left out: `spring`.
    #[serde(default)]
    pub tangent_law: TangentLaw,
}
