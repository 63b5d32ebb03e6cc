use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The reading depends on the base angle. The amplitude is its relative change over the range of base angles: from
/// one end to the other (odd shapes), or from the middle to the ends (even shapes).
///
/// Base angles count from the box, so in a box that was turned they go beyond what an arm reaches. Nobody knows how the change goes
/// on there: as it began (shapes 1, 2), not at all (3, 4), or, if it is the arm's own angle that counts, from the start with each
/// quarter turn of the box (5, 6). Without a turn these are the same; with one, the range is that of the arm.
pub(super) struct BaseAngleDependence;

/// Range of base angles in deg beyond which the box must have been turned, and half of what an arm reaches in one place.
const TURNED: f64 = 100.0;
const REACH: f64 = 45.0;

fn position(shape: f64, stroke: &Stroke, reference: &Reference) -> Option<f64> {
    let turned = reference.base_deg.is_some_and(|(low, high)| high - low > TURNED);
    let base_deg = stroke.base_deg.filter(|_| turned && shape > 2.5);
    Some(match base_deg {
        None => stroke.base_position?,
        Some(base_deg) if shape < 4.5 => (base_deg / REACH).clamp(-1.0, 1.0),
        Some(base_deg) => (base_deg - 90.0 * (base_deg / 90.0).round()) / REACH,
    })
}

impl Effect for BaseAngleDependence {
    fn id(&self) -> &'static str {
        "base_angle_dependence"
    }

    fn title(&self) -> &'static str {
        "the reading depends on the base angle"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "base_rel", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.03, 0.35)
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0] })
    }

    fn apply(
        &self,
        amplitude: f64,
        shape: f64,
        stroke: &Stroke,
        reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        let x = position(shape, stroke, reference).unwrap_or(0.0);
        let odd = shape.rem_euclid(2.0) > 0.5;
        let pattern = if odd { 0.5 * x } else { x * x };
        c.ln_factor += (amplitude * pattern).max(-0.99).ln_1p();
        Ok(())
    }
}
