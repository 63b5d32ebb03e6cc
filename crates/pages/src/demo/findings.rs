//! What was found: forces, interface friction, friction angle and density; and what was not.

use soilctl_app::demo::{Answer, EachStroke};
use soilctl_app::text::{number, sentence_case};
use soilctl_figure::{Align, CalloutKind, HtmlReport, Table};

use super::figures::Drawn;
use super::shown::show;
use crate::PageError;

pub(super) fn forces(page: &mut HtmlReport, answer: &Answer, drawn: &Drawn) -> Result<(), PageError> {
    page.heading("Failure forces");
    if let Some(forces) = &answer.forces {
        page.paragraph(format!(
            "Of {} forces, half are within {:.1} % of the most that the soil bore there and then, and 95 % within {:.1} %; {:.0} % \
             are within 10 %. In the middle they are {:.1} % too {}. {:.0} % of the errors are within one stated standard \
             deviation; 68 % would be right.",
            forces.compared,
            100.0 * forces.median_error,
            100.0 * forces.percentile_95_error,
            100.0 * forces.share_within_10_percent,
            100.0 * forces.median_signed_error.abs(),
            if forces.median_signed_error < 0.0 { "low" } else { "high" },
            100.0 * forces.share_within_one_sd,
        ));
    } else {
        page.paragraph("There is no stroke with a force.");
    }
    show(page, drawn.forces.as_ref(), "Bars are one stated standard deviation.")?;
    let columns = [
        ("stroke", Align::Right),
        ("tool angle (deg)", Align::Right),
        ("depth (mm)", Align::Right),
        ("set-point (deg)", Align::Right),
        ("force (N)", Align::Right),
        ("sd (N)", Align::Right),
        ("limit there and then (N)", Align::Right),
        ("at failure in truth (N)", Align::Right),
        ("error (%)", Align::Right),
        ("used for", Align::Left),
        ("remark", Align::Left),
    ];
    let mut table = Table::new("Every stroke of the plan", columns);
    let cell =
        |value: Option<f64>, digits: usize| value.map_or("–".into(), |value| format!("{value:.digits$}"));
    for stroke in &answer.each {
        table.row([
            stroke.number.to_string(),
            number(stroke.alpha_deg),
            format!("{:.1}", 1e3 * stroke.depth_m),
            number(stroke.delta_set_deg),
            cell(stroke.force_n, 2),
            cell(stroke.force_sd_n, 2),
            cell(stroke.limit_force_n, 2),
            cell(stroke.true_force_n, 2),
            cell(stroke.error.map(|error| 100.0 * error), 1),
            used(stroke).to_owned(),
            remark(stroke),
        ])?;
    }
    page.table(table);
    Ok(())
}

fn used(stroke: &EachStroke) -> &'static str {
    match (stroke.used_for_delta, stroke.used_for_phi) {
        (true, true) => "δ φ ρ",
        (true, false) => "δ",
        (false, true) => "φ ρ",
        (false, false) => "",
    }
}

fn remark(stroke: &EachStroke) -> String {
    match &stroke.why_none {
        Some(reason) => reason.clone(),
        None if stroke.true_force_n.is_none() => "the soil did not fail in truth".into(),
        None => String::new(),
    }
}

pub(super) fn friction(page: &mut HtmlReport, answer: &Answer, drawn: &Drawn) -> Result<(), PageError> {
    page.heading("Interface friction");
    if let Some(delta) = &answer.delta {
        let bracket = match (delta.above_deg, delta.below_deg) {
            (Some(above), Some(below)) => {
                format!("The lifts put it between {} and {}°.", number(above), number(below))
            }
            (Some(above), None) => format!("Set-points up to {}° lift.", number(above)),
            (None, _) => "No set-point lifts significantly.".into(),
        };
        page.paragraph(format!(
            "δ = {:.1} ± {:.1}° (one standard deviation) from {} strokes at 80 and 90°; in truth {}°, an error of {:+.1}°. \
             {bracket}",
            delta.delta_deg,
            delta.sd_deg,
            answer.strokes.used_for_delta,
            number(answer.truth.delta_deg),
            delta.error_deg,
        ));
    }
    if let Some(reason) = &answer.no_delta {
        page.callout(CalloutKind::Warning, "The sweep does not tell it", format!("{reason}."));
    }
    show(
        page,
        drawn.friction.as_ref(),
        "Failed soil slips up along the plate and turns the force to the interface friction, whatever the set-point is. Where nothing is \
         left to turn, the set-point is the friction.",
    )?;
    if let Some([low, high]) = answer.delta_used_deg {
        let source = if answer.no_delta.is_some() { "around the published value" } else { "from the sweep" };
        page.paragraph(format!(
            "What follows takes δ to lie between {low:.1} and {high:.1}°, {source}, and for each stroke the inclination that its force \
             had when the soil failed, ± 1°: less than δ may be mobilised by then, never more."
        ));
    }
    Ok(())
}

pub(super) fn estimate(page: &mut HtmlReport, answer: &Answer, drawn: &Drawn) -> Result<(), PageError> {
    page.heading("Friction angle and density");
    if let Some(reason) = &answer.no_estimate {
        page.callout(CalloutKind::Bad, "No estimate", format!("{reason}."));
    }
    if answer.strokes.used_for_phi > 0 {
        page.paragraph(format!(
            "From {} strokes in which the soil failed as the model has it. Those of one tool angle are one band. All bands together hold \
             their true forces with {} %; what depth, density of a preparation, sensor and model add is part of them.",
            answer.strokes.used_for_phi,
            number(100.0 * answer.regions().find_map(|(_, region)| region.confidence).unwrap_or(0.0))
        ));
    }
    if answer.true_forces.is_some() {
        page.paragraph(
            "The last answer takes the forces and depths of the same strokes as they were in truth: what it has and the others \
             lack is lost in reading the logs.",
        );
    }
    for (name, region) in answer.regions() {
        let kind = match (region.consistent, region.holds_truth) {
            (true, true) => CalloutKind::Good,
            (true, false) => CalloutKind::Warning,
            (false, _) => CalloutKind::Bad,
        };
        let end = match (region.consistent, region.holds_truth) {
            (true, true) => " The truth lies inside.",
            (true, false) => " The truth lies outside.",
            (false, _) => "",
        };
        page.callout(kind, sentence_case(name), format!("{}{end}", region.verdict));
    }
    show(
        page,
        drawn.region.as_ref(),
        "Every friction angle and density inside an outline explains every force within its band.",
    )?;
    show(
        page,
        drawn.bands.as_ref(),
        "What each measured force alone allows at the middle δ: steep bands tell friction angles apart, flat ones densities.",
    )?;
    Ok(())
}

pub(super) fn honest(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    page.heading("What was not recovered");
    if answer.not_recovered.is_empty() {
        page.paragraph("Nothing is missing.");
        return Ok(());
    }
    let mut table = Table::new("Nothing is left out", [("", Align::Right), ("what", Align::Left)]);
    for (number, what) in answer.not_recovered.iter().enumerate() {
        table.row([(number + 1).to_string(), what.clone()])?;
    }
    page.table(table);
    Ok(())
}
