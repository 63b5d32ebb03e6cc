//! A table of corners.

use serde::Deserialize;

use crate::{Drawing, DrawingError, Outline, Reading, Shape, Unit};

#[derive(Debug, Deserialize)]
struct Row {
    layer: String,
    #[serde(default)]
    part: String,
    x_m: f64,
    y_m: f64,
}

/// Rows of one layer and part that follow each other are one shape. Whether it is an area the table does not say, unless its first corner stands at the end
/// once more.
pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Drawing, DrawingError> {
    let metres = reading.unit.map_or(1.0, Unit::metres);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(bytes);
    let mut shapes: Vec<(String, Shape)> = Vec::new();
    for (i, row) in reader.deserialize().enumerate() {
        let malformed = |error: csv::Error| DrawingError::Malformed {
            line: error.position().and_then(|at| usize::try_from(at.line()).ok()).unwrap_or(i + 2),
            reason: format!("{error}; columns are layer, x_m, y_m and, if wanted, part"),
        };
        let Row { layer, part, x_m, y_m } = row.map_err(malformed)?;
        let corner = [metres * x_m, metres * y_m];
        match shapes.last_mut() {
            Some((last, shape)) if *last == part && shape.layer == layer => shape.corners.push(corner),
            _ => shapes.push((part, Shape { layer, corners: vec![corner], outline: Outline::Unsaid })),
        }
    }
    let mut shapes: Vec<Shape> = shapes.into_iter().map(|(_, shape)| shape).collect();
    for shape in &mut shapes {
        if shape.corners.len() > 3 && shape.corners.first() == shape.corners.last() {
            shape.corners.pop();
            shape.outline = Outline::Closed;
        }
    }
    Ok(Drawing { shapes, unit: Some(reading.unit.unwrap_or(Unit::Metre)), ..Drawing::default() })
}

/// The table of shapes; areas end with their first corner.
pub(crate) fn write(shapes: &[Shape]) -> Result<String, DrawingError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |error: &dyn std::fmt::Display| DrawingError::Kind(error.to_string());
    writer.write_record(["layer", "part", "x_m", "y_m"]).map_err(|e| failed(&e))?;
    for (i, shape) in shapes.iter().enumerate() {
        let again = shape.corners.iter().take(usize::from(shape.outline == Outline::Closed));
        for [x, y] in shape.corners.iter().chain(again) {
            let record = [shape.layer.clone(), (i + 1).to_string(), format!("{x:?}"), format!("{y:?}")];
            writer.write_record(&record).map_err(|e| failed(&e))?;
        }
    }
    let bytes = writer.into_inner().map_err(|e| failed(&e))?;
    String::from_utf8(bytes).map_err(|e| failed(&e))
}
