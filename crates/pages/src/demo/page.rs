//! The page: the soil, what the arm did, what was found, and how far that is from the truth.

use soilctl_app::demo::{Answer, Work};
use soilctl_app::text::{number, range, yes};
use soilctl_figure::{Align, CalloutKind, HtmlReport, RichText, Table};

use super::figures::Drawn;
use super::findings;
use super::shown::show;
use crate::PageError;

pub(super) fn page(answer: &Answer, work: &Work, drawn: &Drawn) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new(&answer.title);
    let count = answer.strokes;
    page.kind("Demonstration").subtitle(format!(
        "{} strokes on the simulated arm, {} with a failure force; model {}, seed {}",
        count.asked, count.with_force, answer.model, answer.seed
    ));
    summary(&mut page, answer)?;
    soil(&mut page, answer, work)?;
    arm(&mut page, answer, work, drawn)?;
    findings::forces(&mut page, answer, drawn)?;
    findings::friction(&mut page, answer, drawn)?;
    findings::estimate(&mut page, answer, drawn)?;
    findings::honest(&mut page, answer)?;
    again(&mut page, answer, work);
    Ok(page)
}

fn summary(page: &mut HtmlReport, answer: &Answer) -> Result<(), PageError> {
    let (kind, title) = match answer.not_recovered.len() {
        0 => (CalloutKind::Good, "Everything was recovered".to_owned()),
        1 => (CalloutKind::Warning, "One thing was not recovered".to_owned()),
        n => (CalloutKind::Warning, format!("{n} things were not recovered")),
    };
    let text = match &answer.not_recovered[..] {
        [] => "Strokes, forces, interface friction, friction angle and density are where they should be."
            .to_owned(),
        list => format!("{}.", list.join("; ")),
    };
    page.verdict(kind, &title, format!("{} {text}", answer.found));
    let columns = [
        ("", Align::Left),
        ("estimate", Align::Right),
        ("truth", Align::Right),
        ("holds the truth", Align::Left),
    ];
    let mut table = Table::new("What was found, and what is true", columns);
    let truth = &answer.truth;
    if let Some(delta) = &answer.delta {
        let verdict = if delta.determined { yes(delta.holds_truth) } else { "does not count" };
        table.row([
            "Interface friction δ (deg)".to_owned(),
            format!("{:.1} ± {:.1}", delta.delta_deg, delta.sd_deg),
            number(truth.delta_deg),
            verdict.to_owned(),
        ])?;
    }
    for (name, region) in answer.regions() {
        table.row([
            format!("Friction angle φ (deg), {name}"),
            range(region.phi_deg, 1),
            number(truth.phi_deg),
            yes(region.phi_holds_truth).to_owned(),
        ])?;
        table.row([
            format!("Density ρ (kg/m³), {name}"),
            range(region.density_kg_m3, 0),
            number(truth.density_kg_m3),
            yes(region.density_holds_truth).to_owned(),
        ])?;
    }
    if answer.delta.is_some() || answer.density_unknown.is_some() {
        page.table(table);
    }
    Ok(())
}

fn soil(page: &mut HtmlReport, answer: &Answer, work: &Work) -> Result<(), PageError> {
    let truth = &answer.truth;
    page.heading("The soil");
    page.paragraph(format!(
        "{}: a soil that the simulator knows and the estimate does not. When it fails, it bears what the force model {} \
         says{}.",
        answer.title,
        answer.model,
        if answer.model == "table" { ", in the middle between its proven bounds" } else { "" }
    ));
    page.definitions([
        ("Friction angle φ", format!("{}°", number(truth.phi_deg))),
        ("Friction between soil and plate δ", format!("{}°", number(truth.delta_deg))),
        ("Density ρ", format!("{} kg/m³", number(truth.density_kg_m3))),
        ("Cohesion (known to the estimate)", format!("{} Pa", number(truth.cohesion_pa))),
        ("Gravity (known to the estimate)", format!("{} m/s²", number(truth.gravity_m_s2))),
        ("End factor (0 in plane strain)", number(truth.end_factor)),
        (
            "Density as weighed",
            work.density_kg_m3.map_or("not weighed".into(), |density| {
                format!("{density:.0} kg/m³, mean of {} preparations", work.plan.batches())
            }),
        ),
    ]);
    Ok(())
}

fn arm(page: &mut HtmlReport, answer: &Answer, work: &Work, drawn: &Drawn) -> Result<(), PageError> {
    let count = answer.strokes;
    page.heading("What the arm did");
    page.paragraph(format!(
        "{} preparations of the soil with {} strokes together. Strokes at 80 and 90° sweep the set-point of the interface \
         friction around {}°, the published value; the others, at four tool angles and two depths, tell friction angle \
         from density. {} strokes were made to their end.",
        work.plan.batches(),
        count.asked,
        number(answer.delta_guess_deg),
        count.made,
    ));
    show(
        page,
        drawn.curves.as_ref(),
        "Force of the soil on the plate against the way by the motors' encoders, free play and stretch included, from where \
         the load that the insertion has left along the plate is gone. Round: the failure that was found. Diamond: the moment \
         at which the simulated soil failed.",
    )?;
    Ok(())
}

fn again(page: &mut HtmlReport, answer: &Answer, work: &Work) {
    page.heading("The same by hand");
    page.paragraph("Every step is a verb of its own, and reads the files that this demonstration left.");
    let folder = &answer.files.folder;
    let mut entries = vec![
        ("Simulate", format!("soilctl simulate {} --out runs --seed {}", answer.files.plan, answer.seed)),
        ("Look at a stroke", format!("soilctl monitor --play {folder}/batch_000.mcap --open")),
        ("Find failure forces", format!("soilctl process {folder} --out runs/strokes.csv")),
    ];
    let estimated = work.estimates.first().and_then(|estimated| estimated.work.as_ref().ok());
    if let (Some(table), Some(estimated)) = (&answer.files.measurements, estimated) {
        let request = &estimated.request;
        let mut line = format!(
            "soilctl report {table} --model {} --delta column --delta-tol {:.2} --gravity {}",
            request.model, request.delta_tol_deg, request.loads.gravity_m_s2
        );
        if request.loads.cohesion_pa > 0.0 {
            line += &format!(" --cohesion {}", request.loads.cohesion_pa);
        }
        entries.push(("Estimate, on a page with more detail", line));
    }
    page.definitions(entries.into_iter().map(|(name, line)| (name, RichText::default().code(line))));
}
