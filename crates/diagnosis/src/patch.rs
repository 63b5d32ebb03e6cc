//! The model file that a diagnosis leaves: what was known, and what was found.

use std::collections::BTreeMap;

use soilctl_effects::{EffectEntry, FILE_SCHEMA, HeldOut, ModelFile, ParameterValue, SoilEntry};

use crate::{Comparison, Data, Diagnosis, Fitted, FittedSoil, FoundEffect};

fn value(value: f64, sd: f64, unit: &str) -> ParameterValue {
    ParameterValue { value, sd, unit: unit.into() }
}

impl FoundEffect {
    /// Its parameters by name.
    #[must_use]
    pub fn parameters(&self) -> BTreeMap<String, ParameterValue> {
        let effect = self.id.effect();
        let main = effect.parameter;
        let mut parameters =
            BTreeMap::from([(main.name.to_owned(), value(self.amplitude, self.amplitude_sd, main.unit))]);
        if let Some(of_shape) = effect.shape
            && let Some(parameter) = of_shape.parameter
        {
            // Half the distance to the next value that was tried.
            let away = of_shape.values.iter().map(|v| (v - self.shape).abs()).filter(|d| *d > 0.0);
            let step = away.fold(f64::INFINITY, f64::min);
            let sd = if step.is_finite() { 0.5 * step } else { 0.0 };
            parameters.insert(parameter.name.to_owned(), value(self.shape, sd, parameter.unit));
        }
        parameters
    }

    fn entry(&self) -> EffectEntry {
        EffectEntry {
            id: self.id,
            parameters: self.parameters(),
            shape: self.shape,
            log_bayes_factor: self.log_bayes_factor,
        }
    }
}

impl Diagnosis {
    /// The model file: force model, effects and empirical terms that were known, then those that were found. `data_hash` is that of the stroke
    /// table.
    #[must_use]
    pub fn model_file(
        &self,
        data: &Data,
        model: &str,
        known: &[EffectEntry],
        data_hash: String,
    ) -> ModelFile {
        let file = file(data, model, known, (&self.comparison.soil_after, &self.effects));
        ModelFile {
            status: self.status.name().into(),
            empirical: data.known_terms.iter().chain(&self.terms).cloned().collect(),
            equivalence_set: self.equivalence_set.iter().map(ToString::to_string).collect(),
            data_hash,
            held_out: self.comparison.held_out(),
            ..file
        }
    }
}

impl Fitted {
    /// The model file of effects that nothing was said of: force model, effects and empirical terms that are known, then these.
    #[must_use]
    pub fn model_file(&self, data: &Data, model: &str, known: &[EffectEntry]) -> ModelFile {
        file(data, model, known, (&self.soil, &self.effects))
    }
}

/// What is known, a soil and effects.
fn file(
    data: &Data,
    model: &str,
    known: &[EffectEntry],
    (soil, effects): (&FittedSoil, &[FoundEffect]),
) -> ModelFile {
    let mean = data.reference.delta_set_deg.unwrap_or_else(|| data.delta_set_deg(0));
    ModelFile {
        schema: FILE_SCHEMA.into(),
        model: model.to_owned(),
        status: "hand".into(),
        soil: SoilEntry {
            phi_deg: value(soil.phi_deg, soil.phi_sd_deg, "deg"),
            delta_deg: value((mean + soil.delta_offset_deg).max(0.0), soil.delta_offset_sd_deg, "deg"),
            delta_offset_deg: value(soil.delta_offset_deg, soil.delta_offset_sd_deg, "deg"),
            density_kg_m3: value(soil.density_kg_m3, soil.density_sd_kg_m3, "kg/m3"),
            gravity_m_s2: data.gravity_m_s2,
        },
        effects: known.iter().cloned().chain(effects.iter().map(FoundEffect::entry)).collect(),
        empirical: data.known_terms.clone(),
        equivalence_set: Vec::new(),
        reference: data.reference.clone(),
        data_hash: String::new(),
        held_out: None,
    }
}

impl Comparison {
    /// Figures of merit on batches that were left out; `None` with fewer than two batches.
    fn held_out(&self) -> Option<HeldOut> {
        let gap = &self.gap;
        Some(HeldOut {
            rmse_before: gap.heldout_before?,
            rmse_after: gap.heldout_after?,
            chi2_per_n_before: gap.chi2_per_n_before.unwrap_or_default(),
            chi2_per_n_after: gap.chi2_per_n_after.unwrap_or_default(),
            delta_elpd: gap.delta_elpd?,
            delta_elpd_se: gap.delta_elpd_se?,
        })
    }

    /// A model file without the effects and terms that were found (all but the first `known` of each), with the soil that fits best then.
    #[must_use]
    pub fn without_effects(&self, file: &ModelFile, known: [usize; 2]) -> ModelFile {
        let (before, after) = (&self.soil_before, &self.soil_after);
        let mut plain = file.clone();
        plain.effects.truncate(known[0]);
        plain.empirical.truncate(known[1]);
        plain.soil.phi_deg.value = before.phi_deg;
        plain.soil.delta_offset_deg.value = before.delta_offset_deg;
        plain.soil.density_kg_m3.value = before.density_kg_m3;
        let shift = before.delta_offset_deg - after.delta_offset_deg;
        plain.soil.delta_deg.value = (plain.soil.delta_deg.value + shift).max(0.0);
        plain
    }
}
