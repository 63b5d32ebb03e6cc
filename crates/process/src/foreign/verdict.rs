//! What becomes of a contact: a stroke that is weighed, or the reason why it is none.

use super::air::AirModel;
use super::contact::{Touch, depth};
use super::push::{self, Why};
use super::stroke::Weigher;
use super::survey::Survey;
use super::{Contact, ContactKind, LEAST_TRAVEL_M};
use crate::Outcome;
use crate::log::{LogStroke, NoStroke};

pub(super) fn weigh(weigher: &Weigher<'_>, touch: &Touch, surface_z_m: f64) -> Result<LogStroke, NoStroke> {
    let survey = weigher.survey;
    let (from_s, to_s) = (time(survey, touch.blocks.start), time(survey, touch.blocks.end.saturating_sub(1)));
    if touch.blocks.is_empty() {
        return Err(NoStroke {
            from_s,
            to_s,
            reason: "no samples lie between these times".into(),
            refused: true,
        });
    }
    match push::push(&survey.blocks, touch.blocks.clone(), surface_z_m, LEAST_TRAVEL_M) {
        Ok(push) => weigher.stroke(&push),
        Err(nothing) => Err(NoStroke {
            from_s,
            to_s,
            reason: nothing.to_string(),
            refused: nothing.why == Why::NoPosture,
        }),
    }
}

pub(super) fn contact(
    survey: &Survey,
    air: Option<&AirModel>,
    touch: &Touch,
    surface_z_m: f64,
    outcome: &Result<LogStroke, NoStroke>,
) -> Contact {
    let (kind, reason) = match outcome {
        Err(NoStroke { reason, refused: true, .. }) => (ContactKind::Refused, Some(reason.clone())),
        Err(NoStroke { reason, .. }) => (ContactKind::NoStroke, Some(reason.clone())),
        Ok(stroke) => match &stroke.evaluated.analysis.outcome {
            Outcome::Found(_) => (ContactKind::Stroke, None),
            Outcome::Indiscernible(reason) => (ContactKind::NoFailure, Some(reason.to_string())),
        },
    };
    let blocks = survey.blocks.get(touch.blocks.clone()).unwrap_or_default();
    let highest =
        air.and_then(|air| blocks.iter().filter_map(|block| air.force_n(block)).max_by(f64::total_cmp));
    Contact {
        kind,
        from_s: time(survey, touch.blocks.start),
        to_s: time(survey, touch.blocks.end.saturating_sub(1)),
        depth_m: deepest(survey, touch, surface_z_m),
        highest_n: highest,
        reason,
    }
}

pub(super) fn deepest(survey: &Survey, touch: &Touch, surface_z_m: f64) -> Option<f64> {
    let blocks = survey.blocks.get(touch.blocks.clone()).unwrap_or_default();
    blocks.iter().filter_map(|block| depth(block, surface_z_m)).max_by(f64::total_cmp)
}

pub(super) fn time(survey: &Survey, block: usize) -> f64 {
    survey.blocks.get(block).or(survey.blocks.last()).map_or(0.0, |block| block.t_s)
}
