//! The page, section by section.

use soilctl_app::estimate::{Centre, Estimation, Point, distinct};
use soilctl_app::report::Report;
use soilctl_app::text::number;
use soilctl_figure::{Align, CalloutKind, HtmlReport, RichText, Size, Table};

use super::{budget, curves, shear};
use crate::{PageError, estimate as figures};

/// Tool angles for which the models are drawn against the friction angle.
const MOST_CURVES: usize = 6;

/// The page of a report.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(report: &Report) -> Result<HtmlReport, PageError> {
    let work = &report.estimation;
    let mut page = HtmlReport::new(&report.title);
    page.kind("Soil estimate").subtitle(subtitle(work));
    verdict(&mut page, work)?;
    ends(&mut page, work)?;
    measurements(&mut page, work)?;
    regions(&mut page, work)?;
    models(&mut page, work)?;
    budget::section(&mut page, &report.budget)?;
    if report.asked_for_shear {
        shear::section(&mut page, report.shear.as_ref())?;
    }
    next(&mut page, work)?;
    optimisers(&mut page, work)?;
    method(&mut page, work);
    Ok(page)
}

fn subtitle(work: &Estimation) -> String {
    let a = &work.answer;
    let density = match a.density_known_kg_m3 {
        Some([low, high]) => format!("density known within {low:.0} to {high:.0} kg/m³"),
        None => "density unknown".into(),
    };
    format!(
        "{} measurements, model {}, interface friction {} to {}°, {density}, {}",
        a.measurements.len(),
        a.model,
        number(a.delta_deg[0]),
        number(a.delta_deg[1]),
        work.inputs.band_in_words(&work.request),
    )
}

fn verdict(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    let a = &work.answer;
    let kind = if a.consistent { CalloutKind::Good } else { CalloutKind::Bad };
    let title =
        if a.consistent { "The measurements agree" } else { "The measurements contradict each other" };
    page.verdict(kind, title, a.verdict.as_str());
    for warning in &a.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    let (Some(phi), Some(density)) = (a.phi_deg, a.density_kg_m3) else { return Ok(()) };
    let columns = [
        ("", Align::Left),
        ("consistent from", Align::Right),
        ("to", Align::Right),
        ("centre ±", Align::Right),
        ("least misfit", Align::Right),
    ];
    let mut table = Table::new(
        "Estimate: the full range, its centre with the half width that covers it, and the soil of least misfit inside it",
        columns,
    );
    let centre = |pick: fn(&Centre) -> String| a.centre.as_ref().map_or("–".into(), pick);
    let best = |pick: fn(&Point) -> String| a.best_estimate.as_ref().map_or("–".into(), pick);
    table.row([
        "Friction angle φ (deg)".to_owned(),
        format!("{:.2}", phi[0]),
        format!("{:.2}", phi[1]),
        centre(|c| format!("{:.2} ± {:.2}", c.phi_deg, c.phi_half_width_deg)),
        best(|b| format!("{:.2}", b.phi_deg)),
    ])?;
    table.row([
        "Density ρ (kg/m³)".to_owned(),
        format!("{:.0}", density[0]),
        format!("{:.0}", density[1]),
        centre(|c| format!("{:.0} ± {:.0}", c.density_kg_m3, c.density_half_width_kg_m3)),
        best(|b| format!("{:.0}", b.density_kg_m3)),
    ])?;
    table.row([
        "Interface friction δ (deg)".to_owned(),
        format!("{:.2}", a.delta_deg[0]),
        format!("{:.2}", a.delta_deg[1]),
        "as given".to_owned(),
        best(|b| format!("{:.2}", b.delta_deg)),
    ])?;
    page.table(table);
    Ok(())
}

/// The estimate with and without ends, side by side.
fn ends(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    let a = &work.answer;
    let Some(plane) = &a.plane_strain else { return Ok(()) };
    page.heading("With and without ends");
    let [narrow, wide] = a.width_ratio.map(|ratio| format!("{ratio:.1}"));
    let widths = if narrow == wide { narrow } else { format!("{narrow} to {wide}") };
    page.paragraph(format!(
        "A plate moves the soil ahead of it and also some beside its two ends, so it needs more force than a piece of the same width of an \
         endless plate (plane strain). The plates here are {widths} times as wide as deep. Who takes the measured force for that of plane \
         strain explains what the ends add by stronger soil, and finds a friction angle that is too high."
    ));
    let columns = [
        ("", Align::Left),
        ("φ from (deg)", Align::Right),
        ("to", Align::Right),
        ("ρ from (kg/m³)", Align::Right),
        ("to", Align::Right),
    ];
    let mut table = Table::new("The same measurements, understood in two ways", columns);
    let row = |name: &str, phi: Option<[f64; 2]>, density: Option<[f64; 2]>| {
        let ends = |range: Option<[f64; 2]>, digits: usize| {
            range.map_or(["–".into(), "–".into()], |range| range.map(|x| format!("{x:.digits$}")))
        };
        let ([a, b], [c, d]) = (ends(phi, 1), ends(density, 0));
        [name.to_owned(), a, b, c, d]
    };
    table.row(row("with ends", a.phi_deg, a.density_kg_m3))?;
    table.row(row("without ends (plane strain)", plane.phi_deg, plane.density_kg_m3))?;
    page.table(table);
    if !plane.consistent {
        page.paragraph("Without ends no soil explains all measurements.");
    }
    if let Some([low, high]) = a.end_factor {
        page.paragraph(format!(
            "What ends add is known to lie between nothing and a proven most. The measurements are explained if it is between {:.0} and \
             {:.0} % of that most, nearly the same part for all strokes. Strokes with a plate of another width, or at another depth, would \
             narrow this.",
            100.0 * low,
            100.0 * high
        ));
    }
    Ok(())
}

fn measurements(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    page.heading("Measurements");
    let columns = [
        ("measurement", Align::Left),
        ("strokes", Align::Right),
        ("force (N)", Align::Right),
        ("band from (N)", Align::Right),
        ("to (N)", Align::Right),
        ("scatter (%)", Align::Right),
        ("stated (%)", Align::Right),
        ("of mean (%)", Align::Right),
        ("in common (%)", Align::Right),
    ];
    let is_pooled = work.answer.confidence.is_some();
    let shown = if is_pooled { columns.len() } else { columns.len() - 4 };
    let mut table = Table::new("Failure forces and the bands they allow", columns.into_iter().take(shown));
    let percent = |share: Option<f64>| share.map_or("–".into(), |x| format!("{:.1}", 100.0 * x));
    for m in &work.answer.measurements {
        let mut row = vec![
            m.label.clone(),
            m.strokes.to_string(),
            format!("{:.3}", m.force_n),
            format!("{:.3}", m.force_low_n),
            format!("{:.3}", m.force_high_n),
        ];
        if let Some(p) = &m.pooled {
            row.extend(p.shares().map(percent));
        }
        table.row(row)?;
    }
    page.table(table);
    if let (Some(all), Some(each)) = (work.answer.confidence, work.answer.confidence_each) {
        page.paragraph(format!(
            "Strokes of one kind are one band. Deviations are those of one stroke by the scatter and as the table states it, of the mean, and of \
             what the strokes of a kind share. All bands together hold their true forces with {} %, each with {:.2} %.",
            number(100.0 * all),
            100.0 * each
        ));
    }
    Ok(())
}

fn regions(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    let size = Size::new(820, 520)?;
    if work.answer.consistent {
        page.heading("Soils that explain every measurement");
        page.figure(
            &figures::region(work)?,
            size,
            "Every friction angle and density inside the outline explains every measured force within its band, for \
             some interface friction in the given interval. The sections show single values of δ.",
        )?;
    }
    page.heading("Bands of the measurements");
    page.figure(
        &figures::bands(work)?,
        size,
        "Each measurement alone allows a band; steep bands (large tool angles) tell friction angles apart, flat \
         ones (small tool angles) densities.",
    )?;
    if work.answer.consistent && !work.projections.phi_delta.is_empty() {
        page.heading("The other projections");
        let volume = work.projections.volume;
        let size = volume.map_or_else(String::new, |volume| format!(" of {volume:.4} deg² kg/m³"));
        page.paragraph(format!(
            "The consistent set is a body in (φ, ρ, δ){size}; these are its other two shadows."
        ));
        page.figure(&figures::phi_delta(work)?, Size::default(), "Friction angle and interface friction.")?;
        page.figure(&figures::delta_density(work)?, Size::default(), "Interface friction and density.")?;
    }
    Ok(())
}

fn models(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    page.heading("Model and data");
    page.figure(
        &figures::fit(work)?,
        Size::new(820, 480)?,
        "Measured coefficients over the tool angle, with the model at the ends of the friction range and at the \
         soil of least misfit.",
    )?;
    let mut angles: Vec<f64> = work.answer.measurements.iter().map(|m| m.alpha_deg).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    for alpha in angles.into_iter().take(MOST_CURVES) {
        if let Some(figure) = curves::against_phi(work, alpha)? {
            page.figure(
                &figure,
                Size::default(),
                format!(
                    "All models at tool angle {}° against the friction angle; the horizontal strip is what was measured.",
                    number(alpha)
                ),
            )?;
        }
    }
    Ok(())
}

fn next(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    let Some(next) = &work.answer.next_strokes else { return Ok(()) };
    page.heading("Next best stroke");
    let columns = [
        "tool angle (deg)",
        "depth (mm)",
        "width (mm)",
        "area left (%)",
        "φ width (deg)",
        "ρ width (kg/m³)",
        "force (N)",
        "model",
    ];
    let mut table = Table::new(
        "What would be left of the region, on average over soils inside it",
        columns.map(|c| (c, Align::Right)),
    );
    for n in next.iter().take(12) {
        table.row([
            number(n.alpha_deg),
            format!("{:.1}", 1e3 * n.depth_m),
            format!("{:.0}", 1e3 * n.width_m),
            format!("{:.0}", 100.0 * n.area_left),
            format!("{:.2}", n.phi_width_deg),
            format!("{:.0}", n.density_width_kg_m3),
            format!("{:.2}", n.force_n),
            n.model.to_owned(),
        ])?;
    }
    page.table(table);
    if next.iter().any(|n| n.model != work.answer.model) {
        page.paragraph(
            "Rows under another model than the estimate's are at tool angles that its table does not cover; there both \
             prediction and region are Chen & Liu's closed form.",
        );
    }
    Ok(())
}

fn optimisers(page: &mut HtmlReport, work: &Estimation) -> Result<(), PageError> {
    let Some(minima) = &work.answer.optimisers else { return Ok(()) };
    page.heading("What plain optimisation would say");
    page.paragraph(
        "Local optimisers give one soil and no range, and where they end depends on where they start. Each row is one \
         distinct end; all three parameters were free.",
    );
    let columns = ["optimiser", "starts", "φ (deg)", "ρ (kg/m³)", "δ (deg)", "misfit", "in the region"]
        .map(|c| (c, Align::Right));
    let mut table = Table::new("Ends of downhill simplex and Levenberg-Marquardt", columns);
    for (m, count) in distinct(minima) {
        let [optimiser, rest @ ..] = m.cells();
        table.row([optimiser, count.to_string()].into_iter().chain(rest))?;
    }
    page.table(table);
    Ok(())
}

fn method(page: &mut HtmlReport, work: &Estimation) {
    page.heading("Method");
    page.paragraph(
        RichText::new("A force interval at given φ and δ is a density interval, because force is proportional to density. ")
            .text("The region is the intersection of these bands over all measurements and the union over δ; its \
                   boundary is moved outwards by at most 0.03 %, never inwards. If the uncertainties hold, the soil is ")
            .strong("inside")
            .text("."),
    );
    page.definitions([
        ("Model", work.model.reference().to_owned()),
        ("Coefficients", "normalised by the slant length, K = 2F/(γL²w), passive minus active".to_owned()),
        ("After", "W. Hong, Modeling, Estimation, and Control of Robot-Soil Interactions, PhD thesis, MIT 2001, chapter 7".to_owned()),
    ]);
}
