use super::*;

/// A vertical cut of height one, with soil of its own level beyond the mesh on both sides, and soil below.
pub(super) fn cut(factor: f64, hand: f64, datum: f64, weights: [f64; 2]) -> (Statement, LowerField) {
    let high = usize::from(hand < 0.0);
    let blocks = Blocks {
        xs: &[-2.0, 0.0, 2.0],
        ys: &[-3.0, -1.0, 0.0],
        cell: &|i, j| (j == 0 || i == high).then_some(1 - j),
        materials: &weights.map(|w| material(0.0, 0.5, w)),
        condition: &|[x, _], out| match out {
            [0, -1] => Condition::Far,
            [0, _] => Condition::Free,
            _ if x == 0.0 => Condition::Free,
            _ => Condition::Far,
        },
        objective: BODY,
        gravity: [0.0; 2],
        datum,
        surcharge: 0.0,
        slope: 0.0,
    };
    let [above, below] = weights.map(|w| w * factor);
    let f = |[x, y]: [f64; 2]| {
        let (x, over) = (x * hand, (-1.0 - y).max(0.0));
        let beside = above * x.max(0.0);
        let value = above * datum * (x * x + y * y) / 2.0 + beside * x / 2.0 - above * y * y * y / 6.0;
        [
            value - below * over.powi(3) / 6.0 - above * over * over / 4.0,
            hand * (above * datum * x + beside),
            above * datum * y - above * y * y / 2.0 + below * over * over / 2.0 + above * over / 2.0,
        ]
    };
    let statement = blocks.statement();
    let mut field = fitted(&statement, &blocks.mesh(&statement), factor, &f);
    field.far_stress = above * (3.0 + datum) - 2.0 * below - above / 2.0;
    (statement, field)
}

#[test]
fn a_cut_stands_between_soils_of_different_level() {
    for hand in [1.0, -1.0] {
        for datum in [0.0, 0.4, -1.0] {
            for weights in [[1.0, 1.0], [1.0, 1.4], [1.0, 0.3]] {
                is_the_limit(1.0, &|factor| cut(factor, hand, datum, weights));
            }
        }
        let (statement, field) = cut(0.9, hand, 0.4, [1.0, 1.4]);
        altered_is_refused(&statement, &field);
        // The level stress below may differ by 2 c less what the height of the cut takes up already.
        for (more, holds) in [(0.54, true), (0.56, false), (-0.54, true), (-0.56, false)] {
            let mut field = field.clone();
            field.far_stress += more;
            assert_eq!(prove_lower(&statement, &field).is_ok(), holds, "{more}");
        }
    }
}
