//! Vectors, normals and volumes in the plane and in space alike, in intervals.

use crate::interval::Interval;

/// A vector of the plane, `[x, z]`, or of space, `[x, s, z]`.
pub(super) type Vector<const N: usize> = [Interval; N];

/// A symmetric matrix, all of it.
pub(super) type Matrix<const N: usize> = [[Interval; N]; N];

/// The coordinate that is the height.
pub(super) const fn up<const N: usize>() -> usize {
    N - 1
}

/// `N!`.
pub(super) fn factorial<const N: usize>() -> Interval {
    Interval::point(if N == 2 { 2.0 } else { 6.0 })
}

pub(super) fn dot<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Interval {
    a.iter().zip(b).fold(Interval::ZERO, |sum, (a, b)| sum + *a * *b)
}

/// `a - b` of two places.
pub(super) fn between<const N: usize>(a: &[f64; N], b: &[f64; N]) -> Vector<N> {
    std::array::from_fn(|k| Interval::point(a[k]) - Interval::point(b[k]))
}

/// The normal of a face through `N` places: in space twice the area long and right-handed, in the plane as long as
/// the edge and to the right of it.
pub(super) fn normal<const N: usize>(places: &[[f64; N]]) -> Vector<N> {
    let a = between(&places[1], &places[0]);
    if N == 2 {
        return std::array::from_fn(|k| if k == 0 { a[1] } else { -a[0] });
    }
    let b = between(&places[2], &places[0]);
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}
