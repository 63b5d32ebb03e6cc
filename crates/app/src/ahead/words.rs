//! The answer in words.

use super::{Answer, Verdict};
use crate::text::number;

pub(super) fn verdict(answer: &Answer) -> String {
    let judged = answer.alarms + answer.quiet;
    if judged == 0 {
        return "No stroke can be judged.".into();
    }
    let percent = number(100.0 * answer.false_alarms);
    let strokes = if judged == 1 { "stroke" } else { "strokes" };
    if answer.alarms == 0 {
        return format!(
            "Nothing is seen ahead of {judged} {strokes}: no force rises beyond what the soil explains. A block that stands further ahead, or deeper, \
             than the force feels is not excluded."
        );
    }
    let named: Vec<&str> = answer
        .strokes
        .iter()
        .filter(|stroke| stroke.verdict == Verdict::Alarm)
        .map(|stroke| stroke.stroke_id.as_str())
        .take(5)
        .collect();
    let more = if answer.alarms > named.len() { ", ..." } else { "" };
    format!(
        "Something may be ahead: the force of {} of {judged} {strokes} rises beyond what the soil explains ({}{more}). Of strokes with nothing ahead {percent} % \
         do so by chance.",
        answer.alarms,
        named.join(", ")
    )
}

pub(super) fn notes(answer: &Answer) -> Vec<String> {
    let mut notes = Vec::new();
    let chance = answer.false_alarms * (answer.alarms + answer.quiet) as f64;
    if answer.alarms > 0 && (answer.alarms as f64) < 2.0 * chance {
        notes.push(format!("of so many strokes {} would alarm by chance alone", number(chance)));
    }
    if answer.references.is_none() {
        notes.push(
            "strokes are compared with each other; where most of them come near something, none stands out: give --reference with strokes that have \
             nothing ahead"
                .into(),
        );
    }
    let regions = || answer.strokes.iter().filter_map(|stroke| stroke.alarm.as_ref()?.last_region.as_ref());
    if regions().next().is_some() {
        notes.push(
            "regions are those of a fixed block at least as wide as the plate, that reaches further down than it and far ahead (plane strain), in sand without \
             cohesion; a smaller or narrower one shows less and is nearer"
                .into(),
        );
    }
    if regions().any(|region| region.places.is_empty()) {
        notes.push(
            "a region is empty: no such block goes with the force; something narrower, something that moves, or another soil does".into(),
        );
    }
    let is_slanted =
        |stroke: &&super::StrokeAnswer| stroke.alarm.as_ref().is_some_and(|a| a.last_region.is_none());
    if answer.strokes.iter().any(|stroke| is_slanted(&stroke)) {
        notes.push("regions are told for upright plates only (85 to 95 deg)".into());
    }
    notes
}
