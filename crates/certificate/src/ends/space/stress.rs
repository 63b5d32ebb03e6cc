//! The stress in a simplex that follows from what presses on its faces.
//!
//! The centroid `c` cuts the simplex in `N + 1` parts; part `i` has the face opposite vertex `i`. The stress `P` is
//! linear in each (in the plane Johnson & Mercier 1978, in space Krizek 1982 and Gopalakrishnan, Guzman & Lee 2024).
//!
//! # At a vertex
//!
//! Let `p` be a vertex, `d_a` the ways from it to the others, and `e_a` the dual basis. Part `a` lies at the outer
//! face spanned by the `d_b` with `b != a`, of which `e_a` is a normal, and is cut from part `b` by a face spanned by
//! the other `d` and the way to the centroid, which is along the sum of all `d`: `e_a - e_b` is a normal of it. Write
//! `P = sum P^bc d_b d_c` and let `t_a = P e_a` be given on the outer faces, `t_a = sum t_a^b d_b`. The stresses
//! `P_a` of the parts obey
//!
//! ```text
//! P_a e_a = t_a,      (P_a - P_b) (e_a - e_b) = 0
//! ```
//!
//! The first say `P_a^ab = t_a^b`. Component `a` of the second is `t_a^a - t_a^b - P_b^aa + t_b^a = 0`, which gives
//! `P_b^aa`; in space component `c`, the third, is `P_a^bc + P_b^ac = t_a^c + t_b^c`, and two of these three less the
//! other give twice one. So there is one solution:
//!
//! ```text
//! P_a^ab = t_a^b,     P_a^bb = t_b^b - t_b^a + t_a^b,     P_a^bc = (t_a^b + t_a^c + t_b^c + t_c^b - t_b^a - t_c^a)/2
//! ```
//!
//! With `J` as in [balances](super::balance) and `n` the normal of the face `a`, pointing out of the simplex, `e_a =
//! -n/J`.
//!
//! # At the centroid
//!
//! All parts have one stress `P_c` there. *If the balances of the simplex hold, exactly one `P_c` makes `div P =
//! -e_z` in all parts*:
//!
//! - The divergence in part `i` is a constant vector; let `E_i` be that plus `e_z`. By Gauss's theorem and as `P` is
//!   symmetric and what it presses is the same on both sides of inner faces, for any `P_c` the integral of `E . r`
//!   over the simplex is, for each rigid motion `r`, what the outer faces do with `r` less that of the weight: zero,
//!   as forces and moments balance. The parts have the same volume, and their centroids are `(c - x_i)/(N + 1)` from
//!   `c`. So `sum E_i = 0`, and `S = sum E_i (x_i - c)'` is symmetric.
//! - Let `G_i` be the gradient of the function that is 1 at `x_i` and 0 at the other vertices: `sum G_i = 0`, `sum
//!   G_i (x_i - c)' = 1`, and any `N` of them are a basis. Hence `E_i = M G_i` for one matrix `M`, and `S = M`: it is
//!   symmetric.
//! - In part `i` the function that is 1 at the centroid and 0 on the outer face has the gradient `(N + 1) G_i`. So a
//!   change of `P_c` by `Q` changes `E_i` by `(N + 1) Q G_i`, and `Q = -M/(N + 1)` and no other makes all `E_i` zero.
//!
//! For this `P_c` the mean of `P`, `m`, follows by Gauss from the outer faces, as the weight has no moment about `c`;
//! and it is the mean of the means of the parts:
//!
//! ```text
//! m = 1/((N + 1) J) sum over f, j of  s t_fj (x_j - x_f)'
//! (N + 1)^2 m = sum over parts and vertices of P  +  (N + 1) P_c
//! ```
//!
//! *So the stress is in equilibrium everywhere*: in each part, and across all faces: what presses on them is linear,
//! and agrees at all vertices, by the first equation above on outer faces, by the second on inner ones, and at the
//! centroid since the stress is one there.

use super::simplex::{Matrix, between, dot};
use super::topology::Complex;
use super::tractions::{Pressing, Sheets};
use crate::interval::Interval;

/// A stress, and where it is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<const N: usize> {
    pub(super) stress: Matrix<N>,
    /// The vertex; none for the centroid.
    pub(super) corner: Option<usize>,
}

/// The stresses of all parts of a simplex at its vertices, and that at the centroid: between, the stress is linear.
pub(super) fn stresses<const N: usize>(
    complex: &Complex<'_, N>,
    sheets: &Sheets<N>,
    pressing: &Pressing<N>,
    number: usize,
) -> Vec<Point<N>> {
    let cell = &complex.cells[number];
    let sign = |f: usize| if cell.outwards[f] { Interval::ONE } else { -Interval::ONE };
    // What presses out of the simplex, and the normal that way.
    let out = |f: usize, corner: usize| {
        pressing.on(complex, sheets, number, f, corner).map(|component| component * sign(f))
    };
    let mut points = Vec::with_capacity(N * (N + 1) + 1);
    let mut sum = [[Interval::ZERO; N]; N];
    let square = cell.volume.square();
    for (at, &corner) in cell.corners.iter().enumerate() {
        let mut others = [0; N];
        (0..=N).filter(|&k| k != at).enumerate().for_each(|(a, k)| others[a] = k);
        let ways = others.map(|k| between(&complex.places[cell.corners[k]], &complex.places[corner]));
        let normals = others.map(|f| complex.faces[cell.faces[f]].normal.map(|n| n * sign(f)));
        let given: Matrix<N> = others.map(|f| {
            let pressing = out(f, corner);
            normals.map(|n| dot(&n, &pressing) / square)
        });
        for a in 0..N {
            let stress = spread(&part(&given, a), &ways);
            add(&mut sum, &stress, Interval::ONE);
            points.push(Point { stress, corner: Some(corner) });
        }
    }
    let parts = Interval::point(-1.0) / Interval::point((N + 1) as f64);
    let mut centre = [[Interval::ZERO; N]; N];
    add(&mut centre, &sum, parts);
    let mut mean = [[Interval::ZERO; N]; N];
    for (f, &opposite) in cell.corners.iter().enumerate() {
        for &corner in cell.corners.iter().filter(|&&c| c != opposite) {
            let (pressing, arm) =
                (out(f, corner), between(&complex.places[corner], &complex.places[opposite]));
            for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
                mean[i][j] = mean[i][j] + pressing[i] * arm[j];
            }
        }
    }
    let mean =
        std::array::from_fn(|i| std::array::from_fn(|j| (mean[i][j] + mean[j][i]).half() / cell.volume));
    add(&mut centre, &mean, Interval::ONE);
    points.push(Point { stress: centre, corner: None });
    points
}

/// Contravariant components of the stress in part `a` at a vertex.
fn part<const N: usize>(given: &Matrix<N>, a: usize) -> Matrix<N> {
    let mut part = [[Interval::ZERO; N]; N];
    for b in 0..N {
        part[a][b] = given[a][b];
        part[b][a] = given[a][b];
        if b != a {
            part[b][b] = given[b][b] - given[b][a] + given[a][b];
        }
        for c in (0..b).filter(|&c| b != a && c != a) {
            let twice = given[a][b] + given[a][c] + given[b][c] + given[c][b] - given[b][a] - given[c][a];
            part[b][c] = twice.half();
            part[c][b] = twice.half();
        }
    }
    part
}

/// `sum part^bc d_b d_c`.
fn spread<const N: usize>(part: &Matrix<N>, ways: &Matrix<N>) -> Matrix<N> {
    let mut stress = [[Interval::ZERO; N]; N];
    for i in 0..N {
        for j in 0..=i {
            let mut sum = Interval::ZERO;
            for b in 0..N {
                let along: Interval = (0..N).fold(Interval::ZERO, |along, c| along + part[b][c] * ways[c][j]);
                sum = sum + along * ways[b][i];
            }
            stress[i][j] = sum;
            stress[j][i] = sum;
        }
    }
    stress
}

fn add<const N: usize>(sum: &mut Matrix<N>, other: &Matrix<N>, factor: Interval) {
    for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
        sum[i][j] = sum[i][j] + other[i][j] * factor;
    }
}
