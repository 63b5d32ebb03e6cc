//! The settings file: what a person writes and [`Params`](crate::Params) checks.

use serde::{Deserialize, Serialize};

/// Settings as they stand in a TOML file. Unknown keys are refused. Lists of five go by joint or motor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ControllerConfig {
    /// Version of the format: 1.
    pub version: u32,
    /// Encoders and their filters.
    pub encoders: Encoders,
    /// The force sensor.
    pub force_sensor: ForceSensor,
    /// Gains of the servo laws.
    pub gains: Gains,
    /// Amplifiers and motors.
    pub motors: Motors,
    /// Speeds of moves.
    pub moves: Moves,
    /// Moves that end at a contact.
    pub touch: Touch,
    /// Insertion of the plate.
    pub insert: Insert,
    /// Strokes.
    pub stroke: Stroke,
    /// Where the sequences work.
    pub site: Site,
    /// The friction sweep.
    pub sweep: Sweep,
    /// How the arm follows a hand. Settings from before it did may leave it out: those of `data/controller/default.toml` count then.
    #[serde(default = "default_hand")]
    pub hand: Hand,
    /// Limits that lead to the safe state.
    pub safety: Safety,
}

/// Encoders and their filters. Corner frequencies are 0.1 to 240 Hz.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Encoders {
    /// Counts in one turn of each motor coordinate; 1 to 1e9, negative if it counts backwards.
    pub motor_counts_per_turn: [f64; 5],
    /// Counts in one turn of each external encoder, in the same coordinates as the motors.
    pub external_counts_per_turn: [f64; 5],
    /// Corner of the motor encoders' low-pass in Hz.
    pub motor_filter_hz: f64,
    /// Corner of the external encoders' low-pass in Hz.
    pub external_filter_hz: f64,
    /// Corner of the velocity's low-pass in Hz.
    pub velocity_filter_hz: f64,
}

/// The force sensor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceSensor {
    /// Corner of the low-pass in Hz, 0.1 to 240.
    pub filter_hz: f64,
    /// Ticks over which the bias is averaged, 1 to 5000.
    pub bias_ticks: u32,
    /// Range of the sensor's x and y axes in N; above 0.
    pub shear_range_n: f64,
    /// Range of the sensor's z axis in N; above 0.
    pub normal_range_n: f64,
    /// Range of the moments in N m; above 0.
    pub moment_range_nm: f64,
}

/// Gains; all 0 to 1e5.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gains {
    /// Eq. 3.1, proportional gain on the motor encoders in N m/rad.
    pub motor_p_nm_per_rad: [f64; 5],
    /// Eqs 3.1 and 3.2, damping on the motor encoders in N m s/rad.
    pub motor_d_nms_per_rad: [f64; 5],
    /// Eq. 3.1, proportional gain on the external encoders in N m/rad.
    pub external_p_nm_per_rad: [f64; 5],
    /// Eq. 3.1, integral gain on the external encoders in N m/(rad s).
    pub external_i_nm_per_rad_s: [f64; 5],
    /// Largest torque of an integral in N m.
    pub integral_limit_nm: [f64; 5],
    /// Velocity control, proportional gain in N m s/rad.
    pub velocity_p_nms_per_rad: [f64; 5],
    /// Velocity control, integral gain in N m/rad.
    pub velocity_i_nm_per_rad: [f64; 5],
    /// Eq. 3.2, springs along r, t, z in N/m.
    pub stiffness_n_per_m: [f64; 3],
    /// Whether what the counterweights leave of the arm's weight is added.
    pub gravity_compensation: bool,
}

/// Motors and amplifiers, by motor coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Motors {
    /// Amplifier current for 1 N m of the motor coordinate in A; above 0, at most 100.
    pub current_a_per_nm: [f64; 5],
    /// Largest torque in N m; above 0.
    pub max_torque_nm: [f64; 5],
    /// Fastest change of torque in N m/s; above 0.
    pub max_torque_rate_nm_s: [f64; 5],
}

/// Peak speeds of moves; all above 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Moves {
    /// Fastest joint of a joint move in deg/s, at most 360.
    pub joint_speed_deg_s: f64,
    /// Tip of a Cartesian move in m/s, at most 1.
    pub tip_speed_m_s: f64,
    /// Pitch of a Cartesian move in deg/s, at most 360.
    pub pitch_speed_deg_s: f64,
}

/// Moves that end at a contact; all above 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Touch {
    /// Speed of a joint towards its stop in deg/s.
    pub joint_speed_deg_s: [f64; 5],
    /// Tracking error in degrees that means a stop; below `safety.tracking_error_deg`.
    pub joint_error_deg: [f64; 5],
    /// Speed of the tip in m/s.
    pub tip_speed_m_s: f64,
    /// Force against the motion in N that means contact.
    pub tip_force_n: f64,
    /// Ticks for which either must last, 1 to 1000.
    pub confirm_ticks: u32,
    /// Longest way down to the soil in m.
    pub soil_travel_m: f64,
    /// Longest way to a wall in m.
    pub wall_travel_m: f64,
}

/// Insertion (eqs 5.1 to 5.3).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Insert {
    /// Mean speed along the plate in m/s; above 0, at most 0.1.
    pub speed_m_s: f64,
    /// Whether lateral forces are accommodated.
    pub accommodate: bool,
    /// `k_F` in m/s per N; 0 to 1.
    pub gain_m_s_per_n: f64,
    /// Lateral force in N that is left alone; 0 to 100.
    pub dead_zone_n: f64,
    /// Fastest lateral motion in m/s; above 0, at most 0.1.
    pub max_lateral_speed_m_s: f64,
    /// Largest lateral offset in m; 0 to 0.2.
    pub max_lateral_offset_m: f64,
    /// Longest wait at the end for the depth to be reached, in ticks; 0 to 100 000.
    pub settle_ticks: u32,
    /// How much may be missing of the depth in m; above 0, at most 0.1.
    pub depth_tolerance_m: f64,
}

/// The law that turns the lead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StrokeLaw {
    /// Eq. 5.11: keeps the plate's height.
    Position,
    /// Eqs 5.24 to 5.26: keeps the angle of the force.
    Force,
}

/// Strokes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stroke {
    /// The law used by sequences.
    pub law: StrokeLaw,
    /// `l_0` in m; 0 to 0.1.
    pub initial_lead_m: f64,
    /// `l_rate` in m/s; above 0, at most 0.1.
    pub lead_rate_m_s: f64,
    /// Lead in m at which the stroke ends; above `initial_lead_m`, at most 0.2.
    pub max_lead_m: f64,
    /// Way of the plate towards the base in m at which the stroke ends; above 0, at most 0.5.
    pub max_travel_m: f64,
    /// Ticks after which the stroke ends; 1 to 1 000 000.
    pub max_ticks: u32,
    /// `k_pt`, 0 to 100.
    pub force_p: f64,
    /// `k_it / k_pt` in 1/s, 0 to 100.
    pub force_i_per_s: f64,
    /// Proportional gain of eq. 5.11 in rad/m, 0 to 1e5.
    pub position_p_rad_per_m: f64,
    /// Integral gain of eq. 5.11 in rad/(m s), 0 to 1e5.
    pub position_i_rad_per_m_s: f64,
    /// Corner in Hz of a low-pass on the external position that the lead starts from; 0.1 to 240.
    pub position_filter_hz: f64,
    /// Force in N below which its direction is not used; above 0.
    pub least_force_n: f64,
    /// Largest inclination of the lead below the horizontal in degrees, 0 to 90.
    pub upper_bound_deg: f64,
    /// The smallest inclination is plate angle - friction angle + this, in degrees; 0 to 90.
    pub lower_margin_deg: f64,
    /// Way of the plate in m from which on the soil counts as failed; above 0. From then on the lead keeps its inclination, so that a
    /// plate that lifts shows in the angle of the force (section 5.4).
    pub failure_travel_m: f64,
    /// Rise of the force angle at failure in degrees that means lifting; above 0.
    pub lift_deg: f64,
    /// Rise of the plate after the failure in m that means lifting; above 0, at most 0.1.
    pub lift_rise_m: f64,
    /// Forces that the soil bears (section 5.3.3).
    pub safe_force: SafeForceTable,
}

/// Largest safe force against the angle between the force and the plate's normal; both lists have the same length, 0 or 2 to 32.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SafeForceTable {
    /// Angle to the plate's normal in degrees, positive downwards; rising.
    pub angle_deg: Vec<f64>,
    /// Largest safe force in N; above 0.
    pub force_n: Vec<f64>,
}

/// Where the sequences work.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Site {
    /// Expected height of the soil's surface in the base frame in m.
    pub surface_z_m: f64,
    /// Height in m above it at which a touch begins; above 0.
    pub clearance_m: f64,
    /// Height in m above it on the way between strokes; above the clearance.
    pub transit_m: f64,
    /// Posture after homing in degrees, inside the arm's limits.
    pub park_deg: [f64; 5],
}

/// The friction sweep (section 5.4).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// First friction angle in degrees, below the true one; 0 to 60.
    pub first_delta_deg: f64,
    /// Last friction angle in degrees; at least the first, at most 60.
    pub last_delta_deg: f64,
    /// Step in degrees; above 0.
    pub step_deg: f64,
    /// Radius of the strokes in m.
    pub radius_m: f64,
    /// Base angles in degrees that one preparation of the soil has room for; 1 to 16.
    pub base_deg: Vec<f64>,
    /// Tool angle in degrees; 80 to 90, since others mislead (section 5.4).
    pub tool_angle_deg: f64,
    /// Vertical depth in m.
    pub depth_m: f64,
}

/// How the arm follows a hand.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Hand {
    /// Fastest motion of the plate's edge in m/s; above 0, at most 0.5.
    pub speed_m_s: f64,
    /// Fastest change of that motion in m/s2; above 0, at most 20.
    pub acceleration_m_s2: f64,
    /// Fastest turn of the plate in deg/s; above 0, at most 90.
    pub pitch_speed_deg_s: f64,
    /// Fastest change of that turn in deg/s2; above 0, at most 3600.
    pub pitch_acceleration_deg_s2: f64,
    /// Force of the soil in N against which the arm no longer pushes; above 0, below `safety.tip_force_n`.
    pub force_n: f64,
    /// Share of the largest torques above which it no longer pushes; above 0, below 1.
    pub torque_share: f64,
    /// How far from the limits of radius and height in `safety` the edge stays, in m; 0 to 0.1.
    pub margin_m: f64,
    /// Ticks without word from the hand after which the arm stops; 1 to 5000.
    pub lease_ticks: u32,
}

/// Those of the settings that come with the program.
fn default_hand() -> Hand {
    match toml::from_str::<ControllerConfig>(crate::DEFAULT) {
        Ok(settings) => settings.hand,
        // They have the section, as a test sees.
        Err(error) => unreachable!("{error}"),
    }
}

/// Limits. Each that is broken leads to the safe state.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Safety {
    /// Degrees that a joint may lie beyond the arm's limits; 0 to 10.
    pub joint_margin_deg: f64,
    /// Speed limit as a multiple of the arm's; above 0, at most 10.
    pub joint_speed_factor: f64,
    /// Largest wanted minus actual joint angle in degrees; above 0.
    pub tracking_error_deg: [f64; 5],
    /// Largest distance in m from wanted to actual position under stiffness control; above `stroke.max_lead_m`.
    pub stiffness_error_m: f64,
    /// Largest change of a wanted joint angle in one tick in degrees; above 0.
    pub setpoint_step_deg: f64,
    /// Largest difference of motor and external encoders in degrees; above 0.
    pub disagreement_deg: [f64; 5],
    /// Largest force on the plate in N; above 0.
    pub tip_force_n: f64,
    /// Ticks for which a torque may be at its limit; at least 1.
    pub saturated_ticks: u32,
    /// Least and largest radius of the tip in m.
    pub radius_m: [f64; 2],
    /// Least and largest height of the tip in m.
    pub height_m: [f64; 2],
    /// Least and largest base angle of the tip in degrees.
    pub base_deg: [f64; 2],
    /// Ticks without a new motor encoder reading.
    pub motor_encoder_stale_ticks: u32,
    /// Ticks without a new external encoder reading.
    pub external_encoder_stale_ticks: u32,
    /// Ticks without a new force reading.
    pub force_stale_ticks: u32,
    /// Ticks with new force readings of the same bits; 0 switches the check off.
    pub force_frozen_ticks: u32,
    /// Ticks without a new amplifier reading.
    pub amplifier_stale_ticks: u32,
    /// Ticks missed in a row without a fault.
    pub dropped_ticks: u32,
    /// Ticks without a new heartbeat of the operator's side.
    pub heartbeat_ticks: u32,
    /// Largest amplifier current in A, by motor; above 0.
    pub max_current_a: [f64; 5],
    /// Largest difference of measured and commanded current in A; above 0.
    pub current_error_a: f64,
    /// Least and largest supply voltage in V.
    pub supply_voltage_v: [f64; 2],
    /// Ticks for which current or voltage may be out of bounds; at least 1.
    pub amplifier_ticks: u32,
}
