//! `soilctl process`: logs in, failure forces out.

mod analysis;
mod answer;
pub(crate) mod figures;
pub(crate) mod findings;
mod inputs;
mod manifest;
mod one_log;
mod outputs;
mod page;
mod words;
mod work;

use std::path::PathBuf;

pub(crate) use answer::ProcessAnswer;
use clap::ValueEnum;
pub(crate) use manifest::Skipped;
pub(crate) use outputs::save;
use soilctl_jobs::Shard;

use super::Outcome;
use super::pages::{self, FigureFiles};
use crate::args::{TopicArgs, finite};
use crate::error::CliError;
use crate::output::Output;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "A log of soilctl says itself where its strokes are, with which arm and how they were meant. Of any \
    other ROS 2 bag (.mcap) joint states and wrenches are used; it needs --surface-z and --width, and --urdf if the bag \
    holds none. /truth is never read.\n\n\
    With --out, campaign.json and traces.csv are written beside the table, and manifest.jsonl says what became of each \
    log. The same command again goes on where it was stopped and reads only logs that are new or changed.\n\n\
    Exit codes: 1 no stroke has a failure force; 2 no log can be used; 3 some log is bad or damaged, or the work was \
    stopped."
)]
pub(crate) struct Args {
    /// Logs (.mcap), or folders with logs
    #[arg(required = true, value_name = "LOG")]
    pub(crate) logs: Vec<PathBuf>,

    /// Stroke table to write (.csv or .parquet)
    #[arg(long, value_name = "FILE")]
    pub(crate) out: Option<PathBuf>,

    /// Logs that are read at a time; the answer does not depend on it [default: all processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) threads: Option<u16>,

    /// Reads only each N-th log, starting with the I-th, and writes no table: the same command without this one then takes what
    /// all shards have read, wherever they ran
    #[arg(long, value_name = "I/N", requires = "out", conflicts_with_all = ["report", "figures", "plot"])]
    pub(crate) shard: Option<Shard>,

    /// Samples a second in traces.csv
    #[arg(long, value_name = "HZ", default_value_t = 50.0, value_parser = finite)]
    pub(crate) trace_rate: f64,

    #[command(flatten)]
    pub(crate) bag: BagArgs,

    #[command(flatten)]
    pub(crate) analysis: AnalysisArgs,

    /// One HTML page with figures and what they mean
    #[arg(long, value_name = "FILE")]
    pub(crate) report: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) figures: FigureFiles,

    /// A figure (.svg, .png) or its data (.csv)
    #[arg(long, value_name = "FILE", requires = "plot_kind")]
    pub(crate) plot: Option<PathBuf>,

    /// Which figure
    #[arg(long, value_enum, requires = "plot")]
    pub(crate) plot_kind: Option<PlotKind>,
}

/// What a bag of another program does not say.
#[derive(Debug, Clone, Default, clap::Args)]
#[command(next_help_heading = "Bags of other programs")]
pub(crate) struct BagArgs {
    #[command(flatten)]
    pub(crate) topics: TopicArgs,

    /// Link at the plate's lower edge, its z axis down along the plate [default: plate_tip]
    #[arg(long, value_name = "LINK")]
    pub(crate) plate_frame: Option<String>,

    /// Tool angle (deg) [default: that of the plate frame]
    #[arg(long, value_name = "DEG", value_parser = finite)]
    pub(crate) alpha: Option<f64>,

    /// Width of the plate (m)
    #[arg(long, value_name = "M", value_parser = finite)]
    pub(crate) width: Option<f64>,

    /// Interface friction that the controller was set to (deg)
    #[arg(long, value_name = "DEG", value_parser = finite)]
    pub(crate) delta_set: Option<f64>,

    /// Readings in free air: FX,FY,FZ or FX,FY,FZ,MX,MY,MZ (N, N m) [default: those before each stroke]
    #[arg(long, value_name = "N,N,N", value_delimiter = ',', value_parser = finite, allow_hyphen_values = true)]
    pub(crate) tare: Option<Vec<f64>>,

    /// Weight of what the sensor carries (N); it turns with the sensor
    #[arg(long, value_name = "N", value_parser = finite, default_value_t = 0.0)]
    pub(crate) tool_weight: f64,

    /// CSV with the columns start and end (s, on the clock of the stamps) [default: strokes are looked for]
    #[arg(long, value_name = "FILE")]
    pub(crate) strokes: Option<PathBuf>,
}

/// What is made of the strokes.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Campaign")]
pub(crate) struct AnalysisArgs {
    /// Slant length to which forces are scaled (m)
    #[arg(long, value_name = "M", value_parser = finite, default_value_t = 0.0254)]
    pub(crate) slant: f64,

    /// Logs of rubbing a sand-covered plate: the check of the interface friction
    #[arg(long, value_name = "LOG")]
    pub(crate) rubbing: Vec<PathBuf>,

    /// Density of the soil (kg/m3): matches a friction angle to the mean force of each tool angle
    #[arg(long, value_name = "KG/M3", value_parser = finite)]
    pub(crate) density: Option<f64>,

    /// Friction angle (deg) for which the model's forces are compared; needs --density
    #[arg(long, value_name = "DEG", value_parser = finite, requires = "density")]
    pub(crate) phi: Option<f64>,

    /// Interface friction for the comparison (deg) [default: the estimate from the sweep, or the mean set-point]
    #[arg(long, value_name = "DEG", value_parser = finite)]
    pub(crate) delta: Option<f64>,

    /// Gravity for the comparison (m/s2)
    #[arg(long, value_name = "M/S2", value_parser = finite,
          default_value_t = soilctl_soil::STANDARD_GRAVITY_M_S2)]
    pub(crate) gravity: f64,

    /// Force model for the comparison
    #[arg(long, value_name = "NAME", default_value = "table")]
    pub(crate) model: String,
}

/// Figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlotKind {
    /// Lift of the force's angle at failure against set-point (figure 5-14)
    Friction,
    /// Friction angle while the plate is rubbed (figure 5-15)
    Rubbing,
    /// F/H^2 against depth
    Depth,
    /// Forces at the nominal depth against tool angle
    Campaign,
}

impl Args {
    /// All logs of a folder, with what they say themselves, into a stroke table.
    pub(crate) fn plain(folder: &std::path::Path, out: &std::path::Path) -> Self {
        Self {
            logs: vec![folder.to_owned()],
            out: Some(out.to_owned()),
            threads: None,
            shard: None,
            trace_rate: 50.0,
            bag: BagArgs::default(),
            analysis: AnalysisArgs {
                slant: 0.0254,
                rubbing: Vec::new(),
                density: None,
                phi: None,
                delta: None,
                gravity: soilctl_soil::STANDARD_GRAVITY_M_S2,
                model: "table".to_owned(),
            },
            report: None,
            figures: FigureFiles::default(),
            plot: None,
            plot_kind: None,
        }
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let (answer, outcome) = process(args, output)?;
    output.answer(&answer)?;
    Ok(outcome)
}

/// Everything but the answer on stdout.
pub(crate) fn process(args: &Args, output: &Output) -> Result<(ProcessAnswer, Outcome), CliError> {
    let inputs = inputs::Inputs::of(args)?;
    let done = work::process(&inputs, output)?;
    let campaign = outputs::campaign(&inputs)?;
    let rubbing = analysis::rubbing(args, &inputs)?;
    let analysis = analysis::analyse(&args.analysis, &done.strokes(), &campaign, rubbing)?;
    let mut written = Vec::new();
    if inputs.shard.is_none() && !done.stopped {
        written = outputs::write(&inputs, &done, &campaign)?;
    }
    if let (Some(path), Some(kind)) = (&args.plot, args.plot_kind) {
        let figure = figures::figure(kind, &analysis, &done.strokes())?;
        super::save_figure(&figure, path, soilctl_figure::Size::default())?;
        written.push(path.display().to_string());
    }
    if args.report.is_some() || args.figures.figures.is_some() {
        let mut page = page::render(&done, &analysis)?;
        written.extend(pages::write(&mut page, args.report.as_deref(), &args.figures, output)?);
    }
    let answer = ProcessAnswer::new(&done, analysis, written);
    if done.all_failed() {
        return Err(CliError::Usage(answer.failure(!output.is_quiet())));
    }
    if done.stopped {
        output.note(&format!(
            "stopped after {} of {} logs; the same command goes on from here",
            done.entries.len(),
            inputs.own().count()
        ));
    }
    let outcome = match () {
        () if done.is_partial() => Outcome::Partial,
        // A share without a stroke says nothing of the whole.
        () if answer.strokes.is_empty() && inputs.shard.is_none() => Outcome::Negative,
        () => Outcome::Done,
    };
    Ok((answer, outcome))
}
