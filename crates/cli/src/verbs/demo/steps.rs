//! The demonstration, step by step; each is what a verb does.

use soilctl_campaign::{BatchTruth, Options, Plan, SoilPreset, read_truth};

use super::Args;
use super::answer::{DemoAnswer, Files, StrokeCount, Truth};
use super::compare::{self, Batch};
use super::estimates::{self, Estimated};
use super::folder::{Folder, Made};
use super::{delta, figures, page, plan, words};
use crate::error::CliError;
use crate::output::Output;
use crate::verbs::pages::{self, FigureFiles};
use crate::verbs::process::{self, ProcessAnswer, Skipped, save};
use soilctl_app::simulate::{self, Answer as SimulateAnswer};

/// Everything that the page tells beside the answer.
pub(super) struct Told<'a> {
    pub(super) folder: &'a Folder,
    pub(super) plan: &'a Plan,
    pub(super) processed: &'a ProcessAnswer,
    /// With density unknown, as weighed, and from the true forces, as far as there are.
    pub(super) estimates: &'a [Estimated],
    pub(super) density_kg_m3: Option<f64>,
}

pub(super) fn run(args: &Args, soil: &SoilPreset, output: &Output) -> Result<DemoAnswer, CliError> {
    let model = args.model(soil);
    let guess_deg = soil.delta_deg.round();
    let plan = plan::plan(&soil.name, &model, args.seed, guess_deg, args.quick)?;
    let out = args.out.clone().unwrap_or_else(|| std::path::Path::new("demo").join(&soil.name));
    let folder = Folder::open(&out, &Made::new(soil.name.clone(), args.seed, model.clone(), args.quick))?;
    save(&folder.file("plan.toml"), plan.text().as_bytes())?;
    let mut answer = begun(soil, &plan, &folder, &model, args.seed, guess_deg);

    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let threads = args.threads.map_or(cores, usize::from);
    let asked = answer.strokes.asked;
    output.note(&format!("1 of 4: {asked} strokes on the simulated arm, {}", soil.title));
    let options = Options { out: &out, seed: args.seed, threads };
    let simulated = simulate::campaign(&plan, None, &options, output)?;
    answer.files.logs =
        simulated.batches.iter().map(|batch| folder.file(&batch.log).display().to_string()).collect();
    answer.strokes.made = simulated.batches.iter().map(|batch| batch.strokes_done).sum();
    answer.each = compare::each(&plan, &[]);
    if !simulated.complete {
        return Ok(answer);
    }

    output.note("2 of 4: failure forces from the logs");
    let truths: Vec<BatchTruth> = simulated
        .batches
        .iter()
        .map(|batch| read_truth(&folder.file(&batch.log)))
        .collect::<Result<_, _>>()?;
    let density_kg_m3 = weighed(&truths);
    let (processed, _) = process::process(&process_args(&answer, &folder, threads, density_kg_m3)?, output)?;
    if processed.stopped {
        return Ok(answer);
    }
    output.note("3 of 4: interface friction, friction angle and density");
    compared(&mut answer, &plan, &simulated, truths, &processed);
    let estimates = estimates::all(&mut answer, &folder, &plan, &processed.strokes, density_kg_m3)?;
    answer.complete = true;
    answer.not_recovered = words::not_recovered(&answer);

    output.note("4 of 4: the page");
    let told =
        Told { folder: &folder, plan: &plan, processed: &processed, estimates: &estimates, density_kg_m3 };
    let drawn = figures::all(&answer, &told)?;
    answer.files.figures = figures::save_all(&drawn, &folder)?;
    let path = folder.file("report.html");
    answer.files.report = Some(path.display().to_string());
    pages::write(&mut page::render(&answer, &told, &drawn)?, Some(&path), &FigureFiles::default(), output)?;
    Ok(answer)
}

/// The answer before anything is done.
fn begun(
    soil: &SoilPreset,
    plan: &Plan,
    folder: &Folder,
    model: &str,
    seed: u64,
    guess_deg: f64,
) -> DemoAnswer {
    DemoAnswer {
        soil: soil.name.clone(),
        title: soil.title.clone(),
        model: model.to_owned(),
        seed,
        complete: false,
        truth: Truth {
            phi_deg: soil.phi_deg,
            delta_deg: soil.delta_deg,
            density_kg_m3: soil.density_kg_m3,
            cohesion_pa: soil.cohesion_pa,
            gravity_m_s2: soil.gravity_m_s2,
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
        each: Vec::new(),
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

/// The options of `soilctl process`.
fn process_args(
    answer: &DemoAnswer,
    folder: &Folder,
    threads: usize,
    density_kg_m3: Option<f64>,
) -> Result<process::Args, CliError> {
    Ok(process::Args {
        logs: answer.files.logs.iter().map(Into::into).collect(),
        out: Some(folder.file("strokes.csv")),
        shard: None,
        threads: Some(u16::try_from(threads).unwrap_or(u16::MAX)),
        trace_rate: figures::TRACE_RATE_HZ,
        bag: process::BagArgs::default(),
        analysis: process::AnalysisArgs {
            slant: plan::SLANT_M,
            rubbing: Vec::new(),
            // Its comparison with a model knows no cohesion.
            density: density_kg_m3.filter(|_| answer.truth.cohesion_pa == 0.0),
            phi: None,
            delta: Some(answer.delta_guess_deg),
            gravity: answer.truth.gravity_m_s2,
            model: answer.model.clone(),
        },
        report: None,
        figures: FigureFiles::default(),
        plot: None,
        plot_kind: None,
    })
}

/// Strokes and interface friction beside the truth.
fn compared(
    answer: &mut DemoAnswer,
    plan: &Plan,
    simulated: &SimulateAnswer,
    truths: Vec<BatchTruth>,
    processed: &ProcessAnswer,
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
            skipped: of(&report.log).map_or(&[] as &[Skipped], |entry| &entry.skipped),
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
