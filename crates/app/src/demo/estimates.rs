//! The estimates of a demonstration, beside the truth.

use std::path::Path;

use soilctl_campaign::Plan;
use soilctl_process::table::StrokeRecord;
use soilctl_strokes::{Campaign, StrokeRow, StrokeTable};

use super::answer::{Answer, DENSITY_UNKNOWN, DENSITY_WEIGHED, EachStroke, TRUE_FORCES};
use super::delta;
use super::folder::Folder;
use super::region::{self, Known};
use crate::estimate::Estimation;
use crate::files::save;
use crate::request::Ends;
use crate::{AppError, document};

/// An estimate, or why there is none.
pub struct Estimated {
    /// Its name.
    pub name: &'static str,
    /// The estimate, or in words why there is none.
    pub work: Result<Estimation, String>,
}

/// Marks strokes by their names; says how many.
pub(super) fn mark<'a>(
    each: &mut [EachStroke],
    names: impl Iterator<Item = &'a String>,
    field: fn(&mut EachStroke) -> &mut bool,
) -> usize {
    let names: Vec<&String> = names.collect();
    let mut count = 0;
    for stroke in each {
        if stroke.stroke_id.as_ref().is_some_and(|id| names.contains(&id)) {
            *field(stroke) = true;
            count += 1;
        }
    }
    count
}

fn write(path: &Path, rows: &[StrokeRow]) -> Result<(), AppError> {
    Ok(StrokeTable::new(&path.display().to_string(), rows)?.write(path)?)
}

/// Friction angle and density, with the density unknown and as weighed, and from the true forces.
pub(super) fn all(
    answer: &mut Answer,
    folder: &Folder,
    plan: &Plan,
    ends: Ends,
    strokes: &[StrokeRecord],
    density_kg_m3: Option<f64>,
) -> Result<Vec<Estimated>, AppError> {
    let interval_deg = delta::interval_deg(answer.delta.as_ref(), answer.delta_guess_deg);
    if strokes.is_empty() {
        answer.no_estimate = Some("no stroke has a failure force".into());
        return Ok(Vec::new());
    }
    answer.delta_used_deg = Some(interval_deg);
    let table = folder.file("measurements.csv");
    let campaign = Campaign::read_beside(&table)?.unwrap_or_default();
    let rows: Vec<StrokeRow> = strokes.iter().map(|stroke| stroke.at_failure(interval_deg)).collect();
    write(&table, &rows)?;
    answer.files.measurements = Some(table.display().to_string());
    let known = |measurements| Known {
        measurements,
        model: &answer.model,
        ends,
        cohesion_pa: plan.soil().cohesion_pa,
        gravity_m_s2: plan.soil().gravity_m_s2,
        density_sd_rel: campaign.density_sd_rel,
    };
    let mut wanted = vec![(DENSITY_UNKNOWN, Some("estimate.json"), known(&table).request(None))];
    wanted.extend(density_kg_m3.map(|density| {
        (DENSITY_WEIGHED, Some("estimate_weighed.json"), known(&table).request(Some(density)))
    }));
    let true_table = folder.file("measurements_true.csv");
    let true_rows = strokes.iter().filter_map(|stroke| {
        let truth = answer.each.iter().find(|one| one.stroke_id == stroke.row.stroke_id)?;
        Some(stroke.in_truth(truth.true_force_n?, truth.true_depth_m?, interval_deg))
    });
    let true_rows: Vec<StrokeRow> = true_rows.collect();
    if !true_rows.is_empty() {
        write(&true_table, &true_rows)?;
        wanted.push((TRUE_FORCES, None, known(&true_table).request(None)));
    }
    let mut all = Vec::new();
    for (name, file, request) in wanted {
        let work = region::estimate(&request)?;
        let found = work.as_ref().ok().map(|work| region::region(work, &answer.truth));
        if let (Some(file), Ok(work)) = (file, &work) {
            let path = folder.file(file);
            save(&path, document(&work.answer)?.as_bytes())?;
            answer.files.estimates.push(path.display().to_string());
        }
        if let Err(problem) = &work {
            answer.no_estimate.get_or_insert_with(|| format!("{name}: {problem}"));
        }
        match name {
            DENSITY_UNKNOWN => {
                if let Ok(work) = &work {
                    let is_out = |id: &String| {
                        work.answer.left_out.iter().any(|out| out.stroke_id.as_ref() == Some(id))
                    };
                    let names = strokes.iter().filter_map(|s| s.row.stroke_id.as_ref());
                    answer.strokes.used_for_phi =
                        mark(&mut answer.each, names.filter(|id| !is_out(id)), |s| &mut s.used_for_phi);
                }
                answer.density_unknown = found;
            }
            DENSITY_WEIGHED => answer.density_weighed = found,
            _ => answer.true_forces = found,
        }
        all.push(Estimated { name, work });
    }
    Ok(all)
}
