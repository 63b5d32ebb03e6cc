//! Stresses and velocities along a line through a solution.

use serde::Serialize;
use soilctl_app::limits::Fields;
use soilctl_limit_analysis::results::Principal;

/// So many places on a line, in the middles of equal parts.
const PARTS: u32 = 400;

/// What is found along a line. Stresses are total ones, compression positive.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Shown {
    length_m: f64,
    /// How much of the line is in no soil.
    outside_m: f64,
    /// The sum of the stresses across the line, and of those along it, in kN/m; none where no stresses are known.
    normal_kn_per_m: Option<f64>,
    shear_kn_per_m: Option<f64>,
    places: Vec<Place>,
}

/// What is found at a place.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Place {
    /// Distance from the line's beginning.
    at_m: f64,
    point_m: [f64; 2],
    stress: Option<Stress>,
    /// Velocity over that of what moves fastest.
    velocity: Option<[f64; 2]>,
}

/// The stress at a place, by the field that proves the lower bound.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Stress {
    /// Across the line.
    normal_kpa: f64,
    /// Along the line: positive where the soil on the left of its direction pushes that on the right forwards.
    shear_kpa: f64,
    /// The greater and the lesser compression, and the direction of the greater one from the horizontal.
    major_kpa: f64,
    minor_kpa: f64,
    major_deg: f64,
}

/// Along a line of a section in m.
///
/// # Errors
/// Words, if the line has no length or is nowhere in the soil.
pub(crate) fn shown(fields: &Fields, from: [f64; 2], to: [f64; 2]) -> Result<Shown, String> {
    let along = [to[0] - from[0], to[1] - from[1]];
    let length_m = along[0].hypot(along[1]);
    if !(length_m > 0.0 && length_m.is_finite()) {
        return Err("a section line needs two points that differ".to_owned());
    }
    let units = &fields.units;
    let (t, n) = ([along[0] / length_m, along[1] / length_m], [-along[1] / length_m, along[0] / length_m]);
    let top = fields.flow.as_ref().map(|flow| {
        let all = flow.corner_velocities();
        all.iter().flatten().map(|[x, y]| x.hypot(*y)).fold(flow.speed(), f64::max)
    });
    let place = |k: u32| {
        let part = (f64::from(k) + 0.5) / f64::from(PARTS);
        let point_m = [0, 1].map(|axis| part.mul_add(along[axis], from[axis]));
        let own = [0, 1].map(|axis| (point_m[axis] - units.origin[axis]) / units.length);
        let stress = fields.stress.as_ref().and_then(|field| field.stress(own)).map(|[xx, yy, xy]| {
            let of =
                |a: [f64; 2], b: [f64; 2]| a[0] * (xx * b[0] + xy * b[1]) + a[1] * (xy * b[0] + yy * b[1]);
            let principal = Principal::of([xx, yy, xy]);
            Stress {
                normal_kpa: -units.stress * of(n, n),
                shear_kpa: units.stress * of(t, n),
                major_kpa: units.stress * principal.major,
                minor_kpa: units.stress * principal.minor,
                major_deg: principal.direction[1].atan2(principal.direction[0]).to_degrees(),
            }
        });
        let velocity = fields.flow.as_ref().and_then(|flow| flow.velocity(own)).zip(top);
        let velocity = velocity.filter(|(_, top)| *top > 0.0).map(|([x, y], top)| [x / top, y / top]);
        Place { at_m: part * length_m, point_m, stress, velocity }
    };
    let places: Vec<Place> = (0..PARTS).map(place).collect();
    let step_m = length_m / f64::from(PARTS);
    let is_outside = |place: &&Place| place.stress.is_none() && place.velocity.is_none();
    let outside_m = step_m * places.iter().filter(is_outside).count() as f64;
    if places.iter().all(|place| is_outside(&place)) {
        return Err("the line is nowhere in the soil".to_owned());
    }
    let stresses = || places.iter().filter_map(|place| place.stress.as_ref());
    let is_known = stresses().next().is_some();
    let sum = |of: fn(&Stress) -> f64| is_known.then(|| step_m * stresses().map(of).sum::<f64>());
    let (normal_kn_per_m, shear_kn_per_m) = (sum(|s| s.normal_kpa), sum(|s| s.shear_kpa));
    Ok(Shown { length_m, outside_m, normal_kn_per_m, shear_kn_per_m, places })
}
