use std::path::Path;

use serde::Serialize;

use crate::error::DirectShearError;
use crate::table::Table;

pub(crate) const READING_ALLOWED: &str = "a number between -1e9 and 1e9";

/// Bounded, so that no difference of readings can overflow.
pub(crate) fn reading_ok(reading: f64) -> bool {
    reading.is_finite() && reading.abs() <= 1e9
}

/// One reading of the shear box.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RawSample {
    /// Horizontal displacement of the box halves in m.
    pub displacement_m: f64,
    /// Reading of the load cell in N, bias and machine friction included.
    pub shear_force_n: f64,
    /// Vertical movement of the cover in m, upward positive; `None` if it was not recorded.
    pub vertical_m: Option<f64>,
}

/// One run: the box is sheared once under one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RawRun {
    run_id: String,
    load_kg: f64,
    samples: Vec<RawSample>,
}

impl RawRun {
    /// Fewer samples than this show no peak.
    pub const MIN_SAMPLES: usize = 3;

    /// A run from its name, load (above 0, at most 1e6 kg) and samples in the order they were taken.
    ///
    /// # Errors
    /// [`DirectShearError::Run`] if the load is out of range, there are fewer than three samples, a reading is not
    /// between -1e9 and 1e9, the displacement goes back or does not advance at all, or only some samples have a vertical reading.
    pub fn new(
        run_id: impl Into<String>,
        load_kg: f64,
        samples: Vec<RawSample>,
    ) -> Result<Self, DirectShearError> {
        let run_id = run_id.into();
        match problem(load_kg, &samples) {
            Some(problem) => Err(DirectShearError::Run { run_id, problem }),
            None => Ok(Self { run_id, load_kg, samples }),
        }
    }

    /// Name of the run.
    #[must_use]
    pub fn run_id(&self) -> &str {
        &self.run_id
    }

    /// Load on the shear plane in kg.
    #[must_use]
    pub const fn load_kg(&self) -> f64 {
        self.load_kg
    }

    /// The samples, displacement never decreasing.
    #[must_use]
    pub fn samples(&self) -> &[RawSample] {
        &self.samples
    }
}

fn problem(load_kg: f64, samples: &[RawSample]) -> Option<String> {
    if !(load_kg.is_finite() && load_kg > 0.0 && load_kg <= 1e6) {
        return Some(format!("load is {load_kg} kg; it must be above 0 and at most 1e6 kg"));
    }
    if samples.len() < RawRun::MIN_SAMPLES {
        return Some(format!("{} samples; at least {} are needed", samples.len(), RawRun::MIN_SAMPLES));
    }
    let finite = |s: &RawSample| {
        [s.displacement_m, s.shear_force_n, s.vertical_m.unwrap_or(0.0)].into_iter().all(reading_ok)
    };
    if !samples.iter().all(finite) {
        return Some("a reading is not between -1e9 and 1e9; remove that sample".to_owned());
    }
    if let Some(pair) = samples.windows(2).find(|pair| pair[1].displacement_m < pair[0].displacement_m) {
        return Some(format!(
            "displacement goes back from {} to {} m; give samples in the order they were taken and each run its \
             own run_id",
            pair[0].displacement_m, pair[1].displacement_m
        ));
    }
    if samples[0].displacement_m == samples[samples.len() - 1].displacement_m {
        return Some("displacement never advances; check the column displacement_mm".to_owned());
    }
    let vertical = samples.iter().filter(|sample| sample.vertical_m.is_some()).count();
    if vertical != 0 && vertical != samples.len() {
        return Some(format!(
            "{vertical} of {} samples have a vertical reading; give all or none",
            samples.len()
        ));
    }
    None
}

/// Reads runs from a CSV file.
///
/// Columns `run_id, load_kg, displacement_mm, shear_force_n` and optionally `vertical_mm` (upward positive; may be
/// empty for a whole run); others are ignored. Rows of a run come in the order they were sampled and carry
/// the same load. Runs come back in the order of their first row.
///
/// # Errors
/// A [`DirectShearError`] with file, line and column for anything wrong in a cell, and those of [`RawRun::new`].
pub fn read_runs(path: impl AsRef<Path>) -> Result<Vec<RawRun>, DirectShearError> {
    from_table(&Table::read(path.as_ref())?)
}

/// The same as [`read_runs`] for the bytes of a table; `name` stands in for the file in messages.
///
/// # Errors
/// As [`read_runs`].
pub fn parse_runs(bytes: &[u8], name: &str) -> Result<Vec<RawRun>, DirectShearError> {
    from_table(&Table::parse(bytes, name)?)
}

fn from_table(table: &Table) -> Result<Vec<RawRun>, DirectShearError> {
    table.refuse_misspelt(&["run_id", "load_kg", "displacement_mm", "shear_force_n", "vertical_mm"])?;
    let id_column = table.require("run_id")?;
    let load_column = table.require("load_kg")?;
    let displacement_column = table.require("displacement_mm")?;
    let force_column = table.require("shear_force_n")?;
    let vertical_column = table.column("vertical_mm");

    let mut runs: Vec<(String, f64, Vec<RawSample>)> = Vec::new();
    for row in &table.rows {
        let id = table.text(row, id_column)?;
        let load = table.number(row, load_column, "a number above 0 and at most 1e6 kg", |load| {
            load > 0.0 && load <= 1e6
        })?;
        let displacement_mm = table.number(row, displacement_column, READING_ALLOWED, reading_ok)?;
        let shear_force_n = table.number(row, force_column, READING_ALLOWED, reading_ok)?;
        let vertical_mm = match vertical_column {
            Some(column) if !table.is_empty(row, column) => {
                Some(table.number(row, column, READING_ALLOWED, reading_ok)?)
            }
            _ => None,
        };
        let sample = RawSample {
            displacement_m: displacement_mm * 1e-3,
            shear_force_n,
            vertical_m: vertical_mm.map(|mm| mm * 1e-3),
        };
        match runs.iter_mut().find(|run| run.0 == id) {
            Some(run) if run.1 == load => run.2.push(sample),
            Some(run) => {
                let allowed = format!("{} kg as in the first row of run `{id}`; one run has one load", run.1);
                return Err(table.cell_error(row, load_column, &allowed));
            }
            None => runs.push((id.to_owned(), load, vec![sample])),
        }
    }
    runs.into_iter().map(|(id, load, samples)| RawRun::new(id, load, samples)).collect()
}
