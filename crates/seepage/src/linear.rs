//! The one place where large sparse systems are solved, by `faer` on one thread.

use crate::error::SeepageError;

/// A term of a matrix: row, column, value. Terms of one place add up.
pub(crate) type Term = (usize, usize, f64);

/// Solves `A x = b`.
#[cfg(target_pointer_width = "64")]
pub(crate) fn solve(size: usize, terms: &[Term], right: &[f64]) -> Result<Vec<f64>, SeepageError> {
    use faer::linalg::solvers::Solve;
    use faer::sparse::{SparseColMat, Triplet};

    // Of the whole process, but nothing else here asks for it: bits must not depend on the number of threads.
    faer::set_global_parallelism(faer::Par::Seq);
    let triplets: Vec<_> = terms.iter().map(|(i, j, value)| Triplet::new(*i, *j, *value)).collect();
    let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(size, size, &triplets)
        .map_err(|_| SeepageError::Singular)?;
    let factors = matrix.sp_lu().map_err(|_| SeepageError::Singular)?;
    let mut x = faer::Col::from_fn(size, |i| right[i]);
    factors.solve_in_place(x.as_mat_mut());
    let solution: Vec<f64> = (0..size).map(|i| x[i]).collect();
    if solution.iter().all(|value| value.is_finite()) { Ok(solution) } else { Err(SeepageError::Singular) }
}

/// Solves nothing: `faer` does not compile there.
#[cfg(not(target_pointer_width = "64"))]
pub(crate) fn solve(_size: usize, _terms: &[Term], _right: &[f64]) -> Result<Vec<f64>, SeepageError> {
    Err(SeepageError::NotHere)
}
