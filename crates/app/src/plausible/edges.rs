//! Loads that end beside free ground: what the ground bears there may be less than what the whole problem is about.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, BoundaryEntry, Kind, Profile, Side, SoilEntry};

use super::file::size;
use crate::text::number;

type Point = [f64; 2];

/// Pressure at an edge over what the soil bears there from which on it is told.
const NEAR: f64 = 0.5;
/// How far beyond an edge is looked, and what is on a line, over the size of the ground.
const BEYOND: f64 = 1e-4;
const ON_LINE: f64 = 1e-9;

/// An even load beside free level ground bears down on it with `c N_c` at most (Prandtl), however far it reaches: at its edge the weight
/// of the soil does not help. With live loads that is what is asked for.
pub(super) fn notes(d: &Description) -> Vec<Option<String>> {
    let ground = size(d.regions.iter().flat_map(|r| &r.polygon));
    let is_on_top = |b: &BoundaryEntry| b.sides.contains(&Side::Top) && b.kind != Kind::Free;
    if d.objective != (Aim::StrengthReduction {})
        || d.surcharge_kpa > 0.0
        || d.boundaries.iter().any(is_on_top)
    {
        return Vec::new();
    }
    let mut all = Vec::new();
    for (i, load) in d.boundaries.iter().enumerate().filter(|(_, b)| b.kind == Kind::Load && b.line.len() > 1)
    {
        let [first, last] = load.pressure_kpa.map_or([0.0; 2], Profile::ends);
        let line = &load.line;
        let ends = [(line[0], line[1], first), (line[line.len() - 1], line[line.len() - 2], last)];
        all.extend(ends.into_iter().map(|(end, before, pressure)| {
            let soil = beside(d, end, before, ground)?;
            let factor = bearing(soil.friction_deg());
            let bears = soil.cohesion_kpa * factor;
            (pressure > NEAR * bears).then(|| {
                format!(
                    "boundary {}: its load of {} kPa ends at ({}, {}) beside free ground, which bears {} kPa there, {:.1} times its cohesion: \
                     the factor of safety is no more than that of this edge; let the load grow from zero, or reach to a wall or a side",
                    i + 1,
                    number(pressure),
                    number(end[0]),
                    number(end[1]),
                    number(round(bears)),
                    factor
                )
            })
        }));
    }
    all
}

/// The soil of free level ground beyond the end of a line.
fn beside(d: &Description, end: Point, before: Point, ground: f64) -> Option<&SoilEntry> {
    let level = (end[1] - before[1]).abs() <= ON_LINE * ground;
    let beyond = [end[0] + BEYOND * ground * (end[0] - before[0]).signum(), end[1]];
    let near = ON_LINE * ground;
    let holds = |line: &[Point]| line.windows(2).any(|ends| distance(beyond, [ends[0], ends[1]]) <= near);
    let ring = |polygon: &[Point]| holds(&[polygon, &polygon[..polygon.len().min(1)]].concat());
    let is_held = d.boundaries.iter().any(|b| b.kind != Kind::Free && holds(&b.line))
        || d.structures.iter().any(|s| ring(&s.polygon) || holds(&s.edge));
    let mut regions = d.regions.iter().filter(|region| ring(&region.polygon));
    let (region, other) = (regions.next()?, regions.next());
    let soil = d.soils.iter().find(|soil| soil.name == region.soil)?;
    let is_plain = soil.cohesion_gradient_kpa_per_m == 0.0 && soil.strength.is_none();
    (level && !is_held && other.is_none() && is_plain).then_some(soil)
}

fn distance(p: Point, [a, b]: [Point; 2]) -> f64 {
    let (d, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let square = d[0] * d[0] + d[1] * d[1];
    let s = if square > 0.0 { ((from[0] * d[0] + from[1] * d[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
    (from[0] - s * d[0]).hypot(from[1] - s * d[1])
}

/// N_c.
fn bearing(phi_deg: f64) -> f64 {
    let phi = phi_deg.to_radians();
    if phi < 1e-6 {
        return 2.0 + std::f64::consts::PI;
    }
    let passive = (std::f64::consts::FRAC_PI_4 + 0.5 * phi).tan().powi(2);
    (passive * (std::f64::consts::PI * phi.tan()).exp() - 1.0) / phi.tan()
}

/// Four digits.
fn round(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
