//! Another problem than the one that was solved.

use serde_json::{Value, json};

use crate::Expected::{AsBefore, Other, Refused};
use crate::{both, boundary, certify, finds, honest, scale, soil};

#[test]
fn soil_said_to_be_stronger_keeps_the_lower_bound_and_is_named() {
    let forge = |s: &mut Value| {
        for region in 0..2 {
            soil(s, region)["phi_deg"] = json!(45.0);
            scale(&mut soil(s, region)["cohesion"]["at_origin"], 2.0);
        }
    };
    finds(forge, [AsBefore, Refused("dilation beyond what the friction demands")], &["friction 45 deg"]);
}

#[test]
fn clay_said_to_be_weaker_keeps_an_upper_bound_for_that_clay() {
    let forge = |s: &mut Value| soil(s, 2)["cohesion"]["at_origin"] = json!(0.078125);
    // Less is dissipated, in the same flow.
    let found = [Refused("strength to spare"), Other(0.1, 1.0)];
    finds(forge, found, &["friction 0 deg, cohesion 0.078125"]);
}

#[test]
fn negative_cohesion_is_no_soil() {
    let forge = |s: &mut Value| scale(&mut soil(s, 2)["cohesion"]["at_origin"], -1.0);
    finds(forge, both("cohesion at a corner of region 2"), &[]);
}

#[test]
fn another_weight_is_named_and_its_flow_bounds_another_force() {
    let forge = |s: &mut Value| (0..3).for_each(|region| scale(&mut soil(s, region)["unit_weight"], 2.0));
    // Twice the weight is lifted beside the footing, and twice as much sinks under it.
    finds(forge, [Refused("strength to spare"), Other(1.0, 2.0)], &["unit weight 2"]);
}

#[test]
fn water_left_out_is_not_shown_and_more_of_it_is() {
    let dry = |s: &mut Value| {
        for region in 1..3 {
            soil(s, region).as_object_mut().unwrap().remove("pore_pressure");
        }
    };
    let answer = finds(dry, [AsBefore, Other(1.0, 1.1)], &[]);
    assert!(!answer["statement"].to_string().contains("pore pressure"));
    let wet = |s: &mut Value| {
        for region in 1..3 {
            soil(s, region)["pore_pressure"]["at_origin"] = json!(0.75);
        }
    };
    finds(wet, [Refused("strength to spare"), Other(0.5, 1.0)], &["pore pressure 0.75 + 0 x"]);
}

#[test]
fn a_greater_load_beside_is_named_and_bears_down_on_what_rises() {
    let forge = |s: &mut Value| boundary(s, "loaded")["condition"]["loaded"]["pressure"] = json!([2.5, 3.5]);
    finds(forge, [Refused("strength to spare"), Other(1.0, 2.0)], &["loaded: pressure 2.5 to 3.5"]);
}

#[test]
fn a_load_marked_live_is_not_what_is_bounded_unless_loads_are() {
    let forge = |s: &mut Value| boundary(s, "loaded")["condition"]["loaded"]["live"] = json!(true);
    let answer = finds(forge, [AsBefore, AsBefore], &["loaded: pressure"]);
    assert!(!answer["statement"].to_string().contains("the load that is bounded"));
    let forge = |s: &mut Value| {
        boundary(s, "loaded")["condition"]["loaded"]["live"] = json!(true);
        s["statement"]["objective"] = json!("loads");
    };
    let no_work = Refused("the load whose factor is bounded is not proven to do work on it");
    // The file has no factor, so none is proven.
    let lower = Refused("strength to spare");
    finds(forge, [lower, no_work], &["the load that is bounded: pressure", "the factor on the loads"]);
}

#[test]
fn a_surcharge_is_named_and_never_negative() {
    let forge = |s: &mut Value| s["statement"]["surcharge"] = json!(1.0);
    finds(forge, [Refused("strength to spare"), Other(1.0, 2.0)], &["pressure 1, level at y = 0"]);
    let forge = |s: &mut Value| s["statement"]["surcharge"] = json!(-1.0);
    finds(forge, both("surcharge of the statement is -1 stress"), &[]);
}

#[test]
fn gravity_that_leans_or_lifts_is_refused_or_named() {
    let forge = |s: &mut Value| s["statement"]["gravity"] = json!([0.25, -1.0]);
    let found = [Refused("different unit weight where gravity is not vertical"), Other(0.5, 1.5)];
    finds(forge, found, &["(0.25, -1) along (x, y)"]);
    let forge = |s: &mut Value| s["statement"]["gravity"] = json!([0.0, 1.0]);
    finds(forge, both("gravity along y of the statement is 1"), &[]);
}

#[test]
fn the_objective_is_that_of_the_statement_whatever_was_solved() {
    let forge = |s: &mut Value| s["statement"]["objective"]["structure"]["velocity"] = json!([0.0, 1.0]);
    // The stresses press upwards on the footing with what they pressed downwards; the flow opens a gap that was not there.
    finds(forge, [Other(-1.0 - 1e-12, -1.0 + 1e-12), Other(-1.0, 2.0)], &["its velocity (0, 1)"]);
    let forge = |s: &mut Value| s["statement"]["objective"] = json!("everything");
    let words = Refused("its factor on everything that acts must be above zero");
    finds(forge, [words, Refused("is not proven to do work on it")], &["the factor on all that acts"]);
}

#[test]
fn other_boundary_conditions_are_named_or_do_not_fit_the_fields() {
    let forge = |s: &mut Value| boundary(s, "fixed")["condition"] = json!("free");
    let found = [Refused("one for each run of free or loaded boundary"), Refused("one for each wall")];
    finds(forge, found, &["left of (-3, -2) to (3, -2): free"]);
    let rough = json!({"face": {"delta_deg": 35.0, "adhesion": 9.0}});
    let forge = |s: &mut Value| boundary(s, "face")["condition"] = rough.clone();
    let found = [AsBefore, Refused("opening beyond what the friction demands")];
    finds(forge, found, &["face of the structure, friction 35 deg, adhesion 9"]);
    let forge = |s: &mut Value| {
        let twice = boundary(s, "fixed").clone();
        s["statement"]["boundaries"].as_array_mut().unwrap().push(twice);
    };
    finds(forge, both("two boundary conditions on one side"), &[]);
    let forge = |s: &mut Value| {
        s["statement"]["boundaries"].as_array_mut().unwrap().retain(|entry| entry["condition"] != "fixed");
    };
    finds(forge, both("needs a boundary condition"), &[]);
}

#[test]
fn ground_moved_under_the_mesh_does_not_fit_it() {
    // The right end of the footing, and the lines that meet there.
    let forge = |s: &mut Value| {
        let points = s["statement"]["points"].as_array_mut().unwrap();
        *points.iter_mut().find(|point| **point == json!([0.5, 0.0])).unwrap() = json!([0.625, 0.0]);
    };
    finds(forge, both("the mesh does not fit the regions"), &["(0.625, 0)"]);
}

#[test]
fn loops_that_do_not_close_overlap_or_are_missing_are_no_regions() {
    let outline = |change: fn(&mut Vec<Value>)| {
        move |s: &mut Value| change(s["statement"]["regions"][2]["loops"].as_array_mut().unwrap())
    };
    let open = outline(|loops| drop(loops[0].as_array_mut().unwrap().pop()));
    finds(open, both("each line must end where the next one starts"), &[]);
    let twice = outline(|loops| loops.extend(loops.first().cloned()));
    finds(twice, both("used twice by loops"), &[]);
    finds(outline(Vec::clear), both("region 2: has no loop"), &[]);
    let crossed = |s: &mut Value| {
        s["statement"]["lines"].as_array_mut().unwrap().push(json!({"from": 3, "to": 10}));
    };
    finds(crossed, both("cross, touch or overlap"), &[]);
}

/// Work must not grow with the square of what a file says.
#[test]
fn four_hundred_thousand_empty_regions_are_refused_at_once() {
    let file = honest().to_string();
    let empty = r#"{"loops":[],"material":{"phi_deg":1.0,"cohesion":{"at_origin":1.0},"unit_weight":9.0}},"#;
    let key = r#""regions":["#;
    let (code, answer, _) = certify(&file.replacen(key, &(key.to_owned() + &empty.repeat(400_000)), 1));
    assert_eq!(code, 1);
    assert!(answer["lower"]["refusal"].as_str().unwrap().contains("region 0: has no loop"), "{answer}");
    assert!(answer["statement"].to_string().contains("and 399963 more"));
}

#[test]
fn plane_fields_prove_nothing_about_a_structure_with_ends() {
    let forge = |s: &mut Value| s["statement"]["width"] = json!(3.0);
    let upper = Refused("a flow in the plane proves nothing about a structure with ends");
    finds(forge, [Refused("with a width there is one soil only"), upper], &["the structure is 3 wide"]);
    let blocks = json!({"field": {"vertices": [], "velocities": [], "facets": []}, "claimed": 1.0});
    let forge = |s: &mut Value| s["mechanism"] = blocks.clone();
    finds(forge, [AsBefore, Refused("of which only one can be meant")], &["plane strain"]);
}
