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

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: signals that go with each other by 0.6 have L = [[1, 0], [0.6, 0.8]], so that (1, 1) becomes (1, 0.5).
    #[test]
    fn what_varies_together_becomes_independent() {
        let factor = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.6, 0.8]);
        let together = Together { rows: vec![0, 1], factor, half_ln_det: 0.8_f64.ln() };
        let mut z = [1.0, 1.0];
        together.whiten(&mut z);
        assert!((z[0] - 1.0).abs() < 1e-15 && (z[1] - 0.5).abs() < 1e-15, "{z:?}");
        // Lines of a Jacobian go as residuals do, column by column.
        let mut lines = [1.0, 0.0, 2.0, 1.0, 3.0, -1.0];
        together.whiten_lines(&mut lines, 3);
        for column in 0..3 {
            let mut of = [[1.0, 0.0, 2.0][column], [1.0, 3.0, -1.0][column]];
            together.whiten(&mut of);
            assert!((of[0] - lines[column]).abs() < 1e-15 && (of[1] - lines[3 + column]).abs() < 1e-15);
        }
    }

    /// Rows that take part go by stroke where something is known of them, and each by itself where nothing is.
    #[test]
    fn rows_of_a_stroke_go_together_only_if_something_is_known() {
        let rows = [Row::Force(0), Row::Force(1), Row::Channel { stroke: 0, block: 0 }];
        let alone = Together::all(&rows, &[true, false, true], |_| None, None);
        assert_eq!(alone.iter().map(|of| of.rows.clone()).collect::<Vec<_>>(), [vec![0], vec![2]]);
        assert!(alone.iter().all(|of| of.half_ln_det == 0.0));
    }
}
