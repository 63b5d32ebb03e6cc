//! Controller and plant together, for tests.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::print_stdout)]

use soilctl_controller::{
    Event, EventKind, Mode, Params, Request, SequenceId, StrokeLaw, StrokePlan, StrokeSpec, Tunable,
};
use soilctl_earth_pressure::model;
use soilctl_kinematics::{Arm, JointAngles, TaskPose};
use soilctl_plant::{Ground, Plant, PlantParams, Simulation, SoilPreset, Tick};

pub const SURFACE_Z_M: f64 = -0.3302;

pub fn ground(params: &PlantParams, soil: &str, force_model: &str) -> Ground {
    let (preset, model) = (SoilPreset::named(soil).unwrap(), model(force_model).unwrap());
    Ground::new(params, &preset, model.as_ref(), SURFACE_Z_M, 5).unwrap()
}

/// A homed arm that is switched on at these joints.
pub fn homed(params: Params, plant: PlantParams, ground: Option<Ground>, joints: &JointAngles) -> Simulation {
    let encoders = plant.config().encoders;
    let plant = Plant::new(plant, ground, joints, 11).unwrap();
    let mut simulation = Simulation::new(params, plant);
    let state = simulation.state_mut();
    (state.homed, state.filters.offset_known) = (true, true);
    state.filters.motor_zero = encoders.motor_offset_counts;
    state.filters.external_zero = encoders.external_offset_counts;
    simulation.tick(Some(Request::Enable), &mut |_| {}).unwrap();
    assert_eq!(simulation.state().mode, Mode::Ready, "{:?}", simulation.state().fault);
    simulation
}

pub fn above(radius_m: f64, base_deg: f64, alpha_deg: f64, height_m: f64) -> JointAngles {
    let pose = TaskPose::digging(radius_m, base_deg.to_radians(), height_m, alpha_deg.to_radians()).unwrap();
    Arm::thesis().inverse(&pose).unwrap()
}

pub fn spec(radius_m: f64, alpha_deg: f64, slant_m: f64, delta_deg: f64) -> StrokeSpec {
    StrokeSpec {
        batch: 0,
        radius_m,
        base_rad: 0.0,
        tool_angle_rad: alpha_deg.to_radians(),
        depth_m: slant_m * alpha_deg.to_radians().sin(),
        delta_rad: delta_deg.to_radians(),
    }
}

pub fn plan(text: &str) -> Params {
    let plan = StrokePlan::from_toml(text, "plan").unwrap();
    Params::from_toml(Arm::thesis(), soilctl_controller::DEFAULT, "default", plan).unwrap()
}

/// What a stroke showed.
#[derive(Debug, Default, Clone)]
pub struct Trace {
    pub events: Vec<(u64, Event)>,
    pub rows: Vec<Row>,
}

/// One tick of a trace.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    pub stroking: bool,
    /// In-plane force by the sensor, its bias taken off, in N.
    pub force_n: f64,
    pub soil: soilctl_plant::SoilTruth,
    pub radius_m: f64,
    pub z_m: f64,
}

impl Trace {
    pub fn note(&mut self, tick: Tick<'_>) {
        let telemetry = &tick.outputs.telemetry;
        let [r, _, z] = telemetry.force_rtz_n;
        let tip = tick.truth.tip_m;
        self.events.extend(tick.outputs.events.as_slice().iter().map(|event| (tick.outputs.tick, *event)));
        self.rows.push(Row {
            stroking: telemetry.trajectory == Some(soilctl_controller::TrajectoryKind::Stroke),
            force_n: r.hypot(z),
            soil: tick.truth.soil,
            radius_m: tip[0].hypot(tip[1]),
            z_m: tip[2],
        });
    }

    pub fn find(&self, kind: EventKind) -> Option<Event> {
        self.events.iter().map(|(_, event)| *event).find(|event| event.kind == kind)
    }
}

/// One whole stroke in fresh soil, from above it.
pub fn stroke(soil: &str, force_model: &str, spec: StrokeSpec, law: StrokeLaw) -> (bool, Trace) {
    stroke_on(PlantParams::thesis(), soil, force_model, spec, law)
}

/// The same on another plant.
pub fn stroke_on(
    plant: PlantParams,
    soil: &str,
    force_model: &str,
    spec: StrokeSpec,
    law: StrokeLaw,
) -> (bool, Trace) {
    let ground = ground(&plant, soil, force_model);
    let start = above(spec.radius_m, 0.0, spec.tool_angle_rad.to_degrees(), SURFACE_Z_M + 0.02);
    let mut simulation = homed(Params::thesis(), plant, Some(ground), &start);
    let mut trace = Trace::default();
    for request in [Request::Tune(Tunable::Law(law)), Request::Stroke(spec)] {
        simulation.tick(Some(request), &mut |_| {}).unwrap();
    }
    let done = simulation
        .run_sequence(SequenceId::InsertStrokePullout, 60_000, &mut |tick| trace.note(tick))
        .unwrap();
    if !done {
        println!("{:?}", simulation.state().fault);
        for (tick, event) in &trace.events {
            println!("{tick} {:?} {} {:.5} {:.5}", event.kind, event.index, event.value, event.limit);
        }
    }
    (done, trace)
}
