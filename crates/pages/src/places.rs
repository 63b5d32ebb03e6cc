//! The page of places.

use soilctl_app::places::{Answer, Between, By, Cell, Pair, PlaceFound};
use soilctl_app::text::{number, range, yes};
use soilctl_figure::{
    Align, Axis, CalloutKind, Dash, Figure, HtmlReport, Legend, Line, Marker, Points, Polygon, Polygons,
    Shade, Shades, Size, Table, Text, TextPlace,
};

use crate::PageError;

/// Pairs that are listed.
const MOST_PAIRS: usize = 40;
/// Places whose names are written beside them.
const MOST_NAMES: usize = 40;

/// The page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("Is the soil the same everywhere?");
    let between = if answer.between.is_some() { ", what lies between" } else { "" };
    page.kind("Places").subtitle(format!("{} places, model {}{between}", answer.places.len(), answer.model));
    let whole = answer.places.iter().all(|place| place.consistent);
    let (kind, title) = match (whole, answer.pairs.iter().any(|pair| pair.differ)) {
        (false, _) => (CalloutKind::Warning, "Some places contradict themselves"),
        (true, true) => (CalloutKind::Note, "Soils differ"),
        (true, false) => (CalloutKind::Note, "No difference is found"),
    };
    page.verdict(kind, title, answer.verdict.as_str());
    for warning in &answer.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    page.heading("Places");
    if answer.places.iter().any(|place| place.x_m.is_some()) {
        page.figure(
            &places(answer)?,
            Size::new(760, 560)?,
            "Places by groups whose soils are not found to differ.",
        )?;
    }
    page.table(places_table(answer)?);
    page.heading("Soils of the places");
    page.figure(
        &regions(answer)?,
        Size::new(760, 520)?,
        "Friction angles and densities that explain every stroke of a place: the outline of each, in the colour of its group.",
    )?;
    if let Some(between) = &answer.between {
        maps(&mut page, answer, between)?;
    }
    page.heading("Pairs of places");
    page.table(pairs_table(answer)?);
    method(&mut page, answer);
    Ok(page)
}

/// Title, unit, and value in a cell of a map.
type Shown<'a> = (&'a str, &'a str, &'a dyn Fn(&Cell) -> f64);

/// Colour of a group; places without one have the last.
fn color(place: &PlaceFound) -> usize {
    place.group.map_or(7, |group| group % 7)
}

fn ground(title: &str) -> Result<Figure, PageError> {
    Ok(Figure::new(title, Axis::linear("x (m)"), Axis::linear("y (m)")).with_equal_aspect()?)
}

/// Places on the ground, by group, with hull and next places.
fn places(answer: &Answer) -> Result<Figure, PageError> {
    let mut figure = ground("Places")?;
    push_places(&mut figure, answer, true)?;
    Ok(figure)
}

fn push_places(figure: &mut Figure, answer: &Answer, by_group: bool) -> Result<(), PageError> {
    if let Some(between) = &answer.between {
        let outline: Vec<(f64, f64)> =
            between.hull.iter().chain(between.hull.first()).map(|p| (p[0], p[1])).collect();
        figure.push(Line::new("hull of the places", outline).dash(Dash::Dash).width(1.0).color(6))?;
    }
    let mut groups: Vec<Option<usize>> = answer.places.iter().map(|place| place.group).collect();
    groups.sort_unstable();
    groups.dedup();
    for group in groups {
        let members: Vec<&PlaceFound> = answer.places.iter().filter(|place| place.group == group).collect();
        let at: Vec<(f64, f64)> = members.iter().filter_map(|place| Some((place.x_m?, place.y_m?))).collect();
        let Some(first) = members.first().filter(|_| !at.is_empty()) else { continue };
        let name = match group {
            Some(_) if members.len() > 1 => format!("group of {}", first.name),
            Some(_) => format!("{} alone", first.name),
            None => "no soil".to_owned(),
        };
        let labels = members.iter().filter(|place| place.x_m.is_some()).map(|place| label(place));
        let points = Points::new(if by_group { name } else { String::new() }, at).labels(labels);
        figure.push(if by_group {
            points.color(color(first))
        } else {
            points.marker(Marker::Circle).color(6)
        })?;
    }
    if by_group && answer.places.len() <= MOST_NAMES {
        for place in &answer.places {
            if let (Some(x), Some(y)) = (place.x_m, place.y_m) {
                figure.push(Text::new(&place.name, (x, y)).place(TextPlace::Above))?;
            }
        }
    }
    if let Some(between) = &answer.between
        && !between.next_places.is_empty()
    {
        let at: Vec<(f64, f64)> = between.next_places.iter().map(|p| (p[0], p[1])).collect();
        let labels = (1..=at.len()).map(|order| format!("next place {order}"));
        figure.push(Points::new("next places", at).marker(Marker::Cross).labels(labels).color(5))?;
    }
    Ok(())
}

fn label(place: &PlaceFound) -> String {
    format!("{}: φ {} deg, ρ {} kg/m³", place.name, range(place.phi_deg, 1), range(place.density_kg_m3, 0))
}

fn places_table(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("place", Align::Left),
        ("x (m)", Align::Right),
        ("y (m)", Align::Right),
        ("strokes", Align::Right),
        ("φ (deg)", Align::Right),
        ("ρ (kg/m³)", Align::Right),
        ("group", Align::Right),
    ];
    let mut table = Table::new("Every soil that explains the strokes of a place", columns);
    let metres = |value: Option<f64>| value.map_or_else(|| "–".into(), number);
    for place in &answer.places {
        table.row([
            place.name.clone(),
            metres(place.x_m),
            metres(place.y_m),
            place.strokes.to_string(),
            range(place.phi_deg, 1),
            range(place.density_kg_m3, 0),
            place.group.map_or_else(|| "no soil".into(), |group| (group + 1).to_string()),
        ])?;
    }
    Ok(table)
}

/// The regions of all places.
fn regions(answer: &Answer) -> Result<Figure, PageError> {
    let title = "Soils that explain the strokes of each place";
    let axes = (Axis::linear("Friction angle φ (deg)"), Axis::linear("Density ρ (kg/m³)"));
    let mut figure = Figure::new(title, axes.0, axes.1).with_legend(Legend::Hidden);
    for place in &answer.places {
        let ring = |ring: &Vec<[f64; 2]>| ring.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>();
        let polygons =
            place.region.iter().filter_map(|rings| rings.first()).map(|outer| Polygon::new(ring(outer)));
        let polygons: Vec<Polygon> = polygons.collect();
        if !polygons.is_empty() {
            figure.push(Polygons::new(&place.name, polygons).color(color(place)))?;
        }
    }
    if figure.layers().is_empty() {
        figure.push(Text::new("no place has a soil", (0.0, 0.0)))?;
    }
    Ok(figure)
}

fn maps(page: &mut HtmlReport, answer: &Answer, between: &Between) -> Result<(), PageError> {
    page.heading("Between the places");
    page.paragraph(format!(
        "A value between places lies in an interval: what places do not know, and {} standard deviations of what lies between them, for every \
         covariance that the places leave plausible. The middle of an interval is no better than its ends; look at both maps.",
        number((100.0 * between.deviations).round() / 100.0)
    ));
    let middle = |[low, high]: [f64; 2]| f64::midpoint(low, high);
    let half = |[low, high]: [f64; 2]| 0.5 * (high - low);
    let phi = |cell: &Cell| cell.phi_deg;
    let density = |cell: &Cell| cell.density_kg_m3;
    let shown: [Shown<'_>; 4] = [
        ("Friction angle, middle of its interval", "φ (deg)", &|cell| middle(phi(cell))),
        ("Friction angle, half width of its interval", "± φ (deg)", &|cell| half(phi(cell))),
        ("Density, middle of its interval", "ρ (kg/m³)", &|cell| middle(density(cell))),
        ("Density, half width of its interval", "± ρ (kg/m³)", &|cell| half(density(cell))),
    ];
    for (title, unit, value) in shown {
        page.figure(&map(title, unit, answer, between, value)?, Size::new(760, 560)?, format!("{title}."))?;
    }
    if !between.next_places.is_empty() {
        let mut table = Table::new(
            "Where a further place would tell most, within the hull; each as if those before were done",
            [("", Align::Right), ("x (m)", Align::Right), ("y (m)", Align::Right)],
        );
        for (order, [x, y]) in between.next_places.iter().enumerate() {
            table.row([(order + 1).to_string(), number(*x), number(*y)])?;
        }
        page.table(table);
    }
    Ok(())
}

fn map(
    title: &str,
    unit: &str,
    answer: &Answer,
    between: &Between,
    value: impl Fn(&Cell) -> f64,
) -> Result<Figure, PageError> {
    // Corners by whole steps, so that those of neighbours are the same to the last digit.
    let edge = |middle: f64, side: f64| ((middle / between.cell_m).round() + side) * between.cell_m;
    let parts: Vec<Shade> = between
        .cells
        .iter()
        .map(|cell| {
            let (x, y) = ([-0.5, 0.5].map(|s| edge(cell.x_m, s)), [-0.5, 0.5].map(|s| edge(cell.y_m, s)));
            Shade { ring: vec![(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])], value: value(cell) }
        })
        .collect();
    let ends =
        parts.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.value), h.max(p.value)));
    // Values that are all the same still need a bar.
    let spread = (ends.1 - ends.0).max(1e-3 * ends.1.abs()).max(1e-9);
    let mut figure = ground(title)?;
    figure.push(Shades::new(unit, parts, ends.0, ends.0 + spread))?;
    push_places(&mut figure, answer, false)?;
    Ok(figure)
}

fn pairs_table(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("places", Align::Left),
        ("compared by", Align::Left),
        ("force ratio", Align::Right),
        ("tellable from", Align::Right),
        ("p", Align::Right),
        ("differ", Align::Right),
    ];
    let mut sorted: Vec<&Pair> = answer.pairs.iter().collect();
    sorted.sort_by(|a, b| b.differ.cmp(&a.differ).then(a.p.unwrap_or(1.0).total_cmp(&b.p.unwrap_or(1.0))));
    let more = sorted.len().saturating_sub(MOST_PAIRS);
    let rest = if more > 0 { format!("; {more} more are in the JSON answer") } else { String::new() };
    let mut table = Table::new(format!("Pairs, the least alike first{rest}"), columns);
    let or_dash = |value: Option<String>| value.unwrap_or_else(|| "–".into());
    for pair in sorted.iter().take(MOST_PAIRS) {
        let by = match pair.by {
            By::Forces => format!("forces of {} kinds", pair.kinds),
            By::Sets => "sets".into(),
            By::Nothing => "nothing".into(),
        };
        table.row([
            pair.places.join(", "),
            by,
            or_dash(pair.force_ratio.map(|ratio| format!("{ratio:.3}"))),
            or_dash(pair.tellable_ratio.map(|ratio| format!("{ratio:.3}"))),
            or_dash(pair.p.map(|p| format!("{p:.2e}"))),
            yes(pair.differ).to_owned(),
        ])?;
    }
    Ok(table)
}

fn method(page: &mut HtmlReport, answer: &Answer) {
    page.heading("Method");
    page.paragraph(
        "The set of a place is that of `estimate` with its strokes alone. Two places are compared by forces of strokes of one kind, which one \
         soil needs whatever the model, or by whether some soil explains the strokes of both. Places are put together as long as no two members \
         differ and some soil explains all their strokes.",
    );
    if let Some(rate) = answer.false_discovery {
        page.paragraph(format!(
            "Differences are told by Benjamini and Hochberg's rule with a false-discovery rate of {} %, on probabilities after Šidák that hold \
             however the errors of strokes are correlated.",
            number(100.0 * rate)
        ));
    }
    page.paragraph(
        "Between places: ordinary kriging of intervals with exponential covariances, the hull over all lengths and variances within 95 % of the \
         restricted likelihood.",
    );
}
