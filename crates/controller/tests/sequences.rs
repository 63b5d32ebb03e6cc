//! Whole sequences against the test plant.
#![allow(clippy::unwrap_used, clippy::float_cmp)]

mod common;

use common::{Rig, Soil};
use soilctl_controller::trajectory::RING_SIZE;
use soilctl_controller::{
    ControllerConfig, DEFAULT, Event, EventKind, Finish, Params, Refusal, Request, SequenceId, StrokePlan,
    StrokeSpec, Trajectory, TrajectoryKind, Tunable,
};
use soilctl_kinematics::{Arm, JointAngles, JointVelocities, TaskPose};

fn above(arm: &Arm, radius_m: f64, alpha_deg: f64) -> JointAngles {
    let pose = TaskPose::digging(radius_m, 0.0, -0.28, alpha_deg.to_radians()).unwrap();
    arm.inverse(&pose).unwrap()
}

fn spec(radius_m: f64, alpha_deg: f64, delta_deg: f64) -> StrokeSpec {
    StrokeSpec {
        batch: 0,
        radius_m,
        base_rad: 0.0,
        tool_angle_rad: alpha_deg.to_radians(),
        depth_m: 0.025,
        delta_rad: delta_deg.to_radians(),
    }
}

#[test]
fn homing_finds_the_stops() {
    let params = Params::thesis();
    let q = JointAngles::from_degrees([-80.0, -10.0, 130.0, -60.0, -80.0]);
    let mut rig = Rig::new(params, q.0);
    rig.request(Request::Enable);
    rig.run_sequence(SequenceId::Homing, 30_000);
    assert!(rig.has(|event| event.kind == EventKind::SequenceSucceeded(SequenceId::Homing)));
    rig.run(500);
    let seen = rig.outputs.telemetry.motor_joints;
    for i in 0..5 {
        // The stops give way a little under the touch.
        assert!((seen.0[i] - rig.plant.q[i]).abs() < 0.4f64.to_radians(), "joint {i}");
    }
}

#[test]
fn a_stroke_from_touch_to_pullout() {
    let params = Params::thesis();
    let start = above(params.arm(), 0.4318, 80.0);
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil::new());
    rig.request(Request::Stroke(spec(0.4318, 80.0, 23.0)));
    rig.run_sequence(SequenceId::InsertStrokePullout, 60_000);
    assert!(rig.has(|event| event.kind == EventKind::SequenceSucceeded(SequenceId::InsertStrokePullout)));
    let surface = rig.find(|event| event.kind == EventKind::SurfaceFound).unwrap().value;
    assert!((surface + 0.3302).abs() < 0.004, "{surface}");
    let depth = rig.find(|event| event.kind == EventKind::Inserted).unwrap();
    assert!((depth.value - depth.limit).abs() < 0.001, "{depth:?}");
    let force = rig.find(|event| event.kind == EventKind::StrokeEnded).unwrap().value;
    // Along r, the failure force of 12 N across the plate and its friction.
    assert!(force > 11.0 && force < 15.0, "{force} N");
    let ended =
        |event: &Event| event.kind == EventKind::TrajectoryEnded(TrajectoryKind::Stroke, Finish::TravelLimit);
    assert!(rig.has(ended));
    // Stored while inserting and stroking, and only then.
    assert_eq!(rig.state.storage_segment, 1);
    assert!(!rig.state.storing);
}

/// A stroke in soil that never fails, with this largest lead; how it ended.
fn in_hard_soil(max_lead_m: f64) -> Finish {
    let mut config: ControllerConfig = toml::from_str(DEFAULT).unwrap();
    config.stroke.max_lead_m = max_lead_m;
    let params = Params::new(Arm::thesis(), config, StrokePlan::default()).unwrap();
    let start = above(params.arm(), 0.4318, 90.0);
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil { failure_n: 1000.0, ..Soil::new() });
    rig.request(Request::Stroke(spec(0.4318, 90.0, 23.0)));
    rig.run_sequence(SequenceId::InsertStrokePullout, 60_000);
    // Neither is a fault: the arm goes on with the next stroke.
    assert!(rig.has(|event| event.kind == EventKind::SequenceSucceeded(SequenceId::InsertStrokePullout)));
    let ended = |(_, event): &(u64, Event)| match event.kind {
        EventKind::TrajectoryEnded(TrajectoryKind::Stroke, finish) => Some(finish),
        _ => None,
    };
    rig.events.iter().find_map(ended).unwrap()
}

#[test]
fn a_stroke_ends_at_the_limit_of_its_lead_or_of_the_torques_in_hard_soil() {
    assert_eq!(in_hard_soil(0.003), Finish::LeadLimit);
    assert_eq!(in_hard_soil(0.05), Finish::TorqueLimit);
}

#[test]
fn no_soil_means_pulling_out_in_vain() {
    let params = Params::thesis();
    let start = above(params.arm(), 0.4318, 90.0);
    let mut rig = Rig::homed(params, start);
    rig.run_sequence(SequenceId::InsertStrokePullout, 30_000);
    assert!(rig.has(|event| event.kind == EventKind::SequenceFailed(SequenceId::InsertStrokePullout)));
}

#[test]
fn walls_are_found() {
    let params = Params::thesis();
    let pose = TaskPose::digging(0.4318, 0.0, -0.25, 90f64.to_radians()).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    let walls = [0.50, 0.36, 0.08, -0.09];
    rig.plant.walls = Some(walls);
    rig.run_sequence(SequenceId::WallSensing, 60_000);
    for (found, true_place) in rig.state.walls_m.iter().zip(walls) {
        let found = found.unwrap();
        assert!((found - true_place).abs() < 0.003, "{found} {true_place}");
    }
}

/// Two strokes in fresh soil, a pause, one more.
#[test]
fn a_campaign_waits_between_batches() {
    let text = "version = 1\n[[batches]]\nstrokes = [\
        { radius_m = 0.4318, base_deg = -10.0, alpha_deg = 80.0, depth_m = 0.02, delta_set_deg = 23.0 },\
        { radius_m = 0.3048, base_deg = 10.0, alpha_deg = 70.0, depth_m = 0.02, delta_set_deg = 23.0 }]\n\
        [[batches]]\nstrokes = [\
        { radius_m = 0.4318, base_deg = 0.0, alpha_deg = 90.0, depth_m = 0.02, delta_set_deg = 23.0 }]\n";
    let plan = StrokePlan::from_toml(text, "plan").unwrap();
    let params = Params::from_toml(Arm::thesis(), DEFAULT, "default", plan).unwrap();
    let start = params.arm().inverse(&TaskPose::digging(0.4, 0.0, -0.2, 1.4).unwrap()).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil::new());
    rig.request(Request::Start(SequenceId::Campaign));
    let mut ticks = 0;
    while !rig.has(|event| event.kind == EventKind::Waiting) {
        rig.tick();
        ticks += 1;
        assert!(
            ticks < 100_000 && rig.state.fault.is_none(),
            "{:?} {:?}",
            rig.state.fault,
            rig.state.machine
        );
    }
    rig.run(1000);
    let strokes =
        |rig: &Rig| rig.events.iter().filter(|(_, event)| event.kind == EventKind::StrokeEnded).count();
    assert_eq!(strokes(&rig), 2);
    rig.request(Request::Continue);
    rig.settle(60_000);
    assert_eq!(strokes(&rig), 3);
    assert!(rig.has(|event| event.kind == EventKind::SequenceSucceeded(SequenceId::Campaign)));
    assert_eq!(rig.state.storage_segment, 3);
}

/// Section 5.4: the plate lifts at set-points below the true friction angle; the answer is within 2 degrees.
#[test]
fn the_friction_sweep_finds_the_angle() {
    let params = Params::thesis();
    let start = above(params.arm(), 0.4318, 80.0);
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil { delta: 23f64.to_radians(), ..Soil::new() });
    rig.request(Request::Start(SequenceId::FrictionSweep));
    for _ in 0..400_000 {
        rig.tick();
        assert!(rig.state.fault.is_none(), "{:?}", rig.state.fault);
        if !rig.state.machine.is_running() {
            break;
        }
        if rig.state.machine.waits() {
            rig.request(Request::Continue);
        }
    }
    let lifts: Vec<_> = rig
        .events
        .iter()
        .filter(|(_, event)| matches!(event.kind, EventKind::Lift | EventKind::Rise))
        .map(|(_, event)| event.value)
        .collect();
    let found = rig.find(|event| event.kind == EventKind::FrictionFound);
    let found = found.unwrap_or_else(|| panic!("{lifts:?}")).value;
    println!("friction angle {found} deg, lifts {lifts:?}");
    assert!((found - 23.0).abs() <= 2.0, "{found} {lifts:?}");
}

#[test]
fn requests_out_of_place_are_refused() {
    let params = Params::thesis();
    let mut rig = Rig::new(params, [0.0, 0.5, 1.5, 0.0, 0.5]);
    let mut refusal = |request| {
        rig.request(request).events.as_slice().iter().find_map(|event| match event.kind {
            EventKind::Refused(refusal) => Some(refusal),
            _ => None,
        })
    };
    assert_eq!(refusal(Request::Start(SequenceId::Homing)), Some(Refusal::Mode));
    assert_eq!(refusal(Request::Continue), Some(Refusal::NothingWaits));
    assert_eq!(refusal(Request::Enable), None);
    assert_eq!(refusal(Request::Enable), Some(Refusal::Mode));
    assert_eq!(refusal(Request::Start(SequenceId::Campaign)), Some(Refusal::NotHomed));
    assert_eq!(refusal(Request::Push(Trajectory::Insert { depth_m: 0.01 })), Some(Refusal::NotHomed));
    let bad = JointVelocities([f64::NAN; 5]);
    let push = Request::Push(Trajectory::JointVelocity { rates: bad, ticks: None });
    assert_eq!(refusal(push), Some(Refusal::Value));
    assert_eq!(refusal(Request::Tune(Tunable::SpeedScale(f64::INFINITY))), Some(Refusal::Value));
    assert_eq!(refusal(Request::Start(SequenceId::Homing)), None);
    assert_eq!(refusal(Request::Push(Trajectory::Hold { ticks: None })), Some(Refusal::Busy));
    assert_eq!(refusal(Request::Abort), None);
    for _ in 0..RING_SIZE {
        // The endless hold gives way to the first, which keeps its place.
        refusal(Request::Push(Trajectory::Hold { ticks: Some(1_000_000) }));
    }
    refusal(Request::Push(Trajectory::Hold { ticks: None }));
    assert_eq!(refusal(Request::Push(Trajectory::Hold { ticks: None })), Some(Refusal::RingFull));
}
