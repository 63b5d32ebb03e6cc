use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_controller::TICK_S;
use soilctl_kinematics::{JointAngles, TaskPose};
use soilctl_session::messages::ControllerStep;

/// How things are in one tick. Angles in degrees, otherwise SI units; base frame.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StateMessage {
    /// The tick.
    pub tick: u64,
    /// Its time in s.
    pub time_s: f64,
    /// `off`, `ready` or `fault`.
    pub mode: String,
    /// Whether all joints were at their stops.
    pub homed: bool,
    /// Whether simulated time stands still until there is something to do.
    pub paused: bool,
    /// Whether a sequence waits for `continue`.
    pub waiting: bool,
    /// The innermost sequence that runs, or null.
    pub sequence: Option<String>,
    /// Its step.
    pub sequence_step: u8,
    /// Kind of the active trajectory, or null.
    pub trajectory: Option<String>,
    /// Joints by the external encoders.
    pub joints_deg: [f64; 5],
    /// Joint speeds by the motor encoders in degrees a second.
    pub joint_rates_deg_s: [f64; 5],
    /// Wanted joints.
    pub desired_joints_deg: [f64; 5],
    /// Joint torques before the transmission in N m.
    pub joint_torques_nm: [f64; 5],
    /// The plate; null before homing.
    pub plate: Option<Pose>,
    /// Force of the soil on the plate along r, t, z.
    pub force_rtz_n: [f64; 3],
    /// Angle between the force and the plate's normal, in a stroke.
    pub friction_angle_deg: Option<f64>,
    /// Its set-point.
    pub friction_setpoint_deg: Option<f64>,
    /// Way of the plate towards the base in a stroke, in m.
    pub displacement_m: Option<f64>,
    /// Wanted lead in m, in a stroke.
    pub lead_m: Option<f64>,
    /// Its inclination below the horizontal.
    pub lead_inclination_deg: Option<f64>,
    /// Largest force at the present angle that the soil bears without failing, if that is known.
    pub safe_force_n: Option<f64>,
    /// The first fault since the last reset.
    pub fault: Option<FaultState>,
    /// Whether this tick is stored.
    pub storing: bool,
    /// Number of the stored segment.
    pub storage_segment: u32,
    /// The hand that leads the plate, or null.
    #[serde(default)]
    pub led: Option<LedState>,
    /// By how much a session in real time has fallen behind the clock since it began, because ticks came too late, in s.
    #[serde(default)]
    pub behind_s: f64,
    /// What was lost on the way since the session began.
    pub dropped: Dropped,
}

/// A hand that leads the plate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LedState {
    /// Whose.
    pub hand: u32,
    /// Where it is.
    pub x_m: f64,
    /// Where it is.
    pub y_m: f64,
    /// Where it is.
    pub z_m: f64,
    /// The tool angle that it wants.
    pub tool_angle_deg: f64,
    /// What holds the arm back: `none`, `reach`, `force` or `torque`.
    pub limit: String,
    /// The larger of force and torque as a share of what is allowed.
    pub load: f64,
}

/// Pose of the plate's lower edge.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[allow(missing_docs, reason = "the names say it")]
pub struct Pose {
    pub x_m: f64,
    pub y_m: f64,
    pub z_m: f64,
    /// Tool angle of a plate that strokes towards the base.
    pub tool_angle_deg: f64,
    /// Lean out of the vertical plane.
    pub lean_deg: f64,
}

/// A fault.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FaultState {
    /// Which limit.
    pub kind: String,
    /// Joint, motor or channel.
    pub index: u16,
    /// The value found.
    pub value: f64,
    /// The limit.
    pub limit: f64,
    /// The tick.
    pub tick: u64,
}

/// Counts of what was lost.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Dropped {
    /// Steps that are not in the log.
    pub log_steps: u64,
    /// States that the server did not take in time.
    pub states: u64,
    /// Events that it did not take in time.
    pub events: u64,
    /// Messages that this client did not take in time.
    pub messages: u64,
}

/// What a state shows and a single step does not tell. Feed it every step, or fill it from the controller's memory.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Memory {
    /// Whether the arm is homed.
    pub homed: bool,
    /// Whether a sequence waits.
    pub waiting: bool,
    /// The fault.
    pub fault: Option<FaultState>,
    /// Radius of the plate at the beginning of the stroke in m.
    pub stroke_radius_m: Option<f64>,
}

impl Memory {
    /// Takes in a step.
    pub fn step(&mut self, step: &ControllerStep) {
        for event in &step.events {
            match event.kind.split_once('/') {
                Some(("fault", kind)) if self.fault.is_none() => {
                    self.fault = Some(FaultState {
                        kind: kind.to_owned(),
                        index: event.index,
                        value: event.value,
                        limit: event.limit,
                        tick: step.tick,
                    });
                    self.waiting = false;
                }
                _ if event.kind == "reset" => self.fault = None,
                _ if event.kind == "homed" => self.homed = true,
                _ if event.kind == "waiting" => self.waiting = true,
                Some(("sequence_step" | "sequence_failed" | "sequence_succeeded", _)) => self.waiting = false,
                _ => {}
            }
        }
        if step.sequence.is_empty() {
            self.waiting = false;
        }
        // Logs of an arm that was homed before they began: only a homed arm has a pose.
        self.homed |= step.pose.iter().any(|number| *number != 0.0);
        self.stroke_radius_m =
            (step.trajectory == "stroke").then(|| self.stroke_radius_m.unwrap_or_else(|| radius_m(step)));
    }
}

fn radius_m(step: &ControllerStep) -> f64 {
    let [x, y, ..] = step.pose;
    x.hypot(y)
}

/// Time of a tick in s.
#[allow(clippy::cast_precision_loss, reason = "exact for 500 000 years")]
pub(crate) fn seconds(tick: u64) -> f64 {
    tick as f64 * TICK_S
}

fn name(text: &str) -> Option<String> {
    (!text.is_empty()).then(|| text.to_owned())
}

impl StateMessage {
    /// The state after a step.
    #[must_use]
    pub fn new(step: &ControllerStep, memory: &Memory) -> Self {
        let stroking = step.trajectory == "stroke";
        let in_stroke = |value: f64| stroking.then_some(value);
        let [x_m, y_m, z_m, n1_rad, n2_rad] = step.pose;
        let pose = TaskPose { x_m, y_m, z_m, n1_rad, n2_rad };
        // The plate's normal, like the force, is told by its inclination below the horizontal.
        let plate_rad = pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
        Self {
            tick: step.tick,
            time_s: seconds(step.tick),
            mode: step.mode.clone(),
            homed: memory.homed,
            paused: false,
            waiting: memory.waiting,
            sequence: name(&step.sequence),
            sequence_step: step.sequence_step,
            trajectory: name(&step.trajectory),
            joints_deg: JointAngles(step.external_joints_rad).degrees(),
            joint_rates_deg_s: step.joint_rates_rad_s.map(f64::to_degrees),
            desired_joints_deg: JointAngles(step.desired_joints_rad).degrees(),
            joint_torques_nm: step.joint_torques_nm,
            plate: memory.homed.then(|| Pose {
                x_m,
                y_m,
                z_m,
                tool_angle_deg: pose.tool_angle_rad().to_degrees(),
                lean_deg: n2_rad.to_degrees(),
            }),
            force_rtz_n: step.force_rtz_n,
            friction_angle_deg: in_stroke((step.force_inclination_rad - plate_rad).to_degrees()),
            friction_setpoint_deg: in_stroke((step.desired_inclination_rad - plate_rad).to_degrees()),
            displacement_m: memory.stroke_radius_m.map(|start| start - radius_m(step)),
            lead_m: in_stroke(step.lead_m),
            lead_inclination_deg: in_stroke(step.lead_inclination_rad.to_degrees()),
            safe_force_n: None,
            fault: memory.fault.clone(),
            storing: step.store,
            storage_segment: step.storage_segment,
            led: None,
            behind_s: 0.0,
            dropped: Dropped::default(),
        }
    }
}
