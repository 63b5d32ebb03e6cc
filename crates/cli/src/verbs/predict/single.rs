//! The prediction of one plate given on the command line.

use soilctl_earth_pressure::{Case, ForceModel, Input, check_loads, sensitivity_percent};
use soilctl_soil::{Angle, Bracket, Interface, Plate, Soil};

use super::Args;
use super::answer::{Inputs, Prediction, Sensitivity};
use super::chosen::Chosen;
use crate::args::NumberOrColumn;
use crate::error::CliError;

/// Stands in for a quantity that was not given, so that the others are checked all the same.
const ANY: f64 = 1.0;

/// The four angles of the command line.
pub(super) fn case(args: &Args, alpha_deg: f64) -> Result<Case, CliError> {
    Ok(Case::from_deg(alpha_deg, args.loads.beta, args.phi()?, delta(args)?))
}

pub(super) fn predict(args: &Args, alpha_deg: f64) -> Result<Prediction, CliError> {
    let (delta_deg, density) = (delta(args)?, density(args)?);
    let plate = Plate::new(
        Angle::from_degrees(alpha_deg),
        Angle::from_degrees(args.loads.beta),
        args.depth.unwrap_or(ANY),
        args.width.unwrap_or(ANY),
    )?;
    let soil = Soil::new(Angle::from_degrees(args.phi()?), density.unwrap_or(ANY))?
        .with_cohesion(args.loads.cohesion)?
        .with_gravity(args.loads.gravity)?;
    Interface::new(Angle::from_degrees(delta_deg), args.loads.adhesion)?;
    let loads = args.checked_loads()?;

    let chosen = Chosen::of(args)?;
    let model = chosen.model.as_ref();
    let case = case(args, alpha_deg)?;
    check_loads(model, &case, &loads)?;
    let found = model.predict(&case)?;
    let ends = model.provenance();
    let bracket = if ends.lower == ends.upper { None } else { Some(found.bracket(ends)?) };
    let complete = args.depth.is_some() && args.width.is_some() && density.is_some();
    Ok(Prediction {
        model: model.id().into(),
        k_passive: found.passive.map(|side| side.weight),
        k_active: found.active.map(|side| side.weight),
        k_net: Some(found.k_net().0),
        k_net_depth: Some(found.k_net().to_depth(plate.tool_angle()).0),
        k_net_lower: bracket.as_ref().map(Bracket::lower),
        k_net_upper: bracket.as_ref().map(Bracket::upper),
        k_net_provenance: bracket.as_ref().map(|b| b.provenance().into()),
        force_n: complete.then(|| found.force_n(&plate, &soil, &loads)),
        sensitivity_percent_per_deg: Some(sensitivity(model, &case)),
        inputs: Inputs {
            alpha_deg: Some(alpha_deg),
            delta_deg: Some(delta_deg),
            density_kg_m3: density,
            depth_m: args.depth,
            width_m: args.width,
            ..inputs(args)?
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
pub(super) fn inputs(args: &Args) -> Result<Inputs, CliError> {
    Ok(Inputs {
        alpha_deg: None,
        beta_deg: args.loads.beta,
        phi_deg: args.phi()?,
        delta_deg: args.delta()?.number(),
        cohesion_pa: args.loads.cohesion,
        adhesion_pa: args.loads.adhesion,
        surcharge_pa: args.loads.surcharge,
        density_kg_m3: args.density.and_then(NumberOrColumn::number),
        gravity_m_s2: args.loads.gravity,
        depth_m: None,
        width_m: None,
    })
}

fn delta(args: &Args) -> Result<f64, CliError> {
    args.delta()?.number().ok_or_else(|| needs_strokes("--delta", "delta_set_deg"))
}

fn density(args: &Args) -> Result<Option<f64>, CliError> {
    match args.density {
        Some(NumberOrColumn::Column) => Err(needs_strokes("--density", "density_kg_m3")),
        given => Ok(given.and_then(NumberOrColumn::number)),
    }
}

fn needs_strokes(option: &str, column: &str) -> CliError {
    CliError::Usage(format!(
        "{option} is column, which takes {column} from a stroke table, but there is none; give --strokes FILE or a \
         number"
    ))
}
