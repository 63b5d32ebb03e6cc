//! The data of a figure as a table in long form; the columns are documented at `Figure::to_csv`.

use crate::model::{Figure, Layer, Orientation, Shade};

const HEADER: &str = "layer,kind,name,part,ring,x,y,y_low,y_high,text\n";

/// The fields of one row after `layer,kind,name`; absent ones are empty.
#[derive(Default)]
struct Row<'a> {
    part_and_ring: Option<(usize, usize)>,
    x: Option<f64>,
    y: Option<f64>,
    y_low: Option<f64>,
    y_high: Option<f64>,
    /// Stands in the column of the text.
    value: Option<f64>,
    text: &'a str,
}

/// Writes all layers.
pub(crate) fn to_csv(figure: &Figure) -> String {
    let mut out = HEADER.to_owned();
    for (index, layer) in figure.layers.iter().enumerate() {
        let prefix = format!("{},{},{}", index + 1, layer.kind(), quoted(layer.name()));
        for row in rows(layer) {
            let (part, ring) = row
                .part_and_ring
                .map_or_else(Default::default, |(part, ring)| (part.to_string(), ring.to_string()));
            let [x, y, low, high] = [row.x, row.y, row.y_low, row.y_high].map(number);
            let text = row.value.map_or_else(|| quoted(row.text), |value| number(Some(value)));
            out += &format!("{prefix},{part},{ring},{x},{y},{low},{high},{text}\n");
        }
    }
    out
}

fn rows(layer: &Layer) -> Vec<Row<'_>> {
    let point = |&(x, y): &(f64, f64)| Row { x: Some(x), y: Some(y), ..Row::default() };
    match layer {
        Layer::Line(line) => line.points.iter().map(point).collect(),
        Layer::Band(band) => (0..band.x.len())
            .map(|i| Row {
                x: Some(band.x[i]),
                y_low: Some(band.low[i]),
                y_high: Some(band.high[i]),
                ..Row::default()
            })
            .collect(),
        Layer::Polygons(polygons) => {
            let mut rows = Vec::new();
            for (part, polygon) in polygons.parts.iter().enumerate() {
                for (ring, points) in std::iter::once(&polygon.exterior).chain(&polygon.holes).enumerate() {
                    let place = Some((part + 1, ring));
                    rows.extend(points.iter().map(|p| Row { part_and_ring: place, ..point(p) }));
                }
            }
            rows
        }
        Layer::Points(points) => {
            let bars = points.bars();
            let row = |(i, p): (usize, _)| Row {
                y_low: bars.as_ref().map(|bars| bars[i].0),
                y_high: bars.as_ref().map(|bars| bars[i].1),
                text: points.labels.as_ref().map_or("", |labels| labels[i].as_str()),
                ..point(p)
            };
            points.points.iter().enumerate().map(row).collect()
        }
        Layer::Paths(paths) => {
            let parts = paths.parts.iter().enumerate();
            let part = |(part, points): (usize, &'_ Vec<_>)| {
                let place = Some((part + 1, 0));
                points.iter().map(move |p| Row { part_and_ring: place, ..point(p) }).collect::<Vec<_>>()
            };
            parts.flat_map(part).collect()
        }
        Layer::Shades(shades) => {
            let parts = shades.parts.iter().enumerate();
            let part = |(part, shade): (usize, &Shade)| {
                let (place, value) = (Some((part + 1, 0)), Some(shade.value));
                let row = |p| Row { part_and_ring: place, value, ..point(p) };
                shade.ring.iter().map(row).collect::<Vec<_>>()
            };
            parts.flat_map(part).collect()
        }
        Layer::Span(span) if span.orientation == Orientation::Horizontal => {
            vec![Row { y_low: Some(span.low), y_high: Some(span.high), ..Row::default() }]
        }
        Layer::Span(span) => [span.low, span.high].map(|end| Row { x: Some(end), ..Row::default() }).into(),
        Layer::RefLine(line) if line.orientation == Orientation::Horizontal => {
            vec![Row { y: Some(line.at), ..Row::default() }]
        }
        Layer::RefLine(line) => vec![Row { x: Some(line.at), ..Row::default() }],
        Layer::Text(text) => vec![Row { text: &text.text, ..point(&text.at) }],
    }
}

/// The shortest text that reads back as the same value.
fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value:?}"))
}

fn quoted(field: &str) -> String {
    if field.contains(['"', ',', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}
