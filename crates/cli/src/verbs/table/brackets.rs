//! Tables of brackets: showing and checking them, and uniting shards.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{BracketRow, BracketTable};

use super::answer::{Head, TableAnswer};
use super::file::{for_brackets, read_brackets, write_brackets};
use crate::error::CliError;
use crate::text::{columns, number};

/// Name of the tables that `table build --model bounds` makes; the force model shows it as its provenance.
pub(super) const NAME: &str = "limit analysis of the plate";
/// Their source.
pub(super) const SOURCE: &str = "soilctl table build --model bounds: finite-element limit analysis of the embedded \
                                 plate, both bounds proven with interval arithmetic";

/// How wide the brackets of a table are.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Gaps {
    /// Gap at which a case was done.
    max_gap: f64,
    /// Most elements that a case was given.
    max_elements: usize,
    /// Mean of the gaps.
    mean: f64,
    /// The widest gap.
    widest: f64,
    /// Where it is: alpha, phi and delta in degrees.
    widest_at: [f64; 3],
    /// Cases that ran out of elements before they reached the gap.
    over_max_gap: usize,
    /// Brackets that are not proven.
    uncertified: usize,
}

impl Gaps {
    /// None for an empty table.
    pub(super) fn of(table: &BracketTable) -> Option<Self> {
        let rows = table.rows();
        let widest = rows.iter().max_by(|a, b| a.gap.total_cmp(&b.gap))?;
        let rules = table.rules();
        Some(Self {
            max_gap: rules.max_gap,
            max_elements: rules.max_elements,
            mean: rows.iter().map(|row| row.gap).sum::<f64>() / rows.len() as f64,
            widest: widest.gap,
            widest_at: widest.node(),
            // The gap of coefficients is a rounding wider than that of the forces.
            over_max_gap: rows.iter().filter(|row| row.gap > rules.max_gap * (1.0 + 1e-9)).count(),
            uncertified: rows.iter().filter(|row| !row.certified).count(),
        })
    }

    pub(super) fn text(&self) -> String {
        format!(
            "gap: mean {} %, widest {} % at {}; above {} %: {} (ran out of {} elements), not proven: {}\n",
            number(100.0 * self.mean),
            number(100.0 * self.widest),
            in_words(self.widest_at),
            number(100.0 * self.max_gap),
            self.over_max_gap,
            self.max_elements,
            self.uncertified,
        )
    }
}

pub(super) fn in_words([alpha, phi, delta]: [f64; 3]) -> String {
    format!("alpha {}, phi {}, delta {}", number(alpha), number(phi), number(delta))
}

/// A bracket at a node.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct BracketCell {
    /// Tool angle.
    alpha_deg: f64,
    /// Friction angle.
    phi_deg: f64,
    /// Interface friction angle.
    delta_deg: f64,
    /// Lower bound on the net coefficient per slant length.
    lower: f64,
    /// Upper bound on it.
    upper: f64,
    /// `(U - L) / ((U + L) / 2)`.
    gap: f64,
    /// Whether both bounds are proven.
    certified: bool,
    /// Triangles behind the lower bound.
    lower_elements: usize,
    /// Triangles behind the upper bound.
    upper_elements: usize,
    /// `solved` or `interpolated`.
    status: &'static str,
}

impl BracketCell {
    fn of(row: &BracketRow) -> Self {
        Self {
            alpha_deg: row.alpha_deg,
            phi_deg: row.phi_deg,
            delta_deg: row.delta_deg,
            lower: row.lower,
            upper: row.upper,
            gap: row.gap,
            certified: row.certified,
            lower_elements: row.lower_elements,
            upper_elements: row.upper_elements,
            status: row.status.word(),
        }
    }
}

pub(super) fn show(table: &BracketTable) -> TableAnswer {
    let cells = table.rows().iter().map(BracketCell::of).collect();
    TableAnswer::ShowBrackets { table: Head::of_brackets(table), gaps: Gaps::of(table), cells }
}

pub(super) fn show_text(cells: &[BracketCell]) -> String {
    let header = ["alpha", "phi", "delta", "lower", "upper", "gap %"].map(str::to_owned).to_vec();
    let rows = cells.iter().map(|cell| {
        [cell.alpha_deg, cell.phi_deg, cell.delta_deg, cell.lower, cell.upper, 100.0 * cell.gap]
            .map(number)
            .to_vec()
    });
    let rows: Vec<_> = std::iter::once(header).chain(rows).collect();
    format!("bounds on k_net per slant length\n{}", columns(&rows))
}

/// Unites the files of shards.
pub(super) fn merge(files: &[PathBuf], out: &Path) -> Result<TableAnswer, CliError> {
    for_brackets(out)?;
    let (mut rows, mut first) = (Vec::new(), None);
    for path in files {
        let (table, version) = read_brackets(path)?;
        rows.extend_from_slice(table.rows());
        let made = (table.rules(), version);
        let (expected, whence) = first.get_or_insert_with(|| (made.clone(), path));
        if made != *expected {
            let words = |(rules, version): &(soilctl_earth_pressure::table::BracketRules, String)| {
                format!(
                    "soilctl {version} with --max-gap {} --max-elements {}",
                    rules.max_gap, rules.max_elements
                )
            };
            return Err(CliError::Usage(format!(
                "{} was built by {}, but {} by {}; a table keeps to one rule, so build them alike",
                path.display(),
                words(&made),
                whence.display(),
                words(expected)
            )));
        }
    }
    let Some(((rules, version), _)) = first else {
        return Err(CliError::Usage("no file to merge was given".into()));
    };
    if version != env!("CARGO_PKG_VERSION") {
        return Err(CliError::Usage(format!(
            "the files were built by soilctl {version}; merge them with that version, this is {}",
            env!("CARGO_PKG_VERSION")
        )));
    }
    let table = BracketTable::new(NAME, rules, rows)?;
    write_brackets(&table, SOURCE, out)?;
    let file = out.display().to_string();
    Ok(TableAnswer::Merge { table: Head::of_brackets(&table), gaps: Gaps::of(&table), file })
}
