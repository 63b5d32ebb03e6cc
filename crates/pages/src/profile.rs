//! The page of a profile.

use soilctl_app::profile::{Answer, Hypothesis, Kind, Level, Predicted};
use soilctl_app::text::{number, range, yes};
use soilctl_figure::{
    Align, Axis, CalloutKind, Figure, HtmlReport, Marker, Points, Polygon, Polygons, RefLine, Size, Table,
    Text,
};

use crate::PageError;

/// The page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("Does the ground change with depth?");
    let [shallow, deep] = answer.depths_m.map(|m| number((1e4 * m).round() / 10.0));
    page.kind("Profile").subtitle(format!(
        "{} measurements from {shallow} to {deep} mm deep, model {}",
        answer.strokes.len(),
        answer.model
    ));
    let open = Kind::ALL.iter().filter(|kind| answer.allows(**kind)).count();
    let (kind, title) = match (answer.allows(Kind::OneSoil), open) {
        (true, _) => (CalloutKind::Note, "No change is found"),
        (false, 0) => (CalloutKind::Bad, "No ground explains the strokes"),
        (false, 1) => (CalloutKind::Good, "The ground changes with depth"),
        (false, _) => (CalloutKind::Warning, "The ground changes with depth; how is not known"),
    };
    page.verdict(kind, title, answer.verdict.as_str());
    for warning in &answer.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    page.heading("What is left of the ground");
    let friction = levels("Friction angle over depth", "Friction angle φ (deg)", answer, |l| l.phi_deg)?;
    page.figure(
        &friction,
        Size::new(760, 480)?,
        "Friction angles at each depth, of every ground of a kind that explains all strokes.",
    )?;
    let density = levels("Density over depth", "Density ρ (kg/m³)", answer, |l| l.density_kg_m3)?;
    page.figure(&density, Size::new(760, 480)?, "Densities at each depth, of the same grounds.")?;
    page.table(hypotheses(answer)?);
    if let Some(step) = answer.of(Kind::Step).filter(|step| step.consistent) {
        page.table(slices(step)?);
    }
    page.heading("Measurements");
    page.figure(
        &normalised(answer)?,
        Size::new(760, 440)?,
        "Density times coefficient with its band. In one soil it is the same at all depths for one tool angle, but for the ends of plates.",
    )?;
    if !answer.next_depths.is_empty() {
        page.heading("Where next?");
        page.table(next(answer)?);
    }
    page.heading("Method");
    page.paragraph(
        "For each kind of ground all friction angles, densities, frictions on the plate and depths of a step are searched that explain every stroke within its band; none is lost. The \
         force is that of local pressures: at each point of the plate the weight of what lies above, times the coefficient of the friction there. By how much that may be off, from proven \
         bounds of layered ground, widens every band.",
    );
    Ok(page)
}

fn color(kind: Kind) -> usize {
    match kind {
        Kind::OneSoil => 2,
        Kind::Gradient => 0,
        Kind::Step => 1,
    }
}

/// Ranges over depth, one area a kind, the widest at the back.
fn levels(title: &str, unit: &str, answer: &Answer, of: fn(&Level) -> [f64; 2]) -> Result<Figure, PageError> {
    let mut figure = Figure::new(title, Axis::linear(unit), Axis::linear("Height (mm), the surface at 0"));
    for kind in [Kind::Step, Kind::Gradient, Kind::OneSoil] {
        let Some(one) = answer.of(kind).filter(|one| !one.profile.is_empty()) else { continue };
        let at = |end: usize| one.profile.iter().map(move |l| (of(l)[end], -1e3 * l.depth_m));
        let ring: Vec<(f64, f64)> = at(0).chain(at(1).rev()).collect();
        figure.push(Polygons::new(kind.name(), vec![Polygon::new(ring)]).color(color(kind)))?;
    }
    if figure.layers().is_empty() {
        figure.push(Text::new("no ground explains the strokes", (0.0, 0.0)))?;
        return Ok(figure);
    }
    let mut depths: Vec<f64> = answer.strokes.iter().map(|stroke| stroke.depth_m).collect();
    depths.sort_by(f64::total_cmp);
    depths.dedup_by(|a, b| (*a - *b).abs() < 1e-4);
    for (place, depth) in depths.into_iter().enumerate() {
        // One name for all of them.
        let name = if place == 0 { "depths of strokes" } else { "" };
        figure.push(RefLine::horizontal(name, -1e3 * depth).color(6))?;
    }
    Ok(figure)
}

fn hypotheses(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("ground", Align::Left),
        ("explains", Align::Left),
        ("φ top (deg)", Align::Right),
        ("φ bottom (deg)", Align::Right),
        ("growth of φ (deg)", Align::Right),
        ("ρ top (kg/m³)", Align::Right),
        ("ρ bottom (kg/m³)", Align::Right),
        ("step (mm)", Align::Right),
        ("p", Align::Right),
    ];
    let mut table = Table::new("Kinds of ground, and what the strokes leave of them", columns);
    for one in &answer.hypotheses {
        let r = one.ranges;
        table.row([
            one.kind.name().to_owned(),
            yes(one.consistent).to_owned(),
            range(r.map(|r| r.phi_top_deg), 1),
            range(r.map(|r| r.phi_bottom_deg), 1),
            range(r.map(|r| r.phi_growth_deg), 1),
            range(r.map(|r| r.density_top_kg_m3), 0),
            range(r.map(|r| r.density_bottom_kg_m3), 0),
            range(one.step_m.map(|step| step.map(|m| 1e3 * m)), 0),
            one.p.map_or_else(|| "–".into(), |p| format!("{p:.1e}")),
        ])?;
    }
    for (name, alias, unit) in [
        ("one soil, friction falls with stress", &answer.friction_law, "deg a decade"),
        ("one soil with cohesion", &answer.cohesion, "Pa"),
    ] {
        let explains = alias.consistent.map_or_else(
            || "not asked: the model has no such term".to_owned(),
            |c| match alias.left {
                Some(left) if c => format!("yes, {} {unit}", range(Some(left), 1)),
                Some(_) | None => yes(c).to_owned(),
            },
        );
        let phi = range(alias.phi_deg, 1);
        let dash = || "–".to_owned();
        table.row([name.to_owned(), explains, phi.clone(), phi, dash(), dash(), dash(), dash(), dash()])?;
    }
    Ok(table)
}

fn slices(step: &Hypothesis) -> Result<Table, PageError> {
    let columns = [
        ("step (mm)", Align::Right),
        ("φ above (deg)", Align::Right),
        ("φ below (deg)", Align::Right),
        ("ρ above (kg/m³)", Align::Right),
        ("ρ below (kg/m³)", Align::Right),
    ];
    let mut table = Table::new("Steps by their depth", columns);
    for slice in &step.slices {
        let r = slice.ranges;
        table.row([
            range(Some(slice.step_m.map(|m| 1e3 * m)), 1),
            range(Some(r.phi_top_deg), 1),
            range(Some(r.phi_bottom_deg), 1),
            range(Some(r.density_top_kg_m3), 0),
            range(Some(r.density_bottom_kg_m3), 0),
        ])?;
    }
    Ok(table)
}

fn normalised(answer: &Answer) -> Result<Figure, PageError> {
    let (x, y) = (Axis::linear("Depth (mm)"), Axis::linear("2F/(g w L²) (kg/m³)"));
    let mut figure = Figure::new("Density times coefficient over depth", x, y);
    let mut angles: Vec<f64> = answer.strokes.iter().map(|s| s.alpha_deg).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    for (place, alpha) in angles.iter().enumerate() {
        let of = || answer.strokes.iter().filter(|s| (s.alpha_deg - alpha).abs() < 1e-6);
        let at: Vec<(f64, f64)> = of().map(|s| (1e3 * s.depth_m, s.normalised_kg_m3)).collect();
        let errors: Vec<(f64, f64)> = of()
            .map(|s| {
                let [low, high] = s.normalised_band_kg_m3;
                (s.normalised_kg_m3 - low, high - s.normalised_kg_m3)
            })
            .collect();
        let labels = of().map(|s| s.label.clone());
        let points = Points::new(format!("{}°", number(*alpha)), at).y_error(errors).labels(labels);
        figure.push(points.marker(Marker::Circle).color(place % 7))?;
    }
    Ok(figure)
}

fn next(answer: &Answer) -> Result<Table, PageError> {
    let mut columns = vec![("depth (mm)", Align::Right), ("tells", Align::Right)];
    let kinds: Vec<Kind> = Kind::ALL.into_iter().filter(|kind| answer.allows(*kind)).collect();
    columns.extend(kinds.iter().map(|kind| (kind.name(), Align::Right)));
    let mut table = Table::new(
        "Forces (N) that kinds of ground allow at a depth; above 1 a stroke may tell them apart",
        columns,
    );
    for depth in &answer.next_depths {
        let mut row = vec![number((1e4 * depth.depth_m).round() / 10.0), format!("{:.2}", depth.tells)];
        row.extend(kinds.iter().map(|kind| {
            depth.forces.iter().find(|one| one.kind == *kind).map_or_else(|| "–".into(), Predicted::in_words)
        }));
        table.row(row)?;
    }
    Ok(table)
}
