//! Statements in units of a half-width, a height or a depth.

use soilctl_certificate::{Condition, Material, Objective, Statement};

use super::common::statement;

pub(crate) fn pressed(pressure: f64, live: bool) -> Condition {
    Condition::Loaded { pressure: [pressure; 2], shear: [0.0; 2], live }
}

pub(crate) fn heavy(material: Material) -> Material {
    Material { unit_weight: 1.0, ..material }
}

/// Right half of level ground under a strip of half-width one.
fn half(
    material: Material,
    objective: Objective,
    [w, d]: [f64; 2],
    strip: Condition,
    beside: Condition,
) -> Statement {
    let points = [[0.0, 0.0], [0.0, -d], [w, -d], [w, 0.0], [1.0, 0.0]];
    statement(&[(&[0, 1, 2, 3, 4], material)], &points, objective, |[x, y]| match () {
        () if x == 0.0 => Condition::Smooth,
        () if y == 0.0 && x < 1.0 => strip,
        () if y == 0.0 => beside,
        () => Condition::Fixed,
    })
}

/// A strip load on weightless soil, with a pressure beside it.
pub(crate) fn strip(material: Material, beside: f64, size: [f64; 2]) -> Statement {
    half(material, Objective::Loads, size, pressed(1.0, true), pressed(beside, false))
}

/// A rigid footing that is pushed into soil.
pub(crate) fn footing(material: Material, delta_deg: f64, adhesion: f64, size: [f64; 2]) -> Statement {
    let objective = Objective::Structure { velocity: [0.0, -1.0] };
    let face = Condition::Face { delta_deg, adhesion };
    Statement { gravity: [0.0, -1.0], ..half(material, objective, size, face, Condition::Free) }
}

/// A smooth wall of height one on the left of level ground on a base, which is smooth unless gravity is inclined.
pub(crate) fn wall(
    layers: &[(f64, Material)],
    gravity: [f64; 2],
    surcharge: f64,
    direction: f64,
) -> Statement {
    let width = 12.0;
    let (mut points, mut top) = (vec![[0.0, 0.0], [width, 0.0]], 0.0);
    let mut corners = Vec::new();
    for (i, (thickness, _)) in layers.iter().enumerate() {
        top -= thickness;
        points.extend([[0.0, top], [width, top]]);
        corners.push([2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1]);
    }
    let regions: Vec<(&[usize], Material)> =
        corners.iter().zip(layers).map(|(c, (_, material))| (c.as_slice(), material.clone())).collect();
    let objective = Objective::Structure { velocity: [direction, 0.0] };
    let it = statement(&regions, &points, objective, |[x, y]| match () {
        () if x == 0.0 => Condition::Face { delta_deg: 0.0, adhesion: 0.0 },
        () if x == width => Condition::Far,
        () if y == 0.0 => Condition::Free,
        // An endless layer on a smooth base has nothing to hold it against an earthquake.
        () if gravity[0] != 0.0 => Condition::Fixed,
        () => Condition::Smooth,
    });
    Statement { gravity, surcharge, ..it }
}

/// A slope of height one, its crest on the left; the factor on its weight is bounded.
pub(crate) fn slope(material: Material, angle_deg: f64) -> Statement {
    let run = if angle_deg == 90.0 { 0.0 } else { 1.0 / angle_deg.to_radians().tan() };
    let (left, right, bottom) = (-3.0, run + 2.5, -1.5);
    let points = [[left, 1.0], [left, bottom], [right, bottom], [right, 0.0], [run, 0.0], [0.0, 1.0]];
    let objective = Objective::Body { gravity: [0.0, -1.0] };
    statement(&[(&[0, 1, 2, 3, 4, 5], heavy(material))], &points, objective, |[x, y]| {
        if x == left || x == right || y == bottom { Condition::Fixed } else { Condition::Free }
    })
}
