//! The answer in words.

use soilctl_soil::STANDARD_GRAVITY_M_S2;

use super::Request;
use super::answer::{Answer, FrictionBasis, SlopeAnswer, Verdict};
use super::region::{Origin, Soils};
use crate::solve::Asked;
use crate::text::{number, to_two_digits};

/// Two stresses, in Pa or kPa, with two digits each.
pub(super) fn stresses([low, high]: [f64; 2]) -> String {
    let (unit, size) = if high < 2000.0 { ("Pa", 1.0) } else { ("kPa", 1000.0) };
    let digits = |stress: f64| number(to_two_digits(stress / size));
    format!("{} to {} {unit}", digits(low), digits(high))
}

/// Why friction of the soils may not be taken for that of the problem, whose soil slips at these stresses.
pub(super) fn other_stresses(soils: &Soils, slips_pa: Option<[f64; 2]>) -> String {
    let slips = slips_pa.map_or_else(
        || "where this soil slips in the problem could not be found".to_owned(),
        |stress| {
            format!(
                "in this problem it slips at {}, and deeper slides at more would decide if friction fell",
                stresses(stress)
            )
        },
    );
    let tried = soils.tried_pa.map_or_else(|| "stresses that were not published".into(), stresses);
    let remedy = match soils.origin {
        Origin::Strokes => "Estimate with `--friction-law`, or say with --constant-friction that it does not",
        Origin::Published => "Say with --constant-friction that friction and cohesion are taken as published",
    };
    format!(
        "{} tried the soil at {tried}; {slips}. Friction of sand falls by 3 to 6 deg with each factor of ten. {remedy}",
        soils.origin.trials()
    )
}

fn factor(value: Option<f64>) -> String {
    value.map_or_else(|| "unknown".into(), |value| format!("{value:.3}"))
}

/// The answer in a sentence or two.
pub(super) fn verdict(answer: &Answer, origin: Origin) -> String {
    // What it is, without the explanation behind the comma.
    let quantity = answer.quantity.words().split(',').next().unwrap_or_default();
    let unit = if answer.quantity == Asked::ForceKnPerM { " kN/m" } else { "" };
    let required = number(answer.required) + unit;
    let [low, high] = answer.phi_deg;
    let soils = match (answer.friction_basis, answer.cohesion_pa) {
        (FrictionBasis::Law, _) => "friction by the law of stress".to_owned(),
        (FrictionBasis::SameStress | FrictionBasis::Constant, None) => {
            format!("phi {low:.1} to {high:.1} deg")
        }
        (FrictionBasis::SameStress | FrictionBasis::Constant, Some([least, most])) => {
            format!("phi {low:.1} to {high:.1} deg, cohesion {} to {} Pa", number(least), number(most))
        }
    };
    let every = origin.every_soil();
    match answer.answer {
        Verdict::Stands => format!(
            "It stands for {every} ({soils}): the {quantity} is at least {} ({required} is required).",
            factor(answer.lower)
        ),
        Verdict::Fails => format!(
            "It fails for {every} ({soils}): the {quantity} is at most {} ({required} is required).",
            factor(answer.upper)
        ),
        Verdict::Depends => {
            let mut text = format!(
                "It depends on the soil ({soils}): the {quantity} is between {} and {} ({required} is required).",
                factor(answer.lower),
                factor(answer.upper)
            );
            if let Some(phi) = answer.stands_from_phi_deg {
                text += &format!(" From phi {phi:.1} deg on it stands.");
            }
            if let Some(phi) = answer.fails_to_phi_deg {
                text += &format!(" Up to phi {phi:.1} deg it fails.");
            }
            text += &by_slope(answer);
            if let Some(stress) = decisive(answer) {
                text += &format!(" A test of this soil at {} would tell.", stresses(stress));
            }
            text
        }
    }
}

/// Stresses that decide: from those at which soil of one friction slips to that which leaves least of the strength.
fn decisive(answer: &Answer) -> Option<[f64; 2]> {
    let [low, high] = answer.slip_stress_pa?;
    let at = answer.decisive_stress_pa;
    Some([at.map_or(low, |at| at.min(low)), at.map_or(high, |at| at.max(high))])
}

/// With which slopes of a law it stands.
fn by_slope(answer: &Answer) -> String {
    let stands = |slope: &&SlopeAnswer| slope.lower.is_some_and(|lower| lower >= answer.required);
    let standing: Vec<_> = answer.by_slope.iter().filter(stands).collect();
    match (&standing[..], &answer.by_slope[..]) {
        ([], []) => String::new(),
        ([], _) => " No slope of the law is proven to stand.".into(),
        ([first, .., last], _) | ([first @ last], _) => format!(
            " With friction that falls by {} to {} deg a decade it stands.",
            number(first.slope_deg_per_decade[0]),
            number(last.slope_deg_per_decade[1])
        ),
    }
}

/// What to keep in mind.
pub(super) fn warnings(answer: &Answer, request: &Request, soils: &Soils) -> Vec<String> {
    let mut warnings = Vec::new();
    match answer.friction_basis {
        FrictionBasis::Law => {
            if let Some([least, most]) = decisive(answer)
                && let Some([low, high]) = answer.tried_stress_pa
                && (least < low || most > high)
            {
                warnings.push(format!(
                    "the soil was tried at {}, and here {} decide: beyond what was tried the law of stress is carried on to the side that is not safe, and \
                     not to the other",
                    stresses([low, high]),
                    stresses([least, most])
                ));
            }
        }
        FrictionBasis::SameStress => {}
        FrictionBasis::Constant => warnings.push(format!(
            "{} taken to be the same at {} as in {}, at {}, because --constant-friction says so; sands lose 3 to 6 deg with each factor of \
             ten",
            if answer.cohesion_pa.is_some() { "friction and cohesion are" } else { "friction is" },
            answer.slip_stress_pa.map_or_else(|| "any stress".into(), stresses),
            soils.origin.trials(),
            answer.tried_stress_pa.map_or_else(|| "stresses that were not published".into(), stresses)
        )),
    }
    warnings.extend(cut(soils));
    if answer.gravity_m_s2 != STANDARD_GRAVITY_M_S2 && !request.keep_weight {
        warnings.push(format!(
            "gravity of {} m/s2 makes the weight of {}; all other weights and loads are those of the file",
            number(answer.gravity_m_s2),
            answer.soil
        ));
    }
    warnings
}

/// That the search of the estimate ended before its region did, if so.
pub(super) fn cut(soils: &Soils) -> Option<String> {
    let which = match soils.cut {
        [true, true] => "weaker and stronger",
        [true, false] => "weaker",
        [false, true] => "stronger",
        [false, false] => return None,
    };
    Some(format!(
        "the search of the estimate ended before its region did: {which} soils may explain the strokes too, and nothing is said of them"
    ))
}
