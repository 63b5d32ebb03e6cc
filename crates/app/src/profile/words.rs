//! What a profile comes to, and what to keep in mind.

use soilctl_ground::profile::STEEPEST_DEG;

use super::answer::{Alias, Answer, Hypothesis, Kind, Ranges};
use crate::estimate::Inputs;
use crate::request::Ends;
use crate::text::{number, range};

/// Least tool angle, and friction on the plate, for which the model of layers was checked, in deg.
const CHECKED_DEG: f64 = 50.0;
const CHECKED_DELTA_DEG: [f64; 2] = [9.0, 26.0];

fn mm(m: f64) -> String {
    number((1e4 * m).round() / 10.0)
}

fn percent(part: f64) -> String {
    number((1e4 * part).round() / 100.0)
}

/// The result in sentences.
pub(super) fn verdict(answer: &Answer) -> String {
    let mut text = finding(answer);
    text += &risk(answer);
    text += &aliases(answer);
    text += &next(answer);
    text
}

fn finding(answer: &Answer) -> String {
    let left = |kind: Kind| answer.of(kind).and_then(|one| one.ranges.map(|r| (one, r)));
    let (one_soil, gradient, step) = (left(Kind::OneSoil), left(Kind::Gradient), left(Kind::Step));
    let deepest = mm(answer.depths_m[1]);
    match (one_soil, gradient, step) {
        (Some((_, soil)), ..) => {
            let mut text = format!(
                "One soil explains all strokes (friction angle {} deg, density {} kg/m3), so no change with depth is found.",
                range(Some(soil.phi_top_deg), 1),
                range(Some(soil.density_top_kg_m3), 0)
            );
            if let Some((_, r)) = gradient {
                text += &format!(
                    " One soil, a gradient and a step cannot be told apart: from the surface to {deepest} mm a gradient may change friction by {} deg and density by {} kg/m3.",
                    range(Some(r.phi_growth_deg), 1),
                    range(Some(r.density_growth_kg_m3), 0)
                );
            }
            text
        }
        (None, Some((_, r)), None) => format!(
            "The ground changes with depth: no one soil explains the strokes, and no step does; a gradient does. {}",
            growth(&r, "at the deepest stroke")
        ),
        (None, None, Some((one, r))) => format!(
            "The ground changes with depth: no one soil explains the strokes, and no gradient does; a step does, between {} mm deep. {}",
            range(one.step_m.map(|s| s.map(|m| 1e3 * m)), 0),
            growth(&r, "below the step")
        ),
        (None, Some((_, of_gradient)), Some((one, of_step))) => format!(
            "The ground changes with depth: no one soil explains the strokes. A gradient and a step (between {} mm deep) both do, and cannot be told apart. By a gradient: {} \
             By a step: {}",
            range(one.step_m.map(|s| s.map(|m| 1e3 * m)), 0),
            growth(&of_gradient, "at the deepest stroke"),
            growth(&of_step, "below the step")
        ),
        (None, None, None) => {
            let nearest = answer.hypotheses.iter().filter_map(|h| h.widening.map(|w| (w, h.kind)));
            let nearest = nearest.min_by(|a, b| a.0.total_cmp(&b.0));
            let of = |(factor, kind): (f64, Kind)| {
                format!(
                    " With bands {} times as wide a {} would.",
                    number((100.0 * factor).ceil() / 100.0),
                    kind.name()
                )
            };
            format!(
                "No ground explains the strokes: neither one soil, nor a gradient, nor a step.{} Something else is wrong, such as depths, or strokes that disturbed each other.",
                nearest.map_or_else(String::new, of)
            )
        }
    }
}

/// What grew, and which way, as far as that is known.
fn growth(r: &Ranges, where_to: &str) -> String {
    let of = |[low, high]: [f64; 2], digits: usize, unit: &str| {
        if low > 0.0 {
            format!("greater by {} {unit}", range(Some([low, high]), digits))
        } else if high < 0.0 {
            format!("less by {} {unit}", range(Some([-high, -low]), digits))
        } else {
            format!("other by {} {unit} (greater or less is not known)", range(Some([low, high]), digits))
        }
    };
    format!(
        "{} the friction angle is {}, the density {}.",
        crate::text::sentence_case(where_to),
        of(r.phi_growth_deg, 1, "deg"),
        of(r.density_growth_kg_m3, 0, "kg/m3")
    )
}

/// How likely the verdict is false.
fn risk(answer: &Answer) -> String {
    let excluded: Vec<&Hypothesis> = answer.hypotheses.iter().filter(|one| !one.consistent).collect();
    let Some(confidence) = answer.confidence else {
        return " Bands are taken as certain, so what is excluded is, as far as the model of layers holds."
            .into();
    };
    let mut text = format!(
        " If errors are random, ground of whichever kind it is gets excluded with a probability of {} % at most.",
        percent(1.0 - confidence)
    );
    for one in excluded {
        if let Some(p) = one.p {
            text += &format!(
                " {}: strokes are as far off by chance in at most {p:.1e} of such ground.",
                sentence(one.kind.name())
            );
        }
    }
    text
}

fn sentence(text: &str) -> String {
    crate::text::sentence_case(text)
}

/// One soil that looks like this.
fn aliases(answer: &Answer) -> String {
    let of = |alias: &Alias, what: &str, unit: &str| {
        let left = alias.left.filter(|_| alias.consistent == Some(true))?;
        Some(format!("{what} ({} {unit})", range(Some(left), 1)))
    };
    let found: Vec<String> = [
        of(&answer.friction_law, "friction that falls with stress", "deg a decade"),
        of(&answer.cohesion, "cohesion", "Pa"),
    ]
    .into_iter()
    .flatten()
    .collect();
    if answer.allows(Kind::OneSoil) || answer.hypotheses.iter().all(|one| !one.consistent) && found.is_empty()
    {
        return String::new();
    }
    if found.is_empty() {
        let asked = if answer.cohesion.consistent.is_some() { " or has some cohesion" } else { "" };
        return format!(" One soil whose friction falls with stress{asked} does not explain them.");
    }
    format!(
        " But one soil with {} explains them too, and strokes at other depths do not tell it from ground that changes: test the soil in direct shear at two stresses, or \
         dig and make the same stroke from the bottom of the pit.",
        found.join(", or with ")
    )
}

fn next(answer: &Answer) -> String {
    let depth = answer.next.and_then(|place| answer.next_depths.get(place));
    match depth {
        Some(depth) => {
            let forces: Vec<String> = depth
                .forces
                .iter()
                .map(|one| format!("{} {} N", one.kind.name(), one.in_words()))
                .collect();
            format!(
                " The next stroke tells most at {} mm ({} deg): {}.",
                mm(depth.depth_m),
                number(depth.alpha_deg),
                forces.join(", ")
            )
        }
        None if answer.next_depths.is_empty() => String::new(),
        None => " No single stroke at another depth is expected to tell more; repeat the strokes, so that bands become narrower.".into(),
    }
}

/// Whether a range reaches an end of what was searched.
fn touches(searched: [f64; 2], ranges: &[[f64; 2]]) -> bool {
    const CLOSE: f64 = 1e-6;
    ranges.iter().any(|[low, high]| *low <= searched[0] + CLOSE || *high >= searched[1] - CLOSE)
}

/// What to keep in mind.
pub(super) fn warnings(answer: &Answer, inputs: &Inputs, left_out: usize) -> Vec<String> {
    let mut warnings = vec![
        "the force in ground that changes is that of local pressures, the weight above each point of the plate times the coefficient of the friction there; what it may be off by proven \
         bounds of layered ground (friction angles of 32 to 42 deg) is in the ranges"
            .to_owned(),
    ];
    if left_out > 0 {
        warnings.push(format!(
            "{left_out} strokes at tool angles above {STEEPEST_DEG} deg do not count: there soil fails far below the plate's edge, where no stroke tells what it is"
        ));
    }
    let [low, high] = answer.delta_deg;
    let flat = answer.strokes.iter().filter(|s| s.alpha_deg < CHECKED_DEG).count();
    if flat > 0 || low < CHECKED_DELTA_DEG[0] || high > CHECKED_DELTA_DEG[1] {
        warnings.push(format!(
            "the model of layers was checked for tool angles from {CHECKED_DEG} deg on and friction on the plate of {} to {} deg; here {flat} measurements are at less, and friction on the plate \
             is {} to {} deg",
            CHECKED_DELTA_DEG[0],
            CHECKED_DELTA_DEG[1],
            number(low),
            number(high)
        ));
    }
    if answer.ends == Ends::Finite {
        warnings.push("the model of layers was checked in plane strain; what ends of plates add is taken to go with depth in the same way".to_owned());
    }
    for one in &answer.hypotheses {
        let Some(r) = one.ranges else { continue };
        let most = r.phi_growth_deg.iter().map(|g| g.abs()).fold(0.0, f64::max);
        if most > 10.0 {
            warnings.push(format!(
                "{}: changes of up to {most:.0} deg are left, more than the 10 deg for which the model of layers was checked",
                one.kind.name()
            ));
        }
        if touches(answer.phi_searched_deg, &[r.phi_top_deg, r.phi_bottom_deg]) {
            warnings.push(format!(
                "{}: friction angles reach an end of {} deg, which is all that the model covers; they may go beyond",
                one.kind.name(),
                range(Some(answer.phi_searched_deg), 1)
            ));
        }
        if !one.is_sharp {
            warnings.push(format!(
                "{}: the search ended before ranges were narrow; they hold, and may be wider than need be",
                one.kind.name()
            ));
        }
        if !one.is_certain {
            warnings.push(format!(
                "{}: the search ended before such ground was found or excluded",
                one.kind.name()
            ));
        }
    }
    let angles: Vec<f64> = answer.strokes.iter().map(|s| s.alpha_deg).collect();
    let alone = answer.strokes.iter().filter(|s| {
        let other = |o: &&super::Stroke| {
            (o.alpha_deg - s.alpha_deg).abs() <= 1.0 && (o.depth_m / s.depth_m - 1.0).abs() > 0.05
        };
        !answer.strokes.iter().any(|o| other(&o))
    });
    let alone = alone.count();
    if alone > 0 && angles.len() > alone {
        warnings.push(format!("{alone} measurements have no other depth at their tool angle, and tell little of changes with depth"));
    }
    warnings.push(
        "a wrong zero of the depths looks like a change near the surface: give how well it is known (depth_sd_m, depth_common_sd_m)".to_owned(),
    );
    warnings.extend(inputs.warnings.iter().cloned());
    warnings
}
