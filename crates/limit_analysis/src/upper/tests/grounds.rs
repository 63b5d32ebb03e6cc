//! Statements of problems.

use soilctl_certificate::{
    Boundary, Condition, Line, LineUse, Linear, Material, Objective, Region, Statement,
};

pub(super) fn soil(phi_deg: f64, cohesion: f64, unit_weight: f64) -> Material {
    Material {
        phi_deg,
        cohesion: Linear::uniform(cohesion),
        unit_weight,
        pore_pressure: Linear::default(),
        tension: None,
        envelope: None,
        anisotropy: None,
    }
}

/// One region around which points follow each other counter-clockwise, with the condition on the line from each point to
/// the next.
pub(super) fn region(
    around: &[([f64; 2], Condition)],
    material: Material,
    objective: Objective,
) -> Statement {
    let n = around.len();
    let uses: Vec<LineUse> = (0..n).map(|line| LineUse { line, forward: true }).collect();
    let on = |(line, (_, condition)): (usize, &([f64; 2], Condition))| Boundary {
        line,
        forward: true,
        condition: *condition,
    };
    Statement {
        points: around.iter().map(|a| a.0).collect(),
        lines: (0..n).map(|i| Line { from: i, to: (i + 1) % n }).collect(),
        regions: vec![Region { loops: vec![uses], material }],
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective,
        width: None,
        members: Vec::new(),
        boundaries: around.iter().enumerate().map(on).collect(),
    }
}

pub(super) fn pressed(pressure: f64, live: bool) -> Condition {
    Condition::Loaded { pressure: [pressure; 2], shear: [0.0; 2], live }
}

/// The right half of level ground with `strip` on it from 0 to `half` and `beside` next to it.
pub(super) fn footing(
    half: f64,
    [width, depth]: [f64; 2],
    strip: Condition,
    beside: Condition,
    material: Material,
    objective: Objective,
) -> Statement {
    let around = [
        ([0.0, 0.0], Condition::Smooth),
        ([0.0, -depth], Condition::Far),
        ([width, -depth], Condition::Far),
        ([width, 0.0], beside),
        ([half, 0.0], strip),
    ];
    region(&around, material, objective)
}

/// A slope of unit height whose toe is at the origin.
pub(super) fn slope(steepness_deg: f64, material: Material) -> Statement {
    let run = if steepness_deg == 90.0 { 0.0 } else { 1.0 / steepness_deg.to_radians().tan() };
    let around = [
        ([0.0, 0.0], Condition::Free),
        ([-2.0, 0.0], Condition::Fixed),
        ([-2.0, -1.5], Condition::Fixed),
        ([run + 3.0, -1.5], Condition::Fixed),
        ([run + 3.0, 1.0], Condition::Free),
        ([run, 1.0], Condition::Free),
    ];
    let mut statement = region(&around, material, Objective::Body { gravity: [0.0, -1.0] });
    statement.gravity = [0.0, -1e-9];
    statement
}

/// The right half of level ground in two layers, with a live load from 0 to 1 and `beside` next to it.
pub(super) fn layered(
    [width, depth]: [f64; 2],
    thickness: f64,
    [upper, lower]: [Material; 2],
    beside: Condition,
) -> Statement {
    let points = vec![
        [0.0, 0.0],
        [0.0, -thickness],
        [width, -thickness],
        [width, 0.0],
        [1.0, 0.0],
        [0.0, -depth],
        [width, -depth],
    ];
    let ends = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 5), (5, 6), (6, 2)];
    let forward = |line: usize| LineUse { line, forward: true };
    let back = |line: usize| LineUse { line, forward: false };
    let (smooth, fixed) = (Condition::Smooth, Condition::Fixed);
    let on =
        [(0, smooth), (2, fixed), (3, beside), (4, pressed(1.0, true)), (5, smooth), (6, fixed), (7, fixed)];
    Statement {
        points,
        lines: ends.map(|(from, to)| Line { from, to }).to_vec(),
        regions: vec![
            Region { loops: vec![(0..5).map(forward).collect()], material: upper },
            Region { loops: vec![vec![forward(5), forward(6), forward(7), back(1)]], material: lower },
        ],
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective: Objective::Loads,
        width: None,
        members: Vec::new(),
        boundaries: on.map(|(line, condition)| Boundary { line, forward: true, condition }).to_vec(),
    }
}
