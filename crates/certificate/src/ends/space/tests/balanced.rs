//! Balances that are made exact, and equations with known singular values.

use std::f64::consts::PI;

use super::super::SPACE;
use super::super::balance::balances;
use super::super::cholesky::Layout;
use super::super::dissection::dissect;
use super::super::stress::stresses;
use super::super::system::{Row, System};
use super::super::topology::Complex;
use super::super::tractions::Sheets;
use super::Small;
use super::small::ground;
use crate::CertificateError;
use crate::interval::Interval;

/// A field that is out of balance is balanced; then the parts of all tetrahedra are in equilibrium, and what they
/// press on inner faces is the same on both sides.
#[test]
fn what_is_balanced_is_in_equilibrium() {
    let small = Small::new(true);
    let field = small.field(&ground(1.4, 1.0), &ground(0.6, 1.0));
    let complex = Complex::new(&small.vertices, &small.tetrahedra, &SPACE).unwrap();
    let sheets = Sheets::new(&complex, &field.tractions, &field.behind, false).unwrap();
    let free = balances(&complex, &sheets).solve(&sheets.guess).unwrap();
    assert!(free.iter().all(|x| x.hi() - x.lo() < 1e-11));
    assert!(free.iter().zip(&sheets.guess).any(|(x, guess)| (x.middle() - guess).abs() > 1e-2));
    let pressing = sheets.with(&free);
    for (number, cell) in complex.cells.iter().enumerate() {
        let points = stresses(&complex, &sheets, &pressing, number);
        let middle = |p: &super::super::stress::Point<3>| p.stress.map(|row| row.map(Interval::middle));
        let centroid: [f64; 3] =
            std::array::from_fn(|k| cell.corners.iter().map(|&c| small.vertices[c][k]).sum::<f64>() / 4.0);
        for part in 0..4 {
            // The part opposite a vertex is, at each other vertex, the one in the order of those that are left.
            let others: Vec<usize> = (0..4).filter(|&k| k != part).collect();
            let at = |k: usize| {
                let among = (0..4).filter(|&o| o != k).position(|o| o == part).unwrap();
                middle(&points[3 * k + among])
            };
            let centre = middle(&points[12]);
            // Gradients by Cramer's rule, relative to the centroid.
            let ways: Vec<[f64; 3]> = others
                .iter()
                .map(|&k| std::array::from_fn(|i| small.vertices[cell.corners[k]][i] - centroid[i]))
                .collect();
            let cross = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let by = |v: [f64; 3], w: [f64; 3]| v.iter().zip(w).map(|(a, b)| a * b).sum::<f64>();
            let volume = by(ways[0], cross(ways[1], ways[2]));
            let mut divergence = [0.0, 0.0, 1.0];
            for k in 0..3 {
                let slope = cross(ways[(k + 1) % 3], ways[(k + 2) % 3]);
                let stress = at(others[k]);
                for i in 0..3 {
                    divergence[i] +=
                        (0..3).map(|j| (stress[i][j] - centre[i][j]) * slope[j] / volume).sum::<f64>();
                }
            }
            assert!(divergence.iter().all(|x| x.abs() < 1e-9), "{divergence:?}");
            // Across the inner faces that this part shares with the others, at their vertices.
            for &other in others.iter().filter(|&&other| other > part) {
                for &k in others.iter().filter(|&&k| k != other) {
                    let third = (0..4).find(|&o| o != part && o != other && o != k).unwrap();
                    let way = |k: usize| -> [f64; 3] {
                        std::array::from_fn(|i| small.vertices[cell.corners[k]][i] - centroid[i])
                    };
                    let normal = cross(way(k), way(third));
                    let among = |p: usize| (0..4).filter(|&o| o != k).position(|o| o == p).unwrap();
                    let [here, there] = [part, other].map(|p| middle(&points[3 * k + among(p)]));
                    for i in 0..3 {
                        let jump: f64 = (0..3).map(|j| (here[i][j] - there[i][j]) * normal[j]).sum();
                        assert!(jump.abs() < 1e-10, "{jump}");
                    }
                }
            }
        }
    }
}

/// The plate's force is what the planes ahead and behind press more or less, as no others press along x.
#[test]
fn forces_on_the_whole_box_balance() {
    let small = Small::new(true);
    let field = small.field(&ground(1.4, 1.0), &ground(0.6, 1.0));
    let complex = Complex::new(&small.vertices, &small.tetrahedra, &SPACE).unwrap();
    let sheets = Sheets::new(&complex, &field.tractions, &field.behind, false).unwrap();
    let free = balances(&complex, &sheets).solve(&sheets.guess).unwrap();
    let pressing = sheets.with(&free);
    let mut planes = 0.0;
    let mut plate = 0.0;
    for (number, face) in complex.faces.iter().enumerate() {
        let sum = |sheet: usize| pressing.known[sheet].iter().map(|p| p[0].middle()).sum::<f64>() / 6.0;
        let sign = face.normal[0].middle().signum();
        if let Some(rim) = face.rim.filter(|rim| rim.axis == 0) {
            planes += if rim.high { 1.0 } else { -1.0 } * sign * sum(number);
        }
        if let Some(number_there) = face.plate {
            plate += sign * (sum(number) - sum(complex.faces.len() + number_there));
        }
    }
    assert!(plate > 0.01 && (plate - planes).abs() < 1e-10, "{plate} {planes}");
}

/// A row of springs: eigenvalues are known.
#[test]
fn eigenvalues_of_springs_are_bounded_from_below() {
    let count = 200;
    let neighbours: Vec<Vec<usize>> = (0..count)
        .map(|i: usize| {
            [i.checked_sub(1), Some(i + 1).filter(|&n| n < count)].into_iter().flatten().collect()
        })
        .collect();
    let places: Vec<[f64; 3]> = (0..count).map(|i| [i as f64, 0.0, 0.0]).collect();
    let rows: Vec<Vec<usize>> = (0..count).map(|i| vec![i]).collect();
    let layout = Layout::new(&dissect(&places, &neighbours), &neighbours, &rows).unwrap();
    let mut matrix = vec![vec![]; count];
    for (i, list) in neighbours.iter().enumerate() {
        matrix[layout.place[i]].push((layout.place[i], 2.0));
        for &n in list.iter().filter(|&&n| layout.place[n] > layout.place[i]) {
            matrix[layout.place[i]].push((layout.place[n], -1.0));
        }
    }
    let least = 2.0 - 2.0 * (PI / (count as f64 + 1.0)).cos();
    let factor = layout.factor(&matrix, 0.999 * least).unwrap();
    assert!(factor.rounding() < 1e-13);
    assert!(layout.factor(&matrix, 1.001 * least).is_none());
    // What is solved is solved.
    let factor = layout.factor(&matrix, 0.0).unwrap();
    let mut right: Vec<f64> = (0..count).map(|i| (i % 5) as f64).collect();
    let given = right.clone();
    factor.solve(&mut right);
    for (i, list) in neighbours.iter().enumerate() {
        let at = layout.place[i];
        let sum: f64 = list.iter().map(|&n| right[layout.place[n]]).sum();
        assert!((2.0 * right[at] - sum - given[at]).abs() < 1e-9);
    }
}

fn system(rows: &[(&[f64], f64)]) -> System {
    let rows: Vec<Row> = rows
        .iter()
        .enumerate()
        .map(|(group, (factors, right))| Row {
            group,
            entries: factors.iter().map(|&x| x.into()).enumerate().collect(),
            right: (*right).into(),
        })
        .collect();
    System { places: vec![[0.0; 3]; rows.len()], rows, columns: 3, of: "equation" }
}

#[test]
fn equations_are_solved_near_the_guess_or_refused() {
    let found = system(&[(&[1.0, 1.0, 1.0], 3.0), (&[1.0, -1.0, 0.0], 1.0)]).solve(&[9.0, 0.0, 0.0]).unwrap();
    let middle: Vec<f64> = found.iter().map(|x| x.middle()).collect();
    assert!(
        (middle[0] + middle[1] + middle[2] - 3.0).abs() < 1e-14
            && (middle[0] - middle[1] - 1.0).abs() < 1e-14
    );
    assert!(found.iter().all(|x| x.hi() - x.lo() < 1e-14), "{found:?}");
    // The nearest to the guess: what was added to it is a combination of the rows.
    assert!((middle[0] - 9.0 + middle[1] - 2.0 * middle[2]).abs() < 1e-13, "{middle:?}");
    let dependent = system(&[(&[1.0, 1.0, 1.0], 3.0), (&[2.0, 2.0, 2.0], 1.0)]).solve(&[0.0; 3]);
    assert!(matches!(dependent, Err(CertificateError::NotProven { .. })));
    let empty = system(&[(&[], 0.0)]).solve(&[0.0; 3]);
    assert!(matches!(empty, Err(CertificateError::NotProven { .. })));
    let infinite = system(&[(&[1.0, 1.0, 1.0], 3.0)]).solve(&[f64::MAX, f64::MAX, 0.0]);
    assert!(infinite.is_err() || infinite.unwrap()[0].hi() > 1e300);
}
