//! Bounds of a tool over friction angles, as a table that goes on where it was broken off.
//!
//! Beside the table is a file with `.json` added to its name: what the table was made from, and its rows. A table made from the same is gone on with; rows
//! without bounds are tried again.

use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_columns::{Cell, Kind};

use super::file::ToolFile;
use super::ground::Placed;
use super::request::{Request, Setting};
use crate::files::{read_text, save, save_table};
use crate::watch::OneOfMany;
use crate::{AppError, Interrupted, Watch};

/// What a file beside a table says that it is.
const SCHEMA: &str = "soilctl.tool-table/1";

/// Most rows: each is a proof of seconds to minutes.
const MOST: usize = 2000;

/// Bounds at one pair of friction angles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RowAnswer {
    /// Internal friction angle of the soil.
    pub phi_deg: f64,
    /// Friction angle between soil and tool, where the tool file says none; null if it says all.
    pub delta_deg: Option<f64>,
    /// Lower bound on the force along the motion, per metre of width, with ends if a width is given; null if none is proven.
    pub lower_n_per_m: Option<f64>,
    /// Upper bound likewise.
    pub upper_n_per_m: Option<f64>,
    /// Lower bound on the coefficient of that force, as in the answer.
    pub coefficient_lower: Option<f64>,
    /// Upper bound on it.
    pub coefficient_upper: Option<f64>,
    /// Their gap; null as in the answer.
    pub gap: Option<f64>,
    /// Why there are no bounds; null if there are.
    pub problem: Option<String>,
}

/// The table that was written.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct TableAnswer {
    /// Its file.
    pub file: String,
    /// Rows that an earlier run had made.
    pub kept_rows: usize,
    /// All rows, by friction angle of the soil and then of the interface.
    pub rows: Vec<RowAnswer>,
}

/// What is beside a table.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Beside {
    schema: String,
    program: String,
    tool: ToolFile,
    /// The request without what differs from row to row.
    request: Request,
    rows: Vec<RowAnswer>,
}

impl Beside {
    fn new(request: &Request, tool: ToolFile) -> Self {
        let setting =
            Setting { phi_deg: 0.0, delta_deg: None, file: PathBuf::new(), ..request.setting.clone() };
        let request = Request {
            setting,
            budget: request.budget.clone(),
            width_m: request.width_m,
            ..Request::default()
        };
        let program = format!("soilctl {}", env!("CARGO_PKG_VERSION"));
        Self { schema: SCHEMA.into(), program, tool, request, rows: Vec::new() }
    }

    /// Takes rows from an earlier run that made them from the same.
    fn take_rows(&mut self, beside: &Path) -> Result<(), AppError> {
        if !beside.exists() {
            return Ok(());
        }
        let wrong = |problem: &str| AppError::Request(format!("{}: {problem}", beside.display()));
        let mut earlier: Self =
            serde_json::from_str(&read_text(beside)?).map_err(|problem| wrong(&problem.to_string()))?;
        let rows = std::mem::take(&mut earlier.rows);
        // Compared as they are written: numbers as text, no key left out.
        if serde_json::to_value(&earlier)? != serde_json::to_value(&*self)? {
            return Err(wrong(
                "the table was made from another tool, other options or by another version; name another --table, or remove this file",
            ));
        }
        self.rows = rows;
        Ok(())
    }

    fn write(&self, table: &Path, beside: &Path) -> Result<(), AppError> {
        save(beside, serde_json::to_string_pretty(self)?.as_bytes())?;
        let known = |x: Option<f64>| x.map_or(Cell::Missing, Cell::Float);
        let row = |row: &RowAnswer| {
            [
                Cell::Float(row.phi_deg),
                known(row.delta_deg),
                known(row.lower_n_per_m),
                known(row.upper_n_per_m),
                known(row.coefficient_lower),
                known(row.coefficient_upper),
                known(row.gap),
            ]
        };
        save_table(table, "tool", COLUMNS, self.rows.iter().map(row))
    }
}

const COLUMNS: [(&str, Kind); 7] = [
    ("phi_deg", Kind::Decimal),
    ("delta_deg", Kind::OptionalFloat),
    ("lower_n_per_m", Kind::OptionalFloat),
    ("upper_n_per_m", Kind::OptionalFloat),
    ("coefficient_lower", Kind::OptionalFloat),
    ("coefficient_upper", Kind::OptionalFloat),
    ("gap", Kind::OptionalFloat),
];

/// The pairs of friction angles of a request: interfaces are no rougher than the soil.
fn pairs(request: &Request, tool: &ToolFile) -> Result<Vec<(f64, Option<f64>)>, AppError> {
    if request.deltas_deg.is_some() && tool.delta_deg.is_some() {
        return Err(AppError::Request(
            "--deltas is of interfaces that the tool file leaves out, and it has a delta_deg for all pieces; remove that, or leave --deltas out".into(),
        ));
    }
    let phis =
        request.phis_deg.as_ref().map_or_else(|| vec![request.setting.phi_deg], |nodes| nodes.values());
    let deltas: Vec<Option<f64>> = request.deltas_deg.as_ref().map_or_else(
        || vec![request.setting.delta_deg],
        |nodes| nodes.values().into_iter().map(Some).collect(),
    );
    let all: Vec<_> = phis
        .iter()
        .flat_map(|phi| deltas.iter().map(move |delta| (*phi, *delta)))
        .filter(|(phi, delta)| delta.is_none_or(|delta| delta <= *phi))
        .collect();
    if all.is_empty() || all.len() > MOST {
        return Err(AppError::Request(format!(
            "the table would have {} rows with an interface no rougher than the soil; it may have 1 to {MOST}, so change --phis and --deltas",
            all.len()
        )));
    }
    Ok(all)
}

/// Refuses what cannot become a table, before any work.
pub(super) fn check(request: &Request, tool: &ToolFile, table: &Path) -> Result<(), AppError> {
    crate::files::table_form(table)?;
    pairs(request, tool)?;
    Beside::new(request, tool.clone()).take_rows(&beside(table))
}

fn beside(table: &Path) -> PathBuf {
    let mut name = table.as_os_str().to_owned();
    name.push(".json");
    name.into()
}

/// Makes the table, or goes on with it; each row is saved when it is made.
pub(super) fn run(
    request: &Request,
    tool: &ToolFile,
    table: &Path,
    watch: &dyn Watch,
) -> Result<TableAnswer, AppError> {
    let stop = watch.stop(Interrupted::KeepsResults);
    let pairs = pairs(request, tool)?;
    let file = beside(table);
    let mut made = Beside::new(request, tool.clone());
    made.take_rows(&file)?;
    let earlier = std::mem::take(&mut made.rows);
    let mut kept_rows = 0;
    watch.begin(pairs.len() as u64, "rows");
    for (phi_deg, delta_deg) in pairs {
        let is_this =
            |row: &&RowAnswer| row.phi_deg == phi_deg && row.delta_deg == delta_deg && row.problem.is_none();
        let row = if let Some(row) = earlier.iter().find(is_this) {
            kept_rows += 1;
            row.clone()
        } else if stop.load(Ordering::Relaxed) {
            RowAnswer::none(phi_deg, delta_deg, "the run was ended before this row".into())
        } else {
            RowAnswer::new(request, tool, phi_deg, delta_deg, watch)
        };
        made.rows.push(row);
        made.write(table, &file)?;
        watch.advance(1);
    }
    watch.end();
    Ok(TableAnswer { file: table.display().to_string(), kept_rows, rows: made.rows })
}

impl RowAnswer {
    fn new(
        request: &Request,
        tool: &ToolFile,
        phi_deg: f64,
        delta_deg: Option<f64>,
        watch: &dyn Watch,
    ) -> Self {
        let setting = Setting { phi_deg, delta_deg, ..request.setting.clone() };
        let one = Request {
            setting,
            budget: request.budget.clone(),
            width_m: request.width_m,
            ..Request::default()
        };
        let watch = OneOfMany { watch, name: None };
        let found = Placed::of_file(tool.clone(), &one.setting)
            .and_then(|placed| super::bounded(&one, &placed, Vec::new(), &watch));
        match found {
            Ok(found) => {
                let answer = found.answer;
                Self {
                    phi_deg,
                    delta_deg,
                    lower_n_per_m: Some(answer.lower_n_per_m),
                    upper_n_per_m: Some(answer.upper_n_per_m),
                    coefficient_lower: Some(answer.coefficient_lower),
                    coefficient_upper: Some(answer.coefficient_upper),
                    gap: answer.gap,
                    problem: None,
                }
            }
            Err(problem) => Self::none(phi_deg, delta_deg, problem.to_string()),
        }
    }

    fn none(phi_deg: f64, delta_deg: Option<f64>, problem: String) -> Self {
        Self {
            phi_deg,
            delta_deg,
            lower_n_per_m: None,
            upper_n_per_m: None,
            coefficient_lower: None,
            coefficient_upper: None,
            gap: None,
            problem: Some(problem),
        }
    }
}
