use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The reading depends on the base angle. The amplitude is its relative change over the range of base angles: from
/// one end to the other (odd shapes), or from the middle to the ends (even shapes).
///
/// Base angles count from the box, so in a box that was turned they go beyond what an arm reaches. Nobody knows how the change goes
/// on there: as it began (shapes 1, 2), not at all (3, 4), or, if it is the arm's own angle that counts, from the start with each
/// turn of the box (5, 6). Without a turn these are the same; with one, the range is that of the arm.
pub(super) struct BaseAngleDependence;

/// By how much a box is turned, in deg: a wider range of base angles is that of no arm.
const TURN: f64 = 180.0;

/// Position of a base angle between the ends of the arm's range, which are -1 and 1.
fn position(shape: f64, stroke: &Stroke, reference: &Reference) -> Option<f64> {
    let range = reference.base_deg.map(|(low, high)| high - low).filter(|range| *range > TURN);
    let Some((base_deg, range)) = stroke.base_deg.zip(range) else { return stroke.base_position };
    // To either side of 0, before and after the turn.
    let reach = 0.5 * (range - TURN);
    Some(match shape {
        ..2.5 => base_deg / reach,
        2.5..4.5 => (base_deg / reach).clamp(-1.0, 1.0),
        _ => (base_deg - TURN * (base_deg / TURN).round()) / reach,
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
        // Beyond the ends nothing grows with the square.
        let pattern = if odd { 0.5 * x } else { x.abs().min(x * x) };
        c.ln_factor += (amplitude * pattern).max(-0.99).ln_1p();
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use soilctl_strokes::StrokeRow;

    use super::*;

    fn positions(base_deg: &[f64], shape: f64) -> Vec<f64> {
        let row = |base_deg: &f64| StrokeRow { base_deg: Some(*base_deg), ..StrokeRow::default() };
        let rows: Vec<StrokeRow> = base_deg.iter().map(row).collect();
        let Some(reference) = Reference::of(&rows) else { return Vec::new() };
        rows.iter().filter_map(|row| position(shape, &Stroke::new(row, &reference), &reference)).collect()
    }

    #[test]
    fn without_a_turn_all_continuations_are_the_same() {
        for shape in [1.0, 3.0, 5.0] {
            assert_eq!(positions(&[-30.0, 0.0, 15.0, 30.0], shape), [-1.0, 0.0, 0.5, 1.0]);
            // Nor is an arm that reaches far a turned box: the amplitude is that from one end to the other.
            assert_eq!(positions(&[-80.0, 0.0, 40.0, 80.0], shape), [-1.0, 0.0, 0.5, 1.0]);
        }
    }

    #[test]
    fn beyond_a_turn_the_change_goes_on_stays_or_repeats() {
        let turned = [-30.0, 0.0, 30.0, 150.0, 180.0, 210.0];
        assert_eq!(positions(&turned, 1.0), [-1.0, 0.0, 1.0, 5.0, 6.0, 7.0]);
        assert_eq!(positions(&turned, 3.0), [-1.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
        assert_eq!(positions(&turned, 5.0), [-1.0, 0.0, 1.0, -1.0, 0.0, 1.0]);
    }
}
