//! What figures refuse, and that whatever they accept can be drawn.
#![allow(clippy::unwrap_used, clippy::expect_used)]

use proptest::prelude::*;
use soilctl_figure::{
    Axis, Band, Figure, FigureError, FigureGrid, Layer, Legend, Line, Paths, Points, Polygon, Polygons,
    RefLine, Shade, Shades, Size, Span, Table, Text,
};

fn linear() -> Figure {
    Figure::new("t", Axis::linear("x"), Axis::linear("y"))
}

fn refused(layer: impl Into<Layer>) -> FigureError {
    linear().push(layer).map(|_| ()).expect_err("must be refused")
}

#[test]
fn bad_values_are_named() {
    for bad in [f64::NAN, f64::INFINITY, -1e101] {
        let error = refused(Line::new("stress", [(0.0, 1.0), (bad, 1.0)]));
        assert!(matches!(error, FigureError::NotFinite { index: 1, what: "x", .. }), "{error}");
        assert!(error.to_string().contains("stress") && error.to_string().contains("x[1]"), "{error}");
        refused(Band::new("b", [0.0, 1.0], [0.0, bad], [1.0, 1.0]));
        refused(Polygons::new("p", [Polygon::new([(0.0, 0.0), (1.0, 0.0), (bad, 1.0)])]));
        refused(RefLine::vertical("r", bad));
        refused(Span::vertical("s", 0.0, bad));
        refused(Text::new("t", (bad, 0.0)));
        refused(Points::new("p", [(0.0, 0.0)]).y_error([(bad, 0.0)]));
    }
}

#[test]
fn mismatched_and_missing_data_are_refused() {
    use FigureError as E;
    type Case = (Layer, fn(&E) -> bool);
    let triangle = |value: f64| Shade { ring: vec![(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], value };
    let cases: [Case; 13] = [
        (Line::new("l", []).into(), |e| matches!(e, E::TooFewPoints { .. })),
        (Line::new("l", [(0.0, 0.0)]).width(0.0).into(), |e| matches!(e, E::BadWidth { .. })),
        (Band::new("b", [0.0, 1.0], [0.0], [1.0, 1.0]).into(), |e| {
            matches!(e, E::LengthMismatch { found: 1, .. })
        }),
        (Polygons::new("p", [Polygon::new([(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)])]).into(), |e| {
            matches!(e, E::TooFewPoints { needed: 3, found: 2, .. })
        }),
        (Points::new("p", [(0.0, 0.0)]).labels(["a", "b"]).into(), |e| matches!(e, E::LengthMismatch { .. })),
        (Points::new("p", [(0.0, 0.0)]).y_error([(-1.0, 0.0)]).into(), |e| {
            matches!(e, E::BadErrorBar { .. })
        }),
        (Span::horizontal("s", 2.0, 1.0).into(), |e| matches!(e, E::Inverted { .. })),
        (Polygons::new("p", []).into(), |e| matches!(e, E::TooFewPoints { .. })),
        (Paths::new("p", []).into(), |e| matches!(e, E::TooFewPoints { .. })),
        (Paths::new("p", [vec![(0.0, 0.0)]]).into(), |e| matches!(e, E::TooFewPoints { needed: 2, .. })),
        (Paths::new("p", [vec![(0.0, 0.0), (1.0, 0.0)]]).width(0.1).into(), |e| {
            matches!(e, E::BadWidth { .. })
        }),
        (Shades::new("s", [triangle(1.0)], 2.0, 2.0).into(), |e| matches!(e, E::Inverted { .. })),
        (Shades::new("s", [triangle(f64::NAN)], 0.0, 1.0).into(), |e| {
            matches!(e, E::NotFinite { what: "values", .. })
        }),
    ];
    for (layer, expected) in cases {
        let error = refused(layer);
        assert!(expected(&error), "{error:?}");
    }
}

#[test]
fn logarithmic_axes_need_positive_values() {
    let mut figure = Figure::new("t", Axis::log("x"), Axis::linear("y"));
    let error = figure.push(Line::new("l", [(0.0, -1.0)])).map(|_| ()).unwrap_err();
    assert!(matches!(error, FigureError::NotPositive { what: "x", .. }));
    assert!(figure.push(Span::vertical("s", -1.0, 1.0)).is_err());
    assert!(figure.push(Span::horizontal("s", -1.0, 1.0)).is_ok());
    assert!(figure.with_equal_aspect().is_err());
}

#[test]
fn bad_ranges_sizes_and_pages_are_refused() {
    assert!(matches!(Axis::linear("x").range(1.0, 1.0), Err(FigureError::Inverted { .. })));
    assert!(matches!(Axis::linear("x").range(2.0, 1.0), Err(FigureError::Inverted { .. })));
    assert!(matches!(Axis::log("x").range(0.0, 1.0), Err(FigureError::BadRangeEnd { .. })));
    assert!(matches!(Axis::linear("x").range(f64::NAN, 1.0), Err(FigureError::BadRangeEnd { .. })));
    assert!(matches!(Size::new(10, 500), Err(FigureError::BadSize { .. })));
    assert!(matches!(Size::new(500, 50_000), Err(FigureError::BadSize { .. })));
    assert!(matches!(linear().to_svg(Size::default()), Err(FigureError::EmptyFigure { .. })));
    assert!(matches!(FigureGrid::new([], 2), Err(FigureError::BadGrid { .. })));
    assert!(matches!(
        Table::new("t", [("a", soilctl_figure::Align::Left)]).row(["1", "2"]),
        Err(FigureError::BadRow { .. })
    ));
}

#[test]
fn a_refused_layer_leaves_the_figure_unchanged() {
    let mut figure = linear();
    figure.push(Line::new("l", [(0.0, 0.0), (1.0, 1.0)])).unwrap();
    let before = figure.clone();
    assert!(figure.push(Line::new("l", [(f64::NAN, 0.0)])).is_err());
    assert_eq!(figure, before);
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -1e3..1e3,
        prop::sample::select(vec![0.0, 1e100, -1e100, 1e-300, 1e15, 1.0, 1.0 + 1e-15, f64::NAN]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn whatever_is_accepted_can_be_drawn(
        points in prop::collection::vec((coordinate(), coordinate()), 1..6),
        log in any::<bool>(),
        equal in any::<bool>(),
        name in ".{0,60}",
        width in 160u32..400,
    ) {
        let axis = |label: &str| if log { Axis::log(label) } else { Axis::linear(label) };
        let mut figure = Figure::new(name.clone(), axis(&name), axis("y")).with_legend(Legend::Right);
        if equal && !log {
            figure = figure.with_equal_aspect().unwrap();
        }
        let x: Vec<f64> = points.iter().map(|p| p.0).collect();
        let shade = Shade { ring: points.clone(), value: points[0].0 };
        let layers: [Layer; 7] = [
            Line::new(name.as_str(), points.clone()).into(),
            Points::new("p", points.clone()).into(),
            Band::new("b", x.clone(), x.clone(), x).into(),
            Polygons::new("a", [Polygon::new(points.clone())]).into(),
            Text::new(name.as_str(), points[0]).into(),
            Paths::new(name.as_str(), [points.clone()]).arrows().into(),
            Shades::new(name.as_str(), [shade], points[0].1, 1.0).into(),
        ];
        let accepted = layers.into_iter().filter(|layer| figure.push(layer.clone()).is_ok()).count();
        let size = Size::new(width, 160).unwrap();
        if accepted > 0 {
            let svg = figure.to_svg(size).unwrap();
            prop_assert!(!svg.contains("NaN") && !svg.contains("inf"));
            // Programs that show the picture count in single precision: nothing may lie far beyond the page.
            let places = svg.split(" d=\"").skip(1).filter_map(|part| part.split('"').next());
            let numbers = places.flat_map(|d| d.split(['M', ' ', 'Z'])).filter_map(|n| n.parse::<f64>().ok());
            prop_assert!(numbers.into_iter().all(|n| (-20.0..420.0).contains(&n)));
            prop_assert!(figure.to_png(size).is_ok());
            prop_assert!(!figure.to_plotly_json()["layout"]["xaxis"]["range"].to_string().contains("null"));
        }
    }
}

#[test]
fn arrows_whose_heads_reach_below_zero_of_a_logarithmic_axis_are_drawn_without_heads() {
    let points = [(422.055_725_604_602_46, 1e15), (1e100, 183.420_642_181_318_95)];
    let mut figure = Figure::new("", Axis::log(""), Axis::log("y")).with_legend(Legend::Right);
    figure.push(Line::new("l", points)).unwrap();
    figure.push(Paths::new("", [points.to_vec()]).arrows()).unwrap();
    let svg = figure.to_svg(Size::new(160, 160).unwrap()).unwrap();
    assert!(!svg.contains("NaN"), "{svg}");
}
