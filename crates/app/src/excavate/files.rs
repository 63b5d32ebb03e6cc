//! A campaign plan of the passes, and the controller's settings for strokes as long as they are.

use std::path::Path;

use serde::Serialize;
use soilctl_campaign::Plan;
use soilctl_campaign::file::{Batch, Stroke};
use soilctl_controller::Params;
use soilctl_controller::config::{ControllerConfig, StrokeLaw};
use soilctl_digging::{Pass, Soils};

use super::request::Request;
use crate::AppError;
use crate::files::save;

/// Name of the settings, as the plan says it.
const CONTROLLER: &str = "controller.toml";

/// What stands in a plan file.
#[derive(Serialize)]
struct PlanText<'a> {
    version: u32,
    design: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    controller: Option<&'a str>,
    soil: &'a str,
    model: &'a str,
    seed: u64,
    batches: Vec<Batch>,
}

/// The plan whose soil is dug in, with one stroke that nobody makes, at the first tool angle of these (deg) that the arm reaches.
pub(super) fn plan(request: &Request, soils: &Soils, angles_deg: [f64; 2]) -> Result<Plan, AppError> {
    let [low, high] = angles_deg;
    let at = |part: f64| {
        let text = text(request, vec![stroke(request, soils, low + part * (high - low), 0.01)], None)?;
        Ok::<Plan, AppError>(Plan::from_toml(&text, "the plan of the trench", Path::new(""))?)
    };
    let mut plan = at(0.0);
    for part in 1..=8 {
        if plan.is_ok() {
            break;
        }
        plan = at(f64::from(part) / 8.0);
    }
    Ok(plan?.with_controller(settings(request))?)
}

/// The settings that soilctl brings along, but for what ends a stroke.
fn settings(request: &Request) -> ControllerConfig {
    let mut config = Params::thesis().config().clone();
    config.stroke.max_travel_m = request.length_m;
    // The depth is to be kept; the angle of the force, which measurements need, may vary.
    config.stroke.law = StrokeLaw::Position;
    config
}

/// Writes plan and settings, if that is asked; the names of the files.
pub(super) fn write(
    request: &Request,
    passes: &[Pass],
    soils: &Soils,
    plan: &Plan,
) -> Result<Vec<String>, AppError> {
    let Some(folder) = &request.out else { return Ok(Vec::new()) };
    if passes.is_empty() {
        return Ok(Vec::new());
    }
    std::fs::create_dir_all(folder)
        .map_err(|problem| AppError::File { path: folder.display().to_string(), problem })?;
    let strokes = passes
        .iter()
        .map(|pass| stroke(request, soils, pass.cost.tool_angle_deg, pass.stroke.depth_m))
        .collect();
    let toml = |problem: toml::ser::Error| AppError::Request(format!("the settings: {problem}"));
    let settings = toml::to_string(plan.controller()).map_err(toml)?;
    let mut names = Vec::new();
    for (name, text) in [(CONTROLLER, settings), ("plan.toml", text(request, strokes, Some(CONTROLLER))?)] {
        let path = folder.join(name);
        save(&path, text.as_bytes())?;
        names.push(path.display().to_string());
    }
    Ok(names)
}

/// To a tenth of a degree and of a millimetre, as people set them.
fn stroke(request: &Request, soils: &Soils, alpha_deg: f64, depth_m: f64) -> Stroke {
    let tenth = |value: f64| (10.0 * value).round() / 10.0;
    Stroke {
        radius_m: Some(request.radius_m),
        base_deg: request.base_deg,
        alpha_deg: tenth(alpha_deg),
        depth_m: 1e-3 * tenth(1e3 * depth_m),
        delta_set_deg: soils.delta_deg()[1],
    }
}

fn text(request: &Request, strokes: Vec<Stroke>, controller: Option<&str>) -> Result<String, AppError> {
    let plan = PlanText {
        version: 1,
        design: format!("a trench {} m long and {} m deep in passes", request.length_m, request.depth_m),
        controller,
        soil: &request.soil,
        model: "table",
        seed: request.seed,
        batches: vec![Batch { radius_m: None, strokes }],
    };
    toml::to_string(&plan).map_err(|problem| AppError::Request(format!("the plan: {problem}")))
}
