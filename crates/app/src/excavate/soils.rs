//! Which soils are possible: told by numbers, by an estimate, or that of the box alone.

use soilctl_digging::Soils;
use soilctl_plant::SoilPreset;

use super::request::{Request, interval};
use crate::estimate::{self, Beside};
use crate::{AppError, Watch};

/// The possible soils, and what to keep in mind.
pub(super) fn possible(
    request: &Request,
    preset: &SoilPreset,
    watch: &dyn Watch,
) -> Result<(Soils, Vec<String>), AppError> {
    if preset.cohesion_pa != 0.0 {
        return Err(AppError::Request(format!(
            "the soil {} has a cohesion of {} Pa; passes are planned for soils without cohesion: choose another --soil",
            preset.name, preset.cohesion_pa
        )));
    }
    let of = |key: &str, given: &Option<Vec<f64>>, own: f64| match given {
        Some(given) => interval(key, given),
        None => Ok([own; 2]),
    };
    let delta_deg = of("delta", &request.delta_deg, preset.delta_deg)?;
    let density_kg_m3 = of("density", &request.density_kg_m3, preset.density_kg_m3)?;
    let mut warnings = Vec::new();
    let soils = match &request.strokes {
        None => {
            let phi_deg = of("phi", &request.phi_deg, preset.phi_deg)?;
            Soils::within(phi_deg, delta_deg, density_kg_m3, preset.gravity_m_s2)?
        }
        Some(file) => {
            let asked = estimate::Request {
                confidence: None,
                ..Beside { model: request.model.clone(), ..Beside::default() }.request(file)
            };
            let found = estimate::run(&asked, watch)?;
            let (low, high) = found.inputs.delta_deg;
            let delta_deg = if request.delta_deg.is_some() { delta_deg } else { [low, high] };
            let soils = Soils::of_region(&found.estimate.region, delta_deg, preset.gravity_m_s2)?;
            warnings.extend(found.answer.warnings.iter().cloned());
            soils.ok_or_else(|| {
                AppError::Request(
                    "no soil explains the strokes, so none is possible; `soilctl diagnose` says which effect is missing"
                        .into(),
                )
            })?
        }
    };
    let [phi, density] = soils.ranges();
    let [delta_low, delta_high] = soils.delta_deg();
    let holds = |[low, high]: [f64; 2], value: f64| value >= low - 1e-9 && value <= high + 1e-9;
    if !(holds(phi, preset.phi_deg)
        && holds(density, preset.density_kg_m3)
        && holds([delta_low, delta_high], preset.delta_deg))
    {
        warnings.push(format!(
            "the soil of the box (phi {} deg, delta {} deg, {} kg/m3) is none of those that are thought possible: what is said of all of them need \
             not hold of it",
            preset.phi_deg, preset.delta_deg, preset.density_kg_m3
        ));
    }
    Ok((soils, warnings))
}
