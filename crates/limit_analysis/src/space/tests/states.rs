//! States of stress that are known obey the programs, or break the right rows.

use soilctl_conic::Cone;

use super::super::adapt::Lengths;
use super::super::complex::Complex;
use super::super::element::{Element, Pressing};
use super::super::program::Assembled;
use super::super::region::Region;
use super::super::section;
use super::super::sheets::{Component, Sheets};
use super::super::strength::Strengths;

fn assembled(phi_deg: f64, delta_deg: f64) -> Assembled {
    let complex = Complex::new(&Region::new(phi_deg, 5.0).first());
    let section = section::cut(&complex, &Lengths::default());
    Assembled::new(complex, &section, &Strengths::new(phi_deg, delta_deg), 5.0)
}

/// Unknowns of a stress `diag(x, s, 1)` times the depth.
fn set<const N: usize, const M: usize>(
    complex: &Complex<N, M>,
    sheets: &Sheets<N>,
    stress: [f64; N],
    all: &mut [f64],
) {
    for (sheet, &face) in sheets.0.iter().zip(&complex.sheets) {
        let face = &complex.faces[face];
        for component in sheet.iter().map(|vertex| vertex.iter().enumerate()) {
            for (axis, component) in component {
                if let Component::Free { number, .. } = component {
                    all[*number] = stress[axis] * face.normal[axis] / face.long;
                }
            }
        }
    }
}

/// The least slack of all cones at a stress like that, with the best number `t` of each point; balances first.
fn slacks(of: &Assembled, x: f64, s: f64, ratio: f64) -> [f64; 2] {
    let mut all = vec![f64::NAN; of.program.unknowns];
    set(&of.ends.0, &of.ends.1, [x, s, 1.0], &mut all);
    set(&of.section.0, &of.section.1, [x, 1.0], &mut all);
    let t = 0.5 * (x.min(s).min(1.0) + x.max(s).max(1.0) / ratio);
    all.iter_mut().filter(|value| value.is_nan()).for_each(|value| *value = t);
    let (mut row, mut least) = (0, [f64::MAX; 2]);
    for &cone in &of.program.cones {
        let slack = of.program.slack(row, cone, &all);
        let kind = usize::from(cone != Cone::Zero);
        least[kind] = least[kind].min(slack);
        row += cone.rows();
    }
    assert!(of.force.value(&all).abs() < 1e-12);
    least
}

#[test]
fn the_ground_with_other_pressures_is_borne_within_the_limits_only() {
    // What decides is the ratio of the greatest and the least pressure: `K` is 3.
    let of = assembled(30.0, 15.0);
    for (x, s, borne) in [
        (1.0, 1.0, true),
        (2.99, 1.0, true),
        (3.01, 1.0, false),
        (0.34, 1.0, true),
        (0.33, 1.0, false),
        (2.0, 0.68, true),
        (2.0, 0.66, false),
    ] {
        let [balance, cones] = slacks(&of, x, s, 3.0);
        assert!(balance > -1e-11, "{balance}");
        assert_eq!(cones > 0.0, borne, "{x} {s}: {cones}");
    }
}

#[test]
fn the_ground_at_rest_presses_on_smooth_plates_too() {
    let [balance, cones] = slacks(&assembled(40.0, 0.0), 1.0, 1.0, 4.6);
    assert!(balance > -1e-11 && cones > 0.1, "{balance} {cones}");
}

/// A stress that is linear, and in equilibrium with the weight.
fn linear([x, s, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let (xx, ss) = (0.3 + 0.5 * x - 0.2 * s + 0.4 * z, -0.1 + 0.7 * x + 0.3 * s - 0.6 * z);
    let (xs, xz, sz) =
        (0.2 - 0.4 * x + 0.6 * s + z, 0.9 * x + 0.1 * s - 1.1 * z, 0.8 * s - 0.3 * x + 0.1 * z);
    // Rows: 0.5 + 0.6 - 1.1, -0.4 + 0.3 + 0.1, 0.9 + 0.8 - 2.7 + 1.
    [[xx, xs, xz], [xs, ss, sz], [xz, sz, 0.4 - 0.7 * x + 0.2 * s - 2.7 * z]]
}

#[test]
fn a_linear_stress_balances_and_comes_back() {
    let complex = Complex::new(&Region::new(30.0, 5.0).first());
    let mut compared = 0;
    for cell in complex.cells.iter().filter(|cell| !cell.at_surface) {
        let element = Element::new(&complex, cell);
        let mut pressing: Pressing<3, 4> = [[[0.0; 3]; 4]; 4];
        for (f, j) in (0..4).flat_map(|f| (0..4).map(move |j| (f, j))).filter(|(f, j)| f != j) {
            let normal = complex.faces[cell.faces[f]].normal.map(|n| n * cell.signs[f]);
            let stress = linear(complex.places[cell.corners[j]]);
            pressing[f][j] = stress.map(|row| (0..3).map(|k| row[k] * normal[k]).sum());
        }
        for (found, expected) in element.resultants(&pressing).into_iter().zip(element.weights()) {
            assert!((found - expected).abs() < 1e-11, "{found} {expected}");
        }
        let places: Vec<[f64; 3]> = cell.corners.map(|corner| complex.places[corner]).to_vec();
        let centroid = std::array::from_fn(|k| places.iter().map(|p| p[k]).sum::<f64>() / 4.0);
        for (point, stress) in element.stresses(&pressing).iter().enumerate() {
            let expected = linear(places.get(point / 3).copied().unwrap_or(centroid));
            for (a, b) in stress.iter().flatten().zip(expected.iter().flatten()) {
                assert!((a - b).abs() < 1e-10, "{a} {b}");
            }
            compared += 1;
        }
    }
    assert!(compared > 500);
}
