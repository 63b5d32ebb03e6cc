//! What fades with the distance to something: an earlier stroke, a wall.

use crate::{Acting, Conditions, EffectsError, Parameter, Range, Shape};

/// Relative change of the force at no distance.
pub(super) const AMPLITUDE: Parameter = Parameter { name: "amplitude", unit: "1" };

/// Plausible amplitudes.
pub(super) const RANGE: Range = Range::either(0.06, 0.5);

/// Decay length in m.
pub(super) const DECAY: Shape = Shape {
    parameter: Some(Parameter { name: "decay_m", unit: "m" }),
    values: &[0.02, 0.035, 0.06, 0.1, 0.15],
};

/// Changes the force by `amplitude exp(-distance / decay)`; nothing if the distance was not measured.
pub(super) fn fade(
    acting: &Acting<'_>,
    distance_m: Option<f64>,
    conditions: &mut Conditions,
) -> Result<(), EffectsError> {
    if let Some(distance_m) = distance_m {
        conditions.scale(acting.amplitude * libm::exp(-distance_m / acting.shape));
    }
    Ok(())
}
