#![allow(clippy::unwrap_used, reason = "tests")]

use super::*;
use crate::{Format, Shape, signed_area_m2};

/// Three holes on a line to the north-east, 50 m apart; the middle one lacks the peat, and has sand between clay. Group, headings, units and types are
/// those of AGS 4.1.
const SITE: &str = r#""GROUP","PROJ"
"HEADING","PROJ_ID","PROJ_NAME"
"UNIT","",""
"TYPE","ID","X"
"DATA","1","A site with ""quotes"", and commas"

"GROUP","LOCA"
"HEADING","LOCA_ID","LOCA_TYPE","LOCA_NATE","LOCA_NATN","LOCA_GL"
"UNIT","","","m","m","m"
"TYPE","ID","PA","2DP","2DP","2DP"
"DATA","BH1","CP","1000.00","2000.00","12.00"
"DATA","BH3","CP","1060.00","2080.00","14.00"
"DATA","BH2","CP","1030.00","2040.00","13.00"

"GROUP","GEOL"
"HEADING","LOCA_ID","GEOL_TOP","GEOL_BASE","GEOL_DESC","GEOL_LEG","GEOL_GEOL"
"UNIT","","m","m","","",""
"TYPE","ID","2DP","2DP","X","PA","PA"
"DATA","BH1","0.00","1.00","made ground","102","MG"
"DATA","BH1","1.00","2.00","peat","601","PEAT"
"DATA","BH1","2.00","5.00","stiff clay","201","LC"
"DATA","BH1","5.00","8.00","very stiff clay","201","LC"
"DATA","BH2","0.00","1.50","made ground","102","MG"
"DATA","BH2","1.50","4.00","clay","201","LC"
"DATA","BH2","4.00","5.00","sand","401","SAND"
"DATA","BH2","5.00","9.00","clay","201","LC"
"DATA","BH3","0.00","1.50","made ground","102","MG"
"DATA","BH3","1.50","10.00","clay","201","LC"

"GROUP","TRIT"
"HEADING","LOCA_ID","SAMP_TOP","SPEC_DPTH","TRIT_CU"
"UNIT","","m","m","kPa"
"TYPE","ID","2DP","2DP","0DP"
"DATA","BH1","3.00","3.20","75"
"DATA","BH2","6.00","","110"
"DATA","BH1","1.50","1.60","8"

"GROUP","ABBR"
"HEADING","ABBR_HDNG","ABBR_CODE","ABBR_DESC"
"UNIT","","",""
"TYPE","X","X","X"
"DATA","GEOL_GEOL","LC","London Clay"
"DATA","SAMP_TYPE","SAND","no stratum"
"#;

fn drawn(text: &str, holes: &[&str]) -> Result<Drawing, DrawingError> {
    let holes = holes.iter().map(ToString::to_string).collect();
    Drawing::from_bytes(text.as_bytes(), Format::Ags, &Reading { holes, ..Reading::default() })
}

fn area(shapes: &[Shape], layer: &str) -> f64 {
    shapes.iter().filter(|shape| shape.layer == layer).map(|shape| signed_area_m2(&shape.corners).abs()).sum()
}

/// Areas by trapezia: of made ground 50 (1 + 1.5)/2 + 50 (1.5 + 1.5)/2, of peat and sand triangles to either side; with the clay they are the whole between
/// the ground and the ends of the holes.
#[test]
fn strata_are_joined_between_holes_and_taper_out() {
    let shapes = drawn(SITE, &[]).unwrap().shapes;
    for (layer, exact) in [("MG", 137.5), ("PEAT", 25.0), ("SAND", 50.0), ("LC", 900.0 - 137.5 - 75.0)] {
        assert!((area(&shapes, layer) - exact).abs() < 1e-9, "{layer}: {}", area(&shapes, layer));
    }
    let x = |edge: fn(f64, f64) -> f64| {
        shapes.iter().flat_map(|s| &s.corners).map(|p| p[0]).reduce(edge).unwrap()
    };
    assert!((x(f64::min), x(f64::max)) == (0.0, 100.0));
    // Peat is a triangle from the first hole to the second.
    let peat: Vec<&Shape> = shapes.iter().filter(|shape| shape.layer == "PEAT").collect();
    assert!(peat.len() == 1 && peat[0].corners == [[0.0, 11.0], [0.0, 10.0], [50.0, 11.5]], "{peat:?}");
}

#[test]
fn tests_are_told_by_stratum_and_water_is_left_alone() {
    let water =
        "\"GROUP\",\"WSTG\"\n\"HEADING\",\"LOCA_ID\"\n\"UNIT\",\"\"\n\"TYPE\",\"ID\"\n\"DATA\",\"BH1\"\n";
    let notes = drawn(&format!("{SITE}\n{water}"), &[]).unwrap().notes.join("\n");
    for words in [
        "LC: undrained strength 75.0 to 110.0 kPa in 2 tests",
        "PEAT: undrained strength 8.0",
        "ground water is not read",
        "LC is London Clay",
    ] {
        assert!(notes.contains(words), "{words}: {notes}");
    }
    assert!(notes.contains("BH1, BH2, BH3"), "{notes}");
}

/// Named holes are in the order of their names, along the way from one to the next; one alone is level.
#[test]
fn holes_that_are_named_are_the_section() {
    let shapes = drawn(SITE, &["BH3", "BH1"]).unwrap().shapes;
    assert!((area(&shapes, "LC") + area(&shapes, "PEAT") + area(&shapes, "MG") - 900.0).abs() < 1e-9);
    let level = drawn(SITE, &["BH2"]).unwrap().shapes;
    assert!((area(&level, "SAND") - 18.0).abs() < 1e-9 && level.len() == 4);
    let unknown = drawn(SITE, &["BH9"]).unwrap_err().to_string();
    assert!(unknown.contains("no hole BH9 with strata"), "{unknown}");
}

#[test]
fn what_cannot_be_drawn_is_refused_with_the_reason() {
    for (from, to, words) in [
        (
            "\"DATA\",\"BH2\",\"4.00\",\"5.00\"",
            "\"DATA\",\"BH2\",\"4.20\",\"5.00\"",
            "no stratum between 4.00 and 4.20 m",
        ),
        (
            "\"DATA\",\"BH2\",\"4.00\",\"5.00\"",
            "\"DATA\",\"BH2\",\"3.50\",\"5.00\"",
            "two strata between 3.50 and 4.00 m",
        ),
        (
            "\"DATA\",\"BH1\",\"0.00\",\"1.00\"",
            "\"DATA\",\"BH1\",\"1.00\",\"1.00\"",
            "must be below GEOL_TOP",
        ),
        ("\"2080.00\",\"14.00\"", "\"2080.00\",\"\"", "hole BH3 has no level of the ground"),
        ("\"1030.00\",\"2040.00\"", "\"\",\"2040.00\"", "hole BH2 has no coordinates"),
        ("\"1030.00\",\"2040.00\"", "\"1000.00\",\"2000.00\"", "are at one place of the section"),
        (
            "\"UNIT\",\"\",\"m\",\"m\",\"\"",
            "\"UNIT\",\"\",\"ft\",\"m\",\"\"",
            "GEOL_TOP is in \"ft\"; only m is read",
        ),
        ("\"BH1\",\"0.00\",\"1.00\"", "\"BH7\",\"0.00\",\"1.00\"", "hole BH7 is not in group LOCA"),
        ("\"GROUP\",\"PROJ\"", "\"**PROJ\"", "AGS 3 or older"),
        ("\"GROUP\",\"GEOL\"", "\"GROUP\",\"GEOX\"", "no group GEOL"),
        (
            "\"0.00\",\"1.50\",\"made ground\",\"102\",\"MG\"\n\"DATA\",\"BH3\",\"1.50\"",
            "\"x\",\"1.50\",\"made ground\",\"102\",\"MG\"\n\"DATA\",\"BH3\",\"1.50\"",
            "must be a number",
        ),
    ] {
        let text = SITE.replacen(from, to, 1);
        assert_ne!(text, SITE, "{from}");
        let problem = drawn(&text, &[]).unwrap_err().to_string();
        assert!(problem.contains(words), "{words}: {problem}");
    }
    // What is wrong with a hole that is not wanted does not matter.
    let text = SITE
        .replacen("\"DATA\",\"BH2\",\"4.00\"", "\"DATA\",\"BH2\",\"x\"", 1)
        .replace("\"kPa\"", "\"kN/m2\"");
    assert!(drawn(&text, &[]).is_err() && drawn(&text, &["BH1", "BH3"]).is_ok());
    assert!(drawn("", &[]).is_err() && drawn("a,b\n", &[]).is_err());
}

/// Files that do harm end in an answer or in words.
#[test]
fn altered_files_never_panic() {
    let mut random = soilctl_mutants::Random(7);
    for _ in 0..2_000 {
        let read = Drawing::from_bytes(&random.mutant(SITE.as_bytes()), Format::Ags, &Reading::default());
        let corners = read.iter().flat_map(|drawing| &drawing.shapes).flat_map(|shape| &shape.corners);
        assert!(corners.flatten().all(|x| x.is_finite()));
    }
}
