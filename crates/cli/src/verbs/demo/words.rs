//! The answer for people.

use super::answer::{DemoAnswer, Region};
use super::estimates::{DENSITY_UNKNOWN, DENSITY_WEIGHED, TRUE_FORCES};
use crate::text::{columns, number};

/// Largest median and 95th percentile of the errors of forces with which they count as recovered.
const MEDIAN_ERROR: f64 = 0.03;
const WITHIN_10_PERCENT: f64 = 0.95;
/// Largest error of the interface friction in deg.
const DELTA_ERROR_DEG: f64 = 1.5;

/// What was not recovered.
pub(super) fn not_recovered(answer: &DemoAnswer) -> Vec<String> {
    let mut list = Vec::new();
    let count = answer.strokes;
    let lost = count.asked.saturating_sub(count.made);
    if lost > 0 {
        list.push(format!("not made by the arm: {lost} of {} strokes", count.asked));
    }
    let forceless = count.made.saturating_sub(count.with_force);
    if forceless > 0 {
        list.push(format!("without a failure force: {forceless} of {} strokes", count.made));
    }
    let unfailed = answer.each.iter().filter(|s| s.stroke_id.is_some() && s.true_force_n.is_none()).count();
    if unfailed > 0 {
        list.push(format!(
            "with a failure force although the soil never failed: {unfailed} of {} strokes",
            count.made
        ));
    }
    if let Some(forces) = &answer.forces {
        if forces.median_error > MEDIAN_ERROR {
            list.push(format!(
                "the median error of the forces is {:.1} %, more than {:.0} %",
                100.0 * forces.median_error,
                100.0 * MEDIAN_ERROR
            ));
        }
        if forces.share_within_10_percent < WITHIN_10_PERCENT {
            list.push(format!(
                "{:.0} % of the forces are within 10 %, less than {:.0} %",
                100.0 * forces.share_within_10_percent,
                100.0 * WITHIN_10_PERCENT
            ));
        }
    }
    match (&answer.delta, &answer.no_delta) {
        (_, Some(reason)) => list.push(format!("the interface friction: {reason}")),
        (Some(delta), None) if delta.error_deg.abs() > DELTA_ERROR_DEG => list.push(format!(
            "the interface friction is off by {:+.1} deg, more than {DELTA_ERROR_DEG} deg",
            delta.error_deg
        )),
        _ => {}
    }
    if let Some(reason) = &answer.no_estimate {
        list.push(format!("friction angle and density, {reason}"));
    }
    for (name, region) in named(answer) {
        let Some(region) = region else { continue };
        if !region.consistent {
            list.push(format!(
                "{name}: no friction angle and density explain all forces within {} standard deviations",
                super::region::SIGMA
            ));
        } else if !region.holds_truth {
            list.push(format!("{name}: the truth lies outside the region"));
        }
    }
    list
}

/// The regions with their names.
pub(super) fn named(answer: &DemoAnswer) -> [(&'static str, &Option<Region>); 3] {
    [
        (DENSITY_UNKNOWN, &answer.density_unknown),
        (DENSITY_WEIGHED, &answer.density_weighed),
        (TRUE_FORCES, &answer.true_forces),
    ]
}

pub(super) fn yes(value: bool) -> &'static str {
    if value { "yes" } else { "no" }
}

/// A range, or a dash.
pub(super) fn range(value: Option<[f64; 2]>, digits: usize) -> String {
    value.map_or_else(|| "-".into(), |[low, high]| format!("{low:.digits$} to {high:.digits$}"))
}

pub(super) fn text(answer: &DemoAnswer) -> String {
    let count = answer.strokes;
    let mut text = format!(
        "{}, model {}, seed {}: {} of {} strokes made, {} with a failure force\n",
        answer.title, answer.model, answer.seed, count.made, count.asked, count.with_force
    );
    if !answer.complete {
        return text + "stopped before the end; the same command goes on\n";
    }
    let truth = &answer.truth;
    let mut rows = vec![["", "estimate", "truth", "holds it"].map(String::from).to_vec()];
    if let Some(delta) = &answer.delta {
        rows.push(vec![
            "interface friction (deg)".into(),
            format!("{:.1} ± {:.1}", delta.delta_deg, delta.sd_deg),
            number(truth.delta_deg),
            if delta.determined { yes(delta.holds_truth).into() } else { "does not count".into() },
        ]);
    }
    for (name, region) in named(answer) {
        let Some(region) = region else { continue };
        rows.push(vec![
            format!("friction angle (deg), {name}"),
            range(region.phi_deg, 1),
            number(truth.phi_deg),
            yes(region.phi_holds_truth).into(),
        ]);
        rows.push(vec![
            format!("density (kg/m3), {name}"),
            range(region.density_kg_m3, 0),
            number(truth.density_kg_m3),
            yes(region.density_holds_truth).into(),
        ]);
    }
    text += &columns(&rows);
    if let Some(forces) = &answer.forces {
        text += &format!(
            "errors of {} failure forces: median {:.1} %, 95 % below {:.1} %, {:.0} % of them within 10 %\n",
            forces.compared,
            100.0 * forces.median_error,
            100.0 * forces.percentile_95_error,
            100.0 * forces.share_within_10_percent
        );
    }
    for problem in &answer.not_recovered {
        text += &format!("not recovered: {problem}\n");
    }
    if let Some(report) = &answer.files.report {
        text += &format!("report: {report}\n");
    }
    text
}
