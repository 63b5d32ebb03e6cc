use std::collections::BTreeMap;

use super::super::balance;
use super::*;
use crate::examples::Random;
use crate::{Gauge, VertexCopy};

/// Where the way from the buried block to the rim is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Way {
    /// To the loaded top.
    Up,
    /// To the fixed base.
    Down,
}

/// A block in weightless clay that is pushed up against a column of soil, on which a pressure acts. A function that is the
/// same all around it would carry no force.
pub(super) fn buried(way: Way, objective: Objective, pressure: f64, factor: f64) -> (Statement, LowerField) {
    let moves = matches!(objective, Objective::Structure { .. });
    let load = Condition::Loaded { pressure: [pressure; 2], shear: [0.0; 2], live: true };
    let blocks = Blocks {
        xs: &[-3.0, -1.0, 1.0, 3.0],
        ys: &[0.0, 1.0, 2.0, 4.0],
        cell: &|i, j| (i != 1 || j != 1).then_some(0),
        materials: &[material(0.0, 0.5, 0.0)],
        condition: &|[x, y], out| match out {
            [0, 1] if y == 4.0 && x.abs() < 1.0 => load,
            [0, 1] if y == 4.0 => Condition::Free,
            _ if x.abs() <= 1.0 && (1.0..=2.0).contains(&y) && moves => {
                Condition::Face { delta_deg: 0.0, adhesion: 0.2 }
            }
            _ => Condition::Fixed,
        },
        objective,
        gravity: [0.0, -1.0],
        datum: 4.0,
        surcharge: 0.0,
        slope: 0.0,
    };
    let q = pressure * if moves { 1.0 } else { factor };
    // The vertical stress is `-q` above the block and zero elsewhere.
    let f = move |[x, y]: [f64; 2]| {
        let beyond = if way == Way::Up { 0.0 } else { -2.0 * q };
        match () {
            () if x >= 1.0 => [beyond * x, beyond, 0.0],
            () if x > -1.0 && y >= 2.0 => [-q * (x + 1.0) * (x + 1.0) / 2.0, -q * (x + 1.0), 0.0],
            () => [0.0; 3],
        }
    };
    let statement = blocks.statement();
    let mesh = blocks.mesh(&statement);
    let mut field = fitted(&statement, &mesh, factor, &f);
    let slope = if way == Way::Up { -2.0 * q } else { 2.0 * q };
    field.gauges.push(Gauge { constant: 0.0, gradient: Gradient::Free { x: slope, y: 0.0 } });
    part(&mut field, way);
    (statement, field)
}

/// Gives the triangles on the left of the way copies of their own.
fn part(field: &mut LowerField, way: Way) {
    let place = |v: usize| field.mesh.vertices[v].position;
    let reach = if way == Way::Up { 2.0..=4.0 } else { 0.0..=1.0 };
    let on_way = |v: usize| place(v)[0] == 1.0 && reach.contains(&place(v)[1]);
    let mut twins: BTreeMap<usize, usize> = BTreeMap::new();
    for (t, triangle) in field.mesh.triangles.iter().enumerate() {
        let is_left = triangle.corners.iter().all(|v| place(*v)[0] <= 1.0 && reach.contains(&place(*v)[1]));
        for k in (0..3).filter(|k| is_left && on_way(triangle.corners[*k])) {
            let copy = field.corners[t][k];
            if let Jet::Free { base, .. } = &mut field.copies[copy].jet {
                field.copies[copy].jet = Jet::Free { base: *base, f: 0.0, fx: 0.0, fy: 0.0 };
            }
            field.corners[t][k] = *twins.entry(copy).or_insert_with(|| {
                let VertexCopy { vertex, jet } = field.copies[copy];
                field.copies.push(VertexCopy { vertex, jet: jet.on(1, 0) });
                field.copies.len() - 1
            });
        }
        for k in 0..3 {
            let [a, b] = [1, 2].map(|i| triangle.corners[(k + i) % 3]);
            if on_way(a) && on_way(b) {
                field.slopes[t][k] = 0.0;
            }
        }
    }
    for copy in &mut field.copies {
        if matches!(copy.jet, Jet::Gauge { .. })
            && way == Way::Up
            && field.mesh.vertices[copy.vertex].position[0] < 1.0
        {
            copy.jet = Jet::Gauge { gauge: 1 };
        }
    }
}

const UP: Objective = Objective::Structure { velocity: [0.0, 1.0] };

#[test]
fn a_buried_block_is_held_by_the_soil_above() {
    for way in [Way::Up, Way::Down] {
        is_the_limit(1.0, &|factor| buried(way, Objective::Loads, 1.0, factor));
        let (statement, field) = buried(way, UP, 0.99, 1.0);
        balance::check(&statement, &field);
        let bound = prove_lower(&statement, &field).unwrap();
        assert!(bound <= 1.98 && bound > 1.98 - 1e-9, "{bound}");
        let (statement, field) = buried(way, UP, 1.01, 1.0);
        assert!(prove_lower(&statement, &field).is_err());
    }
}

#[test]
fn any_function_with_branches_balances() {
    for way in [Way::Up, Way::Down] {
        for seed in 0..5 {
            let (statement, mut field) = buried(way, UP, 0.3, 1.0);
            let mut random = Random::new(seed);
            let mut of_vertex: BTreeMap<usize, [f64; 3]> = BTreeMap::new();
            for copy in &mut field.copies {
                if let Jet::Free { base, .. } = copy.jet {
                    let [f, fx, fy] =
                        *of_vertex.entry(copy.vertex).or_insert_with(|| [0; 3].map(|_| random.next()));
                    copy.jet = Jet::Free { base, f, fx, fy };
                }
            }
            field.slopes.iter_mut().flatten().for_each(|s| *s = random.next());
            let [constant, x, y] = [0; 3].map(|_| random.next());
            field.gauges[1] = Gauge { constant, gradient: Gradient::Free { x, y } };
            balance::check(&statement, &field);
        }
    }
}

#[test]
fn branches_must_fit() {
    for way in [Way::Up, Way::Down] {
        let (statement, good) = buried(way, UP, 0.9, 1.0);
        let refused = |change: &dyn Fn(&mut LowerField)| {
            let mut field = good.clone();
            change(&mut field);
            prove_lower(&statement, &field).unwrap_err()
        };
        let last = good.copies.len() - 2;
        let torn = refused(&|field| {
            let base = 1;
            field.copies[last].jet = Jet::Free { base, f: 1e-9, fx: 0.0, fy: 0.0 };
        });
        assert!(matches!(torn, CertificateError::BadField { .. }), "{torn}");
        let unlike = refused(&|field| field.copies[last].jet = field.copies[last].jet.on(0, 0));
        assert!(matches!(unlike, CertificateError::BadField { .. }), "{unlike}");
        let elsewhere = refused(&|field| field.copies[last].vertex = 0);
        assert!(matches!(elsewhere, CertificateError::BadField { .. }), "{elsewhere}");
        let none = refused(&|field| field.gauges.truncate(1));
        assert!(matches!(none, CertificateError::NoSuch { .. }), "{none}");
        let endless = refused(&|field| field.gauges[1].constant = f64::NAN);
        assert!(matches!(endless, CertificateError::OutOfRange { .. }), "{endless}");
    }
}
