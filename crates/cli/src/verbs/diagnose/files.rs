//! Files of a diagnosis: model file, predictions, next experiment.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use soilctl_diagnosis::{Comparison, Data, Diagnosis, FoundEffect, NextExperiment, Part, Status};
use soilctl_effects::{
    Covariate, EffectEntry, FILE_SCHEMA, HeldOut, Loaded, ModelFile, ParameterValue, SoilEntry,
};
use soilctl_jobs::fnv1a;
use soilctl_strokes::StrokeTable;

use super::{Against, Work};
use crate::error::CliError;
use crate::verbs::process::save;

/// Where things were written.
pub(super) struct Written {
    pub(super) patch: PathBuf,
    pub(super) report: PathBuf,
    pub(super) next: Option<PathBuf>,
}

/// Writes all files but the report.
pub(super) fn write(work: &Work, strokes: &Path, out: &Path) -> Result<Written, CliError> {
    let bytes = std::fs::read(strokes).map_err(|problem| failed(strokes, problem))?;
    let patch = out.join("patch.json");
    let file = model_file(&work.against, &work.data, &work.diagnosis, &bytes);
    file.write(&patch)?;
    predictions(work, file, &patch, &out.join("predictions.csv"))?;
    gap_table(&work.diagnosis.comparison.parts, &out.join("gap.csv"))?;
    let next = match &work.diagnosis.next {
        Some(next) => {
            let path = out.join("next_experiment.csv");
            write_design(next, &path)?;
            Some(path)
        }
        None => None,
    };
    Ok(Written { patch, report: out.join("report.html"), next })
}

fn failed(path: &Path, problem: std::io::Error) -> CliError {
    CliError::File { path: path.display().to_string(), problem }
}

fn value(value: f64, sd: f64, unit: &str) -> ParameterValue {
    ParameterValue { value, sd, unit: unit.into() }
}

/// The model file of a diagnosis: what was known, then what was found; `bytes` are those of the stroke table.
pub(super) fn model_file(against: &Against, data: &Data, d: &Diagnosis, bytes: &[u8]) -> ModelFile {
    let soil = &d.comparison.soil_after;
    let set = data.delta_set_deg(0);
    let mean = data.reference.delta_set_deg.unwrap_or(set);
    let gap = &d.comparison.gap;
    let held_out = match (gap.heldout_before, gap.heldout_after, gap.delta_elpd, gap.delta_elpd_se) {
        (Some(rmse_before), Some(rmse_after), Some(delta_elpd), Some(delta_elpd_se)) => Some(HeldOut {
            rmse_before,
            rmse_after,
            chi2_per_n_before: gap.chi2_per_n_before.unwrap_or_default(),
            chi2_per_n_after: gap.chi2_per_n_after.unwrap_or_default(),
            delta_elpd,
            delta_elpd_se,
        }),
        _ => None,
    };
    ModelFile {
        schema: FILE_SCHEMA.into(),
        model: against.model.clone(),
        status: status(d.status).into(),
        soil: SoilEntry {
            phi_deg: value(soil.phi_deg, soil.phi_sd_deg, "deg"),
            delta_deg: value((mean + soil.delta_offset_deg).max(0.0), soil.delta_offset_sd_deg, "deg"),
            delta_offset_deg: value(soil.delta_offset_deg, soil.delta_offset_sd_deg, "deg"),
            density_kg_m3: value(soil.density_kg_m3, soil.density_sd_kg_m3, "kg/m3"),
            gravity_m_s2: data.gravity_m_s2,
        },
        effects: against
            .known()
            .iter()
            .cloned()
            .chain(d.effects.iter().map(|found| EffectEntry {
                id: found.id,
                parameters: parameters(found),
                shape: found.shape,
                log_bayes_factor: found.log_bayes_factor,
            }))
            .collect(),
        equivalence_set: d.equivalence_set.iter().map(ToString::to_string).collect(),
        reference: data.reference.clone(),
        data_hash: fnv1a(bytes),
        held_out,
    }
}

/// Parameters of an effect by name.
pub(super) fn parameters(found: &FoundEffect) -> BTreeMap<String, ParameterValue> {
    let effect = found.id.effect();
    let main = effect.parameter;
    let mut parameters =
        BTreeMap::from([(main.name.to_owned(), value(found.amplitude, found.amplitude_sd, main.unit))]);
    if let Some(of_shape) = effect.shape
        && let Some(parameter) = of_shape.parameter
    {
        // Half the distance to the next value that was tried.
        let away = of_shape.values.iter().map(|v| (v - found.shape).abs()).filter(|d| *d > 0.0);
        let step = away.fold(f64::INFINITY, f64::min);
        let sd = if step.is_finite() { 0.5 * step } else { 0.0 };
        parameters.insert(parameter.name.to_owned(), value(found.shape, sd, parameter.unit));
    }
    parameters
}

/// Status as it is written.
pub(super) const fn status(status: Status) -> &'static str {
    match status {
        Status::None => "none",
        Status::Named => "named",
        Status::Ambiguous => "ambiguous",
        Status::Provisional => "provisional",
        Status::Unknown => "unknown",
        Status::NotTestable => "not_testable",
    }
}

/// The design without forces, and with empty cells for what is to be read: both are still to be measured.
fn write_design(next: &NextExperiment, path: &Path) -> Result<(), CliError> {
    let table = StrokeTable::new("next_experiment.csv", &next.rows)?;
    let mut text = Vec::new();
    table.to_writer(&mut text)?;
    let text = String::from_utf8_lossy(&text);
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let Some(header) = lines.next() else { return Ok(()) };
    let keep: Vec<usize> = (0..header.len()).filter(|&i| header[i] != "force_n").collect();
    let read = |i: usize| next.readings.iter().any(|channel| channel.column() == header[i]);
    let mut out = keep.iter().map(|&i| header[i].as_str()).collect::<Vec<_>>().join(",") + "\n";
    for line in lines {
        let cell = |&i: &usize| if read(i) { "" } else { line.get(i).map_or("", String::as_str) };
        out += &(keep.iter().map(cell).collect::<Vec<_>>().join(",") + "\n");
    }
    save(path, out.as_bytes())
}

/// The same file without the effects that were found (all but the first `known`), with the soil that fits best then.
pub(super) fn without_effects(file: &ModelFile, known: usize, c: &Comparison) -> ModelFile {
    let mut plain = file.clone();
    plain.effects.truncate(known);
    plain.soil.phi_deg.value = c.soil_before.phi_deg;
    plain.soil.delta_offset_deg.value = c.soil_before.delta_offset_deg;
    plain.soil.density_kg_m3.value = c.soil_before.density_kg_m3;
    let shift = c.soil_before.delta_offset_deg - c.soil_after.delta_offset_deg;
    plain.soil.delta_deg.value = (plain.soil.delta_deg.value + shift).max(0.0);
    plain
}

fn predictions(work: &Work, file: ModelFile, patch: &Path, path: &Path) -> Result<(), CliError> {
    let c = &work.diagnosis.comparison;
    let name = patch.display().to_string();
    let before = Loaded::new(without_effects(&file, work.against.known().len(), c), &name)?;
    let after = Loaded::new(file, &name)?;
    let mut text = String::from("stroke_id,force_before_n,force_after_n,heldout_before_n,heldout_after_n\n");
    for (i, row) in work.data.rows.iter().enumerate() {
        let id = row.stroke_id.clone().unwrap_or_else(|| (i + 1).to_string());
        let held =
            |values: &Option<Vec<f64>>| values.as_ref().map_or_else(String::new, |v| v[i].exp().to_string());
        text += &format!(
            "{},{},{},{},{}\n",
            quoted(&id),
            before.force_n(row)?,
            after.force_n(row)?,
            held(&c.heldout_before),
            held(&c.heldout_after)
        );
    }
    save(path, text.as_bytes())
}

/// The held-out gap by column and condition.
fn gap_table(parts: &[Part], path: &Path) -> Result<(), CliError> {
    let mut text = String::from(
        "channel,covariate,from,to,readings,normalised_rmse_before,normalised_rmse_after,delta_elpd,delta_elpd_se\n",
    );
    for part in parts {
        let [from, to] =
            part.range.map_or_else(Default::default, |range| range.map(|value| value.to_string()));
        text += &format!(
            "{},{},{from},{to},{},{},{},{},{}\n",
            part.channel,
            part.covariate.map_or("", Covariate::column),
            part.readings,
            part.before,
            part.after,
            part.delta_elpd,
            part.delta_elpd_se
        );
    }
    save(path, text.as_bytes())
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use soilctl_diagnosis::NextExperiment;
    use soilctl_effects::Channel;
    use soilctl_strokes::StrokeRow;

    #[test]
    fn a_design_leaves_what_is_to_be_measured_empty() {
        let row = StrokeRow {
            alpha_deg: 80.0,
            depth_m: 0.02,
            width_m: 0.1,
            force_n: 1.0,
            radius_m: Some(0.3),
            heap_height_m: Some(0.0),
            ..StrokeRow::default()
        };
        let readings = vec![Channel::HeapHeight];
        let next = NextExperiment { text: String::new(), rows: vec![row.clone(), row], readings, power: 1.0 };
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("next_experiment.csv");
        super::write_design(&next, &path).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let header = lines.next().unwrap();
        let at = |column: &str| header.iter().position(|name| *name == column);
        assert_eq!(at("force_n"), None);
        for line in lines.by_ref().take(2) {
            assert_eq!(line[at("heap_height_m").unwrap()], "");
            assert_eq!(line[at("radius_m").unwrap()], "0.3");
        }
        assert_eq!(lines.next(), None);
    }
}
