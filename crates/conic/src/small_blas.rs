//! The few routines of BLAS and LAPACK that Clarabel's semidefinite cones call.
//!
//! Clarabel declares them and leaves it to others to provide them. Libraries that do are written in Fortran or C, would have
//! to be built or found on every system, and choose instructions by processor, so that bits differ between machines. The
//! matrices here have three rows: plain loops are as fast, and the same everywhere. Factors and decompositions of three rows
//! Clarabel computes itself; those for larger ones are here because it refers to them.
//!
//! Signatures and meanings are those of the reference implementation (Anderson et al. 1999, LAPACK Users' Guide): matrices
//! by columns, with a leading dimension; all arguments by address.

#![allow(
    unsafe_code,
    reason = "the names and the calling convention are given; each routine only makes slices of what the convention promises"
)]

use std::ffi::{c_char, c_int};

use crate::small_dense::{Part, Target, View, eigen, factor, singular, solve_factored};

/// A dimension: none if negative.
unsafe fn size(of: *const c_int) -> usize {
    // SAFETY: the convention promises an integer there.
    usize::try_from(unsafe { *of }).unwrap_or(0)
}

unsafe fn is(flag: *const c_char, letter: u8) -> bool {
    // SAFETY: the convention promises a letter there.
    (unsafe { *flag } as u8).eq_ignore_ascii_case(&letter)
}

/// Numbers from the first to the last of a matrix.
fn extent(rows: usize, columns: usize, lead: usize) -> usize {
    if rows == 0 || columns == 0 { 0 } else { (columns - 1) * lead + rows }
}

unsafe fn numbers<'a>(at: *const f64, count: usize) -> &'a [f64] {
    // SAFETY: the convention promises so many numbers there, that nobody changes meanwhile.
    if count == 0 { &[] } else { unsafe { std::slice::from_raw_parts(at, count) } }
}

unsafe fn numbers_mut<'a>(at: *mut f64, count: usize) -> &'a mut [f64] {
    // SAFETY: the convention promises so many numbers there, that nobody else uses meanwhile.
    if count == 0 { &mut [] } else { unsafe { std::slice::from_raw_parts_mut(at, count) } }
}

/// `C = alpha op(A) op(B) + beta C`.
#[unsafe(no_mangle)]
unsafe extern "C" fn dgemm_(
    transa: *const c_char,
    transb: *const c_char,
    m: *const c_int,
    n: *const c_int,
    k: *const c_int,
    alpha: *const f64,
    a: *const f64,
    lda: *const c_int,
    b: *const f64,
    ldb: *const c_int,
    beta: *const f64,
    c: *mut f64,
    ldc: *const c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        let (m, n, k, lda, ldb, ldc) = (size(m), size(n), size(k), size(lda), size(ldb), size(ldc));
        let (turn_a, turn_b) = (!is(transa, b'N'), !is(transb, b'N'));
        let a = numbers(a, if turn_a { extent(k, m, lda) } else { extent(m, k, lda) });
        let b = numbers(b, if turn_b { extent(n, k, ldb) } else { extent(k, n, ldb) });
        let data = numbers_mut(c, extent(m, n, ldc));
        let mut target = Target { data, lead: ldc, rows: m, columns: n, part: Part::All };
        target.multiply(*alpha, View::new(a, lda, turn_a), View::new(b, ldb, turn_b), k, *beta);
    }
}

unsafe fn part(uplo: *const c_char) -> Part {
    // SAFETY: as above.
    if unsafe { is(uplo, b'U') } { Part::Upper } else { Part::Lower }
}

/// `C = alpha A A' + beta C`, or `alpha A' A + beta C`; one triangle of it.
#[unsafe(no_mangle)]
unsafe extern "C" fn dsyrk_(
    uplo: *const c_char,
    trans: *const c_char,
    n: *const c_int,
    k: *const c_int,
    alpha: *const f64,
    a: *const f64,
    lda: *const c_int,
    beta: *const f64,
    c: *mut f64,
    ldc: *const c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        let (n, k, lda, ldc) = (size(n), size(k), size(lda), size(ldc));
        let turn = !is(trans, b'N');
        let a = numbers(a, if turn { extent(k, n, lda) } else { extent(n, k, lda) });
        let data = numbers_mut(c, extent(n, n, ldc));
        let a = View::new(a, lda, turn);
        let mut target = Target { data, lead: ldc, rows: n, columns: n, part: part(uplo) };
        target.multiply(*alpha, a, a.turn(), k, *beta);
    }
}

/// `C = alpha (A B' + B A') + beta C`, or `alpha (A' B + B' A) + beta C`; one triangle of it.
#[unsafe(no_mangle)]
unsafe extern "C" fn dsyr2k_(
    uplo: *const c_char,
    trans: *const c_char,
    n: *const c_int,
    k: *const c_int,
    alpha: *const f64,
    a: *const f64,
    lda: *const c_int,
    b: *const f64,
    ldb: *const c_int,
    beta: *const f64,
    c: *mut f64,
    ldc: *const c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        let (n, k, lda, ldb, ldc) = (size(n), size(k), size(lda), size(ldb), size(ldc));
        let turn = !is(trans, b'N');
        let all = |lead| if turn { extent(k, n, lead) } else { extent(n, k, lead) };
        let (a, b) = (numbers(a, all(lda)), numbers(b, all(ldb)));
        let (a, b) = (View::new(a, lda, turn), View::new(b, ldb, turn));
        let data = numbers_mut(c, extent(n, n, ldc));
        let mut target = Target { data, lead: ldc, rows: n, columns: n, part: part(uplo) };
        target.multiply(*alpha, a, b.turn(), k, *beta);
        target.multiply(*alpha, b, a.turn(), k, 1.0);
    }
}

/// Cholesky's factor.
#[unsafe(no_mangle)]
unsafe extern "C" fn dpotrf_(
    uplo: *const c_char,
    n: *const c_int,
    a: *mut f64,
    lda: *const c_int,
    info: *mut c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        let (n, lda) = (size(n), size(lda));
        let a = numbers_mut(a, extent(n, n, lda));
        *info = factor(a, lda, n, is(uplo, b'U')).err().map_or(0, |at| at as c_int);
    }
}

/// Solves equations with Cholesky's factor.
#[unsafe(no_mangle)]
unsafe extern "C" fn dpotrs_(
    uplo: *const c_char,
    n: *const c_int,
    nrhs: *const c_int,
    a: *const f64,
    lda: *const c_int,
    b: *mut f64,
    ldb: *const c_int,
    info: *mut c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        let (n, count, lda, ldb) = (size(n), size(nrhs), size(lda), size(ldb));
        let lower = View::new(numbers(a, extent(n, n, lda)), lda, is(uplo, b'U'));
        let b = numbers_mut(b, extent(n, count, ldb));
        b.chunks_mut(ldb.max(1)).for_each(|column| solve_factored(lower, n, column));
        *info = 0;
    }
}

/// All eigenvalues of a symmetric matrix, increasing, and its eigenvectors if wanted. Whatever range is asked for, it is
/// all of them.
#[unsafe(no_mangle)]
unsafe extern "C" fn dsyevr_(
    jobz: *const c_char,
    _range: *const c_char,
    uplo: *const c_char,
    n: *const c_int,
    a: *mut f64,
    lda: *const c_int,
    _vl: *const f64,
    _vu: *const f64,
    _il: *const c_int,
    _iu: *const c_int,
    _abstol: *const f64,
    m: *mut c_int,
    w: *mut f64,
    z: *mut f64,
    ldz: *const c_int,
    _isuppz: *mut c_int,
    work: *mut f64,
    lwork: *const c_int,
    iwork: *mut c_int,
    liwork: *const c_int,
    info: *mut c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        *info = 0;
        if *lwork == -1 || *liwork == -1 {
            (*work, *iwork) = (1.0, 1);
            return;
        }
        let (count, lda, ldz) = (size(n), size(lda), size(ldz));
        let upper = is(uplo, b'U');
        let view = View::new(numbers(a, extent(count, count, lda)), lda, upper);
        let entry = |i: usize, j: usize| view.at(i.max(j), i.min(j));
        let (values, vectors) =
            eigen((0..count).map(|i| (0..count).map(|j| entry(i, j)).collect()).collect());
        *m = *n;
        numbers_mut(w, count).copy_from_slice(&values);
        if is(jobz, b'V') && count > 0 {
            let z = numbers_mut(z, extent(count, count, ldz));
            vectors.iter().enumerate().for_each(|(j, v)| z[j * ldz..j * ldz + count].copy_from_slice(v));
        }
    }
}

/// A decomposition by singular values, with as many vectors as there are values.
#[unsafe(no_mangle)]
unsafe extern "C" fn dgesdd_(
    jobz: *const c_char,
    m: *const c_int,
    n: *const c_int,
    a: *mut f64,
    lda: *const c_int,
    s: *mut f64,
    u: *mut f64,
    ldu: *const c_int,
    vt: *mut f64,
    ldvt: *const c_int,
    work: *mut f64,
    lwork: *const c_int,
    _iwork: *mut c_int,
    info: *mut c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe { dgesvd_(jobz, jobz, m, n, a, lda, s, u, ldu, vt, ldvt, work, lwork, info) }
}

/// The same.
#[unsafe(no_mangle)]
unsafe extern "C" fn dgesvd_(
    _jobu: *const c_char,
    _jobvt: *const c_char,
    m: *const c_int,
    n: *const c_int,
    a: *mut f64,
    lda: *const c_int,
    s: *mut f64,
    u: *mut f64,
    ldu: *const c_int,
    vt: *mut f64,
    ldvt: *const c_int,
    work: *mut f64,
    lwork: *const c_int,
    info: *mut c_int,
) {
    // SAFETY: the caller keeps to the convention.
    unsafe {
        *info = 0;
        if *lwork == -1 {
            *work = 1.0;
            return;
        }
        let (m, n, lda, ldu, ldvt) = (size(m), size(n), size(lda), size(ldu), size(ldvt));
        let wide = n > m;
        let view = View::new(numbers(a, extent(m, n, lda)), lda, wide);
        let (rows, columns) = if wide { (n, m) } else { (m, n) };
        let mut found =
            singular((0..columns).map(|j| (0..rows).map(|i| view.at(i, j)).collect()).collect(), rows);
        if wide {
            std::mem::swap(&mut found.left, &mut found.right);
        }
        numbers_mut(s, columns).copy_from_slice(&found.values);
        let u = numbers_mut(u, extent(m, columns, ldu));
        let vt = numbers_mut(vt, extent(columns, n, ldvt));
        for (k, (left, right)) in found.left.iter().zip(&found.right).enumerate() {
            left.iter().enumerate().for_each(|(i, x)| u[i + k * ldu] = *x);
            right.iter().enumerate().for_each(|(j, x)| vt[k + j * ldvt] = *x);
        }
    }
}

#[cfg(test)]
#[path = "small_blas_tests.rs"]
mod tests;
