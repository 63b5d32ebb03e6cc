//! The same seed gives the same bits; another seed gives others.
#![allow(clippy::unwrap_used, clippy::print_stdout)]

mod rig;

use rig::{above, ground, homed, spec};
use soilctl_controller::{Params, Request, SequenceId};
use soilctl_kinematics::JointAngles;
use soilctl_plant::{Drive, Hardware, Plant, PlantParams};

/// FNV-1a over everything that a log would hold of 6 s: a touch and the beginning of an insertion.
fn hash() -> u64 {
    let plant = PlantParams::thesis();
    let sand = ground(&plant, "ticino_rained", "table");
    let start = above(0.4318, 0.0, 80.0, rig::SURFACE_Z_M + 0.01);
    let mut simulation = homed(Params::thesis(), plant, Some(sand), &start);
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    let mut feed = |bits: u64| {
        for byte in bits.to_le_bytes() {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    };
    let mut note = |tick: soilctl_plant::Tick<'_>| {
        tick.sensed.wrench.iter().for_each(|value| feed(value.to_bits()));
        tick.sensed.external_counts.iter().for_each(|&count| feed(u64::from(count.cast_unsigned())));
        tick.outputs.motor_torques.0.iter().for_each(|value| feed(value.to_bits()));
        tick.truth.tip_m.iter().for_each(|value| feed(value.to_bits()));
        feed(tick.truth.soil.limit_force_n.to_bits());
    };
    simulation.tick(Some(Request::Stroke(spec(0.4318, 80.0, 0.0254, 23.0))), &mut note).unwrap();
    simulation.tick(Some(Request::Start(SequenceId::InsertStrokePullout)), &mut note).unwrap();
    simulation.run(3000, &mut note).unwrap();
    assert!(simulation.plant().truth().soil.depth_m > 0.0);
    hash
}

/// Debug and release give the same: run both and compare what is printed.
#[test]
fn the_same_seed_gives_the_same_bits() {
    let first = hash();
    println!("hash {first:016x}");
    assert_eq!(first, hash());
    // On another thread, with another stack and other allocations.
    assert_eq!(first, std::thread::spawn(hash).join().unwrap());
}

#[test]
fn another_seed_gives_other_noise() {
    let read = |seed| {
        let joints = JointAngles::from_degrees([0.0, 40.0, 90.0, 0.0, 20.0]);
        let mut plant = Plant::new(PlantParams::thesis(), None, &joints, seed).unwrap();
        plant.exchange(&Drive::default()).unwrap().wrench.map(f64::to_bits)
    };
    assert_eq!(read(1), read(1));
    assert_ne!(read(1), read(2));
}
