//! Campaigns on the simulated arm, logged as real ones are, and what only the simulation knows of them.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, reason = "helpers of tests")]

use std::path::Path;

use soilctl_controller::{EventKind, Mode, Params, Request, SequenceId, TrajectoryKind};
use soilctl_earth_pressure::model;
use soilctl_kinematics::{Arm, JointAngles, TaskPose};
use soilctl_plant::{Ground, Plant, PlantParams, Simulation, SoilPreset};
use soilctl_session::messages::SoilTruth;
use soilctl_session::{Logger, Pace, Setup, StepRecord, Truth};

const SURFACE_Z_M: f64 = -0.3302;

/// What the simulation knows of a stroke.
#[derive(Debug, Clone, Copy, Default)]
pub struct TrueStroke {
    /// Depth of the edge when the stroke began in m.
    pub depth_m: f64,
    /// Force on the plate when the soil failed, in N; 0 if it did not.
    pub failure_n: f64,
    /// The model's force at full friction then, in N.
    pub limit_n: f64,
    /// Depth then.
    pub failure_depth_m: f64,
    /// Tool angle then, in deg.
    pub failure_alpha_deg: f64,
}

/// A stroke of a plan.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    pub base_deg: f64,
    pub alpha_deg: f64,
    pub slant_m: f64,
    pub delta_deg: f64,
}

/// Runs one batch at a radius into a log; what is true of its strokes.
pub fn batch(
    path: &Path,
    soil: &str,
    radius_m: f64,
    strokes: &[Wanted],
    seed: u64,
    truth_scale: f64,
) -> Vec<TrueStroke> {
    let mut plan = String::from("version = 1\n\n[[batches]]\nstrokes = [\n");
    for s in strokes {
        let depth_m = s.slant_m * s.alpha_deg.to_radians().sin();
        plan += &format!(
            "  {{ radius_m = {radius_m:?}, base_deg = {:?}, alpha_deg = {:?}, depth_m = {depth_m:?}, delta_set_deg = {:?} }},\n",
            s.base_deg, s.alpha_deg, s.delta_deg
        );
    }
    plan += "]\n";
    let thesis = Params::thesis();
    let setup = Setup::new(thesis.arm().config(), thesis.config(), &plan, seed, "table").unwrap();
    let params = setup.params().unwrap();
    let plant_params = PlantParams::thesis();
    let encoders = plant_params.config().encoders;
    let mut ground = Ground::new(
        &plant_params,
        &SoilPreset::named(soil).unwrap(),
        model("table").unwrap().as_ref(),
        SURFACE_Z_M,
        seed,
    )
    .unwrap();
    ground.prepare();
    let first = strokes[0];
    let pose = TaskPose::digging(
        radius_m,
        first.base_deg.to_radians(),
        SURFACE_Z_M + 0.09,
        first.alpha_deg.to_radians(),
    )
    .unwrap();
    let start: JointAngles = Arm::thesis().inverse(&pose).unwrap();
    let plant = Plant::new(plant_params, Some(ground), &start, seed).unwrap();
    let mut simulation = Simulation::new(params, plant);
    let state = simulation.state_mut();
    (state.homed, state.filters.offset_known) = (true, true);
    state.filters.motor_zero = encoders.motor_offset_counts;
    state.filters.external_zero = encoders.external_offset_counts;
    let (logger, mut recorder) = Logger::create(path, &setup, Pace::Simulated).unwrap();
    let mut found = Vec::new();
    let mut stroking = false;
    let mut request = Some(Request::Enable);
    for tick in 0..600_000u32 {
        if tick == 1 {
            request = Some(Request::Start(SequenceId::Campaign));
        }
        recorder.before(simulation.state());
        let mut ended = false;
        simulation
            .tick(request.take(), &mut |tick| {
                let soil = &tick.truth.soil;
                let [n, t] = [soil.normal_n, soil.tangent_n];
                let truth = Truth {
                    joints: tick.truth.joints,
                    soil: SoilTruth {
                        depth_m: soil.depth_m * truth_scale,
                        limit_force_n: soil.limit_force_n * truth_scale,
                        force_rtz_n: [n * truth_scale, 0.0, t * truth_scale],
                    },
                    ..Truth::default()
                };
                let record =
                    StepRecord::new(tick.sensed, tick.commands, tick.outputs, tick.state, Some(truth));
                recorder.after(tick.sensed, tick.commands, tick.outputs, tick.state, record.truth);
                let now = tick.outputs.telemetry.trajectory == Some(TrajectoryKind::Stroke);
                if now && !stroking {
                    found.push(TrueStroke { depth_m: soil.depth_m, ..TrueStroke::default() });
                }
                stroking = now;
                if let Some(stroke) = found.last_mut().filter(|s| now && soil.failing && s.failure_n == 0.0) {
                    stroke.failure_n = n.hypot(t);
                    stroke.limit_n = soil.limit_force_n;
                    stroke.failure_depth_m = soil.depth_m;
                    stroke.failure_alpha_deg = soil.tool_angle_rad.to_degrees();
                }
                let is = |wanted| tick.outputs.events.as_slice().iter().any(|event| event.kind == wanted);
                ended = is(EventKind::SequenceSucceeded(SequenceId::Campaign))
                    || is(EventKind::SequenceFailed(SequenceId::Campaign))
                    || (tick.outputs.mode != Mode::Ready && tick.sensed.tick > 2);
            })
            .unwrap();
        if ended {
            break;
        }
    }
    drop(recorder);
    logger.finish().unwrap();
    found
}
