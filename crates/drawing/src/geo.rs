//! GeoJSON with plane coordinates in metres.

use std::str::FromStr;

use geojson::{Feature, FeatureCollection, GeoJson, Geometry, GeometryValue, JsonObject, Position};

use crate::{Drawing, DrawingError, Outline, Point, Reading, Shape, Unit, Why};

/// Properties that may name a layer, best first.
const NAMES: [&str; 3] = ["layer", "soil", "name"];
/// Geometries in geometries, at most.
const DEEPEST: usize = 16;

pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Drawing, DrawingError> {
    let refused = |why: String| DrawingError::Kind(format!("{why}; is it GeoJSON?"));
    let text = std::str::from_utf8(bytes).map_err(|error| refused(error.to_string()))?;
    let found = GeoJson::from_str(text).map_err(|error| refused(error.to_string()))?;
    let unit = reading.unit.unwrap_or(Unit::Metre);
    let mut drawing = Drawing { unit: Some(unit), ..Drawing::default() };
    let features = match found {
        GeoJson::FeatureCollection(FeatureCollection { features, .. }) => features,
        GeoJson::Feature(feature) => vec![feature],
        GeoJson::Geometry(geometry) => vec![Feature::from(geometry)],
    };
    for feature in features {
        let layer = layer(&feature);
        match &feature.geometry {
            Some(geometry) => add(&mut drawing, &layer, geometry, unit.metres(), 0),
            None => drawing.leave_out(&layer, "Feature", Why::other("it has no geometry")),
        }
    }
    Ok(drawing)
}

fn layer(feature: &Feature) -> String {
    let text = |name: &&str| feature.property(name)?.as_str().map(str::to_owned);
    NAMES.iter().find_map(text).unwrap_or_else(|| "0".into())
}

fn add(drawing: &mut Drawing, layer: &str, geometry: &Geometry, metres: f64, depth: usize) {
    let points = |line: &[Position]| -> Option<Vec<Point>> {
        line.iter().map(|p| Some([metres * p.as_slice().first()?, metres * p.as_slice().get(1)?])).collect()
    };
    let mut shape = |line: &[Position], outline: Outline| match points(line) {
        None => drawing.leave_out(
            layer,
            geometry.value.type_name(),
            Why::shape("a position must have two numbers"),
        ),
        Some(mut corners) => {
            if outline == Outline::Closed && corners.len() > 1 && corners.first() == corners.last() {
                corners.pop();
            }
            drawing.shapes.push(Shape { layer: layer.to_owned(), corners, outline });
        }
    };
    let hole =
        Why::shape("it has a hole; draw what is in the hole, and the soil around it as areas without holes");
    let polygons: &[_] = match &geometry.value {
        GeometryValue::Polygon { coordinates } => std::slice::from_ref(coordinates),
        GeometryValue::MultiPolygon { coordinates } => coordinates,
        GeometryValue::LineString { coordinates } => return shape(coordinates, Outline::Open),
        GeometryValue::MultiLineString { coordinates } => {
            return coordinates.iter().for_each(|line| shape(line, Outline::Open));
        }
        GeometryValue::GeometryCollection { geometries } if depth < DEEPEST => {
            return geometries.iter().for_each(|one| add(drawing, layer, one, metres, depth + 1));
        }
        GeometryValue::Point { .. }
        | GeometryValue::MultiPoint { .. }
        | GeometryValue::GeometryCollection { .. } => {
            return drawing.leave_out(
                layer,
                geometry.value.type_name(),
                Why::other("it is neither an area nor a line"),
            );
        }
    };
    for polygon in polygons {
        match &polygon[..] {
            [ring] => shape(ring, Outline::Closed),
            [] => {}
            _ => return drawing.leave_out(layer, geometry.value.type_name(), hole),
        }
    }
}

pub(crate) fn write(shapes: &[Shape]) -> Result<String, DrawingError> {
    let feature = |shape: &Shape| {
        let ring = shape.outline == Outline::Closed;
        let again = shape.corners.iter().take(usize::from(ring));
        let line: Vec<Point> = shape.corners.iter().chain(again).copied().collect();
        let value =
            if ring { GeometryValue::new_polygon([line]) } else { GeometryValue::new_line_string(line) };
        let mut properties = JsonObject::new();
        properties.insert("layer".into(), shape.layer.clone().into());
        Feature { properties: Some(properties), ..Feature::from(Geometry::new(value)) }
    };
    let features = shapes.iter().map(feature).collect();
    let collection = FeatureCollection { bbox: None, features, foreign_members: None };
    let text = serde_json::to_string_pretty(&collection);
    Ok(text.map_err(|error| DrawingError::Kind(error.to_string()))? + "\n")
}
