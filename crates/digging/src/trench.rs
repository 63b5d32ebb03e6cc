//! A trench in passes: as deep each as the torque limits allow in every soil that is still consistent, replanned after each pass.

use soilctl_controller::{Params, StrokeSpec};
use soilctl_earth_pressure::ForceModel;

use crate::choice::{Aim, Cost, Task};
use crate::{DiggingError, Soils, Surface};

/// Most passes of a trench.
pub(crate) const MOST_PASSES: usize = 40;
/// What is left of a depth counts as nothing, in m: the touch does not find the floor better.
pub(crate) const DONE_M: f64 = 0.0015;
/// A pass that cuts less deeper than this, in m, is none.
const DEEPER_M: f64 = 0.0005;
/// Accuracy of the depth of a pass in m.
const ACCURACY_M: f64 = 0.0002;

/// A trench along a radius of the arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trench {
    /// Radius of its far end, where strokes begin, in m.
    pub radius_m: f64,
    /// Base angle in rad.
    pub base_rad: f64,
    /// Length towards the base in m.
    pub length_m: f64,
    /// Depth of its floor below the level surface in m.
    pub depth_m: f64,
}

impl Trench {
    /// A stroke over its whole length at a tool angle (deg), to a depth below the surface where it goes in (m), but for the friction on the plate.
    #[must_use]
    pub fn stroke(&self, tool_angle_deg: f64, depth_m: f64) -> StrokeSpec {
        StrokeSpec {
            batch: 0,
            radius_m: self.radius_m,
            base_rad: self.base_rad,
            tool_angle_rad: tool_angle_deg.to_radians(),
            depth_m,
            delta_rad: 0.0,
        }
    }
}

/// What passes must keep to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rules {
    /// Greatest share of a torque limit in any soil that is consistent.
    pub share: f64,
    /// Interval of tool angles in deg.
    pub angles_deg: [f64; 2],
    /// What is to be least among tool angles that keep the share.
    pub aim: Aim,
    /// Dry friction of the drives in N m, by motor.
    pub friction_nm: [f64; 5],
    /// Least depth of a pass in m: below it the touch and the play of the arm count for more.
    pub least_m: f64,
    /// Greatest depth of a pass in m.
    pub most_m: f64,
}

/// A pass that was planned.
#[derive(Debug, Clone, PartialEq)]
pub struct Pass {
    /// The stroke.
    pub stroke: StrokeSpec,
    /// What it takes at most.
    pub cost: Cost,
    /// The heap ahead at its begin in m.
    pub heap_m: f64,
}

/// The next pass of a trench, from the surface as it is at its far end; `None` if even the least pass would take more than the share allowed.
///
/// # Errors
/// As [`Task::cost`]; [`DiggingError::OutOfReach`] if the arm reaches no tool angle there.
pub fn next_pass(
    params: &Params,
    model: &dyn ForceModel,
    soils: &Soils,
    surface: &Surface,
    trench: &Trench,
    rules: &Rules,
) -> Result<Option<Pass>, DiggingError> {
    let level_m = params.config().site.surface_z_m;
    let first = trench.stroke(90.0, 0.0);
    // Where soil has run off the far wall the plate would stand in a slope, above the floor that it is to cut.
    let begin_m = trench.radius_m - surface.floor_begins_m(&first, trench.length_m);
    let trench = &Trench { radius_m: begin_m, ..*trench };
    let left_m = surface.under_m(&trench.stroke(90.0, 0.0)).unwrap_or(level_m) - (level_m - trench.depth_m);
    let most_m = left_m.min(rules.most_m).max(rules.least_m);
    let least_m = rules.least_m;
    let at = |depth_m: f64| pass(params, model, soils, surface, trench, rules, depth_m);
    let Some(mut best) = at(least_m)? else { return Ok(None) };
    if let Some(whole) = at(most_m)? {
        return Ok(Some(whole));
    }
    let (mut low, mut high) = (least_m, most_m);
    while high - low > ACCURACY_M {
        let middle = f64::midpoint(low, high);
        match at(middle)? {
            Some(found) => (low, best) = (middle, found),
            None => high = middle,
        }
    }
    Ok(Some(best))
}

/// The passes of a trench as they are planned beforehand, and whether they make its whole depth: until a pass would take more than its share, or cuts
/// no deeper than what has run off since the last.
///
/// # Errors
/// As [`next_pass`].
pub fn passes(
    params: &Params,
    model: &dyn ForceModel,
    soils: &Soils,
    mut surface: Surface,
    trench: &Trench,
    rules: &Rules,
) -> Result<(Vec<Pass>, bool), DiggingError> {
    let wanted_m = params.config().site.surface_z_m - trench.depth_m;
    let mut found: Vec<Pass> = Vec::new();
    let mut floor_m = f64::INFINITY;
    while found.len() < MOST_PASSES {
        let Some(pass) = next_pass(params, model, soils, &surface, trench, rules)? else { break };
        let reached_m = surface.under_m(&pass.stroke).unwrap_or(wanted_m) - pass.stroke.depth_m;
        if reached_m > floor_m - DEEPER_M {
            break;
        }
        floor_m = reached_m;
        surface.stroke(&pass.stroke, trench.length_m)?;
        found.push(pass);
        if floor_m <= wanted_m + DONE_M {
            return Ok((found, true));
        }
    }
    Ok((found, false))
}

/// A pass of a depth (m), if it keeps to the rules.
fn pass(
    params: &Params,
    model: &dyn ForceModel,
    soils: &Soils,
    surface: &Surface,
    trench: &Trench,
    rules: &Rules,
    depth_m: f64,
) -> Result<Option<Pass>, DiggingError> {
    let delta_deg = soils.delta_deg()[1];
    let mut task = Task {
        radius_m: trench.radius_m,
        base_rad: trench.base_rad,
        surface_z_m: 0.0,
        depth_m,
        length_m: trench.length_m,
        friction_nm: rules.friction_nm,
    };
    // The tool angle changes neither place nor heap.
    let stroke = task.stroke(90.0, delta_deg);
    task.surface_z_m = surface.under_m(&stroke).unwrap_or(params.config().site.surface_z_m);
    let heaps_m = surface.heaps_m(&stroke, trench.length_m)?;
    let of = |aim| task.best(params, model, soils, rules.angles_deg, aim, &heaps_m);
    let Some(mut cost) = of(rules.aim)? else {
        return Err(DiggingError::OutOfReach {
            radius_m: trench.radius_m,
            low_deg: rules.angles_deg[0],
            high_deg: rules.angles_deg[1],
        });
    };
    if cost.share > rules.share && rules.aim != Aim::Torque {
        let Some(least) = of(Aim::Torque)? else { return Ok(None) };
        cost = least;
    }
    let heap_m = heaps_m.first().copied().unwrap_or(0.0);
    let stroke = task.stroke(cost.tool_angle_deg, delta_deg);
    Ok((cost.share <= rules.share).then_some(Pass { stroke, cost, heap_m }))
}
