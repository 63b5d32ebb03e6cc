//! Readings of one stroke, weighed as one: their residuals are made independent of each other by what is known of how they vary together.

use nalgebra::DMatrix;

use super::problem::Row;
use crate::correlation::Correlation;

/// Rows of one stroke, and the lower Cholesky factor `L` of their correlation matrix.
pub(super) struct Together {
    pub(super) rows: Vec<usize>,
    factor: DMatrix<f64>,
    /// Half of ln of the determinant of the correlation matrix.
    pub(super) half_ln_det: f64,
}

impl Together {
    /// The rows that take part, by stroke; each by itself if nothing is known of how they vary together.
    pub(super) fn all(
        rows: &[Row],
        included: &[bool],
        signal: impl Fn(Row) -> Option<soilctl_effects::Channel>,
        correlation: Option<&Correlation>,
    ) -> Vec<Self> {
        let mut of_stroke: Vec<Vec<usize>> = Vec::new();
        for (r, row) in rows.iter().enumerate().filter(|(r, _)| included[*r]) {
            let same = |of: &Vec<usize>| rows[of[0]].stroke() == row.stroke();
            match correlation.and_then(|_| of_stroke.iter().position(same)) {
                Some(place) => of_stroke[place].push(r),
                None => of_stroke.push(vec![r]),
            }
        }
        let group = |of: Vec<usize>| {
            let signals: Vec<_> = of.iter().map(|&r| signal(rows[r])).collect();
            let known = correlation.and_then(|correlation| correlation.factor(&signals));
            let factor = known.unwrap_or_else(|| DMatrix::identity(of.len(), of.len()));
            let half_ln_det = (0..of.len()).map(|k| factor[(k, k)].ln()).sum();
            Self { rows: of, factor, half_ln_det }
        };
        of_stroke.into_iter().map(group).collect()
    }

    /// `L⁻¹ z` for values of the rows, by substitution.
    pub(super) fn whiten(&self, z: &mut [f64]) {
        for i in 0..z.len() {
            let known: f64 = (0..i).map(|j| self.factor[(i, j)] * z[j]).sum();
            z[i] = (z[i] - known) / self.factor[(i, i)];
        }
    }

    /// The same for lines of `width` values, one after the other.
    pub(super) fn whiten_lines(&self, lines: &mut [f64], width: usize) {
        if self.rows.len() < 2 {
            return;
        }
        for i in 0..self.rows.len() {
            let (before, rest) = lines.split_at_mut(i * width);
            let line = &mut rest[..width];
            for (j, other) in before.chunks_exact(width).enumerate() {
                let factor = self.factor[(i, j)];
                if factor != 0.0 {
                    line.iter_mut().zip(other).for_each(|(value, known)| *value -= factor * known);
                }
            }
            let own = self.factor[(i, i)];
            line.iter_mut().for_each(|value| *value /= own);
        }
    }
}
