//! Hidden campaigns.

use soilctl_earth_pressure::model;
use soilctl_effects::{Channel, DirectMechanics, EffectId};
use soilctl_strokes::{Campaign, StrokeRow};

use super::cause::Cause;
use super::design::{Design, rows};
use super::hidden::{Hidden, Span, TrueSoil, force_n};
use super::random::Random;
use super::traces::{Baselines, fill, instrument};
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
    pub(super) truth: Truth,
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
    let hides = |id: EffectId| hidden.iter().any(|h| h.cause == Cause::Effect(id));
    let dense = hides(EffectId::InsertionLoosening) || random.unit() < 0.4;
    let delta_set = random.between(17.0, 25.0);
    let soil = TrueSoil {
        phi_deg: random.between(33.0, 42.0),
        delta_deg: delta_set + random.normal(0.7),
        density_kg_m3: random.between(1430.0, 1620.0),
    };
    let known = random.unit() < 0.5;
    let campaign = Campaign {
        phi_independent_deg: known.then(|| soil.phi_deg + random.normal(1.0)),
        phi_independent_sd: known.then_some(1.0),
        density_sd_rel: random.between(0.01, 0.03),
        depth_sd_m: random.between(2e-4, 4e-4),
        dense_preparation: dense,
        instrument: instrument(random),
        ..Campaign::default()
    };
    let plain_name = design.true_model.unwrap_or(base_model);
    let true_name = if hides(EffectId::ModelForm) { "coulomb" } else { plain_name };
    let count = rows.len() as f64;
    let span = Span {
        depth_m: rows.iter().map(|row| row.depth_m).sum::<f64>() / count,
        time_s: (rows[0].time_s.unwrap_or(0.0), rows[rows.len() - 1].time_s.unwrap_or(1.0)),
        batches: (count / 6.0).ceil(),
    };
    let baselines = Baselines::draw(&campaign, dense, random);
    let truth = Truth {
        models: [true_name.to_owned(), plain_name.to_owned()],
        soil,
        span,
        baselines,
        delta_set,
        design: design.clone(),
    };
    let Some((ln_true, ln_plain)) = truth.fill(&mut rows, &campaign, &hidden, random)? else {
        return Ok(None);
    };
    Ok(Some(HiddenCampaign { attempt: 0, rows, campaign, hidden, ln_true, ln_plain, truth }))
}

/// What is true of a hidden campaign beside its effects.
#[derive(Debug, Clone)]
pub(super) struct Truth {
    /// Force models with the effects and without.
    models: [String; 2],
    soil: TrueSoil,
    span: Span,
    baselines: Baselines,
    delta_set: f64,
    design: Design,
}

impl Truth {
    /// Fills forces and columns of rows that have geometry; ln of the forces without scatter, with the effects and without.
    /// `None` if a stroke has no force.
    #[allow(clippy::type_complexity, reason = "two columns")]
    fn fill(
        &self,
        rows: &mut [StrokeRow],
        campaign: &Campaign,
        hidden: &[Hidden],
        random: &mut Random,
    ) -> Result<Option<(Vec<f64>, Vec<f64>)>, DiagnosisError> {
        let span = &self.span;
        let [true_model, plain_model] = self.models.each_ref().map(|id| model(id).map(DirectMechanics::new));
        let (true_model, plain_model) = (true_model?, plain_model?);
        let (mut ln_true, mut ln_plain) = (Vec::new(), Vec::new());
        let mut batch_density = 1.0;
        for row in rows {
            // Set-points that bracket the first one move the force's inclination with them.
            let moved = row.delta_set_deg.map_or(0.0, |set| set - self.delta_set);
            let soil = &TrueSoil { delta_deg: self.soil.delta_deg + moved, ..self.soil };
            let (Some(plain), Some(with)) =
                (force_n(&plain_model, soil, span, row, &[]), force_n(&true_model, soil, span, row, hidden))
            else {
                return Ok(None);
            };
            ln_plain.push(plain.ln());
            ln_true.push(with.ln());
            if row.order == Some(1) {
                batch_density = 1.0 + random.normal(campaign.density_sd_rel);
            }
            let recorded = row.depth_m;
            row.depth_m = (recorded + random.normal(campaign.depth_sd_m)).max(0.3 * recorded);
            let Some(real) = force_n(&true_model, soil, span, row, hidden) else { return Ok(None) };
            row.depth_m = recorded;
            row.force_n = (real * batch_density * (1.0 + random.normal(self.design.scatter))).max(0.02);
            row.density_kg_m3 = Some(soil.density_kg_m3 * batch_density * (1.0 + random.normal(0.005)));
            row.delta_set_deg.get_or_insert(self.delta_set);
            let asked: Vec<Channel> = Channel::ALL.into_iter().filter(|c| c.of(row).is_some()).collect();
            if self.design.traces {
                fill(row, hidden, soil, span, campaign, &self.baselines, random);
            } else if !asked.is_empty() {
                let mut full = row.clone();
                fill(&mut full, hidden, soil, span, campaign, &self.baselines, random);
                for channel in asked {
                    channel.put(row, channel.of(&full));
                }
            }
        }
        Ok(Some((ln_true, ln_plain)))
    }
}

impl HiddenCampaign {
    /// Makes the strokes of a follow-up: the same soil, instrument and effects. The answer is all strokes together, or
    /// `None` if a stroke of the follow-up has no force.
    ///
    /// # Errors
    /// [`DiagnosisError::Model`] if the design names an unknown force model.
    pub fn followed_by(
        &self,
        design: &[StrokeRow],
        seed: u64,
    ) -> Result<Option<Vec<StrokeRow>>, DiagnosisError> {
        let mut random = Random::new(seed, 1 << 60);
        let mut rows = design.to_vec();
        // The generator counts batches by their names.
        let batches = self.truth.span.batches as usize;
        let mut names: Vec<Option<String>> = Vec::new();
        for row in &mut rows {
            if names.last() != Some(&row.batch) {
                names.push(row.batch.clone());
            }
            row.batch = Some(format!("b{:02}", batches + names.len()));
        }
        if self.truth.fill(&mut rows, &self.campaign, &self.hidden, &mut random)?.is_none() {
            return Ok(None);
        }
        for (row, of) in rows.iter_mut().zip(design) {
            row.batch.clone_from(&of.batch);
        }
        Ok(Some(self.rows.iter().cloned().chain(rows).collect()))
    }
}
