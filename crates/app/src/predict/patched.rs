//! Predictions of a model file, with its effects.

use std::path::Path;

use soilctl_earth_pressure::plane_model;
use soilctl_effects::{Loaded, ModelFile};
use soilctl_soil::Angle;
use soilctl_strokes::{ReadOptions, StrokeRow};

use super::Request;
use super::answer::{Answer, Inputs, StrokePrediction};
use crate::request::{Ends, NumberOrColumn};
use crate::{AppError, terms};

pub(super) fn predict(request: &Request, path: &Path) -> Result<Answer, AppError> {
    let mut file = ModelFile::read(path)?;
    if let Some(phi) = request.phi_deg {
        file.soil.phi_deg.value = phi;
    }
    if let Some(NumberOrColumn::Number(density)) = request.density_kg_m3 {
        file.soil.density_kg_m3.value = density;
    }
    // A number holds for every stroke, whatever its set-point.
    let delta = request.delta_deg.and_then(NumberOrColumn::number);
    if let Some(delta) = delta {
        file.soil.delta_deg.value = delta;
    }
    let loaded = Loaded::new(file, &path.display().to_string())?;
    let seen = |row: &StrokeRow| StrokeRow {
        delta_set_deg: row.delta_set_deg.filter(|_| delta.is_none()),
        ..row.clone()
    };
    let (strokes, force_n, k_net, beyond) =
        match (&request.strokes, request.alpha_deg, request.depth_m, request.width_m) {
            (Some(table), ..) => {
                let table = table.strokes(ReadOptions { allow_zero_sd: true })?;
                let beyond = terms::beyond(&loaded, table.rows());
                let rows =
                    table.rows().map(|row| stroke(&loaded, seen(&row))).collect::<Result<Vec<_>, _>>()?;
                (Some(rows), None, None, beyond)
            }
            (None, Some(alpha_deg), Some(depth_m), Some(width_m)) => {
                let row = StrokeRow { alpha_deg, depth_m, width_m, force_n: 1.0, ..StrokeRow::default() };
                let force_n = loaded.force_n(&row)?;
                let beyond = terms::beyond(&loaded, std::iter::once(row.clone()));
                (None, Some(force_n), Some(coefficient(&loaded, &row, force_n)), beyond)
            }
            _ => {
                return Err(AppError::Request(
                    "--model-file predicts forces: give --strokes FILE, or --alpha, --depth and --width"
                        .into(),
                ));
            }
        };
    let soil = &loaded.file().soil;
    let base = plane_model(&loaded.file().model)?;
    let effects: Vec<&str> = loaded.file().effects.iter().map(|entry| entry.id.name()).collect();
    let over = terms::conditions(&loaded).map(|over| format!(" and what has no name over {over}"));
    let with = if effects.is_empty() { "no effects".to_owned() } else { effects.join(", ") };
    Ok(Answer {
        model: base.id().into(),
        k_passive: None,
        k_active: None,
        k_net,
        k_net_depth: k_net
            .zip(request.alpha_deg)
            .map(|(k, alpha)| k / Angle::from_degrees(alpha).sin().powi(2)),
        k_net_lower: None,
        k_net_upper: None,
        k_net_provenance: None,
        ends: Ends::None,
        width_ratio: None,
        force_n,
        friction_law: None,
        sensitivity_percent_per_deg: None,
        inputs: Inputs {
            alpha_deg: request.alpha_deg,
            beta_deg: 0.0,
            phi_deg: soil.phi_deg.value,
            delta_deg: Some(soil.delta_deg.value),
            cohesion_pa: 0.0,
            adhesion_pa: 0.0,
            surcharge_pa: 0.0,
            density_kg_m3: Some(soil.density_kg_m3.value),
            gravity_m_s2: soil.gravity_m_s2,
            depth_m: request.depth_m,
            width_m: request.width_m,
        },
        interpolation_margin: 0.0,
        notes: std::iter::once(format!(
            "with the effects of {}: {with}{}",
            path.display(),
            over.unwrap_or_default()
        ))
        .chain(beyond)
        .collect(),
        reference: base.reference().to_owned(),
        valid_range: base.valid_range().into(),
        strokes,
    })
}

fn stroke(loaded: &Loaded, row: StrokeRow) -> Result<StrokePrediction, AppError> {
    let force_n = loaded.force_n(&row)?;
    Ok(StrokePrediction {
        line: row.line,
        k_net: coefficient(loaded, &row, force_n),
        alpha_deg: row.alpha_deg,
        depth_m: row.depth_m,
        force_n: Some(force_n),
        measured_n: row.force_n,
        ratio: Some(force_n / row.force_n),
        stroke_id: row.stroke_id,
    })
}

/// The force as a slant-normalised coefficient, whatever it is made of.
fn coefficient(loaded: &Loaded, row: &StrokeRow, force_n: f64) -> f64 {
    let soil = &loaded.file().soil;
    let slant_m = row.depth_m / Angle::from_degrees(row.alpha_deg).sin();
    2.0 * force_n / (soil.density_kg_m3.value * soil.gravity_m_s2 * slant_m * slant_m * row.width_m)
}
