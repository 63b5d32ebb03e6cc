//! Plain algorithms on small dense matrices, each in one order of sums: the same bits on all machines.

/// A matrix that others hold by columns, or its transpose.
#[derive(Debug, Clone, Copy)]
pub(crate) struct View<'a> {
    data: &'a [f64],
    lead: usize,
    turned: bool,
}

impl<'a> View<'a> {
    /// `lead` numbers from one column to the next.
    pub(crate) fn new(data: &'a [f64], lead: usize, turned: bool) -> Self {
        Self { data, lead, turned }
    }

    pub(crate) fn turn(self) -> Self {
        Self { turned: !self.turned, ..self }
    }

    pub(crate) fn at(&self, row: usize, column: usize) -> f64 {
        let (row, column) = if self.turned { (column, row) } else { (row, column) };
        self.data[row + column * self.lead]
    }
}

/// Which entries of a matrix are changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    All,
    Upper,
    Lower,
}

/// A matrix that is changed.
#[derive(Debug)]
pub(crate) struct Target<'a> {
    pub(crate) data: &'a mut [f64],
    pub(crate) lead: usize,
    pub(crate) rows: usize,
    pub(crate) columns: usize,
    pub(crate) part: Part,
}

impl Target<'_> {
    /// `C = alpha A B + beta C`, where `A` has `inner` columns. What `C` was is not read if `beta` is zero.
    pub(crate) fn multiply(&mut self, alpha: f64, a: View<'_>, b: View<'_>, inner: usize, beta: f64) {
        for j in 0..self.columns {
            let rows = match self.part {
                Part::All => 0..self.rows,
                Part::Upper => 0..self.rows.min(j + 1),
                Part::Lower => j.min(self.rows)..self.rows,
            };
            for i in rows {
                let sum = (0..inner).fold(0.0, |sum, k| sum + a.at(i, k) * b.at(k, j));
                let entry = &mut self.data[i + j * self.lead];
                *entry = alpha * sum + if beta == 0.0 { 0.0 } else { beta * *entry };
            }
        }
    }
}

/// Cholesky's factor of a symmetric matrix, in place of its lower triangle, or transposed in place of the upper one. The
/// number of the first leading part that is not positive definite, from one, if there is one.
pub(crate) fn factor(a: &mut [f64], lead: usize, n: usize, upper: bool) -> Result<(), usize> {
    let at = |i: usize, j: usize| if upper { j + i * lead } else { i + j * lead };
    for j in 0..n {
        let pivot = (0..j).fold(a[at(j, j)], |sum, k| sum - a[at(j, k)] * a[at(j, k)]);
        // Also what is not a number.
        if pivot.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
            return Err(j + 1);
        }
        let root = pivot.sqrt();
        a[at(j, j)] = root;
        for i in j + 1..n {
            a[at(i, j)] = (0..j).fold(a[at(i, j)], |sum, k| sum - a[at(i, k)] * a[at(j, k)]) / root;
        }
    }
    Ok(())
}

/// Solves `L L' x = b` in place, `L` as above.
pub(crate) fn solve_factored(lower: View<'_>, n: usize, b: &mut [f64]) {
    for i in 0..n {
        b[i] = (0..i).fold(b[i], |sum, k| sum - lower.at(i, k) * b[k]) / lower.at(i, i);
    }
    for i in (0..n).rev() {
        b[i] = (i + 1..n).fold(b[i], |sum, k| sum - lower.at(k, i) * b[k]) / lower.at(i, i);
    }
}

/// Rounds of rotations: they converge quadratically, after six or so.
const ROUNDS: usize = 40;

/// Cosine and sine of the rotation that makes `[[app, apq], [apq, aqq]]` diagonal (Rutishauser 1966).
fn rotation(app: f64, apq: f64, aqq: f64) -> (f64, f64) {
    let theta = (aqq - app) / (2.0 * apq);
    let tan = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cos = 1.0 / (tan * tan + 1.0).sqrt();
    (cos, tan * cos)
}

/// Eigenvalues, increasing, and eigenvectors, by Jacobi's rotations. `a` has all rows of a symmetric matrix.
pub(crate) fn eigen(mut a: Vec<Vec<f64>>) -> (Vec<f64>, Vec<Vec<f64>>) {
    let n = a.len();
    let mut vectors: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..ROUNDS {
        let mut turned = false;
        for (p, q) in (0..n).flat_map(|q| (0..q).map(move |p| (p, q))) {
            let small = f64::EPSILON * 0.01 * (a[p][p].abs() + a[q][q].abs());
            if a[p][q].abs() <= small {
                continue;
            }
            turned = true;
            let (cos, sin) = rotation(a[p][p], a[p][q], a[q][q]);
            for row in &mut a {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
            for k in 0..n {
                (a[p][k], a[q][k]) = (cos * a[p][k] - sin * a[q][k], sin * a[p][k] + cos * a[q][k]);
                (vectors[p][k], vectors[q][k]) =
                    (cos * vectors[p][k] - sin * vectors[q][k], sin * vectors[p][k] + cos * vectors[q][k]);
            }
        }
        if !turned {
            break;
        }
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    (order.iter().map(|&i| a[i][i]).collect(), order.iter().map(|&i| vectors[i].clone()).collect())
}

/// A singular value decomposition.
#[derive(Debug)]
pub(crate) struct Singular {
    /// Decreasing.
    pub(crate) values: Vec<f64>,
    /// For each value the vector on the left and that on the right.
    pub(crate) left: Vec<Vec<f64>>,
    pub(crate) right: Vec<Vec<f64>>,
}

/// The decomposition of a matrix by one-sided rotations (Hestenes 1958). `columns` has at least as many rows as columns.
pub(crate) fn singular(mut columns: Vec<Vec<f64>>, rows: usize) -> Singular {
    let n = columns.len();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y);
    let mut right: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..ROUNDS {
        let mut turned = false;
        for (p, q) in (0..n).flat_map(|q| (0..q).map(move |p| (p, q))) {
            let [pp, pq, qq] =
                [(p, p), (p, q), (q, q)].map(|(i, j): (usize, usize)| dot(&columns[i], &columns[j]));
            if pq.abs() <= f64::EPSILON * (pp * qq).sqrt() {
                continue;
            }
            turned = true;
            let (cos, sin) = rotation(pp, pq, qq);
            for list in [&mut columns, &mut right] {
                for k in 0..list[p].len() {
                    (list[p][k], list[q][k]) =
                        (cos * list[p][k] - sin * list[q][k], sin * list[p][k] + cos * list[q][k]);
                }
            }
        }
        if !turned {
            break;
        }
    }
    let lengths: Vec<f64> = columns.iter().map(|column| dot(column, column).sqrt()).collect();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| lengths[j].total_cmp(&lengths[i]));
    let values: Vec<f64> = order.iter().map(|&i| lengths[i]).collect();
    let mut left: Vec<Vec<f64>> = Vec::with_capacity(n);
    let mut axes = 0..rows;
    for &i in &order {
        let mut vector = columns[i].clone();
        let mut length = lengths[i];
        // Where the value is zero any vector will do that is normal to the others.
        while length.partial_cmp(&f64::MIN_POSITIVE) != Some(std::cmp::Ordering::Greater) {
            let Some(axis) = axes.next() else { break };
            vector = (0..rows).map(|k| f64::from(u8::from(k == axis))).collect();
            for other in left.iter().chain(&left) {
                let along = dot(&vector, other);
                vector.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
            }
            length = dot(&vector, &vector).sqrt();
            if length < 0.5 / (rows as f64) {
                length = 0.0;
            }
        }
        vector.iter_mut().for_each(|x| *x /= length);
        left.push(vector);
    }
    Singular { values, left, right: order.iter().map(|&i| right[i].clone()).collect() }
}
