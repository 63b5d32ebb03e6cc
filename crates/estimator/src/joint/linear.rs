//! Least values of linear functions on polytopes, proven.
//!
//! A polytope is what rows `a x <= b` leave of the box `0 <= x <= 1`. For any multipliers `y >= 0` of the rows,
//!
//! ```text
//! min c x  >=  -y b + sum over j of min(0, c_j + sum over i of y_i a_ij)
//! ```
//!
//! because the box bounds what is left of each coordinate (Neumaier & Shcherbina 2004, Safe bounds in linear and mixed-integer linear
//! programming, *Mathematical Programming* 99). The dual simplex method finds good multipliers; whatever it does, and wherever it is broken off, the
//! bound holds. That nothing is left is proven the same way, with `c = 0` and a bound above 0 (Farkas).

/// Most coordinates.
pub(super) const MOST_DIMENSIONS: usize = 7;
/// What counts as feasible, of rows whose largest coefficient is 1.
const FEASIBLE: f64 = 1e-10;
/// Pivots after which the search is broken off; a bound that is not the best one costs width, never a soil.
const MOST_PIVOTS: usize = 80;
/// Rounding of a bound relative to the sum of what it is made of.
const ROUNDING: f64 = 1e-13;

/// A point, or the coefficients of a row.
pub(super) type Coefficients = [f64; MOST_DIMENSIONS];

/// Rows `a x <= b` on the unit box.
pub(super) struct Polytope {
    dimensions: usize,
    rows: Vec<(Coefficients, f64)>,
}

impl Polytope {
    /// The unit box.
    pub(super) const fn new(dimensions: usize) -> Self {
        Self { dimensions, rows: Vec::new() }
    }

    /// Adds a row `a x <= b`, unless the box obeys it anyhow.
    pub(super) fn push(&mut self, a: Coefficients, b: f64) {
        let most: f64 = a.iter().map(|a| a.max(0.0)).sum();
        let size = a.iter().fold(0.0_f64, |size, a| size.max(a.abs()));
        if most <= b {
            return;
        }
        // A row without coefficients that is not obeyed leaves nothing.
        let scale = if size > 0.0 { 1.0 / size } else { 1.0 / b.abs() };
        self.rows.push((a.map(|a| a * scale), b * scale));
    }

    /// A lower bound on a linear function; `None` if the polytope is proven to be empty.
    pub(super) fn least(&self, objective: &Coefficients) -> Option<f64> {
        let mut tableau = Tableau::new(self, objective);
        for _ in 0..MOST_PIVOTS {
            let Some(row) = tableau.violated() else { break };
            let Some(column) = tableau.entering(row) else {
                let ray = self.bound(&tableau.ray(row), &[0.0; MOST_DIMENSIONS]);
                if ray > 0.0 {
                    return None;
                }
                break;
            };
            tableau.pivot(row, column);
        }
        Some(self.bound(&tableau.multipliers(), objective))
    }

    /// The bound that multipliers prove, rounded downwards.
    fn bound(&self, multipliers: &[f64], objective: &Coefficients) -> f64 {
        let mut left = *objective;
        let (mut value, mut size) = (0.0, objective.iter().map(|c| c.abs()).sum::<f64>());
        for (y, (a, b)) in multipliers.iter().zip(&self.rows) {
            if *y > 0.0 {
                for (left, a) in left.iter_mut().zip(a) {
                    *left += y * a;
                }
                value -= y * b;
                // Coefficients are at most 1.
                size += y * (b.abs() + self.dimensions as f64);
            }
        }
        value + left.iter().map(|x| x.min(0.0)).sum::<f64>() - ROUNDING * size
    }
}

/// What a basic or nonbasic variable is: a coordinate, or the slack of a row.
#[derive(Clone, Copy, PartialEq)]
enum Variable {
    Coordinate,
    Slack(usize),
}

/// One row of the tableau: `basic + sum of coefficients times nonbasic = value`, all nonbasic variables at 0.
struct Row {
    basic: Variable,
    coefficients: Coefficients,
    value: f64,
}

/// The dual simplex method with bounds: a coordinate at its upper end 1 is replaced by 1 less itself.
struct Tableau {
    dimensions: usize,
    count: usize,
    rows: Vec<Row>,
    nonbasic: [Variable; MOST_DIMENSIONS],
    /// Reduced costs, never below 0.
    costs: Coefficients,
}

impl Tableau {
    fn new(polytope: &Polytope, objective: &Coefficients) -> Self {
        let dimensions = polytope.dimensions;
        let at_upper_end = objective.map(|c| c < 0.0);
        let row = |(place, (a, b)): (usize, &(Coefficients, f64))| {
            let (mut coefficients, mut value) = (*a, *b);
            for (a, &flipped) in coefficients.iter_mut().zip(&at_upper_end) {
                if flipped {
                    value -= *a;
                    *a = -*a;
                }
            }
            Row { basic: Variable::Slack(place), coefficients, value }
        };
        Self {
            dimensions,
            count: polytope.rows.len(),
            rows: polytope.rows.iter().enumerate().map(row).collect(),
            nonbasic: [Variable::Coordinate; MOST_DIMENSIONS],
            costs: objective.map(f64::abs),
        }
    }

    /// The row whose basic variable is farthest outside of its bounds, turned so that it is below 0.
    fn violated(&mut self) -> Option<usize> {
        let (mut worst, mut found) = (FEASIBLE, None);
        for (place, row) in self.rows.iter().enumerate() {
            let above = if row.basic == Variable::Coordinate { row.value - 1.0 } else { 0.0 };
            let by = (-row.value).max(above);
            if by > worst {
                (worst, found) = (by, Some(place));
            }
        }
        let row = self.rows.get_mut(found?)?;
        if row.value > 0.0 {
            row.coefficients = row.coefficients.map(|a| -a);
            row.value = 1.0 - row.value;
        }
        found
    }

    /// The column that may enter for a row, of least ratio.
    fn entering(&self, row: usize) -> Option<usize> {
        let coefficients = self.rows.get(row)?.coefficients;
        let (mut least, mut found) = (f64::INFINITY, None);
        for (column, (a, cost)) in coefficients.iter().zip(&self.costs).enumerate().take(self.dimensions) {
            let ratio = cost / -a;
            if *a < -FEASIBLE && ratio < least {
                (least, found) = (ratio, Some(column));
            }
        }
        found
    }

    fn pivot(&mut self, row: usize, column: usize) {
        let Some(leaving) = self.rows.get_mut(row) else { return };
        let by = 1.0 / leaving.coefficients[column];
        leaving.coefficients[column] = 1.0;
        leaving.coefficients = leaving.coefficients.map(|a| a * by);
        leaving.value *= by;
        let (pivot, value) = (leaving.coefficients, leaving.value);
        std::mem::swap(&mut leaving.basic, &mut self.nonbasic[column]);
        for (place, other) in self.rows.iter_mut().enumerate() {
            let factor = other.coefficients[column];
            if place != row && factor != 0.0 {
                other.coefficients[column] = 0.0;
                for (a, p) in other.coefficients.iter_mut().zip(&pivot) {
                    *a -= factor * p;
                }
                other.value -= factor * value;
            }
        }
        let factor = self.costs[column];
        self.costs[column] = 0.0;
        for (cost, p) in self.costs.iter_mut().zip(&pivot) {
            *cost = (*cost - factor * p).max(0.0);
        }
    }

    /// Multipliers of the rows by the reduced costs of their slacks.
    fn multipliers(&self) -> Vec<f64> {
        self.of_slacks(&self.costs)
    }

    /// Multipliers that prove that a row cannot be obeyed.
    fn ray(&self, row: usize) -> Vec<f64> {
        let Some(row) = self.rows.get(row) else { return vec![0.0; self.count] };
        let mut found = self.of_slacks(&row.coefficients);
        if let Variable::Slack(place) = row.basic
            && let Some(multiplier) = found.get_mut(place)
        {
            *multiplier = 1.0;
        }
        found
    }

    fn of_slacks(&self, columns: &Coefficients) -> Vec<f64> {
        let mut found = vec![0.0; self.count];
        for (variable, value) in self.nonbasic.iter().zip(columns) {
            if let Variable::Slack(place) = *variable
                && let Some(multiplier) = found.get_mut(place)
            {
                *multiplier = value.max(0.0);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polytope(dimensions: usize, rows: &[(Vec<f64>, f64)]) -> Polytope {
        let mut found = Polytope::new(dimensions);
        for (a, b) in rows {
            let mut coefficients = [0.0; MOST_DIMENSIONS];
            coefficients[..dimensions].copy_from_slice(a);
            found.push(coefficients, *b);
        }
        found
    }

    fn objective(c: &[f64]) -> Coefficients {
        let mut found = [0.0; MOST_DIMENSIONS];
        found[..c.len()].copy_from_slice(c);
        found
    }

    #[test]
    fn a_corner_cut_off_a_square() {
        let square = polytope(2, &[(vec![-1.0, -1.0], -0.5), (vec![2.0, 2.0], 3.0)]);
        assert!((square.least(&objective(&[1.0, 1.0])).unwrap() - 0.5).abs() < 1e-9);
        assert!((square.least(&objective(&[-1.0, -1.0])).unwrap() + 1.5).abs() < 1e-9);
        assert!((square.least(&objective(&[-2.0, -1.0])).unwrap() + 2.5).abs() < 1e-9);
        assert!(square.least(&objective(&[1.0, 0.0])).unwrap().abs() < 1e-9);
    }

    #[test]
    fn rows_that_contradict_each_other_leave_nothing() {
        let none = polytope(2, &[(vec![1.0, 1.0], 0.5), (vec![-1.0, -1.0], -0.6)]);
        assert_eq!(none.least(&objective(&[1.0, -3.0])), None);
        assert_eq!(polytope(1, &[(vec![0.0], -1.0)]).least(&objective(&[0.0])), None);
    }

    /// Every vertex of a polytope, by all choices of as many rows or faces of the box as there are dimensions.
    fn by_vertices(dimensions: usize, rows: &[(Vec<f64>, f64)], c: &[f64]) -> Option<f64> {
        let mut all = rows.to_vec();
        for j in 0..dimensions {
            let unit =
                |sign: f64| (0..dimensions).map(|k| if k == j { sign } else { 0.0 }).collect::<Vec<_>>();
            all.push((unit(1.0), 1.0));
            all.push((unit(-1.0), 0.0));
        }
        let mut best: Option<f64> = None;
        let mut chosen: Vec<usize> = (0..dimensions).collect();
        loop {
            let a = nalgebra::DMatrix::from_fn(dimensions, dimensions, |i, j| all[chosen[i]].0[j]);
            let b = nalgebra::DVector::from_fn(dimensions, |i, _| all[chosen[i]].1);
            if let Some(x) = a.lu().solve(&b)
                && x.iter().all(|x| x.is_finite())
                && all
                    .iter()
                    .all(|(a, b)| a.iter().zip(x.iter()).map(|(a, x)| a * x).sum::<f64>() <= b + 1e-9)
            {
                let value: f64 = c.iter().zip(x.iter()).map(|(c, x)| c * x).sum();
                best = Some(best.map_or(value, |best| best.min(value)));
            }
            let Some(i) = (0..dimensions).rev().find(|&i| chosen[i] < all.len() - dimensions + i) else {
                return best;
            };
            chosen[i] += 1;
            for k in i + 1..dimensions {
                chosen[k] = chosen[k - 1] + 1;
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// The bound is the least value at a vertex, and never above it.
        #[test]
        fn the_bound_is_the_least_vertex(
            rows in proptest::collection::vec((proptest::collection::vec(-1.0..1.0, 4), -0.6..1.0), 1..7),
            c in proptest::collection::vec(-1.0..1.0, 4),
        ) {
            let exact = by_vertices(4, &rows, &c);
            match (polytope(4, &rows).least(&objective(&c)), exact) {
                (Some(bound), Some(exact)) => {
                    prop_assert!(bound <= exact + 1e-9, "{bound} {exact}");
                    prop_assert!(bound >= exact - 1e-7, "{bound} {exact}");
                }
                (None, exact) => prop_assert!(exact.is_none(), "{exact:?}"),
                (Some(_), None) => {}
            }
        }
    }
}
