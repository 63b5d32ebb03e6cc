//! What a demonstration found, beside the truth, in words.

use super::answer::{Answer, Region};
use crate::text::number;

/// A range of friction angles, in deg, that says nothing of a sand.
const OPEN_DEG: f64 = 15.0;

/// Two or three sentences: friction angle and density with how sure they are, interface friction, and the truth.
pub(super) fn in_words(answer: &Answer) -> String {
    let truth = &answer.truth;
    let (weighed, unknown) = (&answer.density_weighed, &answer.density_unknown);
    let mut text = match (weighed.as_ref().and_then(ranges), unknown.as_ref().and_then(ranges)) {
        (Some([phi, _]), Some([phi_unknown, density_unknown])) => {
            let open = unknown.as_ref().and_then(|region| region.phi_deg);
            let without = match open {
                Some([low, high]) if high - low > OPEN_DEG => {
                    format!("without it the strokes leave it open, {phi_unknown} deg")
                }
                _ => format!("without it {phi_unknown} deg at {density_unknown} kg/m3"),
            };
            format!(
                "The forces say that the friction angle of the soil is {phi} deg, with its density as weighed; {without}"
            )
        }
        (None, Some([phi, density])) | (Some([phi, density]), None) => format!(
            "The forces say that the friction angle of the soil is {phi} deg and its density {density} kg/m3"
        ),
        (None, None) => {
            let why =
                answer.no_estimate.as_deref().unwrap_or("no soil explains all forces within their bands");
            return format!(
                "No friction angle was found: {why}. In truth it is {} deg, at {} kg/m3.",
                number(truth.phi_deg),
                number(truth.density_kg_m3)
            );
        }
    };
    let regions = [weighed, unknown].into_iter().flatten();
    if let Some(confidence) = regions.clone().find_map(|region| region.confidence) {
        text += &format!(". The bands of all forces hold together with {} %", number(100.0 * confidence));
    }
    let held = if regions.clone().filter(|region| region.consistent).all(|region| region.holds_truth) {
        "which lies inside"
    } else {
        "which lies outside"
    };
    text += &format!(
        ". In truth it is {} deg at {} kg/m3, {held}.",
        number(truth.phi_deg),
        number(truth.density_kg_m3)
    );
    match (&answer.delta, &answer.no_delta) {
        (Some(delta), None) => {
            text += &format!(
                " The friction between soil and plate is found as {:.1} ± {:.1} deg, in truth {} deg.",
                delta.delta_deg,
                delta.sd_deg,
                number(truth.delta_deg)
            );
        }
        (Some(_) | None, _) => {
            text += &format!(
                " The friction between soil and plate was not found and is taken as published, {} deg.",
                number(answer.delta_guess_deg)
            );
        }
    }
    text
}

/// Friction angle in deg and density in kg/m3, each from and to; `None` if no soil explains the forces.
fn ranges(region: &Region) -> Option<[String; 2]> {
    let ([phi_low, phi_high], [low, high]) = (region.phi_deg?, region.density_kg_m3?);
    Some([format!("{phi_low:.1} to {phi_high:.1}"), format!("{low:.0} to {high:.0}")])
}
