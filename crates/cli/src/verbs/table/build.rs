//! `table build`.

use std::path::PathBuf;

use soilctl_earth_pressure::table::{Cell, CellStatus, PredictionTable, Quantity};
use soilctl_earth_pressure::{Case, ForceModel, model};

use super::answer::{Head, TableAnswer};
use super::bounds;
use super::file::{form, write_table};
use super::grid::{Grid, Nodes};
use crate::error::CliError;
use crate::output::Output;

/// Most nodes of a table.
const MAX_CELLS: usize = 2_000_000;

/// The model that is solved rather than evaluated.
const BOUNDS: &str = "bounds";

#[derive(Debug, clap::Args)]
#[command(after_help = "Nodes at which the model has no answer (delta above phi among them) stay empty.\n\n\
    Bounds take hours: each case goes to FILE.partial.jsonl as soon as it is solved, and the same command goes on from \
    there, also after Ctrl-C (exit code 3) or a power cut. With --store a case goes there instead: any number of runs may share \
    one, on any machines that see the folder, and one with --out makes the table of it. On a finished file, a larger grid fills only what is missing. \
    Same options, same bytes: for any number of threads, interruptions or shards.")]
pub(super) struct Args {
    /// Model: bounds (lower and upper bound by limit analysis, both proven), or coulomb, log-spiral, log-spiral-thesis,
    /// caquot, chen, thesis-ub, thesis-lb, table
    #[arg(long, value_name = "NAME", default_value = BOUNDS)]
    model: String,

    /// Grid: appendix-c, the 287 sets of the thesis, or wide
    #[arg(long, value_enum, default_value_t = Grid::AppendixC)]
    grid: Grid,

    /// Nodes of the tool angle (deg) [default: 70:100:5, wide 30:110:10]
    #[arg(long, value_name = "FROM:TO:STEP")]
    alpha: Option<Nodes>,

    /// Nodes of the friction angle of the soil (deg) [default: 25:50:5, wide 20:55:5]
    #[arg(long, value_name = "FROM:TO:STEP")]
    phi: Option<Nodes>,

    /// Nodes of the interface friction angle (deg) [default: 0:30:5, wide 0:55:5]
    #[arg(long, value_name = "FROM:TO:STEP")]
    delta: Option<Nodes>,

    /// File to write (.csv, or .parquet if it is not bounds); its description goes beside it, with .json added. Not needed with
    /// --store
    #[arg(long, value_name = "FILE", required_unless_present = "store")]
    out: Option<PathBuf>,

    #[command(flatten)]
    bounds: bounds::BoundsArgs,
}

impl Args {
    fn axes(&self) -> [Vec<f64>; 3] {
        let given = [&self.alpha, &self.phi, &self.delta];
        let mut axes = self.grid.axes();
        for (axis, nodes) in axes.iter_mut().zip(given) {
            if let Some(nodes) = nodes {
                axis.clone_from(&nodes.0);
            }
        }
        axes
    }
}

pub(super) fn build(args: &Args, output: &Output) -> Result<TableAnswer, CliError> {
    let axes = args.axes();
    let size: usize = axes.iter().map(Vec::len).product();
    if size > MAX_CELLS {
        return Err(CliError::Usage(format!(
            "the table would have {size} nodes; at most {MAX_CELLS} are allowed, so take larger steps"
        )));
    }
    if args.model == BOUNDS {
        return bounds::build(&args.bounds, axes, args.out.as_deref(), output);
    }
    if let Some(option) = args.bounds.given() {
        return Err(CliError::Usage(format!(
            "{option} is for --model {BOUNDS}, and --model is {}; leave one of the two out",
            args.model
        )));
    }
    let Some(out) = &args.out else {
        return Err(CliError::Usage("--out is missing: name the file for the table".into()));
    };
    // Before the work, not after it.
    form(out)?;
    let model = model(&args.model)?;
    let (table, first_refusal) = fill(model.as_ref(), axes, output)?;
    if table.is_empty() {
        let reason = first_refusal.unwrap_or_else(|| "delta is above phi everywhere".into());
        return Err(CliError::Usage(format!("no node of the table could be filled: {reason}")));
    }
    let source = format!("{} on a grid; {}", model.id(), model.reference());
    write_table(&table, &source, out)?;
    let file = out.display().to_string();
    Ok(TableAnswer::Build { table: Head::of(&table, &source), file, first_refusal })
}

fn fill(
    model: &dyn ForceModel,
    axes: [Vec<f64>; 3],
    output: &Output,
) -> Result<(PredictionTable, Option<String>), CliError> {
    let mut table = PredictionTable::new(model.id(), Quantity::Estimate, axes.clone())?;
    let mut first_refusal = None;
    let progress = output.bar(table.len() as u64, "cells");
    for &alpha in &axes[0] {
        for &phi in &axes[1] {
            for &delta in axes[2].iter().filter(|delta| **delta <= phi) {
                match model.predict(&Case::level_deg(alpha, phi, delta)) {
                    Ok(found) => {
                        let solved = found.interpolation_margin == 0.0;
                        let status = if solved { CellStatus::Solved } else { CellStatus::Interpolated };
                        table.insert([alpha, phi, delta], Cell { k_net: found.k_net().0, status })?;
                    }
                    Err(problem) => first_refusal = first_refusal.or(Some(problem.to_string())),
                }
            }
            progress.inc(axes[2].len() as u64);
        }
    }
    progress.finish();
    Ok((table, first_refusal))
}
