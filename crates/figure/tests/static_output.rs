//! SVG, PNG, CSV and grid output.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{assert_well_formed, everything};
use soilctl_figure::{Axis, Dash, Figure, FigureGrid, Legend, Line, Size};

fn lines(count: usize) -> Figure {
    let mut figure = Figure::new("t", Axis::linear("x"), Axis::linear("y"));
    for i in 0..count {
        let y = i as f64;
        figure.push(Line::new(format!("line {i}"), [(0.0, y), (1.0, y + 1.0)]).dash(Dash::Solid)).unwrap();
    }
    figure
}

/// Polylines in the given colour.
fn strokes(svg: &str, color: &str) -> usize {
    let stroke = format!("stroke=\"{color}\"");
    svg.lines().filter(|line| line.starts_with("<polyline") && line.contains(&stroke)).count()
}

#[test]
fn svg_has_one_stroke_per_line_and_one_in_the_legend() {
    let figure = lines(3);
    let svg = figure.to_svg(Size::default()).unwrap();
    assert_well_formed(&svg);
    assert_eq!(strokes(&svg, "#0072B2"), 2);
    assert_eq!(strokes(&svg, "#D55E00"), 2);
    for i in 0..3 {
        assert!(svg.contains(&format!("\nline {i}\n")) || svg.contains(&format!(">line {i}<")), "legend {i}");
    }
    let plain = figure.with_legend(Legend::Hidden).to_svg(Size::default()).unwrap();
    assert_eq!(strokes(&plain, "#0072B2"), 1);
    assert!(!plain.contains("line 0"));
}

#[test]
fn svg_of_hostile_text_is_well_formed_and_inert() {
    let svg = everything().unwrap().to_svg(Size::default()).unwrap();
    assert_well_formed(&svg);
    assert!(!svg.contains("<script") && !svg.contains('\u{0}'));
    assert!(svg.contains("&lt;script&gt;"));
}

#[test]
fn long_legends_leave_room_for_the_plot() {
    for legend in [Legend::Below, Legend::Right] {
        let svg = lines(200).with_legend(legend).to_svg(Size::new(400, 300).unwrap()).unwrap();
        assert!(svg.contains(" more"), "{legend:?}");
        assert!(!svg.contains("\"-"), "nothing left of or above the page");
    }
}

#[test]
fn png_has_the_promised_size_and_shows_something() {
    let size = Size::new(300, 200).unwrap();
    let png = everything().unwrap().to_png(size).unwrap();
    let mut reader = png::Decoder::new(png.as_slice()).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (600, 400));
    let colored = pixels.chunks(3).filter(|p| p.iter().max().unwrap() - p.iter().min().unwrap() > 40).count();
    let dark = pixels.chunks(3).filter(|p| p.iter().all(|&c| c < 90)).count();
    let white = pixels.chunks(3).filter(|p| *p == [255, 255, 255]).count();
    assert!(colored > 1000 && dark > 500 && white > 50_000, "{colored} {dark} {white}");
}

#[test]
fn output_is_reproducible() {
    let (a, b) = (everything().unwrap(), everything().unwrap());
    let size = Size::new(300, 200).unwrap();
    assert_eq!(a.to_svg(size), b.to_svg(size));
    assert_eq!(a.to_png(size), b.to_png(size));
    assert_eq!(a.to_csv(), b.to_csv());
    assert_eq!(a.to_plotly_json().to_string(), b.to_plotly_json().to_string());
}

/// Splits RFC 4180 text into records.
fn parse(csv: &str) -> Vec<Vec<String>> {
    let (mut records, mut record, mut field, mut quoted) = (Vec::new(), Vec::new(), String::new(), false);
    let mut chars = csv.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' if quoted && chars.peek() == Some(&'"') => field.push(chars.next().unwrap()),
            '"' => quoted = !quoted,
            ',' if !quoted => record.push(std::mem::take(&mut field)),
            '\n' if !quoted => {
                record.push(std::mem::take(&mut field));
                records.push(std::mem::take(&mut record));
            }
            c => field.push(c),
        }
    }
    records
}

#[test]
fn csv_reads_back_exactly() {
    let records = parse(&everything().unwrap().to_csv());
    assert!(records.iter().all(|record| record.len() == 10));
    let of = |kind: &str| records.iter().filter(|r| r[1] == kind).collect::<Vec<_>>();
    let number = |text: &str| text.parse::<f64>().unwrap();
    assert_eq!(of("line").len(), 3);
    assert_eq!(number(&of("line")[2][6]), 1.0 / 3.0);
    assert_eq!(of("line")[0][2], common::HOSTILE);
    assert_eq!(of("band")[1][2], "band, \"quoted\"");
    assert_eq!((number(&of("band")[1][7]), number(&of("band")[1][8])), (1.0, 3.0));
    assert_eq!(of("polygons").iter().filter(|r| r[4] == "1").count(), 4);
    assert_eq!((number(&of("points")[0][7]), number(&of("points")[0][8])), (0.5, 1.25));
    assert_eq!(of("points")[1][9], common::HOSTILE);
    assert_eq!(of("vspan").len(), 2);
    assert_eq!(number(&of("hline")[0][6]), 2.0);
    assert_eq!(of("paths").iter().map(|r| r[3].as_str()).collect::<Vec<_>>(), ["1", "1", "2", "2", "2"]);
    assert!(of("shades").len() == 4 && of("shades").iter().all(|r| number(&r[9]) == 0.7));
    assert_eq!(records.len(), 1 + 3 + 2 + 8 + 2 + 5 + 4 + 1 + 2 + 1 + 1 + 1);
}

#[test]
fn grids_hold_all_figures() {
    let grid = FigureGrid::new([lines(1), lines(2), lines(3)], 2).unwrap();
    let svg = grid.to_svg(Size::new(900, 700).unwrap()).unwrap();
    assert_well_formed(&svg);
    assert_eq!(strokes(&svg, "#0072B2"), 6);
    assert!(grid.to_svg(Size::new(300, 300).unwrap()).is_err());
}
