use serde::{Deserialize, Serialize};
use soilctl_controller::{Commands, Event, Outputs, Sensed, Telemetry};
use soilctl_kinematics::TaskPose;

use super::{request, word};

/// `soilctl_msgs/msg/ControllerStep`: all that went into one step of the controller and all that came out, bit for bit.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[allow(
    missing_docs,
    reason = "the fields are those of Sensed, Commands, Outputs and Telemetry, which document them"
)]
pub struct ControllerStep {
    /// Number of the call since the log began, from 0; a gap means that steps were not logged.
    pub step: u64,
    pub tick: u64,
    pub sensed_tick: u64,
    pub motor_counts: [i32; 5],
    pub motor_sequence: u32,
    pub external_counts: [i32; 5],
    pub external_sequence: u32,
    pub wrench: [f64; 6],
    pub wrench_sequence: u32,
    pub wrench_overload: bool,
    pub amplifier_current_a: [f64; 5],
    pub amplifier_voltage_v: [f64; 5],
    pub amplifier_sequence: u32,
    pub heartbeat: u32,
    pub emergency_stop: bool,
    /// Name of the request, empty if there is none.
    pub request: String,
    /// Numbers of the request, in SI units and rad.
    pub request_numbers: Vec<f64>,
    pub mode: String,
    pub amplifiers_enabled: bool,
    pub motor_torques_nm: [f64; 5],
    pub motor_currents_a: [f64; 5],
    pub store: bool,
    pub storage_segment: u32,
    pub events: Vec<EventMessage>,
    pub events_dropped: u32,
    pub motor_joints_rad: [f64; 5],
    pub external_joints_rad: [f64; 5],
    pub joint_rates_rad_s: [f64; 5],
    /// x, y, z in m, n1, n2 in rad.
    pub pose: [f64; 5],
    pub force_rtz_n: [f64; 3],
    pub desired_joints_rad: [f64; 5],
    pub desired_position_m: [f64; 3],
    pub joint_torques_nm: [f64; 5],
    pub force_inclination_rad: f64,
    pub desired_inclination_rad: f64,
    pub lead_inclination_rad: f64,
    pub lead_m: f64,
    pub accommodation_m: f64,
    /// Kind of the active trajectory, empty if there is none.
    pub trajectory: String,
    /// The innermost sequence, empty if none runs.
    pub sequence: String,
    pub sequence_step: u8,
}

/// `soilctl_msgs/msg/Event`.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct EventMessage {
    /// What happened, for example `fault/tip_force`.
    pub kind: String,
    /// Joint, motor, channel, step or stroke; 0 if none.
    pub index: u16,
    /// The number behind it.
    pub value: f64,
    /// Its limit, or 0.
    pub limit: f64,
}

impl From<&Event> for EventMessage {
    fn from(event: &Event) -> Self {
        let Event { kind, index, value, limit } = *event;
        Self { kind: word(&kind), index, value, limit }
    }
}

impl ControllerStep {
    /// The message of a step.
    #[must_use]
    pub fn new(step: u64, sensed: &Sensed, commands: &Commands, outputs: &Outputs) -> Self {
        // Taken apart by name, so that a field that is added cannot be forgotten here.
        let Sensed {
            tick: sensed_tick,
            motor_counts,
            motor_sequence,
            external_counts,
            external_sequence,
            wrench,
            wrench_sequence,
            wrench_overload,
            amplifier_current_a,
            amplifier_voltage_v,
            amplifier_sequence,
        } = *sensed;
        let Commands { heartbeat, emergency_stop, request } = commands;
        let (request, request_numbers) = request::encode(request.as_ref());
        let Outputs {
            tick,
            mode,
            amplifiers_enabled,
            motor_torques,
            motor_currents_a,
            store,
            storage_segment,
            events,
            telemetry,
        } = outputs;
        let Telemetry {
            motor_joints,
            external_joints,
            joint_rates,
            pose: TaskPose { x_m, y_m, z_m, n1_rad, n2_rad },
            force_rtz_n,
            desired_joints,
            desired_position_m,
            joint_torques,
            force_inclination_rad,
            desired_inclination_rad,
            lead_inclination_rad,
            lead_m,
            accommodation_m,
            trajectory,
            sequence,
        } = *telemetry;
        Self {
            step,
            tick: *tick,
            sensed_tick,
            motor_counts,
            motor_sequence,
            external_counts,
            external_sequence,
            wrench,
            wrench_sequence,
            wrench_overload,
            amplifier_current_a,
            amplifier_voltage_v,
            amplifier_sequence,
            heartbeat: *heartbeat,
            emergency_stop: *emergency_stop,
            request,
            request_numbers,
            mode: word(mode),
            amplifiers_enabled: *amplifiers_enabled,
            motor_torques_nm: motor_torques.0,
            motor_currents_a: *motor_currents_a,
            store: *store,
            storage_segment: *storage_segment,
            events: events.as_slice().iter().map(EventMessage::from).collect(),
            events_dropped: events.dropped(),
            motor_joints_rad: motor_joints.0,
            external_joints_rad: external_joints.0,
            joint_rates_rad_s: joint_rates.0,
            pose: [x_m, y_m, z_m, n1_rad, n2_rad],
            force_rtz_n,
            desired_joints_rad: desired_joints.0,
            desired_position_m,
            joint_torques_nm: joint_torques.0,
            force_inclination_rad,
            desired_inclination_rad,
            lead_inclination_rad,
            lead_m,
            accommodation_m,
            trajectory: trajectory.as_ref().map(word).unwrap_or_default(),
            sequence: sequence.map(|(sequence, _)| word(&sequence)).unwrap_or_default(),
            sequence_step: sequence.map_or(0, |(_, step)| step),
        }
    }

    /// What the hardware reported.
    #[must_use]
    pub fn sensed(&self) -> Sensed {
        Sensed {
            tick: self.sensed_tick,
            motor_counts: self.motor_counts,
            motor_sequence: self.motor_sequence,
            external_counts: self.external_counts,
            external_sequence: self.external_sequence,
            wrench: self.wrench,
            wrench_sequence: self.wrench_sequence,
            wrench_overload: self.wrench_overload,
            amplifier_current_a: self.amplifier_current_a,
            amplifier_voltage_v: self.amplifier_voltage_v,
            amplifier_sequence: self.amplifier_sequence,
        }
    }

    /// What the operator's side wanted.
    ///
    /// # Errors
    /// In words, if the request is none of the controller's.
    pub fn commands(&self) -> Result<Commands, String> {
        let request = request::decode(&self.request, &self.request_numbers)?;
        Ok(Commands { heartbeat: self.heartbeat, emergency_stop: self.emergency_stop, request })
    }
}

/// `soilctl_msgs/msg/Keyframe`: the complete state of the controller before a step.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Keyframe {
    /// Version of this message and of the encoding of `state`.
    pub version: u32,
    /// Number of the key frame, from 0.
    pub number: u32,
    /// Number of the step that follows.
    pub step: u64,
    /// The state.
    pub state: Vec<u8>,
}

impl SoilTruth {
    /// The message in these bytes, also one of an early log, which ends with the force: what that lacks is not a number, and
    /// not failing.
    ///
    /// # Errors
    /// In words what is wrong with it.
    pub fn read(bytes: &[u8]) -> Result<Self, String> {
        #[derive(Deserialize)]
        struct Early {
            depth_m: f64,
            limit_force_n: f64,
            force_rtz_n: [f64; 3],
        }
        super::decode(bytes).or_else(|problem: String| {
            let Early { depth_m, limit_force_n, force_rtz_n } = super::decode(bytes).map_err(|_| problem)?;
            Ok(Self {
                depth_m,
                limit_force_n,
                force_rtz_n,
                limit_force_now_n: f64::NAN,
                mobilisation: f64::NAN,
                failing: false,
            })
        })
    }
}

/// `soilctl_msgs/msg/SoilTruth`: what a simulated soil knows and nobody measures.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SoilTruth {
    /// Depth of the plate's lower edge below the surface in m, negative above it.
    pub depth_m: f64,
    /// Force at which the soil would fail now in N, at full friction on the plate; 0 outside the soil.
    pub limit_force_n: f64,
    /// Force of the soil on the plate along r, t, z in N.
    pub force_rtz_n: [f64; 3],
    /// Force at which the soil would fail now in N, with the present force along the plate.
    pub limit_force_now_n: f64,
    /// Share of the failure force that is mobilised, -1 to 1.
    pub mobilisation: f64,
    /// Whether the soil fails in this step.
    pub failing: bool,
}
