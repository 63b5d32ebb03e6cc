use super::*;

/// A strip load of pressure one on weightless soil between fixed walls: level pressure of 2 c everywhere, 4 c below it.
pub(super) fn strip(factor: f64) -> (Statement, LowerField) {
    let load = Condition::Loaded { pressure: [1.0; 2], shear: [0.0; 2], live: true };
    let blocks = Blocks {
        xs: &[0.0, 1.0, 3.0, 4.0],
        ys: &[-1.0, 0.0],
        cell: &|_, _| Some(0),
        materials: &[material(0.0, 0.5, 0.0)],
        condition: &|[x, _], out| match out {
            [0, 1] if (1.0..3.0).contains(&x) => load,
            [0, 1] => Condition::Free,
            _ => Condition::Fixed,
        },
        objective: Objective::Loads,
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        slope: 0.0,
    };
    let f = |[x, y]: [f64; 2]| {
        let (on, from) = (x.clamp(1.0, 3.0) - 1.0, (x - 3.0).max(0.0));
        let value = -factor * (on * on / 2.0 + 2.0 * from);
        [value - factor * y * y / 4.0, -factor * on, -factor * y / 2.0]
    };
    let statement = blocks.statement();
    let field = fitted(&statement, &blocks.mesh(&statement), factor, &f);
    (statement, field)
}

#[test]
fn a_strip_load_is_borne_by_two_crossing_columns() {
    is_the_limit(2.0, &strip);
    let (statement, field) = strip(1.9);
    altered_is_refused(&statement, &field);
    // Without cohesion a load may not begin beside a free side, whose stress must vanish.
    let mut loose = statement.clone();
    loose.regions[0].material = material(30.0, 0.0, 0.0);
    let error = prove_lower(&loose, &field).unwrap_err();
    assert!(matches!(error, CertificateError::BadField { .. }), "{error}");
    // A hole that is free all around has no start.
    let mut hollow = statement;
    hollow.points.extend([[1.5, -0.5], [2.5, -0.5], [2.0, -0.7]]);
    let (p, l) = (hollow.points.len() - 3, hollow.lines.len());
    let ring = [(0, 1), (1, 2), (2, 0)];
    hollow.lines.extend(ring.map(|(a, b)| crate::Line { from: p + a, to: p + b }));
    let sides = [0, 1, 2].map(|i| LineUse { line: l + i, forward: true });
    hollow.regions[0].loops.push(sides.to_vec());
    let free = |s: LineUse| crate::Boundary { line: s.line, forward: true, condition: Condition::Free };
    hollow.boundaries.extend(sides.map(free));
    let error = prove_lower(&hollow, &field).unwrap_err();
    assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
}
