//! Strokes of the plan beside what is true of them, and how large the errors are.

use soilctl_campaign::{BatchReport, BatchTruth, Plan, StrokeTruth};
use soilctl_process::table::StrokeRecord;
use soilctl_stats::quantile;

use super::answer::{EachStroke, Forces};
use crate::process::Skipped;

/// By how much times on a log's clock, in s, may miss a stroke that they are of.
const SAME_S: f64 = 0.5;

/// What a log gave.
pub(super) struct Batch<'a> {
    pub(super) report: &'a BatchReport,
    pub(super) truth: BatchTruth,
    pub(super) strokes: Vec<&'a StrokeRecord>,
    pub(super) skipped: &'a [Skipped],
}

/// Every stroke of the plan, with what was found and what is true.
pub(super) fn each(plan: &Plan, batches: &[Batch<'_>]) -> Vec<EachStroke> {
    let mut all = Vec::new();
    for number in 0..plan.batches() {
        let batch = batches.iter().find(|batch| batch.report.batch == number);
        for index in plan.strokes_of(number) {
            let Some(wanted) = plan.strokes().strokes().get(index) else { continue };
            let mut stroke = EachStroke {
                number: index + 1,
                batch: number + 1,
                alpha_deg: degrees(wanted.tool_angle_rad),
                depth_m: wanted.depth_m,
                delta_set_deg: degrees(wanted.delta_rad),
                stroke_id: None,
                force_n: None,
                force_sd_n: None,
                true_force_n: None,
                limit_force_n: None,
                error: None,
                measured_depth_m: None,
                true_depth_m: None,
                used_for_delta: false,
                used_for_phi: false,
                why_none: None,
                trace_id: None,
                found_at_s: None,
                true_at_s: None,
            };
            match batch {
                Some(batch) => fill(&mut stroke, index, batch),
                None => stroke.why_none = Some("its preparation was not simulated to the end".into()),
            }
            all.push(stroke);
        }
    }
    all
}

/// Degrees that went through radians, rounded so that they read as they were written.
fn degrees(radians: f64) -> f64 {
    (radians.to_degrees() * 1e9).round() / 1e9
}

fn fill(stroke: &mut EachStroke, index: usize, batch: &Batch<'_>) {
    let truth = batch.truth.strokes.iter().find(|truth| truth.plan_index == Some(index));
    let Some(truth) = truth else {
        stroke.why_none = Some(lost(stroke.number, batch.report));
        return;
    };
    if let Some(failure) = truth.failure {
        stroke.true_force_n = Some(failure.force_n);
        stroke.true_depth_m = Some(failure.depth_m);
        stroke.true_at_s = Some(failure.time_s);
    }
    // The time of the failure, for that of the stroke is on the campaign's clock.
    let during = |time_s: f64| time_s > truth.start_s - SAME_S && time_s < truth.end_s + SAME_S;
    let Some(found) = batch.strokes.iter().find(|found| found.failure.failure_time_s.is_some_and(during))
    else {
        let skipped = skipped(truth, batch.skipped);
        let reason = skipped.map_or("no stroke was found in the log", |skip| &skip.reason);
        stroke.why_none = Some(reason.to_owned());
        stroke.trace_id = skipped.and_then(|skip| skip.stroke_id.clone());
        return;
    };
    stroke.stroke_id.clone_from(&found.row.stroke_id);
    stroke.trace_id.clone_from(&stroke.stroke_id);
    stroke.force_n = Some(found.row.force_n);
    stroke.force_sd_n = found.row.force_sd_n;
    stroke.found_at_s = found.failure.failure_time_s;
    stroke.measured_depth_m = Some(found.row.depth_m);
    // At the same depth, that is: the plate goes on down, and the limit force grows with it.
    stroke.limit_force_n = found.failure.failure_time_s.and_then(|time_s| truth.limit_force_n(time_s));
    stroke.error = stroke.limit_force_n.filter(|n| *n > 0.0).map(|n| found.row.force_n / n - 1.0);
}

fn lost(number: usize, report: &BatchReport) -> String {
    let start = format!("stroke {number}: ");
    let failure = report.failures.iter().find_map(|failure| failure.strip_prefix(&start));
    failure.map_or_else(|| "the arm did not come to it".into(), |why| format!("the arm gave up: {why}"))
}

fn skipped<'a>(truth: &StrokeTruth, skipped: &'a [Skipped]) -> Option<&'a Skipped> {
    skipped.iter().find(|skip| skip.from_s < truth.end_s + SAME_S && skip.to_s > truth.start_s - SAME_S)
}

/// How far forces are from the truth; `None` without a stroke to compare.
pub(super) fn forces(each: &[EachStroke]) -> Option<Forces> {
    let compared: Vec<(f64, &EachStroke)> =
        each.iter().filter_map(|stroke| Some((stroke.error?, stroke))).collect();
    let sorted = |size: fn(f64) -> f64| {
        let mut errors: Vec<f64> = compared.iter().map(|(error, _)| size(*error)).collect();
        errors.sort_by(f64::total_cmp);
        errors
    };
    let (sizes, signed) = (sorted(f64::abs), sorted(|error| error));
    let share = |count: usize| count as f64 / compared.len() as f64;
    let within_sd = |(_, stroke): &&(f64, &EachStroke)| {
        let off_n = stroke.force_n.zip(stroke.limit_force_n).map(|(found, limit)| (found - limit).abs());
        off_n.zip(stroke.force_sd_n).is_some_and(|(off, sd)| off <= sd)
    };
    Some(Forces {
        compared: compared.len(),
        median_error: quantile(&sizes, 0.5)?,
        percentile_95_error: quantile(&sizes, 0.95)?,
        share_within_10_percent: share(sizes.iter().filter(|size| **size <= 0.1).count()),
        median_signed_error: quantile(&signed, 0.5)?,
        share_within_one_sd: share(compared.iter().filter(within_sd).count()),
    })
}
