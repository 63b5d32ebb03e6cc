//! The bounds that `docs/verification.md` shows: kept in a file, from which the page's table is made. A run compares what it finds with
//! the file; with `SOILCTL_ROWS=write` it writes it (`cargo xtask rows`).

use std::path::PathBuf;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};
use soilctl_limit_analysis::Bounds;

/// Tests of this program run side by side.
static FILE: Mutex<()> = Mutex::new(());
/// Elements up to which the ordinary tests go.
const ORDINARY: usize = 1200;
/// Significant digits that are kept.
const DIGITS: i32 = 6;

/// A problem with a known answer, and what was proven of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Row {
    problem: String,
    /// Elements of the upper bound's mesh: a problem may be there with several.
    elements: usize,
    /// The interval in which the exact value is known to lie.
    known: [f64; 2],
    lower: f64,
    upper: f64,
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/verification/exact.json")
}

fn rounded(value: f64) -> f64 {
    let unit = 10_f64.powi(DIGITS - 1 - value.abs().log10().floor() as i32);
    (value * unit).round() / unit
}

/// Whether two numbers differ by no more than the rounding of both.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1.1 * 10_f64.powi(1 - DIGITS) * a.abs().max(b.abs())
}

/// Compares the bounds with their row in the file, or writes it.
#[track_caller]
pub(crate) fn row(problem: &str, bounds: &Bounds, known: [f64; 2]) {
    let found = Row {
        problem: problem.to_owned(),
        elements: bounds.upper.elements,
        known: known.map(rounded),
        lower: rounded(bounds.lower.value),
        upper: rounded(bounds.upper.value),
    };
    let _guard = FILE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let text = std::fs::read_to_string(path()).unwrap_or_else(|_| "[]".to_owned());
    let mut rows: Vec<Row> = serde_json::from_str(&text).unwrap();
    let is_it = |row: &Row| row.problem == found.problem && row.elements == found.elements;
    if std::env::var_os("SOILCTL_ROWS").is_some_and(|value| value == "write") {
        rows.retain(|row| !is_it(row));
        rows.push(found);
        rows.sort_by(|a, b| (&a.problem, a.elements).cmp(&(&b.problem, b.elements)));
        std::fs::write(path(), serde_json::to_string_pretty(&rows).unwrap() + "\n").unwrap();
        return;
    }
    let advice = "if that is an improvement, `cargo xtask rows` writes docs/verification anew";
    let Some(kept) = rows.iter().find(|row| is_it(row)) else {
        if found.elements > ORDINARY {
            // What takes minutes is compared if it is there.
            return;
        }
        panic!("docs/verification/exact.json does not have {found:?}; {advice}")
    };
    let agree = same(kept.lower, found.lower) && same(kept.upper, found.upper);
    let known = kept.known.iter().zip(found.known).all(|(a, b)| same(*a, b));
    assert!(agree && known, "{found:?}, but docs/verification/exact.json has {kept:?}; {advice}");
}
