//! What is written comes back in every format, and files made to do harm do none.

#![allow(clippy::unwrap_used, reason = "tests")]

use proptest::prelude::*;
use soilctl_drawing::{Drawing, Format, Outline, Reading, Shape};
use soilctl_mutants::{Random, count};

const FORMATS: [Format; 3] = [Format::Dxf, Format::GeoJson, Format::Csv];

fn shapes() -> impl Strategy<Value = Vec<Shape>> {
    let corner = (-1e3..1e3, -1e2..1e2).prop_map(|(x, y)| [x, y]);
    let names = prop::sample::select(vec!["sand", "stiff clay", "Löß", "water table", "0"]);
    let shape = (names, prop::collection::vec(corner, 4..12), any::<bool>());
    let shape = shape.prop_map(|(layer, corners, closed)| Shape {
        layer: layer.to_owned(),
        corners,
        outline: if closed { Outline::Closed } else { Outline::Open },
    });
    prop::collection::vec(shape, 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_format_gives_back_what_was_written(shapes in shapes()) {
        let drawing = Drawing { shapes, ..Drawing::default() };
        for format in FORMATS {
            let text = drawing.to_text(format).unwrap();
            let mut back = Drawing::from_bytes(text.as_bytes(), format, &Reading::default()).unwrap();
            prop_assert!(back.left_out.is_empty());
            // A table does not tell lines from areas, except that areas return; DXF has areas first, then lines by layers, and may walk them backwards.
            let is_open = |shape: &Shape| shape.outline != Outline::Closed;
            let order = |shape: &Shape| (is_open(shape), shape.layer.clone());
            let mut wanted = drawing.shapes.clone();
            wanted.sort_by_key(order);
            back.shapes.sort_by_key(order);
            prop_assert_eq!(back.shapes.len(), wanted.len());
            for (found, wanted) in back.shapes.iter().zip(&wanted) {
                prop_assert_eq!(&found.layer, &wanted.layer);
                prop_assert_eq!(is_open(found), is_open(wanted));
                let mut turned = found.corners.clone();
                turned.reverse();
                prop_assert!(found.corners == wanted.corners || turned == wanted.corners);
            }
            prop_assert_eq!(&drawing.to_text(format).unwrap(), &text);
        }
    }
}

#[test]
fn mutants_of_every_format_are_read_or_refused() {
    let shape = |layer: &str, outline| Shape {
        layer: layer.into(),
        corners: vec![[0.0, 0.0], [10.0, 0.0], [10.0, -5.0], [0.0, -5.0]],
        outline,
    };
    let shapes = vec![shape("sand", Outline::Closed), shape("water", Outline::Open)];
    let drawing = Drawing { shapes, ..Drawing::default() };
    let mut random = Random(29);
    for format in FORMATS {
        let text = drawing.to_text(format).unwrap();
        for _ in 0..25 * count() {
            let mutant = random.mutant(text.as_bytes());
            if let Ok(read) = Drawing::from_bytes(&mutant, format, &Reading::default()) {
                assert!(read.shapes.iter().flat_map(|s| &s.corners).flatten().all(|x| x.is_finite()));
            }
        }
    }
}

#[test]
fn geojson_of_others_is_read_by_its_properties() {
    let text = r#"{"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"soil": "clay", "id": 7},
         "geometry": {"type": "MultiPolygon", "coordinates": [[[[0, 0, 5], [4, 0], [4, -2], [0, 0]]], [[[5, 0], [6, 0], [6, -1]]]]}},
        {"type": "Feature", "properties": {"name": "hollow"},
         "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 0]], [[1, 1], [2, 1], [2, 2], [1, 1]]]}},
        {"type": "Feature", "properties": null, "geometry": {"type": "Point", "coordinates": [1, 2]}},
        {"type": "Feature", "properties": {"layer": "gwl"}, "geometry": {"type": "LineString", "coordinates": [[0, -1], [9, -1.5]]}}]}"#;
    let found = Drawing::from_bytes(text.as_bytes(), Format::GeoJson, &Reading::default()).unwrap();
    let layers: Vec<_> =
        found.shapes.iter().map(|s| (s.layer.as_str(), s.corners.len(), s.outline)).collect();
    let wanted = [("clay", 3, Outline::Closed), ("clay", 3, Outline::Closed), ("gwl", 2, Outline::Open)];
    assert_eq!(layers, wanted);
    let left: Vec<_> = found.left_out.keys().map(|it| (it.layer.as_str(), it.what.as_str())).collect();
    assert_eq!(left, [("0", "Point"), ("hollow", "Polygon")]);
}
