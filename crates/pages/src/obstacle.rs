//! The force of a tool near a buried body over its distance, as a figure and a page.

use std::path::Path;

use soilctl_app::obstacle::{Answer, BodyKind, Found, Verdict};
use soilctl_app::text::{number, number_or_dash};
use soilctl_figure::{
    Align, Axis, Band, CalloutKind, Dash, Figure, HtmlReport, Legend, Line, Marker, Points, RefLine, Size,
    Table,
};

use crate::PageError;
use crate::limits::round;
use crate::problem::Scene;
use crate::write::save_figure;

/// Both bounds on the ratio to the force without the body, over the distance.
///
/// # Errors
/// [`PageError`] if there is nothing to draw.
pub fn figure(answer: &Answer) -> Result<Figure, PageError> {
    let both: Vec<(f64, f64, f64)> = answer
        .distances
        .iter()
        .filter_map(|one| Some((one.ahead_m, one.ratio_lower?, one.ratio_upper?)))
        .collect();
    if both.is_empty() {
        return Err(PageError::Nothing(
            "there is nothing to draw: at no distance are both bounds on the ratio known".into(),
        ));
    }
    let title = match answer.body {
        BodyKind::Fixed => "Force near a fixed body",
        BodyKind::Smooth => "Force near a fixed body with smooth faces",
        BodyKind::Stone => "Force near a stone",
    };
    let most = both.iter().map(|one| one.2).fold(1.0 + answer.scatter, f64::max);
    let least = both.iter().map(|one| one.1).fold(1.0, f64::min);
    let margin = 0.08 * (most - least).max(0.05);
    let y = Axis::linear("force over that without the body").range(least - margin, most + margin)?;
    let mut figure = Figure::new(title, Axis::linear("distance of the body ahead of the tip (m)"), y)
        .with_legend(Legend::Below);
    let [x, low, high] =
        [0, 1, 2].map(|i| both.iter().map(|one| [one.0, one.1, one.2][i]).collect::<Vec<_>>());
    if both.len() > 1 {
        figure.push(Band::new("between the bounds, joined by straight lines", x, low, high).color(0))?;
    }
    let points =
        |pick: fn(&(f64, f64, f64)) -> f64| both.iter().map(|one| (one.0, pick(one))).collect::<Vec<_>>();
    let (upper, lower) = (points(|one| one.2), points(|one| one.1));
    figure.push(Line::new("", upper.clone()).color(0).dash(Dash::Dash))?;
    figure.push(Line::new("", lower.clone()).color(0))?;
    figure.push(Points::new("upper bound", upper).color(1).marker(Marker::Square))?;
    figure.push(Points::new("lower bound", lower).color(2))?;
    figure.push(RefLine::horizontal("scatter of measured forces", 1.0 + answer.scatter))?;
    Ok(figure)
}

/// Writes the figure.
///
/// # Errors
/// [`PageError`] if it cannot be drawn or written.
pub fn save(answer: &Answer, path: &Path) -> Result<(), PageError> {
    save_figure(&figure(answer)?, path, Size::new(760, 480)?)
}

/// The page: what the force says, the figure, the table, and the problem at the least distance.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(found: &Found) -> Result<HtmlReport, PageError> {
    let answer = &found.answer;
    let mut page = HtmlReport::new(answer.tool.title.as_deref().unwrap_or("Is there a rock ahead?"));
    let kind = match answer.answer {
        Verdict::Shows | Verdict::Hidden => CalloutKind::Good,
        Verdict::Open => CalloutKind::Warning,
    };
    let headline = match answer.answer {
        Verdict::Shows => "The force shows the body",
        Verdict::Hidden => "The force does not show the body",
        Verdict::Open => "The bounds leave it open",
    };
    page.kind("Bounds on a tool's force near a buried body").subtitle(subtitle(answer)).verdict(
        kind,
        headline,
        answer.verdict.clone(),
    );
    page.figure(
        &figure(answer)?,
        Size::new(820, 480)?,
        "Both bounds on the force over that without the body. At the marked distances they are proven; lines between them are drawn only.",
    )?;
    page.table(table(answer)?);
    for note in &answer.notes {
        page.paragraph(note.clone());
    }
    let (description, described) = &found.nearest;
    let (drawing, size) = Scene::of_file(description, described).figure()?;
    page.heading("The problem").figure(&drawing, size, "Tool and body at the least distance.")?;
    Ok(page)
}

fn subtitle(answer: &Answer) -> String {
    let m = |x: f64| number(round(x));
    format!(
        "A block {} m high and {} m long, its top {} m below the surface; the tool is {} m deep",
        m(answer.body_height_m),
        m(answer.body_length_m),
        m(answer.body_top_m),
        m(answer.tool.depth_m)
    )
}

fn table(answer: &Answer) -> Result<Table, PageError> {
    let columns = ["distance (m)", "force from (N/m)", "to (N/m)", "ratio from", "to"];
    let mut table = Table::new("Proven bounds over the distance", columns.map(|c| (c, Align::Right)));
    let force = number;
    table.row([
        "no body".to_owned(),
        force(answer.without_lower_n_per_m),
        force(answer.without_upper_n_per_m),
        "1".into(),
        "1".into(),
    ])?;
    for one in &answer.distances {
        table.row([
            number(one.ahead_m),
            number_or_dash(one.lower_n_per_m),
            number_or_dash(one.upper_n_per_m),
            number_or_dash(one.ratio_lower),
            number_or_dash(one.ratio_upper),
        ])?;
    }
    Ok(table)
}
