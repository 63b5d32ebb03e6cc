//! Fields whose forces are known.

use super::Small;
use super::small::ground;
use crate::examples::{Plate, rankine_field};
use crate::{
    CertificateError, Claim, EndForce, Objective, SCHEMA, Scale, Solution, SpaceStress, check_lower, prove,
    prove_end, prove_space,
};

/// More pressure ahead of the plate than behind: what is at first not balanced.
fn pushed(by: f64) -> SpaceStress {
    Small::new(true).field(&ground(1.0 + by, 1.0), &ground(1.0 - by, 1.0))
}

#[test]
fn the_ground_at_rest_presses_alike_on_both_sides() {
    for (x, s) in [(1.0, 1.0), (2.5, 1.0), (0.5, 1.0), (1.2, 0.6), (0.6, 1.5)] {
        let field = Small::new(true).field(&ground(x, s), &ground(x, s));
        let EndForce { reach, end, between } = prove_end(30.0, 15.0, &field).unwrap();
        assert_eq!(reach, 0.5);
        // Zero, but for what rounding may add to the balances.
        assert!((-1e-10..=0.0).contains(&end) && (-1e-10..=0.0).contains(&between), "{end} {between}");
    }
}

#[test]
fn what_the_soil_does_not_bear_is_refused() {
    // `K` is 3: between the limits and outside.
    let small = Small::new(true);
    for (x, s, bears) in [
        (2.99, 1.0, true),
        (3.01, 1.0, false),
        (0.34, 1.0, true),
        (0.33, 1.0, false),
        (2.0, 0.7, true),
        (2.0, 0.66, false),
    ] {
        let proven = prove_end(30.0, 15.0, &small.field(&ground(x, s), &ground(x, s)));
        assert_eq!(proven.is_ok(), bears, "{x} {s} {proven:?}");
    }
}

#[test]
fn a_push_is_worth_something_and_holds_for_all_widths() {
    let force = prove_end(30.0, 15.0, &pushed(0.1)).unwrap();
    assert!(force.end > 0.003 && force.between > 0.01, "{force:?}");
    assert_eq!(force.per_width(0.99), None);
    assert_eq!(force.per_width(f64::NAN), None);
    let expected = |width: f64| (2.0 * force.end + (width - 1.0) * force.between) / width;
    for width in [1.0, 2.0, 1e3] {
        let proven = force.per_width(width).unwrap();
        assert!(proven <= expected(width) + 1e-15 && proven > expected(width) - 1e-12);
    }
    // The other way round there is nothing to gain.
    assert!(prove_end(30.0, 15.0, &pushed(-0.1)).unwrap().end < 0.0);
}

#[test]
fn a_statement_has_its_own_units() {
    // Two deep, of soil with 35 degrees.
    let plate = Plate { lean: 0.0, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let statement = plate.statement().with_width(6.0);
    let field = pushed(0.1);
    let force = prove_end(35.0, 20.0, &field).unwrap().per_width(3.0).unwrap();
    let weight = statement.regions[0].material.unit_weight;
    let proven = prove_space(&statement, &field).unwrap();
    assert!((proven - 4.0 * weight * force).abs() < 1e-12, "{proven} {force}");
    // To the left, twice as fast.
    let mut left = statement.clone();
    left.objective = Objective::Structure { velocity: [-2.0, 0.0] };
    assert!((prove_space(&left, &field).unwrap() - 2.0 * proven).abs() < 1e-12);
    left.objective = Objective::Structure { velocity: [1.0, 0.1] };
    assert!(matches!(prove_space(&left, &field), Err(CertificateError::NotCovered { .. })));
    let narrow = prove_space(&plate.statement().with_width(1.9), &field);
    assert!(matches!(narrow, Err(CertificateError::NotCovered { .. })), "{narrow:?}");
    for other in [
        Plate { lean: 0.1, ..plate },
        Plate { surcharge: 0.1, ..plate },
        Plate { gravity: [0.1, -1.0], ..plate },
    ] {
        let refused = prove_space(&other.statement().with_width(6.0), &field);
        assert!(matches!(refused, Err(CertificateError::NotCovered { .. })), "{refused:?}");
    }
    assert!(prove_space(&plate.statement(), &field).is_err());
}

#[test]
fn a_smooth_plate_bears_no_shear() {
    assert!(prove_end(30.0, 0.0, &pushed(0.1)).is_ok());
}

#[test]
fn a_solution_has_it_alone_or_beside_one_in_the_plane() {
    let plate = Plate { lean: 0.0, delta_deg: 20.0, surcharge: 0.0, gravity: [0.0, -1.0] };
    let (statement, field) = (plate.statement().with_width(6.0), pushed(0.1));
    let proven = prove_space(&statement, &field).unwrap();
    let mut solution = Solution {
        schema: SCHEMA.into(),
        program: "test 0".into(),
        statement,
        scale: Scale::default(),
        lower: None,
        upper: None,
        mechanism: None,
        space: Some(Claim { field, claimed: proven, computed: None }),
    };
    let text = serde_json::to_string(&solution).unwrap();
    assert_eq!(serde_json::from_str::<Solution>(&text).unwrap(), solution);
    assert_eq!(prove(&solution).unwrap().lower.unwrap().proven, proven);
    // One that is not proven spoils the other, whatever it claims.
    solution.lower = Some(Claim { field: rankine_field(4, 2.9), claimed: 0.0, computed: None });
    let checked = check_lower(&solution).unwrap();
    assert!(checked.claimed == proven && checked.proven.is_err(), "{checked:?}");
}
