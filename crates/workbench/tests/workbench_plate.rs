//! The plate's bench: forces against Rankine's closed form and the use case `predict`, bands and regions against theirs, and what is refused.
#![allow(clippy::unwrap_used)]

mod common;

use std::f64::consts::FRAC_PI_4;
use std::sync::Mutex;

use common::{Page, workbench};
use serde_json::{Value, json};
use soilctl_app::request::{Ends, NumberOrColumn};
use soilctl_app::{Unwatched, estimate, predict};
use soilctl_workbench::Desk;

/// What the desk of the test that holds the lock has told.
static TOLD: Mutex<Vec<Value>> = Mutex::new(Vec::new());
static ONE: Mutex<()> = Mutex::new(());
const GRAVITY: f64 = 9.80665;

fn tell(message: String) {
    TOLD.lock().unwrap().push(serde_json::from_str(&message).unwrap());
}

/// The answer of a desk to a message.
fn ask(message: &Value) -> Value {
    let _one = ONE.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let mut desk = Desk::open(tell);
    desk.obey(&message.to_string());
    TOLD.lock().unwrap().pop().unwrap()
}

fn plate(change: &Value) -> Value {
    let mut given = json!({
        "alpha_deg": 80, "beta_deg": 0, "depth_m": 0.05, "width_m": 0.127, "phi_deg": 40, "delta_deg": 20, "density_kg_m3": 1450,
        "cohesion_pa": 0, "adhesion_pa": 0, "surcharge_pa": 0, "gravity_m_s2": GRAVITY, "slow": false,
    });
    let (given_keys, change) = (given.as_object_mut().unwrap(), change.as_object().unwrap());
    given_keys.extend(change.iter().map(|(key, value)| (key.clone(), value.clone())));
    json!({"type": "plate", "id": 3, "plate": given})
}

fn strokes(csv: &str, change: &Value) -> Value {
    let mut given = json!({
        "csv": csv, "model": "coulomb", "delta_deg": 0, "delta_tol_deg": 0, "density_kg_m3": null, "density_tol": 0.04,
        "force_limit_n": null,
    });
    let (given_keys, change) = (given.as_object_mut().unwrap(), change.as_object().unwrap());
    given_keys.extend(change.iter().map(|(key, value)| (key.clone(), value.clone())));
    json!({"type": "strokes", "id": 4, "strokes": given})
}

fn pair(value: &Value) -> [f64; 2] {
    [0, 1].map(|k| value[k].as_f64().unwrap())
}

/// Passive minus active pressure on a smooth upright wall (Rankine 1857).
fn rankine(phi_deg: f64) -> f64 {
    let half = phi_deg.to_radians() / 2.0;
    (FRAC_PI_4 + half).tan().powi(2) - (FRAC_PI_4 - half).tan().powi(2)
}

/// A smooth upright plate needs what Rankine says, by every model of plane strain that is no table; the bracket holds it.
#[test]
fn a_smooth_upright_plate_is_rankines() {
    let shown = ask(&plate(&json!({"alpha_deg": 90, "delta_deg": 0})))["shown"].take();
    let force = 0.5 * 1450.0 * GRAVITY * 0.05 * 0.05 * 0.127 * rankine(40.0);
    let models = shown["models"].as_array().unwrap();
    let mut exact = 0;
    for model in models.iter().filter(|model| model["ends"] == "none" && model["force_n"].is_array()) {
        let [low, high] = pair(&model["force_n"]);
        match model["id"].as_str().unwrap() {
            "coulomb" | "log-spiral" | "chen" => {
                assert!((low / force - 1.0).abs() < 1e-3 && low == high, "{model}");
                exact += 1;
            }
            "table" => assert!(low <= force && force <= high && high < 1.02 * low, "{model}"),
            _ => assert!((low / force - 1.0).abs() < 0.25, "{model}"),
        }
    }
    assert_eq!(exact, 3);
    // What it bears straight on is the same.
    let first = &shown["borne"][0]["points"][0];
    assert!(first[0] == 0.0 && first[1].as_f64().unwrap() <= force && force <= first[2].as_f64().unwrap());
    // Ends only add.
    let of = |ends: &str| models.iter().find(|m| m["id"] == "table" && m["ends"] == ends).unwrap();
    assert!(pair(&of("finite")["force_n"])[1] > pair(&of("none")["force_n"])[1]);
}

/// Each number is that of `soilctl predict`, and each refusal its words.
#[test]
fn forces_and_refusals_are_those_of_the_use_case() {
    for (change, cohesion_pa) in [(json!({"slow": true}), 0.0), (json!({"cohesion_pa": 100.0}), 100.0)] {
        let shown = ask(&plate(&change))["shown"].take();
        let models = shown["models"].as_array().unwrap();
        for model in models.iter().filter(|model| model["is_left_out"] == false) {
            let mut request = predict::Request {
                model: model["id"].as_str().unwrap().into(),
                alpha_deg: Some(80.0),
                phi_deg: Some(40.0),
                delta_deg: Some(NumberOrColumn::Number(20.0)),
                density_kg_m3: Some(NumberOrColumn::Number(1450.0)),
                depth_m: Some(0.05),
                width_m: Some(0.127),
                ends: Some(if model["ends"] == "none" { Ends::None } else { Ends::Finite }),
                ..predict::Request::default()
            };
            request.loads.cohesion_pa = cohesion_pa;
            match predict::run(&request, &Unwatched) {
                Ok(found) => {
                    let [low, high] = pair(&model["force_n"]);
                    let force = found.force_n.unwrap();
                    match (found.k_net_lower, found.k_net_upper) {
                        (Some(lower), Some(upper)) => {
                            assert_eq!(pair(&model["k_net"]), [lower, upper]);
                            assert!(((low * high).sqrt() / force - 1.0).abs() < 1e-9);
                        }
                        _ => assert!((low / force - 1.0).abs() < 1e-12 && low == high, "{model}"),
                    }
                }
                Err(problem) => assert_eq!(model["error"], problem.to_string()),
            }
        }
        let left_out = models.iter().filter(|model| model["is_left_out"] == true).count();
        assert_eq!(left_out, usize::from(cohesion_pa > 0.0));
        let refused = models.iter().filter(|model| model["error"].is_string()).count();
        assert!(refused > 0 || cohesion_pa == 0.0);
    }
}

/// A slip line runs from the plate's lower edge to the surface, and Coulomb's is the plane that the closed form has.
#[test]
fn slip_lines_end_at_the_surface() {
    let shown = ask(&plate(&json!({"alpha_deg": 90, "delta_deg": 0, "beta_deg": 0})))["shown"].take();
    assert!((pair(&shown["top_m"])[1] - 0.05).abs() < 1e-12);
    for model in shown["models"].as_array().unwrap() {
        let Some(points) = model["surface_m"].as_array() else { continue };
        assert!(pair(&points[0]).iter().all(|x| x.abs() < 1e-9), "{model}");
        let [x, y] = pair(points.last().unwrap());
        assert!((y - 0.05).abs() < 1e-9, "{model}");
        // At 45 deg less half the friction angle, in front of a smooth upright plate.
        if model["id"] == "coulomb" {
            assert!((y.atan2(x).to_degrees() - 25.0).abs() < 1e-6, "{model}");
        }
    }
}

#[test]
fn what_no_plate_has_is_refused_in_words() {
    for (change, words) in [
        (json!({"depth_m": 0}), "depth"),
        (json!({"density_kg_m3": -1}), "density"),
        (json!({"surcharge_pa": -1}), "surcharge"),
        (json!({"alpha_deg": 200}), "alpha"),
    ] {
        let told = ask(&plate(&change));
        assert!(told["error"]["words"].as_str().unwrap().contains(words), "{told}");
        assert!(told["shown"].is_null());
    }
    // A model that does not cover the case says so at its place, and the others answer.
    let shown = ask(&plate(&json!({"phi_deg": 22, "delta_deg": 10})))["shown"].take();
    let table = shown["models"].as_array().unwrap().iter().find(|model| model["id"] == "table").unwrap();
    assert!(table["error"].as_str().unwrap().contains("phi"), "{table}");
    assert!(
        shown["borne"][0]["error"].is_string() && shown["borne"][1]["points"].as_array().unwrap().len() > 20
    );
    let told = ask(&json!({"type": "strokes", "id": 1, "strokes": {"file": "/etc/passwd"}}));
    assert_eq!(told["type"], "error");
}

const SMOOTH: &str = "alpha_deg,depth_m,width_m,force_n,force_sd_n\n90,0.05,0.127,9,0.5\n";

/// One smooth upright stroke leaves the densities `2 F / (g H^2 w K)` with Rankine's K; twice the force, twice the density.
#[test]
fn a_band_is_rankines_and_in_proportion_to_the_force() {
    let band = |csv: &str| {
        let shown = ask(&strokes(csv, &json!({})))["shown"].take();
        let rings: Vec<Vec<[f64; 2]>> =
            serde_json::from_value(shown["bands"][0]["polygons"][0].clone()).unwrap();
        let mut found = Vec::new();
        for (k, a) in rings[0].iter().enumerate() {
            let b = rings[0][(k + 1) % rings[0].len()];
            if (a[0] > 40.0) != (b[0] > 40.0) {
                found.push(a[1] + (40.0 - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
            }
        }
        found.sort_by(f64::total_cmp);
        found
    };
    let density = |force: f64| 2.0 * force / (GRAVITY * 0.05 * 0.05 * 0.127 * rankine(40.0));
    let once = band(SMOOTH);
    for (found, force) in once.iter().zip([8.5, 9.5]) {
        assert!((found / density(force) - 1.0).abs() < 1e-3, "{found}");
    }
    let twice = band(&SMOOTH.replace(",9,0.5", ",18,1"));
    assert!(once.iter().zip(&twice).all(|(a, b)| (b / a - 2.0).abs() < 2e-3));
}

const PUBLISHED: &str = include_str!("../../../data/soils/ticino_rained/strokes.csv");

/// The region is that of `soilctl estimate`, and the stroke that is best comes first; server and desk tell the same.
#[test]
fn the_region_is_that_of_the_use_case() {
    let change = json!({"model": "table", "delta_deg": null, "delta_tol_deg": 1});
    let message = strokes(PUBLISHED, &change);
    let told = ask(&message);
    let (workbench, _) = workbench(None);
    let mut page = Page::open(&workbench);
    assert_eq!(page.ask(&message, "strokes"), told);
    let plate = plate(&json!({}));
    assert_eq!(page.ask(&plate, "plate"), ask(&plate));
    let answer = &told["shown"]["answer"];
    let file = serde_json::from_value(json!({"csv": PUBLISHED})).unwrap();
    let work =
        estimate::run(&estimate::Request { file, ..estimate::Request::default() }, &Unwatched).unwrap();
    for key in ["phi_deg", "density_kg_m3", "region", "verdict", "measurements"] {
        assert_eq!(answer[key], serde_json::to_value(&work.answer).unwrap()[key], "{key}");
    }
    let next = json!({"type": "next", "id": 5, "next": message["strokes"]});
    let left: Vec<f64> = ask(&next)["strokes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["area_left"].as_f64().unwrap())
        .collect();
    assert!(left.len() > 4 && left.is_sorted() && left[0] < 1.0);
    let lines: Vec<u64> =
        told["shown"]["bands"].as_array().unwrap().iter().map(|b| b["lines"][0].as_u64().unwrap()).collect();
    assert_eq!(lines, [2, 3, 4, 5]);
    // What all share lies in what is seen.
    let [phi, density] = [0, 1].map(|axis| pair(&told["shown"]["extent"][axis]));
    let [own_phi, own_density] = ["phi_deg", "density_kg_m3"].map(|key| pair(&answer[key]));
    assert!(phi[0] <= own_phi[0] && own_phi[1] <= phi[1]);
    assert!(density[0] <= own_density[0] && own_density[1] <= density[1]);
}

#[test]
fn tables_that_make_no_sense_are_refused_with_their_line() {
    for (csv, words) in [
        (SMOOTH.replace(",9,", ",x,"), "line 2"),
        ("alpha_deg,depth_m\n90,0.05\n".to_owned(), "width_m"),
        (format!("{SMOOTH}{}", "90,0.05,0.127,9,0.5\n".repeat(200)), "201 strokes"),
    ] {
        let told = ask(&strokes(&csv, &json!({})));
        assert!(told["error"]["words"].as_str().unwrap().contains(words), "{told}");
    }
    // Strokes that no soil explains are an answer that says which.
    let csv = format!("{SMOOTH}90,0.1,0.127,9,0.5\n");
    let answer = ask(&strokes(&csv, &json!({})))["shown"]["answer"].take();
    assert_eq!(answer["consistent"], false);
    assert!(!answer["disagreement"]["pairs"].as_array().unwrap().is_empty(), "{answer}");
}
