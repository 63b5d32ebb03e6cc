//! Figures of the arm.

use soilctl_app::arm::skewing::{Row, Skewing};
use soilctl_figure::{Axis, Dash, DataPoint, Figure, Line};

use crate::PageError;

const BLACK: usize = 6;

/// Where the force points, for errors all around (Hong 2001, figure 5-6).
///
/// # Errors
/// [`PageError`] if a curve cannot be drawn.
pub fn skewing(found: &Skewing) -> Result<Figure, PageError> {
    let most = found.around.iter().flatten().map(|row| row.pid_deg.abs()).fold(10.0, f64::max);
    let most = (most / 10.0).ceil() * 10.0;
    let mut figure = Figure::new(
        "Skewing: where the tip's force points",
        Axis::linear("Direction of the error (deg; 0 outwards, 90 up)").range(0.0, 360.0)?,
        Axis::linear("From the error to the force (deg)").range(-most, most)?,
    );
    let curve = |circle: &[Row], value: fn(&Row) -> f64| -> Vec<DataPoint> {
        circle.iter().map(|row| (row.error_deg, value(row))).collect()
    };
    for (color, circle) in found.around.iter().enumerate() {
        let radius_m = circle.first().map_or(0.0, |row| row.radius_m);
        let points = curve(circle, |row| row.pid_deg);
        figure.push(Line::new(format!("joint PID, r = {radius_m:.3} m"), points).color(color))?;
    }
    // One beside the other they cannot be told apart.
    for (nth, circle) in found.around.iter().enumerate() {
        let name = if nth == 0 { "Cartesian stiffness" } else { "" };
        let points = curve(circle, |row| row.stiffness_deg);
        figure.push(Line::new(name, points).color(BLACK).dash(Dash::Solid))?;
    }
    Ok(figure)
}
