//! The page of a failure surface.

use soilctl_app::surface::{Agreement, Answer};
use soilctl_app::text::{number, range};
use soilctl_figure::{
    Align, Axis, CalloutKind, Figure, HtmlReport, Marker, Points, RefLine, Size, Span, Table,
};

use crate::PageError;

/// The page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("What does the crack ahead of the plate say?");
    let [low, high] = answer.delta_deg.map(number);
    page.kind("Failure surface").subtitle(format!(
        "{} break distances, interface friction {low} to {high}°, beside the forces under model {}",
        answer.strokes.len(),
        answer.force.model
    ));
    let of = |kind| answer.models.iter().filter(|said| said.agreement == kind).count();
    let (kind, title) = if of(Agreement::Agrees) == answer.models.len() {
        (CalloutKind::Good, "Surface and forces agree")
    } else if of(Agreement::Agrees) > 0 {
        (CalloutKind::Warning, "It depends on the model of the surface")
    } else if answer.force.phi_deg.is_none() {
        (CalloutKind::Warning, "The forces contradict each other")
    } else {
        (CalloutKind::Bad, "Surface and forces contradict each other")
    };
    page.verdict(kind, title, answer.verdict.as_str());
    for warning in &answer.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    page.heading("Friction angles");
    page.figure(
        &frictions(answer)?,
        Size::new(760, 360)?,
        "Friction angles that explain every break distance, by each model of the surface; the strip is what the forces leave.",
    )?;
    page.table(models(answer)?);
    page.heading("Break distances");
    page.figure(
        &distances(answer)?,
        Size::new(760, 440)?,
        "Measured distances with their bands, and what models predict for the soils that the forces leave.",
    )?;
    page.table(strokes(answer)?);
    page.heading("Method");
    page.paragraph(
        "Each model has a slip surface for each friction angle and friction on the plate, and says where it meets the ground. A friction angle explains the \
         measurement if it does so for every stroke within its band, for some friction on the plate within what is known. Angles are enclosed, so none \
         that explains the measurement is lost. Limit analysis proves forces, not where soil fails; sand that dilates less than its friction angle breaks nearer \
         to the plate than the mechanism of an upper bound, which is what the model without dilation is for.",
    );
    Ok(page)
}

/// A bar for each model.
fn frictions(answer: &Answer) -> Result<Figure, PageError> {
    let count = answer.models.len() as f64;
    let y = Axis::linear("Model of the surface, as in the table").range(0.4, count + 0.6)?;
    let mut figure =
        Figure::new("Friction angle by surface and by force", Axis::linear("Friction angle φ (deg)"), y);
    if let Some([low, high]) = answer.force.phi_deg {
        figure.push(Span::vertical("by forces", low, high))?;
    }
    let mut none = true;
    for (place, said) in (1..).zip(&answer.models) {
        let Some([low, high]) = said.phi_deg else { continue };
        none = false;
        let y = f64::from(place);
        let line = vec![(low, y), (high, y)];
        figure.push(
            soilctl_figure::Line::new(said.surface.name(), line).width(8.0).dash(soilctl_figure::Dash::Solid),
        )?;
    }
    if none && answer.force.phi_deg.is_none() {
        figure.push(RefLine::vertical("nothing explains surface or forces", 0.0))?;
    }
    Ok(figure)
}

fn models(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("model of the surface", Align::Left),
        ("φ by the surface (deg)", Align::Right),
        ("with the forces (deg)", Align::Right),
        ("ρ then (kg/m³)", Align::Right),
        ("", Align::Left),
    ];
    let mut table =
        Table::new("What models of the surface say, in the order of the figure from below", columns);
    for said in &answer.models {
        let words = match said.agreement {
            Agreement::Agrees => "agrees with the forces",
            Agreement::Nearer => "the ground breaks nearer than the forces say",
            Agreement::Farther => "the ground breaks farther than the forces say",
            Agreement::NoFriction => "explains the distances by no friction angle",
            Agreement::NoForce => "no soil explains the forces",
        };
        table.row([
            said.surface.name().to_owned(),
            range(said.phi_deg, 2),
            range(said.phi_both_deg, 2),
            range(said.density_both_kg_m3, 0),
            words.to_owned(),
        ])?;
    }
    Ok(table)
}

/// Distances by stroke, in mm.
fn distances(answer: &Answer) -> Result<Figure, PageError> {
    let mut figure = Figure::new(
        "Where the ground broke",
        Axis::linear("Stroke, as in the table"),
        Axis::linear("Distance from the plate (mm)"),
    );
    let mm = |m: f64| 1e3 * m;
    let places = || (1..=answer.strokes.len()).map(|i| i as f64);
    let measured: Vec<(f64, f64)> =
        places().zip(&answer.strokes).map(|(i, s)| (i, mm(s.distance_m))).collect();
    let errors: Vec<(f64, f64)> =
        answer.strokes.iter().map(|s| [answer.deviations * mm(s.sd_m); 2].into()).collect();
    let labels = answer.strokes.iter().map(|s| s.label.clone());
    figure.push(
        Points::new("measured", measured).y_error(errors).labels(labels).marker(Marker::Circle).color(6),
    )?;
    for (model, said) in answer.models.iter().enumerate() {
        let shift = 0.12 * (model as f64 + 1.0);
        let of = places()
            .zip(&answer.strokes)
            .filter_map(|(i, s)| Some((i + shift, (*s.predicted_m.get(model)?)?)));
        let of: Vec<(f64, [f64; 2])> = of.collect();
        let middles: Vec<(f64, f64)> = of.iter().map(|(x, [l, h])| (*x, mm(f64::midpoint(*l, *h)))).collect();
        let halves: Vec<(f64, f64)> = of.iter().map(|(_, [l, h])| [mm(0.5 * (h - l)); 2].into()).collect();
        if !middles.is_empty() {
            figure.push(Points::new(said.surface.name(), middles).y_error(halves).color(model))?;
        }
    }
    Ok(figure)
}

fn strokes(answer: &Answer) -> Result<Table, PageError> {
    let mut columns =
        vec![("stroke", Align::Left), ("measured (mm)", Align::Right), ("± (mm)", Align::Right)];
    columns.extend(answer.models.iter().map(|said| (said.surface.name(), Align::Right)));
    let mut table = Table::new("Break distances and what models predict (mm)", columns);
    for stroke in &answer.strokes {
        let mm = |m: f64| format!("{:.1}", 1e3 * m);
        let mut row = vec![stroke.label.clone(), mm(stroke.distance_m), mm(answer.deviations * stroke.sd_m)];
        row.extend(stroke.predicted_m.iter().map(|p| range(p.map(|p| p.map(|m| 1e3 * m)), 1)));
        table.row(row)?;
    }
    Ok(table)
}
