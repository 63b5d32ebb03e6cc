//! Regions of soils in forms that others read: GeoJSON, a table, HTML, SVG.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use soilctl_estimator::Region;

/// A MultiPolygon; x is the friction angle in degrees, y the density in kg/m3.
pub(crate) fn geojson<'py>(py: Python<'py>, region: &Region) -> PyResult<Bound<'py, PyDict>> {
    let polygons = PyList::empty(py);
    for polygon in region.polygons() {
        let rings = PyList::empty(py);
        for ring in polygon {
            // GeoJSON repeats the first point.
            let closed: Vec<(f64, f64)> = ring.iter().chain(ring.first()).map(|&[x, y]| (x, y)).collect();
            rings.append(closed)?;
        }
        polygons.append(rings)?;
    }
    let dict = PyDict::new(py);
    dict.set_item("type", "MultiPolygon")?;
    dict.set_item("coordinates", polygons)?;
    Ok(dict)
}

/// A pandas DataFrame with a row for each corner of the boundary.
pub(crate) fn boundary_table<'py>(py: Python<'py>, region: &Region) -> PyResult<Bound<'py, PyAny>> {
    let (mut polygons, mut rings) = (Vec::new(), Vec::new());
    let (mut angles, mut densities) = (Vec::new(), Vec::new());
    for (i, polygon) in region.polygons().iter().enumerate() {
        for (k, ring) in polygon.iter().enumerate() {
            for &[angle, density] in ring {
                polygons.push(i);
                rings.push(k);
                angles.push(angle);
                densities.push(density);
            }
        }
    }
    let columns = PyDict::new(py);
    columns.set_item("polygon", polygons)?;
    columns.set_item("ring", rings)?;
    columns.set_item("friction_angle_deg", angles)?;
    columns.set_item("density_kg_m3", densities)?;
    py.import("pandas")?.call_method1("DataFrame", (columns,))
}

/// The ranges and the region itself; notebooks show this rather than the SVG alone.
pub(crate) fn html(region: &Region) -> String {
    let (Some(([a, b], [c, d])), Some(svg)) = (region.bounds(), svg(region)) else {
        return "<p>No soil is consistent with all measurements.</p>".to_owned();
    };
    format!(
        "<table><caption>consistent soils</caption><tr><th>friction angle</th><td>{a:.2} to {b:.2} deg</td></tr>\
         <tr><th>density</th><td>{c:.0} to {d:.0} kg/m³</td></tr></table>{svg}"
    )
}

/// None if there is no soil to draw.
pub(crate) fn svg(region: &Region) -> Option<String> {
    let ([x_low, x_high], [y_low, y_high]) = region.bounds()?;
    let (x_scale, y_scale) = (360.0 / (x_high - x_low).max(1e-9), 240.0 / (y_high - y_low).max(1e-9));
    let point = |&[x, y]: &[f64; 2]| {
        format!("{:.2},{:.2}", 60.0 + x_scale * (x - x_low), 20.0 + y_scale * (y_high - y))
    };
    let rings = region.polygons().iter().flatten();
    let path: String =
        rings.map(|ring| format!("M{}Z", ring.iter().map(point).collect::<Vec<_>>().join("L"))).collect();
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 440 300\" width=\"440\" font-size=\"11\">\
         <path d=\"{path}\" fill=\"#9ec9e8\" stroke=\"#1f5f8b\" fill-rule=\"evenodd\"/>\
         <text x=\"60\" y=\"276\">{x_low:.2}</text><text x=\"420\" y=\"276\" text-anchor=\"end\">{x_high:.2}</text>\
         <text x=\"240\" y=\"292\" text-anchor=\"middle\">friction angle in degrees</text>\
         <text x=\"54\" y=\"28\" text-anchor=\"end\">{y_high:.0}</text>\
         <text x=\"54\" y=\"260\" text-anchor=\"end\">{y_low:.0}</text>\
         <text x=\"14\" y=\"140\" transform=\"rotate(-90 14 140)\" text-anchor=\"middle\">density in kg/m³</text></svg>"
    ))
}
