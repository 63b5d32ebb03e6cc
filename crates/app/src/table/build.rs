//! Fills a table, with proven bounds or from another model; fills what is missing in one that is there.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::{Cell, CellStatus, PredictionTable, Quantity};
use soilctl_earth_pressure::{Case, ForceModel, plane_model};

pub use super::Answer;
use super::Head;
use super::bounds::{self, BoundsOptions};
use super::grid::{Grid, Nodes, check_axes};
use crate::table_file::{form, write_table};
use crate::{AppError, Watch};

/// Most nodes of a table.
const MAX_CELLS: usize = 2_000_000;

/// The model that is solved rather than evaluated.
const BOUNDS: &str = "bounds";

/// Fills a table, with proven bounds or from another model; fills what is missing in one that is there.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Model: bounds (lower and upper bound by limit analysis, both proven), or coulomb, log-spiral, log-spiral-thesis,
    /// caquot, chen, thesis-ub, thesis-lb, table
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model)]
    pub model: String,

    /// Grid: appendix-c, the 287 sets of the thesis, or wide
    #[arg(long, value_enum, default_value_t)]
    pub grid: Grid,

    /// Nodes of the tool angle (deg) [default: 70:100:5, wide 30:110:10]
    #[arg(long = "alpha", value_name = "FROM:TO:STEP")]
    #[schemars(with = "Option<String>")]
    pub alpha_deg: Option<Nodes>,

    /// Nodes of the friction angle of the soil (deg) [default: 25:50:5, wide 20:55:5]
    #[arg(long = "phi", value_name = "FROM:TO:STEP")]
    #[schemars(with = "Option<String>")]
    pub phi_deg: Option<Nodes>,

    /// Nodes of the interface friction angle (deg) [default: 0:30:5, wide 0:55:5]
    #[arg(long = "delta", value_name = "FROM:TO:STEP")]
    #[schemars(with = "Option<String>")]
    pub delta_deg: Option<Nodes>,

    /// File to write (.csv, or .parquet if it is not bounds); its description goes beside it, with .json added. Not needed with
    /// --store
    #[arg(long, value_name = "FILE", required_unless_present = "store")]
    pub out: Option<PathBuf>,

    #[command(flatten)]
    #[serde(flatten)]
    #[allow(missing_docs)]
    pub bounds: BoundsOptions,
}

impl Default for Request {
    fn default() -> Self {
        Self {
            model: BOUNDS.into(),
            grid: Grid::default(),
            alpha_deg: None,
            phi_deg: None,
            delta_deg: None,
            out: None,
            bounds: BoundsOptions::default(),
        }
    }
}

impl Request {
    fn axes(&self) -> [Vec<f64>; 3] {
        let given = [&self.alpha_deg, &self.phi_deg, &self.delta_deg];
        let mut axes = self.grid.axes();
        for (axis, nodes) in axes.iter_mut().zip(given) {
            if let Some(nodes) = nodes {
                *axis = nodes.values();
            }
        }
        axes
    }
}

/// Builds the table, or goes on with one.
///
/// # Errors
/// [`AppError`] if the request makes no sense, nothing could be filled, or a file cannot be read or written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let axes = request.axes();
    let size: usize = axes.iter().map(Vec::len).product();
    if size > MAX_CELLS {
        return Err(AppError::Request(format!(
            "the table would have {size} nodes; at most {MAX_CELLS} are allowed, so take larger steps"
        )));
    }
    check_axes(&axes)?;
    if request.model == BOUNDS {
        return bounds::build(&request.bounds, axes, request.out.as_deref(), watch);
    }
    if let Some(option) = request.bounds.given() {
        return Err(AppError::Request(format!(
            "{option} is for --model {BOUNDS}, and --model is {}; leave one of the two out",
            request.model
        )));
    }
    let Some(out) = &request.out else {
        return Err(AppError::Request("--out is missing: name the file for the table".into()));
    };
    // Before the work, not after it.
    form(out)?;
    let model = plane_model(&request.model)?;
    let (table, first_refusal) = fill(model.as_ref(), axes, watch)?;
    if table.is_empty() {
        let reason = first_refusal.unwrap_or_default();
        return Err(AppError::Request(format!("no node of the table could be filled: {reason}")));
    }
    let source = format!("{} on a grid; {}", model.id(), model.reference());
    write_table(&table, &source, out)?;
    let file = out.display().to_string();
    Ok(Answer::Build { table: Head::of(&table, &source), file, first_refusal })
}

fn fill(
    model: &dyn ForceModel,
    axes: [Vec<f64>; 3],
    watch: &dyn Watch,
) -> Result<(PredictionTable, Option<String>), AppError> {
    let mut table = PredictionTable::new(model.id(), Quantity::Estimate, axes.clone())?;
    let mut first_refusal = None;
    watch.begin(table.len() as u64, "cells");
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
            watch.advance(axes[2].len() as u64);
        }
    }
    watch.end();
    Ok((table, first_refusal))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::from_json;

    #[test]
    fn nodes_and_shards_are_written_in_json_as_in_options() {
        let text =
            r#"{"grid": "wide", "alpha_deg": "70:80:5", "shard": "1/2", "out": "t.csv", "max_gap": 0.1}"#;
        let request: Request = from_json(text).unwrap();
        assert_eq!(request.axes()[0], [70.0, 75.0, 80.0]);
        assert_eq!(request.axes()[2].len(), 12);
        let written = serde_json::to_value(&request).unwrap();
        assert_eq!((&written["alpha_deg"], &written["shard"]), (&"70:80:5".into(), &"1/2".into()));
        for wrong in [r#"{"alpha_deg": "70"}"#, r#"{"shard": "3/2"}"#, r#"{"max_elements": 10}"#] {
            assert!(from_json::<Request>(wrong).is_err(), "{wrong}");
        }
    }
}
