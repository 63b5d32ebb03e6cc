//! Random regions of soils and slopes of sand: what is said to stand or to fail does, by the exact factor. Minutes.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "a test that tells what it found")]

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use serde_json::json;
use soilctl_app::limits::Budget;
use soilctl_app::stability::{self, Request, Verdict};
use soilctl_app::{AppError, Unwatched};

/// Evenly spread points of the unit cube in as many dimensions as a case has numbers, none of which goes with another: multiples of the powers of
/// 1/g, where g^6 = g + 1 (Roberts's sequence).
struct Spread {
    case: u32,
    drawn: i32,
}

impl Spread {
    const G: f64 = 1.134_724_138_401_519_5;

    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.drawn += 1;
        low + (high - low) * (0.5 + f64::from(self.case) * Self::G.powi(-self.drawn)).fract()
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

/// What is said of a random region and slope, none of it wrong; `None` where nothing is proven.
fn said(folder: &Path, case: u32) -> Option<Verdict> {
    let mut spread = Spread { case, drawn: 0 };
    let low = spread.between(22.0, 42.0);
    let phi_deg = [low, low + spread.between(0.2, 6.0)];
    let density = spread.between(1200.0, 1800.0);
    let slope_deg = spread.between(18.0, 45.0);
    let request = Request {
        region: region(folder, phi_deg, [density, 1.1 * density]),
        problem: slope(folder, spread.between(0.5, 20.0), slope_deg),
        constant_friction: true,
        trials: 0,
        budget: Budget { max_gap: 0.1, max_elements: 2000, ..Budget::default() },
        ..Request::default()
    };
    let exact = phi_deg.map(|phi| phi.to_radians().tan() / slope_deg.to_radians().tan());
    let said = match stability::run(&request, &Unwatched) {
        Ok(found) => found,
        // A word that nothing is proven is no wrong answer; it is counted.
        Err(AppError::Limit(_)) => return None,
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
    println!(
        "{case}: phi {phi_deg:.1?}, slope {slope_deg:.1}: {:?} {:.3?} {:.3?}",
        said.answer, said.lower, said.upper
    );
    Some(said.answer)
}

/// The exact factor of dry sand is the ratio of the tangents, at any height and density: of all soils of a region it is known, and no sampling is needed.
#[test]
#[ignore = "minutes: cargo xtask verify"]
fn three_hundred_slopes_are_never_said_to_stand_or_fail_wrongly() {
    let next = AtomicU32::new(0);
    let counts = [const { AtomicU32::new(0) }; 4];
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                let folder = tempfile::tempdir().unwrap();
                while let case @ 0..300 = next.fetch_add(1, Ordering::Relaxed) {
                    let place = said(folder.path(), case).map_or(3, |answer| answer as usize);
                    counts[place].fetch_add(1, Ordering::Relaxed);
                }
            });
        }
    });
    let [stands, fails, depends, unsaid] = counts.map(AtomicU32::into_inner);
    let text = format!("stands {stands}, fails {fails}, depends {depends}, nothing said {unsaid}");
    println!("{text}");
    // Where the slope is not near the friction angles, it is decided.
    assert!(stands + fails > 150 && unsaid < 15, "{text}");
}
