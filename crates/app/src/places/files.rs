//! Places and cells as files.

use serde_json::{Value, json};

use super::answer::{Answer, Cell};
use crate::AppError;

/// The ellipsoid of WGS 84: half its greater axis in m, and the square of its eccentricity.
const AXIS_M: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 6.694_379_990_14e-3;
/// Farther from the origin the plane of x and y leaves the ellipsoid by more than a decimetre in the plane.
const FARTHEST_M: f64 = 1000.0;

/// From x and y in m to the coordinates that are written.
struct Coordinates {
    /// Longitude and latitude in deg, and degrees of each for a metre.
    geographic: Option<([f64; 2], [f64; 2])>,
}

impl Coordinates {
    fn of(origin: Option<[f64; 2]>) -> Self {
        let geographic = origin.map(|[lat, lon]| {
            let (sin, cos) = (libm::sin(lat.to_radians()), libm::cos(lat.to_radians()));
            let root = libm::sqrt(1.0 - ECCENTRICITY_SQUARED * sin * sin);
            let meridian_m = AXIS_M * (1.0 - ECCENTRICITY_SQUARED) / (root * root * root);
            let parallel_m = AXIS_M / root * cos;
            ([lon, lat], [parallel_m, meridian_m].map(|radius_m| radius_m.recip().to_degrees()))
        });
        Self { geographic }
    }

    fn at(&self, x_m: f64, y_m: f64) -> Result<[f64; 2], AppError> {
        let Some((origin, degrees)) = self.geographic else { return Ok([x_m, y_m]) };
        if x_m.abs().max(y_m.abs()) > FARTHEST_M {
            return Err(AppError::Request(format!(
                "a place is at ({x_m}, {y_m}) m; geographic coordinates are given within {FARTHEST_M} m of --origin-deg, so choose a nearer origin"
            )));
        }
        Ok([origin[0] + x_m * degrees[0], origin[1] + y_m * degrees[1]])
    }
}

/// Places, cells and next places as features. With an origin, coordinates are longitude and latitude (RFC 7946); without one, x and y in m,
/// which the member `coordinates_are` tells.
pub(super) fn geojson(answer: &Answer, origin: Option<[f64; 2]>) -> Result<String, AppError> {
    let coordinates = Coordinates::of(origin);
    let mut features = Vec::new();
    for place in &answer.places {
        let (Some(x), Some(y)) = (place.x_m, place.y_m) else { continue };
        let about = json!({
            "kind": "place", "name": place.name, "x_m": x, "y_m": y, "strokes": place.strokes, "consistent": place.consistent,
            "phi_deg": place.phi_deg, "density_kg_m3": place.density_kg_m3, "group": place.group,
        });
        features.push(feature(json!({"type": "Point", "coordinates": coordinates.at(x, y)?}), about));
    }
    if let Some(between) = &answer.between {
        for cell in &between.cells {
            features.push(feature(square(&coordinates, cell, 0.5 * between.cell_m)?, with_kind(cell)?));
        }
        for (order, [x, y]) in between.next_places.iter().enumerate() {
            let about = json!({"kind": "next-place", "order": order + 1, "x_m": x, "y_m": y});
            features.push(feature(json!({"type": "Point", "coordinates": coordinates.at(*x, *y)?}), about));
        }
    }
    let are = if origin.is_some() {
        "longitude and latitude in degrees, WGS 84"
    } else {
        "x and y in metres, not geographic"
    };
    let all = json!({"type": "FeatureCollection", "coordinates_are": are, "features": features});
    Ok(serde_json::to_string(&all)? + "\n")
}

fn feature(geometry: Value, properties: Value) -> Value {
    json!({"type": "Feature", "geometry": geometry, "properties": properties})
}

fn with_kind(cell: &Cell) -> Result<Value, AppError> {
    let mut about = serde_json::to_value(cell)?;
    if let Some(keys) = about.as_object_mut() {
        keys.insert("kind".into(), "cell".into());
    }
    Ok(about)
}

/// A cell, counter-clockwise and closed.
fn square(coordinates: &Coordinates, cell: &Cell, half_m: f64) -> Result<Value, AppError> {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let ring = corners.map(|(x, y)| coordinates.at(cell.x_m + x * half_m, cell.y_m + y * half_m));
    let ring = ring.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(json!({"type": "Polygon", "coordinates": [ring]}))
}

/// Cells as a table.
pub(super) fn cells(answer: &Answer) -> Result<String, AppError> {
    let Some(between) = &answer.between else {
        let why = answer.warnings.last().cloned().unwrap_or_default();
        return Err(AppError::Request(format!("there are no cells for --cells: {why}")));
    };
    let mut text = String::from(
        "x_m,y_m,phi_low_deg,phi_high_deg,phi_sd_deg,density_low_kg_m3,density_high_kg_m3,density_sd_kg_m3,inside\n",
    );
    for cell in &between.cells {
        let ([a, b], [c, d]) = (cell.phi_deg, cell.density_kg_m3);
        text += &format!(
            "{},{},{a},{b},{},{c},{d},{},{}\n",
            cell.x_m, cell.y_m, cell.phi_sd_deg, cell.density_sd_kg_m3, cell.inside
        );
    }
    Ok(text)
}
