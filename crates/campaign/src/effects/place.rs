//! Where the strokes of a plan lie to each other, as effects want to know it.

use soilctl_controller::StrokeSpec;
use soilctl_soil::units::inches_to_m;

use crate::Plan;

/// The place of a stroke in its campaign.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Place {
    pub(super) radius_m: f64,
    /// Radius from 12 in (0) to 17 in (1).
    pub(super) radius_position: f64,
    pub(super) base_deg: f64,
    /// From the least (-1) to the greatest (1) base angle of the campaign.
    pub(super) base_position: f64,
    /// From the plate's place to that of the nearest earlier stroke in this preparation, edge to edge, in m.
    pub(super) gap_prior_m: Option<f64>,
    /// From the first (0) to the last (1) stroke of the campaign.
    pub(super) time_fraction: f64,
    /// Set-point of the interface friction angle.
    pub(super) delta_set_deg: f64,
    /// Number in its preparation, from 1.
    pub(super) order: f64,
}

/// The places of all strokes.
pub(super) fn places(plan: &Plan) -> Vec<Place> {
    let strokes = plan.strokes().strokes();
    let width_m = plan.plant().arm().config().plate.width_m;
    let base = |stroke: &StrokeSpec| stroke.base_rad.to_degrees();
    let low = strokes.iter().map(base).fold(f64::INFINITY, f64::min);
    let high = strokes.iter().map(base).fold(f64::NEG_INFINITY, f64::max);
    let (near, far) = (inches_to_m(12.0), inches_to_m(17.0));
    let last = strokes.len().saturating_sub(1).max(1);
    strokes
        .iter()
        .enumerate()
        .map(|(i, stroke)| Place {
            radius_m: stroke.radius_m,
            delta_set_deg: stroke.delta_rad.to_degrees(),
            #[allow(clippy::cast_precision_loss, reason = "at most 1024 strokes")]
            order: 1.0 + strokes[..i].iter().filter(|earlier| earlier.batch == stroke.batch).count() as f64,
            radius_position: (stroke.radius_m - near) / (far - near),
            base_deg: base(stroke),
            base_position: if high > low { 2.0 * (base(stroke) - low) / (high - low) - 1.0 } else { 0.0 },
            gap_prior_m: strokes[..i]
                .iter()
                .filter(|earlier| earlier.batch == stroke.batch)
                .map(|earlier| gap_m(edge(stroke, width_m), edge(earlier, width_m)))
                .min_by(f64::total_cmp),
            #[allow(clippy::cast_precision_loss, reason = "at most 1024 strokes")]
            time_fraction: i as f64 / last as f64,
        })
        .collect()
}

type Point = [f64; 2];

/// Both ends of the plate's edge, seen from above.
fn edge(stroke: &StrokeSpec, width_m: f64) -> [Point; 2] {
    let (sin, cos) = libm::sincos(stroke.base_rad);
    [0.5, -0.5].map(|side| {
        [stroke.radius_m * cos - side * width_m * sin, stroke.radius_m * sin + side * width_m * cos]
    })
}

/// Distance of two segments; those that cross touch.
fn gap_m([a, b]: [Point; 2], [c, d]: [Point; 2]) -> f64 {
    let turn = |p: Point, q: Point, r: Point| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0 {
        return 0.0;
    }
    [to_segment(a, [c, d]), to_segment(b, [c, d]), to_segment(c, [a, b]), to_segment(d, [a, b])]
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

fn to_segment(point: Point, [a, b]: [Point; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [point[0] - a[0], point[1] - a[1]]);
    let squared = along[0] * along[0] + along[1] * along[1];
    let share = if squared > 0.0 { (to[0] * along[0] + to[1] * along[1]) / squared } else { 0.0 };
    let share = share.clamp(0.0, 1.0);
    libm::hypot(to[0] - share * along[0], to[1] - share * along[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps() {
        let unit = [[0.0, 0.0], [1.0, 0.0]];
        assert!((gap_m(unit, [[0.0, 2.0], [1.0, 2.0]]) - 2.0).abs() < 1e-12);
        assert!((gap_m(unit, [[4.0, 4.0], [4.0, 9.0]]) - 5.0).abs() < 1e-12);
        assert!(gap_m(unit, [[0.5, -1.0], [0.5, 1.0]]) == 0.0);
    }

    /// Strokes at one radius overlap like chords: the gap of plates that are 25 deg apart at 17 in is what is left between
    /// their ends.
    #[test]
    fn the_first_stroke_has_no_neighbour() {
        let plan = include_str!("../../../../data/plans/table_6_2.toml");
        let plan = Plan::from_toml(plan, "plan", std::path::Path::new("")).unwrap();
        let places = places(&plan);
        for (i, place) in places.iter().enumerate() {
            assert_eq!(place.gap_prior_m.is_none(), i % 6 == 0, "{i}");
        }
        // Ends at (r cos b -+ w/2 sin b, r sin b +- w/2 cos b); the nearest pair by hand.
        let (r, w, b) = (0.4318_f64, 0.127_f64, 25.0_f64.to_radians());
        let ends = libm::hypot(
            r * libm::cos(b) + 0.5 * w * libm::sin(b) - r,
            r * libm::sin(b) - 0.5 * w * libm::cos(b) - 0.5 * w,
        );
        assert!((places[1].gap_prior_m.unwrap() - ends).abs() < 1e-9, "{places:?} {ends}");
    }
}
