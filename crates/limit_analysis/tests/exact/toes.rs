//! Walls on ground that does not move: at the toe the soil has all velocities between theirs.

use std::f64::consts::PI;

use soilctl_certificate::{Condition, Objective, Statement, StreamJet, prove_upper};

use crate::common::{soil, statement};
use crate::grounds::heavy;
use crate::solve;

/// A wall of height one that is pushed into clay, cohesion one, on ground at rest; `held` says what holds the soil there.
fn wall(unit_weight: f64, adhesion: f64, held: Condition, below: f64) -> Statement {
    let width = 4.0;
    let points = [[0.0, 0.0], [0.0, -1.0], [0.0, -1.0 - below], [width, -1.0 - below], [width, 0.0]];
    let outline: &[usize] = if below == 0.0 { &[0, 1, 3, 4] } else { &[0, 1, 2, 3, 4] };
    let objective = Objective::Structure { velocity: [1.0, 0.0] };
    let mut material = heavy(soil(0.0, 1.0));
    material.unit_weight = unit_weight;
    let it = statement(&[(outline, material)], &points, objective, |[x, y]| match () {
        () if x == 0.0 && y > -1.0 => Condition::Face { delta_deg: 0.0, adhesion },
        () if y == 0.0 => Condition::Free,
        () => held,
    });
    Statement { gravity: [0.0, -1.0], ..it }
}

#[test]
fn rough_walls_in_clay_carry_a_fan_at_their_top() {
    // A slip line at 45 degrees from the toe and a fan at the top: 1 + pi/2 times the height.
    let exact = 1.0 + PI / 2.0;
    let bounds = solve(wall(0.0, 1.0, Condition::Fixed, 0.0), 2500);
    assert!(bounds.lower.value <= exact && exact <= bounds.upper.value);
    assert!(bounds.gap() < 0.01, "{} to {}", bounds.lower.value, bounds.upper.value);
}

#[test]
fn smooth_walls_in_clay_carry_rankines_force_above_fixed_ground() {
    for below in [0.0, 0.5] {
        let bounds = solve(wall(1.0, 0.0, Condition::Fixed, below), 1500);
        let [lower, upper] = [bounds.lower.value, bounds.upper.value];
        assert!(lower <= 2.5 && 2.5 <= upper, "{below}: {lower} to {upper}");
        assert!(bounds.gap() < 0.01, "{below}: {lower} to {upper}");
    }
}

#[test]
fn a_slip_at_a_toe_that_is_altered_proves_nothing_false() {
    let statement = wall(0.0, 1.0, Condition::Fixed, 0.0);
    let field = solve(statement.clone(), 300).upper.field;
    let slipping: Vec<usize> = (0..field.stream.len())
        .filter(|i| matches!(field.stream[*i].jet, StreamJet::Slip { .. } | StreamJet::SlipAtWall { .. }))
        .collect();
    assert!(slipping.len() > 1);
    let (mut refused, mut proven) = (0, 0);
    let mut check = |altered: &soilctl_certificate::UpperField| match prove_upper(&statement, altered) {
        Ok(bound) => {
            assert!(bound >= 1.0 + PI / 2.0, "{bound}");
            proven += 1;
        }
        Err(_) => refused += 1,
    };
    for &at in &slipping {
        let before = field.stream[at].jet;
        let free = StreamJet::Free { s: 0.0, sx: 0.0, sy: 0.0 };
        let mut others = vec![free, StreamJet::Corner { wall: 0 }];
        for i in 0..field.stream.len() {
            others.extend([
                StreamJet::Slip { copy: i, towards: i, jump: 0.3 },
                StreamJet::SlipAtWall { copy: i, towards: at },
            ]);
        }
        for vertex in 0..field.mesh.vertices.len() {
            others.push(match before {
                StreamJet::Slip { copy, jump, .. } => StreamJet::Slip { copy, towards: vertex, jump },
                StreamJet::SlipAtWall { copy, .. } => StreamJet::SlipAtWall { copy, towards: vertex },
                other => other,
            });
        }
        if let StreamJet::Slip { copy, towards, jump } = before {
            others.push(StreamJet::Slip { copy, towards, jump: 0.9 * jump });
            others.push(StreamJet::Slip { copy: at, towards, jump });
        }
        for jet in others {
            let mut altered = field.clone();
            altered.stream[at].jet = jet;
            check(&altered);
        }
    }
    assert!(refused > 100 && proven > slipping.len(), "{refused} {proven}");
}
