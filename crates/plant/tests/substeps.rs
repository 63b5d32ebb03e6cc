//! The substep against an independent arm: how far the tip is off, and what energy is lost or gained.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod common;

use common::{Reference, distance};
use soilctl_kinematics::{JointAngles, MotorTorques};
use soilctl_plant::config::PlantConfig;
use soilctl_plant::{Drive, Hardware, Plant, PlantParams};

const START_DEG: [f64; 5] = [10.0, 60.0, 60.0, 20.0, 40.0];

fn params(change: impl Fn(&mut PlantConfig)) -> PlantParams {
    let thesis = PlantParams::thesis();
    let mut config = thesis.config().clone();
    change(&mut config);
    PlantParams::new(thesis.arm().clone(), config).unwrap()
}

/// What the comparison cannot have: dry friction and free play make a system whose path is not smooth.
fn smooth(config: &mut PlantConfig) {
    config.drives.friction_nm = [0.0; 5];
    config.drives.load_friction = [0.0; 5];
    config.drives.free_play_deg = [0.0; 5];
}

/// Torques that swing all joints with some 1 rad/s.
fn swing(t: f64) -> [f64; 5] {
    let c = |w: f64| libm::cos(w * t);
    [2.0 * c(4.0), 2.0 * c(5.0), 0.4 * c(6.0), 0.3 * c(5.0), 0.4 * c(6.0)]
}

/// Largest distance of the tips in m in 2 s without control.
fn open_loop(substeps: u32) -> (f64, f64) {
    let params = params(|config| {
        smooth(config);
        config.bodies.substeps = substeps;
    });
    let start = JointAngles::from_degrees(START_DEG);
    let mut plant = Plant::new(params.clone(), None, &start, 1).unwrap();
    let mut reference = Reference::new(&params, start);
    let (mut worst, mut fastest) = (0.0_f64, 0.0_f64);
    for n in 0..1000 {
        let torques = swing(f64::from(n) * 0.002);
        let drive = Drive { motor_torques: MotorTorques(torques), amplifiers_enabled: true };
        plant.exchange(&drive).unwrap();
        for _ in 0..40 {
            reference.runge_kutta(&torques, 0.002 / 40.0);
        }
        worst = worst.max(distance(plant.truth().tip_m, reference.tip(params.arm())));
        params.arm().check_limits(&JointAngles(reference.q)).unwrap();
        fastest = reference.v.iter().fold(fastest, |f, v| f.max(v.abs()));
    }
    (worst, fastest)
}

#[test]
fn the_tip_without_control() {
    let (mut last, mut errors) = (f64::INFINITY, Vec::new());
    for substeps in [5, 10, 20] {
        let (error, fastest) = open_loop(substeps);
        println!("{substeps} substeps: {:.4} mm after 2 s, up to {fastest:.2} rad/s", 1e3 * error);
        assert!(error < last);
        (last, _) = (error, errors.push(error));
    }
    let chosen = PlantParams::thesis().config().bodies.substeps;
    let (error, fastest) = open_loop(chosen);
    assert!(fastest > 0.5, "{fastest}");
    assert!(error < 1e-3, "{error} m");
    // First order.
    assert!(errors[0] / errors[1] > 1.6 && errors[1] / errors[2] > 1.6, "{errors:?}");
}

/// A servo as the controller's, without its counts: torques towards a slow path, in motor coordinates.
fn servo(t: f64, rotor: &[f64; 5], rotor_v: &[f64; 5], start: &[f64; 5]) -> [f64; 5] {
    const P: [f64; 5] = [500.0, 600.0, 250.0, 250.0, 200.0];
    const D: [f64; 5] = [25.0, 30.0, 10.0, 10.0, 5.0];
    std::array::from_fn(|i| {
        let wanted = start[i] + 0.15 * (1.0 - libm::cos(2.0 * t));
        let rate = 0.3 * libm::sin(2.0 * t);
        P[i] * (wanted - rotor[i]) + D[i] * (rate - rotor_v[i])
    })
}

/// Under a servo at 500 Hz, with free play and dry friction: the largest distance of the tips in m in 2 s.
fn closed_loop(substeps: u32) -> f64 {
    let params = params(|config| config.bodies.substeps = substeps);
    let start = JointAngles::from_degrees(START_DEG);
    let mut plant = Plant::new(params.clone(), None, &start, 1).unwrap();
    let mut reference = Reference::new(&params, start);
    let motors = params.arm().transmission().motor_angles(&start).unwrap().0;
    let encoders = params.config().encoders;
    let per_turn = encoders.motor_counts_per_turn;
    // Both are read through the same encoder.
    let counted = |counts: [f64; 5]| -> [f64; 5] {
        std::array::from_fn(|i| counts[i] * std::f64::consts::TAU / per_turn[i])
    };
    let mut loops = [Loop::new(motors), Loop::new(motors)];
    let (mut worst, mut torques) = (0.0_f64, [[0.0; 5]; 2]);
    for n in 1..=1000 {
        let drive = Drive { motor_torques: MotorTorques(torques[0]), amplifiers_enabled: true };
        let sensed = plant.exchange(&drive).unwrap();
        for _ in 0..100 {
            reference.small_step(&torques[1], 2e-5);
        }
        worst = worst.max(distance(plant.truth().tip_m, reference.tip(params.arm())));
        let t = f64::from(n) * 0.002;
        let of_plant = std::array::from_fn(|i| {
            f64::from(sensed.motor_counts[i]) - f64::from(encoders.motor_offset_counts[i])
        });
        let of_reference =
            std::array::from_fn(|i| (reference.rotor[i] * per_turn[i] / std::f64::consts::TAU).floor());
        torques = [loops[0].torques(t, counted(of_plant)), loops[1].torques(t, counted(of_reference))];
    }
    worst
}

struct Loop {
    start: [f64; 5],
    last: [f64; 5],
    rate: [f64; 5],
}

impl Loop {
    fn new(start: [f64; 5]) -> Self {
        Self { start, last: start, rate: [0.0; 5] }
    }

    fn torques(&mut self, t: f64, turned: [f64; 5]) -> [f64; 5] {
        for ((rate, now), last) in self.rate.iter_mut().zip(turned).zip(self.last) {
            // The controller's low-pass of 40 Hz.
            *rate += 0.395 * ((now - last) / 0.002 - *rate);
        }
        self.last = turned;
        servo(t, &turned, &self.rate, &self.start)
    }
}

#[test]
fn the_tip_under_control() {
    let mut chosen = f64::INFINITY;
    for substeps in [5, 10, 20] {
        let error = closed_loop(substeps);
        println!("{substeps} substeps: {:.5} mm in 2 s under control", 1e3 * error);
        if substeps == PlantParams::thesis().config().bodies.substeps {
            chosen = error;
        }
    }
    assert!(chosen < 5e-5, "{chosen} m");
}

/// Without friction and damping the energy of the swinging arm stays. A semi-implicit step lets it swing about its mean, most of all
/// in the stiff gears; what is bounded is the drift, by 2 % of what there is.
#[test]
fn energy() {
    let params = params(|config| {
        smooth(config);
        config.drives.viscous_nms_per_rad = [0.0; 5];
        config.drives.damping_nms_per_rad = [0.0; 5];
        config.bodies.joint_damping_nms_per_rad = [0.0; 5];
    });
    let start = JointAngles::from_degrees([0.0, 60.0, 60.0, 20.0, 40.0]);
    let mut plant = Plant::new(params.clone(), None, &start, 1).unwrap();
    let push = [3.0, 4.0, 1.0, 0.5, 0.3];
    let drive = Drive { motor_torques: MotorTorques(push), amplifiers_enabled: true };
    for _ in 0..100 {
        plant.exchange(&drive).unwrap();
    }
    let kinetic = plant.energy_j().unwrap() - params.arm().potential_energy_j(&plant.truth().joints).unwrap();
    let energies: Vec<f64> = (0..500)
        .map(|_| {
            plant.exchange(&Drive::default()).unwrap();
            plant.energy_j().unwrap()
        })
        .collect();
    let mean = |part: &[f64]| part.iter().sum::<f64>() / 100.0;
    let drift = mean(&energies[400..]) - mean(&energies[..100]);
    let swing = energies.iter().fold(0.0_f64, |s, e| s.max((e - mean(&energies[..100])).abs()));
    println!(
        "of {kinetic:.3} J in motion, energy drifts by {drift:.5} J in 0.8 s and swings by {swing:.5} J"
    );
    assert!(kinetic > 0.3 && drift.abs() < 0.02 * kinetic, "{drift} of {kinetic} J");
}
