//! A plant for tests, independent of the controller: rigid joints with inertia, friction, weight and stops; counts with
//! real resolution; soil as springs along and across the plate, limited by friction and by failure.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::unwrap_used,
    clippy::cast_possible_truncation,
    clippy::needless_range_loop
)]

use std::f64::consts::TAU;

use soilctl_controller::{Commands, Event, Mode, Outputs, Params, Request, Sensed, SequenceId, State, step};
use soilctl_kinematics::{Arm, JointAngles, MotorTorques, TaskForce};

const SUBSTEPS: usize = 10;
const DT: f64 = 0.002 / SUBSTEPS as f64;
const INERTIA: [f64; 5] = [0.8, 1.0, 0.3, 0.05, 0.05];
/// Backdrive friction; that of shoulder and elbow is 0.25 and 0.6 lbf at the tip.
const COULOMB: [f64; 5] = [0.4, 0.5, 0.9, 0.2, 2.0];
const VISCOUS: [f64; 5] = [0.5, 0.5, 0.3, 0.05, 0.2];

/// Soil in the arm's plane.
#[derive(Clone, Copy)]
pub struct Soil {
    pub surface_z: f64,
    pub normal_stiffness: f64,
    pub tangent_stiffness: f64,
    pub failure_n: f64,
    pub delta: f64,
    /// Resistance to insertion in N per m of depth.
    pub bearing_per_m: f64,
    /// How far the soil pushes the plate sideways per m of depth.
    pub drift: f64,
    pub entry_r: f64,
    pub anchor_n: f64,
    pub anchor_s: f64,
    pub anchor_t: f64,
    pub inside: bool,
    pub deepest: f64,
    pub normal_force: f64,
    pub tangent_force: f64,
    pub failed: bool,
}

impl Soil {
    pub fn new() -> Self {
        Self {
            surface_z: -0.3302,
            normal_stiffness: 4300.0,
            tangent_stiffness: 4000.0,
            failure_n: 12.0,
            delta: 23f64.to_radians(),
            bearing_per_m: 800.0,
            drift: 0.0,
            entry_r: 0.0,
            anchor_n: 0.0,
            anchor_s: 0.0,
            anchor_t: 0.0,
            inside: false,
            deepest: 0.0,
            normal_force: 0.0,
            tangent_force: 0.0,
            failed: false,
        }
    }

    /// Force on the plate along r, t, z for the tip's place along r, t, z.
    fn force(&mut self, [r, t, z]: [f64; 3], n1: f64) -> [f64; 3] {
        let depth = self.surface_z - z;
        let (sin, cos) = n1.sin_cos();
        let (normal, up) = ([-cos, sin], [-sin, -cos]);
        if depth <= 0.0 {
            *self = Self { inside: false, deepest: 0.0, normal_force: 0.0, tangent_force: 0.0, ..*self };
            return [0.0; 3];
        }
        if !self.inside {
            *self = Self {
                inside: true,
                failed: false,
                entry_r: r,
                anchor_n: 0.0,
                anchor_s: 0.0,
                anchor_t: t,
                ..*self
            };
        }
        // From where the plate came in, since its pitch changes a little in a stroke.
        let u = (r - self.entry_r) * normal[0] - depth * normal[1];
        let s = (r - self.entry_r) * up[0] - depth * up[1];
        if depth > self.deepest {
            self.anchor_n += self.drift * (depth - self.deepest);
            self.deepest = depth;
        }
        let mut n = self.normal_stiffness * (self.anchor_n - u);
        if n > self.failure_n {
            let slip = (n - self.failure_n) / self.normal_stiffness;
            self.anchor_n -= slip;
            // The failing wedge rises along the plate.
            self.anchor_s += slip;
            self.failed = true;
            n = self.failure_n;
        }
        let friction = self.delta.tan() * n.abs();
        let bearing = self.bearing_per_m * depth;
        let most = if self.failed { friction } else { friction + bearing };
        let free = self.tangent_stiffness * (self.anchor_s - s);
        let tangent = free.clamp(-friction, most);
        self.anchor_s -= (free - tangent) / self.tangent_stiffness;
        (self.normal_force, self.tangent_force) = (n, tangent);
        let side = 4000.0 * (self.anchor_t - t);
        [n * normal[0] + tangent * up[0], side, n * normal[1] + tangent * up[1]]
    }
}

pub struct Plant {
    pub arm: Arm,
    pub q: [f64; 5],
    pub v: [f64; 5],
    pub soil: Option<Soil>,
    /// Walls of the box at +x, -x, +y, -y.
    pub walls: Option<[f64; 4]>,
    pub force_rtz: [f64; 3],
    counts_motor: [f64; 5],
    counts_external: [f64; 5],
    offsets: [i32; 5],
    wrench: [f64; 6],
    pub force_bias: [f64; 6],
    noise: u64,
    tick: u64,
    currents: [f64; 5],
}

impl Plant {
    pub fn new(params: &Params, q: [f64; 5]) -> Self {
        let encoders = &params.config().encoders;
        Self {
            arm: params.arm().clone(),
            q,
            v: [0.0; 5],
            soil: None,
            walls: None,
            force_rtz: [0.0; 3],
            counts_motor: encoders.motor_counts_per_turn,
            counts_external: encoders.external_counts_per_turn,
            offsets: [1000, -77, 31_000, 5, -9999],
            wrench: [0.0; 6],
            force_bias: [0.3, -0.2, 0.5, 0.0, 0.0, 0.0],
            noise: 0x9e37_79b9,
            tick: 0,
            currents: [0.0; 5],
        }
    }

    fn random(&mut self) -> f64 {
        self.noise =
            self.noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.noise >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    }

    pub fn sense(&mut self) -> Sensed {
        self.tick += 1;
        let motors = self.arm.transmission().motor_angles(&JointAngles(self.q)).unwrap().0;
        let count = |i: usize, per_turn: f64| (motors[i] * per_turn / TAU).round() as i32;
        let sequence = self.tick as u32;
        let mut wrench = self.wrench;
        for (reading, bias) in wrench.iter_mut().zip(self.force_bias) {
            *reading += bias;
        }
        for reading in wrench.iter_mut().take(3) {
            *reading += 0.04 * self.random();
        }
        Sensed {
            tick: self.tick,
            motor_counts: std::array::from_fn(|i| count(i, self.counts_motor[i]) + self.offsets[i]),
            motor_sequence: sequence,
            external_counts: std::array::from_fn(|i| count(i, self.counts_external[i]) - self.offsets[i]),
            external_sequence: sequence,
            wrench,
            wrench_sequence: sequence,
            wrench_overload: false,
            amplifier_current_a: self.currents,
            amplifier_voltage_v: [48.0; 5],
            amplifier_sequence: sequence,
        }
    }

    pub fn act(&mut self, outputs: &Outputs) {
        self.currents = outputs.motor_currents_a;
        let torques = if outputs.amplifiers_enabled { outputs.motor_torques } else { MotorTorques([0.0; 5]) };
        let drive = self.arm.transmission().joint_torques(&torques).unwrap().0;
        let (lower, upper) = (self.arm.lower_limits().0, self.arm.upper_limits().0);
        for _ in 0..SUBSTEPS {
            let joints = JointAngles(self.q);
            let weight = self.arm.gravity_torques(&joints).unwrap().0;
            let load = self.load(&joints);
            for i in 0..5 {
                let stop = 3000.0 * ((lower[i] - self.q[i]).max(0.0) - (self.q[i] - upper[i]).max(0.0));
                let damp = if stop == 0.0 { 0.0 } else { 30.0 * self.v[i] };
                let friction = COULOMB[i] * (self.v[i] / 0.004).tanh() + VISCOUS[i] * self.v[i];
                let torque = drive[i] - weight[i] + load[i] + stop - damp - friction;
                self.v[i] += torque / INERTIA[i] * DT;
            }
            for i in 0..5 {
                self.q[i] += self.v[i] * DT;
            }
        }
    }

    /// Joint torques of soil and walls; also sets the wrench.
    fn load(&mut self, joints: &JointAngles) -> [f64; 5] {
        if self.soil.is_none() && self.walls.is_none() {
            return [0.0; 5];
        }
        let pose = self.arm.forward(joints).unwrap();
        let (s, c) = self.q[0].sin_cos();
        let place = [pose.x_m * c + pose.y_m * s, pose.y_m * c - pose.x_m * s, pose.z_m];
        let mut rtz = self.soil.as_mut().map_or([0.0; 3], |soil| soil.force(place, pose.n1_rad));
        if let Some([east, west, north, south]) = self.walls {
            let push = |low: f64, high: f64, x: f64| 5000.0 * ((low - x).max(0.0) - (x - high).max(0.0));
            let (x, y) = (push(west, east, pose.x_m), push(south, north, pose.y_m));
            rtz[0] += x * c + y * s;
            rtz[1] += y * c - x * s;
        }
        self.force_rtz = rtz;
        let [r, t, z] = rtz;
        let world = [r * c - t * s, r * s + t * c, z];
        let frame = self.arm.frames(joints).unwrap().ft_sensor.rotation;
        for i in 0..3 {
            self.wrench[i] = (0..3).map(|k| frame[k][i] * world[k]).sum();
        }
        let force = TaskForce([world[0], world[1], world[2], 0.0, 0.0]);
        self.arm.jacobian(joints).unwrap().joint_torques(&force).unwrap().0
    }
}

/// Plant and controller together.
pub struct Rig {
    pub params: Params,
    pub state: State,
    pub plant: Plant,
    pub outputs: Outputs,
    pub events: Vec<(u64, Event)>,
    heartbeat: u32,
}

impl Rig {
    pub fn new(params: Params, q: [f64; 5]) -> Self {
        let (state, plant) = (State::new(&params), Plant::new(&params, q));
        Self { params, state, plant, outputs: Outputs::default(), events: Vec::new(), heartbeat: 0 }
    }

    /// Switched on at these joints, as if homed there.
    pub fn homed(params: Params, q: JointAngles) -> Self {
        let mut rig = Self::new(params, q.0);
        let mut at_home = Plant::new(&rig.params, rig.plant.arm.transmission().home().0);
        let zero = at_home.sense();
        rig.state.homed = true;
        rig.state.filters.offset_known = true;
        rig.state.filters.motor_zero = zero.motor_counts;
        rig.state.filters.external_zero = zero.external_counts;
        rig.request(Request::Enable);
        assert_eq!(rig.state.mode, Mode::Ready, "{:?}", rig.state.fault);
        rig
    }

    pub fn commands(&mut self) -> Commands {
        self.heartbeat += 1;
        Commands { heartbeat: self.heartbeat, ..Commands::default() }
    }

    pub fn tick_with(&mut self, sensed: &Sensed, commands: &Commands) -> Outputs {
        let outputs = step(&self.params, &mut self.state, sensed, commands);
        self.plant.act(&outputs);
        self.events.extend(outputs.events.as_slice().iter().map(|event| (outputs.tick, *event)));
        self.outputs = outputs;
        outputs
    }

    pub fn request(&mut self, request: Request) -> Outputs {
        let (sensed, mut commands) = (self.plant.sense(), self.commands());
        commands.request = Some(request);
        self.tick_with(&sensed, &commands)
    }

    pub fn tick(&mut self) -> Outputs {
        let (sensed, commands) = (self.plant.sense(), self.commands());
        self.tick_with(&sensed, &commands)
    }

    pub fn run(&mut self, ticks: usize) {
        for _ in 0..ticks {
            self.tick();
        }
    }

    /// Until nothing moves and no sequence runs; panics after `most` ticks.
    pub fn settle(&mut self, most: usize) {
        for _ in 0..most {
            self.tick();
            if self.state.mode != Mode::Ready {
                panic!("{:?} {:?}", self.state.fault, self.events);
            }
            if self.state.idle && !self.state.machine.is_running() {
                return;
            }
        }
        panic!("not done after {most} ticks: {:?} {:?}", self.state.machine.top(), self.state.active);
    }

    pub fn run_sequence(&mut self, sequence: SequenceId, most: usize) {
        self.request(Request::Start(sequence));
        self.settle(most);
    }

    pub fn has(&self, wanted: impl Fn(&Event) -> bool) -> bool {
        self.events.iter().any(|(_, event)| wanted(event))
    }

    pub fn find(&self, wanted: impl Fn(&Event) -> bool) -> Option<Event> {
        self.events.iter().map(|(_, event)| *event).find(wanted)
    }
}
