//! At which depth a next stroke would tell most.

use soilctl_ground::profile::{LOG_FORCE, Stroke};
use soilctl_soil::{Angle, Plate};

use super::answer::{Hypothesis, Kind, NextDepth, Predicted};
use super::request::Request;
use super::strokes::Strokes;
use crate::AppError;
use crate::estimate::Inputs;

/// Depths that are considered, if none are given: from this part of the least one
const LEAST: f64 = 0.5;
/// to this multiple of the deepest, beyond which a gradient is not carried on.
const MOST: f64 = 1.5;
const COUNT: usize = 6;

/// Plates of candidates, with the model at them.
pub(super) fn candidates(
    request: &Request,
    inputs: &Inputs,
    strokes: &Strokes<'_>,
) -> Result<Vec<(Plate, Stroke)>, AppError> {
    let [low, high] = strokes.depths_m;
    let depths_m: Vec<f64> = if request.next_depth_m.is_empty() {
        let (low, high) = (LEAST * low, MOST * high);
        let steps = (COUNT - 1) as f64;
        // To a millimetre, as depths are set.
        let all = (0..COUNT).map(|i| low * libm::pow(high / low, i as f64 / steps));
        let mut all: Vec<f64> = all.map(|d| (1e3 * d).round() * 1e-3).filter(|d| *d > 0.0).collect();
        all.dedup();
        all
    } else {
        request.next_depth_m.clone()
    };
    // The tool angle at which most strokes were made, and the plate of its first.
    let measurements = &inputs.measurements;
    let count = |alpha_deg: f64| -> usize {
        measurements.iter().filter(|m| m.alpha_deg == alpha_deg).map(|m| m.count).sum()
    };
    let mut usual: Option<(usize, f64, f64)> = None;
    for m in measurements {
        let strokes = count(m.alpha_deg);
        if usual.is_none_or(|(most, ..)| strokes > most) {
            usual = Some((strokes, m.alpha_deg, m.width_m));
        }
    }
    let Some((_, alpha_deg, width_m)) = usual else { return Ok(Vec::new()) };
    depths_m
        .into_iter()
        .map(|depth_m| {
            if !(depth_m > 0.0 && depth_m <= MOST * high + 1e-3) {
                return Err(AppError::OutOfRange {
                    key: "next_depth_m".into(),
                    value: depth_m.to_string(),
                    allowed: format!(
                        "above 0 m and at most {} m, {MOST} times the deepest stroke",
                        MOST * high
                    ),
                });
            }
            let plate = Plate::new(Angle::from_degrees(alpha_deg), Angle::ZERO, depth_m, width_m)?;
            Ok((plate, strokes.stroke(&plate, [0.0, f64::INFINITY])?))
        })
        .collect()
}

/// What each candidate would tell, for logarithms of forces that the hypotheses allow.
pub(super) fn depths(
    candidates: &[(Plate, Stroke)],
    hypotheses: &[Hypothesis],
    forces: &[Vec<[f64; 2]>],
    strokes: &Strokes<'_>,
) -> Vec<NextDepth> {
    let mut bands: Vec<f64> =
        strokes.setup.observations.iter().map(|o| libm::log(o.high_n() / o.low_n().max(1e-300))).collect();
    bands.sort_by(f64::total_cmp);
    let band = bands.get(bands.len() / 2).copied().unwrap_or(1.0);
    let open: Vec<(Kind, &Vec<[f64; 2]>)> = hypotheses
        .iter()
        .zip(forces)
        .filter(|(one, _)| one.consistent)
        .map(|(one, f)| (one.kind, f))
        .collect();
    if open.is_empty() {
        return Vec::new();
    }
    let of = |place: usize| -> Vec<(Kind, [f64; 2])> {
        open.iter().filter_map(|(kind, forces)| Some((*kind, *forces.get(place)?))).collect()
    };
    candidates
        .iter()
        .enumerate()
        .map(|(place, (plate, _))| {
            let forces = of(place);
            NextDepth {
                alpha_deg: plate.tool_angle().degrees(),
                depth_m: plate.depth_m(),
                width_m: plate.width_m(),
                tells: open_part(&forces) / band,
                forces: forces.into_iter().map(|(kind, ln)| Predicted { kind, force_n: told(ln) }).collect(),
            }
        })
        .collect()
}

/// Forces in N of their logarithms.
fn told([low, high]: [f64; 2]) -> [Option<f64>; 2] {
    [Some(libm::exp(low)), (high < LOG_FORCE[1]).then(|| libm::exp(high))]
}

/// How much of the logarithms of forces one hypothesis allows and another does not, on average over pairs; with one, how much it allows.
fn open_part(forces: &[(Kind, [f64; 2])]) -> f64 {
    let width = |[low, high]: [f64; 2]| (high - low).max(0.0);
    if let [(_, only)] = forces {
        return width(*only);
    }
    let (mut sum, mut pairs) = (0.0, 0.0);
    for (i, (_, a)) in forces.iter().enumerate() {
        for (_, b) in &forces[i + 1..] {
            sum += width(*a) + width(*b) - 2.0 * width([a[0].max(b[0]), a[1].min(b[1])]);
            pairs += 1.0;
        }
    }
    if pairs > 0.0 { sum / pairs } else { 0.0 }
}

/// The depth that tells most, the least deep of equals, of those at which no hypothesis leaves forces open; `None` if none tells more than a band.
pub(super) fn best(depths: &[NextDepth]) -> Option<usize> {
    let mut best: Option<(usize, f64)> = None;
    for (place, depth) in depths.iter().enumerate() {
        let has_ends = depth.forces.iter().all(|one| one.force_n[1].is_some());
        if has_ends && depth.tells > 1.0 && best.is_none_or(|(_, most)| depth.tells > most) {
            best = Some((place, depth.tells));
        }
    }
    best.map(|(place, _)| place)
}
