//! The page of two height maps.

use soilctl_app::heights::{Answer, VolumeAnswer};
use soilctl_app::text::number;
use soilctl_figure::{
    Align, Axis, CalloutKind, Dash, Figure, HtmlReport, Legend, Line, Paths, RefLine, Shade, Shades, Size,
    Span, Table,
};

use crate::PageError;

/// The page.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(answer: &Answer) -> Result<HtmlReport, PageError> {
    let mut page = HtmlReport::new("What does a scan of the ground say?");
    page.kind("Height maps").subtitle(format!(
        "Before and after a stroke with a plate {} mm wide; a cell is {} mm",
        number(1e3 * answer.plate.width_m),
        number(round(1e3 * answer.maps.first().map_or(0.0, |map| map.cell_m)))
    ));
    let (kind, title) = if answer.ground_break.is_some() {
        (CalloutKind::Good, "Where the ground broke")
    } else {
        (CalloutKind::Warning, "Where the ground broke cannot be said")
    };
    page.verdict(kind, title, answer.verdict.as_str());
    for warning in &answer.warnings {
        page.callout(CalloutKind::Warning, "Keep in mind", warning.as_str());
    }
    page.heading("Ahead of the plate");
    page.figure(
        &profile(answer)?,
        Size::new(760, 400)?,
        "Change of height along the plate's heading, the mean over its middle half. The strip is where the ground broke, with two standard deviations and the resolution.",
    )?;
    page.heading("From above");
    page.figure(
        &rise(answer)?,
        Size::new(760, 520)?,
        "What rose. The plate stands at 0 and pushed to the right; the dashed line is where the ground broke.",
    )?;
    page.figure(&fall(answer)?, Size::new(760, 520)?, "What sank.")?;
    page.table(volumes(answer)?);
    page.heading("The maps");
    page.table(maps(answer)?);
    page.table(moved(answer)?);
    page.heading("Method");
    page.paragraph(
        "The second map is laid on the first by a plane, and a shift sideways where slopes of the ground show one, from ground away from the plate's path that did not change. What is left \
         there is the noise. The edge is found on the mean over lines across the middle half of the plate: for every place where the rise may end, a step, a slope and a \
         hollow foot are fitted up to it and nothing beyond, and how well that fits is the place's weight. Volumes are sums over what stands out of the noise, with \
         two cells around it, and further rings as long as their mean does.",
    );
    Ok(page)
}

fn round(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

fn profile(answer: &Answer) -> Result<Figure, PageError> {
    let points: Vec<(f64, f64)> = answer
        .profile
        .ahead_m
        .iter()
        .zip(&answer.profile.rise_m)
        .filter_map(|(ahead, rise)| Some((1e3 * ahead, 1e3 * (*rise)?)))
        .collect();
    if points.is_empty() {
        return Err(PageError::Nothing(
            "there is nothing to draw: no ground ahead of the plate was seen".into(),
        ));
    }
    // Beyond twice the distance there is noise only.
    let end = points.last().map_or(1.0, |last| last.0);
    let end = answer.ground_break.as_ref().map_or(end, |broke| end.min(2.5e3 * broke.within_m[1]));
    let points: Vec<(f64, f64)> = points.into_iter().filter(|point| point.0 <= end).collect();
    let mut figure = Figure::new(
        "Change of height ahead of the plate",
        Axis::linear("Distance from the plate's face (mm)"),
        Axis::linear("Change of height (mm)"),
    )
    .with_legend(Legend::Below);
    let noise = 1e3 * answer.profile.noise_m * answer.deviations;
    figure.push(
        Span::horizontal(format!("noise, {} standard deviations", number(answer.deviations)), -noise, noise)
            .color(7),
    )?;
    if let Some(broke) = &answer.ground_break {
        // Distances are along the surface, the profile on the map.
        let level = on_map(answer.slope_deg);
        let [low, high] = broke.within_m.map(|m| 1e3 * m * level);
        figure.push(Span::vertical("where the ground broke", low, high))?;
        figure.push(RefLine::vertical("most likely", 1e3 * broke.distance_m * level))?;
    }
    figure.push(Line::new("mean over the lines", points).width(2.0))?;
    Ok(figure)
}

/// A length along ground of a slope over that on the map.
fn on_map(slope_deg: f64) -> f64 {
    slope_deg.to_radians().cos()
}

fn rise(answer: &Answer) -> Result<Figure, PageError> {
    above(answer, "What rose", "rise (mm)", 1.0)
}

fn fall(answer: &Answer) -> Result<Figure, PageError> {
    above(answer, "What sank", "fall (mm)", -1.0)
}

/// Changes of one sign, seen from above in the plate's directions.
fn above(answer: &Answer, title: &str, name: &str, sign: f64) -> Result<Figure, PageError> {
    let picture = &answer.picture;
    let mut figure = Figure::new(
        title,
        Axis::linear("Ahead of the plate's face (mm)"),
        Axis::linear("To the left of its middle (mm)"),
    )
    .with_legend(Legend::Below)
    .with_equal_aspect()?;
    let half = 500.0 * picture.cell_m;
    // Corners are counted, so that those of neighbours are the same to the last bit.
    let edge = |centres: &[f64], i: usize| {
        let first = centres.first().copied().unwrap_or(0.0);
        1e3 * first - half + 2.0 * half * i as f64
    };
    let mut parts = Vec::new();
    for (j, row) in picture.change_m.iter().enumerate() {
        for (i, change) in row.iter().enumerate() {
            let Some(change) = change else { continue };
            let [left, right] = [i, i + 1].map(|i| edge(&picture.ahead_m, i));
            let [below, above] = [j, j + 1].map(|j| edge(&picture.left_m, j));
            let ring = vec![(left, below), (right, below), (right, above), (left, above)];
            parts.push(Shade { ring, value: 1e3 * (sign * change).max(0.0) });
        }
    }
    let most = if sign > 0.0 { answer.heap.most_m } else { answer.furrow.most_m };
    let top = 1e3 * most.max(answer.deviations * answer.noise_m);
    figure.push(Shades::new(name, parts, 0.0, top))?;
    let wide = 500.0 * answer.plate.width_m;
    figure.push(Line::new("plate", vec![(0.0, -wide), (0.0, wide)]).width(4.0).dash(Dash::Solid).color(6))?;
    if let Some(broke) = &answer.ground_break {
        let at = 1e3 * broke.distance_m * on_map(answer.slope_deg);
        let line = vec![(at, -wide), (at, wide)];
        figure.push(Line::new("where the ground broke", line).width(2.0).dash(Dash::Dash).color(1))?;
    }
    // The part of the width that the profile is the mean of.
    let ends = [-0.5 * wide, 0.5 * wide];
    let far = 1e3 * answer.ground_break.as_ref().map_or(answer.plate.width_m, |broke| broke.within_m[1]);
    let lines: Vec<Vec<(f64, f64)>> = ends.iter().map(|y| vec![(0.0, *y), (far, *y)]).collect();
    figure.push(Paths::new("lines of the profile", lines).width(1.0).color(2))?;
    Ok(figure)
}

fn volumes(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("", Align::Left),
        ("volume (l)", Align::Right),
        ("± (l)", Align::Right),
        ("at most (mm)", Align::Right),
        ("cells", Align::Right),
        ("not seen", Align::Right),
    ];
    let mut table = Table::new("Heap and furrow, with one standard deviation", columns);
    let mut row = |name: &str, of: &VolumeAnswer| {
        table
            .row([
                name.to_owned(),
                format!("{:.4}", 1e3 * of.volume_m3),
                format!("{:.4}", 1e3 * of.sd_m3),
                format!("{:.1}", 1e3 * of.most_m),
                of.cells.to_string(),
                of.hidden_cells.to_string(),
            ])
            .map(|_| ())
    };
    row("heap", &answer.heap)?;
    row("furrow", &answer.furrow)?;
    Ok(table)
}

fn maps(answer: &Answer) -> Result<Table, PageError> {
    let columns = [
        ("", Align::Left),
        ("file", Align::Left),
        ("cells", Align::Right),
        ("seen", Align::Right),
        ("points", Align::Right),
        ("a cell", Align::Right),
        ("frame", Align::Left),
    ];
    let mut table = Table::new("What was read around the plate", columns);
    let count = |number: Option<usize>| number.map_or_else(|| "–".to_owned(), |number| number.to_string());
    for (name, map) in ["before", "after"].into_iter().zip(&answer.maps) {
        let [columns, rows] = map.size;
        let file = map.file.rsplit(['/', '\\']).next().unwrap_or_default();
        table.row([
            name.to_owned(),
            file.to_owned(),
            format!("{columns} × {rows}"),
            map.seen.to_string(),
            count(map.points),
            count(map.points_per_cell),
            if map.frame.is_empty() { "–".to_owned() } else { map.frame.clone() },
        ])?;
    }
    Ok(table)
}

fn moved(answer: &Answer) -> Result<Table, PageError> {
    let columns = [("", Align::Left), ("", Align::Right)];
    let mut table = Table::new("How the second map lies against the first on unchanged ground", columns);
    let shift = &answer.shift;
    let mm = |m: f64| format!("{:.2} mm", 1e3 * m);
    for (name, value) in [
        ("higher at the plate", format!("{} ± {}", mm(shift.up_m), mm(shift.up_sd_m))),
        ("tilted along x and y", format!("{:.3}° and {:.3}°", shift.tilt_deg[0], shift.tilt_deg[1])),
        ("to the side along x and y", format!("{} and {}", mm(shift.sideways_m[0]), mm(shift.sideways_m[1]))),
        ("noise of a cell", mm(answer.noise_m)),
        ("noise of the profile", mm(answer.profile.noise_m)),
    ] {
        table.row([name.to_owned(), value])?;
    }
    Ok(table)
}
