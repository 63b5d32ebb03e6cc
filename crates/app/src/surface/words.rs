//! What surface and forces come to together, and what to keep in mind.

use super::answer::{Agreement, Answer, Said};
use crate::estimate::Estimation;

/// The result in sentences.
pub(super) fn verdict(answer: &Answer) -> String {
    let strokes = match answer.strokes.len() {
        1 => "one stroke".to_owned(),
        count => format!("{count} strokes"),
    };
    let mut text = match answer.force.phi_deg {
        Some([low, high]) => {
            format!("Forces leave phi between {low:.1} and {high:.1} deg under model {}.", answer.force.model)
        }
        None => format!("No soil explains the forces under model {}.", answer.force.model),
    };
    text += &format!(" The crack ahead of the plate ({strokes}):");
    let said: Vec<String> = answer.models.iter().map(one).collect();
    text += &format!(" {}.", said.join("; "));
    let of = |kind: Agreement| answer.models.iter().filter(|said| said.agreement == kind).count();
    let count = answer.models.len();
    text += &if of(Agreement::Agrees) == count {
        " Surface and forces agree, whichever model of the surface is taken.".to_owned()
    } else if of(Agreement::Agrees) > 0 {
        format!(
            " Whether surface and forces agree depends on the model of the surface: by {} of {count} they do.",
            of(Agreement::Agrees)
        )
    } else if answer.force.phi_deg.is_none() {
        " There is nothing to hold the surface against.".to_owned()
    } else {
        let why = if of(Agreement::Nearer) == count {
            " It breaks nearer than every model says: the strokes failed at less friction than their forces tell, the soil is held together by \
              something else (cohesion, ends), or what was seen is an earlier or inner crack."
        } else if of(Agreement::Farther) == count {
            " It breaks farther away than every model says: forces were read before the soil failed, the surface ahead was loaded or rose, or what \
              was seen is a later crack."
        } else {
            ""
        };
        format!(" Surface and forces contradict each other by every model.{why}")
    };
    text
}

fn one(said: &Said) -> String {
    let name = said.surface.name();
    match (said.phi_deg, said.agreement) {
        (Some([low, high]), agreement) => {
            let range = format!("{name} says phi {low:.1} to {high:.1} deg");
            match (agreement, said.phi_both_deg) {
                (Agreement::Agrees, Some([a, b])) => format!("{range}, with the forces {a:.1} to {b:.1} deg"),
                (Agreement::Nearer, _) => format!("{range}, below what forces leave"),
                (Agreement::Farther, _) => format!("{range}, above what forces leave"),
                (Agreement::Agrees | Agreement::NoFriction | Agreement::NoForce, _) => range,
            }
        }
        (None, _) => format!("{name} explains the distances by no friction angle"),
    }
}

/// What to keep in mind.
pub(super) fn warnings(answer: &Answer, found: &Estimation) -> Vec<String> {
    let mut warnings = vec![
        "where the ground breaks is what a model says, and not proven: bounds are proven for forces. Between the models, and with dilation below \
         the friction angle, it differs by more than the measurement; take a range only if all of them give it"
            .to_owned(),
        "models are of plane strain and of the moment of failure: measure ahead of the middle of the plate, and before the heap has grown".to_owned(),
    ];
    if answer.not_measured > 0 {
        warnings.push(format!(
            "{} strokes have no break distance and count for the forces only",
            answer.not_measured
        ));
    }
    if answer.strokes.iter().any(|stroke| stroke.predicted_m.iter().any(Option::is_none)) {
        warnings.push(
            "some models have no failure surface for some strokes, which is shown as a dash".to_owned(),
        );
    }
    warnings.extend(found.inputs.warnings.iter().cloned());
    if !found.answer.cut_by.is_empty() {
        warnings
            .push(format!("the region of the forces touches the {}", found.answer.cut_by.join(" and the ")));
    }
    warnings
}
