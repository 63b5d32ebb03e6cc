//! The simulated arm, stroke by stroke, in ground that keeps its furrows and heaps, and what each stroke takes of the motors.

use soilctl_campaign::Plan;
use soilctl_controller::{EventKind, Request, SequenceId, StrokeSpec, TICK_S, Trajectory, TrajectoryKind};
use soilctl_kinematics::{JointTorques, MotorTorques, TaskPose, Transmission};
use soilctl_plant::{Simulation, Tick};

use crate::DiggingError;

/// Ticks that one stroke may take with everything around it: 4 minutes.
const MOST_TICKS: u32 = 120_000;
/// Ticks over which a torque is averaged before its peak is taken: 0.1 s, in which gears and cables ring.
const MEAN_TICKS: usize = 50;
/// Every so many ticks a sample is kept.
const SAMPLE_TICKS: u64 = 5;

/// One sample of a stroke, by the controller's sensors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Time in s.
    pub time_s: f64,
    /// Way of the plate towards the base since the stroke began in m.
    pub travel_m: f64,
    /// Height of the lower edge in m.
    pub z_m: f64,
    /// In-plane force of the soil on the plate in N.
    pub force_n: f64,
    /// Its angle to the plate's normal in rad, positive where the plate presses down.
    pub inclination_rad: f64,
}

/// What a stroke did, from the insertion to its end: what was wanted of the motors, and what became of the soil in truth.
///
/// To the insertion belongs what a stroke begins with: taking back the force that pressed the plate in, until the lead grows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Dug {
    /// Whether it was made to its end, pulled out again.
    pub done: bool,
    /// Why not, in words.
    pub failure: Option<String>,
    /// Way of the plate towards the base in m.
    pub travel_m: f64,
    /// Height of the surface where the plate went in, in m.
    pub surface_z_m: f64,
    /// Depth below it at the end of the insertion and at the end of the stroke in m.
    pub depth_m: [f64; 2],
    /// Soil that the plate has swept: its width times the depth along its way, in m3.
    pub swept_m3: f64,
    /// Greatest force of the soil on the plate in the stroke in N.
    pub peak_force_n: f64,
    /// Greatest share of a joint's or motor's torque limit in insertion and stroke, of means over 0.1 s.
    pub peak_share: [f64; 2],
    /// Greatest torque of each joint in insertion and stroke in N m, of means over 0.1 s.
    pub peak_torque_nm: [[f64; 5]; 2],
    /// Mechanical work of the motors in insertion and stroke in J, none given back.
    pub work_j: [f64; 2],
    /// Work done on the soil in insertion and stroke in J.
    pub soil_work_j: [f64; 2],
    /// Current squared times time of all motors in insertion and stroke in A2 s: heat for each ohm of winding.
    pub heat_a2s: [f64; 2],
    /// Time of insertion and stroke in s.
    pub time_s: [f64; 2],
    /// The stroke by the sensors, from where the lead grows.
    pub samples: Vec<Sample>,
}

/// The simulated arm over its box of soil, switched on.
pub struct Machine {
    simulation: Simulation,
}

impl Machine {
    /// The arm of a plan, parked over freshly prepared soil of one of its batches. The strokes of the plan are not made.
    ///
    /// # Errors
    /// [`DiggingError::Campaign`] if soil and force model do not go together.
    pub fn new(plan: &Plan, seed: u64, batch: usize) -> Result<Self, DiggingError> {
        let mut simulation = plan.simulation(&plan.setup(seed)?, seed, batch)?;
        simulation.tick(Some(Request::Enable), &mut |_| {})?;
        Ok(Self { simulation })
    }

    /// Controller and plant.
    #[must_use]
    pub const fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Goes to a stroke, makes it and pulls out.
    ///
    /// # Errors
    /// [`DiggingError::Plant`] if the simulated arm leaves all bounds. A stroke that fails is told in the answer.
    pub fn stroke(&mut self, spec: &StrokeSpec) -> Result<Dug, DiggingError> {
        self.stroke_watched(spec, &mut |_| {})
    }

    /// The same, with every tick from the touch to the pull-out shown.
    ///
    /// # Errors
    /// As [`Machine::stroke`].
    pub fn stroke_watched(
        &mut self,
        spec: &StrokeSpec,
        observer: &mut dyn FnMut(&Tick<'_>),
    ) -> Result<Dug, DiggingError> {
        self.go_to(spec)?;
        self.simulation.tick(Some(Request::Stroke(*spec)), &mut |_| {})?;
        let width_m = self.simulation.params().arm().config().plate.width_m;
        let mut watch = Watch::new(&self.simulation, width_m);
        let done =
            self.simulation.run_sequence(SequenceId::InsertStrokePullout, MOST_TICKS, &mut |tick| {
                watch.note(&tick);
                observer(&tick);
            })?;
        let mut dug = watch.dug;
        dug.done = done;
        dug.surface_z_m = self.simulation.state().surface_z_m;
        if !done {
            let fault = self.simulation.state().fault;
            dug.failure = Some(fault.map_or_else(
                || "the sequence gave up".to_owned(),
                |record| {
                    format!("fault {:?}: {} against a limit of {}", record.fault, record.value, record.limit)
                },
            ));
            self.recover()?;
        }
        Ok(dug)
    }

    /// As a campaign goes to its strokes: up, across in the joints, down to where the touch begins.
    fn go_to(&mut self, spec: &StrokeSpec) -> Result<(), DiggingError> {
        let params = self.simulation.params();
        let site = params.config().site;
        let transit_m = site.surface_z_m + site.transit_m;
        let pose = self.simulation.outputs().telemetry.pose;
        let target = params.arm().inverse(&spec.pose(transit_m))?;
        if pose.z_m < transit_m - 1e-3 {
            self.make(Trajectory::CartesianMove { target: TaskPose { z_m: transit_m, ..pose } })?;
        }
        self.make(Trajectory::JointMove { target })?;
        self.make(Trajectory::CartesianMove { target: spec.pose(site.surface_z_m + site.clearance_m) })
    }

    fn make(&mut self, trajectory: Trajectory) -> Result<(), DiggingError> {
        let mut request = Some(Request::Push(trajectory));
        let mut ended = false;
        for _ in 0..MOST_TICKS {
            self.simulation.tick(request.take(), &mut |tick| {
                ended |= tick.outputs.events.as_slice().iter().any(|event| {
                    matches!(
                        event.kind,
                        EventKind::TrajectoryEnded(..) | EventKind::Fault(_) | EventKind::Refused(_)
                    )
                });
            })?;
            if ended {
                break;
            }
        }
        Ok(())
    }

    /// Out of the safe state after a fault, and up.
    fn recover(&mut self) -> Result<(), DiggingError> {
        if self.simulation.state().fault.is_some() {
            for request in [Request::Reset, Request::Enable] {
                self.simulation.tick(Some(request), &mut |_| {})?;
            }
        }
        Ok(())
    }
}

/// Sums up the ticks of a stroke.
struct Watch {
    dug: Dug,
    width_m: f64,
    limits_nm: [f64; 10],
    /// The last torques of joints and motors in N m, and their sums.
    window: Vec<[f64; 10]>,
    sums: [f64; 10],
    next: usize,
    start_radius_m: Option<f64>,
    sensed_radius_m: Option<f64>,
    last: Option<[f64; 3]>,
    transmission: Transmission,
    phase: usize,
    first_lead_m: f64,
}

impl Watch {
    fn new(simulation: &Simulation, width_m: f64) -> Self {
        let params = simulation.params();
        let joints = params.arm().config().joints.all().map(|joint| joint.max_torque_nm);
        let motors = params.config().motors.max_torque_nm;
        Self {
            dug: Dug::default(),
            width_m,
            limits_nm: std::array::from_fn(|i| if i < 5 { joints[i] } else { motors[i - 5] }),
            window: Vec::with_capacity(MEAN_TICKS),
            sums: [0.0; 10],
            next: 0,
            start_radius_m: None,
            sensed_radius_m: None,
            last: None,
            transmission: *params.arm().transmission(),
            phase: 0,
            first_lead_m: params.config().stroke.initial_lead_m,
        }
    }

    fn note(&mut self, tick: &Tick<'_>) {
        let telemetry = &tick.outputs.telemetry;
        let phase = match telemetry.trajectory {
            Some(TrajectoryKind::Insert) => 0,
            Some(TrajectoryKind::Stroke) => usize::from(telemetry.lead_m > self.first_lead_m),
            _ => {
                self.last = None;
                return;
            }
        };
        let motors = tick.outputs.motor_torques;
        let rates = self.transmission.motor_velocities(&tick.truth.joint_rates).unwrap_or_default();
        let power: f64 = motors.0.iter().zip(rates.0).map(|(torque, rate)| (torque * rate).max(0.0)).sum();
        let current: f64 = tick.outputs.motor_currents_a.iter().map(|current| current * current).sum();
        let dug = &mut self.dug;
        dug.work_j[phase] += power * TICK_S;
        dug.heat_a2s[phase] += current * TICK_S;
        dug.time_s[phase] += TICK_S;
        let tip = tick.truth.tip_m;
        let soil = &tick.truth.soil;
        if let Some(last) = self.last {
            let done: f64 = (0..3).map(|i| -soil.force_n[i] * (tip[i] - last[i])).sum();
            dug.soil_work_j[phase] += done;
        }
        if phase == 0 {
            dug.depth_m[0] = soil.depth_m;
        }
        self.peaks(motors, phase);
        if telemetry.trajectory == Some(TrajectoryKind::Stroke) {
            self.stroke(tick, phase, libm::hypot(tip[0], tip[1]));
        }
        self.last = Some(tip);
    }

    fn peaks(&mut self, motors: MotorTorques, phase: usize) {
        let joints = self.transmission.joint_torques(&motors).unwrap_or(JointTorques([0.0; 5])).0;
        let both: [f64; 10] = std::array::from_fn(|i| if i < 5 { joints[i] } else { motors.0[i - 5] });
        if phase != self.phase {
            // Each phase by itself.
            self.window.clear();
            (self.sums, self.next, self.phase) = ([0.0; 10], 0, phase);
        }
        if self.window.len() < MEAN_TICKS {
            self.window.push(both);
        } else {
            for (sum, old) in self.sums.iter_mut().zip(self.window[self.next]) {
                *sum -= old;
            }
            self.window[self.next] = both;
            self.next = (self.next + 1) % MEAN_TICKS;
        }
        for (sum, new) in self.sums.iter_mut().zip(both) {
            *sum += new;
        }
        #[allow(clippy::cast_precision_loss, reason = "at most 50")]
        let count = self.window.len() as f64;
        let dug = &mut self.dug;
        for (i, sum) in self.sums.iter().enumerate() {
            let mean = (sum / count).abs();
            dug.peak_share[phase] = dug.peak_share[phase].max(mean / self.limits_nm[i]);
            if i < 5 {
                dug.peak_torque_nm[phase][i] = dug.peak_torque_nm[phase][i].max(mean);
            }
        }
    }

    fn stroke(&mut self, tick: &Tick<'_>, phase: usize, radius_m: f64) {
        let soil = &tick.truth.soil;
        let start = *self.start_radius_m.get_or_insert(radius_m);
        let travel_m = start - radius_m;
        let dug = &mut self.dug;
        dug.swept_m3 += self.width_m * soil.depth_m.max(0.0) * (travel_m - dug.travel_m);
        dug.travel_m = travel_m;
        dug.depth_m[1] = soil.depth_m;
        if phase == 1 {
            dug.peak_force_n = dug.peak_force_n.max(libm::hypot(soil.normal_n, soil.tangent_n));
        }
        if phase == 1 && tick.outputs.tick.is_multiple_of(SAMPLE_TICKS) {
            let telemetry = &tick.outputs.telemetry;
            let [r, _, z] = telemetry.force_rtz_n;
            let pose = &telemetry.pose;
            let radius_m = libm::hypot(pose.x_m, pose.y_m);
            let travel_m = *self.sensed_radius_m.get_or_insert(radius_m) - radius_m;
            let plate_rad = pose.tool_angle_rad() - std::f64::consts::FRAC_PI_2;
            #[allow(clippy::cast_precision_loss, reason = "ticks of minutes")]
            let time_s = tick.outputs.tick as f64 * TICK_S;
            dug.samples.push(Sample {
                time_s,
                travel_m,
                z_m: pose.z_m,
                force_n: libm::hypot(r, z),
                inclination_rad: libm::atan2(z, r) - plate_rad,
            });
        }
    }
}
