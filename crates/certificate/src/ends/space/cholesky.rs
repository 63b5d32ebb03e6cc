//! Cholesky's factors of a large sparse matrix in floating point, by dense fronts (Duff & Reid 1983), and a bound on
//! what rounding did to them.
//!
//! If `L` is what comes of the algorithm on the matrix `A`, run to its end in whatever order sums are taken, then
//! (Higham 2002, Accuracy and Stability of Numerical Algorithms, theorem 10.3; Rump 2006, BIT 46, 433-452)
//!
//! ```text
//! |L L' - A|  <=  g |L| |L'|,     g = (k + 1) u/(1 - (k + 1) u),   u = 2^-53
//! ```
//!
//! in each entry, `k` being the most numbers in a row of `L`. As `L L'` has no negative eigenvalue, none of `A` is
//! below the opposite of the norm of the right side, which is at most its greatest sum of a row. Underflow adds less
//! than the smallest normal number times all that is ever added.

use super::dissection::Part;

/// The most rows of a front: its square must be held.
const MAX_FRONT: usize = 8_000;
/// The most numbers of a factor.
const MAX_NUMBERS: usize = 150_000_000;
/// Columns that are eliminated before what is beyond them is changed.
const BLOCK: usize = 32;

/// Where the numbers of the factor are; common to all matrices with the same zeros.
#[derive(Debug)]
pub(super) struct Layout {
    /// For each row its place in the order of elimination.
    pub(super) place: Vec<usize>,
    fronts: Vec<Front>,
}

#[derive(Debug)]
struct Front {
    /// First of the rows that are eliminated here, and how many there are.
    first: usize,
    pivots: usize,
    /// All rows, increasing: those that are eliminated, and what is connected to them.
    rows: Vec<usize>,
    children: Vec<usize>,
}

/// Entries `(row, value)` of a symmetric matrix, for each column from the diagonal on downwards.
pub(super) type Columns = Vec<Vec<(usize, f64)>>;

/// A factor.
#[derive(Debug)]
pub(super) struct Factor<'a> {
    layout: &'a Layout,
    /// For each front its eliminated columns, one after the other.
    panels: Vec<Vec<f64>>,
}

impl Layout {
    /// `rows` has the rows of each group. Nothing if too much would have to be held.
    pub(super) fn new(parts: &[Part], neighbours: &[Vec<usize>], rows: &[Vec<usize>]) -> Option<Self> {
        let mut order = vec![0; rows.len()];
        let mut starts = Vec::new();
        let mut place = vec![0; rows.iter().map(Vec::len).sum()];
        let mut sequence = Vec::new();
        let mut next = 0;
        for &group in parts.iter().flat_map(|part| &part.groups) {
            order[group] = sequence.len();
            sequence.push(group);
            starts.push(next);
            for &row in &rows[group] {
                place[row] = next;
                next += 1;
            }
        }
        starts.push(next);
        let mut beyond: Vec<Vec<usize>> = Vec::new();
        let mut fronts = Vec::new();
        let (mut done, mut numbers) = (0, 0);
        for part in parts {
            let from = done;
            done += part.groups.len();
            let mut later: Vec<usize> =
                part.groups.iter().flat_map(|&g| &neighbours[g]).map(|&g| order[g]).collect();
            part.children.iter().for_each(|&child| later.extend(&beyond[child]));
            later.retain(|&at| at >= done);
            later.sort_unstable();
            later.dedup();
            let all = (from..done).chain(later.iter().copied());
            let rows: Vec<usize> = all.flat_map(|at| starts[at]..starts[at + 1]).collect();
            let (first, pivots) = (starts[from], starts[done] - starts[from]);
            numbers += pivots * rows.len();
            if rows.len() > MAX_FRONT || numbers > MAX_NUMBERS {
                return None;
            }
            fronts.push(Front { first, pivots, rows, children: part.children.clone() });
            beyond.push(later);
        }
        (next == place.len()).then_some(Self { place, fronts })
    }

    /// Factors a matrix less `shift` times the unit matrix, with rows in the order of elimination; nothing if a pivot
    /// is not positive, or there are numbers where the layout has none.
    pub(super) fn factor(&self, columns: &Columns, shift: f64) -> Option<Factor<'_>> {
        let mut local = vec![0; self.place.len()];
        let mut panels = Vec::with_capacity(self.fronts.len());
        let mut updates: Vec<Vec<f64>> = Vec::with_capacity(self.fronts.len());
        for front in &self.fronts {
            let size = front.rows.len();
            front.rows.iter().enumerate().for_each(|(at, &row)| local[row] = at);
            let mut dense = vec![0.0; size * size];
            for column in front.first..front.first + front.pivots {
                let start = local[column] * size;
                for &(row, value) in &columns[column] {
                    // Otherwise these would be the factors of another matrix.
                    if front.rows.get(local[row]) != Some(&row) {
                        return None;
                    }
                    dense[start + local[row]] += value;
                }
                dense[start + local[column]] -= shift;
            }
            for &child in &front.children {
                let update = std::mem::take(&mut updates[child]);
                let rows = &self.fronts[child].rows[self.fronts[child].pivots..];
                if rows.iter().any(|&row| front.rows.get(local[row]) != Some(&row)) {
                    return None;
                }
                for (c, &column) in rows.iter().enumerate() {
                    let start = local[column] * size;
                    let values = &update[c * rows.len()..];
                    (c..rows.len()).for_each(|r| dense[start + local[rows[r]]] += values[r]);
                }
            }
            eliminate(&mut dense, size, front.pivots)?;
            let rest = size - front.pivots;
            let mut update = Vec::with_capacity(rest * rest);
            for column in front.pivots..size {
                update.extend_from_slice(&dense[column * size + front.pivots..(column + 1) * size]);
            }
            updates.push(update);
            dense.truncate(front.pivots * size);
            dense.shrink_to_fit();
            panels.push(dense);
        }
        Some(Factor { layout: self, panels })
    }
}

/// Eliminates the first columns of a dense symmetric matrix, of which the lower half counts.
fn eliminate(dense: &mut [f64], size: usize, pivots: usize) -> Option<()> {
    for from in (0..pivots).step_by(BLOCK) {
        let to = (from + BLOCK).min(pivots);
        let (done, beyond) = dense.split_at_mut(to * size);
        for j in from..to {
            let (before, column) = done.split_at_mut(j * size);
            let column = &mut column[j..size];
            for k in from..j {
                let other = &before[k * size + j..(k + 1) * size];
                let factor = other[0];
                column.iter_mut().zip(other).for_each(|(x, y)| *x -= factor * y);
            }
            let pivot = column[0];
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            let root = pivot.sqrt();
            column[0] = root;
            column[1..].iter_mut().for_each(|x| *x /= root);
        }
        for c in to..size {
            let column = &mut beyond[(c - to) * size + c..(c - to + 1) * size];
            let mut k = from;
            while k + 4 <= to {
                let [p, q, r, s] = [0, 1, 2, 3].map(|i| &done[(k + i) * size + c..(k + i + 1) * size]);
                let (a, b, d, e) = (p[0], q[0], r[0], s[0]);
                for ((((x, p), q), r), s) in column.iter_mut().zip(p).zip(q).zip(r).zip(s) {
                    *x -= (a * p + b * q) + (d * r + e * s);
                }
                k += 4;
            }
            for k in k..to {
                let other = &done[k * size + c..(k + 1) * size];
                let factor = other[0];
                column.iter_mut().zip(other).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    Some(())
}

impl Factor<'_> {
    /// Solves with the matrix that was factored, rows being in the order of elimination. Nothing is proven.
    pub(super) fn solve(&self, right: &mut [f64]) {
        let fronts = || self.layout.fronts.iter().zip(&self.panels);
        for (front, panel) in fronts() {
            let size = front.rows.len();
            for j in 0..front.pivots {
                let column = &panel[j * size..(j + 1) * size];
                let x = right[front.rows[j]] / column[j];
                right[front.rows[j]] = x;
                (j + 1..size).for_each(|r| right[front.rows[r]] -= column[r] * x);
            }
        }
        for (front, panel) in fronts().rev() {
            let size = front.rows.len();
            for j in (0..front.pivots).rev() {
                let column = &panel[j * size..(j + 1) * size];
                let sum: f64 = (j + 1..size).map(|r| column[r] * right[front.rows[r]]).sum();
                right[front.rows[j]] = (right[front.rows[j]] - sum) / column[j];
            }
        }
    }

    /// A bound on how far below zero the least eigenvalue of the matrix that was factored may be.
    pub(super) fn rounding(&self) -> f64 {
        let count = self.layout.place.len();
        let (mut sums, mut lengths) = (vec![0.0; count], vec![0_u32; count]);
        for (front, panel) in self.layout.fronts.iter().zip(&self.panels) {
            let size = front.rows.len();
            for j in 0..front.pivots {
                let column = &panel[j * size + j..(j + 1) * size];
                let sum: f64 = column.iter().map(|x| x.abs()).sum();
                for (&row, x) in front.rows[j..].iter().zip(column) {
                    sums[row] += x.abs() * sum;
                    lengths[row] += 1;
                }
            }
        }
        let longest = lengths.iter().copied().max().unwrap_or(0);
        gamma(f64::from(longest) + 1.0) * greatest(&sums)
    }
}

/// `k u/(1 - k u)` for `k` up to a million, and what sums of that many positive numbers need besides, rounded up.
pub(super) fn gamma(k: f64) -> f64 {
    // Half of the machine's epsilon is the unit roundoff; the rest is far more than is lost in the sums.
    if k < 1e6 { k * 0.5 * f64::EPSILON * (1.0 + 1e-6) } else { f64::INFINITY }
}

/// The greatest of some sums; infinite if one is not a number.
pub(super) fn greatest(sums: &[f64]) -> f64 {
    sums.iter().fold(0.0, |most: f64, &sum| if sum.is_finite() { most.max(sum) } else { f64::INFINITY })
}
