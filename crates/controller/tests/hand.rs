//! The arm follows a hand: within its limits for any target, against what pushes back, and no longer than the hand says where it is.
#![allow(clippy::unwrap_used, clippy::needless_range_loop, clippy::cast_possible_truncation)]

mod common;

use common::{Rig, Soil};
use proptest::prelude::*;
use soilctl_controller::{
    EventKind, Finish, HandLimit, HandTarget, Mode, Params, Refusal, Request, StrokePlan, TICK_S, Trajectory,
    TrajectoryKind,
};
use soilctl_kinematics::{Arm, TaskPose};

/// As a page sends: every 20 ms.
const EVERY: usize = 10;

fn rig(params: Params) -> Rig {
    let pose = TaskPose::digging(0.43, 0.0, -0.25, 90f64.to_radians()).unwrap();
    let joints = params.arm().inverse(&pose).unwrap();
    Rig::homed(params, joints)
}

fn target(radius: f64, base_deg: f64, z_m: f64, tool_deg: f64) -> HandTarget {
    let (sin, cos) = base_deg.to_radians().sin_cos();
    HandTarget { x_m: radius * cos, y_m: radius * sin, z_m, tool_angle_rad: tool_deg.to_radians() }
}

fn follow(target: HandTarget) -> Request {
    Request::Push(Trajectory::Follow { hand: 1, target })
}

/// The wanted edge along r, t, z as it was told last, by the joints that are wanted: computed without the law.
fn wanted(rig: &Rig) -> [f64; 3] {
    rig.plant.arm.forward(&rig.outputs.telemetry.desired_joints).unwrap().position_m()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Leads the arm for some ticks; `each` sees every tick.
fn lead(rig: &mut Rig, target: HandTarget, ticks: usize, mut each: impl FnMut(&Rig)) {
    for tick in 0..ticks {
        if tick % EVERY == 0 {
            rig.request(follow(target));
        } else {
            rig.tick();
        }
        each(rig);
    }
}

fn refusals(rig: &Rig, refusal: Refusal) -> usize {
    rig.events.iter().filter(|(_, event)| event.kind == EventKind::Refused(refusal)).count()
}

#[test]
fn the_edge_comes_to_the_hand_and_stays_there() {
    let mut rig = rig(Params::thesis());
    let there = target(0.36, 20.0, -0.22, 80.0);
    let way = distance(wanted(&rig), [there.x_m, there.y_m, there.z_m]);
    let hand = rig.params.config().hand;
    // Speeding up, going on and braking, and time for the rest.
    let ticks = ((way / hand.speed_m_s + hand.speed_m_s / hand.acceleration_m_s2 + 0.4) / TICK_S) as usize;
    lead(&mut rig, there, ticks, |_| {});
    let pose = rig.outputs.telemetry.pose;
    assert!(distance(pose.position_m(), [there.x_m, there.y_m, there.z_m]) < 0.002, "{pose:?}");
    assert!((pose.tool_angle_rad() - there.tool_angle_rad).abs() < 0.01, "{pose:?}");
    assert!(pose.n2_rad.abs() < 0.01, "the edge is level: {pose:?}");
    assert!(!rig.has(|event| matches!(event.kind, EventKind::HandLimit(_))), "{:?}", rig.events);
    assert_eq!(rig.outputs.telemetry.trajectory, Some(TrajectoryKind::Follow));
}

#[test]
fn a_hand_that_is_gone_stops_the_arm_within_the_stated_time() {
    let mut rig = rig(Params::thesis());
    let hand = rig.params.config().hand;
    lead(&mut rig, target(0.6, 60.0, -0.2, 90.0), 400, |_| {});
    let moving = wanted(&rig);
    rig.tick();
    assert!(distance(moving, wanted(&rig)) > 0.9 * hand.speed_m_s * TICK_S, "it should be on its way");
    // Lease, braking, and a tick or two of rounding. The last word came a few ticks ago.
    let most = hand.lease_ticks as usize + (hand.speed_m_s / hand.acceleration_m_s2 / TICK_S) as usize + 3;
    rig.run(most);
    let let_go = EventKind::TrajectoryEnded(TrajectoryKind::Follow, Finish::LetGo);
    assert!(rig.has(|event| event.kind == let_go) && rig.state.idle, "{:?}", rig.events);
    let (still, there) = (wanted(&rig), rig.outputs.telemetry.pose.position_m());
    rig.run(250);
    assert_eq!(wanted(&rig), still);
    assert!(distance(there, rig.outputs.telemetry.pose.position_m()) < 0.003);
    assert_eq!(rig.state.mode, Mode::Ready);
    // 0.3 s, as the documentation says.
    assert!(most as f64 * TICK_S < 0.3);
}

#[test]
fn one_hand_at_a_time_and_none_without_numbers() {
    let mut rig = rig(Params::thesis());
    let there = target(0.4, 0.0, -0.25, 90.0);
    let other = Request::Push(Trajectory::Follow { hand: 2, target: there });
    rig.request(follow(there));
    rig.request(other);
    assert_eq!(refusals(&rig, Refusal::OtherHand), 1);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut bad_target = [there.x_m, there.y_m, there.z_m, there.tool_angle_rad];
            bad_target[place] = bad;
            let [x_m, y_m, z_m, tool_angle_rad] = bad_target;
            rig.request(follow(HandTarget { x_m, y_m, z_m, tool_angle_rad }));
        }
    }
    assert_eq!(refusals(&rig, Refusal::Value), 12);
    rig.run(400);
    rig.request(other);
    assert_eq!(refusals(&rig, Refusal::OtherHand), 1);
    assert_eq!(rig.outputs.telemetry.trajectory, Some(TrajectoryKind::Follow));
    // What else is to be done goes before a hand that comes, and takes the plate from one that is there.
    rig.run(400);
    rig.request(Request::Push(Trajectory::Hold { ticks: Some(100) }));
    rig.request(follow(there));
    assert_eq!(refusals(&rig, Refusal::Busy), 1);
    rig.run(150);
    rig.request(follow(there));
    rig.request(Request::Abort);
    assert!(rig.state.idle);
}

/// A wall at +x, springs of 5 N/mm: the hand goes 0.2 m into it.
#[test]
fn the_arm_does_not_push_harder_than_allowed_and_comes_back() {
    let mut rig = rig(Params::thesis());
    rig.plant.walls = Some([0.45, -1.0, 1.0, -1.0]);
    let most_n = rig.params.config().hand.force_n;
    let (mut peak, mut last) = (0.0_f64, 0.0);
    lead(&mut rig, target(0.65, 0.0, -0.25, 90.0), 2000, |rig| {
        last = rig.plant.force_rtz.iter().map(|part| part * part).sum::<f64>().sqrt();
        peak = peak.max(last);
    });
    assert_eq!(rig.state.mode, Mode::Ready, "{:?}", rig.state.fault);
    assert!(peak < 1.3 * most_n && peak < rig.params.config().safety.tip_force_n, "{peak} N");
    assert!((0.8 * most_n..=1.1 * most_n).contains(&last), "{last} N");
    let said = rig.find(|event| event.kind == EventKind::HandLimit(HandLimit::Force)).unwrap();
    assert!(said.value > 0.5 && said.limit == 1.0, "{said:?}");
    let many = rig.events.iter().filter(|(_, event)| matches!(event.kind, EventKind::HandLimit(_))).count();
    assert!(many < 5, "a limit at which the arm works is no flood: {many}");
    // Let go, the arm does not press on.
    rig.run(1500);
    assert!(rig.plant.force_rtz[0].abs() < 1.2 * most_n && rig.state.mode == Mode::Ready);
    // What the integrals of the servo law hold against the wall takes a while to go.
    lead(&mut rig, target(0.40, 0.0, -0.25, 90.0), 2500, |_| {});
    assert!(rig.plant.force_rtz[0].abs() < 0.1);
    assert!((rig.outputs.telemetry.pose.x_m - 0.40).abs() < 0.003);
    assert!(rig.has(|event| event.kind == EventKind::HandLimit(HandLimit::None)));
}

#[test]
fn torques_are_a_limit_of_their_own() {
    let mut settings = Params::thesis().config().clone();
    (settings.hand.force_n, settings.hand.torque_share) = (39.0, 0.25);
    let mut rig = rig(Params::new(Arm::thesis(), settings, StrokePlan::default()).unwrap());
    rig.plant.walls = Some([0.45, -1.0, 1.0, -1.0]);
    lead(&mut rig, target(0.65, 0.0, -0.25, 90.0), 2000, |_| {});
    assert_eq!(rig.state.mode, Mode::Ready, "{:?}", rig.state.fault);
    assert!(rig.has(|event| event.kind == EventKind::HandLimit(HandLimit::Torque)), "{:?}", rig.events);
    assert!(rig.plant.force_rtz[0].abs() < 30.0, "{:?}", rig.plant.force_rtz);
}

/// Through soil that fails at 12 N the arm goes on and stays near its height.
#[test]
fn soil_is_ploughed() {
    let mut rig = rig(Params::thesis());
    rig.plant.soil = Some(Soil::new());
    lead(&mut rig, target(0.43, 0.0, -0.35, 90.0), 1500, |_| {});
    lead(&mut rig, target(0.33, 0.0, -0.35, 90.0), 2500, |_| {});
    let pose = rig.outputs.telemetry.pose;
    assert_eq!(rig.state.mode, Mode::Ready, "{:?}", rig.state.fault);
    assert!((pose.x_m - 0.33).abs() < 0.005 && (pose.z_m + 0.35).abs() < 0.005, "{pose:?}");
    assert!(rig.plant.soil.unwrap().failed);
}

#[test]
fn settings_from_before_hands_are_read() {
    let text = soilctl_controller::DEFAULT;
    let (before, rest) = text.split_once("[hand]").unwrap();
    let (_, after) = rest.split_once("[safety]").unwrap();
    let old = format!("{before}[safety]{after}");
    let params = Params::from_toml(Arm::thesis(), &old, "old", StrokePlan::default()).unwrap();
    assert_eq!(params, Params::thesis());
}

/// Anything that is a number, and many that arms know.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -1.0..1.0,
        1 => any::<f64>().prop_filter("finite", |x| x.is_finite()),
        1 => prop::sample::select(vec![f64::MAX, f64::MIN, -0.0, 1e-310, 1e9]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever hands do, the wanted edge keeps to speed and acceleration, the arm to its workspace, and nothing is a fault.
    #[test]
    fn limits_hold_for_any_target(
        script in prop::collection::vec((prop::array::uniform4(number()), 1_usize..250), 1..12),
    ) {
        let mut rig = rig(Params::thesis());
        let (hand, safety) = (rig.params.config().hand, rig.params.config().safety);
        let mut last: Option<[f64; 3]> = None;
        let mut last_velocity: Option<[f64; 3]> = None;
        for ([x_m, y_m, z_m, tool], ticks) in script {
            let target = HandTarget { x_m, y_m, z_m, tool_angle_rad: 1.5 + tool };
            let mut worst = (0.0_f64, 0.0_f64);
            lead(&mut rig, target, ticks, |rig| {
                let place = wanted(rig);
                if let Some(before) = last {
                    let velocity = [0, 1, 2].map(|i| (place[i] - before[i]) / TICK_S);
                    worst.0 = worst.0.max(distance(velocity, [0.0; 3]));
                    if let Some(before) = last_velocity {
                        // A border that is reached stops what goes across it at once; the rest keeps to the acceleration.
                        if rig.state.active.unwrap().hand.limit == HandLimit::None {
                            worst.1 = worst.1.max(distance(velocity, before) / TICK_S);
                        }
                    }
                    last_velocity = Some(velocity);
                }
                last = Some(place);
            });
            prop_assert_eq!(rig.state.mode, Mode::Ready, "{:?} at {:?}", rig.state.fault, target);
            prop_assert!(worst.0 <= hand.speed_m_s * 1.02, "{} m/s", worst.0);
            // Turning with the base adds v^2 / r.
            let turning = 2.0 * hand.speed_m_s * hand.speed_m_s / safety.radius_m[0];
            prop_assert!(worst.1 <= hand.acceleration_m_s2 * 1.05 + turning, "{} m/s2", worst.1);
            let pose = rig.outputs.telemetry.pose;
            let radius = pose.x_m.hypot(pose.y_m);
            prop_assert!(radius > safety.radius_m[0] && radius < safety.radius_m[1], "{radius}");
            prop_assert!(pose.z_m > safety.height_m[0] && pose.z_m < safety.height_m[1], "{}", pose.z_m);
        }
    }
}
