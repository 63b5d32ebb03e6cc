//! Numbers that obey linear equations exactly, near numbers that nearly do.
//!
//! Let `B x = g` be the equations, with rows scaled to the length 1. If the least singular value of `B` is `s > 0`,
//! there is an exact solution no farther from any `x` than `|g - B x|/s`. The residual is enclosed in intervals.
//! Coefficients are known as intervals, too: `B = M + E`, where `M` has doubles, and
//!
//! ```text
//! s  >=  sqrt(least eigenvalue of M M')  -  |E|
//! ```
//!
//! with the Frobenius norm of `E`. That `M M' - l` has no negative eigenvalue but for a known rounding error is
//! proven by [factors](super::cholesky) of it: with `A` what floating point makes of it, `|A - (M M' - l)| <= g (|M|
//! |M'| + l)`, where `g` is as there, with the most numbers that are ever added up.
//!
//! `x` is first improved by the same factors. So fields need not be balanced better than what can be written down.

use super::cholesky::{Columns, Factor, Layout, gamma, greatest};
use super::dissection::dissect;
use crate::CertificateError;
use crate::interval::Interval;

/// Equations.
#[derive(Debug)]
pub(super) struct System {
    pub(super) rows: Vec<Row>,
    /// For each group of rows, where it is: only for speed.
    pub(super) places: Vec<[f64; 3]>,
    pub(super) columns: usize,
    /// What is balanced, in messages.
    pub(super) of: &'static str,
}

/// `sum of factor x_number = right`.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) group: usize,
    pub(super) entries: Vec<(usize, Interval)>,
    pub(super) right: Interval,
}

/// The doubles of a system.
struct Middle {
    /// For each row, in the order of elimination.
    rows: Vec<Vec<(usize, f64)>>,
    /// Not less than the Frobenius norm of what the coefficients are off.
    off: f64,
}

/// Steps by which the numbers are improved.
const STEPS: usize = 4;

/// Steps of the inverse iteration, from which the least eigenvalue is guessed.
const GUESSES: usize = 12;

impl System {
    fn not_proven(&self, quantity: &'static str) -> CertificateError {
        CertificateError::NotProven { quantity, place: self.of.to_owned(), low: -1.0, unit: "" }
    }

    /// Enclosures of numbers that obey all equations, near a guess of them.
    pub(super) fn solve(mut self, guess: &[f64]) -> Result<Vec<Interval>, CertificateError> {
        let quantity = "rank of the balances, less their number,";
        if self.rows.is_empty() {
            return Ok(guess.iter().map(|&x| x.into()).collect());
        }
        self.scale()?;
        let (neighbours, rows) = self.groups();
        let parts = dissect(&self.places, &neighbours);
        let Some(layout) = Layout::new(&parts, &neighbours, &rows) else {
            let place = format!("{} balances", self.rows.len());
            return Err(CertificateError::NotCovered { place, what: "they are connected too much" });
        };
        let middle = self.middle(&layout);
        let matrix = middle.square(self.columns);
        let Some(factor) = layout.factor(&matrix, 0.0) else {
            return Err(self.not_proven(quantity));
        };
        let mut numbers = guess.to_vec();
        let mut residual = self.residual(&numbers);
        for _ in 0..STEPS {
            let better = self.improved(&numbers, &residual, &middle, &layout, &factor);
            let next = self.residual(&better);
            if norm(&next).hi() >= norm(&residual).hi() || better.iter().any(|x| !x.is_finite()) {
                break;
            }
            (numbers, residual) = (better, next);
        }
        let mut shift = 0.5 * least(&factor, layout.place.len());
        drop(factor);
        for _ in 0..4 {
            let singular = middle.least_singular_value(&layout, &matrix, shift, self.columns);
            if singular > 0.0 {
                let radius = (norm(&residual) / Interval::point(singular)).hi();
                return Ok(numbers
                    .iter()
                    .map(|&x| Interval::point(x) + Interval::new(-radius, radius))
                    .collect());
            }
            shift *= 0.25;
        }
        Err(self.not_proven(quantity))
    }

    /// Scales each row to the length 1, about.
    fn scale(&mut self) -> Result<(), CertificateError> {
        let length =
            |row: &Row| row.entries.iter().map(|(_, factor)| factor.middle().powi(2)).sum::<f64>().sqrt();
        // Also if one is infinite or not a number.
        if !self.rows.iter().all(|row| (f64::MIN_POSITIVE..f64::MAX).contains(&length(row))) {
            return Err(self.not_proven("number of free tractions in a balance, less one,"));
        }
        for row in &mut self.rows {
            let scale = Interval::point(1.0 / length(row));
            row.entries.iter_mut().for_each(|(_, factor)| *factor = *factor * scale);
            row.right = row.right * scale;
        }
        Ok(())
    }

    /// For each group the groups with which it has numbers in common, and its rows.
    fn groups(&self) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
        let mut rows = vec![Vec::new(); self.places.len()];
        let mut of_columns = vec![Vec::new(); self.columns];
        for (i, row) in self.rows.iter().enumerate() {
            rows[row.group].push(i);
            row.entries.iter().for_each(|(number, _)| of_columns[*number].push(row.group));
        }
        let mut neighbours = vec![Vec::new(); self.places.len()];
        for groups in &mut of_columns {
            groups.dedup();
            for &a in groups.iter() {
                neighbours[a].extend(groups.iter().filter(|&&b| b != a));
            }
        }
        neighbours.iter_mut().for_each(|list| {
            list.sort_unstable();
            list.dedup();
        });
        (neighbours, rows)
    }

    fn middle(&self, layout: &Layout) -> Middle {
        let mut rows = vec![Vec::new(); self.rows.len()];
        let mut off = Interval::ZERO;
        for (i, row) in self.rows.iter().enumerate() {
            for (number, factor) in &row.entries {
                let middle = factor.middle();
                off = off + (*factor - Interval::point(middle)).square();
                rows[layout.place[i]].push((*number, middle));
            }
        }
        Middle { rows, off: off.sqrt().hi() }
    }

    fn residual(&self, numbers: &[f64]) -> Vec<Interval> {
        let left = |row: &Row| {
            row.entries
                .iter()
                .fold(row.right, |sum, (number, factor)| sum - *factor * Interval::point(numbers[*number]))
        };
        self.rows.iter().map(left).collect()
    }

    fn improved(
        &self,
        numbers: &[f64],
        residual: &[Interval],
        middle: &Middle,
        layout: &Layout,
        factor: &Factor,
    ) -> Vec<f64> {
        let mut forces = vec![0.0; residual.len()];
        residual.iter().zip(&layout.place).for_each(|(r, &place)| forces[place] = r.middle());
        factor.solve(&mut forces);
        let mut better = numbers.to_vec();
        for (row, force) in middle.rows.iter().zip(forces) {
            row.iter().for_each(|&(number, value)| better[number] += value * force);
        }
        better
    }
}

/// Euclid's norm.
fn norm(vector: &[Interval]) -> Interval {
    vector.iter().fold(Interval::ZERO, |sum, x| sum + x.square()).sqrt()
}

/// A guess of the least eigenvalue, by inverse iteration.
fn least(factor: &Factor, count: usize) -> f64 {
    let mut vector: Vec<f64> = (0..count).map(|i| 1.0 + (i % 7) as f64).collect();
    let mut growth = 1.0;
    for _ in 0..GUESSES {
        let before = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        vector.iter_mut().for_each(|x| *x /= before);
        factor.solve(&mut vector);
        growth = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
    }
    1.0 / growth
}

impl Middle {
    /// The rows of each column, with values.
    fn columns(&self, count: usize) -> Vec<Vec<(usize, f64)>> {
        let mut columns = vec![Vec::new(); count];
        for (i, row) in self.rows.iter().enumerate() {
            row.iter().for_each(|&(number, value)| columns[number].push((i, value)));
        }
        columns
    }

    /// `M M'`, rounded.
    fn square(&self, count: usize) -> Columns {
        let columns = self.columns(count);
        let mut sums = vec![0.0; self.rows.len()];
        let mut square = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let mut met = Vec::new();
            for &(number, value) in row {
                for &(j, other) in columns[number].iter().filter(|(j, _)| *j >= i) {
                    sums[j] += value * other;
                    met.push(j);
                }
            }
            met.sort_unstable();
            met.dedup();
            square.push(met.iter().map(|&j| (j, sums[j])).collect());
            met.iter().for_each(|&j| sums[j] = 0.0);
        }
        square
    }

    /// A lower bound of the least singular value of the equations, not positive if there is none.
    fn least_singular_value(&self, layout: &Layout, matrix: &Columns, shift: f64, count: usize) -> f64 {
        if !(shift > 0.0 && shift.is_finite()) {
            return 0.0;
        }
        let Some(factor) = layout.factor(matrix, shift) else {
            return 0.0;
        };
        // The greatest sum of a row of |M| |M'|, and the most products in a sum.
        let columns = self.columns(count);
        let of_columns: Vec<f64> =
            columns.iter().map(|column| column.iter().map(|(_, value)| value.abs()).sum()).collect();
        let of_rows: Vec<f64> = self
            .rows
            .iter()
            .map(|row| row.iter().map(|&(number, value)| value.abs() * of_columns[number]).sum())
            .collect();
        let longest = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let rounded = gamma(longest as f64 + 2.0) * (greatest(&of_rows) + shift);
        // Far more than underflow can add, and finite only if all else is.
        let tiny = 1e-200;
        let [shift, rounded, factored, tiny] = [shift, rounded, factor.rounding(), tiny].map(Interval::point);
        let eigenvalue = shift - (rounded + factored + tiny) * Interval::point(1.0 + 1e-9);
        (eigenvalue.or_zero().sqrt() - Interval::point(self.off)).lo()
    }
}
