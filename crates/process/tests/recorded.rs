//! Whole recordings: two strokes of the thesis's arm, its joints from inverse kinematics, the wrench turned into the sensor's
//! frame by our own kinematics, and read back through the URDF by the crate `k`.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

mod common;

use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

use common::{LIMIT_N, Random};
use soilctl_kinematics::{Arm, JointAngles, TaskPose, urdf};
use soilctl_process::foreign::{ContactKind, ForeignLog, Oddity};
use soilctl_process::log::{Candidate, LogSettings, read_log};
use soilctl_process::{Evaluated, Method, Outcome, ProcessError, Robot};
use soilctl_session::messages::{Header, JointState, Time, Wrench, WrenchStamped, encode};

const SURFACE_M: f64 = -0.3302;
const NAMES: [&str; 5] = ["base", "shoulder", "elbow", "twist", "wrist"];

#[derive(Clone, Copy)]
struct Plan {
    alpha_deg: f64,
    radius_m: f64,
    base_deg: f64,
    depth_m: f64,
    /// By how much the tool angle grows in 20 mm of travel.
    turn_deg: f64,
    /// Inclination to which the force turns once the soil has failed; it begins at 23 deg.
    slip_deg: f64,
}

impl Plan {
    const fn steady(alpha_deg: f64, radius_m: f64, base_deg: f64, depth_m: f64) -> Self {
        Self { alpha_deg, radius_m, base_deg, depth_m, turn_deg: 0.0, slip_deg: 23.0 }
    }
}

/// Time, joints, wrench in the sensor frame.
type Moment = (f64, JointAngles, [f64; 6]);

fn record(plans: &[Plan], tare: [f64; 3], noise_n: f64) -> Vec<Moment> {
    let arm = Arm::thesis();
    let mut random = Random(9);
    let mut moments = Vec::new();
    let mut t = 100.0;
    for plan in plans {
        let base = plan.base_deg.to_radians();
        let tool = |travel: f64| (plan.alpha_deg + plan.turn_deg * travel / 0.02).to_radians();
        let mut add = |travel: f64, z: f64, force_along: f64, force_up: f64| {
            let alpha = tool(travel);
            let pose = TaskPose::digging(plan.radius_m - travel, base, SURFACE_M + z, alpha).unwrap();
            let joints = arm.inverse(&pose).unwrap();
            // Soil on plate, in the base frame: against the motion, which is towards the base.
            let world = [force_along * base.cos(), force_along * base.sin(), force_up];
            let frame = arm.frames(&joints).unwrap().ft_sensor;
            let in_sensor = |v: [f64; 3]| -> [f64; 3] {
                std::array::from_fn(|i| (0..3).map(|j| frame.rotation[j][i] * v[j]).sum())
            };
            // The force acts a third up the plate: torque about the sensor, along its y axis.
            let tip = arm.frames(&joints).unwrap().plate_tip;
            let at = tip.point_m([0.0, 0.0, -plan.depth_m / alpha.sin() / 3.0]);
            let r: [f64; 3] = std::array::from_fn(|i| at[i] - frame.origin_m[i]);
            let torque = [
                r[1] * world[2] - r[2] * world[1],
                r[2] * world[0] - r[0] * world[2],
                r[0] * world[1] - r[1] * world[0],
            ];
            let (f, m) = (in_sensor(world), in_sensor(torque));
            let f: [f64; 3] = std::array::from_fn(|i| f[i] + tare[i] + noise_n * random.normal());
            moments.push((t, joints, [f[0], f[1], f[2], m[0], m[1], m[2]]));
            t += 0.002;
        };
        for _ in 0..700 {
            add(0.0, 0.02, 0.0, 0.0);
        }
        for i in 0..1000 {
            let z = 0.02 - (0.02 + plan.depth_m) * f64::from(i) / 1000.0;
            add(0.0, z, 0.0, (-z * 60.0).max(0.0));
        }
        // The stroke: the lead of a spring advances, the soil gives way at its limit.
        let scale = (plan.depth_m / 0.0254).powi(2);
        let (mut u, stiffness) = (0.0_f64, 1500.0);
        let force = |u: f64| LIMIT_N * scale * (1.0 + 0.2 * u / plan.depth_m) * (u / 0.0008).min(1.0);
        for i in 0..3000 {
            let lead = 0.020 * f64::from(i) / 3000.0;
            while stiffness * (lead - u) > force(u) && u < lead {
                u += 1e-6;
            }
            let size = (stiffness * (lead - u)).min(force(u) + 0.01);
            // Inclined at 23 deg below the plate's normal, until failed soil has slipped along it for 2 mm.
            let slipped = ((u - 0.001) / 0.002).clamp(0.0, 1.0);
            let inclination = tool(u) - (90.0 - 23.0 - (plan.slip_deg - 23.0) * slipped).to_radians();
            add(u, -plan.depth_m, size * inclination.cos(), size * inclination.sin());
        }
        for i in 0..1000 {
            add(u, -plan.depth_m + (plan.depth_m + 0.02) * f64::from(i) / 1000.0, 0.0, 0.0);
        }
    }
    moments
}

/// Writes moments as a log, and reads it; every `swap`-th wrench comes after the next.
fn read(moments: &[Moment], joints_every: usize, swap: usize) -> (Vec<Evaluated>, ForeignLog) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("log.mcap");
    let mut writer = mcap::Writer::new(std::fs::File::create(&path).unwrap()).unwrap();
    let mut channel = |topic: &str, kind: &str| {
        let schema = writer.add_schema(kind, "ros2msg", b"").unwrap();
        writer.add_channel(schema, topic, "cdr", &BTreeMap::new()).unwrap()
    };
    let channels = [
        channel("/joint_states", "sensor_msgs/msg/JointState"),
        channel("/wrench", "geometry_msgs/msg/WrenchStamped"),
    ];
    let header = |t_s: f64, frame: &str| Header {
        stamp: Time { sec: t_s as i32, nanosec: (t_s.fract() * 1e9) as u32 },
        frame_id: frame.to_owned(),
    };
    let mut wrenches: Vec<(f64, [f64; 6])> = moments.iter().map(|m| (m.0, m.2)).collect();
    for i in (1..wrenches.len()).step_by(swap) {
        wrenches.swap(i - 1, i);
    }
    for (i, (moment, (t_s, wrench))) in moments.iter().zip(&wrenches).enumerate() {
        let mut put = |channel: usize, data: &[u8]| {
            let time = (moment.0 * 1e9) as u64;
            let header = mcap::records::MessageHeader {
                channel_id: channels[channel],
                sequence: 0,
                log_time: time,
                publish_time: time,
            };
            writer.write_to_known_channel(&header, data).unwrap();
        };
        if i % joints_every == 0 {
            let joints = JointState {
                header: header(moment.0, ""),
                name: NAMES.map(str::to_owned).to_vec(),
                position: moment.1.0.to_vec(),
                ..JointState::default()
            };
            put(0, &encode(&joints).unwrap());
        }
        let [x, y, z, a, b, c] = *wrench;
        let wrench = Wrench { force: [x, y, z].into(), torque: [a, b, c].into() };
        put(1, &encode(&WrenchStamped { header: header(*t_s, "ft_sensor"), wrench }).unwrap());
    }
    writer.finish().unwrap();
    let settings = LogSettings {
        urdf: Some(urdf(&Arm::thesis())),
        surface_z_m: Some(SURFACE_M),
        width_m: Some(0.127),
        ..LogSettings::default()
    };
    let mut strokes = Vec::new();
    let log = read_log(&path, &settings, &AtomicBool::new(false), &mut |found| {
        if let Candidate::Stroke(stroke) = found {
            strokes.push(stroke.evaluated);
        }
    });
    (strokes, log.unwrap().foreign.unwrap())
}

fn check(plan: &Plan, found: &Evaluated) {
    let Outcome::Found(point) = &found.analysis.outcome else { panic!("{:?}", found.analysis.outcome) };
    let row = &found.row;
    let limit = LIMIT_N * (plan.depth_m / 0.0254).powi(2);
    assert!((row.alpha_deg - plan.alpha_deg).abs() < 1e-6);
    assert!((row.depth_m - plan.depth_m).abs() < 2e-4);
    assert!((row.force_n / limit - 1.0).abs() < 0.02, "{} {limit}", row.force_n);
    assert_eq!(point.method, Method::Saturation);
    assert!((row.friction_angle_deg.unwrap() - 23.0).abs() < 0.3);
    assert!((row.base_deg.unwrap() - plan.base_deg).abs() < 0.01);
    assert!((row.radius_m.unwrap() - plan.radius_m).abs() < 1e-3);
    assert!((row.tare_before_n.unwrap() - row.tare_after_n.unwrap()).abs() < 0.05);
}

#[test]
fn strokes_are_found_and_their_forces_with_tare_noise_and_disorder() {
    let plans = [
        Plan::steady(90.0, 0.4318, -25.0, 0.0254),
        Plan::steady(80.0, 0.4318, 25.0, 0.025),
        Plan::steady(70.0, 0.3048, 35.0, 0.0239),
    ];
    let moments = record(&plans, [1.5, -0.7, 3.0], 0.02);
    for (joints_every, swap) in [(1, 1_000_000), (5, 7)] {
        let (strokes, log) = read(&moments, joints_every, swap);
        assert_eq!(strokes.len(), plans.len());
        assert!(log.troubles.iter().all(|trouble| trouble.what == Oddity::Disordered), "{:?}", log.troubles);
        assert!(log.contacts.iter().all(|contact| contact.kind == ContactKind::Stroke));
        for (plan, stroke) in plans.iter().zip(&strokes) {
            check(plan, stroke);
        }
        // The sensor keeps one posture, or nearly: bias and weight cannot be told apart, their sum can.
        let air = log.air.unwrap();
        assert!((air.noise.unwrap().force_n() - 0.02).abs() < 0.002);
    }
}

#[test]
fn urdfs_that_cannot_be_used_are_refused() {
    let good = urdf(&Arm::thesis());
    let error = Robot::from_urdf(&good, "spoon", "ft_sensor").unwrap_err();
    assert!(
        matches!(&error, ProcessError::NoFrame { .. }) && error.to_string().contains("plate_tip"),
        "{error}"
    );
    for text in [
        "",
        "<robot name=\"a\"/>",
        "not xml",
        &good.replace("<parent link=\"base_link\"/>", "<parent link=\"hand_link\"/>"),
        &good.replace("<child link=\"twist_link\"/>", "<child link=\"nowhere\"/>"),
    ] {
        assert!(matches!(Robot::from_urdf(text, "plate_tip", "ft_sensor"), Err(ProcessError::Urdf(_))));
    }
}

fn evaluated(plan: &Plan) -> Evaluated {
    let (strokes, _) = read(&record(&[*plan], [0.5, 0.0, 1.0], 0.02), 3, 1_000_000);
    assert_eq!(strokes.len(), 1);
    strokes.into_iter().next().unwrap()
}

/// An arm turns the plate while it pulls: friction counts from the plate as it is then.
#[test]
fn a_plate_that_turns_has_the_same_friction_angle() {
    for turn_deg in [-4.0, 3.0] {
        let found = evaluated(&Plan { turn_deg, ..Plan::steady(90.0, 0.4318, 10.0, 0.0254) });
        let Outcome::Found(point) = &found.analysis.outcome else { panic!("{:?}", found.analysis.outcome) };
        assert!((found.row.friction_angle_deg.unwrap() - 23.0).abs() < 0.3);
        assert!((found.slip.unwrap().angle_deg - 23.0).abs() < 0.3);
        let turned_deg = found.row.turned_deg.unwrap();
        assert!((turned_deg - turn_deg * point.displacement_m / 0.02).abs() < 0.2, "{turned_deg}");
    }
}

/// Section 5.4: the force turns to the interface friction when soil slips, whatever it was before.
#[test]
fn slipping_soil_shows_its_friction() {
    for slip_deg in [21.0, 27.0] {
        let found = evaluated(&Plan { slip_deg, ..Plan::steady(80.0, 0.4318, 0.0, 0.0254) });
        let slip = found.slip.unwrap();
        assert!((slip.angle_deg - slip_deg).abs() < 0.4 && slip.sd_deg < 0.5, "{slip:?}");
    }
}
