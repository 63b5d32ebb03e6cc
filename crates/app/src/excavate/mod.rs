//! Trenches that are dug at little cost to the motors: which forces fail the soil, at which tool angle, how deep a pass may be.

mod answer;
mod dug;
mod files;
mod request;
mod soils;
mod words;

use soilctl_controller::Params;
use soilctl_digging::{
    Aim, Bite, Cost, DiggingError, Pass, Push, Rules, Soils, Surface, Task, borne, load, passes, way,
};
use soilctl_earth_pressure::{ForceModel, plane_model};
use soilctl_plant::SoilPreset;
use soilctl_soil::Angle;

pub use answer::{AngleRow, Answer, Becomes, DugRow, DugTrench, Ended, ForceRow, Learned, Manner, PassRow};
pub use request::{Least, Request};

use crate::files::{can_be_written, table_form};
use crate::{AppError, Watch};

/// Step of the tool angles that are told, in deg.
const ANGLE_STEP_DEG: f64 = 5.0;
/// Step of the inclinations that are told, in deg.
const INCLINATION_STEP_DEG: f64 = 5.0;

/// Plans a trench, and digs it on the simulated arm if that is asked.
///
/// # Errors
/// [`AppError`] if soils, angles or places make no sense or cannot be reached, or a file cannot be written. That no pass keeps the torque share is an
/// answer.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    if let Some(path) = &request.table {
        can_be_written(path)?;
        table_form(path)?;
    }
    let preset = SoilPreset::named(&request.soil).map_err(soilctl_campaign::CampaignError::from)?;
    let (before, mut warnings) = soils::possible(request, &preset, watch)?;
    let model = plane_model(&request.model)?;
    let plan = files::plan(request, &before, request.angles_deg()?)?;
    let params = plan.params();
    let (trench, rules) = (request.trench(), request.rules(plan.plant().config().drives.friction_nm)?);
    let repose = Angle::from_degrees(before.ranges()[0][0]);
    let surface = Surface::level(plan.plant(), params.config().site.surface_z_m, repose)?;
    let (planned, complete) = passes(params, model.as_ref(), &before, surface.clone(), &trench, &rules)?;
    let task = Task {
        radius_m: trench.radius_m,
        base_rad: trench.base_rad,
        surface_z_m: params.config().site.surface_z_m,
        depth_m: planned.first().map_or(rules.least_m, |pass| pass.stroke.depth_m),
        length_m: trench.length_m,
        friction_nm: rules.friction_nm,
    };
    // What it pushes ahead on level ground, whatever its tool angle.
    let heaps_m = surface.heaps_m(&task.stroke(dug::FIXED_DEG, before.delta_deg()[1]), trench.length_m)?;
    let alpha_deg = match planned.first() {
        Some(pass) => pass.cost.tool_angle_deg,
        None => task
            .best(params, model.as_ref(), &before, rules.angles_deg, rules.aim, &heaps_m)?
            .map_or(rules.angles_deg[0], |cost| cost.tool_angle_deg),
    };
    let forces = forces(params, model.as_ref(), &before, &task, alpha_deg)?;
    let angles = angles(params, model.as_ref(), &before, &task, &heaps_m, &rules)?;
    if angles.iter().any(|row| row.bears_n.is_none()) {
        warnings.push(format!(
            "no lower bound is known for some tool angles, which `{}` does not cover; what is enough to fail the soil is told by Chen and Liu's upper bound there",
            request.model
        ));
    }
    let files = files::write(request, &planned, &before, &plan)?;
    let dug = if request.dig {
        dug::all(&plan, request, model.as_ref(), &before, &trench, &rules, watch)?
    } else {
        Vec::new()
    };
    let [phi_deg, density_kg_m3] = before.ranges();
    let passes: Vec<PassRow> = planned.iter().map(row).collect();
    let mut answer = Answer {
        soil: request.soil.clone(),
        phi_deg,
        delta_deg: before.delta_deg(),
        density_kg_m3,
        least: request.least,
        share: request.share,
        at: [alpha_deg, task.depth_m],
        forces,
        angles,
        passes,
        complete,
        dug,
        files,
        verdict: String::new(),
        warnings,
    };
    answer.verdict = words::verdict(&answer, request);
    if let Some(path) = &request.table {
        answer.write_table(path)?;
    }
    Ok(answer)
}

fn row(pass: &Pass) -> PassRow {
    PassRow {
        alpha_deg: pass.cost.tool_angle_deg,
        depth_m: pass.stroke.depth_m,
        fails_n: pass.cost.force_n.1,
        share: pass.cost.share,
    }
}

/// Forces by inclination at the begin of a stroke.
fn forces(
    params: &Params,
    model: &dyn ForceModel,
    soils: &Soils,
    task: &Task,
    alpha_deg: f64,
) -> Result<Vec<ForceRow>, AppError> {
    let width_m = params.arm().config().plate.width_m;
    let bite = Bite { tool_angle_deg: alpha_deg, depth_m: task.depth_m, heap_m: 0.0, width_m };
    let up_m = task.depth_m / libm::sin(alpha_deg.to_radians()) / 3.0;
    let at = way(params, &task.stroke(alpha_deg, 0.0), task.surface_z_m, task.length_m)?;
    let mut rows = Vec::new();
    for inclination_deg in inclinations(soils) {
        let found = borne(model, soils, &bite, inclination_deg)?;
        let share = match (found.fails_n, at.joints.first()) {
            (Some(force_n), Some(joints)) => {
                let push = Push { force_n, inclination_rad: inclination_deg.to_radians(), up_m };
                Some(load(params, joints, &push, &task.friction_nm)?.share)
            }
            _ => None,
        };
        rows.push(ForceRow {
            inclination_deg,
            plate: found.contact.into(),
            bears_n: found.bears_n,
            fails_n: found.fails_n,
            share,
        });
    }
    Ok(rows)
}

/// From as steep upwards as the plate may hold to the least friction angle downwards, with the friction on the plate among them.
fn inclinations(soils: &Soils) -> Vec<f64> {
    let [low, high] = soils.delta_deg();
    let least_phi = soils.ranges()[0][0];
    let mut all = vec![-high, -low, low, high, least_phi];
    let steps = (least_phi / INCLINATION_STEP_DEG).floor().clamp(0.0, 24.0);
    #[allow(clippy::cast_possible_truncation, reason = "at most 24")]
    for i in -(steps as i32)..=steps as i32 {
        let deg = f64::from(i) * INCLINATION_STEP_DEG;
        if deg >= -high {
            all.push(deg);
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    all
}

/// Costs of tool angles that the arm reaches.
fn angles(
    params: &Params,
    model: &dyn ForceModel,
    soils: &Soils,
    task: &Task,
    heaps_m: &[f64],
    rules: &Rules,
) -> Result<Vec<AngleRow>, AppError> {
    let [low, high] = rules.angles_deg;
    let steps = ((high - low) / ANGLE_STEP_DEG).floor().clamp(0.0, 18.0);
    let mut degrees: Vec<f64> = Vec::new();
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 18")]
    for i in 0..=steps as u32 {
        degrees.push(low + ANGLE_STEP_DEG * f64::from(i));
    }
    let best = task.best(params, model, soils, rules.angles_deg, rules.aim, heaps_m)?;
    degrees.extend(best.as_ref().map(|cost| cost.tool_angle_deg));
    degrees.push(dug::FIXED_DEG);
    degrees.sort_by(f64::total_cmp);
    degrees.dedup_by(|a, b| (*a - *b).abs() < 0.1);
    let mut rows = Vec::new();
    for deg in degrees {
        match task.cost(params, model, soils, deg, heaps_m) {
            Ok(cost) => rows.push(angle(&cost)),
            // Out of the arm's reach.
            Err(DiggingError::Kinematics(_) | DiggingError::WayEnds { .. }) => {}
            Err(other) => return Err(other.into()),
        }
    }
    Ok(rows)
}

fn angle(cost: &Cost) -> AngleRow {
    AngleRow {
        alpha_deg: cost.tool_angle_deg,
        end_alpha_deg: cost.turns_deg[1],
        bears_n: cost.force_n.0,
        fails_n: cost.force_n.1,
        share: cost.of(Aim::Torque),
        heat_a2: cost.of(Aim::Heat),
        work_kj_m3: 1e-3 * cost.of(Aim::Work),
    }
}
