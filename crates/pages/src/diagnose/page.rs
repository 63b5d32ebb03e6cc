//! The page of a diagnosis: where, what, how sure, what else, what changes, what next.

use soilctl_app::diagnose::{Answer, Diagnosed};
use soilctl_app::text::{number, sentence_case};
use soilctl_diagnosis::Part;
use soilctl_effects::Covariate;
use soilctl_figure::{Align, CalloutKind, HtmlReport, Size, Table};

use super::{figures, traces};
use crate::PageError;

/// Most covariates that residuals are drawn over.
const MOST_FIGURES: usize = 3;
/// Most disagreements that are listed.
const MOST_PLACES: usize = 12;
/// Explanations that are listed.
const MOST_RIVALS: usize = 8;

pub(super) fn page(work: &Diagnosed) -> Result<HtmlReport, PageError> {
    let answer = &work.answer;
    let mut page = HtmlReport::new(&work.title);
    page.kind("Diagnosis").subtitle(format!(
        "{} strokes against the force model {}",
        answer.strokes,
        work.against.described()
    ));
    let kind = match answer.status.as_str() {
        "none" | "named" => CalloutKind::Good,
        _ => CalloutKind::Warning,
    };
    page.verdict(kind, sentence_case(&answer.status.replace('_', " ")), answer.sentence());
    places(&mut page, work, answer)?;
    what(&mut page, answer)?;
    rivals(&mut page, work, answer)?;
    changes(&mut page, work, answer)?;
    next(&mut page, answer)?;
    testability(&mut page, answer)?;
    Ok(page)
}

fn places(page: &mut HtmlReport, work: &Diagnosed, answer: &Answer) -> Result<(), PageError> {
    page.heading("Where model and measurement disagree");
    if answer.located.is_empty() {
        page.paragraph("No column varies over any recorded condition by more than chance, once the soil is recalibrated.");
    } else {
        let columns = [
            ("column", Align::Left),
            ("when", Align::Left),
            ("over", Align::Left),
            ("adjusted p", Align::Right),
        ];
        let mut table =
            Table::new("Disagreements that are more than chance (false discoveries held at 5 %)", columns);
        for place in answer.located.iter().take(MOST_PLACES) {
            table.row([
                place.channel.clone(),
                place.phase.as_deref().unwrap_or("whole stroke").replace('_', " "),
                place.covariate.clone(),
                format!("{:.2e}", place.p_adjusted),
            ])?;
        }
        page.table(table);
        if answer.located.len() > MOST_PLACES {
            page.paragraph(format!("{} more are in the answer.", answer.located.len() - MOST_PLACES));
        }
    }
    let mut over: Vec<&str> = Vec::new();
    let found = answer
        .located
        .iter()
        .filter(|place| place.channel == "force_n")
        .map(|place| place.covariate.as_str());
    for name in found.chain(["depth_m", "alpha_deg"]) {
        if !over.contains(&name) && over.len() < MOST_FIGURES {
            over.push(name);
        }
    }
    for name in over {
        if let Some(figure) = figures::residuals(work, name)? {
            page.figure(&figure, Size::new(760, 380)?, "Each point is a stroke; zero is perfect agreement.")?;
        }
    }
    if work.traces.is_some() {
        page.paragraph(format!(
            "{} of {} strokes have a trace in which the failure was found.",
            answer.traces, answer.strokes
        ));
    }
    Ok(())
}

fn what(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    page.heading("What is missing, and how sure that is");
    if answer.effects.is_empty() {
        page.paragraph("No effect of the catalogue is named.");
        return without_a_name(page, answer);
    }
    let columns = [
        ("effect", Align::Left),
        ("what it is", Align::Left),
        ("parameters", Align::Left),
        ("ln Bayes factor", Align::Right),
    ];
    let mut table = Table::new("Effects of the best explanation", columns);
    for found in &answer.effects {
        let parameters: Vec<String> =
            found.parameters.iter().map(|(name, p)| format!("{name} {}", p.text())).collect();
        table.row([
            found.id.to_string(),
            found.id.title().into(),
            parameters.join("; "),
            format!("{:.1}", found.log_bayes_factor),
        ])?;
    }
    page.table(table);
    page.paragraph(
        "The ln Bayes factor says how much more probable the forces are with the effect than without it: 5 is a \
         factor of 150. Plausible ranges of the parameters are part of it, so a free parameter pays for itself.",
    );
    Ok(())
}

/// What the force does over conditions of the strokes, where no effect explains it.
fn without_a_name(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    for term in &answer.empirical {
        page.paragraph(format!(
            "What the forces do over {} takes its place in the model file, as a table without a law behind it: it says nothing of conditions that these \
             strokes did not have. ln Bayes factor {:.1}.",
            term.over.join(" and "),
            term.log_bayes_factor
        ));
        let conditions = term.over.iter().map(|name| (name.clone(), Align::Right));
        let columns = conditions.chain([("change of the force".to_owned(), Align::Right)]);
        let mut table = Table::new("An empirical term", columns);
        for point in term.points() {
            let [change, sd] = point.change.map(|share| 100.0 * share);
            let at = point.at.iter().map(|value| number(*value));
            table.row(at.chain([format!("{change:+.1} ± {sd:.1} %")]))?;
        }
        page.table(table);
    }
    Ok(())
}

fn rivals(page: &mut HtmlReport, work: &Diagnosed, answer: &Answer) -> Result<(), PageError> {
    page.heading("What else it could be");
    if answer.equivalence_set.len() > answer.effects.len().max(1) {
        page.paragraph(format!("Not told apart by these data: {}.", answer.equivalence_set.join(", ")));
    }
    let columns =
        [("effect alone", Align::Left), ("what it is", Align::Left), ("ln Bayes factor", Align::Right)];
    let mut table = Table::new("Single effects, best first", columns);
    for (id, factor) in work.diagnosis.alone.iter().take(MOST_RIVALS) {
        table.row([id.to_string(), id.title().into(), format!("{factor:.1}")])?;
    }
    page.table(table);
    Ok(())
}

fn changes(page: &mut HtmlReport, work: &Diagnosed, answer: &Answer) -> Result<(), PageError> {
    page.heading("What changes when it is added");
    page.figure(&figures::forces(work)?, Size::new(640, 480)?, "On the line, model and measurement agree.")?;
    for (figure, caption) in traces::figures(work)? {
        page.figure(&figure, Size::new(760, 380)?, &caption)?;
    }
    let shown = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.3}"));
    let columns = [("", Align::Left), ("without effects", Align::Right), ("with effects", Align::Right)];
    let mut table =
        Table::new("The gap; held out means that each batch is predicted from the others", columns);
    let gap = &answer.gap;
    table.row(["RMS of ln force".into(), shown(Some(gap.before)), shown(Some(gap.after))])?;
    table.row(["RMS of ln force, held out".into(), shown(gap.heldout_before), shown(gap.heldout_after)])?;
    table.row([
        "chi² a stroke, held out".into(),
        shown(gap.chi2_per_n_before),
        shown(gap.chi2_per_n_after),
    ])?;
    let (before, after) = (&work.diagnosis.comparison.soil_before, &work.diagnosis.comparison.soil_after);
    table.row([
        "Friction angle (deg)".into(),
        format!("{:.2} ± {:.2}", before.phi_deg, before.phi_sd_deg),
        format!("{:.2} ± {:.2}", after.phi_deg, after.phi_sd_deg),
    ])?;
    table.row([
        "Density (kg/m³)".into(),
        format!("{:.0} ± {:.0}", before.density_kg_m3, before.density_sd_kg_m3),
        format!("{:.0} ± {:.0}", after.density_kg_m3, after.density_sd_kg_m3),
    ])?;
    page.table(table);
    if let (Some(gain), Some(error)) = (gap.delta_elpd, gap.delta_elpd_se) {
        page.paragraph(format!(
            "Expected log predictive density of unseen batches changes by {gain:.1} ± {error:.1}."
        ));
    }
    shrinks(page, work)
}

/// The held-out gap column by column, and that of the forces along the conditions where they disagree most.
fn shrinks(page: &mut HtmlReport, work: &Diagnosed) -> Result<(), PageError> {
    let parts = &work.diagnosis.comparison.parts;
    if parts.is_empty() {
        page.paragraph(
            "With one batch there is none to leave out, so the gap is not divided by column and condition.",
        );
        return Ok(());
    }
    let cells = |part: &Part| {
        let gap = [part.before, part.after].map(|value| format!("{value:.2}"));
        let gain = format!("{:.1} ± {:.1}", part.delta_elpd, part.delta_elpd_se);
        std::iter::once(part.readings.to_string()).chain(gap).chain([gain])
    };
    let right = |name| (name, Align::Right);
    let numbers =
        [right("readings"), right("without effects"), right("with effects"), right("gain in ln density")];
    let mut table = Table::new(
        "The held-out gap by column, in standard deviations of the prediction with effects: 1 is what scatter leaves",
        [("column", Align::Left)].into_iter().chain(numbers),
    );
    for part in parts.iter().filter(|part| part.covariate.is_none()) {
        table.row([part.channel.to_owned()].into_iter().chain(cells(part)))?;
    }
    page.table(table);
    // Over which the largest part differs most from the smallest before anything is added.
    let forces: Vec<&Part> = parts.iter().filter(|part| part.channel == "force_n").collect();
    let mut conditions: Vec<(Covariate, f64)> = Vec::new();
    for name in forces.iter().filter_map(|part| part.covariate) {
        if conditions.iter().all(|(other, _)| *other != name) {
            let of = || forces.iter().filter(|part| part.covariate == Some(name)).map(|part| part.before);
            conditions.push((name, of().fold(0.0, f64::max) - of().fold(f64::INFINITY, f64::min)));
        }
    }
    conditions.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut table = Table::new(
        "The held-out gap of the forces along the conditions over which it varies most, in the same unit",
        [("condition", Align::Left), ("from", Align::Right), ("to", Align::Right)].into_iter().chain(numbers),
    );
    for &(name, _) in conditions.iter().take(MOST_FIGURES) {
        for part in forces.iter().filter(|part| part.covariate == Some(name)) {
            let [from, to] = part.range.map_or_else(Default::default, |range| range.map(number));
            table.row([name.to_string(), from, to].into_iter().chain(cells(part)))?;
        }
    }
    page.table(table);
    page.paragraph("All columns along all conditions are in gap.csv. Gains count each reading on its own; strokes of a batch have an error in common, which the density of whole batches above takes into account.");
    Ok(())
}

fn next(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    page.heading("What to measure next");
    match &answer.next_experiment {
        Some(next) => {
            page.paragraph(format!(
                "{}. The chance that this settles it is {:.0} %. The strokes are in {}; append their results to the \
                 stroke table as further batches.",
                next.text,
                100.0 * next.power,
                next.design_csv
            ));
            if let Some(plan) = &next.plan {
                page.paragraph(format!(
                    "{plan} is the plan of the campaign with these strokes after those that were made."
                ));
            }
        }
        None => {
            page.paragraph("No follow-up on the menu would tell more.");
        }
    }
    Ok(())
}

fn testability(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    page.heading("What this design could show");
    let columns = [
        ("effect", Align::Left),
        ("typical amplitude", Align::Right),
        ("largest", Align::Right),
        ("testable", Align::Left),
    ];
    let mut table = Table::new(
        "Expected squared signal-to-noise ratio, before any force is looked at; below 8 nothing can be named",
        columns,
    );
    for of in &answer.testability {
        table.row([
            of.id.clone(),
            format!("{:.1}", of.lambda),
            format!("{:.1}", of.lambda_largest),
            of.verdict.clone(),
        ])?;
    }
    page.table(table);
    Ok(())
}
