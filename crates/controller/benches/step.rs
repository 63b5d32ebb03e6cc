//! One step of the controller, against the bars of 1 us (median) and 10 us (p99.9) at 500 Hz.
//!
//! Inputs are those of a still arm; the work of a step does not depend on them, but on what the arm does: holding, moving
//! along a line (with the inverse), stroking under stiffness control.

#![allow(clippy::print_stdout, reason = "quantiles stand beside criterion's means")]

use std::hint::black_box;
use std::time::Instant;

use criterion::Criterion;
use soilctl_controller::{Commands, Params, Request, Sensed, State, StrokeLaw, Trajectory, step};
use soilctl_kinematics::{JointAngles, TaskPose};

/// A ready controller and its next inputs.
struct Case {
    params: Params,
    state: State,
    sensed: Sensed,
    commands: Commands,
}

impl Case {
    fn new(trajectory: Option<Trajectory>) -> Self {
        let params = Params::thesis();
        let pose = TaskPose { x_m: 0.4318, y_m: 0.0, z_m: -0.3, n1_rad: 3.2, n2_rad: 0.0 };
        let joints = params.arm().inverse(&pose).unwrap_or(JointAngles([0.0, 1.0, 1.0, 0.0, 1.0]));
        let mut state = State::new(&params);
        (state.homed, state.filters.offset_known) = (true, true);
        let motors = params.arm().transmission().motor_angles(&joints).unwrap_or_default().0;
        let encoders = &params.config().encoders;
        #[allow(clippy::cast_possible_truncation, reason = "a few turns")]
        let counts = |per_turn: [f64; 5]| {
            std::array::from_fn(|i| (motors[i] * per_turn[i] / std::f64::consts::TAU) as i32)
        };
        let sensed = Sensed {
            motor_counts: counts(encoders.motor_counts_per_turn),
            external_counts: counts(encoders.external_counts_per_turn),
            amplifier_voltage_v: [48.0; 5],
            ..Sensed::default()
        };
        let mut case = Self { params, state, sensed, commands: Commands::default() };
        case.run(Some(Request::Enable));
        if let Some(trajectory) = trajectory {
            case.run(Some(Request::Push(trajectory)));
        }
        case
    }

    fn next(&mut self) {
        self.sensed.tick += 1;
        let sequence = self.sensed.motor_sequence.wrapping_add(1);
        self.sensed.motor_sequence = sequence;
        self.sensed.external_sequence = sequence;
        self.sensed.wrench_sequence = sequence;
        self.sensed.amplifier_sequence = sequence;
        self.sensed.wrench = [0.6 + 1e-6 * f64::from(sequence % 1000), 0.0, 1.5, 0.0, 0.0, 0.0];
        self.sensed.amplifier_current_a = std::array::from_fn(|i| {
            self.state.motor_torques_nm[i] * self.params.config().motors.current_a_per_nm[i]
        });
        self.commands.heartbeat = sequence;
    }

    fn run(&mut self, request: Option<Request>) {
        self.next();
        self.commands.request = request;
        black_box(step(&self.params, &mut self.state, &self.sensed, &self.commands));
        self.commands.request = None;
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let target = TaskPose { x_m: 0.35, y_m: 0.1, z_m: -0.1, n1_rad: 3.1, n2_rad: 0.0 };
    let cases = [
        ("hold", None),
        ("move along a line", Some(Trajectory::CartesianMove { target })),
        ("stroke", Some(Trajectory::Stroke { law: StrokeLaw::Force, delta_rad: 0.4 })),
    ];
    let mut group = criterion.benchmark_group("step");
    for (name, trajectory) in cases {
        // The same tick again and again: a copy of the state is part of the time.
        let mut case = Case::new(trajectory);
        for _ in 0..100 {
            case.run(None);
        }
        case.next();
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut state = case.state;
                step(&case.params, &mut state, black_box(&case.sensed), &case.commands)
            });
        });

        // Quantiles over consecutive ticks; the clock's own time is part of it.
        let mut times = Vec::with_capacity(200_000);
        let mut case = Case::new(trajectory);
        let mut restarts = 0;
        while times.len() < 200_000 {
            if case.state.idle && trajectory.is_some() || case.state.fault.is_some() {
                case = Case::new(trajectory);
                case.run(None);
                restarts += 1;
            }
            case.next();
            let start = Instant::now();
            black_box(step(&case.params, &mut case.state, black_box(&case.sensed), &case.commands));
            times.push(start.elapsed().as_nanos());
        }
        times.sort_unstable();
        let (median, high) = (times[times.len() / 2], times[times.len() * 999 / 1000]);
        println!(
            "{name}: median {median} ns, p99.9 {high} ns over {} steps, {restarts} restarts",
            times.len()
        );
    }
    group.finish();
    criterion.final_summary();
}
