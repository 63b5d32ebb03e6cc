//! The report, section by section.

use soilctl_app::process::{Analysis, Answer, Friction};
use soilctl_app::text::{number, sentence_case};
use soilctl_figure::{Align, CalloutKind, Figure, HtmlReport, Size, Table};
use soilctl_process::table::StrokeRecord;

use super::figures;
use crate::PageError;

/// The page of logs that were processed.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("Strokes of a campaign");
    page.kind("Failure forces");
    let skipped = verdict(&mut page, answer);
    sections(&mut page, &answer.analysis, &answer.strokes)?;
    scans(&mut page, answer)?;
    if skipped > 0 || answer.is_partial() {
        left_out(&mut page, answer)?;
    }
    Ok(page)
}

/// How many strokes have a force; returns how many have none.
fn verdict(page: &mut HtmlReport, answer: &Answer) -> usize {
    let strokes = answer.strokes.len();
    let skipped: usize = answer.logs.iter().map(|log| log.skipped.len()).sum();
    let kind = match strokes {
        0 => CalloutKind::Bad,
        _ if skipped > 0 || answer.is_partial() => CalloutKind::Warning,
        _ => CalloutKind::Good,
    };
    let title = match strokes {
        0 => "No stroke has a failure force".to_owned(),
        1 => "One stroke has a failure force".to_owned(),
        n => format!("{n} strokes have a failure force"),
    };
    let left = match (skipped, answer.is_partial()) {
        (0, false) => "nothing was left out",
        (0, true) => "some logs are damaged or could not be used, see the end of the page",
        (_, false) => "parts without one are listed at the end of the page",
        (_, true) => "parts without one, and logs that are damaged, are listed at the end of the page",
    };
    let logs = match answer.logs.len() {
        1 => "one log was".to_owned(),
        n => format!("{n} logs were"),
    };
    page.verdict(kind, title, format!("{} read; {left}.", sentence_case(&logs)));
    skipped
}

/// What strokes say together.
fn sections(page: &mut HtmlReport, analysis: &Analysis, strokes: &[StrokeRecord]) -> Result<(), PageError> {
    let show = |page: &mut HtmlReport, figure: Option<Figure>, caption: &str| -> Result<(), PageError> {
        if let Some(figure) = figure {
            page.figure(&figure, Size::default(), caption)?;
        }
        Ok(())
    };
    page.heading("Failure forces");
    show(
        page,
        figures::campaign(analysis, strokes)?,
        "Each force is scaled with the square of its measured depth to the nominal one. Bars are one standard deviation.",
    )?;
    groups(page, analysis)?;
    for (name, effect) in [("Radius", &analysis.radius), ("Base angle", &analysis.base_angle)] {
        if let Some(effect) = effect {
            let kind = if effect.p < 0.05 { CalloutKind::Warning } else { CalloutKind::Good };
            page.callout(kind, name, effect.verdict.as_str());
        }
    }
    if let Some(found) = &analysis.friction {
        page.heading("Interface friction");
        page.paragraph(friction(found));
        show(
            page,
            figures::friction(analysis)?,
            "Failed soil slips up along the plate and turns the force to the interface friction, whatever the set-point is. Where \
             nothing is left to turn, the set-point is the friction.",
        )?;
    }
    if let Some(found) = &analysis.rubbing {
        page.heading("Check by rubbing");
        page.paragraph(format!(
            "The friction angle peaks at {:.2}°; two thirds of {} peaks lie between {:.2} and {:.2}°.",
            found.peak_deg, found.peaks, found.range_deg[0], found.range_deg[1]
        ));
        show(page, figures::rubbing(analysis)?, "Friction angle while the sand-covered plate is rubbed.")?;
    }
    if !analysis.depth_laws.is_empty() {
        page.heading("Force and depth");
        for law in &analysis.depth_laws {
            let [low, high] = law.exponent_95;
            let kind = if law.agrees_with_square { CalloutKind::Good } else { CalloutKind::Warning };
            let title = format!("{}°: F ~ H^{:.2}", number(law.alpha_deg), law.exponent);
            let text = format!(
                "95 % confidence {low:.2} to {high:.2} from {} strokes; soil without cohesion has 2.",
                law.strokes
            );
            page.callout(kind, &title, text);
        }
        show(
            page,
            figures::depth(analysis, strokes)?,
            "Level where the force goes with the square of depth.",
        )?;
    }
    Ok(())
}

fn friction(found: &Friction) -> String {
    let bracket = match (found.above_deg, found.below_deg) {
        (Some(above), Some(below)) => format!("The lifts put it between {above} and {below}°."),
        (Some(above), None) => format!("All set-points up to {above}° lift: sweep further up."),
        (None, Some(below)) => format!("No set-point lifts, from {below}° on: sweep further down."),
        (None, None) => String::new(),
    };
    format!(
        "δ = {:.2} ± {:.2}° (one standard deviation) from {} strokes. {bracket}",
        found.delta_deg,
        found.sd_deg,
        found.strokes.len()
    )
}

fn groups(page: &mut HtmlReport, analysis: &Analysis) -> Result<(), PageError> {
    let columns = [
        ("tool angle (deg)", Align::Right),
        ("strokes", Align::Right),
        ("mean (N)", Align::Right),
        ("sd (N)", Align::Right),
        ("variation (%)", Align::Right),
        ("outliers", Align::Left),
        ("model (N)", Align::Right),
        ("difference (%)", Align::Right),
        ("matched φ (deg)", Align::Right),
    ];
    let title = format!("Forces at a slant length of {} mm", number(analysis.slant_m * 1e3));
    let mut table = Table::new(title, columns);
    let cell =
        |value: Option<f64>, digits: usize| value.map_or("–".into(), |value| format!("{value:.digits$}"));
    for group in &analysis.groups {
        table.row([
            number(group.alpha_deg),
            group.strokes.to_string(),
            format!("{:.3}", group.mean_n),
            cell(group.sd_n, 3),
            cell(group.coefficient_of_variation.map(|v| 100.0 * v), 1),
            group.outliers.join(", "),
            cell(group.model_n, 3),
            cell(group.model_difference.map(|v| 100.0 * v), 1),
            cell(group.matched_phi_deg, 2),
        ])?;
    }
    page.table(table);
    if let Some(c) = &analysis.comparison {
        page.paragraph(format!(
            "Model {} at {} kg/m³ and δ = {:.2}°{}. The matched friction angle is the one at which the model gives the mean.",
            c.model,
            number(c.density_kg_m3),
            c.delta_deg,
            c.phi_deg.map_or(String::new(), |phi| format!(", φ = {}°", number(phi)))
        ));
    }
    Ok(())
}

/// Where the ground broke, by clouds of points around the strokes.
fn scans(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    if answer.logs.iter().all(|log| log.scans.is_empty()) {
        return Ok(());
    }
    page.heading("Where the ground broke");
    let columns = [
        ("stroke", Align::Left),
        ("scans at (s)", Align::Left),
        ("ahead (mm)", Align::Right),
        ("what to know", Align::Left),
    ];
    let mut table = Table::new("By scans before and after each stroke", columns);
    for scan in answer.logs.iter().flat_map(|log| &log.scans) {
        let at =
            [scan.before_s, scan.after_s].map(|t_s| t_s.map_or("–".to_owned(), |t_s| format!("{t_s:.2}")));
        let distance = scan.break_distance_m.zip(scan.break_distance_sd_m);
        table.row([
            scan.stroke_id.clone(),
            at.join(", "),
            distance.map_or("–".to_owned(), |(m, sd_m)| format!("{:.1} ± {:.1}", 1e3 * m, 1e3 * sd_m)),
            scan.reason.iter().chain(&scan.warnings).cloned().collect::<Vec<_>>().join("; "),
        ])?;
    }
    page.table(table);
    Ok(())
}

fn left_out(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    page.heading("What gave no force");
    let columns = [("log or stroke", Align::Left), ("from (s)", Align::Right), ("reason", Align::Left)];
    let mut table = Table::new("Nothing is left out without a reason", columns);
    for log in &answer.logs {
        if let Some(error) = &log.error {
            table.row([log.log.clone(), String::new(), error.clone()])?;
        }
        for damage in &log.damage {
            table.row([log.log.clone(), String::new(), damage.clone()])?;
        }
        for skipped in &log.skipped {
            let name = skipped.stroke_id.clone().unwrap_or_else(|| log.name.clone());
            table.row([name, format!("{:.2}", skipped.from_s), skipped.reason.clone()])?;
        }
    }
    page.table(table);
    Ok(())
}
