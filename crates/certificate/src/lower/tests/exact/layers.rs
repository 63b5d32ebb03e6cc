use super::*;

/// Layered soil without friction under a load all over the mesh, with soil beyond it on both sides: 4 c.
pub(super) fn layered(factor: f64, weights: [f64; 3]) -> (Statement, LowerField) {
    let load = Condition::Loaded { pressure: [1.0; 2], shear: [0.0; 2], live: true };
    let blocks = Blocks {
        xs: &[0.0, 1.0, 3.0],
        ys: &[-3.0, -2.0, -0.7, 0.0],
        cell: &|_, j| Some(j),
        materials: &weights.map(|w| material(0.0, 0.5, w)),
        condition: &|_, out| match out {
            [0, 1] => load,
            [0, -1] => Condition::Fixed,
            _ => Condition::Far,
        },
        objective: Objective::Loads,
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.2,
        slope: 0.0,
    };
    // Beyond the reference, which has the surcharge already.
    let more = 0.2 - factor;
    // At rest the level stress is the vertical one; the reference has it for the weight of the lowest layer only.
    let kinks =
        [(0.0, weights[2] - weights[0]), (-0.7, weights[1] - weights[2]), (-2.0, weights[0] - weights[1])];
    let f = |[x, y]: [f64; 2]| {
        let rest = |power: i32, by: f64| {
            kinks.iter().map(|(top, w)| w * (top - y).max(0.0).powi(power) / by).sum::<f64>()
        };
        let value = more * x * x / 2.0 + more * y * y / 4.0 - rest(3, 6.0);
        [value, more * x, more * y / 2.0 + rest(2, 2.0)]
    };
    let statement = blocks.statement();
    let field = fitted(&statement, &blocks.mesh(&statement), factor, &f);
    (statement, field)
}

#[test]
fn layers_of_different_weight_rest_beside_each_other() {
    for weights in [[1.0, 1.0, 1.0], [2.0, 1.3, 0.4], [1.0, 1.0, 3.0]] {
        // The surcharge acts beyond the mesh only.
        is_the_limit(2.2, &|factor| layered(factor, weights));
        let (statement, field) = layered(2.0, weights);
        altered_is_refused(&statement, &field);
    }
    let (mut statement, field) = layered(2.0, [1.0; 3]);
    statement.regions[1].material.pore_pressure.gradient[0] = 0.1;
    let error = prove_lower(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
    // The joints of far lines belong to the lines above and below.
    let (statement, field) = layered(2.0, [2.0, 1.3, 0.4]);
    let mut other = field.clone();
    let mut changed = 0;
    for copy in &mut other.copies {
        if let (Jet::OneLine { line, f, along }, Place::Corner { point }) =
            (copy.jet, field.mesh.vertices[copy.vertex].place)
        {
            let joins = |l: &crate::Line| l.from == point || l.to == point;
            let far =
                |l: usize| statement.boundaries.iter().any(|b| b.line == l && b.condition == Condition::Far);
            let next =
                (0..statement.lines.len()).find(|l| *l != line && joins(&statement.lines[*l]) && far(*l));
            let Some(next) = next else { continue };
            let length = |l: usize| {
                let [a, b] = [statement.lines[l].from, statement.lines[l].to].map(|p| statement.points[p][1]);
                b - a
            };
            copy.jet = Jet::OneLine { line: next, f, along: along * length(line) / length(next) };
            changed += 1;
        }
    }
    assert_eq!(changed, 4);
    assert_eq!(prove_lower(&statement, &other).unwrap(), 2.0);
}

/// Fixed all around, two layers with a sloping interface. The reference alone carries the weight.
fn sloping(factor: f64) -> (Statement, LowerField) {
    let blocks = Blocks {
        xs: &[0.0, 2.0],
        ys: &[-2.0, -1.0, 0.0],
        cell: &|_, j| Some(1 - j),
        materials: &[1.0, 3.0].map(|w| material(0.0, 1.0, w)),
        condition: &|_, _| Condition::Fixed,
        objective: BODY,
        gravity: [0.0; 2],
        datum: 0.7,
        surcharge: 0.0,
        slope: 0.25,
    };
    let statement = blocks.statement();
    let field = fitted(&statement, &blocks.mesh(&statement), factor, &|_| [0.0; 3]);
    (statement, field)
}

#[test]
fn a_sloping_layer_carries_what_is_above_it() {
    // One below the interface the vertical stress is 2 more than the level one: twice the cohesion.
    is_the_limit(1.0, &sloping);
    let (mut statement, field) = sloping(0.5);
    statement.gravity[1] = -0.1;
    prove_lower(&statement, &field).unwrap();
    statement.gravity[0] = 0.01;
    let error = prove_lower(&statement, &field).unwrap_err();
    assert!(matches!(error, CertificateError::NotCovered { .. }), "{error}");
}

#[test]
fn water_may_press_on_what_is_far_below_less_than_the_weight() {
    let bound = |pressure: f64| {
        let mut soils = [1.0, 2.0].map(|w| material(30.0, 100.0, w));
        soils[1].pore_pressure.gradient[1] = -pressure;
        let blocks = Blocks {
            xs: &[0.0, 2.0],
            ys: &[-2.0, -1.0, 0.0],
            cell: &|_, j| Some(1 - j),
            materials: &soils,
            condition: &|_, out| if out == [0, 1] { Condition::Free } else { Condition::Far },
            objective: Objective::Loads,
            gravity: [0.0, -1.0],
            datum: 0.0,
            surcharge: 0.0,
            slope: 0.0,
        };
        let statement = blocks.statement();
        let field = fitted(&statement, &blocks.mesh(&statement), 7.0, &|_| [0.0; 3]);
        prove_lower(&statement, &field)
    };
    // The lower soil weighs two.
    assert_eq!(bound(1.9).unwrap(), 7.0);
    let error = bound(2.1).unwrap_err();
    assert!(error.to_string().contains("beyond far lines"), "{error}");
}
