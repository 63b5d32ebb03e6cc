//! A trench dug on the simulated arm, pass by pass.

use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_campaign::Plan;
use soilctl_earth_pressure::ForceModel;
use soilctl_soil::Angle;

use crate::choice::Task;
use crate::learn::{Knowledge, Taught};
use crate::trench::{DONE_M, MOST_PASSES, Pass, Rules, Trench, next_pass};
use crate::{DiggingError, Dug, Machine, Soils, Surface};

/// A pass that was made.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// As it was planned.
    pub pass: Pass,
    /// What came of it.
    pub dug: Dug,
    /// Depth below the level surface that it cut to where it began, in m, by the sensors.
    pub floor_m: f64,
    /// What it taught; `None` if it was not asked.
    pub taught: Option<Taught>,
    /// Ranges of friction angle (deg) and density (kg/m3) of the soils that are consistent after it.
    pub ranges: [[f64; 2]; 2],
}

/// Why an excavation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The trench is as deep as wanted.
    Complete,
    /// No pass keeps to the torque share in all soils.
    TooStrong,
    /// A stroke was not made to its end.
    StrokeFailed,
    /// There were as many passes as there may be.
    TooManyPasses,
    /// It was broken off.
    Stopped,
}

/// A trench that was dug.
#[derive(Debug, Clone, PartialEq)]
pub struct Excavation {
    /// Passes in order.
    pub passes: Vec<Made>,
    /// Why it ended.
    pub end: End,
    /// Depth of the floor at the far end in m, as the passes have found and left it.
    pub depth_m: f64,
}

impl Excavation {
    /// Sum over passes.
    #[must_use]
    pub fn sum(&self, of: impl Fn(&Dug) -> f64) -> f64 {
        self.passes.iter().map(|made| of(&made.dug)).sum()
    }

    /// Greatest share of a torque limit in any pass, insertion or stroke.
    #[must_use]
    pub fn peak_share(&self) -> f64 {
        self.passes.iter().flat_map(|made| made.dug.peak_share).fold(0.0, f64::max)
    }
}

/// Makes the passes of another excavation again in fresh soil, as deep each and at the same places, at a fixed tool angle (deg): what it would have
/// taken. The share is not kept to, and costs are told without heaps.
///
/// # Errors
/// As [`Machine::stroke`] and [`Task::cost`].
#[allow(clippy::too_many_arguments, reason = "each is what it says")]
pub fn again(
    plan: &Plan,
    seed: u64,
    model: &dyn ForceModel,
    soils: &Soils,
    passes: &[Made],
    tool_angle_deg: f64,
    stop: &AtomicBool,
) -> Result<Excavation, DiggingError> {
    let level_z_m = plan.params().config().site.surface_z_m;
    let mut machine = Machine::new(plan, seed, 0)?;
    let mut found = Excavation { passes: Vec::new(), end: End::Complete, depth_m: 0.0 };
    for made in passes {
        if stop.load(Ordering::Relaxed) {
            found.end = End::Stopped;
            break;
        }
        let mut pass = made.pass.clone();
        pass.stroke.tool_angle_rad = tool_angle_deg.to_radians();
        let task = Task {
            radius_m: pass.stroke.radius_m,
            base_rad: pass.stroke.base_rad,
            surface_z_m: level_z_m - found.depth_m,
            depth_m: pass.stroke.depth_m,
            length_m: plan.params().config().stroke.max_travel_m,
            friction_nm: plan.plant().config().drives.friction_nm,
        };
        pass.cost = task.cost(plan.params(), model, soils, tool_angle_deg, &[])?;
        let dug = machine.stroke(&pass.stroke)?;
        if let Some(first) = dug.samples.first() {
            found.depth_m = level_z_m - first.z_m;
        }
        let done = dug.done;
        found.passes.push(Made { pass, dug, floor_m: found.depth_m, taught: None, ranges: made.ranges });
        if !done {
            found.end = End::StrokeFailed;
            break;
        }
    }
    Ok(found)
}

/// Digs a trench with the simulated arm in the soil of a plan, whose batch 0 is prepared; strokes of the plan are not made.
///
/// `before` are the soils that are thought possible; with `learns` each pass narrows them. What the arm does and finds by its sensors goes into the
/// next pass, and nothing of the truth.
///
/// # Errors
/// As [`next_pass`], [`Machine::stroke`] and [`Knowledge::take`].
#[allow(clippy::too_many_arguments, reason = "each is what it says")]
pub fn excavate(
    plan: &Plan,
    seed: u64,
    model: &dyn ForceModel,
    before: &Soils,
    trench: &Trench,
    rules: &Rules,
    learns: bool,
    stop: &AtomicBool,
) -> Result<Excavation, DiggingError> {
    let params = plan.params();
    let level_z_m = params.config().site.surface_z_m;
    let width_m = plan.plant().arm().config().plate.width_m;
    let mut machine = Machine::new(plan, seed, 0)?;
    let mut knowledge = Knowledge::new(model, before.clone());
    // The flattest slopes that are possible.
    let repose = Angle::from_degrees(before.ranges()[0][0]);
    let mut surface = Surface::level(plan.plant(), level_z_m, repose)?;
    let mut found = Excavation { passes: Vec::new(), end: End::TooManyPasses, depth_m: 0.0 };
    for _ in 0..MOST_PASSES {
        if stop.load(Ordering::Relaxed) {
            found.end = End::Stopped;
            break;
        }
        if trench.depth_m - found.depth_m <= DONE_M {
            found.end = End::Complete;
            break;
        }
        let soils = knowledge.soils().clone();
        let Some(pass) = next_pass(params, model, &soils, &surface, trench, rules)? else {
            found.end = End::TooStrong;
            break;
        };
        let dug = machine.stroke(&pass.stroke)?;
        let taught = if learns {
            Some(knowledge.take(&dug, pass.cost.tool_angle_deg, pass.heap_m, width_m)?)
        } else {
            None
        };
        let mut made = pass.stroke;
        // Where it goes in; on its way the plate sinks.
        if let Some(first) = dug.samples.first() {
            found.depth_m = level_z_m - first.z_m;
            made.depth_m = (dug.surface_z_m - first.z_m).max(1e-4);
        }
        surface.stroke(&made, dug.travel_m.max(1e-3))?;
        let done = dug.done;
        found.passes.push(Made {
            pass,
            dug,
            floor_m: found.depth_m,
            taught,
            ranges: knowledge.soils().ranges(),
        });
        if !done {
            found.end = End::StrokeFailed;
            break;
        }
    }
    Ok(found)
}
