use serde::{Deserialize, Serialize};
use soilctl_kinematics::{Joint, MotorTorques};

use crate::estimate::Filters;
use crate::events::EventKind;
use crate::monitor::Monitors;
use crate::sequence::Machine;
use crate::trajectory::{Active, Ring, Setpoint, StrokeRun};
use crate::{Events, Fault, FaultRecord, Finish, Mode, Params, Tuning};

/// Version of [`State`]; a stored state of another version is not to be resumed.
pub const STATE_VERSION: u32 = 6;

/// Everything that a step remembers. Plain data: copied, stored as a key frame and resumed bit for bit.
///
/// It holds no NaN and no infinity, so that text formats keep it too.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// [`STATE_VERSION`] of the program that made it.
    pub version: u32,
    /// Whether there was a tick.
    pub started: bool,
    /// The last tick.
    pub tick: u64,
    /// Whether the arm is driven.
    pub mode: Mode,
    /// The first fault since the last reset.
    pub fault: Option<FaultRecord>,
    /// Faults that were reported since the last reset, one bit each.
    pub reported: u64,
    /// Whether all joints were at their stops.
    pub homed: bool,
    /// The present posture becomes that of the stops at the next tick.
    pub pending_home: bool,
    /// Conversion of the inputs.
    pub filters: Filters,
    /// Counters of the monitors.
    pub monitors: Monitors,
    /// Values changed during the run.
    pub tuning: Tuning,
    /// Trajectories to come.
    pub ring: Ring,
    /// The active trajectory.
    pub active: Option<Active>,
    /// Whether the active trajectory is the hold that fills an empty ring.
    pub idle: bool,
    /// How the last trajectory ended.
    pub last_finish: Option<Finish>,
    /// The last stroke.
    pub last_stroke: StrokeRun,
    /// Where the last touch met something: the tip's place in m (x, y, z) when it began to feel it.
    pub touched_m: [f64; 3],
    /// What was wanted last.
    pub setpoint: Setpoint,
    /// Set while the wanted joints have just become those of the arm: the share of the last torques with which to go on.
    pub rebased: Option<f64>,
    /// Integrals of the servo law in N m.
    pub integral_nm: [f64; 5],
    /// Which joint torques were at their limit: -1, 0 or 1.
    pub saturated: [i8; 5],
    /// Motor torques of the tick before in N m.
    pub motor_torques_nm: [f64; 5],
    /// Sequences.
    pub machine: Machine,
    /// Storage by request.
    pub store_requested: bool,
    /// Whether the last tick was stored.
    pub storing: bool,
    /// Number of the stored segment.
    pub storage_segment: u32,
    /// Height of the soil's surface in m: as set, or as touched last.
    pub surface_z_m: f64,
    /// The walls found: +x, -x, +y, -y, as coordinates of the tip in m.
    pub walls_m: [Option<f64>; 4],
}

impl State {
    /// How far the elbow's motor is ahead of the joint at rest, in rad: the torques of the last tick over the stiffness of the cables.
    pub(crate) fn driven_stretch_rad(&self, params: &Params) -> f64 {
        let torques = params.arm().transmission().joint_torques(&MotorTorques(self.motor_torques_nm));
        params.elbow_rad_per_nm * torques.map_or(0.0, |torques| torques.0[Joint::Elbow.index()])
    }

    /// The state before the first tick: off, not homed.
    #[must_use]
    pub fn new(params: &Params) -> Self {
        let config = params.config();
        Self {
            version: STATE_VERSION,
            started: false,
            tick: 0,
            mode: Mode::Off,
            fault: None,
            reported: 0,
            homed: false,
            pending_home: false,
            filters: Filters::default(),
            monitors: Monitors::default(),
            tuning: Tuning {
                speed_scale: 1.0,
                lead_rate_m_s: config.stroke.lead_rate_m_s,
                accommodate: config.insert.accommodate,
                law: config.stroke.law,
            },
            ring: Ring::default(),
            active: None,
            idle: true,
            last_finish: None,
            last_stroke: StrokeRun::default(),
            touched_m: [0.0; 3],
            setpoint: Setpoint::default(),
            rebased: None,
            integral_nm: [0.0; 5],
            saturated: [0; 5],
            motor_torques_nm: [0.0; 5],
            machine: Machine::new(params),
            store_requested: false,
            storing: false,
            storage_segment: 0,
            surface_z_m: config.site.surface_z_m,
            walls_m: [None; 4],
        }
    }

    /// Goes to the safe state. A kind of fault is reported once until it is reset.
    pub(crate) fn raise(&mut self, events: &mut Events, fault: Fault, index: usize, value: f64, limit: f64) {
        let bit = 1_u64 << (fault as u32 % 64);
        if self.reported & bit == 0 {
            self.reported |= bit;
            // A log that does not know NaN still gets the event.
            let value = if value.is_finite() { value } else { 0.0 };
            events.push(EventKind::Fault(fault), index, value, limit);
            if self.fault.is_none() {
                let index = u16::try_from(index).unwrap_or(u16::MAX);
                self.fault = Some(FaultRecord { fault, index, value, limit, tick: self.tick });
            }
        }
        self.mode = Mode::Fault;
        self.stop();
    }

    /// Forgets motion and sequences; the next torques are zero unless the arm is driven again.
    pub(crate) fn stop(&mut self) {
        self.ring.clear();
        self.active = None;
        self.idle = true;
        self.last_finish = None;
        self.rebased = None;
        self.integral_nm = [0.0; 5];
        self.saturated = [0; 5];
        self.motor_torques_nm = [0.0; 5];
        self.pending_home = false;
        self.filters.bias_left = 0;
        self.monitors.quieten();
        self.machine.abort();
    }
}
