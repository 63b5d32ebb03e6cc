//! The force of a tool near a buried body over its distance, as a figure and a page.

use std::path::Path;

use soilctl_app::obstacle::{Answer, BodyKind, DistanceAnswer, Found, Verdict};
use soilctl_app::text::{number, number_or_dash};
use soilctl_figure::{
    Align, Axis, Band, CalloutKind, Dash, Figure, HtmlReport, Legend, Line, Marker, Paths, Points, Polygon,
    Polygons, RefLine, Size, Table,
};

use crate::PageError;
use crate::limits::round;
use crate::write::save_figure;

/// Both bounds on the ratio to the force without the body, over the distance.
///
/// # Errors
/// [`PageError`] if there is nothing to draw.
pub fn figure(answer: &Answer) -> Result<Figure, PageError> {
    let known = |pick: fn(&DistanceAnswer) -> Option<f64>| -> Vec<(f64, f64)> {
        answer.distances.iter().filter_map(|one| Some((one.ahead_m, pick(one)?))).collect()
    };
    let (lower, upper) = (known(|one| one.ratio_lower), known(|one| one.ratio_upper));
    if lower.is_empty() {
        return Err(PageError::Nothing("there is nothing to draw: the force without the body is no push, so nothing is told as a ratio to it".into()));
    }
    let title = match answer.body {
        BodyKind::Fixed => "Force near a fixed body",
        BodyKind::Stone => "Force near a stone",
    };
    let most = lower.iter().chain(&upper).map(|point| point.1).fold(1.0 + answer.scatter, f64::max);
    let margin = 0.08 * (most - 1.0).max(0.05);
    let y = Axis::linear("force over that without the body").range(1.0 - margin, most + margin)?;
    let mut figure = Figure::new(title, Axis::linear("distance of the body ahead of the tip (m)"), y)
        .with_legend(Legend::Below);
    // A band wherever both bounds are known from one distance to the next.
    let both = |one: &DistanceAnswer| Some((one.ahead_m, one.ratio_lower?, one.ratio_upper?));
    let runs = answer.distances.split(|one| both(one).is_none()).filter(|run| run.len() > 1);
    for (index, run) in runs.enumerate() {
        let run: Vec<(f64, f64, f64)> = run.iter().filter_map(both).collect();
        let [x, low, high] =
            [0, 1, 2].map(|i| run.iter().map(|one| [one.0, one.1, one.2][i]).collect::<Vec<_>>());
        let name = if index == 0 { "between the bounds, joined by straight lines" } else { "" };
        figure.push(Band::new(name, x, low, high).color(0))?;
    }
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
    page.heading("Tool and body").figure(
        &drawing(answer)?,
        Size::new(820, 420)?,
        "Tool and body at the least distance, along the surface.",
    )?;
    Ok(page)
}

/// Tool and body at the least distance.
fn drawing(answer: &Answer) -> Result<Figure, PageError> {
    let mut figure = Figure::new("Tool and body", Axis::linear("ahead (m)"), Axis::linear("up (m)"))
        .with_equal_aspect()?;
    let pieces = &answer.tool.pieces;
    let tip = pieces.first().map_or([0.0; 2], |piece| piece.from_m);
    let line: Vec<(f64, f64)> =
        std::iter::once(tip).chain(pieces.iter().map(|piece| piece.to_m)).map(|[x, y]| (x, y)).collect();
    let near = tip[0] + answer.distances.first().map_or(0.0, |one| one.ahead_m);
    let (far, top) = (near + answer.body_length_m, -answer.body_top_m);
    let bottom = top - answer.body_height_m;
    let block = Polygon::new(vec![(near, bottom), (far, bottom), (far, top), (near, top)]);
    let left = line.iter().map(|p| p.0).fold(near, f64::min) - answer.tool.depth_m;
    figure.push(
        Paths::new("surface", vec![vec![(left, 0.0), (far + answer.tool.depth_m, 0.0)]]).width(1.0).color(3),
    )?;
    figure.push(Polygons::new("body", vec![block]).color(1))?;
    figure.push(Paths::new("tool", vec![line]).width(4.0).color(0))?;
    Ok(figure)
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
