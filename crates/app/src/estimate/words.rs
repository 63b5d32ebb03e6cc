//! What the numbers say: the verdict and the warnings of an answer.

use crate::request::Ends;
use soilctl_estimator::Estimate;

use super::answer::{Answer, Disagreement, Measured, PlaneStrain};
use super::law::{LawAnswer, LawRange};
use super::request::Request;
use super::unknowns::{Name, UnknownsAnswer};
use crate::text::{number, to_two_digits};

/// Pairs in conflict that are named; the JSON answer has all.
const MOST_PAIRS: usize = 6;

/// Width over depth from which on ends add less than what forces scatter by: a percent or two.
const WIDE: f64 = 100.0;

/// Names of the search limits that the region touches.
pub(super) fn limits(estimate: &Estimate) -> Vec<&'static str> {
    let l = estimate.limits;
    [
        (l.phi_low, "least friction angle searched"),
        (l.phi_high, "greatest friction angle searched"),
        (l.density_low, "least density searched"),
        (l.density_high, "greatest density searched"),
    ]
    .into_iter()
    .filter_map(|(touched, name)| touched.then_some(name))
    .collect()
}

/// Result in a sentence or two.
pub(super) fn verdict(answer: &Answer) -> String {
    let delta = format!("delta {} to {} deg", number(answer.delta_deg[0]), number(answer.delta_deg[1]));
    if let Some(exact) = &answer.exact {
        return match exact.best.as_ref().and_then(|best| Some((best, best.ellipse_centre?))) {
            Some((best, [phi, density])) => format!(
                "Taken as exact, the contours come closest at phi {phi:.2} deg, density {density:.0} kg/m3 and delta \
                 {:.2} deg.",
                best.delta_deg
            ),
            None => {
                "Taken as exact, no two contours cross: no soil in range explains two of the measurements."
                    .into()
            }
        };
    }
    let model = match answer.ends {
        Ends::Finite => format!("{} of plates with ends", answer.model),
        Ends::None => answer.model.clone(),
    };
    match (answer.phi_deg, answer.density_kg_m3) {
        (Some(phi), Some(density)) => {
            let mut text = format!(
                "The measurements agree under model {model}: phi{} lies between {:.1} and {:.1} deg{} and the density \
                 between {:.0} and {:.0} kg/m3, for {delta}.",
                reference(answer),
                phi[0],
                phi[1],
                slope(answer),
                density[0],
                density[1]
            );
            if let Some(unknowns) = &answer.unknowns {
                text += &left_of(unknowns);
            }
            if let Some(plane) = &answer.plane_strain {
                text += &without_ends(plane);
            }
            text
        }
        _ => {
            let tests = answer.friction_law.as_ref().is_some_and(|law| !law.shear_tests.is_empty());
            let tests = if tests { " and tests in direct shear" } else { "" };
            let mut text =
                format!("No soil explains all measurements{tests} under model {model} with {delta}");
            if let Some([low, high]) = answer.density_known_kg_m3 {
                text += &format!(" and density {low:.0} to {high:.0} kg/m3");
            }
            if let Some(unknowns) = &answer.unknowns {
                text += &known_of(unknowns);
            }
            text += ".";
            if let Some(law) = &answer.friction_law {
                text += &plates_and_shear(law);
            }
            if let Some(d) = &answer.disagreement {
                text += &disagreement(d);
            }
            text
        }
    }
}

/// The unknowns beside friction and density.
fn others(unknowns: &UnknownsAnswer) -> impl Iterator<Item = &super::Unknown> {
    unknowns
        .quantities
        .iter()
        .filter(|unknown| !matches!(unknown.name, Name::PhiDeg | Name::DeltaDeg | Name::DensityKgM3))
}

/// What is left of them, in a sentence.
fn left_of(unknowns: &UnknownsAnswer) -> String {
    let told = others(unknowns).filter_map(|unknown| {
        let (name, unit, digits) = unknown.name.in_words();
        let [low, high] = unknown.range?;
        Some(format!("{name} between {} and {} {unit}", fixed(low, digits), fixed(high, digits)))
    });
    format!(" Of what else is unknown they leave {}.", told.collect::<Vec<_>>().join(", "))
}

/// What was known of them.
fn known_of(unknowns: &UnknownsAnswer) -> String {
    let told = others(unknowns).map(|unknown| {
        let (name, unit, _) = unknown.name.in_words();
        format!(", {name} {} to {} {unit}", number(unknown.known[0]), number(unknown.known[1]))
    });
    told.collect()
}

/// A number with so many digits, never as minus nought.
fn fixed(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let is_nought = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if is_nought { format!("{:.digits$}", 0.0) } else { text }
}

/// At which stress a friction angle is told, if that is one stress.
fn reference(answer: &Answer) -> String {
    answer.reference_stress_pa.map_or_else(String::new, |stress| format!(" at {stress:.0} Pa"))
}

/// How friction falls.
fn slope(answer: &Answer) -> String {
    let slope = answer.friction_law.as_ref().and_then(|law| law.slope_deg_per_decade);
    slope.map_or_else(String::new, |[low, high]| {
        format!(", falls by {low:.1} to {high:.1} deg a decade of normal stress,")
    })
}

/// What strokes and tests in direct shear say each by themselves, where they say nothing together.
fn plates_and_shear(law: &LawAnswer) -> String {
    if law.shear_tests.is_empty() {
        return String::new();
    }
    let told = |range: Option<LawRange>| {
        range.map_or_else(
            || "no law of the known slopes".into(),
            |LawRange { phi_deg: phi, slope_deg_per_decade: slope }| {
                format!(
                    "phi {:.1} to {:.1} deg with a fall of {:.1} to {:.1} deg a decade",
                    phi[0], phi[1], slope[0], slope[1]
                )
            },
        )
    };
    format!(
        " At the reference stress, the strokes alone allow {}, and direct shear alone {}.",
        told(law.plates_alone),
        told(law.shear_alone)
    )
}

/// What would come out if ends were forgotten.
fn without_ends(plane: &PlaneStrain) -> String {
    match plane.phi_deg {
        Some([low, high]) => {
            format!(" If the plates had no ends (plane strain), phi would be {low:.1} to {high:.1} deg.")
        }
        None => " No soil explains them if the plates had no ends (plane strain).".into(),
    }
}

fn disagreement(d: &Disagreement) -> String {
    let mut text = String::new();
    if !d.alone.is_empty() {
        text += &format!(" Not even alone: {}.", d.alone.join("; "));
    }
    if !d.pairs.is_empty() {
        let pairs: Vec<_> = d.pairs.iter().map(|[a, b]| format!("{a} with {b}")).collect();
        let more = pairs.len().saturating_sub(MOST_PAIRS);
        let rest = if more > 0 { format!(", and {more} more pairs") } else { String::new() };
        text += &format!(" In conflict: {}{rest}.", pairs[..pairs.len() - more].join("; "));
    }
    if !d.culprits.is_empty() {
        text += &format!(" The others agree without {}.", d.culprits.join(", or without "));
    }
    text += &match d.uncertainty_factor {
        Some(factor) => format!(" All would agree if the uncertainties were {factor:.2} times as large."),
        None => " Not even ten times the uncertainty makes them agree.".into(),
    };
    text
}

/// What the numbers call for.
pub(super) fn warnings(answer: &Answer, request: &Request, knows_ends: bool) -> Vec<String> {
    let mut warnings = Vec::new();
    if !knows_ends && request.ends.is_none() && answer.width_ratio[0] < WIDE {
        warnings.push(format!(
            "model {} is of plane strain, and plates of {:.1} times their depth have ends, which make the force higher: phi comes out too \
             high, by a degree and more where plates are narrow. `--model table` knows ends; `--ends none` says that they are meant to \
             be left out",
            answer.model, answer.width_ratio[0]
        ));
    }
    if answer.end_factor.is_some() && request.end_tolerance < 1.0 {
        warnings.push(format!(
            "strokes are taken to share what their ends add, to within {} of its proven most, as they would in one soil; `--end-tol 1` \
             leaves each stroke its whole bracket",
            number(request.end_tolerance)
        ));
    }
    if !answer.cut_by.is_empty() {
        warnings.push(format!(
            "the region touches the {}; its true extent there may be larger",
            answer.cut_by.join(" and the ")
        ));
    }
    if answer.consistent {
        warnings.extend(stresses(answer));
    }
    if let Some(unknowns) = answer.unknowns.as_ref().filter(|_| answer.consistent) {
        warnings.extend(not_told(answer, unknowns));
    }
    warnings
}

/// What strokes leave as it was known is no larger than this share less.
const TOLD: f64 = 0.05;
/// Strokes whose depths or plates' lengths differ by no more than this share are of one depth.
const SAME_DEPTH: f64 = 0.15;

/// What the strokes cannot tell of unknowns.
fn not_told(answer: &Answer, unknowns: &UnknownsAnswer) -> Vec<String> {
    let mut warnings = vec![
        "phi is that of the stresses in these strokes, which unknown loads and slopes leave open; at larger stresses it is several degrees lower"
            .to_owned(),
    ];
    let untold: Vec<&str> = others(unknowns)
        .filter(|unknown| {
            let width = |[low, high]: [f64; 2]| high - low;
            unknown.known[0] < unknown.known[1]
                && unknown.range.is_some_and(|range| width(range) >= (1.0 - TOLD) * width(unknown.known))
        })
        .map(|unknown| unknown.name.in_words().0)
        .collect();
    if !untold.is_empty() {
        warnings.push(format!(
            "of {} the strokes tell nothing that was not known before; the other ranges hold for all of it",
            untold.join(" and ")
        ));
    }
    let is_unknown = |names: &[Name]| {
        others(unknowns).any(|unknown| names.contains(&unknown.name) && unknown.known[0] < unknown.known[1])
    };
    let sticks = is_unknown(&[Name::CohesionPa, Name::AdhesionPa]);
    let presses = is_unknown(&[Name::SurchargePa]);
    if sticks && presses {
        warnings.push(
            "cohesion and surcharge cannot be told apart by depth: the force of both goes with the length of the plate, and only tool angles tell \
             them apart, by a few per cent; their region together says what trades for what"
                .into(),
        );
    }
    let ends = |of: fn(&Measured) -> f64| {
        let values = answer.measurements.iter().map(of);
        values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)))
    };
    let depths = ends(|m| m.depth_m);
    let lengths = ends(|m| m.depth_m / m.alpha_deg.to_radians().sin());
    let is_same = |(low, high): (f64, f64)| high <= (1.0 + SAME_DEPTH) * low;
    if (sticks || presses) && (is_same(depths) || is_same(lengths)) {
        let which = match (sticks, presses) {
            (true, true) => "cohesion, surcharge and the soil's weight",
            (true, false) => "cohesion and the soil's weight",
            (false, _) => "a surcharge and the soil's weight",
        };
        let mm = |depth_m: f64| number((1e4 * depth_m).round() / 10.0);
        warnings.push(format!(
            "strokes of one depth ({} to {} mm) can hardly tell {which} apart, whose forces differ by how they grow with depth; add strokes at half or \
             twice the depth",
            mm(depths.0),
            mm(depths.1)
        ));
    }
    warnings
}

/// At which stresses the soil was tried.
fn stresses(answer: &Answer) -> Option<String> {
    let [low, high] = answer.slip_stress_pa?;
    let tried = format!("{} Pa", range(low, high));
    Some(match &answer.friction_law {
        None => format!(
            "phi is that of the stresses on slip surfaces in these strokes, {tried}; at larger stresses it is several degrees lower, so do \
             not carry it to foundations or walls without a test at their stress; `--friction-law` makes it a law of stress"
        ),
        Some(law) => {
            let boxes = law.shear_tests.iter().map(|test| test.stress_pa);
            let (least, most) = boxes.fold((low, high), |(a, b), stress| (a.min(stress), b.max(stress)));
            format!(
                "the law was tried at stresses of {} Pa; beyond them it is carried on in a straight line of the logarithm, while friction may \
                 stop to fall",
                range(least, most)
            )
        }
    })
}

/// Two stresses with two digits each.
fn range(low: f64, high: f64) -> String {
    let digits = |x: f64| number(to_two_digits(x));
    format!("{} to {}", digits(low), digits(high))
}
