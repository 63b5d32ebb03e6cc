//! The demonstration, step by step; each is a use case.

use soilctl_campaign::{BatchTruth, Plan, SoilPreset, demonstration, read_truth};

use super::answer::{Answer, Files, StrokeCount, Truth};
use super::compare::{self, Batch};
use super::estimates::{self, Estimated};
use super::folder::{Folder, Made};
use super::{Request, delta, found, recovered};
use crate::files::save;
use crate::request::Ends;
use crate::{AppError, Watch, process, simulate};

/// A demonstration with everything that figures and page are drawn from.
pub struct Demonstration {
    /// The answer.
    pub answer: Answer,
    /// What it comes from; `None` if the work was stopped.
    pub work: Option<Work>,
}

/// What a demonstration did.
pub struct Work {
    /// The campaign.
    pub plan: Plan,
    /// What the logs gave.
    pub processed: process::Answer,
    /// With density unknown, as weighed, and from the true forces, as far as there are.
    pub estimates: Vec<Estimated>,
    /// Mean density of the preparations as weighed, in kg/m3.
    pub density_kg_m3: Option<f64>,
}

/// Simulates a campaign, finds its forces and the soil behind them, and compares with the truth. All files but figures and page are
/// written.
///
/// # Errors
/// [`AppError`] if the request makes no sense, or a file cannot be read or written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Demonstration, AppError> {
    crate::request::check(request)?;
    let soil = request.soil()?;
    let model = request.model(&soil);
    let guess_deg = soil.delta_deg.round();
    let (ends, end_factor) = request.ends(&model)?;
    let plan = demonstration(&soil.name, &model, end_factor, request.seed, guess_deg, request.quick)?;
    let out = request.out.clone().unwrap_or_else(|| std::path::Path::new("demo").join(&soil.name));
    let folder =
        Folder::open(&out, &Made::new(soil.name.clone(), request.seed, model, end_factor, request.quick))?;
    save(&folder.file("plan.toml"), plan.text().as_bytes())?;
    let mut answer = begun(&soil, &plan, &folder, guess_deg);
    let work = work(request, &soil, plan, ends, &folder, &mut answer, watch)?;
    Ok(Demonstration { answer, work })
}

/// Fills the answer; `None` if the work was stopped.
fn work(
    request: &Request,
    soil: &SoilPreset,
    plan: Plan,
    ends: Ends,
    folder: &Folder,
    answer: &mut Answer,
    watch: &dyn Watch,
) -> Result<Option<Work>, AppError> {
    watch.note(&format!("1 of 4: {} strokes on the simulated arm, {}", answer.strokes.asked, soil.title));
    let campaign = simulate::Request {
        file: folder.file("plan.toml"),
        out: folder.path.clone(),
        seed: None,
        threads: request.threads,
        model_file: None,
    };
    let simulated = simulate::run(&campaign, watch)?;
    answer.files.logs =
        simulated.batches.iter().map(|batch| folder.file(&batch.log).display().to_string()).collect();
    answer.strokes.made = simulated.batches.iter().map(|batch| batch.strokes_done).sum();
    if !simulated.complete {
        return Ok(None);
    }

    watch.note("2 of 4: failure forces from the logs");
    let truths: Vec<BatchTruth> = simulated
        .batches
        .iter()
        .map(|batch| read_truth(&folder.file(&batch.log)))
        .collect::<Result<_, _>>()?;
    let density_kg_m3 = weighed(&truths);
    let processed = process::run(&logs(request, answer, folder, density_kg_m3), watch)?;
    if processed.stopped {
        return Ok(None);
    }

    watch.note("3 of 4: interface friction, friction angle and density");
    compared(answer, &plan, &simulated, truths, &processed);
    let estimates = estimates::all(answer, folder, &plan, ends, &processed.strokes, density_kg_m3)?;
    answer.complete = true;
    answer.not_recovered = recovered::not_recovered(answer);
    answer.found = found::in_words(answer);
    Ok(Some(Work { plan, processed, estimates, density_kg_m3 }))
}

/// What is asked of the logs.
fn logs(request: &Request, answer: &Answer, folder: &Folder, density_kg_m3: Option<f64>) -> process::Request {
    process::Request {
        logs: answer.files.logs.iter().map(Into::into).collect(),
        out: Some(folder.file("strokes.csv")),
        threads: request.threads,
        analysis: process::AnalysisRequest {
            // Its comparison with a model knows no cohesion.
            density_kg_m3: density_kg_m3.filter(|_| answer.truth.cohesion_pa == 0.0),
            delta_deg: Some(answer.delta_guess_deg),
            gravity_m_s2: answer.truth.gravity_m_s2,
            model: answer.model.clone(),
            ..process::AnalysisRequest::default()
        },
        ..process::Request::default()
    }
}

/// The answer before anything is done.
fn begun(soil: &SoilPreset, plan: &Plan, folder: &Folder, guess_deg: f64) -> Answer {
    Answer {
        soil: soil.name.clone(),
        title: soil.title.clone(),
        model: plan.file().model.clone(),
        seed: plan.file().seed,
        complete: false,
        found: String::new(),
        truth: Truth {
            phi_deg: soil.phi_deg,
            delta_deg: soil.delta_deg,
            density_kg_m3: soil.density_kg_m3,
            cohesion_pa: soil.cohesion_pa,
            gravity_m_s2: soil.gravity_m_s2,
            end_factor: plan.file().end_factor,
        },
        strokes: StrokeCount {
            asked: plan.strokes().strokes().len(),
            made: 0,
            with_force: 0,
            used_for_delta: 0,
            used_for_phi: 0,
        },
        delta_guess_deg: guess_deg,
        delta: None,
        no_delta: None,
        delta_used_deg: None,
        density_unknown: None,
        density_weighed: None,
        true_forces: None,
        no_estimate: None,
        forces: None,
        each: compare::each(plan, &[]),
        not_recovered: Vec::new(),
        files: Files {
            folder: folder.path.display().to_string(),
            plan: folder.file("plan.toml").display().to_string(),
            ..Files::default()
        },
    }
}

/// Mean density of the preparations as weighed, in kg/m3.
fn weighed(truths: &[BatchTruth]) -> Option<f64> {
    let all: Vec<f64> = truths.iter().filter_map(|truth| truth.weighed_density_kg_m3).collect();
    (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64)
}

/// Strokes and interface friction beside the truth.
fn compared(
    answer: &mut Answer,
    plan: &Plan,
    simulated: &simulate::Answer,
    truths: Vec<BatchTruth>,
    processed: &process::Answer,
) {
    let of = |log: &str| processed.logs.iter().find(|entry| entry.log.ends_with(log));
    let batches: Vec<Batch<'_>> = simulated
        .batches
        .iter()
        .zip(truths)
        .map(|(report, truth)| Batch {
            report,
            truth,
            strokes: processed
                .strokes
                .iter()
                .filter(|stroke| stroke.failure.log.ends_with(&report.log))
                .collect(),
            skipped: of(&report.log).map_or(&[] as &[process::Skipped], |entry| &entry.skipped),
        })
        .collect();
    answer.each = compare::each(plan, &batches);
    answer.forces = compare::forces(&answer.each);
    answer.strokes.with_force = processed.strokes.len();
    if !processed.strokes.is_empty() {
        answer.files.strokes = processed.written.first().cloned();
    }
    match &processed.analysis.friction {
        Some(found) => {
            let found_delta = delta::compared(found, answer.truth.delta_deg);
            answer.no_delta = delta::objection(&found_delta);
            answer.delta = Some(found_delta);
            answer.strokes.used_for_delta =
                estimates::mark(&mut answer.each, found.strokes.iter().map(|s| &s.stroke_id), |s| {
                    &mut s.used_for_delta
                });
        }
        None => answer.no_delta.clone_from(&processed.analysis.no_friction),
    }
}
