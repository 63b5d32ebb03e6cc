use soilctl_soil::Angle;

use crate::{Case, EarthPressureError, ForceModel};

/// The input that a sensitivity varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// Tool angle alpha.
    ToolAngle,
    /// Surface slope beta.
    SurfaceSlope,
    /// Soil friction phi.
    Friction,
    /// Interface friction delta.
    Interface,
}

/// Change of the slant-normalised net coefficient, in per cent of `base`, when one input grows by `step` and
/// the others stay (Hong 2001, Table 4.3).
///
/// # Errors
/// As [`ForceModel::predict`], at either end of the step.
pub fn sensitivity_percent(
    model: &dyn ForceModel,
    base: &Case,
    input: Input,
    step: Angle,
) -> Result<f64, EarthPressureError> {
    let mut moved = *base;
    let angle = match input {
        Input::ToolAngle => &mut moved.tool_angle,
        Input::SurfaceSlope => &mut moved.surface_slope,
        Input::Friction => &mut moved.friction,
        Input::Interface => &mut moved.interface,
    };
    *angle = *angle + step;
    let before = model.predict(base)?.k_net().0;
    let after = model.predict(&moved)?.k_net().0;
    Ok(100.0 * (after / before - 1.0))
}
