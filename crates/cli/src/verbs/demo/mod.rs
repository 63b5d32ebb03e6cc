//! `soilctl demo`: a simulated campaign from the soil to the estimate, compared with the truth, on one page.

mod answer;
mod compare;
mod delta;
mod estimates;
mod figures;
mod folder;
mod page;
mod plan;
mod region;
mod steps;
mod words;

use std::path::PathBuf;

pub(crate) use answer::DemoAnswer;
use soilctl_campaign::{SoilPreset, presets};

use super::Outcome;
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Writes into DIR: plan.toml, a log for each preparation of the soil, strokes.csv, traces.csv, campaign.json, \
    measurements.csv, the estimates as JSON, figures/ and report.html, which needs no network. Ctrl-C keeps what is finished; \
    the same command goes on. The same soil, seed and model give the same bytes for any number of threads.\n\n\
    Exit codes: 1 no soil explains the forces; 3 strokes were lost, or the work was stopped."
)]
pub(crate) struct Args {
    /// The soil: ticino_rained, ticino_loose, nevada_fine, glass_beads, or mars_drift, mars_crusty, mars_blocky,
    /// mars_pathfinder under the gravity of Mars
    #[arg(long, value_name = "NAME", default_value = "ticino_rained")]
    soil: String,

    /// Folder for all files; made if it is not there, otherwise it must be empty or hold this demonstration [default: demo/SOIL]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Seed of noise and scatter
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Batches and logs at a time; results are the same for any number [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,

    /// Force model of the simulated soil and of the estimate [default: table, or chen for soils that it does not cover]
    #[arg(long, value_name = "NAME")]
    model: Option<String>,

    /// Four strokes instead of sixteen: every step in a quarter of the time, but too few to tell much
    #[arg(long)]
    quick: bool,

    /// Opens the page in the browser
    #[arg(long)]
    open: bool,
}

/// Friction angles that the table of certified bounds covers, in deg.
const TABLE_PHI_DEG: std::ops::RangeInclusive<f64> = 25.0..=50.0;

impl Args {
    /// The force model: the table knows no cohesion.
    fn model(&self, soil: &SoilPreset) -> String {
        let covered = soil.cohesion_pa == 0.0 && TABLE_PHI_DEG.contains(&soil.phi_deg);
        self.model.clone().unwrap_or_else(|| if covered { "table" } else { "chen" }.to_owned())
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let soil = presets().into_iter().find(|soil| soil.name == args.soil).ok_or_else(|| {
        let known: Vec<String> = presets().into_iter().map(|soil| soil.name).collect();
        CliError::Usage(format!("--soil is {}; it must be one of {}", args.soil, known.join(", ")))
    })?;
    let answer = steps::run(args, &soil, output)?;
    if let (true, Some(page)) = (args.open, &answer.files.report)
        && let Err(problem) = open::that_detached(page)
    {
        output.note(&format!("the page could not be opened ({problem}); open {page} yourself"));
    }
    output.answer(&answer)?;
    Ok(outcome(&answer))
}

fn outcome(answer: &DemoAnswer) -> Outcome {
    let consistent = answer.density_unknown.as_ref().is_some_and(|region| region.consistent);
    if answer.complete && !consistent {
        Outcome::Negative
    } else if !answer.complete || answer.strokes.made < answer.strokes.asked {
        Outcome::Partial
    } else {
        Outcome::Done
    }
}
