//! Figure 5-6 as curves: where the force points, for errors all around.

use soilctl_figure::{Axis, Dash, DataPoint, Figure, Line};

use crate::error::CliError;

const BLACK: usize = 6;

/// Angle from error to force against the direction of the error, both in degrees.
pub(super) struct Curves {
    pub(super) radius_m: f64,
    pub(super) pid: Vec<DataPoint>,
    pub(super) stiffness: Vec<DataPoint>,
}

pub(super) fn skewing(curves: &[Curves]) -> Result<Figure, CliError> {
    let most = curves.iter().flat_map(|one| &one.pid).map(|(_, deg)| deg.abs()).fold(10.0, f64::max);
    let most = (most / 10.0).ceil() * 10.0;
    let mut figure = Figure::new(
        "Skewing: where the tip's force points",
        Axis::linear("Direction of the error (deg; 0 outwards, 90 up)").range(0.0, 360.0)?,
        Axis::linear("From the error to the force (deg)").range(-most, most)?,
    );
    for (color, one) in curves.iter().enumerate() {
        figure
            .push(Line::new(format!("joint PID, r = {:.3} m", one.radius_m), one.pid.clone()).color(color))?;
    }
    // One beside the other they cannot be told apart.
    for (nth, one) in curves.iter().enumerate() {
        let name = if nth == 0 { "Cartesian stiffness" } else { "" };
        figure.push(Line::new(name, one.stiffness.clone()).color(BLACK).dash(Dash::Solid))?;
    }
    Ok(figure)
}
