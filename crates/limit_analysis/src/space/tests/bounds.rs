//! What comes of programs: fields that the certificate proves, between bounds that are known.

use std::sync::atomic::Ordering;
use std::time::Instant;

use soilctl_certificate::prove_end;

use super::super::adapt::Lengths;
use super::super::complex::Complex;
use super::super::element::{Element, Stress};
use super::super::program::Assembled;
use super::super::region::Region;
use super::super::response::Response;
use super::super::strength::Strengths;
use super::super::{EndOptions, FACTORISATION, end_lower, section};
use crate::LimitError;
use crate::accuracy::SPACE;

fn options(steps: usize, tetrahedra: usize) -> EndOptions {
    EndOptions { steps, tetrahedra, ..EndOptions::default() }
}

#[test]
fn fields_are_proven_between_known_bounds_and_are_the_same_twice() {
    // Without ends the net coefficient is 4.3107, nearly exactly; a mechanism of blocks in space has 5.196 at this width.
    let lower = end_lower(30.0, 15.0, 5.0, &options(2, 300), &mut |_| {}).unwrap();
    let proven = prove_end(30.0, 15.0, &lower.field).unwrap().per_width(5.0).unwrap();
    let coefficient = 2.0 * proven / 15.0_f64.to_radians().cos();
    assert!(coefficient > 4.3107 && coefficient < 5.196, "{coefficient}");
    assert!((proven - lower.value).abs() < 1e-5, "{proven} {}", lower.value);
    assert_eq!(lower.levels.len(), 3);
    // Finer meshes are better, and no section is above what is nearly exact.
    assert!(lower.levels.windows(2).all(|pair| pair[0].value < pair[1].value));
    assert!(lower.levels.iter().all(|level| 2.0 * level.between / 15.0_f64.to_radians().cos() < 4.3107));
    let again = end_lower(30.0, 15.0, 5.0, &options(2, 300), &mut |_| {}).unwrap();
    assert!(lower.field == again.field && lower.value.to_bits() == again.value.to_bits());
}

#[test]
fn narrow_plates_and_smooth_ones_have_fields_too() {
    // Rankine's wedges bound the force of a smooth plate without ends: `(K - 1/K)/2`; to its ends at this width a mechanism adds
    // less than half of it.
    let lower = end_lower(30.0, 0.0, 8.0, &options(0, 0), &mut |_| {}).unwrap();
    let proven = prove_end(30.0, 0.0, &lower.field).unwrap();
    assert!(proven.between > 1.2 && proven.between < 4.0 / 3.0, "{proven:?}");
    assert!(proven.per_width(8.0).unwrap() < 2.0);
    // As wide as both boxes.
    let lower = end_lower(35.0, 20.0, 0.5, &options(0, 0), &mut |_| {}).unwrap();
    let proven = prove_end(35.0, 20.0, &lower.field).unwrap();
    assert_eq!(proven.reach, 0.25);
    assert!((proven.per_width(0.5).unwrap() - lower.value).abs() < 1e-5);
}

/// `div P = -e_z` by finite differences of the stress, as it is between the points where it is demanded.
#[test]
fn stresses_are_in_equilibrium_inside_all_tetrahedra() {
    let complex = Complex::new(&Region::new(30.0, 5.0).first());
    let triangles = section::cut(&complex, &Lengths::default());
    let mut of = Assembled::new(complex, &triangles, &Strengths::new(30.0, 15.0), 5.0);
    let how =
        soilctl_conic::How { accuracy: SPACE, factorisation: Some(FACTORISATION), seconds: None, dump: None };
    let answer = soilctl_conic::solve(&of.program, how, [&Default::default(); 2]).unwrap();
    for number in 0..of.ends.0.cells.len() {
        let response = Response::new(&of.ends.0, &of.ends.1, number, &mut of.program);
        let corners = of.ends.0.cells[number].corners.map(|corner| of.ends.0.places[corner]);
        let centroid: [f64; 3] = std::array::from_fn(|k| corners.iter().map(|p| p[k]).sum::<f64>() / 4.0);
        let points: Vec<Stress<3>> = (0..Element::<3, 4>::points().count())
            .map(|point| {
                std::array::from_fn(|i| {
                    std::array::from_fn(|j| response.form(point, [i, j], 1.0).value(&answer.x))
                })
            })
            .collect();
        // In the part opposite a vertex.
        let part = number % 4;
        let others: Vec<usize> = (0..4).filter(|&k| k != part).collect();
        let nodes = [corners[others[0]], corners[others[1]], corners[others[2]], centroid];
        let stress = |place: [f64; 3]| -> Stress<3> {
            let volume = |a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]| {
                let [u, v, w]: [[f64; 3]; 3] = [b, c, d].map(|p| std::array::from_fn(|k| p[k] - a[k]));
                u[0] * (v[1] * w[2] - v[2] * w[1])
                    + u[1] * (v[2] * w[0] - v[0] * w[2])
                    + u[2] * (v[0] * w[1] - v[1] * w[0])
            };
            let whole = volume(nodes[0], nodes[1], nodes[2], nodes[3]);
            let mut sum = [[0.0; 3]; 3];
            for node in 0..4 {
                let mut with = nodes;
                with[node] = place;
                let weight = volume(with[0], with[1], with[2], with[3]) / whole;
                // At a vertex parts follow each other in the order of the other vertices.
                let point = others.get(node).map_or(12, |&k| 3 * k + if part < k { part } else { part - 1 });
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    sum[i][j] += weight * points[point][i][j];
                }
            }
            sum
        };
        let middle: [f64; 3] = std::array::from_fn(|k| nodes.iter().map(|p| p[k]).sum::<f64>() / 4.0);
        let step = 1e-3;
        let mut divergence = [0.0, 0.0, 1.0];
        for axis in 0..3 {
            let at = |by: f64| stress(std::array::from_fn(|k| middle[k] + if k == axis { by } else { 0.0 }));
            let (more, less) = (at(step), at(-step));
            (0..3).for_each(|i| divergence[i] += (more[i][axis] - less[i][axis]) / (2.0 * step));
        }
        // As well as the solver met the balances.
        assert!(divergence.iter().all(|x| x.abs() < 1e-4), "{number} {divergence:?}");
    }
}

#[test]
fn a_stop_ends_the_run_with_what_there_is() {
    let stopped = options(3, 5_000);
    stopped.stops[1].store(true, Ordering::Relaxed);
    let start = Instant::now();
    let refused = end_lower(30.0, 15.0, 5.0, &stopped, &mut |_| {});
    assert!(matches!(refused, Err(LimitError::NoField { .. })) && start.elapsed().as_secs() < 20);
    let options = options(3, 5_000);
    let stop = &options.stops[0];
    let lower = end_lower(30.0, 15.0, 5.0, &options, &mut |_| stop.store(true, Ordering::Relaxed)).unwrap();
    assert!(lower.levels.len() == 1 && prove_end(30.0, 15.0, &lower.field).is_ok());
    let late = EndOptions { max_seconds: Some(0.0), ..self::options(0, 0) };
    assert!(end_lower(30.0, 15.0, 5.0, &late, &mut |_| {}).is_err());
}

#[test]
fn numbers_out_of_range_are_refused() {
    for (phi, delta, width) in [
        (4.0, 1.0, 5.0),
        (51.0, 1.0, 5.0),
        (30.0, 31.0, 5.0),
        (30.0, -1.0, 5.0),
        (30.0, 15.0, 0.0),
        (f64::NAN, 15.0, 5.0),
        (30.0, 15.0, f64::INFINITY),
    ] {
        let refused = end_lower(phi, delta, width, &EndOptions::default(), &mut |_| {});
        assert!(matches!(refused, Err(LimitError::Range { .. })), "{phi} {delta} {width}");
    }
}
