//! What a demonstration did not recover.

use super::answer::Answer;

/// Largest median and 95th percentile of the errors of forces with which they count as recovered.
const MEDIAN_ERROR: f64 = 0.03;
const WITHIN_10_PERCENT: f64 = 0.95;
/// Largest error of the interface friction in deg.
const DELTA_ERROR_DEG: f64 = 1.5;

/// What was not recovered.
pub(super) fn not_recovered(answer: &Answer) -> Vec<String> {
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
    for (name, region) in answer.regions() {
        if !region.consistent {
            list.push(format!("{name}: no friction angle and density explain all forces within their bands"));
        } else if !region.holds_truth {
            list.push(format!("{name}: the truth lies outside the region"));
        }
    }
    list
}
