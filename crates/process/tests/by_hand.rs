//! A plate that is led by hand leaves a log like any other: it replays, the simulated arm makes it again from its commands, and its drags
//! are measured.
#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "tests")]

use std::fs::File;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_campaign::{Plan, logged_truth};
use soilctl_controller::{Commands, HandTarget, Mode, Request, TICK_S, Trajectory};
use soilctl_process::Outcome;
use soilctl_process::log::{Candidate, LogSettings, LogStroke, NoStroke, read_log};
use soilctl_session::messages::{ControllerStep, decode};
use soilctl_session::read::{Item, scan};
use soilctl_session::{Logger, Pace, SessionError, replay, topics};

const SEED: u64 = 5;
/// Ticks between two words of the hand.
const EVERY: u64 = 15;
const SURFACE_M: f64 = -0.3302;
/// Ticks of the log, and when the hand lets go.
const TICKS: u64 = 18_500;
const LET_GO: u64 = 17_800;

/// Where the hand is at a time in s: radius in m and height above the soil in m. It goes 70 mm along the ground in `drag_s`.
fn hand(time_s: f64, drag_s: f64) -> [f64; 2] {
    let path = [
        (0.5, 0.43, 0.03),
        (13.0, 0.43, 0.03),
        (18.0, 0.43, -0.025),
        (19.0, 0.43, -0.025),
        (19.0 + drag_s, 0.36, -0.025),
        (20.0 + drag_s, 0.36, -0.025),
        (23.0 + drag_s, 0.36, 0.03),
        (36.0, 0.36, 0.03),
    ];
    let after = path.iter().position(|(time, ..)| *time > time_s).unwrap_or(path.len());
    let (from, to) = (path[after.max(1) - 1], path[after.min(path.len() - 1)]);
    let share = if to.0 > from.0 { ((time_s - from.0) / (to.0 - from.0)).clamp(0.0, 1.0) } else { 0.0 };
    [from.1 + share * (to.1 - from.1), from.2 + share * (to.2 - from.2)]
}

/// Digs into a log; returns the limit force in N of the soil when it first failed ahead of the plate that was dragged.
fn dig(soil: &str, drag_s: f64, path: &Path) -> f64 {
    let plan = Plan::by_hand(soil, SEED).unwrap();
    let setup = plan.setup(SEED).unwrap();
    let mut simulation = plan.simulation(&setup, SEED, 0).unwrap();
    let (logger, mut recorder) = Logger::start(File::create(path).unwrap(), &setup, Pace::Simulated).unwrap();
    let mut limit_n = 0.0_f64;
    // How far the elbow's motor wanders in free air while the hand is still, and after it has let go. The link hangs in its free play.
    let mut still = [[f64::MAX, f64::MIN]; 3];
    for tick in 0..TICKS {
        let time_s = tick as f64 * TICK_S;
        let [radius_m, up_m] = hand(time_s, drag_s);
        let target = HandTarget {
            x_m: radius_m,
            y_m: 0.0,
            z_m: SURFACE_M + up_m,
            tool_angle_rad: 90_f64.to_radians(),
        };
        let request = match tick {
            0 => Some(Request::Enable),
            50 => Some(Request::BiasForce),
            250..LET_GO if tick % EVERY == 0 => Some(Request::Push(Trajectory::Follow { hand: 7, target })),
            _ => None,
        };
        assert!(recorder.before(simulation.state()));
        let outputs = simulation
            .tick(request, &mut |tick| {
                let truth = Some(logged_truth(tick.truth));
                assert!(recorder.after(tick.sensed, tick.commands, tick.outputs, tick.state, truth));
                let soil = tick.truth.soil;
                if limit_n == 0.0 && time_s > 19.0 && soil.failing && soil.normal_n > 0.0 {
                    limit_n = soil.limit_force_now_n;
                }
            })
            .unwrap();
        assert!(tick == 0 || outputs.mode == Mode::Ready, "{:?}", simulation.state().fault);
        let place = [(11.5, 13.0), (34.5, 35.5), (36.0, 37.0)]
            .iter()
            .position(|(from, to)| time_s > *from && time_s < *to);
        if let Some([least, most]) = place.and_then(|place| still.get_mut(place)) {
            let elbow_deg = outputs.telemetry.motor_joints.degrees()[2];
            (*least, *most) = (least.min(elbow_deg), most.max(elbow_deg));
        }
    }
    for [least, most] in still {
        assert!(most - least < 0.1, "the elbow hunts through its free play: {least} to {most} deg");
    }
    drop(recorder);
    logger.finish().unwrap();
    limit_n
}

fn steps(path: &Path) -> Vec<ControllerStep> {
    let mut steps = Vec::new();
    scan::<SessionError>(path, &mut |item| {
        if let Item::Message(message) = item
            && message.channel.topic == topics::STEP
        {
            steps.push(decode(message.data).unwrap());
        }
        Ok(())
    })
    .unwrap();
    steps
}

#[test]
fn a_drag_is_replayed_simulated_again_and_measured() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("dig.mcap");
    let limit_n = dig("ticino_loose", 8.0, &path);
    let again = replay(&path, 0).unwrap();
    assert!(again.is_identical() && again.steps == TICKS, "{again:?}");

    // The commands in the log are all that the hand did: a new arm in new soil makes the same of them, bit for bit.
    let plan = Plan::by_hand("ticino_loose", SEED).unwrap();
    let mut simulation = plan.simulation(&plan.setup(SEED).unwrap(), SEED, 0).unwrap();
    for step in steps(&path) {
        let commands: Commands = step.commands().unwrap();
        let mut same = false;
        simulation.tick_with(&commands, |_| {}, &mut |tick| same = *tick.sensed == step.sensed()).unwrap();
        assert!(same, "step {} of the simulated arm is another one", step.step);
    }

    let (strokes, rejected) = measured(&path);
    assert_eq!((strokes.len(), rejected.len()), (1, 0), "{rejected:?}");
    let (row, analysis) = (&strokes[0].evaluated.row, &strokes[0].evaluated.analysis);
    println!("{} N of {limit_n} N at {} m", row.force_n, row.depth_m);
    assert!(matches!(analysis.outcome, Outcome::Found(_)), "{:?}", analysis.outcome);
    // Of the same soil a little deeper or less deep, a few ticks before or after.
    assert!((row.force_n / limit_n - 1.0).abs() < 0.1, "{} N, in truth {limit_n} N", row.force_n);
    assert!((row.depth_m - 0.025).abs() < 0.003 && (row.alpha_deg - 90.0).abs() < 3.0, "{row:?}");
}

/// Faster, the failure does not show, and the force is greatest where the heap is: that is said, and no force is told.
#[test]
fn the_force_of_a_heap_is_none_of_the_soil() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("dig.mcap");
    dig("ticino_loose", 6.0, &path);
    let (strokes, rejected) = measured(&path);
    assert_eq!((strokes.len(), rejected.len()), (0, 1), "{rejected:?}");
    assert!(rejected[0].refused && rejected[0].reason.contains("heaped up"), "{rejected:?}");
}

fn measured(path: &Path) -> (Vec<LogStroke>, Vec<NoStroke>) {
    let (mut strokes, mut rejected) = (Vec::new(), Vec::new());
    read_log(path, &LogSettings::default(), &AtomicBool::new(false), &mut |candidate| match candidate {
        Candidate::Stroke(stroke) => strokes.push(*stroke),
        Candidate::Rejected(no_stroke) => rejected.push(no_stroke),
    })
    .unwrap();
    (strokes, rejected)
}
