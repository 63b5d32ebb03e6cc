//! Forces of strokes over what the soil explains, and where a block may be, as figures and a page.

use std::path::Path;

use soilctl_app::ahead::{Answer, LookAnswer, RegionAnswer, StrokeAnswer, Verdict};
use soilctl_figure::{
    Align, Axis, CalloutKind, Dash, Figure, HtmlReport, Legend, Line, Marker, Points, Polygon, Polygons,
    RefLine, Size, Table,
};

use crate::PageError;
use crate::write::save_figure;

/// Most strokes that are drawn.
const MOST: usize = 40;
/// Most regions on a page.
const MOST_REGIONS: usize = 6;

/// Colours of what is drawn.
const ALARMED: usize = 1;
const QUIET: usize = 7;
const LIMIT: usize = 0;

/// The force of each stroke over what the soil explains, with the limit of an alarm and the alarms.
///
/// # Errors
/// [`PageError`] if there is nothing to draw.
pub fn figure(answer: &Answer) -> Result<Figure, PageError> {
    let judged: Vec<&StrokeAnswer> =
        answer.strokes.iter().filter(|stroke| !stroke.looks.is_empty()).take(MOST).collect();
    let Some(longest) = judged.iter().max_by_key(|stroke| stroke.looks.len()) else {
        return Err(PageError::Nothing("there is nothing to draw: no stroke can be judged".into()));
    };
    let mut figure = Figure::new(
        "Force over what the soil explains",
        Axis::linear("way of the plate (mm)"),
        Axis::linear("ratio of forces"),
    )
    .with_legend(Legend::Below);
    figure.push(RefLine::horizontal("what the soil explains", 1.0))?;
    // From the first look on each force is compared with itself; what it was then, with those of other strokes.
    let growth = |stroke: &StrokeAnswer, of: fn(&LookAnswer) -> f64| -> Vec<(f64, f64)> {
        let mut looks = stroke.looks.iter();
        let first = looks.next().map(|look| (1e3 * look.way_m, 1.0));
        first.into_iter().chain(looks.map(|look| (1e3 * look.way_m, of(look)))).collect()
    };
    let (mut quiet, mut alarmed) = ("no alarm", "alarm");
    for stroke in &judged {
        let (name, color, width) = match stroke.verdict {
            Verdict::Alarm => (std::mem::take(&mut alarmed), ALARMED, 2.0),
            Verdict::Quiet | Verdict::NotJudged => (std::mem::take(&mut quiet), QUIET, 1.0),
        };
        let line = Line::new(name, growth(stroke, |look| look.ratio));
        figure.push(line.color(color).width(width).dash(Dash::Solid))?;
    }
    let name = format!("limit of an alarm, of {}", longest.stroke_id);
    figure.push(Line::new(name, growth(longest, |look| look.limit)).color(LIMIT).dash(Dash::Dash))?;
    let first = |stroke: &&StrokeAnswer| stroke.looks.first().map(|look| (1e3 * look.way_m, look.ratio));
    figure.push(
        Points::new(
            "at the first look, over other strokes",
            judged.iter().filter_map(first).collect::<Vec<_>>(),
        )
        .color(LIMIT),
    )?;
    let alarms: Vec<(f64, f64)> = judged
        .iter()
        .filter_map(|stroke| stroke.alarm.as_ref())
        .map(|alarm| (1e3 * alarm.way_m, alarm.ratio))
        .collect();
    if !alarms.is_empty() {
        figure.push(Points::new("where it alarms", alarms).color(ALARMED).marker(Marker::Square))?;
    }
    Ok(figure)
}

/// Where a block may be at the last look.
///
/// # Errors
/// [`PageError`] if it cannot be drawn.
fn drawing(region: &RegionAnswer, stroke: &StrokeAnswer) -> Result<Figure, PageError> {
    let mut figure = Figure::new(
        format!("Where a block may be: {}", stroke.stroke_id),
        Axis::linear("face of the block ahead of the plate (mm)"),
        Axis::linear("height of its top (mm)"),
    )
    .with_legend(Legend::Below);
    let parts = merged(region).into_iter().map(|[[near, far], [high, low]]| {
        Polygon::new(vec![(near, -low), (far, -low), (far, -high), (near, -high)])
    });
    figure
        .push(Polygons::new("fixed blocks that go with the force", parts.collect::<Vec<_>>()).color(LIMIT))?;
    let plate = vec![(0.0, 0.0), (0.0, -1e3 * stroke.depth_m)];
    figure.push(Line::new("the plate", plate).color(ALARMED).width(4.0).dash(Dash::Solid))?;
    Ok(figure)
}

/// The parts of a region in mm, those of one distance put together: ranges of distance and of top.
fn merged(region: &RegionAnswer) -> Vec<[[f64; 2]; 2]> {
    let mut parts: Vec<[[f64; 2]; 2]> = Vec::new();
    // They come near to far, and from the surface down.
    for place in &region.places {
        let [ahead, top] = [place.ahead_m, place.top_m].map(|range| range.map(|m| 1e3 * m));
        match parts.last_mut() {
            Some([of, [_, low]]) if *of == ahead && (*low - top[0]).abs() < 1e-6 => *low = top[1],
            Some(_) | None => parts.push([ahead, top]),
        }
    }
    // Neighbours with the same tops.
    let mut wide: Vec<[[f64; 2]; 2]> = Vec::new();
    for part in parts {
        let same =
            |other: &&mut [[f64; 2]; 2]| other[1] == part[1] && (other[0][1] - part[0][0]).abs() < 1e-6;
        match wide.iter_mut().find(same) {
            Some(other) => other[0][1] = part[0][1],
            None => wide.push(part),
        }
    }
    wide
}

/// Writes the figure of the forces.
///
/// # Errors
/// [`PageError`] if it cannot be drawn or written.
pub fn save(answer: &Answer, path: &Path) -> Result<(), PageError> {
    save_figure(&figure(answer)?, path, Size::new(760, 480)?)
}

/// The page: what the forces say, the figures, and a table of the strokes.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("Is something buried ahead?");
    let (kind, headline) = match (answer.alarms, answer.quiet) {
        (0, 0) => (CalloutKind::Warning, "No stroke can be judged"),
        (0, _) => (CalloutKind::Good, "Nothing is seen ahead"),
        (..) => (CalloutKind::Warning, "Something may be ahead"),
    };
    page.kind("Forces beyond what the soil explains").subtitle(format!(
        "{} strokes, {} % false alarms",
        answer.strokes.len(),
        100.0 * answer.false_alarms
    ));
    page.verdict(kind, headline, answer.verdict.clone());
    if answer.alarms + answer.quiet > 0 {
        page.figure(
            &figure(answer)?,
            Size::new(820, 480)?,
            "Lines: the growth of each force since the first look, over the growth of those it is compared with; the limit is that of the longest stroke, each has its own. Dots: the force at the \
             first look over theirs.",
        )?;
    }
    let regions = answer
        .strokes
        .iter()
        .filter_map(|stroke| Some((stroke, stroke.alarm.as_ref()?.last_region.as_ref()?)))
        .filter(|(_, region)| !region.places.is_empty());
    for (place, (stroke, region)) in regions.take(MOST_REGIONS).enumerate() {
        if place == 0 {
            page.heading("Where it may be");
        }
        page.figure(
            &drawing(region, stroke)?,
            Size::new(820, 360)?,
            "All places of face and top that go with the force up to the end, seen from the plate there, by proven bounds widened by the scatter. Bounds hold from one place of the table to the \
             next, hence the steps.",
        )?;
    }
    page.heading("Strokes");
    page.table(table(answer)?);
    for note in &answer.notes {
        page.paragraph(note.clone());
    }
    Ok(page)
}

fn table(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("stroke", Align::Left),
        ("depth (mm)", Align::Right),
        ("compared with", Align::Right),
        ("verdict", Align::Left),
        ("alarm at (mm)", Align::Right),
        ("ratio", Align::Right),
        ("ahead at the end (mm)", Align::Right),
        ("top (mm)", Align::Right),
    ];
    let mut table = Table::new("What became of each stroke", columns);
    let dash = || "–".to_owned();
    let mm = |range: Option<[f64; 2]>| {
        range.map_or_else(dash, |[from, to]| format!("{:.0} to {:.0}", 1e3 * from, 1e3 * to))
    };
    for stroke in &answer.strokes {
        let alarm = stroke.alarm.as_ref();
        let region = alarm.and_then(|alarm| alarm.last_region.as_ref());
        table.row([
            stroke.stroke_id.clone(),
            format!("{:.1}", 1e3 * stroke.depth_m),
            stroke.references.to_string(),
            stroke.reason.clone().unwrap_or_else(|| stroke.verdict.name().to_owned()),
            alarm.map_or_else(dash, |alarm| format!("{:.1}", 1e3 * alarm.way_m)),
            alarm.map_or_else(dash, |alarm| format!("{:.2}", alarm.ratio)),
            mm(region.and_then(|region| region.ahead_m)),
            mm(region.and_then(|region| region.top_m)),
        ])?;
    }
    Ok(table)
}
