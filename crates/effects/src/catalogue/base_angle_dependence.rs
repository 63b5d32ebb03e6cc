use super::Effect;
use crate::{Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// The reading depends on the base angle. The amplitude is its relative change over the range of base angles: from
/// one end to the other (odd shapes), or from the middle to the ends (even shapes).
///
/// Base angles count from the box, so in a box that was turned they go beyond what an arm reaches. Nobody knows how the change goes
/// on there: as it began (shapes 1, 2), not at all (3, 4), or, if it is the arm's own angle that counts, from the start with each
/// quarter turn of the box (5, 6). Without a turn these are the same; with one, the range is that of the arm.
pub(super) struct BaseAngleDependence;

/// Range of base angles in deg beyond which the box must have been turned, and by how much.
const TURNED: f64 = 100.0;
const TURN: f64 = 90.0;

fn position(shape: f64, stroke: &Stroke, reference: &Reference) -> Option<f64> {
    let range =
        reference.base_deg.map(|(low, high)| high - low).filter(|range| *range > TURNED && shape > 2.5);
    Some(match stroke.base_deg.zip(range) {
        None => stroke.base_position?,
        Some((base_deg, range)) => {
            // To either side of 0, before and after the turn.
            let reach = 0.5 * (range - TURN).min(TURN);
            if shape < 4.5 {
                (base_deg / reach).clamp(-1.0, 1.0)
            } else {
                (base_deg - TURN * (base_deg / TURN).round()) / reach
            }
        }
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
        }
    }

    #[test]
    fn beyond_a_turn_the_change_goes_on_stays_or_repeats() {
        let turned = [-30.0, 0.0, 30.0, 60.0, 90.0, 120.0];
        assert_eq!(positions(&turned, 3.0), [-1.0, 0.0, 1.0, 1.0, 1.0, 1.0]);
        assert_eq!(positions(&turned, 5.0), [-1.0, 0.0, 1.0, -1.0, 0.0, 1.0]);
        let on = positions(&turned, 1.0);
        assert!(on.windows(2).all(|pair| (pair[1] - pair[0] - 0.4).abs() < 1e-12), "{on:?}");
    }
}
