//! Homing and wall sensing against the simulated stops and box.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod rig;

use rig::{above, ground, homed};
use soilctl_controller::{Params, Request, SequenceId};
use soilctl_kinematics::JointAngles;
use soilctl_plant::{Plant, PlantParams, Simulation};

/// External encoders are right to 0.8 deg, eight counts; motor encoders are off by the free play as well.
#[test]
fn homing_finds_the_stops() {
    let start = JointAngles::from_degrees([-80.0, -10.0, 130.0, -60.0, -80.0]);
    let plant = PlantParams::thesis();
    let play = plant.config().drives.free_play_deg;
    let mut simulation = Simulation::new(Params::thesis(), Plant::new(plant, None, &start, 3).unwrap());
    simulation.tick(Some(Request::Enable), &mut |_| {}).unwrap();
    let done = simulation.run_sequence(SequenceId::Homing, 40_000, &mut |_| {}).unwrap();
    assert!(done, "{:?} {:?}", simulation.state().fault, simulation.state().machine.top());
    simulation.run(1000, &mut |_| {}).unwrap();
    let truth = simulation.plant().truth().joints.degrees();
    let seen = simulation.outputs().telemetry;
    println!(
        "true {truth:?}\nmotor {:?}\nexternal {:?}",
        seen.motor_joints.degrees(),
        seen.external_joints.degrees()
    );
    for i in 0..5 {
        let external = (seen.external_joints.degrees()[i] - truth[i]).abs();
        let motor = (seen.motor_joints.degrees()[i] - truth[i]).abs();
        assert!(external < 0.8, "joint {i}: external encoder off by {external} deg");
        assert!(motor < 0.8 + play[i], "joint {i}: motor encoder off by {motor} deg");
    }
}

#[test]
fn walls_are_found() {
    // The thesis's box is wider than the arm can reach in and out with a hanging plate.
    let thesis = PlantParams::thesis();
    let mut config = thesis.config().clone();
    (config.sandbox.x_m, config.sandbox.y_m) = ([0.3, 0.52], [-0.15, 0.15]);
    let sandbox = config.sandbox;
    let plate_height_m = thesis.arm().config().plate.height_m;
    let plant = PlantParams::new(thesis.arm().clone(), config).unwrap();
    let start = above(0.42, 0.0, 75.0, -0.26);
    let sand = ground(&plant, "ticino_loose", "chen");
    let mut simulation = homed(Params::thesis(), plant, Some(sand), &start);
    let done = simulation.run_sequence(SequenceId::WallSensing, 200_000, &mut |_| {}).unwrap();
    println!("{:?} {:?}", simulation.state().walls_m, simulation.state().fault);
    assert!(done, "{:?} {:?}", simulation.state().fault, simulation.state().machine.top());
    let half = 0.0635;
    // The plate's edge is along y: its ends meet the walls across y, its faces those across x.
    // A leaning plate meets the outer wall with its upper edge, the inner one with its lower edge.
    let lean = plate_height_m * libm::cos(75f64.to_radians());
    let places = [sandbox.x_m[1] - lean, sandbox.x_m[0], sandbox.y_m[1] - half, sandbox.y_m[0] + half];
    for (found, place) in simulation.state().walls_m.iter().zip(places) {
        println!("wall at {place:.4} m found at {:.4} m", found.unwrap());
        // An external count is 2 mm at this reach, and the plate turns with the base.
        assert!((found.unwrap() - place).abs() < 0.006);
    }
}
