//! What fades with the distance to something: an earlier stroke, a wall.

use crate::{Conditions, Parameter, Range, Shape};

/// Relative change of the force at no distance.
pub(super) const AMPLITUDE: Parameter = Parameter { name: "amplitude", unit: "1" };

/// Plausible amplitudes.
pub(super) fn range() -> Range {
    Range::either(0.06, 0.5)
}

/// Decay length in m.
pub(super) const DECAY: Shape = Shape {
    parameter: Some(Parameter { name: "decay_m", unit: "m" }),
    values: &[0.02, 0.035, 0.06, 0.1, 0.15],
};

/// Changes the force by `amplitude exp(-distance / decay)`; nothing if the distance was not measured.
pub(super) fn fade(amplitude: f64, decay_m: f64, distance_m: Option<f64>, conditions: &mut Conditions) {
    if let Some(distance_m) = distance_m {
        conditions.ln_factor += (amplitude * (-distance_m / decay_m).exp()).max(-0.99).ln_1p();
    }
}
