//! `soilctl predict` from outside: keys, numbers, exit codes, messages.

mod common;

use common::{json, refused, soilctl};
use serde_json::Value;

const CASE: [&str; 7] = ["predict", "--alpha", "80", "--phi", "40", "--delta", "25"];
const PLATE: [&str; 6] = ["--density", "1600", "--depth", "0.025", "--width", "0.127"];

fn case(more: &[&str]) -> Vec<&'static str> {
    CASE.iter().copied().chain(more.iter().map(|arg| &*String::from(*arg).leak())).collect()
}

fn number(answer: &Value, key: &str) -> f64 {
    answer[key].as_f64().unwrap_or_else(|| panic!("{key} is {}", answer[key]))
}

#[test]
fn the_fixed_keys_are_there_and_agree_with_each_other() {
    let (code, answer) = json(&case(&PLATE));
    assert_eq!(code, 0);
    assert_eq!((&answer["schema"], &answer["model"]), (&"soilctl.predict/1".into(), &"chen".into()));
    assert_eq!(answer["version"], env!("CARGO_PKG_VERSION"));
    let k = number(&answer, "k_net");
    // Appendix C of Hong (2001).
    assert!((k - 8.055).abs() < 5e-4);
    assert!((number(&answer, "k_passive") - number(&answer, "k_active") - k).abs() < 1e-12);
    let sine = 80f64.to_radians().sin();
    assert!((number(&answer, "k_net_depth") * sine * sine - k).abs() < 1e-12);
    let scale = 0.5 * 1600.0 * 9.80665 * (0.025 / sine).powi(2) * 0.127;
    assert!((number(&answer, "force_n") / (scale * k) - 1.0).abs() < 1e-12);
    assert_eq!(number(&answer["inputs"], "gravity_m_s2"), 9.80665);
}

#[test]
fn force_is_null_when_a_factor_is_missing() {
    for missing in 0..3 {
        let mut rest = PLATE.to_vec();
        rest.drain(2 * missing..2 * missing + 2);
        let (code, answer) = json(&case(&[&rest[..], &["--cohesion", "10"]].concat()));
        assert_eq!((code, &answer["force_n"]), (0, &Value::Null));
        assert!(answer["k_net"].is_f64());
    }
}

#[test]
fn a_plate_with_ends_needs_its_size_and_tends_to_plane_strain() {
    for (model, plane) in [
        ("mckyes", "coulomb"),
        ("perumpral", "coulomb"),
        ("godwin-spoor", "log-spiral"),
        ("blocks-3d", "chen"),
    ] {
        let message = refused(&case(&["--model", model]));
        assert!(message.contains("--width") && message.contains("--ends none"), "{message}");
        let (code, finite) = json(&case(&[&["--model", model][..], &PLATE].concat()));
        assert_eq!((code, &finite["ends"]), (0, &"finite".into()), "{finite}");
        assert!((number(&finite, "width_ratio") - 0.127 / 0.025).abs() < 1e-12);
        let (_, none) = json(&case(&["--model", model, "--ends", "none"]));
        assert_eq!((&none["ends"], &none["width_ratio"]), (&"none".into(), &Value::Null));
        let (_, known) = json(&case(&["--model", plane]));
        assert!((number(&none, "k_net") / number(&known, "k_net") - 1.0).abs() < 0.02, "{model}");
        assert!(number(&finite, "k_net") > 1.02 * number(&none, "k_net"), "{model}");
    }
    let message =
        refused(&["estimate", "../../data/soils/ticino_rained/strokes.csv", "--model", "blocks-3d"]);
    assert!(message.contains("anew for each soil"), "{message}");
    let message = refused(&case(&[&["--ends", "finite"][..], &PLATE].concat()));
    assert!(message.contains("chen is for plane strain"), "{message}");
}

#[test]
fn every_model_answers_and_tables_have_no_split() {
    for model in
        ["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "table"]
    {
        let (code, answer) = json(&case(&["--model", model]));
        assert_eq!((code, answer["model"].as_str()), (0, Some(model)));
        assert!((7.0..10.0).contains(&number(&answer, "k_net")), "{model}");
        assert_eq!(answer.get("k_net_lower").is_some(), model == "table", "{model}");
        if model.starts_with("thesis-") || model == "table" {
            assert!(answer["k_passive"].is_null() && answer["k_active"].is_null());
        }
    }
    let (_, answer) = json(&case(&["--model", "table"]));
    let ends = &answer["k_net_provenance"];
    assert_eq!(
        (&ends["lower"], &ends["upper"]),
        (
            &"limit analysis of the plate, lower bound".into(),
            &"limit analysis of the plate, upper bound".into()
        )
    );
    let (low, high) = (number(&answer, "k_net_lower"), number(&answer, "k_net_upper"));
    assert!(low < high && ((low * high).sqrt() - number(&answer, "k_net")).abs() < 1e-12);
}

#[test]
fn negative_values_are_arguments_of_their_own() {
    let (code, sloped) = json(&case(&["--beta", "-4"]));
    assert_eq!((code, number(&sloped["inputs"], "beta_deg")), (0, -4.0));
    assert!(number(&sloped, "k_net") < number(&json(&CASE).1, "k_net"));
    let message = refused(&case(&["--cohesion", "-1"]));
    assert!(message.contains("cohesion is -1 Pa; it must be at least 0 Pa"), "{message}");
    assert!(refused(&case(&["--surcharge", "-1"])).contains("surcharge is -1 Pa"));
    assert!(refused(&case(&["--density", "-1"])).contains("density is -1 kg/m3"));
    assert!(refused(&case(&["--depth", "-1"])).contains("depth is -1 m"));
}

#[test]
fn what_has_no_answer_is_refused_with_the_reason() {
    let singular =
        refused(&["predict", "--model", "coulomb", "--alpha", "100", "--phi", "50", "--delta", "30"]);
    assert!(singular.contains("no finite answer at alpha 100 deg, phi 50 deg"), "{singular}");
    for (args, parts) in [
        (["--alpha", "150", "--phi", "40", "--delta", "5"], ["alpha from 20 to 140 deg", "150"]),
        (["--alpha", "80", "--phi", "30", "--delta", "35"], ["delta is 35 deg", "use delta <= phi"]),
        (["--alpha", "80", "--phi", "95", "--delta", "5"], ["phi is 95 deg", "below 90 deg"]),
        (["--alpha", "80", "--phi", "nan", "--delta", "5"], ["'nan' for '--phi <DEG>'", "finite number"]),
        (["--alpha", "80", "--phi", "inf", "--delta", "5"], ["inf", "finite number"]),
        (["--alpha", "80", "--phi", "40", "--delta", "x"], ["--delta", "column"]),
        (["--alpha", "80", "--phi", "40", "--delta", "column"], ["--strokes FILE", "delta_set_deg"]),
    ] {
        let message = refused(&[&["predict"], &args[..]].concat());
        for part in parts {
            assert!(message.contains(part), "{part:?} is not in: {message}");
        }
    }
    assert!(refused(&case(&["--model", "boussinesq"])).contains("the models are coulomb"));
    let load = refused(&case(&["--model", "table", "--cohesion", "5"]));
    assert!(load.contains("model table has no term for cohesion"), "{load}");
    assert!(refused(&["predict", "--phi", "40", "--delta", "25"]).contains("--alpha"));
    let huge = ["--density", "1e300", "--depth", "1e300", "--width", "1e300"];
    assert!(refused(&case(&huge)).contains("force_n came out as"));
}

#[test]
fn text_says_the_same_numbers_as_json() {
    for model in ["chen", "table", "caquot"] {
        let args = case(&[&PLATE[..], &["--model", model]].concat());
        let text = String::from_utf8(soilctl(&args).stdout).unwrap();
        let (_, answer) = json(&args);
        let mut seen = 0;
        for line in text.lines() {
            let mut words = line.split_whitespace();
            let (Some(key), Some(word)) = (words.next(), words.next()) else { continue };
            let Some(expected) = answer.get(key) else { continue };
            seen += 1;
            match word.parse::<f64>() {
                Ok(shown) => assert!((shown / expected.as_f64().unwrap() - 1.0).abs() < 1e-5, "{line}"),
                Err(_) => assert!(word == "-" && expected.is_null(), "{line}"),
            }
        }
        assert_eq!(seen, if model == "table" { 8 } else { 5 }, "{text}");
    }
}

#[test]
fn a_stroke_table_gives_one_prediction_a_row() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("s.csv");
    let rows = "stroke_id,alpha_deg,depth_m,width_m,force_n,delta_set_deg,density_kg_m3\n\
                a,80,0.025,0.127,5,25,1600\nb,90,0.02,0.127,6,20,1500\n";
    std::fs::write(&file, rows).unwrap();
    let strokes = ["predict", "--phi", "40", "--strokes", file.to_str().unwrap()];
    let (code, answer) = json(&[&strokes[..], &["--delta", "column", "--density", "column"]].concat());
    assert_eq!(code, 0);
    assert!(answer["k_net"].is_null() && answer["force_n"].is_null());
    let list = answer["strokes"].as_array().unwrap();
    assert_eq!((list.len(), &list[1]["line"], &list[1]["stroke_id"]), (2, &3.into(), &"b".into()));
    let (_, single) = json(&case(&PLATE));
    assert_eq!((&list[0]["k_net"], &list[0]["force_n"]), (&single["k_net"], &single["force_n"]));
    assert_eq!(number(&list[0], "ratio"), number(&list[0], "force_n") / 5.0);

    let (_, without) = json(&[&strokes[..], &["--delta", "25"]].concat());
    assert!(without["strokes"][0]["force_n"].is_null() && without["strokes"][0]["ratio"].is_null());
    let outside = refused(&[&strokes[..], &["--delta", "25", "--model", "caquot", "--beta", "3"]].concat());
    assert!(outside.contains("s.csv, line 2: model caquot covers beta"), "{outside}");
    let both = refused(&[&strokes[..], &["--delta", "25", "--alpha", "80"]].concat());
    assert!(both.contains("cannot be used with"), "{both}");

    std::fs::write(&file, "alpha_deg,depth_m,width_m,force_n\n80,0.025,0.127,5\n").unwrap();
    let empty = refused(&[&strokes[..], &["--delta", "column"]].concat());
    assert!(empty.contains("line 2: delta_set_deg is empty or missing"), "{empty}");
    std::fs::write(&file, "alpha_deg,depth_m,width_m,force_n\n80,0.025,0.127,x\n").unwrap();
    let bad = refused(&[&strokes[..], &["--delta", "20"]].concat());
    assert!(bad.contains("line 2, column force_n is \"x\""), "{bad}");
}

#[test]
fn figures_are_written_in_the_form_of_their_name() {
    let dir = tempfile::tempdir().unwrap();
    for kind in ["surface", "phi", "delta", "alpha"] {
        for (ending, magic) in [("svg", &b"<svg"[..]), ("png", &b"\x89PNG"[..])] {
            let file = dir.path().join(format!("{kind}.{ending}"));
            let (code, _) = json(&case(&["--plot-kind", kind, "--plot", file.to_str().unwrap()]));
            assert_eq!(code, 0);
            assert!(std::fs::read(&file).unwrap().starts_with(magic), "{kind}.{ending}");
        }
    }
    assert!(refused(&case(&["--plot", "figure.pdf"])).contains(".svg, .png or .csv"));
    assert!(refused(&case(&["--plot", "no/such/folder.svg"])).contains("no/such/folder.svg"));
}

#[test]
fn sensitivities_are_those_of_table_4_3() {
    // Chen, 80 deg, one degree more: 4.1, 5.2, 6.5 and 3.7 % (Hong 2001, Table 4.3).
    let (_, answer) = json(&case(&[]));
    let s = &answer["sensitivity_percent_per_deg"];
    for (key, printed) in [("alpha", 4.1), ("beta", 5.2), ("phi", 6.5), ("delta", 3.7)] {
        assert!((number(s, key) - printed).abs() < 0.06, "{key}: {}", s[key]);
    }
    let (_, table) = json(&case(&["--model", "thesis-ub"]));
    assert!(table["sensitivity_percent_per_deg"]["beta"].is_null());
}
