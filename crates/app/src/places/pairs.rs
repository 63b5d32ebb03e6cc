//! Whether the soils of two places differ.
//!
//! Strokes of one kind need the same force in one soil, whatever the model: so forces are compared where two places have such strokes. The
//! probability is Šidák's of the kind that differs most. Where they have none, it is that with which all bands of both are so far off that a
//! soil explains them together: bands are widened until one does. Either holds however errors are correlated.

use soilctl_earth_pressure::{ChenLiu, failure_force_n};
use soilctl_estimator::{Observation, Setup, agreement_factor, estimate};
use soilctl_ground::p_of_deviations;
use soilctl_soil::{Angle, Interface, Soil};
use soilctl_stats::{benjamini_hochberg, normal_quantile};

use super::answer::{By, Pair};
use super::found::Place;
use super::request::Request;
use crate::AppError;

/// Strokes are of one kind as in `estimate`: tool angles within a degree, depths within 35 %, widths within a thousandth.
const SAME_ALPHA_DEG: f64 = 1.0;
const SAME_DEPTH: f64 = 0.35;
const SAME_WIDTH: f64 = 1e-3;
/// Forces are carried between such plates in a soil of these, by Chen and Liu's mechanism;
const USUAL_PHI_DEG: f64 = 40.0;
const USUAL_DENSITY_KG_M3: f64 = 1500.0;
/// in other soils the correction is by this share of itself different.
const CARRIED_SHARE: f64 = 0.2;

/// All pairs of places, those that differ told with control of false discoveries.
pub(super) fn pairs(request: &Request, places: &[Place]) -> Result<Vec<Pair>, AppError> {
    let mut pairs = Vec::new();
    for (i, a) in places.iter().enumerate() {
        for b in &places[i + 1..] {
            pairs.push(pair(request, a, b)?);
        }
    }
    let p: Vec<f64> = pairs.iter().filter_map(|pair| pair.p).collect();
    let mut rejected = benjamini_hochberg(&p, request.false_discovery).into_iter();
    for pair in pairs.iter_mut().filter(|pair| pair.p.is_some()) {
        pair.differ = rejected.next().unwrap_or(false);
    }
    Ok(pairs)
}

fn pair(request: &Request, a: &Place, b: &Place) -> Result<Pair, AppError> {
    let mut pair = Pair {
        places: [a.name.clone(), b.name.clone()],
        by: By::Nothing,
        kinds: 0,
        force_ratio: None,
        tellable_ratio: None,
        p: None,
        differ: false,
    };
    let (of_a, of_b) = (a.found.setup()?, b.found.setup()?);
    let kinds = kinds(&of_a, &of_b);
    let differences = kinds.iter().map(|(one, other)| difference(request, a, one, b, other));
    let differences = differences.collect::<Result<Vec<_>, AppError>>()?;
    pair.kinds = kinds.len();
    if !differences.is_empty() {
        let mean = differences.iter().map(|d| d.log_ratio).sum::<f64>() / differences.len() as f64;
        pair.force_ratio = Some(libm::exp(mean));
    }
    let both = a.found.answer.consistent && b.found.answer.consistent;
    if request.estimate.is_statistical() && !differences.is_empty() {
        let off: Vec<f64> = differences.iter().map(|d| d.log_ratio / d.sd).collect();
        pair.by = By::Forces;
        pair.p = Some(p_of_deviations(&off));
        let kinds = differences.len() as f64;
        let each = -libm::expm1(libm::log1p(-request.false_discovery) / kinds);
        let least = differences.iter().map(|d| d.sd).fold(f64::INFINITY, f64::min);
        pair.tellable_ratio = Some(libm::exp(normal_quantile(0.5 * each) * least));
    } else if both {
        pair.by = By::Sets;
        let joint = joint(&of_a, &of_b);
        if request.estimate.is_statistical() {
            pair.p = Some(p_of_sets(&joint, [a, b])?);
        } else {
            pair.differ = !estimate(&joint)?.is_consistent();
        }
    }
    Ok(pair)
}

/// A logarithm of a ratio of forces with its standard deviation.
struct Difference {
    log_ratio: f64,
    sd: f64,
}

/// Measurements of one kind at two places, each at most once.
fn kinds<'s>(a: &'s Setup<'_>, b: &'s Setup<'_>) -> Vec<(&'s Observation, &'s Observation)> {
    let mut left: Vec<&Observation> = b.observations.iter().collect();
    let mut kinds = Vec::new();
    for one in &a.observations {
        if let Some(place) = left.iter().position(|other| are_alike(one, other)) {
            kinds.push((one, left.remove(place)));
        }
    }
    kinds
}

fn are_alike(a: &Observation, b: &Observation) -> bool {
    let (a, b) = (a.plate(), b.plate());
    (a.tool_angle().degrees() - b.tool_angle().degrees()).abs() <= SAME_ALPHA_DEG
        && libm::log(a.depth_m() / b.depth_m()).abs() <= libm::log1p(SAME_DEPTH)
        && (a.width_m() / b.width_m() - 1.0).abs() <= SAME_WIDTH
}

fn difference(
    request: &Request,
    a: &Place,
    one: &Observation,
    b: &Place,
    other: &Observation,
) -> Result<Difference, AppError> {
    let carried = libm::log(usual_n(request, a, one)? / usual_n(request, b, other)?);
    let log_ratio = libm::log(one.force_n() / other.force_n()) - carried;
    let own = [sd(a, one), sd(b, other), CARRIED_SHARE * carried];
    Ok(Difference { log_ratio, sd: own.iter().map(|x| x * x).sum::<f64>().sqrt() })
}

/// The force that a plate needs in a soil of usual strength.
fn usual_n(request: &Request, place: &Place, of: &Observation) -> Result<f64, AppError> {
    let loads = &request.estimate.loads;
    let (low, high) = place.found.inputs.delta_deg;
    let delta = f64::midpoint(low, high).clamp(0.0, USUAL_PHI_DEG);
    let soil = Soil::new(Angle::from_degrees(USUAL_PHI_DEG), USUAL_DENSITY_KG_M3)?
        .with_cohesion(loads.cohesion_pa)?
        .with_gravity(loads.gravity_m_s2)?;
    let interface = Interface::new(Angle::from_degrees(delta), loads.adhesion_pa)?;
    Ok(failure_force_n(&ChenLiu, of.plate(), &soil, &interface, loads.surcharge_pa)?.0)
}

/// Standard deviation of the logarithm of a force: of a normal number that is as often in the band.
fn sd(place: &Place, of: &Observation) -> f64 {
    libm::log(of.high_n() / of.force_n()) / reach(place)
}

/// How many standard deviations of a normal number a band of the place reaches.
fn reach(place: &Place) -> f64 {
    let each = place.found.answer.confidence_each.unwrap_or(0.95);
    normal_quantile(0.5 * (1.0 - each))
}

/// The strokes of both, with what is known of either.
fn joint<'m>(a: &Setup<'m>, b: &Setup<'_>) -> Setup<'m> {
    let hull = |(a, b): (f64, f64), (c, d): (f64, f64)| (a.min(c), b.max(d));
    let density = a.density_kg_m3.zip(b.density_kg_m3).map(|(a, b)| hull(a, b));
    Setup {
        observations: a.observations.iter().chain(&b.observations).cloned().collect(),
        delta_deg: hull(a.delta_deg, b.delta_deg),
        density_kg_m3: density,
        ..a.clone()
    }
}

/// The probability that bands of one soil have to be widened so much until some soil explains all of them, at most.
fn p_of_sets(joint: &Setup<'_>, places: [&Place; 2]) -> Result<f64, AppError> {
    // Not even ten times: less likely than any number that is told.
    let factor = agreement_factor(joint)?.unwrap_or(10.0);
    let mut least = f64::INFINITY;
    for place in places {
        for of in &place.found.setup()?.observations {
            let widened = libm::log1p(factor * (of.high_n() / of.force_n() - 1.0));
            least = least.min(widened / sd(place, of));
        }
    }
    Ok(p_of_deviations(&vec![least; joint.observations.len()]))
}
