//! The campaign of a demonstration: a sweep of set-points, and strokes that tell friction angle from density.

use std::fmt::Write;
use std::path::Path;

use crate::{CampaignError, Plan};

/// Slant depth of the strokes in m: 1 inch, as in the thesis.
const SLANT_M: f64 = 0.0254;
/// Slant depth of shallower strokes in m.
const SHALLOW_M: f64 = 0.0203;
/// At 100 deg the soil is stronger; the thesis goes to 0.85 inch (vertical, in m).
const STEEP_DEPTH_M: f64 = 0.0216;

/// Set-points of the sweep, in deg from the guess: most of them lower, where the force lifts. They do not lie evenly about it,
/// so that a sweep that says nothing does not end up at the guess.
const SWEEP_DEG: [f64; 4] = [-8.0, -5.0, -2.0, 3.0];
/// Set-point of the other strokes, in deg from the guess: a little lower, since a plate whose set-point is too high slips along
/// the soil before it fails.
const BELOW_DEG: f64 = -1.0;
/// Lowest set-point in deg.
const LEAST_SET_DEG: f64 = 1.0;

/// A stroke before its depth is known.
struct Cell {
    radius_m: f64,
    base_deg: f64,
    alpha_deg: f64,
    slant_m: f64,
    /// Set-point from the guess in deg.
    from_guess_deg: f64,
}

/// A stroke far from the base, one inch along the plate.
fn far(base_deg: f64, alpha_deg: f64, from_guess_deg: f64) -> Cell {
    let slant_m = if alpha_deg > 95.0 { STEEP_DEPTH_M / libm::sin(alpha_deg.to_radians()) } else { SLANT_M };
    Cell { radius_m: 0.4318, base_deg, alpha_deg, slant_m, from_guess_deg }
}

/// A stroke near the base.
fn near(alpha_deg: f64, slant_m: f64) -> Cell {
    Cell { radius_m: 0.3048, base_deg: 0.0, alpha_deg, slant_m, from_guess_deg: BELOW_DEG }
}

/// Four preparations of four strokes: the sweep at 80 and 90 deg, far from the base; what tells friction angle from density
/// beside it. The stroke near the base comes first: those far from it pull heaps towards it.
fn whole() -> Vec<Vec<Cell>> {
    let [a, b, c, d] = SWEEP_DEG;
    let e = BELOW_DEG;
    vec![
        vec![near(70.0, SLANT_M), far(-25.0, 90.0, a), far(0.0, 90.0, b), far(25.0, 90.0, c)],
        vec![near(70.0, SHALLOW_M), far(-25.0, 80.0, a), far(0.0, 80.0, b), far(25.0, 80.0, c)],
        vec![near(90.0, SHALLOW_M), far(-25.0, 90.0, d), far(0.0, 100.0, e), far(25.0, 80.0, e)],
        vec![near(80.0, SHALLOW_M), far(-25.0, 80.0, d), far(0.0, 100.0, e), far(25.0, 90.0, e)],
    ]
}

/// Two preparations of two strokes: every step has something to do, and no more.
fn quick() -> Vec<Vec<Cell>> {
    let [_, b, c, _] = SWEEP_DEG;
    vec![vec![far(-25.0, 90.0, b), far(25.0, 80.0, c)], vec![far(-25.0, 80.0, b), near(70.0, SLANT_M)]]
}

/// The campaign for a soil and the part of what ends add at most that they do add, around a guess for the interface friction in deg; its strokes are checked for the arm's reach.
///
/// # Errors
/// [`CampaignError`] if there is no such soil or model, or one cannot be had with the other.
pub fn demonstration(
    soil: &str,
    model: &str,
    end_factor: f64,
    seed: u64,
    guess_deg: f64,
    is_quick: bool,
) -> Result<Plan, CampaignError> {
    let mut text = format!(
        "# Demonstration: a sweep of set-points around a guess of {guess_deg} deg for the interface friction at 80 and 90 deg,\n\
         # and strokes at four tool angles and two depths for friction angle and density.\n\n\
         version = 1\n\
         design = \"demonstration: sweep of set-points around {guess_deg} deg, four tool angles, two depths\"\n\
         soil = \"{soil}\"\nmodel = \"{model}\"\nend_factor = {end_factor:?}\nseed = {seed}\n"
    );
    for batch in if is_quick { quick() } else { whole() } {
        text += "\n[[batches]]\nstrokes = [\n";
        for cell in batch {
            let depth_m = cell.slant_m * libm::sin(cell.alpha_deg.to_radians());
            let set_deg = (guess_deg + cell.from_guess_deg).max(LEAST_SET_DEG);
            // Writing to a text cannot fail.
            let _ = writeln!(
                text,
                "    {{ radius_m = {}, base_deg = {:.1}, alpha_deg = {:.1}, depth_m = {depth_m:.5}, \
                 delta_set_deg = {set_deg:.1} }},",
                cell.radius_m, cell.base_deg, cell.alpha_deg
            );
        }
        text += "]\n";
    }
    Plan::from_toml(&text, "the plan of the demonstration", Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets;

    /// The arm can reach every stroke in every soil, under its gravity; the sweep has what the estimate of the interface
    /// friction asks for.
    #[test]
    fn plans_of_all_soils_can_be_made_and_hold_a_sweep() {
        for soil in presets() {
            for is_quick in [false, true] {
                let plan =
                    demonstration(&soil.name, "chen", 0.0, 1, soil.delta_deg.round(), is_quick).unwrap();
                let strokes = plan.strokes().strokes();
                let upright: Vec<f64> = strokes
                    .iter()
                    .filter(|s| (79.0..=91.0).contains(&s.tool_angle_rad.to_degrees()))
                    .map(|s| s.delta_rad.to_degrees().round())
                    .collect();
                assert!(upright.len() >= 3 && upright.iter().any(|set| *set != upright[0]), "{}", soil.name);
                assert!(plan.batches() >= 2 && strokes.len() == if is_quick { 4 } else { 16 });
                assert!((plan.soil().gravity_m_s2 - soil.gravity_m_s2).abs() < 1e-12);
            }
        }
    }

    /// A sweep that tells nothing ends in the middle of its set-points, and that must not be the guess.
    #[test]
    fn the_middle_of_the_sweep_is_not_the_guess() {
        let (low, high) = SWEEP_DEG.iter().fold((f64::MAX, f64::MIN), |(l, h), s| (l.min(*s), h.max(*s)));
        assert!((0.5 * (low + high)).abs() > 2.0);
    }
}
