//! Tables of proven brackets: a lower and an upper bound at every node.

use serde::{Deserialize, Serialize};

use super::cells::{SAME_NODE_DEG, in_words};
use super::{Cell, CellStatus, PredictionTable, Quantity};
use crate::EarthPressureError;

/// Bounds at one node, and how they came about: one row of a bracket file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BracketRow {
    /// Tool angle.
    pub alpha_deg: f64,
    /// Friction angle of the soil.
    pub phi_deg: f64,
    /// Interface friction angle.
    pub delta_deg: f64,
    /// Lower bound on the net coefficient per slant length.
    pub lower: f64,
    /// Upper bound on it.
    pub upper: f64,
    /// `(upper - lower) / ((upper + lower) / 2)`.
    pub gap: f64,
    /// Whether interval arithmetic proves both.
    pub certified: bool,
    /// Triangles behind the lower bound.
    pub lower_elements: usize,
    /// Triangles behind the upper bound.
    pub upper_elements: usize,
    /// How the bounds came about.
    pub status: CellStatus,
    /// Lower bound for plates with ends, of every width.
    #[serde(default)]
    pub ends_lower: Option<f64>,
    /// Upper bound for plates with ends, as the width goes to infinity.
    #[serde(default)]
    pub ends_upper: Option<f64>,
    /// What a depth over width of one adds to it.
    #[serde(default)]
    pub ends_term: Option<f64>,
}

impl BracketRow {
    /// Tool angle, friction angle and interface friction angle in degrees.
    #[must_use]
    pub const fn node(&self) -> [f64; 3] {
        [self.alpha_deg, self.phi_deg, self.delta_deg]
    }

    /// Distance of two bounds over their mean.
    #[must_use]
    pub fn relative_gap(lower: f64, upper: f64) -> f64 {
        2.0 * (upper - lower) / (upper + lower)
    }

    /// What is wrong with the numbers of a row that was read.
    pub(super) fn problem(&self) -> Option<String> {
        for (name, angle) in
            [("alpha_deg", self.alpha_deg), ("phi_deg", self.phi_deg), ("delta_deg", self.delta_deg)]
        {
            if !angle.is_finite() {
                return Some(format!("{name} is {angle}; it must be a finite number of degrees"));
            }
        }
        for (name, bound) in [("lower", self.lower), ("upper", self.upper)] {
            if !(bound > 0.0 && bound.is_finite()) {
                return Some(format!("{name} is {bound}; it must be a finite number above 0"));
            }
        }
        let ends = [self.ends_lower, self.ends_upper, self.ends_term];
        for (name, number) in ["ends_lower", "ends_upper", "ends_term"].into_iter().zip(ends) {
            if let Some(number) = number.filter(|n| !(*n > 0.0 && n.is_finite())) {
                return Some(format!("{name} is {number}; it must be a finite number above 0, or left out"));
            }
        }
        if ends.iter().any(Option::is_some) && ends.iter().any(Option::is_none) {
            return Some("ends_lower, ends_upper and ends_term go together: give all or none".into());
        }
        let gap = Self::relative_gap(self.lower, self.upper);
        // Written with every digit, so only an edit can part them.
        let same = (self.gap - gap).abs() <= 1e-9;
        (!same)
            .then(|| format!("gap is {}, but lower and upper are {gap} apart; the row was edited", self.gap))
    }
}

/// The rules by which every case of a bracket table was stopped.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct BracketRules {
    /// Relative gap at which a case was done.
    pub max_gap: f64,
    /// Most elements that a case was given.
    pub max_elements: usize,
}

/// Lower and upper bounds on the nodes of a grid, in the order of alpha, phi and delta.
#[derive(Debug, Clone, PartialEq)]
pub struct BracketTable {
    name: String,
    rules: BracketRules,
    rows: Vec<BracketRow>,
}

impl BracketTable {
    /// A table from rows in any order. A row may stand in it more than once if it says the same each time.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if a number is not what it can be, or two rows contradict each other.
    pub fn new(
        name: impl Into<String>,
        rules: BracketRules,
        mut rows: Vec<BracketRow>,
    ) -> Result<Self, EarthPressureError> {
        let name = name.into();
        if let Some((node, problem)) = rows.iter().find_map(|row| Some((row.node(), row.problem()?))) {
            let problem = format!("{problem}, at {}", in_words(node));
            return Err(EarthPressureError::BadTable { table: name, problem });
        }
        rows.sort_by(|a, b| {
            let pairs = a.node().into_iter().zip(b.node());
            pairs
                .map(|(x, y)| x.total_cmp(&y))
                .find(|order| order.is_ne())
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        rows.dedup();
        let same = |pair: &&[BracketRow]| {
            pair[0].node().into_iter().zip(pair[1].node()).all(|(x, y)| (x - y).abs() < SAME_NODE_DEG)
        };
        if let Some(pair) = rows.windows(2).find(same) {
            let problem = format!(
                "{} has two brackets, {} to {} and {} to {}; keep one of the two",
                in_words(pair[0].node()),
                pair[0].lower,
                pair[0].upper,
                pair[1].lower,
                pair[1].upper
            );
            return Err(EarthPressureError::BadTable { table: name, problem });
        }
        Ok(Self { name, rules, rows })
    }

    /// Name, for messages and provenance.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The rules by which every case was stopped.
    #[must_use]
    pub const fn rules(&self) -> BracketRules {
        self.rules
    }

    /// All rows, in order.
    #[must_use]
    pub fn rows(&self) -> &[BracketRow] {
        &self.rows
    }

    /// What is known of plates with ends: lower bounds, upper bounds of wide plates, and end terms, as tables of their own; none
    /// unless every row has them.
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if a lower bound is above its upper bound, or as [`PredictionTable::new`].
    pub fn ends(&self) -> Result<Option<[PredictionTable; 3]>, EarthPressureError> {
        if self.rows.iter().any(|row| row.ends_term.is_none()) {
            return Ok(None);
        }
        self.in_order(|row| Some([row.ends_lower?, row.ends_upper?]))?;
        Ok(Some([
            self.of(Quantity::LowerBound, "lower bound with ends", |row| row.ends_lower)?,
            self.of(Quantity::UpperBound, "upper bound with ends", |row| row.ends_upper)?,
            self.of(Quantity::UpperBound, "end term", |row| row.ends_term)?,
        ]))
    }

    /// Refuses a row whose lower bound is above its upper one.
    fn in_order(&self, pick: fn(&BracketRow) -> Option<[f64; 2]>) -> Result<(), EarthPressureError> {
        let crossed = self.rows.iter().find_map(|row| {
            let [lower, upper] = pick(row)?;
            (lower > upper).then(|| (in_words(row.node()), lower, upper))
        });
        match crossed {
            None => Ok(()),
            Some((node, lower, upper)) => Err(EarthPressureError::BadTable {
                table: self.name.clone(),
                problem: format!("at {node} the lower bound {lower} is above the upper bound {upper}"),
            }),
        }
    }

    fn of(
        &self,
        quantity: Quantity,
        words: &str,
        pick: fn(&BracketRow) -> Option<f64>,
    ) -> Result<PredictionTable, EarthPressureError> {
        let name = format!("{}, {words}", self.name);
        let cell = |row: &BracketRow| Some((row.node(), Cell { k_net: pick(row)?, status: row.status }));
        let cells: Vec<_> = self.rows.iter().filter_map(cell).collect();
        PredictionTable::from_cells(&name, quantity, &cells, |_| name.clone())
    }

    /// The lower and the upper bounds as tables of their own, for a [`super::BracketModel`].
    ///
    /// # Errors
    /// [`EarthPressureError::BadTable`] if a lower bound is above its upper bound, or as
    /// [`PredictionTable::new`].
    pub fn split(&self) -> Result<(PredictionTable, PredictionTable), EarthPressureError> {
        self.in_order(|row| Some([row.lower, row.upper]))?;
        Ok((
            self.of(Quantity::LowerBound, "lower bound", |row| Some(row.lower))?,
            self.of(Quantity::UpperBound, "upper bound", |row| Some(row.upper))?,
        ))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    pub(crate) fn row(node: [f64; 3], lower: f64, upper: f64) -> BracketRow {
        let [alpha_deg, phi_deg, delta_deg] = node;
        let gap = BracketRow::relative_gap(lower, upper);
        let (certified, status) = (true, CellStatus::Solved);
        BracketRow {
            alpha_deg,
            phi_deg,
            delta_deg,
            lower,
            upper,
            gap,
            certified,
            lower_elements: 600,
            upper_elements: 700,
            status,
            ends_lower: None,
            ends_upper: None,
            ends_term: None,
        }
    }

    pub(crate) const RULES: BracketRules = BracketRules { max_gap: 0.05, max_elements: 1500 };

    pub(crate) fn square() -> Vec<BracketRow> {
        let mut rows = Vec::new();
        for (i, alpha) in [80.0, 90.0].into_iter().enumerate() {
            for (j, phi) in [30.0, 40.0].into_iter().enumerate() {
                for (k, delta) in [0.0, 10.0].into_iter().enumerate() {
                    let lower = 2.0 + i as f64 + 2.0 * j as f64 + k as f64 / 3.0;
                    rows.push(row([alpha, phi, delta], lower, 1.02 * lower));
                }
            }
        }
        rows
    }

    #[test]
    fn rows_are_put_in_order_and_said_twice_is_said_once() {
        let whole = BracketTable::new("t", RULES, square()).unwrap();
        let mut mixed = square();
        mixed.reverse();
        mixed.extend_from_slice(&square()[2..5]);
        assert_eq!(BracketTable::new("t", RULES, mixed).unwrap(), whole);
        assert_eq!(whole.rows(), square());
    }

    #[test]
    fn contradictions_are_refused() {
        let mut rows = square();
        rows.push(row([90.0, 30.0, 10.0], 3.0, 3.1));
        let message = BracketTable::new("t", RULES, rows).unwrap_err().to_string();
        assert!(message.contains("alpha 90 deg, phi 30 deg, delta 10 deg has two brackets"), "{message}");

        let mut rows = square();
        rows[1].lower = f64::NAN;
        let message = BracketTable::new("t", RULES, rows).unwrap_err().to_string();
        assert!(message.contains("lower is NaN") && message.contains("delta 10 deg"), "{message}");

        let mut rows = square();
        rows[3] = row(rows[3].node(), 5.0, 4.9);
        let message = BracketTable::new("t", RULES, rows).unwrap().split().unwrap_err().to_string();
        assert!(message.contains("the lower bound 5 is above the upper bound 4.9"), "{message}");
    }

    #[test]
    fn both_halves_hold_their_bounds() {
        let (lower, upper) = BracketTable::new("t", RULES, square()).unwrap().split().unwrap();
        assert_eq!((lower.quantity(), upper.quantity()), (Quantity::LowerBound, Quantity::UpperBound));
        for ((node, low), row) in lower.filled().zip(square()) {
            assert_eq!((node, low.k_net), (row.node(), row.lower));
        }
        assert!(upper.filled().zip(square()).all(|((_, high), row)| high.k_net == row.upper));
    }
}
