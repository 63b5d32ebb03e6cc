//! Limits that every effect must have, and magnitudes from the literature.

#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use soilctl_earth_pressure::{Case, model};
use soilctl_effects::{
    Active, Base, Channel, DirectMechanics, EffectId, Reading, Reference, Stroke, force_n,
};
use soilctl_strokes::StrokeRow;

fn row(alpha_deg: f64, depth_m: f64) -> StrokeRow {
    StrokeRow {
        batch: Some("b".into()),
        time_s: Some(50.0),
        alpha_deg,
        depth_m,
        width_m: 0.127,
        speed_mps: Some(0.02),
        radius_m: Some(0.4),
        base_deg: Some(20.0),
        gap_prior_m: Some(0.03),
        wall_m: Some(0.05),
        delta_set_deg: Some(23.0),
        force_n: 8.0,
        ..StrokeRow::default()
    }
}

fn reference() -> Reference {
    Reference {
        depth_m: 0.02,
        alpha_deg: 85.0,
        delta_set_deg: Some(23.0),
        speed_mps: Some(0.01),
        time_s: Some((0.0, 100.0)),
        base_deg: Some((-35.0, 35.0)),
        batches: vec!["a".into(), "b".into()],
    }
}

const BASE: Base = Base { phi_deg: 38.0, delta_deg: 23.0, density_kg_m3: 1500.0, gravity_m_s2: 9.806_65 };

fn force(row: &StrokeRow, effects: &[Active]) -> f64 {
    let mechanics = DirectMechanics::new(model("chen").unwrap());
    let reference = reference();
    force_n(&mechanics, &Stroke::new(row, &reference), &reference, &BASE, effects).unwrap()
}

fn ratio(id: EffectId, amplitude: f64, shape: f64, row: &StrokeRow) -> f64 {
    let effect = id.effect();
    force(row, &[Active { effect, amplitude, shape }]) / force(row, &[])
}

#[test]
fn ids_are_those_of_the_catalogue_and_differ() {
    assert_eq!(EffectId::ALL.len(), 28);
    for id in EffectId::ALL {
        assert_eq!(id.effect().id, id, "the definition in the file {id} is of another effect");
        assert_eq!(id.name().parse::<EffectId>().unwrap(), id);
        assert_eq!(serde_json::to_string(&id).unwrap(), format!("\"{id}\""));
    }
    let message = "gremlins".parse::<EffectId>().unwrap_err().to_string();
    assert!(message.starts_with("there is no effect called \"gremlins\"; the effects are "), "{message}");
    assert!(message.ends_with("backdrive_friction, encoder_quantisation"), "{message}");
}

#[test]
fn without_effects_the_force_is_that_of_the_model() {
    let row = row(80.0, 0.02);
    let chen = model("chen").unwrap().predict(&Case::level_deg(80.0, 38.0, 23.0)).unwrap();
    let slant = 0.02 / 80f64.to_radians().sin();
    let expected = 0.5 * 1500.0 * 9.806_65 * slant * slant * 0.127 * chen.k_net().0;
    assert!((force(&row, &[]) / expected - 1.0).abs() < 1e-12);
}

#[test]
fn amplitude_zero_changes_nothing_at_all() {
    for id in EffectId::ALL {
        let effect = id.effect();
        for alpha in [70.0, 85.0, 100.0] {
            let row = row(alpha, 0.015);
            let with = force(&row, &[Active { effect, amplitude: 0.0, shape: effect.shapes()[0] }]);
            assert_eq!(with.to_bits(), force(&row, &[]).to_bits(), "{id}");
        }
    }
}

#[test]
fn effects_of_the_arm_leave_the_force_alone() {
    for effect in EffectId::ALL.map(EffectId::effect).into_iter().filter(|effect| !effect.acts_on_force()) {
        let active = Active { effect, amplitude: effect.range.typical(), shape: 0.0 };
        assert_eq!(force(&row(80.0, 0.02), &[active]), force(&row(80.0, 0.02), &[]));
        assert!(!effect.linked.is_empty(), "{} shows nowhere", effect.id);
    }
}

#[test]
fn magnitudes_are_those_of_the_literature() {
    // About 5 % of force a degree of slope, up the slope (Hong 2001, section 6.7).
    let up = ratio(EffectId::SurfaceSlope, 1.0, 20.0, &row(80.0, 0.02));
    assert!((1.03..1.08).contains(&up), "{up}");
    assert!(ratio(EffectId::SurfaceSlope, 1.0, -160.0, &row(80.0, 0.02)) < 1.0);
    // Rowe & Peaker (1965): what is missing is missing where failure is gradual, at high tool angles.
    let gradual = ratio(EffectId::ProgressiveFailure, 0.1, 85.0, &row(100.0, 0.02));
    assert!((gradual - 0.9).abs() < 1e-3);
    assert!(ratio(EffectId::ProgressiveFailure, 0.1, 85.0, &row(70.0, 0.02)) > 0.999);
    // Depth enters squared.
    let deep = ratio(EffectId::DepthOffset, 0.002, 0.0, &row(90.0, 0.02));
    assert!((deep - 1.1_f64.powi(2)).abs() < 1e-12);
    // A wedge under a surcharge weighs 1 + 2 q / (gamma H) times as much; a log-spiral feels the top of it less.
    let heap = ratio(EffectId::SurchargeHeap, 20.0, 0.0, &row(90.0, 0.02));
    let wedge = 2.0 * 20.0 / (1500.0 * 9.806_65 * 0.02);
    assert!((0.8..=1.0).contains(&((heap - 1.0) / wedge)), "{heap}");
    // One decade in depth is one decade of the weight's share in stress.
    let shallow = ratio(EffectId::StressDependentFriction, 4.0, 0.0, &row(85.0, 0.002));
    let lower = ratio(EffectId::StressDependentFriction, 4.0, 0.0, &row(85.0, 0.2));
    assert!(shallow > 1.2 && lower < 0.85);
}

#[test]
fn heaps_and_zeros_show_in_their_channels() {
    let reference = reference();
    let stroke = Stroke::new(&row(80.0, 0.02), &reference);
    let reading = Reading {
        stroke: &stroke,
        force_n: 8.0,
        delta_deg: 23.0,
        unit_weight_n_m3: 15_000.0,
        encoder_step_m: 0.001,
    };
    let shift = |id: EffectId, channel, amplitude| id.effect().shift(channel, amplitude, 0.0, &reading);
    assert!((shift(EffectId::SurchargeHeap, Channel::HeapHeight, 15.0) - 0.001).abs() < 1e-15);
    assert_eq!(shift(EffectId::ForceBias, Channel::TareAfter, -0.3), -0.3);
    assert_eq!(shift(EffectId::ForceDrift, Channel::TareBefore, 0.4), 0.2);
    assert_eq!(shift(EffectId::CableFlex, Channel::Displacement, 5e-4), 4e-3);
    assert!(shift(EffectId::FtCrosstalk, Channel::FrictionAngle, 0.05) > 2.0);
}

proptest! {
    #[test]
    fn plausible_amplitudes_leave_a_finite_force(
        which in 0..EffectId::ALL.len(), size in 0.0..1.0_f64, alpha in 70.0..100.0_f64, depth in 0.012..0.03_f64, shape in 0..8_usize,
    ) {
        let effect = EffectId::ALL[which].effect();
        let (range, shapes) = (effect.range, effect.shapes());
        for sign in range.signs() {
            let amplitude = sign * range.low * (range.high / range.low).powf(size);
            let active = Active { effect, amplitude, shape: shapes[shape % shapes.len()] };
            let force = force(&row(alpha, depth), &[active]);
            prop_assert!(force > 0.0 && force.is_finite());
        }
    }
}

/// The table of `docs/diagnosis.md` says of each effect where it acts, what its amplitude is called and in which range.
#[test]
fn the_documentation_has_every_effect() {
    let text = include_str!("../../../docs/diagnosis.md");
    for id in EffectId::ALL {
        let effect = id.effect();
        let shape = effect.shape.and_then(|shape| shape.parameter).map(|parameter| parameter.name);
        let names: Vec<String> =
            std::iter::once(effect.parameter.name).chain(shape).map(|name| format!("`{name}`")).collect();
        let (low, high) = (effect.range.low, effect.range.high);
        let row = format!("| `{id}` | {} | {} | {low} to {high} | ", effect.site.name(), names.join(", "));
        assert!(text.contains(&row), "docs/diagnosis.md lacks the row {row}");
    }
}
