//! Whole recordings: two strokes of the thesis's arm, its joints from inverse kinematics, the wrench turned into the sensor's
//! frame by our own kinematics, and read back through the URDF by the crate `k`.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

mod common;

use common::{LIMIT_N, Random};
use soilctl_kinematics::{Arm, JointAngles, TaskPose, urdf};
use soilctl_process::{
    Aligner, Contact, Evaluated, FindSettings, Finder, Method, Outcome, ProcessError, Recorded, Robot,
    Setting, evaluate,
};

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

fn robot() -> Robot {
    Robot::from_urdf(&urdf(&Arm::thesis()), "plate_tip", "ft_sensor").unwrap()
}

/// Reads moments as two streams; every `swap`-th wrench comes after the next.
fn read(moments: &[Moment], joints_every: usize, swap: usize) -> (Vec<Recorded>, soilctl_process::Lost) {
    let mut aligner = Aligner::new(robot(), 0.5);
    let mut finder = Finder::new(FindSettings::default());
    let mut strokes = Vec::new();
    let mut wrenches: Vec<(f64, [f64; 6])> = moments.iter().map(|m| (m.0, m.2)).collect();
    for i in (1..wrenches.len()).step_by(swap) {
        wrenches.swap(i - 1, i);
    }
    let mut keep = |contact: Option<Contact>| {
        if let Some(Contact::Stroke(stroke)) = contact {
            strokes.push(stroke);
        }
    };
    for (i, (moment, wrench)) in moments.iter().zip(&wrenches).enumerate() {
        if i % joints_every == 0 {
            aligner.joints(moment.0, NAMES.iter().copied().zip(moment.1.0));
        }
        aligner.wrench(wrench.0, wrench.1);
        while let Some(sample) = aligner.next(false).unwrap() {
            keep(finder.push(sample));
        }
    }
    while let Some(sample) = aligner.next(true).unwrap() {
        keep(finder.push(sample));
    }
    keep(finder.end());
    (strokes, aligner.lost())
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
        let (strokes, lost) = read(&moments, joints_every, swap);
        assert_eq!(strokes.len(), plans.len());
        assert_eq!((lost.late, lost.unusable, lost.repeated), (0, 0, 0));
        for (plan, stroke) in plans.iter().zip(&strokes) {
            let setting = Setting { surface_z_m: SURFACE_M, width_m: 0.127, ..Setting::default() };
            check(plan, &evaluate(stroke, &setting).unwrap());
        }
    }
}

#[test]
fn a_touch_is_no_stroke() {
    let mut finder = Finder::new(FindSettings::default());
    let sample = |i: i32, force: f64| soilctl_process::RobotSample {
        t_s: f64::from(i) * 0.002,
        tip_m: [0.4, 0.0, -0.33 - 0.001 * force],
        down_plate: [0.0, 0.0, -1.0],
        wrench: [0.0, 0.0, force, 0.0, 0.0, 0.0],
        to_root: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };
    let mut contacts = Vec::new();
    for i in 0..3000 {
        contacts.extend(finder.push(sample(i, if (1000..1400).contains(&i) { 2.0 } else { 0.0 })));
    }
    assert!(matches!(contacts[..], [Contact::Other(other)] if other.travel_m < 1e-9));
}

#[test]
fn numbers_that_are_none_and_late_messages_are_counted() {
    let mut aligner = Aligner::new(robot(), 0.1);
    let still = || NAMES.iter().copied().zip([0.0, 0.5, 1.0, 0.0, 0.3]);
    for i in 0..100 {
        let t = f64::from(i) * 0.01;
        aligner.joints(t, still());
        aligner.wrench(t + 0.001, [0.0; 6]);
        while aligner.next(false).unwrap().is_some() {}
    }
    aligner.wrench(0.2, [0.0; 6]);
    aligner.wrench(1.5, [f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0]);
    aligner.joints(f64::INFINITY, still());
    let lost = aligner.lost();
    assert_eq!((lost.late, lost.unusable, lost.repeated, lost.gaps), (1, 2, 0, 0));
    let mut nothing = Aligner::new(robot(), 0.1);
    nothing.joints(0.0, [("base", 0.0), ("elbow", 1.0)].into_iter());
    assert_eq!(nothing.missing_joints(), ["shoulder", "twist", "wrist"]);
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
    evaluate(&strokes[0], &Setting { surface_z_m: SURFACE_M, width_m: 0.127, ..Setting::default() }).unwrap()
}

/// An arm turns the plate while it pulls: friction counts from the plate as it is then.
#[test]
fn a_plate_that_turns_has_the_same_friction_angle() {
    for turn_deg in [-4.0, 3.0] {
        let found = evaluated(&Plan { turn_deg, ..Plan::steady(90.0, 0.4318, 10.0, 0.0254) });
        let Outcome::Found(point) = &found.analysis.outcome else { panic!("{:?}", found.analysis.outcome) };
        assert!((found.row.friction_angle_deg.unwrap() - 23.0).abs() < 0.3);
        assert!((found.slip.unwrap().angle_deg - 23.0).abs() < 0.3);
        let turned_deg = found.turned_deg.unwrap();
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
