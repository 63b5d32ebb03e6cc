use super::EffectId;
use crate::{Covariate, Effect, Parameter, Range, Reference, Shape, Site, SoilSite, Stroke};

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

/// The reading depends on the base angle: `F' = F (1 + a p)`, with the pattern `p = x / 2` (odd shapes) or `p = min(|x|, x^2)` (even
/// shapes) over the base angle x, from -1 to 1 between the ends of the arm's range. The amplitude is the relative change from one
/// end to the other, or from the middle to the ends.
///
/// Base angles count from the box, so in a box that was turned they go beyond what an arm reaches. Nobody knows how the change goes
/// on there: as it began (shapes 1, 2), not at all (3, 4), or, if it is the arm's own angle that counts, from the start with each
/// turn of the box (5, 6). Without a turn these are the same; with one, the range is that of the arm. Whether the place in the box
/// or the arm makes it is open, so it is simulated as a strength of the soil.
///
/// Source: own; the lowest odd and the lowest even pattern.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0] }),
    varies_with: Some(Covariate::BaseAngle),
    apply: |a, c| {
        let x = position(a.shape, a.stroke, a.reference).unwrap_or(0.0);
        let odd = a.shape.rem_euclid(2.0) > 0.5;
        // Beyond the ends nothing grows with the square.
        c.scale(a.amplitude * if odd { 0.5 * x } else { x.abs().min(x * x) });
        Ok(())
    },
    ..Effect::new(
        EffectId::BaseAngleDependence,
        Site::Soil(SoilSite::Strength),
        Parameter { name: "base_rel", unit: "1" },
        Range::either(0.03, 0.35),
    )
};

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
