//! SVG, PNG, CSV and grid output.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::everything;
use resvg::usvg::roxmltree::{Document, Node};
use soilctl_figure::{Axis, Dash, Figure, FigureGrid, HtmlReport, Legend, Line, Size};

fn lines(count: usize) -> Figure {
    let mut figure = Figure::new("t", Axis::linear("x"), Axis::linear("y"));
    for i in 0..count {
        let y = i as f64;
        figure.push(Line::new(format!("line {i}"), [(0.0, y), (1.0, y + 1.0)]).dash(Dash::Solid)).unwrap();
    }
    figure
}

/// Paths drawn with a line of the given colour.
fn strokes(svg: &str, color: &str) -> usize {
    let document = Document::parse(svg).unwrap();
    document.descendants().filter(|node| node.attribute("stroke") == Some(color)).count()
}

/// All texts but the document's title.
fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts.filter_map(|node| node.text().map(str::to_owned)).collect()
}

#[test]
fn svg_has_one_stroke_per_line_and_one_in_the_legend() {
    let figure = lines(3);
    let svg = figure.to_svg(Size::default()).unwrap();
    assert_eq!(strokes(&svg, "#0072b2"), 2);
    assert_eq!(strokes(&svg, "#d55e00"), 2);
    for i in 0..3 {
        assert!(texts(&svg).contains(&format!("line {i}")), "legend {i}");
    }
    let plain = figure.with_legend(Legend::Hidden).to_svg(Size::default()).unwrap();
    assert_eq!(strokes(&plain, "#0072b2"), 1);
    assert!(!plain.contains("line 0"));
}

#[test]
fn svg_of_hostile_text_is_well_formed_and_inert() {
    let svg = everything().unwrap().to_svg(Size::default()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let known = ["svg", "title", "rect", "pattern", "path", "circle", "text"];
    let mut elements = document.descendants().filter(Node::is_element);
    assert!(elements.all(|node| known.contains(&node.tag_name().name())));
    assert!(texts(&svg).iter().any(|text| text.starts_with("<script>alert(")));
}

#[test]
fn what_is_referred_to_is_there_and_has_a_name_of_its_own() {
    let mut report = HtmlReport::new("page");
    for _ in 0..2 {
        report.figure(&everything().unwrap(), Size::default(), "").unwrap();
    }
    let svg = everything().unwrap().to_svg(Size::default()).unwrap();
    for document in [svg, report.to_html()] {
        let names = |before: &str, after: &str| -> Vec<String> {
            let parts = document.split(before).skip(1);
            parts.map(|part| part.split_once(after).unwrap().0.to_owned()).collect()
        };
        let (mut patterns, wanted) = (names("<pattern id=\"", "\""), names("fill=\"url(#", ")\""));
        assert!(!wanted.is_empty() && wanted.iter().all(|name| patterns.contains(name)), "{wanted:?}");
        let count = patterns.len();
        patterns.sort();
        patterns.dedup();
        assert_eq!(patterns.len(), count);
    }
}

#[test]
fn long_legends_leave_room_for_the_plot() {
    for legend in [Legend::Below, Legend::Right] {
        let svg = lines(200).with_legend(legend).to_svg(Size::new(400, 300).unwrap()).unwrap();
        assert!(svg.contains(" more"), "{legend:?}");
        assert!(!svg.contains("\"M-") && !svg.contains("translate(-"), "nothing left of or above the page");
    }
}

/// Width, height and the pixels row by row.
fn decoded(png: &[u8]) -> (usize, usize, Vec<[u8; 3]>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    let pixels = bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    (info.width as usize, info.height as usize, pixels)
}

#[test]
fn png_has_the_promised_size_and_shows_something() {
    let size = Size::new(300, 200).unwrap();
    let (width, height, pixels) = decoded(&everything().unwrap().to_png(size).unwrap());
    assert_eq!((width, height), (600, 400));
    let count = |shown: &dyn Fn(&[u8; 3]) -> bool| pixels.iter().filter(|p| shown(p)).count();
    let colored = count(&|p| p.iter().max().unwrap() - p.iter().min().unwrap() > 40);
    let white = count(&|p| *p == [255, 255, 255]);
    // The border of the plot area lies on whole pixels, so it has exactly its colour.
    let ink = count(&|p| *p == [0x1f, 0x23, 0x28]);
    assert!(colored > 1000 && ink > 1500 && white > 50_000, "{colored} {ink} {white}");
}

#[test]
fn words_of_a_png_are_in_their_places() {
    let mut figure = Figure::new("HHHH", Axis::linear("x"), Axis::linear("y"));
    figure.push(Line::new("", [(0.0, 0.0), (1.0, 1.0)])).unwrap();
    let (width, _, pixels) = decoded(&figure.to_png(Size::new(400, 300).unwrap()).unwrap());
    // Nothing but the title is in the uppermost 32 px.
    let dark = (0..64 * width).filter(|&i| pixels[i].iter().all(|&c| c < 128));
    let (columns, rows): (Vec<usize>, Vec<usize>) = dark.map(|i| (i % width, i / width)).unzip();
    let ends = |of: &[usize]| (*of.iter().min().unwrap(), *of.iter().max().unwrap());
    let ((left, right), (top, bottom)) = (ends(&columns), ends(&rows));
    assert!((left + right + 1).abs_diff(width) <= 2, "centred, but it goes from {left} to {right}");
    // An H of DejaVu Sans Bold is 1714 units wide with 377 units of room in all beside it, and 1493 high, of 2048 an em.
    let em = 15.0 * 2.0 / 2048.0;
    assert!(((right - left + 1) as f64 - (4.0 * 1714.0 - 377.0) * em).abs() < 2.0, "{left} {right}");
    assert!(((bottom - top + 1) as f64 - 1493.0 * em).abs() < 2.0, "{top} {bottom}");
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
    assert_eq!(strokes(&svg, "#0072b2"), 6);
    assert!(grid.to_svg(Size::new(300, 300).unwrap()).is_err());
}
