//! Strokes of one kind as one band.

mod carrier;
mod chosen;

use soilctl_earth_pressure::{ChenLiu, ForceModel};
use soilctl_strokes::{Campaign, Kind, Measurement, Pool, StrokeRow, StrokeTable, pool};

use self::carrier::{Carrier, Reference};
pub(super) use self::chosen::SAME_ALPHA_DEG;
use self::chosen::{Chosen, Stroke, chosen, friction_deg, kinds, same_depth};
use super::answer::LeftOut;
use super::request::Request;
use crate::AppError;

/// Bands of all kinds of strokes.
#[derive(Debug, Clone)]
pub struct Bands {
    /// One measurement a kind, at its reference.
    pub measurements: Vec<Measurement>,
    /// Their bands, in the same order.
    pub pool: Pool,
    /// Probability with which all bands together hold their true forces.
    pub confidence: f64,
    /// Friction on the plate (deg) that all forces are brought to, if the strokes tell theirs.
    pub friction_deg: Option<f64>,
    /// Strokes that do not count.
    pub left_out: Vec<LeftOut>,
    /// What is doubtful about strokes or friction, in sentences.
    pub warnings: Vec<String>,
}

/// Whether the table says how forces scatter, or how well depths are known: strokes are repeated, or depths have a deviation.
pub(super) fn tells_scatter(request: &Request, table: &StrokeTable) -> bool {
    let strokes: Vec<Stroke> = table.rows().map(|row| Stroke { row, friction_deg: None }).collect();
    strokes.iter().any(|stroke| stroke.row.depth_sd_m.is_some())
        || kinds(&strokes, same_depth(request)).len() < strokes.len()
}

/// The bands of a table.
pub(super) fn bands(
    request: &Request,
    table: &StrokeTable,
    campaign: &Campaign,
    model: &dyn ForceModel,
    confidence: f64,
) -> Result<Bands, AppError> {
    let strokes = table.rows().map(|row| Stroke { friction_deg: friction_deg(request, &row), row });
    let Chosen { strokes, friction_deg, left_out, warnings } = chosen(request, strokes.collect());
    let batch = |stroke: &Stroke| stroke.row.batch.clone();
    let first = strokes.first().and_then(batch);
    // In one preparation there is one density, and that is the one to find.
    let is_one_preparation = first.is_some() && strokes.iter().all(|stroke| batch(stroke) == first);
    let carrier = Carrier {
        request,
        campaign,
        friction_deg,
        density_sd_rel: if is_one_preparation { 0.0 } else { campaign.density_sd_rel },
        by: if model.has_ends() && !model.bounds_ends() { model } else { &ChenLiu },
        ends: model.bounds_ends().then_some(model),
        range: model.valid_range().alpha_deg,
    };
    let mut measurements = Vec::new();
    let mut all = Vec::new();
    for members in kinds(&strokes, same_depth(request)) {
        let members: Vec<&Stroke> = members.into_iter().filter_map(|place| strokes.get(place)).collect();
        let Some((reference, kind)) = carrier.kind(table.name(), &members)? else { continue };
        measurements.push(measurement(&reference, &kind, &members));
        all.push(kind);
    }
    let pool = pool(table.name(), &all, confidence)?;
    for (measurement, band) in measurements.iter_mut().zip(&pool.bands) {
        measurement.force_n = band.force_n;
        measurement.force_sd_n = band.force_n * band.mean_rel.hypot(band.common_rel);
    }
    Ok(Bands { measurements, pool, confidence, friction_deg, left_out, warnings })
}

fn measurement(reference: &Reference, kind: &Kind, members: &[&Stroke]) -> Measurement {
    let mean = |value: fn(&StrokeRow) -> Option<f64>| {
        let some: Vec<f64> = members.iter().filter_map(|stroke| value(&stroke.row)).collect();
        (!some.is_empty()).then(|| some.iter().sum::<f64>() / some.len() as f64)
    };
    let forces = kind.forces_n.iter();
    Measurement {
        alpha_deg: reference.alpha_deg,
        depth_m: reference.depth_m,
        width_m: reference.width_m,
        force_n: 0.0,
        force_sd_n: 0.0,
        force_min_n: forces.clone().copied().fold(f64::INFINITY, f64::min),
        force_max_n: forces.copied().fold(0.0, f64::max),
        count: members.len(),
        lines: kind.lines.clone(),
        stroke_ids: members.iter().filter_map(|stroke| stroke.row.stroke_id.clone()).collect(),
        label: kind.label.clone(),
        density_kg_m3: mean(|row| row.density_kg_m3),
        delta_set_deg: mean(|row| row.delta_set_deg),
    }
}
