//! The page of a solution: bounds, the mechanism in motion, fields, contact stresses, and how it was computed.

use soilctl_app::limits::{ContactAnswer, Fields, LevelAnswer, ResultsAnswer, SolveAnswer};
use soilctl_app::text::{line_force_unit, moment_unit, number, number_or_dash};
use soilctl_figure::{Align, CalloutKind, HtmlReport, RichText, Table};
use soilctl_limit_analysis::Ended;

use super::plot::{self, Kind};
use crate::PageError;
use crate::problem::Scene;

/// What the drawing of the problem is.
const PROBLEM: &str = "What was given: soils, what holds the ground and what acts on it. Lengths of arrows are to scale among loads \
                       only.";

/// What the page tells of a solution.
pub(crate) struct PageContent {
    /// What sort of problem it is, in a few words.
    pub(crate) kind: &'static str,
    /// The line under the title.
    pub(crate) subtitle: String,
    pub(crate) verdict: (CalloutKind, String, String),
    /// The bounds and what follows from them, by name.
    pub(crate) bounds: Table,
    /// What was given, below the drawing of it.
    pub(crate) inputs: Vec<Table>,
    /// What was given, by name.
    pub(crate) given: Vec<(&'static str, String)>,
    /// How it was computed; no times, which are different each time.
    pub(crate) steps: Option<Table>,
}

/// A table of bounds: what is bounded, lower and upper bound.
pub(crate) fn bounds_table() -> Table {
    let columns = [("", Align::Left), ("lower bound", Align::Right), ("upper bound", Align::Right)];
    Table::new("Proven bounds", columns)
}

/// All levels as a table of a page; without times, which are different each time.
pub(crate) fn level_table(levels: &[LevelAnswer]) -> Result<Option<Table>, PageError> {
    if levels.is_empty() {
        return Ok(None);
    }
    let columns = ["level", "elements", "upper bound", "elements", "lower bound"].map(|c| (c, Align::Right));
    let mut table = Table::new("Meshes from coarse to fine, and what was proven on each", columns);
    for (index, level) in levels.iter().enumerate() {
        let two = |s: &SolveAnswer| [s.elements.to_string(), number_or_dash(s.proven)];
        let [upper, lower] = [Some(&level.upper), level.lower.as_ref()]
            .map(|s| s.map_or_else(|| ["-".to_owned(), "-".to_owned()], two));
        table.row([(index + 1).to_string()].into_iter().chain(upper).chain(lower))?;
    }
    Ok(Some(table))
}

/// What the bounds are worth.
pub(crate) fn proven(gap: Option<f64>, wanted: f64, ended: Ended) -> (CalloutKind, String) {
    let proof = "Both bounds are proven with interval arithmetic; the true value for rigid-plastic soil with associated \
                 flow lies between them.";
    match gap {
        Some(gap) if gap <= wanted => {
            (CalloutKind::Good, format!("{proof} They are {} % apart.", number(round(100.0 * gap))))
        }
        Some(gap) => (
            CalloutKind::Warning,
            format!(
                "{proof} They are {} % apart, where {} % was asked for: the run was {ended}.",
                number(round(100.0 * gap)),
                number(100.0 * wanted)
            ),
        ),
        None => {
            (CalloutKind::Warning, format!("{proof} They are on both sides of zero; the run was {ended}."))
        }
    }
}

/// Three digits.
pub(crate) fn round(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// The page, headed by the problem.
pub(crate) fn page(
    fields: &Fields,
    scene: &Scene,
    content: PageContent,
    results: &ResultsAnswer,
) -> Result<HtmlReport, PageError> {
    let title = if fields.title.is_empty() { content.kind } else { &fields.title };
    let mut page = HtmlReport::new(title);
    let (kind, headline, text) = content.verdict;
    page.kind(content.kind).subtitle(content.subtitle).verdict(kind, headline, text).table(content.bounds);
    let (drawing, size) = scene.figure()?;
    page.heading("The problem").figure(&drawing, size, PROBLEM)?;
    for table in content.inputs {
        page.table(table);
    }
    page.heading("How the soil fails");
    plot::add(&mut page, fields, Kind::Blocks)?;
    if fields.blocks.is_some() && fields.flow.is_some() {
        page.heading("How its section would fail without ends").paragraph(
            "What follows is in plane strain, which bounds the force of this plate from below only: its flow says where meshes are fine.",
        );
    }
    for kind in [Kind::Mechanism, Kind::Velocity, Kind::Dissipation] {
        plot::add(&mut page, fields, kind)?;
    }
    moving_ground(&mut page, results);
    if fields.stress.is_some() {
        page.heading("Stresses");
        for kind in [Kind::End, Kind::Stress, Kind::Contact] {
            plot::add(&mut page, fields, kind)?;
        }
        contacts(&mut page, results)?;
    }
    members(&mut page, fields, results)?;
    if !content.given.is_empty() {
        page.heading("What was given").definitions(content.given);
    }
    page.heading("How it was computed");
    if let Some(steps) = content.steps {
        page.table(steps);
    }
    page.paragraph(
        RichText::new("The lower bound is a stress field that is in equilibrium and nowhere beyond yield, the upper bound a flow that \
                       obeys the flow rule and whose power balance gives the load. Both are found by cone programming on meshes \
                       that are refined where they differ most, and checked by ")
            .code("soilctl certify")
            .text(", which shares no code with the solver. Lines and velocities of the figures are of the last meshes; they show one of \
                   many fields that prove the same bounds."),
    );
    Ok(page)
}

fn moving_ground(page: &mut HtmlReport, results: &ResultsAnswer) {
    let unit = &results.length_unit;
    let stretches: Vec<String> = results
        .moving_ground
        .iter()
        .map(|s| [s.from[0], s.to[0]])
        .map(|[a, b]| format!("x = {} to {} {unit}", number(round(a)), number(round(b))))
        .collect();
    if !stretches.is_empty() {
        page.paragraph(format!("The ground moves at {}.", stretches.join(", and at ")));
    }
}

fn members(page: &mut HtmlReport, fields: &Fields, results: &ResultsAnswer) -> Result<(), PageError> {
    let length = &results.length_unit;
    let force = line_force_unit(&results.stress_unit, length);
    if results.members.is_empty() {
        return Ok(());
    }
    page.heading("Bars, sheets and beams");
    plot::add(page, fields, Kind::Members)?;
    let columns = [
        ("member".to_owned(), Align::Left),
        (format!("bears in tension ({force})"), Align::Right),
        (format!("greatest tension ({force})"), Align::Right),
        (format!("where, from its start ({length})"), Align::Right),
        ("used (%)".to_owned(), Align::Right),
        ("yields".to_owned(), Align::Left),
    ];
    let mut table = Table::new("Axial forces in the field of the lower bound, per unit width", columns);
    let cell = |x: f64| number(round(x));
    let known = |x: Option<f64>| x.map_or_else(|| "–".into(), cell);
    for m in &results.members {
        table.row([
            m.name.clone(),
            cell(m.tensile_strength),
            known(m.greatest_tension),
            known(m.greatest_tension_at),
            known(m.utilisation.map(|used| 100.0 * used)),
            m.yields().to_owned(),
        ])?;
    }
    page.table(table).paragraph(
        "A member yields where the flow of the upper bound stretches it, or where it slips in the soil as bars do that are pulled out. The forces are those of one field that proves the lower bound; \
         others may prove it too.",
    );
    beams(page, fields, results)
}

fn beams(page: &mut HtmlReport, fields: &Fields, results: &ResultsAnswer) -> Result<(), PageError> {
    let length = &results.length_unit;
    let (moment, force) =
        (moment_unit(&results.stress_unit, length), line_force_unit(&results.stress_unit, length));
    let bent: Vec<_> = results.members.iter().filter_map(|m| Some((m, m.bending.as_ref()?))).collect();
    if bent.is_empty() {
        return Ok(());
    }
    plot::add(page, fields, Kind::Moments)?;
    let columns = [
        ("beam".to_owned(), Align::Left),
        (format!("bears ({moment})"), Align::Right),
        (format!("greatest moment ({moment})"), Align::Right),
        (format!("where, from its start ({length})"), Align::Right),
        (format!("greatest shear force ({force})"), Align::Right),
        (format!("hinges, from its start ({length})"), Align::Left),
    ];
    let mut table = Table::new(
        "Bending in the field of the lower bound, per unit width; hinges in the flow of the upper bound",
        columns,
    );
    let known = |x: Option<f64>| x.map_or_else(|| "–".into(), |x| number(round(x)));
    for (member, bending) in bent {
        let hinges: Vec<String> = bending.hinges.iter().map(|[at, _]| number(round(*at))).collect();
        table.row([
            member.name.clone(),
            number(round(bending.moment_strength)),
            known(bending.greatest_moment),
            known(bending.greatest_moment_at),
            known(bending.greatest_shear),
            if hinges.is_empty() { "none".to_owned() } else { hinges.join(", ") },
        ])?;
    }
    page.table(table);
    Ok(())
}

fn contacts(page: &mut HtmlReport, results: &ResultsAnswer) -> Result<(), PageError> {
    let (length, stress) = (&results.length_unit, &results.stress_unit);
    let force = line_force_unit(stress, length);
    if results.contacts.is_empty() {
        return Ok(());
    }
    let columns = [
        ("face".to_owned(), Align::Left),
        (format!("length ({length})"), Align::Right),
        (format!("pressure ({force})"), Align::Right),
        (format!("shear ({force})"), Align::Right),
        (format!("centre from the upper end ({length})"), Align::Right),
        (format!("greatest pressure ({stress})"), Align::Right),
    ];
    let mut table = Table::new("Resultants of the contact stresses, per unit width", columns);
    let cell = |x: f64| number(round(x));
    for ContactAnswer { face, length, normal_force, shear_force, centre, greatest_pressure } in
        &results.contacts
    {
        table.row([
            face.clone(),
            cell(*length),
            cell(*normal_force),
            cell(*shear_force),
            centre.map_or_else(|| "–".into(), cell),
            cell(*greatest_pressure),
        ])?;
    }
    page.table(table);
    Ok(())
}
