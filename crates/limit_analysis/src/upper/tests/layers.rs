//! Two soils.

use std::f64::consts::PI;

use soilctl_certificate::{Condition, Linear};

use super::bounds;
use super::grounds::{layered, soil};

#[test]
fn layers_of_clay_bear_no_less_than_the_weaker_and_no_more_than_the_stronger() {
    let of = |upper: f64, lower: f64| {
        let s = layered([5.0, 3.0], 0.5, [soil(0.0, upper, 0.3), soil(0.0, lower, 0.6)], Condition::Free);
        bounds(&s, &[600]).pop().unwrap().proven
    };
    let (same, stronger, weaker) = (of(1.0, 1.0), of(1.0, 2.0), of(2.0, 1.0));
    assert!(same > 2.0 + PI && same < 5.25, "{same}");
    assert!(stronger > same && stronger < 2.0 * same, "{stronger}");
    assert!(weaker > same && weaker < 2.0 * same, "{weaker}");
    // The strip may punch through the upper layer.
    assert!(weaker < 2.0 + PI + 2.0 * 2.0 * 0.25 + 0.3, "{weaker}");
}

#[test]
fn a_crust_of_clay_on_sand_and_one_of_sand_on_clay_give_way() {
    let clay = soil(0.0, 1.0, 1.0);
    let sand = soil(30.0, 0.1, 1.0);
    for layers in [[sand.clone(), clay.clone()], [clay, sand]] {
        let found = bounds(&layered([5.0, 3.0], 0.5, layers, Condition::Free), &[700]);
        let proven = found[1].proven;
        assert!(proven > 2.0 && proven < 12.0, "{proven}");
    }
}

#[test]
fn two_sands_slip_along_the_weaker_one() {
    let (weak, strong) = (soil(20.0, 1.0, 0.0), soil(30.0, 1.0, 0.0));
    let of =
        |layers| bounds(&layered([6.0, 3.0], 0.5, layers, Condition::Free), &[600]).pop().unwrap().proven;
    let (low, mixed, high) =
        (of([weak.clone(), weak.clone()]), of([weak, strong.clone()]), of([strong.clone(), strong]));
    assert!(low < mixed && mixed < high, "{low} {mixed} {high}");
}

#[test]
fn a_limit_to_tension_and_cohesion_that_grows_count() {
    let with = |tension, gradient| {
        let mut meshed = soil(20.0, 1.0, 0.0);
        meshed.tension = tension;
        meshed.cohesion = Linear { at_origin: 1.0, gradient: [0.0, gradient] };
        bounds(&layered([6.0, 3.0], 0.5, [meshed.clone(), meshed.clone()], Condition::Free), &[600])
            .pop()
            .unwrap()
            .proven
    };
    let (plain, cut, far) = (with(None, 0.0), with(Some(0.0), 0.0), with(Some(5.0), 0.0));
    // A limit beyond the cone's apex is none.
    assert!(cut <= plain * (1.0 + 1e-5) && far == plain, "{plain} {cut} {far}");
    assert!(with(None, -0.5) > plain);
}

/// Clay on the base, below the mobile zone: it has no way out.
#[test]
fn clay_that_is_enclosed_stays_at_rest() {
    let mut s = layered([5.0, 6.0], 5.5, [soil(30.0, 1.0, 1.0), soil(0.0, 1.0, 1.0)], Condition::Free);
    // Narrow, so that the walls of the zone meet above the clay.
    s.boundaries[0].condition = Condition::Fixed;
    s.boundaries[4].condition = Condition::Fixed;
    let found = bounds(&s, &[]);
    assert!(found[0].proven > 10.0);
}
