//! Statements of test problems; the unit tests of the lower bound use them too.

use soilctl_certificate::{
    Boundary, Condition, Line, LineUse, Linear, Material, Objective, Region, Statement,
};

/// Weightless soil unless its unit weight is set.
pub(crate) fn soil(phi_deg: f64, cohesion: f64) -> Material {
    Material {
        phi_deg,
        cohesion: Linear::uniform(cohesion),
        unit_weight: 0.0,
        pore_pressure: Linear::default(),
        tension: None,
        envelope: None,
        anisotropy: None,
    }
}

/// Regions as corner lists with their soils; each outline edge has the condition that `condition` gives its middle.
pub(crate) fn statement(
    regions: &[(&[usize], Material)],
    points: &[[f64; 2]],
    objective: Objective,
    condition: impl Fn([f64; 2]) -> Condition,
) -> Statement {
    let mut lines: Vec<Line> = Vec::new();
    let mut outlines = Vec::new();
    for (corners, material) in regions {
        let uses = (0..corners.len())
            .map(|i| {
                let (from, to) = (corners[i], corners[(i + 1) % corners.len()]);
                if let Some(line) = lines.iter().position(|l| (l.from, l.to) == (to, from)) {
                    return LineUse { line, forward: false };
                }
                lines.push(Line { from, to });
                LineUse { line: lines.len() - 1, forward: true }
            })
            .collect::<Vec<_>>();
        outlines.push(Region { loops: vec![uses], material: material.clone() });
    }
    let used = |line: usize| outlines.iter().flat_map(|r| &r.loops[0]).filter(|u| u.line == line).count();
    let boundaries = (0..lines.len())
        .filter(|l| used(*l) == 1)
        .map(|line| {
            let [p, q] = [lines[line].from, lines[line].to].map(|i| points[i]);
            let middle = [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            Boundary { line, forward: true, condition: condition(middle) }
        })
        .collect();
    Statement {
        points: points.to_vec(),
        lines,
        regions: outlines,
        gravity: [0.0; 2],
        datum: 0.0,
        surcharge: 0.0,
        objective,
        width: None,
        members: Vec::new(),
        boundaries,
    }
}
