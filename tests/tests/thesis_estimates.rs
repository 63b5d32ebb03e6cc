//! Chapter 7 of Hong (2001) reproduced: friction angle and density ranges of the four soils.
//!
//! Recipe: bands of one standard deviation, measured density +-4 %, interface friction +-1 deg, plate 5 in wide,
//! 1 in of slant length.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_earth_pressure::table::BracketModel;
use soilctl_earth_pressure::thesis::{Column, appendix_c};
use soilctl_earth_pressure::{ForceModel, model, plane_model};
use soilctl_estimator::{Estimate, Observation, Setup, estimate, section};
use soilctl_soil::{Angle, Plate, units};
use soilctl_tests::{data, shown};

fn column(file: &str, soil: &str) -> Vec<Vec<String>> {
    csv::Reader::from_path(data(file))
        .unwrap()
        .records()
        .map(|r| r.unwrap().iter().map(str::to_owned).collect::<Vec<_>>())
        .filter(|r| r[0] == soil)
        .collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

fn observations(soil: &str) -> Vec<Observation> {
    column("failure_forces.csv", soil)
        .iter()
        .map(|row| {
            let alpha = Angle::from_degrees(number(&row[1]));
            let depth = units::inches_to_m(1.0) * alpha.sin();
            let plate = Plate::new(alpha, Angle::ZERO, depth, units::inches_to_m(5.0)).unwrap();
            let [force, sd] = [2, 3].map(|i| units::lbf_to_n(number(&row[i])));
            Observation::new(format!("{} deg", row[1]), plate, force, sd).unwrap()
        })
        .collect()
}

fn setup<'m>(model: &'m dyn ForceModel, soil: &str, density_known: bool) -> Setup<'m> {
    let row = &column("soils.csv", soil)[0];
    let (density, delta) = (units::g_cc_to_kg_m3(number(&row[1])), number(&row[6]));
    let setup = Setup::new(model, observations(soil), (delta - 1.0, delta + 1.0));
    if density_known { setup.with_density(0.96 * density, 1.04 * density) } else { setup }
}

fn run(id: &str, soil: &str, density_known: bool) -> Estimate {
    let model = plane_model(id).unwrap();
    estimate(&setup(&*model, soil, density_known)).unwrap()
}

fn assert_range(what: &str, found: [f64; 2], printed: [f64; 2], tolerance: f64) {
    for (f, p) in found.into_iter().zip(printed) {
        assert!((f - p).abs() <= tolerance, "{what}: {found:?}, printed {printed:?}");
    }
}

/// Friction angles (deg) of chapter 7 by soil and model, the density measured, as printed; how far ours may be from them.
///
/// All but rained Ticino are reconstructed and only as good as their reconstruction: forces +-1 to 4 % are +-0.1 to 0.5 deg,
/// deviations +-50 % of some 8 % another 0.5 deg; Nevada comes out 1.0 deg low under the bounds, and the glass
/// beads under Chen 1.2 deg high at the lower end.
const PRINTED: [(&str, &str, [f64; 2], f64); 14] = [
    ("ticino_rained", "thesis-ub", [41.4, 43.8], 0.4),
    ("ticino_rained", "thesis-lb", [43.6, 46.1], 0.4),
    ("ticino_rained", "chen", [40.8, 43.2], 0.4),
    ("ticino_rained", "caquot", [41.2, 43.6], 0.5),
    ("nevada_fine", "thesis-ub", [40.9, 44.0], 1.3),
    ("nevada_fine", "thesis-lb", [42.7, 46.1], 1.3),
    ("nevada_fine", "chen", [39.9, 42.2], 1.3),
    ("nevada_fine", "caquot", [39.7, 42.8], 1.3),
    ("glass_beads", "thesis-ub", [28.0, 30.8], 1.3),
    ("glass_beads", "thesis-lb", [29.3, 32.5], 1.3),
    ("glass_beads", "chen", [26.5, 29.8], 1.3),
    ("glass_beads", "caquot", [28.0, 30.7], 1.3),
    ("ticino_loose", "thesis-ub", [41.4, 44.4], 1.3),
    ("ticino_loose", "caquot", [40.8, 42.9], 1.3),
];

/// Of rained Ticino, the density unknown: density (kg/m3) and friction angle.
const PRINTED_WITHOUT_DENSITY: [(&str, [f64; 2], [f64; 2]); 2] =
    [("thesis-ub", [1200., 1900.], [41., 45.]), ("thesis-lb", [1150., 1810.], [43., 48.])];

/// Section 7.5.1: of loose Ticino, whose forces at 90 and 100 deg may have been read up to 10 % low.
const PRINTED_ADJUSTED: [(&str, [f64; 2]); 2] = [("thesis-ub", [41.1, 44.4]), ("thesis-lb", [43.0, 46.8])];

#[test]
fn the_documentation_shows_how_near_chapter_7_is() {
    let mut lines = Vec::new();
    let mut line = |what: &str, found: [f64; 2], printed: [f64; 2]| {
        lines.push((what.to_owned(), [found, printed].concat()));
    };
    for (soil, id, printed, tolerance) in PRINTED {
        let found = run(id, soil, true);
        let angles = found.phi_deg.unwrap();
        assert_range(&format!("{soil} {id}"), angles, printed, tolerance);
        assert!(soil != "ticino_rained" || !found.limits.any());
        line(&format!("{soil},{id},phi_deg,measured"), angles, printed);
    }
    for (id, density, phi) in PRINTED_WITHOUT_DENSITY {
        let found = run(id, "ticino_rained", false);
        let (angles, densities) = (found.phi_deg.unwrap(), found.density_kg_m3.unwrap());
        assert_range(id, densities, density, 80.0);
        assert_range(id, angles, phi, 1.2);
        line(&format!("ticino_rained,{id},phi_deg,unknown"), angles, phi);
        line(&format!("ticino_rained,{id},density_kg_m3,unknown"), densities, density);
    }
    for (id, printed) in PRINTED_ADJUSTED {
        let model = model(id).unwrap();
        let mut setup = setup(&*model, "ticino_loose", true);
        for observation in &mut setup.observations {
            if observation.plate().tool_angle().degrees() > 89.0 {
                *observation = observation.read_low_by(0.1);
            }
        }
        let angles = estimate(&setup).unwrap().phi_deg.unwrap();
        assert_range(id, angles, printed, 0.4);
        line(&format!("ticino_loose,{id},phi_deg,measured; 90 and 100 deg read low"), angles, printed);
    }
    shown("estimates.csv", "soil,model,quantity,density,from,to,from_printed,to_printed", &lines);
}

#[test]
fn loose_ticino_under_chen_is_inconsistent() {
    assert!(!run("chen", "ticino_loose", true).is_consistent());
    assert!(run("caquot", "ticino_loose", true).is_consistent());
    assert!(run("thesis-ub", "ticino_loose", true).is_consistent());
}

/// The thesis's own bounds as a bracket.
fn thesis_bracket() -> BracketModel {
    let [lower, upper] = [Column::LowerBound, Column::UpperBound].map(|column| appendix_c(column).unwrap());
    BracketModel::new("thesis", "Appendix C", lower, upper)
}

/// The bracket holds the regions of both bounds.
#[test]
fn the_bracket_contains_both_bounds() {
    let (upper, lower) = (run("thesis-ub", "ticino_rained", true), run("thesis-lb", "ticino_rained", true));
    let model = thesis_bracket();
    let bracket = estimate(&setup(&model, "ticino_rained", true)).unwrap();
    for inner in [&upper, &lower] {
        let shared = bracket.region.common_area(&inner.region);
        assert!(shared > 0.9999 * inner.region.area());
    }
}

/// The truth is inside both brackets, so they leave soils in common; the proven one leaves fewer.
#[test]
fn the_proven_bracket_says_more_than_that_of_the_thesis() {
    let model = thesis_bracket();
    for soil in ["ticino_rained", "nevada_fine", "glass_beads"] {
        let printed = estimate(&setup(&model, soil, true)).unwrap().region;
        let proven = run("table", soil, true).region;
        assert!(proven.area() < 0.9 * printed.area(), "{soil}: {} {}", proven.area(), printed.area());
        assert!(proven.common_area(&printed) > 0.5 * proven.area(), "{soil}");
    }
}

/// The union over the continuous interval holds every section and more than the integer ones.
#[test]
fn the_union_holds_its_sections() {
    let model = model("thesis-ub").unwrap();
    let setup = setup(&*model, "ticino_rained", false);
    let all = estimate(&setup).unwrap();
    let mut largest = 0.0_f64;
    for delta in [22.0, 22.37, 23.0, 23.8, 24.0] {
        let section = section(&setup, delta).unwrap();
        // Both are enclosures; a section at an end of the interval sticks out by its own slack.
        let slack = if delta == 22.0 || delta == 24.0 { 0.998 } else { 0.9999 };
        assert!(all.region.common_area(&section) > slack * section.area(), "{delta}");
        largest = largest.max(section.area());
    }
    assert!(all.region.area() > 1.1 * largest);
}
