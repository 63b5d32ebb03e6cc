//! The prediction of one plate given on the command line.

use soilctl_earth_pressure::{Case, ForceModel, Input, check_loads, sensitivity_percent};
use soilctl_soil::{Angle, Bracket, Interface, Plate, Soil};

use super::Request;
use super::answer::{Answer, Inputs, Sensitivity};
use super::chosen::Chosen;
use crate::AppError;
use crate::request::Ends;
use crate::request::NumberOrColumn;

/// Stands in for a quantity that was not given, so that the others are checked all the same.
const ANY: f64 = 1.0;

/// The four angles of the command line.
pub(super) fn case(request: &Request, alpha_deg: f64) -> Result<Case, AppError> {
    Ok(Case::from_deg(alpha_deg, request.loads.beta_deg, request.phi()?, delta(request)?))
}

/// The prediction. What one degree more makes of it takes as long as eight predictions, and may be left out.
pub(super) fn predict(request: &Request, alpha_deg: f64, with_sensitivity: bool) -> Result<Answer, AppError> {
    let (delta_deg, density) = (delta(request)?, density(request)?);
    let plate = Plate::new(
        Angle::from_degrees(alpha_deg),
        Angle::from_degrees(request.loads.beta_deg),
        request.depth_m.unwrap_or(ANY),
        request.width_m.unwrap_or(ANY),
    )?;
    let soil = Soil::new(Angle::from_degrees(request.phi()?), density.unwrap_or(ANY))?
        .with_cohesion(request.loads.cohesion_pa)?
        .with_gravity(request.loads.gravity_m_s2)?;
    Interface::new(Angle::from_degrees(delta_deg), request.loads.adhesion_pa)?;
    let loads = request.checked_loads()?;

    let chosen = Chosen::of(request)?;
    let model = chosen.model.as_ref();
    let sized = request.depth_m.is_some() && request.width_m.is_some();
    let (plate_ends, width_ratio) = chosen.ends(request, sized.then_some(&plate))?;
    let case = case(request, alpha_deg)?.with_width_ratio(width_ratio);
    check_loads(model, &case, &loads)?;
    let found = model.predict(&case)?;
    let mut ends = model.provenance();
    if plate_ends == Ends::Finite && ends.lower != ends.upper {
        ends.upper += " with ends";
    }
    let bracket = if ends.lower == ends.upper { None } else { Some(found.bracket(ends)?) };
    let complete = sized && density.is_some();
    Ok(Answer {
        model: model.id().into(),
        k_passive: found.passive.map(|side| side.weight),
        k_active: found.active.map(|side| side.weight),
        k_net: Some(found.k_net().0),
        k_net_depth: Some(found.k_net().to_depth(plate.tool_angle()).0),
        k_net_lower: bracket.as_ref().map(Bracket::lower),
        k_net_upper: bracket.as_ref().map(Bracket::upper),
        k_net_provenance: bracket.as_ref().map(|b| b.provenance().into()),
        ends: plate_ends,
        width_ratio: width_ratio.finite(),
        force_n: complete.then(|| found.force_n(&plate, &soil, &loads)),
        friction_law: None,
        sensitivity_percent_per_deg: with_sensitivity.then(|| sensitivity(model, &case)),
        inputs: Inputs {
            alpha_deg: Some(alpha_deg),
            delta_deg: Some(delta_deg),
            density_kg_m3: density,
            depth_m: request.depth_m,
            width_m: request.width_m,
            ..inputs(request)?
        },
        interpolation_margin: found.interpolation_margin,
        notes: found.notes.iter().map(|note| (*note).to_owned()).collect(),
        reference: chosen.reference,
        valid_range: model.valid_range().into(),
        strokes: None,
    })
}

fn sensitivity(model: &dyn ForceModel, case: &Case) -> Sensitivity {
    let to = |input| sensitivity_percent(model, case, input, Angle::from_degrees(1.0)).ok();
    Sensitivity {
        alpha: to(Input::ToolAngle),
        beta: to(Input::SurfaceSlope),
        phi: to(Input::Friction),
        delta: to(Input::Interface),
    }
}

/// Inputs that never come from a file; the others are null.
pub(super) fn inputs(request: &Request) -> Result<Inputs, AppError> {
    Ok(Inputs {
        alpha_deg: None,
        beta_deg: request.loads.beta_deg,
        phi_deg: request.phi()?,
        delta_deg: request.delta()?.number(),
        cohesion_pa: request.loads.cohesion_pa,
        adhesion_pa: request.loads.adhesion_pa,
        surcharge_pa: request.loads.surcharge_pa,
        density_kg_m3: request.density_kg_m3.and_then(NumberOrColumn::number),
        gravity_m_s2: request.loads.gravity_m_s2,
        depth_m: None,
        width_m: None,
    })
}

fn delta(request: &Request) -> Result<f64, AppError> {
    request.delta()?.number().ok_or_else(|| needs_strokes("--delta", "delta_set_deg"))
}

fn density(request: &Request) -> Result<Option<f64>, AppError> {
    match request.density_kg_m3 {
        Some(NumberOrColumn::Column) => Err(needs_strokes("--density", "density_kg_m3")),
        given => Ok(given.and_then(NumberOrColumn::number)),
    }
}

fn needs_strokes(option: &str, column: &str) -> AppError {
    AppError::Request(format!(
        "{option} is column, which takes {column} from a stroke table, but there is none; give --strokes FILE or a \
         number"
    ))
}
