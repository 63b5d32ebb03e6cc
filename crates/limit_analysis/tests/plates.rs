//! Bounds on embedded plates against exact solutions and closed-form upper bounds.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_certificate::{prove_lower, prove_upper};
use soilctl_earth_pressure::{Case, ChenLiu, Coulomb, ForceModel};
use soilctl_limit_analysis::{
    Bounds, Description, EmbeddedPlate, Ended, LimitError, Options, Problem, Solve, bound,
};

/// A few coarse levels, however slow the machine.
fn coarse(max_elements: usize) -> Options {
    Options { max_gap: 1e-6, max_work: u64::MAX, max_elements, ..Options::default() }
}

fn solve(plate: &EmbeddedPlate, options: &Options) -> Bounds {
    bound(&plate.problem().unwrap(), options, &mut |_, _| {}).unwrap()
}

/// Net coefficients per slant length.
fn coefficients(plate: &EmbeddedPlate, bounds: &Bounds) -> [f64; 2] {
    let factor = 2.0 / (plate.alpha_deg + plate.delta_deg).to_radians().sin();
    [factor * bounds.lower.value, factor * bounds.upper.value]
}

#[test]
#[ignore = "minutes: cargo xtask verify"]
fn exact_smooth_upright_plate_is_rankines_wall_on_both_sides() {
    for phi_deg in [20.0_f64, 30.0, 45.0] {
        let plate = EmbeddedPlate { phi_deg, ..EmbeddedPlate::default() };
        let bounds = solve(&plate, &coarse(2500));
        let sin = phi_deg.to_radians().sin();
        let exact = (1.0 + sin) / (1.0 - sin) - (1.0 - sin) / (1.0 + sin);
        let [lower, upper] = coefficients(&plate, &bounds);
        assert!(lower <= exact && exact <= upper, "phi {phi_deg}: {lower} {exact} {upper}");
        assert!(bounds.gap() < 0.02, "phi {phi_deg}: gap {}", bounds.gap());
    }
}

#[test]
fn cohesion_and_surcharge_add_what_rankine_says() {
    let (phi_deg, cohesion, surcharge) = (30.0_f64, 0.2, 0.5);
    let plate = EmbeddedPlate { phi_deg, cohesion, surcharge, ..EmbeddedPlate::default() };
    let bounds = solve(&plate, &coarse(2500));
    let sin = phi_deg.to_radians().sin();
    let passive = (1.0 + sin) / (1.0 - sin);
    let active = 1.0 / passive;
    // Half the unit weight, the surcharge, and cohesion on both sides, over unit height; compression everywhere.
    let at_top = active * surcharge - 2.0 * cohesion * active.sqrt();
    let exact = (passive - active) * (0.5 + surcharge) + 2.0 * cohesion * (passive.sqrt() + active.sqrt());
    assert!(at_top < 0.0, "the top of the active side would be in tension: the plate lets go of it there");
    // Where the soil behind stands by itself, the plate is pulled less than Rankine's tension would say.
    assert!(bounds.lower.value <= exact, "{} {exact}", bounds.lower.value);
    assert!(bounds.upper.value >= exact - 0.5 * at_top * at_top / active - 1e-9);
    assert!(bounds.gap() < 0.03, "gap {}", bounds.gap());
}

#[test]
fn closed_form_mechanisms_are_never_below_the_lower_bound() {
    for (alpha_deg, phi_deg, delta_deg) in [(70.0, 25.0, 10.0), (90.0, 40.0, 25.0), (100.0, 50.0, 30.0)] {
        let plate = EmbeddedPlate { alpha_deg, phi_deg, delta_deg, ..EmbeddedPlate::default() };
        let bounds = solve(&plate, &coarse(1500));
        let [lower, upper] = coefficients(&plate, &bounds);
        let case = Case::level_deg(alpha_deg, phi_deg, delta_deg);
        let chen = ChenLiu.predict(&case).unwrap().k_net().0;
        assert!(lower <= chen, "alpha {alpha_deg}: lower {lower}, Chen & Liu {chen}");
        assert!(lower < upper);
        if let Ok(coulomb) = Coulomb.predict(&case) {
            assert!(lower <= coulomb.k_net().0);
        }
    }
}

/// They had no upper bound: a guide ahead of the face cut off a wedge that could not move.
#[test]
fn plates_that_lean_forward_in_soil_of_much_friction_have_both_bounds() {
    let plate = EmbeddedPlate { alpha_deg: 50.0, phi_deg: 44.0, delta_deg: 20.0, ..EmbeddedPlate::default() };
    let bounds = solve(&plate, &coarse(1200));
    assert!(bounds.gap() < 0.05, "gap {}", bounds.gap());
}

/// A rough strip on weightless soil of 40 deg, half of it: `N_c / 2 = 37.66` (Prandtl). The solver fails on its first meshes
/// with the regularisation that is best for others.
#[test]
fn no_level_of_a_rough_footing_is_lost() {
    let text = r#"
        default_boundary = "free"
        objective = { kind = "structure", name = "strip", direction = [0, -1] }
        soil = [{ name = "soil", phi_deg = 40, cohesion_kpa = 1, unit_weight_kn_m3 = 0 }]
        region = [{ soil = "soil", polygon = [[0, -24], [40, -24], [40, 0], [0, 0]] }]
        boundary = [{ kind = "fixed", sides = ["bottom", "right"] }, { kind = "symmetric", sides = ["left"] }]
        structure = [{ name = "strip", edge = [[0, 0], [0.5, 0]], delta_deg = 40, adhesion_kpa = 1 }]
    "#;
    let described = Description::from_toml(text).unwrap().described().unwrap();
    let bounds = bound(&described.problem().unwrap(), &coarse(1500), &mut |_, _| {}).unwrap();
    assert!(bounds.levels.len() > 1 && bounds.levels.iter().all(|level| level.upper.proven.is_some()));
    let [lower, upper] = described.in_units([bounds.lower.value, bounds.upper.value]);
    let phi = 40.0_f64.to_radians();
    let n_q = (std::f64::consts::PI * phi.tan()).exp() * (1.0 + phi.sin()) / (1.0 - phi.sin());
    let exact = 0.5 * (n_q - 1.0) / phi.tan();
    assert!(lower <= exact && exact <= upper, "{lower} {exact} {upper}");
}

#[test]
fn what_is_reported_is_what_the_checker_proves_and_shares_add_up_to_the_gap() {
    let plate = EmbeddedPlate { alpha_deg: 80.0, delta_deg: 15.0, beta_deg: 5.0, ..EmbeddedPlate::default() };
    let problem = plate.problem().unwrap();
    let bounds = solve(&plate, &coarse(2500));
    assert_eq!(prove_lower(problem.statement(), &bounds.lower.field).unwrap(), bounds.lower.value);
    assert_eq!(prove_upper(problem.statement(), &bounds.upper.field).unwrap(), bounds.upper.value);
    for level in &bounds.levels {
        let [gap, sum] = level.identity.unwrap();
        assert!((gap - sum).abs() < 1e-6 * gap, "{gap} {sum}");
    }
}

#[test]
fn bits_do_not_depend_on_threads() {
    let plate = EmbeddedPlate { phi_deg: 35.0, delta_deg: 10.0, ..EmbeddedPlate::default() };
    let one = solve(&plate, &coarse(2500));
    for threads in [2, 4] {
        let more = solve(&plate, &Options { threads, ..coarse(2500) });
        assert_eq!(one.lower.value.to_bits(), more.lower.value.to_bits());
        assert_eq!(one.upper.value.to_bits(), more.upper.value.to_bits());
        assert_eq!(one.lower.field, more.lower.field);
        assert_eq!(one.upper.field, more.upper.field);
    }
}

/// The last upper bound may bring the gap by itself; then there is no lower bound beside it, begun on another thread or not.
#[test]
fn bits_do_not_depend_on_threads_where_one_bound_is_enough() {
    let plate = EmbeddedPlate { phi_deg: 35.0, delta_deg: 10.0, ..EmbeddedPlate::default() };
    let mut alone = 0;
    for max_gap in [0.1, 0.05, 0.03] {
        let at = |threads| solve(&plate, &Options { threads, max_gap, ..coarse(4000) });
        let (one, two) = (at(1), at(2));
        assert!(one.ended == Ended::Gap && one.gap() <= max_gap, "{max_gap}: {:?} {}", one.ended, one.gap());
        // All but the seconds.
        let of = |bounds: &Bounds| -> Vec<_> {
            let solve = |solve: &Solve| (solve.elements, solve.proven.map(f64::to_bits));
            bounds.levels.iter().map(|level| (solve(&level.upper), level.lower.as_ref().map(solve))).collect()
        };
        assert_eq!(of(&one), of(&two));
        assert_eq!((one.lower.field, one.upper.field), (two.lower.field, two.upper.field));
        alone += usize::from(one.levels.last().is_some_and(|level| level.lower.is_none()));
    }
    assert!(alone > 0);
}

#[test]
fn statements_that_name_no_line_or_have_no_weight_are_refused() {
    let statement = EmbeddedPlate::default().problem().unwrap().statement().clone();
    let mut nowhere = statement.clone();
    nowhere.boundaries[0].line = 99;
    let mut upwards = statement.clone();
    upwards.gravity = [0.0, 1.0];
    for bad in [nowhere, upwards] {
        assert!(matches!(Problem::new(bad), Err(LimitError::Range { .. })));
    }
    let mut weightless = statement;
    weightless.gravity = [0.0, 0.0];
    let error = bound(&Problem::new(weightless).unwrap(), &coarse(1000), &mut |_, _| {}).unwrap_err();
    assert!(matches!(error, LimitError::NoCollapse { .. }), "{error}");
}

#[test]
fn numbers_out_of_range_are_refused() {
    let good = EmbeddedPlate::default();
    let bad = [
        EmbeddedPlate { phi_deg: 0.0, ..good },
        EmbeddedPlate { phi_deg: 90.0, ..good },
        EmbeddedPlate { phi_deg: f64::NAN, ..good },
        EmbeddedPlate { delta_deg: 31.0, ..good },
        EmbeddedPlate { delta_deg: -1.0, ..good },
        EmbeddedPlate { alpha_deg: f64::INFINITY, ..good },
        EmbeddedPlate { beta_deg: 30.0, ..good },
        EmbeddedPlate { cohesion: -1.0, ..good },
        EmbeddedPlate { alpha_deg: 150.0, phi_deg: 40.0, delta_deg: 30.0, ..good },
    ];
    for plate in bad {
        assert!(matches!(plate.problem(), Err(LimitError::Range { .. })), "{plate:?}");
    }
    let glued = EmbeddedPlate { adhesion: 0.1, ..good };
    assert!(matches!(glued.problem(), Err(LimitError::NotCovered { .. })));
}

#[test]
fn linear_programs_prove_wider_bounds() {
    let plate = EmbeddedPlate { phi_deg: 30.0, delta_deg: 15.0, ..EmbeddedPlate::default() };
    let cones = solve(&plate, &coarse(700));
    let pyramids = solve(&plate, &Options { segments: Some(12), ..coarse(700) });
    assert!(pyramids.lower.value < cones.lower.value && pyramids.lower.value > 0.9 * cones.lower.value);
    assert!(pyramids.upper.value > cones.upper.value && pyramids.upper.value < 1.1 * cones.upper.value);
}
