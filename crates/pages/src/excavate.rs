//! Figures and the page of an excavation.

use soilctl_app::excavate::{Answer, Ended, Manner};
use soilctl_app::text::range;
use soilctl_figure::{Align, Axis, CalloutKind, Dash, Figure, HtmlReport, Line, RefLine, Size, Table};

use crate::PageError;

/// The forces that the soil bears and that fail it, by their inclination (Hong 2001, figure 5-13).
///
/// # Errors
/// [`PageError`] if a curve cannot be drawn.
pub fn forces(answer: &Answer) -> Result<Figure, PageError> {
    let [alpha_deg, depth_m] = answer.at;
    let mut figure = Figure::new(
        format!("Forces at {alpha_deg:.0} deg and {:.0} mm", 1e3 * depth_m),
        Axis::linear("Inclination to the normal (deg, down +)"),
        Axis::linear("Force (N)"),
    );
    let curve = |of: fn(&soilctl_app::excavate::ForceRow) -> Option<f64>| -> Vec<(f64, f64)> {
        answer.forces.iter().filter_map(|row| Some((row.inclination_deg, of(row)?))).collect()
    };
    figure.push(Line::new("fails every soil", curve(|row| row.fails_n)).color(1).dash(Dash::Solid))?;
    let bears = curve(|row| row.bears_n);
    if bears.len() > 1 {
        figure.push(Line::new("every soil bears", bears).color(0).dash(Dash::Solid))?;
    }
    for (name, deg) in
        [("least friction on the plate", answer.delta_deg[0]), ("greatest", answer.delta_deg[1])]
    {
        if name != "greatest" || answer.delta_deg[1] > answer.delta_deg[0] {
            figure.push(RefLine::vertical(name, deg))?;
        }
    }
    Ok(figure)
}

/// What tool angles cost.
fn angles(answer: &Answer) -> Result<Figure, PageError> {
    let mut figure = Figure::new(
        "What a tool angle takes, in the strongest soil, with the heap that it pushes",
        Axis::linear("Tool angle (deg)"),
        Axis::linear("Part of that at the greatest angle"),
    );
    let Some(last) = answer.angles.last() else { return Ok(figure) };
    for (color, name, of) in [
        (0, "peak torque", (|row| row.share) as fn(&soilctl_app::excavate::AngleRow) -> f64),
        (1, "heat", |row| row.heat_a2),
        (2, "work for a volume", |row| row.work_kj_m3),
    ] {
        let points: Vec<(f64, f64)> =
            answer.angles.iter().map(|row| (row.alpha_deg, of(row) / of(last))).collect();
        figure.push(Line::new(name, points).color(color))?;
    }
    Ok(figure)
}

/// The page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("How do I dig with the least torque?");
    page.kind("Excavation").subtitle(format!(
        "Soils of {}° friction and {} kg/m³, {}° on the plate; at most {:.0} % of the torque limits",
        range(Some(answer.phi_deg), 1),
        range(Some(answer.density_kg_m3), 0),
        range(Some(answer.delta_deg), 1),
        100.0 * answer.share
    ));
    let done = answer.dug.iter().find(|dug| dug.manner == Manner::Learning);
    let good = done.map_or(answer.complete, |dug| dug.ended == Ended::Complete);
    let kind = if good { CalloutKind::Good } else { CalloutKind::Warning };
    let title =
        if good { "The trench is dug within the share" } else { "The trench is not as deep as wanted" };
    page.verdict(kind, title, answer.verdict.as_str());
    for warning in &answer.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    page.heading("Which forces fail the soil");
    page.figure(
        &forces(answer)?,
        Size::new(760, 420)?,
        "Below the lower curve every soil that is possible bears the force, by proven bounds; above the upper one every soil fails. Beyond the friction on \
         the plate it slips up (left), or dives unless the soil below its edge holds it (right).",
    )?;
    page.heading("What tool angles cost");
    page.figure(
        &angles(answer)?,
        Size::new(760, 380)?,
        "A plate whose edge leads, below 90°, lifts the soil ahead with less force. The arm's reach and its joints end the curve.",
    )?;
    let mut costs = Table::new(
        "Tool angles",
        [
            ("tool angle (°)", Align::Right),
            ("force (N)", Align::Right),
            ("torque (%)", Align::Right),
            ("heat (A²)", Align::Right),
            ("work (kJ/m³)", Align::Right),
        ],
    );
    for row in &answer.angles {
        costs.row([
            format!("{:.1}", row.alpha_deg),
            format!("{:.2}", row.fails_n),
            format!("{:.1}", 100.0 * row.share),
            format!("{:.0}", row.heat_a2),
            format!("{:.2}", row.work_kj_m3),
        ])?;
    }
    page.table(costs);
    if !answer.dug.is_empty() {
        page.heading("What was dug");
        page.figure(
            &depths(answer)?,
            Size::new(760, 420)?,
            "Depth of the floor after each pass, on the simulated arm. A pass is as deep as the torque share allows in every soil that is still possible.",
        )?;
        page.table(dug(answer)?);
    }
    page.heading("Method");
    page.paragraph(
        "Torques are those that hold the arm, push the plate in and press it ahead, through the transpose of the Jacobian, at nine places of each stroke, with \
         the heap that soil ahead of the plate makes and the dry friction of the drives. They are for the strongest soil that is possible. How far a plate \
         sinks on its way, and what pushes it in, is known by practice only, so that the arm may take somewhat more.",
    );
    Ok(page)
}

fn name(manner: Manner) -> &'static str {
    match manner {
        Manner::Learning => "learning",
        Manner::Planned => "without learning",
        Manner::Fixed => "fixed 90°",
    }
}

fn depths(answer: &Answer) -> Result<Figure, PageError> {
    let mut figure = Figure::new("Depth by passes", Axis::linear("Pass"), Axis::linear("Depth (mm)"));
    for (color, trench) in answer.dug.iter().enumerate() {
        let mut points = vec![(0.0, 0.0)];
        points.extend((1..).zip(&trench.passes).map(|(i, pass)| (f64::from(i), 1e3 * pass.floor_m)));
        figure.push(Line::new(name(trench.manner), points).color(color).dash(Dash::Solid))?;
    }
    Ok(figure)
}

fn dug(answer: &Answer) -> Result<Table, PageError> {
    let mut table = Table::new(
        "Trenches",
        [
            ("manner", Align::Left),
            ("passes", Align::Right),
            ("depth (mm)", Align::Right),
            ("torque (%)", Align::Right),
            ("work (J)", Align::Right),
            ("work (kJ/m³)", Align::Right),
            ("heat (A² s)", Align::Right),
            ("time (s)", Align::Right),
        ],
    );
    for trench in &answer.dug {
        table.row([
            name(trench.manner).to_owned(),
            trench.passes.len().to_string(),
            format!("{:.1}", 1e3 * trench.depth_m),
            format!("{:.0}", 100.0 * trench.peak_share),
            format!("{:.2}", trench.work_j),
            trench.work_kj_m3.map_or_else(|| "-".into(), |work| format!("{work:.1}")),
            format!("{:.0}", trench.heat_a2s),
            format!("{:.0}", trench.time_s),
        ])?;
    }
    Ok(table)
}
