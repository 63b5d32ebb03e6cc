//! What is told of tables of brackets.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::table::{BracketRow, BracketTable};

/// Name of the tables that `table build --model bounds` makes; the force model shows it as its provenance.
pub(super) const NAME: &str = "limit analysis of the plate";
/// Their source.
pub(super) const SOURCE: &str = "soilctl table build --model bounds: finite-element limit analysis of the embedded \
                                 plate, both bounds proven with interval arithmetic";

/// How wide the brackets of a table are.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Gaps {
    /// Gap at which a case was done.
    pub max_gap: f64,
    /// Most elements that a case was given.
    pub max_elements: usize,
    /// Mean of the gaps.
    pub mean: f64,
    /// The widest gap.
    pub widest: f64,
    /// Where it is: alpha, phi and delta in degrees.
    pub widest_at: [f64; 3],
    /// Cases that ran out of elements before they reached the gap.
    pub over_max_gap: usize,
    /// Brackets that are not proven.
    pub uncertified: usize,
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
}

/// A bracket at a node.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BracketCell {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Friction angle.
    pub phi_deg: f64,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Lower bound on the net coefficient per slant length.
    pub lower: f64,
    /// Upper bound on it.
    pub upper: f64,
    /// `(U - L) / ((U + L) / 2)`.
    pub gap: f64,
    /// Whether both bounds are proven.
    pub certified: bool,
    /// Triangles behind the lower bound.
    pub lower_elements: usize,
    /// Triangles behind the upper bound.
    pub upper_elements: usize,
    /// `solved` or `interpolated`.
    pub status: &'static str,
    /// Lower bound for plates with ends, of every width; null if the table does not know.
    pub ends_lower: Option<f64>,
    /// Upper bound for plates with ends, as the width goes to infinity; null likewise.
    pub ends_upper: Option<f64>,
    /// What a depth over width of one adds to that; null likewise.
    pub ends_term: Option<f64>,
}

impl BracketCell {
    pub(super) fn of(row: &BracketRow) -> Self {
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
            ends_lower: row.ends_lower,
            ends_upper: row.ends_upper,
            ends_term: row.ends_term,
        }
    }
}
