//! What fields look like.

use super::Small;
use super::small::ground;
use crate::examples::Plate;
use crate::{Objective, Statement, show_space};

/// Two deep and six wide, in soil with 35 degrees, moved by `velocity`.
fn statement(velocity: f64) -> Statement {
    let plate = Plate { lean: 0.0, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let mut statement = plate.statement().with_width(6.0);
    statement.objective = Objective::Structure { velocity: [velocity, 0.0] };
    statement
}

#[test]
fn the_ground_at_rest_is_seen_where_it_is() {
    let small = Small::new(true);
    let field = small.field(&ground(1.2, 0.8), &ground(1.2, 0.8));
    for velocity in [1.0, -2.0] {
        let statement = statement(velocity);
        let weight = statement.regions[0].material.unit_weight;
        let shown = show_space(&statement, &field).unwrap();
        assert_eq!(shown.parts.len(), 4 * small.tetrahedra.len());
        let mut volume = 0.0;
        for part in &shown.parts {
            for ((place, stress), principal) in part.corners.iter().zip(&part.stress).zip(&part.principal) {
                let own = -weight * place[2];
                for (i, row) in stress.iter().enumerate() {
                    for (j, value) in row.iter().enumerate() {
                        let expected = if i == j { own * [1.2, 0.8, 1.0][i] } else { 0.0 };
                        assert!((value - expected).abs() < 1e-9, "{place:?} {stress:?}");
                    }
                }
                assert!((principal[0] - 0.8 * own).abs() < 1e-9 && (principal[1] - 1.2 * own).abs() < 1e-9);
            }
            let [a, b, c, d] = part.corners;
            let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
            let cross = [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]];
            volume += (u[0] * cross[0] + u[1] * cross[1] + u[2] * cross[2]).abs() / 6.0;
        }
        // The box, twice as large in all directions: x from -2 to 4 ahead, y from 2 to 5 about the end at 3, 4 deep.
        assert!((volume - 6.0 * 3.0 * 4.0).abs() < 1e-9, "{volume}");
        let ahead = shown.parts.iter().flat_map(|p| p.corners).fold(0.0_f64, |most, p| most.max(p[0]));
        assert_eq!(ahead, if velocity > 0.0 { 4.0 } else { 2.0 });
        let area: f64 = shown
            .plate
            .iter()
            .map(|face| {
                assert!(face.net_pressure.iter().all(|pressure| pressure.abs() < 1e-9));
                assert!(
                    face.corners.iter().all(|[y, z]| (2.0..=3.0).contains(y) && (-2.0..=0.0).contains(z))
                );
                let [a, b, c] = face.corners;
                ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs() / 2.0
            })
            .sum();
        assert!((area - 2.0).abs() < 1e-12, "{area}");
    }
}

#[test]
fn a_push_presses_more_the_deeper() {
    let field = Small::new(true).field(&ground(1.1, 1.0), &ground(0.9, 1.0));
    let statement = statement(1.0);
    let weight = statement.regions[0].material.unit_weight;
    for face in show_space(&statement, &field).unwrap().plate {
        for ([_, z], pressure) in face.corners.iter().zip(face.net_pressure) {
            assert!((pressure + 0.2 * weight * z).abs() < 0.2 * weight * z.abs() + 1e-9, "{z} {pressure}");
        }
    }
}
