//! The same inputs give the same bits, also after a resume from a stored state.
#![allow(clippy::unwrap_used)]

mod common;

use common::{Rig, Soil};
use soilctl_controller::{Outputs, Params, Request, SequenceId, State, StrokeSpec};
use soilctl_kinematics::TaskPose;

/// FNV-1a over every bit of the outputs that the hardware and a log see.
fn add(hash: &mut u64, outputs: &Outputs) {
    let seen = &outputs.telemetry;
    let numbers = outputs
        .motor_torques
        .0
        .iter()
        .chain(&outputs.motor_currents_a)
        .chain(&seen.motor_joints.0)
        .chain(&seen.external_joints.0)
        .chain(&seen.joint_rates.0)
        .chain(&seen.force_rtz_n)
        .chain(&seen.desired_joints.0)
        .chain(&seen.desired_position_m)
        .chain(&seen.joint_torques.0)
        .chain([&seen.lead_m, &seen.lead_inclination_rad, &seen.force_inclination_rad, &seen.pose.z_m]);
    for byte in numbers.flat_map(|number| number.to_bits().to_le_bytes()) {
        *hash = (*hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
}

/// A whole stroke; at `resume` the state goes through JSON and back.
fn run(resume: Option<usize>) -> u64 {
    let params = Params::thesis();
    let pose = TaskPose::digging(0.4318, 0.0, -0.3, 80f64.to_radians()).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil::new());
    rig.request(Request::Stroke(StrokeSpec {
        batch: 0,
        radius_m: 0.4318,
        base_rad: 0.0,
        tool_angle_rad: 80f64.to_radians(),
        depth_m: 0.02,
        delta_rad: 0.4,
    }));
    rig.request(Request::Start(SequenceId::InsertStrokePullout));
    let mut hash = 0xcbf2_9ce4_8422_2325;
    for n in 0..24_000 {
        if resume == Some(n) {
            let text = serde_json::to_string(&rig.state).unwrap();
            let stored: State = serde_json::from_str(&text).unwrap();
            assert_eq!(stored, rig.state);
            rig.state = stored;
        }
        add(&mut hash, &rig.tick());
    }
    assert!(rig.state.fault.is_none() && !rig.state.machine.is_running(), "{:?}", rig.state.machine);
    hash
}

/// No golden number: the soil and the plant of the tests use the system's sines. That the controller's own do not is
/// asserted below.
#[test]
fn two_runs_and_resumed_runs_have_the_same_bits() {
    let hash = run(None);
    println!("{hash:#x}");
    assert_eq!(run(None), hash);
    // In the bias, the touch, the insertion, the stroke and the pull-out.
    for resume in [40, 1000, 4000, 9000, 14_000, 20_000] {
        assert_eq!(run(Some(resume)), hash, "resumed at {resume}");
    }
}

/// `f64::sin` and its like are those of the system and differ between systems; no clock, no lock, no random number.
#[test]
fn only_libm_and_no_clock() {
    let forbidden = [
        ".sin()",
        ".cos()",
        ".tan()",
        ".sin_cos()",
        ".asin()",
        ".acos()",
        ".atan()",
        ".atan2(",
        ".hypot(",
        ".exp()",
        ".ln()",
        ".powf(",
        ".powi(",
        ".mul_add(",
        "f64::sin",
        "f64::cos",
        "Instant",
        "SystemTime",
        "Mutex",
        "HashMap",
        "rand::",
    ];
    let mut open = vec![std::path::PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/src"))];
    let mut files = 0;
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for call in forbidden {
                assert!(!text.contains(call), "{}: {call}", path.display());
            }
            files += 1;
        }
    }
    assert!(files > 25, "{files}");
}
