//! `table build`.

use std::path::PathBuf;

use soilctl_earth_pressure::table::{Cell, CellStatus, PredictionTable, Quantity};
use soilctl_earth_pressure::{Case, ForceModel, model};

use super::answer::{Head, TableAnswer};
use super::file::{Kind, write_table};
use super::grid::Nodes;
use crate::error::CliError;
use crate::output::Output;

/// Most nodes of a table.
const MAX_CELLS: usize = 2_000_000;

#[derive(Debug, clap::Args)]
#[command(after_help = "Nodes at which the model has no answer (delta above phi among them) stay empty.")]
pub(super) struct Args {
    /// Model: coulomb, log-spiral, log-spiral-thesis, caquot, chen, thesis-ub, thesis-lb, table
    #[arg(long, value_name = "NAME", default_value = "chen")]
    model: String,

    /// Nodes of the tool angle (deg)
    #[arg(long, value_name = "FROM:TO:STEP", default_value = "70:100:5")]
    alpha: Nodes,

    /// Nodes of the friction angle of the soil (deg)
    #[arg(long, value_name = "FROM:TO:STEP", default_value = "25:50:5")]
    phi: Nodes,

    /// Nodes of the interface friction angle (deg)
    #[arg(long, value_name = "FROM:TO:STEP", default_value = "0:30:5")]
    delta: Nodes,

    /// File to write (.csv or .parquet); its description goes beside it, with .json added to the name
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

pub(super) fn build(args: &Args, output: &Output) -> Result<TableAnswer, CliError> {
    let axes = [args.alpha.0.clone(), args.phi.0.clone(), args.delta.0.clone()];
    let size: usize = axes.iter().map(Vec::len).product();
    if size > MAX_CELLS {
        return Err(CliError::Usage(format!(
            "the table would have {size} nodes; at most {MAX_CELLS} are allowed, so take larger steps"
        )));
    }
    // Before the work, not after it.
    Kind::of(&args.out)?;
    let model = model(&args.model)?;
    let (table, first_refusal) = fill(model.as_ref(), axes, output)?;
    if table.is_empty() {
        let reason = first_refusal.unwrap_or_else(|| "delta is above phi everywhere".into());
        return Err(CliError::Usage(format!("no node of the table could be filled: {reason}")));
    }
    let source = format!("{} on a grid; {}", model.id(), model.reference());
    write_table(&table, &source, &args.out)?;
    let file = args.out.display().to_string();
    Ok(TableAnswer::Build { table: Head::of(&table, &source), file, first_refusal })
}

fn fill(
    model: &dyn ForceModel,
    axes: [Vec<f64>; 3],
    output: &Output,
) -> Result<(PredictionTable, Option<String>), CliError> {
    let mut table = PredictionTable::new(model.id(), Quantity::Estimate, axes.clone())?;
    let mut first_refusal = None;
    let progress = output.progress(table.len() as u64);
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
    progress.finish_and_clear();
    Ok((table, first_refusal))
}
