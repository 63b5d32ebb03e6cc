#![allow(clippy::unwrap_used, reason = "tests")]

use std::f64::consts::{FRAC_PI_2, PI};

use super::arc::{bulged, chords};
use super::pairs::unescaped;
use crate::{Drawing, DrawingError, Format, Outline, Reading, Unit};

/// A drawing of entities, each as codes and values with spaces between.
fn drawing(head: &str, entities: &str) -> Result<Drawing, DrawingError> {
    let lines = |text: &str| text.split_whitespace().collect::<Vec<_>>().join("\n");
    let text = format!("{}\n0\nSECTION\n2\nENTITIES\n{}\n0\nENDSEC\n0\nEOF\n", lines(head), lines(entities));
    Drawing::from_bytes(text.trim_start().as_bytes(), Format::Dxf, &Reading::default())
}

#[test]
fn an_arc_keeps_to_its_circle_and_chords_are_near() {
    for (radius, near) in [(10.0, 0.01), (0.5, 0.01), (300.0, 0.5)] {
        let points = chords([1.0, 2.0], radius, 0.3, PI, near);
        let mut last = [1.0 + radius * f64::cos(0.3), 2.0 + radius * f64::sin(0.3)];
        for p in points {
            let of_centre = |p: [f64; 2]| (p[0] - 1.0).hypot(p[1] - 2.0);
            assert!((of_centre(p) - radius).abs() < 1e-9 * radius);
            let middle = [0.5 * (last[0] + p[0]), 0.5 * (last[1] + p[1])];
            assert!(radius - of_centre(middle) <= near * (1.0 + 1e-9));
            last = p;
        }
    }
}

#[test]
fn a_bulge_of_one_is_half_a_circle_to_the_right_of_the_way() {
    // Counter-clockwise from (0, 0) to (2, 0): through (1, -1).
    let points = bulged([0.0, 0.0], [2.0, 0.0], 1.0, 1e-3);
    let lowest = points.iter().map(|p| p[1]).fold(0.0, f64::min);
    assert!((lowest + 1.0).abs() < 2e-3, "{lowest}");
    assert_eq!(points.last(), Some(&[2.0, 0.0]));
    // A quarter of a circle has the bulge tan(22.5 deg), and its middle is (1 - cos 45) / sin 45 of half the chord away.
    let quarter = bulged([0.0, 0.0], [2.0, 0.0], -(FRAC_PI_2 / 4.0).tan(), 1e-4);
    let highest = quarter.iter().map(|p| p[1]).fold(0.0, f64::max);
    assert!((highest - (FRAC_PI_2 / 4.0).tan()).abs() < 1e-3, "{highest}");
}

#[test]
fn lines_that_meet_are_an_area_and_others_are_not() {
    let side = |x: [f64; 4], layer: &str| {
        format!("0 LINE 8 {layer} 10 {} 20 {} 11 {} 21 {} ", x[0], x[1], x[2], x[3])
    };
    let square = [[0.0, 0.0, 1.0, 0.0], [1.0, 1.0, 1.0, 0.0], [1.0, 1.0, 0.0, 1.0005], [0.0, 0.0, 0.0, 1.0]];
    let text: String = square.iter().map(|x| side(*x, "sand")).collect();
    let found = drawing("", &(text.clone() + &side([5.0, 5.0, 6.0, 5.0], "sand"))).unwrap();
    assert_eq!(found.shapes.len(), 2);
    assert_eq!((found.shapes[0].outline, found.shapes[0].corners.len()), (Outline::Closed, 4));
    assert_eq!(found.shapes[1].outline, Outline::Open);
    // A line that leads away from a corner is not in the way; one across makes two areas of it.
    let outlines = |text: &str| {
        let shapes = drawing("", text).unwrap().shapes;
        shapes.iter().map(|shape| (shape.outline, shape.corners.len())).collect::<Vec<_>>()
    };
    let away = outlines(&(text.clone() + &side([0.0, 0.0, -1.0, -1.0], "sand")));
    assert_eq!(away, [(Outline::Closed, 4), (Outline::Open, 2)]);
    let across = outlines(&(text.clone() + &side([0.0, 0.0, 1.0, 1.0], "sand")));
    assert_eq!(across, [(Outline::Closed, 3), (Outline::Closed, 3)]);
    // On another layer it is another matter.
    let other = outlines(&(text.clone() + &side([0.0, 0.0, 1.0, 1.0], "rock")));
    assert_eq!(other, [(Outline::Closed, 4), (Outline::Open, 2)]);
    // A line between two areas bounds neither of them.
    let second: String = [[5.0, 0.0, 6.0, 0.0], [6.0, 0.0, 5.0, 1.0], [5.0, 1.0, 5.0, 0.0]]
        .iter()
        .map(|x| side(*x, "sand"))
        .collect();
    let bridged = outlines(&(text + &second + &side([1.0, 0.0, 5.0, 0.0], "sand")));
    assert_eq!(bridged, [(Outline::Closed, 4), (Outline::Closed, 3), (Outline::Open, 2)]);
}

#[test]
fn what_is_hidden_or_unknown_is_left_out_and_counted() {
    let head = "0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 off 70 0 62 -7 0 LAYER 2 \
                frozen 70 1 62 7 0 LAYER 2 sand 70 0 62 7 0 ENDTAB 0 ENDSEC";
    let line = |layer: &str, more: &str| format!("0 LINE 8 {layer} 10 0 20 0 11 1000 21 0 {more} ");
    let text = line("off", "")
        + &line("frozen", "")
        + &line("sand", "")
        + &line("sand", "67 1")
        + &line("sand", "210 1 220 0 230 0")
        + "0 HATCH 8 sand 0 HATCH 8 sand 0 WIPEOUT 8 sand";
    let found = drawing(head, &text).unwrap();
    assert_eq!(found.unit, Some(Unit::Millimetre));
    assert_eq!(found.shapes.len(), 1);
    assert_eq!(found.shapes[0].corners, [[0.0, 0.0], [1.0, 0.0]]);
    let counts: Vec<_> =
        found.left_out.iter().map(|(it, n)| (it.layer.as_str(), it.what.as_str(), *n)).collect();
    let line = "LINE";
    assert_eq!(counts[..3], [("frozen", line, 1), ("off", line, 1), ("sand", "HATCH", 2)]);
    assert_eq!(counts[3..], [("sand", line, 1), ("sand", line, 1), ("sand", "WIPEOUT", 1)]);
}

#[test]
fn what_is_no_drawing_is_refused_with_the_line() {
    let read = |text: &[u8]| Drawing::from_bytes(text, Format::Dxf, &Reading::default()).unwrap_err();
    assert!(matches!(read(b"hello\nworld\n"), DrawingError::Malformed { line: 1, .. }));
    assert!(matches!(read(b"AutoCAD Binary DXF\r\n\x1a\0"), DrawingError::Kind(_)));
    assert!(matches!(read(b"AC1032\0\0"), DrawingError::Kind(_)));
    assert!(matches!(read(b"0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n"), DrawingError::Kind(_)));
    let nan = drawing("", "0 LINE 8 a 10 nan 20 0 11 1 21 1").unwrap_err();
    assert!(matches!(nan, DrawingError::Malformed { .. }), "{nan}");
    let far = drawing("", "0 LINE 8 a 10 1e7 20 0 11 1 21 1").unwrap_err();
    assert!(matches!(far, DrawingError::Coordinate { .. }), "{far}");
}

#[test]
fn letters_of_other_alphabets_come_back() {
    assert_eq!(unescaped("T\\U+00F6n \\U+12 \\U+00G1 \\U+03B1"), "Tön \\U+12 \\U+00G1 α");
}

#[test]
fn arcs_beyond_the_limit_are_refused_before_they_fill_the_memory() {
    let corners = "10 0 20 0 42 1 10 1000 20 0 42 1 ".repeat(100_000);
    let found = drawing("", &format!("0 LWPOLYLINE 8 sand 70 1 {corners}")).unwrap_err();
    assert!(
        matches!(found, DrawingError::TooLarge { what: "corners", count, .. } if count < 102_000),
        "{found}"
    );
}
