//! The material of each piece of soil, in the units of the statement.

use soilctl_certificate::{Anisotropy, LineUse, Linear, Material};

use super::columns::overburden;
use super::error::DescriptionError;
use super::faces::Face;
use super::input::{AnisotropyEntry, Description, SoilEntry};
use super::plan::Plan;
use super::segments::Drawing;
use crate::vector::Point;

/// Where the statement's origin is and what one unit of length and stress stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    pub(super) origin: Point,
    pub(super) length_m: f64,
    pub(super) stress_kpa: f64,
}

impl Units {
    pub(super) fn place(&self, p: Point) -> Point {
        [0, 1].map(|i| (p[i] - self.origin[i]) / self.length_m)
    }

    pub(super) fn stress(&self, kpa: f64) -> f64 {
        kpa / self.stress_kpa
    }

    /// A quantity in kPa that is `value` at a place and grows by `slope` kPa/m.
    fn linear(&self, at: Point, value: f64, slope: [f64; 2]) -> Linear {
        let gradient = slope.map(|s| self.stress(s * self.length_m));
        let to = [0, 1].map(|i| if slope[i] == 0.0 { 0.0 } else { slope[i] * (self.origin[i] - at[i]) });
        Linear { at_origin: self.stress(value + to[0] + to[1]), gradient }
    }
}

/// Rounding that is forgiven where strength should be zero, in units of stress.
const ROUNDING: f64 = 1e-12;

/// The material of a face.
pub(super) fn material(
    description: &Description,
    plan: &Plan,
    face: &Face,
    units: &Units,
) -> Result<Material, DescriptionError> {
    let soil = &description.soils[description.soil_of(face.region)].after_davis();
    let ring = |ring: &Vec<LineUse>| ring.iter().map(|w| plan.map.walked_points(*w)[0]).collect();
    let loops: Vec<Vec<Point>> = face.loops.iter().map(ring).collect();
    let corners = loops.concat();
    let level = [0.0, soil.cohesion_level_m.unwrap_or(0.0)];
    let mut cohesion = units.linear(level, soil.cohesion_kpa, [0.0, -soil.cohesion_gradient_kpa_per_m]);
    let (mut phi_deg, mut envelope) = (soil.phi_deg.unwrap_or(0.0), None);
    if let Some(lines) = soil.lines(description.expected_kpa()) {
        if let Some(first) = lines.inside.first() {
            (phi_deg, cohesion) = (first.phi_deg, Linear::uniform(units.stress(first.cohesion)));
        }
        envelope = lines.envelope(|kpa| units.stress(kpa));
    }
    let least = corners.iter().map(|p| cohesion.at(units.place(*p))).fold(f64::INFINITY, f64::min);
    if least < -ROUNDING {
        let kpa = least * units.stress_kpa;
        let problem =
            format!("its cohesion is {kpa:.3} kPa at one of its corners; cut the region where it is zero");
        return Err(DescriptionError::entry(description.region_title(face.region), problem));
    }
    if least < 0.0 {
        cohesion.at_origin -= 2.0 * least;
    }
    Ok(Material {
        phi_deg,
        cohesion,
        unit_weight: units.stress(soil.unit_weight_kn_m3 * units.length_m),
        pore_pressure: match plan.pores {
            Some(pores) => pores.within(&loops).map_or_else(Linear::default, |plane| {
                let pressure = units.linear(plane.at, plane.kpa, plane.gradient);
                not_above_zero_at_surfaces(pressure, soil, &corners, units)
            }),
            None => pore_pressure(description, &plan.drawing, face, &corners, units),
        },
        tension: soil.tension_kpa.map(|t| units.stress(t)),
        envelope,
        anisotropy: soil.anisotropy.map(|AnisotropyEntry { passive, shear }| Anisotropy { passive, shear }),
    })
}

/// The pore pressure less its rounding, if the soil has no cohesion: where it should be zero at a bare surface, such soil would not bear it.
fn not_above_zero_at_surfaces(
    pressure: Linear,
    soil: &SoilEntry,
    corners: &[Point],
    units: &Units,
) -> Linear {
    let Linear { at_origin, gradient } = pressure;
    let is_exact = at_origin == 0.0 && gradient[0] == 0.0;
    if is_exact || !soil.is_cohesionless() {
        return pressure;
    }
    let terms = corners
        .iter()
        .map(|p| units.place(*p))
        .map(|[x, y]| (gradient[0] * x).abs() + (gradient[1] * y).abs());
    let largest = at_origin.abs() + terms.fold(0.0, f64::max);
    Linear { at_origin: at_origin - 8.0 * f64::EPSILON * largest, gradient }
}

fn pore_pressure(
    description: &Description,
    drawing: &Drawing,
    face: &Face,
    corners: &[Point],
    units: &Units,
) -> Linear {
    let low = corners.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let high = corners.iter().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
    let middle = 0.5 * (low + high);
    let soil = &description.soils[description.soil_of(face.region)];
    if let (true, Some(water), Some((at, slope))) =
        (face.submerged, &description.water, drawing.table_line(middle))
    {
        let weight = water.unit_weight_kn_m3;
        let pressure = units.linear(at, 0.0, [weight * slope, -weight]);
        return not_above_zero_at_surfaces(pressure, soil, corners, units);
    }
    if soil.pore_pressure_ratio == 0.0 {
        return Linear::default();
    }
    // Cuts through all corners make the overburden linear; any level below the face will do.
    let y = corners.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let [left, right] = [low + 0.25 * (high - low), low + 0.75 * (high - low)];
    // Soil below the face must not count: its own weight goes on instead.
    let weight = soil.unit_weight_kn_m3;
    let above = |x: f64| {
        let own =
            corners_at(drawing, face.region, x, 0.5 * (y + corners.iter().map(|p| p[1]).fold(y, f64::max)));
        own.map_or(0.0, |at| overburden(description, drawing, [x, at]) - weight * (y - at))
    };
    let [a, b] = [above(left), above(right)];
    let slope = if a == b { 0.0 } else { (b - a) / (right - left) };
    let ratio = soil.pore_pressure_ratio;
    let mut pressure = units.linear([left, y], ratio * a, [ratio * slope, -ratio * weight]);
    if pressure.at_origin.abs() < ROUNDING {
        // At a surface at the datum it is zero.
        pressure.at_origin = 0.0;
    }
    not_above_zero_at_surfaces(pressure, soil, corners, units)
}

/// A height at which the vertical at `x` is inside a region: the one nearest to `y` in the middle of a crossing.
fn corners_at(drawing: &Drawing, region: usize, x: f64, y: f64) -> Option<f64> {
    let polygon = &drawing.regions[region];
    let mut heights: Vec<f64> = polygon
        .last()
        .into_iter()
        .chain(polygon)
        .zip(polygon)
        .filter(|(a, b)| (a[0] > x) != (b[0] > x))
        .map(|(a, b)| a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]))
        .collect();
    heights.sort_by(f64::total_cmp);
    let middles = heights.chunks_exact(2).map(|c| 0.5 * (c[0] + c[1]));
    middles.min_by(|a, b| (a - y).abs().total_cmp(&(b - y).abs()))
}
