//! The routines against nalgebra, on random matrices with leading dimensions.

use nalgebra::DMatrix;
use proptest::prelude::*;

use super::*;

/// A matrix held by columns with a leading dimension, or its transpose; between columns is what nobody may change.
fn held(matrix: &DMatrix<f64>, turned: bool, spare: usize) -> (Vec<f64>, i32) {
    let matrix = if turned { matrix.transpose() } else { matrix.clone() };
    let lead = matrix.nrows() + spare;
    let mut data = vec![7e77; lead * matrix.ncols()];
    for (i, j) in (0..matrix.nrows()).flat_map(|i| (0..matrix.ncols()).map(move |j| (i, j))) {
        data[i + j * lead] = matrix[(i, j)];
    }
    (data, lead as i32)
}

fn letter(turned: bool) -> c_char {
    (if turned { b'T' } else { b'N' }) as c_char
}

fn matrix(rows: usize, columns: usize, numbers: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(rows, columns, |i, j| numbers[(i + 7 * j) % numbers.len()])
}

fn near(found: &[f64], lead: i32, expected: &DMatrix<f64>) -> bool {
    let rows = expected.nrows();
    found.chunks(lead as usize).enumerate().all(|(j, column)| {
        (0..rows).all(|i| (column[i] - expected[(i, j)]).abs() < 1e-11)
            && column[rows..].iter().all(|&x| x == 7e77)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn products(
        (m, n, k) in (1..5_usize, 1..5_usize, 1..5_usize), (turn_a, turn_b) in any::<(bool, bool)>(), spare in 0..3_usize,
        alpha in -2.0..2.0_f64, beta in prop_oneof![Just(0.0), -2.0..2.0_f64],
        numbers in prop::collection::vec(-1.0..1.0_f64, 61)
    ) {
        let (a, b) = (matrix(m, k, &numbers), matrix(k, n, &numbers[11..]));
        let before = matrix(m, n, &numbers[23..]);
        let ((da, lda), (db, ldb), (mut dc, ldc)) =
            (held(&a, turn_a, spare), held(&b, turn_b, spare), held(&before, false, spare));
        if beta == 0.0 {
            // Not read, so it may be anything.
            for j in 0..n { dc[j * ldc as usize..][..m].fill(f64::NAN); }
        }
        let [m, n, k] = [m, n, k].map(|x| x as i32);
        unsafe {
            dgemm_(&letter(turn_a), &letter(turn_b), &m, &n, &k, &alpha, da.as_ptr(), &lda, db.as_ptr(), &ldb, &beta,
                dc.as_mut_ptr(), &ldc);
        }
        prop_assert!(near(&dc, ldc, &(alpha * a * b + beta * before)));
    }

    #[test]
    fn symmetric_products(
        (n, k) in (1..5_usize, 1..5_usize), (turn, upper) in any::<(bool, bool)>(), spare in 0..3_usize, alpha in -2.0..2.0_f64,
        beta in -2.0..2.0_f64, numbers in prop::collection::vec(-1.0..1.0_f64, 61)
    ) {
        let (a, b, before) = (matrix(n, k, &numbers), matrix(n, k, &numbers[11..]), matrix(n, n, &numbers[23..]));
        let uplo = (if upper { b'U' } else { b'L' }) as c_char;
        let ((da, lda), (db, _)) = (held(&a, turn, spare), held(&b, turn, spare));
        let kept = |(i, j): (usize, usize)| if upper { i > j } else { i < j };
        let expect = |all: DMatrix<f64>| {
            DMatrix::from_fn(all.nrows(), all.ncols(), |i, j| if kept((i, j)) { before[(i, j)] } else { all[(i, j)] })
        };
        let [rows, inner] = [n, k].map(|x| x as i32);
        let (mut dc, ldc) = held(&before, false, spare);
        unsafe {
            dsyrk_(&uplo, &letter(turn), &rows, &inner, &alpha, da.as_ptr(), &lda, &beta, dc.as_mut_ptr(), &ldc);
        }
        prop_assert!(near(&dc, ldc, &expect(alpha * &a * a.transpose() + beta * &before)));
        let (mut dc, ldc) = held(&before, false, spare);
        unsafe {
            dsyr2k_(&uplo, &letter(turn), &rows, &inner, &alpha, da.as_ptr(), &lda, db.as_ptr(), &lda, &beta,
                dc.as_mut_ptr(), &ldc);
        }
        let both = &a * b.transpose() + &b * a.transpose();
        prop_assert!(near(&dc, ldc, &expect(alpha * both + beta * &before)));
    }

    #[test]
    fn factors_and_equations(
        n in 1..6_usize, upper in any::<bool>(), spare in 0..3_usize, numbers in prop::collection::vec(-1.0..1.0_f64, 61)
    ) {
        let root = matrix(n, n, &numbers);
        let a = &root * root.transpose() + DMatrix::identity(n, n);
        let uplo = (if upper { b'U' } else { b'L' }) as c_char;
        let ((mut da, lda), mut info, size) = (held(&a, false, spare), 1, n as i32);
        unsafe { dpotrf_(&uplo, &size, da.as_mut_ptr(), &lda, &mut info); }
        prop_assert_eq!(info, 0);
        let lower = a.clone().cholesky().unwrap().l();
        for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
            let at = if upper { j + i * lda as usize } else { i + j * lda as usize };
            prop_assert!((da[at] - lower[(i, j)]).abs() < 1e-11);
        }
        let x = matrix(n, 2, &numbers[5..]);
        let (mut db, ldb) = held(&(&a * &x), false, spare);
        unsafe { dpotrs_(&uplo, &size, &2, da.as_ptr(), &lda, db.as_mut_ptr(), &ldb, &mut info); }
        prop_assert!(info == 0 && near(&db, ldb, &x));
        // The last pivot is not positive.
        let mut less = a;
        less[(n - 1, n - 1)] -= lower[(n - 1, n - 1)].powi(2) + 1e-3;
        let (mut da, lda) = held(&less, false, spare);
        unsafe { dpotrf_(&uplo, &size, da.as_mut_ptr(), &lda, &mut info); }
        prop_assert_eq!(info, size);
    }

    #[test]
    fn eigenvalues(
        n in 1..6_usize, upper in any::<bool>(), spare in 0..3_usize, numbers in prop::collection::vec(-1.0..1.0_f64, 61)
    ) {
        let root = matrix(n, n, &numbers);
        let a = &root + root.transpose();
        let uplo = (if upper { b'U' } else { b'L' }) as c_char;
        let ((mut da, lda), mut info, mut count, size) = (held(&a, false, spare), 1, 0, n as i32);
        let (mut w, mut z, mut work, mut iwork) = (vec![0.0; n], vec![0.0; n * n], vec![0.0], vec![0]);
        unsafe {
            dsyevr_(&(b'V' as c_char), &(b'A' as c_char), &uplo, &size, da.as_mut_ptr(), &lda, &0.0, &0.0, &0, &0, &0.0,
                &mut count, w.as_mut_ptr(), z.as_mut_ptr(), &size, std::ptr::null_mut(), work.as_mut_ptr(), &1,
                iwork.as_mut_ptr(), &1, &mut info);
        }
        prop_assert_eq!((info, count), (0, size));
        let mut expected: Vec<f64> = a.clone().symmetric_eigenvalues().iter().copied().collect();
        expected.sort_by(f64::total_cmp);
        prop_assert!(w.iter().zip(&expected).all(|(w, e)| (w - e).abs() < 1e-12));
        let vectors = DMatrix::from_column_slice(n, n, &z);
        let diagonal = DMatrix::from_diagonal(&nalgebra::DVector::from_vec(w));
        prop_assert!((a * &vectors - &vectors * diagonal).abs().max() < 1e-12);
        prop_assert!((vectors.transpose() * vectors - DMatrix::identity(n, n)).abs().max() < 1e-13);
    }

    #[test]
    fn singular_values(
        (m, n, rank) in (1..6_usize, 1..6_usize, 0..6_usize), spare in 0..3_usize,
        numbers in prop::collection::vec(-1.0..1.0_f64, 61)
    ) {
        let a = matrix(m, rank, &numbers) * matrix(rank, n, &numbers[13..]);
        let least = m.min(n);
        let ((mut da, lda), mut info) = (held(&a, false, spare), 1);
        let (mut s, mut u, mut vt, mut work) = (vec![0.0; least], vec![0.0; m * least], vec![0.0; least * n], vec![0.0]);
        let (job, rows, columns, values) = (b'S' as c_char, m as i32, n as i32, least as i32);
        for length in [-1, 1] {
            unsafe {
                dgesdd_(&job, &rows, &columns, da.as_mut_ptr(), &lda, s.as_mut_ptr(), u.as_mut_ptr(), &rows,
                    vt.as_mut_ptr(), &values, work.as_mut_ptr(), &length, std::ptr::null_mut(), &mut info);
            }
            prop_assert_eq!(info, 0);
        }
        prop_assert!(s.windows(2).all(|pair| pair[0] >= pair[1]));
        if rank > 0 {
            let expected = a.clone().singular_values();
            prop_assert!(s.iter().zip(&expected).all(|(s, e)| (s - e).abs() < 1e-7), "{s:?} {expected:?}");
        }
        let (u, vt) = (DMatrix::from_column_slice(m, least, &u), DMatrix::from_column_slice(least, n, &vt));
        let diagonal = DMatrix::from_diagonal(&nalgebra::DVector::from_vec(s));
        prop_assert!((&u * diagonal * &vt - a).abs().max() < 1e-12);
        prop_assert!((u.transpose() * &u - DMatrix::identity(least, least)).abs().max() < 1e-6);
        prop_assert!((&vt * vt.transpose() - DMatrix::identity(least, least)).abs().max() < 1e-12);
    }
}

#[test]
fn what_is_not_a_number_ends() {
    let a = vec![vec![f64::NAN; 3]; 3];
    assert_eq!(eigen(a.clone()).0.len(), 3);
    assert_eq!(singular(a, 3).values.len(), 3);
    assert_eq!(factor(&mut [f64::NAN], 1, 1, true), Err(1));
    assert!(eigen(Vec::new()).0.is_empty() && singular(Vec::new(), 2).values.is_empty());
}
