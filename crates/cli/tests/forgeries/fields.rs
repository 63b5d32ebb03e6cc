//! Other fields and meshes than those that were found.

use serde_json::{Value, json};

use crate::Expected::{AsBefore, Refused};
use crate::{SIDES, both, finds, scale};

#[test]
fn a_value_at_one_node_is_refused_where_it_matters() {
    let add = |by: f64| {
        move |s: &mut Value| {
            let copies = s["lower"]["field"]["copies"].as_array_mut().unwrap();
            let jets = copies.iter_mut().filter_map(|copy| copy["jet"].get_mut("free"));
            let f = &mut jets.into_iter().nth(50).unwrap()["f"];
            *f = json!(f.as_f64().unwrap() + by);
        }
    };
    finds(add(1.0), [Refused("strength to spare"), AsBefore], &[]);
    // Equilibrium holds by construction, and strength is left for so little.
    finds(add(1e-12), [AsBefore, AsBefore], &[]);
}

#[test]
fn a_flow_turned_round_breaks_the_flow_rule() {
    let forge = |s: &mut Value| {
        for velocity in s["upper"]["field"]["velocities"].as_array_mut().unwrap() {
            for (kind, keys) in [("free", &["x", "y"][..]), ("slide", &["value"])] {
                if let Some(velocity) = velocity.get_mut(kind) {
                    keys.iter().for_each(|key| scale(&mut velocity[key], -1.0));
                }
            }
        }
    };
    finds(forge, [AsBefore, Refused("beyond what the friction demands")], &[]);
}

/// The same change to the meshes of both fields.
fn meshes(change: impl Fn(&mut Value)) -> impl Fn(&mut Value) {
    move |s| SIDES.iter().for_each(|side| change(&mut s[side]["field"]["mesh"]))
}

#[test]
fn meshes_with_triangles_turned_left_out_doubled_or_in_another_soil_are_refused() {
    let turned = meshes(|mesh| mesh["triangles"][5]["corners"].as_array_mut().unwrap().reverse());
    finds(turned, both("not proven to be counter-clockwise"), &[]);
    let pop = |list: &mut Value| drop(list.as_array_mut().unwrap().pop());
    let left_out = |s: &mut Value| {
        meshes(|mesh| pop(&mut mesh["triangles"]))(s);
        [("lower", "corners"), ("lower", "slopes"), ("upper", "flows")]
            .iter()
            .for_each(|(side, list)| pop(&mut s[side]["field"][list]));
    };
    finds(left_out, both("no triangle beyond"), &[]);
    let again = |list: &mut Value| {
        let entry = list[5].clone();
        list.as_array_mut().unwrap().push(entry);
    };
    let doubled = |s: &mut Value| {
        meshes(|mesh| again(&mut mesh["triangles"]))(s);
        [("lower", "corners"), ("lower", "slopes"), ("upper", "flows")]
            .iter()
            .for_each(|(side, list)| again(&mut s[side]["field"][list]));
    };
    finds(doubled, both("the same edge in the same sense"), &[]);
    let other_soil = meshes(|mesh| {
        let triangles = mesh["triangles"].as_array_mut().unwrap();
        triangles.iter_mut().find(|triangle| triangle["region"] == 2).unwrap()["region"] = json!(0);
    });
    finds(other_soil, both("on no loop of its region"), &[]);
    let nowhere = meshes(|mesh| mesh["triangles"][3]["corners"][0] = json!(1_000_000));
    finds(nowhere, both("triangle 3 names vertex 1000000, but there are"), &[]);
}

#[test]
fn a_vertex_pulled_across_its_neighbours_makes_triangles_overlap() {
    let forge = meshes(|mesh| {
        let vertices = mesh["vertices"].as_array_mut().unwrap();
        let inside = vertices.iter_mut().filter(|vertex| vertex["place"] == "inside");
        inside.into_iter().nth(10).unwrap()["position"] = json!([2.9, -1.9]);
    });
    finds(forge, both("not proven to be counter-clockwise"), &[]);
}
