//! Hidden campaigns.

use soilctl_earth_pressure::model;
use soilctl_effects::DirectMechanics;
use soilctl_strokes::{Campaign, StrokeRow};

use super::design::{Design, rows};
use super::hidden::{Hidden, Span, World, force_n};
use super::random::Random;
use super::traces::{Habits, fill, instrument};
use crate::DiagnosisError;

/// A campaign and what is hidden in it.
#[derive(Debug, Clone)]
pub struct HiddenCampaign {
    /// Strokes.
    pub rows: Vec<StrokeRow>,
    /// What the diagnosis is told beside them.
    pub campaign: Campaign,
    /// Draws before this one that left a stroke without force.
    pub attempt: u64,
    /// What is hidden.
    pub hidden: Vec<Hidden>,
    /// ln of the forces without scatter at commanded geometry, with what is hidden.
    pub ln_true: Vec<f64>,
    /// The same without it.
    pub ln_plain: Vec<f64>,
}

/// Draws soil, geometry and scatter around hidden effects.
///
/// # Errors
/// [`DiagnosisError::Model`] if the design names an unknown force model.
pub(super) fn generate(
    design: &Design,
    base_model: &str,
    hidden: Vec<Hidden>,
    random: &mut Random,
) -> Result<Option<HiddenCampaign>, DiagnosisError> {
    let mut rows = rows(design, random);
    let dense = hidden.iter().any(|h| h.id == "insertion_loosening") || random.unit() < 0.4;
    let delta_set = random.between(17.0, 25.0);
    let world = World {
        phi_deg: random.between(33.0, 42.0),
        delta_deg: delta_set + random.normal(0.7),
        density_kg_m3: random.between(1430.0, 1620.0),
    };
    let known = random.unit() < 0.5;
    let campaign = Campaign {
        phi_independent_deg: known.then(|| world.phi_deg + random.normal(1.0)),
        phi_independent_sd: known.then_some(1.0),
        density_sd_rel: random.between(0.01, 0.03),
        depth_sd_m: random.between(2e-4, 4e-4),
        dense_preparation: dense,
        instrument: instrument(random),
        ..Campaign::default()
    };
    let plain_name = design.true_model.unwrap_or(base_model);
    let true_name = if hidden.iter().any(|h| h.id == "model_form") { "coulomb" } else { plain_name };
    let (true_model, plain_model) =
        (DirectMechanics::new(model(true_name)?), DirectMechanics::new(model(plain_name)?));
    let count = rows.len() as f64;
    let span = Span {
        depth_m: rows.iter().map(|row| row.depth_m).sum::<f64>() / count,
        time_s: (rows[0].time_s.unwrap_or(0.0), rows[rows.len() - 1].time_s.unwrap_or(1.0)),
        batches: (count / 6.0).ceil(),
    };
    let habits = Habits::draw(&campaign, dense, random);
    let (mut ln_true, mut ln_plain) = (Vec::new(), Vec::new());
    let mut batch_density = 1.0;
    for row in &mut rows {
        let (Some(plain), Some(with)) = (
            force_n(&plain_model, &world, &span, row, &[]),
            force_n(&true_model, &world, &span, row, &hidden),
        ) else {
            return Ok(None);
        };
        ln_plain.push(plain.ln());
        ln_true.push(with.ln());
        if row.order == Some(1) {
            batch_density = 1.0 + random.normal(campaign.density_sd_rel);
        }
        let recorded = row.depth_m;
        row.depth_m = (recorded + random.normal(campaign.depth_sd_m)).max(0.3 * recorded);
        let Some(real) = force_n(&true_model, &world, &span, row, &hidden) else { return Ok(None) };
        row.depth_m = recorded;
        row.force_n = (real * batch_density * (1.0 + random.normal(design.scatter))).max(0.02);
        row.density_kg_m3 = Some(world.density_kg_m3 * batch_density * (1.0 + random.normal(0.005)));
        row.delta_set_deg = Some(delta_set);
        if design.traces {
            fill(row, &hidden, &world, &span, &campaign, &habits, random);
        }
    }
    Ok(Some(HiddenCampaign { attempt: 0, rows, campaign, hidden, ln_true, ln_plain }))
}
