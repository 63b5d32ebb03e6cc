//! Random regions of soils and slopes of sand: what is said to stand or to fail does, by the exact factor. Minutes.

#![allow(clippy::unwrap_used, reason = "tests")]

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::json;
use soilctl_app::limits::Budget;
use soilctl_app::stability::{self, Request, Verdict};
use soilctl_app::{AppError, Unwatched};

/// Numbers that differ from each other in no way that matters here (Weyl's sequence).
struct Spread(f64);

impl Spread {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = (self.0 + 0.618_033_988_749_895).fract();
        low + (high - low) * self.0
    }
}

fn region(folder: &Path, phi_deg: [f64; 2], density_kg_m3: [f64; 2]) -> PathBuf {
    let path = folder.join("region.json");
    let answer = json!({
        "schema": "soilctl.estimate/1", "consistent": true, "phi_deg": phi_deg, "density_kg_m3": density_kg_m3,
        "cut_by": [], "slip_stress_pa": [300.0, 900.0],
    });
    fs::write(&path, answer.to_string()).unwrap();
    path
}

/// A dry slope between level ground.
fn slope(folder: &Path, height_m: f64, slope_deg: f64) -> PathBuf {
    let path = folder.join("slope.json");
    let [toe, crest] = [2.0 * height_m, 2.0 * height_m + height_m / slope_deg.to_radians().tan()];
    let (end, base) = (crest + 2.0 * height_m, -height_m);
    let ground = [[0.0, 0.0], [toe, 0.0], [crest, height_m], [end, height_m]];
    let polygon = [[0.0, base], [end, base], [end, height_m], [crest, height_m], [toe, 0.0], [0.0, 0.0]];
    let problem = json!({
        "objective": {"kind": "strength-reduction"}, "default_boundary": "fixed",
        "soil": [{"name": "sand", "phi_deg": 30.0, "unit_weight_kn_m3": 16.0}],
        "region": [{"soil": "sand", "polygon": polygon}],
        "boundary": [{"kind": "free", "line": ground}],
    });
    fs::write(&path, problem.to_string()).unwrap();
    path
}

/// The exact factor of dry sand is the ratio of the tangents, at any height and density: of all soils of a region it is known, and no sampling is needed.
#[test]
#[ignore = "minutes: cargo xtask verify"]
fn three_hundred_slopes_are_never_said_to_stand_or_fail_wrongly() {
    let folder = tempfile::tempdir().unwrap();
    let mut spread = Spread(0.0);
    let mut counts = [0; 4];
    for case in 0..300 {
        let low = spread.between(22.0, 42.0);
        let phi_deg = [low, low + spread.between(0.2, 6.0)];
        let density = spread.between(1200.0, 1800.0);
        let slope_deg = spread.between(18.0, 45.0);
        let request = Request {
            region: region(folder.path(), phi_deg, [density, 1.1 * density]),
            problem: slope(folder.path(), spread.between(0.5, 20.0), slope_deg),
            constant_friction: true,
            trials: 0,
            budget: Budget { max_gap: 0.05, max_elements: 4000, ..Budget::default() },
            ..Request::default()
        };
        let exact = phi_deg.map(|phi| phi.to_radians().tan() / slope_deg.to_radians().tan());
        let said = match stability::run(&request, &Unwatched) {
            Ok(found) => found,
            // A word that nothing is proven is no wrong answer; it is counted.
            Err(AppError::Limit(_)) => {
                counts[3] += 1;
                continue;
            }
            Err(other) => panic!("{case}: {other}"),
        };
        let text = format!("{case}: {phi_deg:?} in a slope of {slope_deg} deg, {said:?}");
        assert!(said.lower.is_none_or(|lower| lower <= exact[0]), "{text}");
        assert!(said.upper.is_none_or(|upper| upper >= exact[1]), "{text}");
        match said.answer {
            Verdict::Stands => assert!(exact[0] >= 1.0, "{text}"),
            Verdict::Fails => assert!(exact[1] < 1.0, "{text}"),
            Verdict::Depends => {}
        }
        counts[said.answer as usize] += 1;
    }
    let [stands, fails, depends, unsaid] = counts;
    // Where the slope is not near the friction angles, it is decided.
    assert!(
        stands + fails > 150 && unsaid < 15,
        "stands {stands}, fails {fails}, depends {depends}, nothing said {unsaid}"
    );
}
