//! What places come to, and what to keep in mind.

use super::answer::{Answer, By, Group};
use super::found::Place;
use crate::text::number;

/// Names that are listed one by one.
const LISTED: usize = 12;

/// The result in sentences.
pub(super) fn verdict(answer: &Answer) -> String {
    let compared: Vec<_> = answer.pairs.iter().filter(|pair| pair.by != By::Nothing).collect();
    let differ = compared.iter().filter(|pair| pair.differ).count();
    let count = answer.places.len();
    let mut text = if compared.is_empty() {
        format!("None of the {count} places can be compared with another.")
    } else if differ == 0 {
        let pairs = match compared.len() {
            1 => "the one pair".to_owned(),
            pairs => format!("{pairs} pairs"),
        };
        format!("No difference is found between the soils of {count} places ({pairs} compared).")
    } else {
        format!("The soil is not the same everywhere: {differ} of {} pairs of places differ.", compared.len())
    };
    if let Some(percent) = tellable_percent(answer) {
        text += &format!(" Forces would have to differ by about {percent:.0} % to be told apart.");
    }
    match &answer.groups[..] {
        [] => {}
        [one] if one.places.len() > 1 => {
            text += &format!(" Taken as one soil, {}.", ranges(one));
        }
        groups => {
            let groups: Vec<String> =
                groups.iter().map(|group| format!("{}: {}", names(&group.places), ranges(group))).collect();
            text += &format!(" By groups that may be of one soil: {}.", groups.join("; "));
        }
    }
    if let (Some(rate), true) = (answer.false_discovery, differ > 0) {
        text += &format!(" Of the differences told, at most {} % are none on average.", number(100.0 * rate));
    }
    text
}

/// Median of the least force ratios that pairs would tell, in per cent above 1.
fn tellable_percent(answer: &Answer) -> Option<f64> {
    let mut ratios: Vec<f64> = answer.pairs.iter().filter_map(|pair| pair.tellable_ratio).collect();
    (!ratios.is_empty()).then(|| 100.0 * (soilctl_stats::median(&mut ratios) - 1.0))
}

fn ranges(group: &Group) -> String {
    let ([a, b], [c, d]) = (group.phi_deg, group.density_kg_m3);
    format!("phi is {a:.1} to {b:.1} deg and the density {c:.0} to {d:.0} kg/m3")
}

fn names(names: &[String]) -> String {
    let more = names.len().saturating_sub(LISTED);
    let listed = names[..names.len() - more].join(", ");
    if more > 0 { format!("{listed} and {more} more") } else { listed }
}

/// What to keep in mind.
pub(super) fn warnings(
    answer: &Answer,
    places: &[Place],
    nothing_between: Option<String>,
    refused: &[Vec<usize>],
) -> Vec<String> {
    let mut warnings = Vec::new();
    let without: Vec<String> =
        answer.places.iter().filter(|place| !place.consistent).map(|place| place.name.clone()).collect();
    if !without.is_empty() {
        warnings.push(format!(
            "no soil explains the strokes of {} under model {}; such places are in no group and tell nothing of what lies between. `estimate` with \
             their strokes alone says what contradicts what",
            names(&without),
            answer.model
        ));
    }
    if answer.groups.iter().any(|group| group.places.len() > 1) {
        warnings.push(
            "that soils are not found to differ is no proof that they are the same: the set of a group holds if they are, and only the set of \
             each place holds in any case. What lies between places is told from the latter"
                .into(),
        );
    }
    for members in refused {
        let members: Vec<String> = members.iter().map(|m| places[*m].name.clone()).collect();
        warnings.push(format!(
            "no pair of {} is found to differ, but no soil explains all their strokes together under model {}; they are not pooled",
            names(&members),
            answer.model
        ));
    }
    if answer.pairs.iter().any(|pair| pair.by == By::Nothing) {
        warnings.push(
            "some pairs of places have no strokes of one kind and no set, so they could not be compared"
                .into(),
        );
    }
    let sets = answer.pairs.iter().filter(|pair| pair.by == By::Sets).count();
    if sets > 0 && answer.false_discovery.is_some() {
        warnings.push(format!(
            "{sets} pairs have no strokes of one kind (tool angle within 1 deg, depth within 35 %, the same width) and were compared by the model, \
             which tells far less; strokes of one kind at every place tell most"
        ));
    }
    let cut: Vec<String> =
        places.iter().filter(|p| !p.found.answer.cut_by.is_empty()).map(|p| p.name.clone()).collect();
    if !cut.is_empty() {
        warnings.push(format!(
            "sets of {} touch limits of the search; their true extent there may be larger",
            names(&cut)
        ));
    }
    warnings.extend(of_places(places));
    match (&answer.between, nothing_between) {
        (None, Some(why)) => warnings.push(why),
        (None, None) => {}
        (Some(between), _) => {
            if between.is_variation_open {
                warnings.push(
                    "the places are too few to tell how much the ground varies: fifteen times what they differ by is plausible, and nothing beyond was \
                     tried, so intervals between places may be too narrow"
                        .into(),
                );
            }
            if between.cells.iter().any(|cell| !cell.inside) {
                warnings.push(
                    "cells outside of the places' hull are carried on, not interpolated; `inside` tells which they are".into(),
                );
            }
        }
    }
    warnings
}

/// What is doubtful about the strokes of places, each sentence once.
fn of_places(places: &[Place]) -> Vec<String> {
    let mut told: Vec<(&str, Vec<String>)> = Vec::new();
    for place in places {
        for warning in &place.found.inputs.warnings {
            match told.iter_mut().find(|(text, _)| *text == warning.as_str()) {
                Some((_, of)) => of.push(place.name.clone()),
                None => told.push((warning, vec![place.name.clone()])),
            }
        }
    }
    told.iter().map(|(text, of)| format!("at {}: {text}", names(of))).collect()
}
