//! What is made of what presses on the faces of a simplex.

use proptest::prelude::*;

use super::super::strength::Strengths;
use super::super::stress::stresses;
use super::super::topology::Complex;
use super::super::tractions::{Pressing, Sheets};
use super::super::{PLANE, SPACE};
use super::Small;
use super::small::ground;
use crate::interval::{Interval, angle};

/// A stress that is linear and in equilibrium with the weight, from any numbers.
fn linear(numbers: &[f64; 24]) -> impl Fn([f64; 3]) -> [[f64; 3]; 3] {
    let mut terms = *numbers;
    // xx, ss, zz, xs, xz, sz: constant, and slopes along x, s, z.
    terms[1] = -terms[14] - terms[19];
    terms[6] = -terms[13] - terms[23];
    terms[11] = -1.0 - terms[17] - terms[22];
    move |[x, s, z]| {
        let at = |k: usize| terms[4 * k] + terms[4 * k + 1] * x + terms[4 * k + 2] * s + terms[4 * k + 3] * z;
        [[at(0), at(3), at(4)], [at(3), at(1), at(5)], [at(4), at(5), at(2)]]
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// A linear stress in equilibrium comes back from what it presses.
    #[test]
    fn a_linear_stress_comes_back(numbers in prop::array::uniform24(-1.0..1.0_f64)) {
        let small = Small::new(true);
        let complex = Complex::new(&small.vertices, &small.tetrahedra, &SPACE).unwrap();
        let stress = linear(&numbers);
        let field = small.field(&stress, &stress);
        let sheets = Sheets::new(&complex, &field.tractions, &field.behind, false).unwrap();
        // Not zero at the surface: as it presses, whatever is demanded there.
        let faces = complex.faces.iter();
        let of_face = |face: &super::super::topology::Face<3>| {
            let normal = face.normal.map(Interval::middle);
            face.corners.iter().map(|&c| {
                stress(small.vertices[c]).map(|row| Interval::point((0..3).map(|k| row[k] * normal[k]).sum()))
            }).collect()
        };
        let known: Vec<Vec<[Interval; 3]>> =
            faces.clone().chain(faces.filter(|face| face.plate.is_some())).map(of_face).collect();
        let pressing = Pressing { known };
        for (number, cell) in complex.cells.iter().enumerate() {
            let points = stresses(&complex, &sheets, &pressing, number);
            prop_assert_eq!(points.len(), 13);
            for point in points {
                let place = point.corner.map_or_else(
                    || std::array::from_fn(|k| cell.corners.iter().map(|&c| small.vertices[c][k]).sum::<f64>() / 4.0),
                    |c| small.vertices[c],
                );
                let expected = stress(place);
                let pairs = point.stress.iter().flatten().zip(expected.iter().flatten());
                for (found, expected) in pairs {
                    prop_assert!((found.middle() - expected).abs() < 1e-11, "{found:?} {expected}");
                    prop_assert!(found.hi() - found.lo() < 1e-10);
                }
            }
        }
    }

    /// The soil bears what its principal pressures say.
    #[test]
    fn the_soil_bears_what_principal_pressures_say(
        pressures in prop::array::uniform3(0.05..1.0_f64), turns in prop::array::uniform3(0.0..6.3_f64)
    ) {
        let strengths = Strengths::new(angle(30.0), 15.0);
        let mut turned = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (k, turn) in turns.into_iter().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            turned = turned.map(|mut row: [f64; 3]| {
                (row[i], row[j]) =
                    (turn.cos() * row[i] - turn.sin() * row[j], turn.sin() * row[i] + turn.cos() * row[j]);
                row
            });
        }
        let stress = turned.map(|a| turned.map(|b| {
            Interval::point((0..3).map(|k| a[k] * pressures[k] * b[k]).sum())
        }));
        let greatest = pressures.into_iter().fold(0.0, f64::max);
        let least = pressures.into_iter().fold(1.0, f64::min);
        let spare = 3.0 * least - greatest;
        prop_assume!(spare.abs() > 1e-9);
        prop_assert_eq!(strengths.spare(&stress) >= 0.0, spare > 0.0, "{}", spare);
    }
}

/// In the plane, too.
#[test]
fn the_ground_comes_back_in_the_plane() {
    let field = Small::new(true).field(&ground(1.5, 1.0), &ground(1.5, 1.0)).section;
    let complex = Complex::new(&field.vertices, &field.triangles, &PLANE).unwrap();
    let sheets = Sheets::new(&complex, &field.tractions, &field.behind, false).unwrap();
    let free: Vec<Interval> = sheets.guess.iter().map(|&x| x.into()).collect();
    let pressing = sheets.with(&free);
    for (number, cell) in complex.cells.iter().enumerate() {
        for point in stresses(&complex, &sheets, &pressing, number) {
            let depth = point.corner.map_or_else(
                || cell.corners.iter().map(|&c| complex.depth(c)).sum::<f64>() / 3.0,
                |c| complex.depth(c),
            );
            let expected = [[1.5 * depth, 0.0], [0.0, depth]];
            for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                assert!((point.stress[i][j].middle() - expected[i][j]).abs() < 1e-12);
            }
        }
    }
}
