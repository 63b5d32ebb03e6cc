//! Soil without friction.

use std::f64::consts::PI;

use soilctl_certificate::{Boundary, Condition, Line, LineUse, Objective};

use super::grounds::{footing, pressed, region, slope, soil};
use super::{bounds, near_from_above};
use crate::EmbeddedPlate;

const BOX: [f64; 2] = [5.0, 3.0];

#[test]
fn a_strip_load_on_clay_is_prandtls() {
    let clay = soil(0.0, 1.0, 0.0);
    let s = footing(1.0, BOX, pressed(1.0, true), Condition::Free, clay, Objective::Loads);
    near_from_above(&bounds(&s, &[600, 1200]), 2.0 + PI, 0.003);
}

#[test]
fn rigid_footings_on_clay_are_prandtls() {
    let down = Objective::Structure { velocity: [0.0, -1.0] };
    for adhesion in [0.0, 1.0] {
        let face = Condition::Face { delta_deg: 0.0, adhesion };
        let s = footing(1.0, BOX, face, Condition::Free, soil(0.0, 1.0, 1.0), down);
        near_from_above(&bounds(&s, &[900]), 2.0 + PI, 0.016);
    }
}

#[test]
fn a_vertical_cut_in_clay_stands_as_high_as_is_known() {
    let found = bounds(&slope(90.0, soil(0.0, 1.0, 1.0)), &[700, 1400]);
    near_from_above(&found, 3.7764, 0.015);
}

/// A slit, on both sides of which the soil must move as the plate does, across it.
#[test]
fn an_upright_plate_in_clay_takes_the_soil_along() {
    let mut s = EmbeddedPlate::default().problem().unwrap().statement().clone();
    s.regions[0].material = soil(0.0, 0.1, 1.0);
    for b in &mut s.boundaries {
        if matches!(b.condition, Condition::Face { .. }) {
            b.condition = Condition::Face { delta_deg: 0.0, adhesion: 0.05 };
        }
    }
    // 4c by Rankine if it were smooth; the weights of both sides cancel.
    let rough = bounds(&s, &[900]).pop().unwrap().proven;
    assert!(rough > 0.4 && rough < 0.6, "{rough}");
}

/// A wall that is closed, around which the soil flows; the box is another one.
#[test]
fn a_pipe_in_clay_is_as_deep_ones_are() {
    let count = 12;
    let mut s = region(
        &[[-3.0, -3.0], [3.0, -3.0], [3.0, 3.0], [-3.0, 3.0]].map(|p| (p, Condition::Fixed)),
        soil(0.0, 1.0, 0.0),
        Objective::Structure { velocity: [1.0, 0.0] },
    );
    // Clockwise.
    let around = |i: usize| (-2.0 * PI * i as f64 / count as f64).sin_cos();
    s.points.extend((0..count).map(|i| [0.5 * around(i).1, 0.5 * around(i).0]));
    let lines = (0..count).map(|i| Line { from: 4 + i, to: 4 + (i + 1) % count });
    s.lines.extend(lines);
    let hole: Vec<LineUse> = (0..count).map(|i| LineUse { line: 4 + i, forward: true }).collect();
    let face = Condition::Face { delta_deg: 0.0, adhesion: 1.0 };
    s.boundaries.extend(hole.iter().map(|u| Boundary { line: u.line, forward: true, condition: face }));
    s.regions[0].loops.push(hole);
    let bound = bounds(&s, &[]).pop().unwrap().proven;
    // Randolph & Houlsby (1984): 11.94 around a circle.
    assert!(bound > 11.0 && bound < 13.0, "{bound}");
}

/// A block on a smooth base whose left side leans on smooth walls in line: where these meet, only rounding tells that they
/// are, so the soil is held there.
#[test]
fn clay_slides_along_walls_that_lean() {
    let around = [
        ([0.0, 0.0], Condition::Smooth),
        ([-0.3, -0.5], Condition::Smooth),
        ([-0.6, -1.0], Condition::Smooth),
        ([2.0, -1.0], Condition::Free),
        ([2.0, 0.0], pressed(1.0, true)),
    ];
    let s = region(&around, soil(0.0, 1.0, 0.2), Objective::Loads);
    let bound = bounds(&s, &[]).pop().unwrap().proven;
    // Between plates it would be two; the wall's lean takes some of the load, and the weight helps.
    assert!(bound > 1.5 && bound < 3.0, "{bound}");
}
