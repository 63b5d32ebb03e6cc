//! The first mesh: fans where stresses are singular, and a guess of where the soil slips.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use soilctl_certificate::{Boundary, Condition};

use crate::mesh::{Fan, Guide};
use crate::mobile::MobileZone;
use crate::problem::Problem;
use crate::singular::{singular_points, typical_length};
use crate::slide::{Slide, slides};
use crate::vector::distance;

/// Size of the first triangles at the end of a beam over its length, at most.
const OF_BEAM: f64 = 0.1;

/// Radius of the first fans in units of length, and how much each level's are smaller.
const FAN: f64 = 0.05;
const SHRINK: f64 = 0.8;

/// Sector angle of the fans.
const SECTOR_DEG: f64 = 15.0;

/// The same for lower bounds at points on the rim that are no tips. There stresses hardly vary along the rays of a fan,
/// but much with their angle; flows do both, and want small fans.
const LOWER_FAN: f64 = 0.4;
const LOWER_SECTOR_DEG: f64 = 7.5;
const LOWER_SECTOR_SHRINK: f64 = 0.9;

/// Clearance of the mobile zone below the slip lines in units of the depth; how it shrinks; and its least value.
const MARGIN: f64 = 0.8;
const MARGIN_SHRINK: f64 = 0.8;
const LEAST_MARGIN: f64 = 0.1;

/// How much flatter than it could possibly be the first slip line leaves the tip, in radians.
const CLEARANCE: f64 = 0.2;

/// Direction of the face that leads from a tip to the surface, as an angle from the direction of motion, and its
/// interface friction in radians.
fn face_above(problem: &Problem, tip: [f64; 2], ahead: f64) -> Option<(f64, f64)> {
    problem.statement().boundaries.iter().find_map(|b| {
        let Condition::Face { delta_deg, .. } = b.condition else { return None };
        let [p, q] = problem.ends(b.line);
        let other = if p == tip {
            q
        } else if q == tip {
            p
        } else {
            return None;
        };
        let angle = (other[1] - tip[1]).atan2(ahead * (other[0] - tip[0]));
        Some((angle, delta_deg.to_radians()))
    })
}

/// A line from the tip to the surface that starts at one angle to the direction of motion and bends towards another.
///
/// Soil ahead of the plate slides up its face at `delta` and along the slip line at `phi`, or faster outwards: the line
/// must leave the tip flatter than the plate by both angles, or nothing could move.
fn slip_line(
    tip: [f64; 2],
    depth: f64,
    [from, to]: [f64; 2],
    phi: f64,
    ahead: f64,
    datum: f64,
) -> Vec<[f64; 2]> {
    let step = 0.05 * depth;
    let (mut points, mut angle) = (vec![tip], from);
    let mut here = tip;
    while here[1] < datum && points.len() < 2000 {
        here = [here[0] + ahead * step * angle.cos(), here[1] + step * angle.sin()];
        points.push(here);
        // A logarithmic spiral: its radius grows by sin(phi) of the way.
        let radius = depth + step * points.len() as f64 * phi.sin();
        angle = (angle + step * phi.cos() / radius).min(to);
    }
    points
}

/// Where a structure ends inside the soil, and where else stresses are singular.
#[derive(Debug, Clone)]
pub(crate) struct Start {
    /// Points of the outline with fans.
    points: Vec<usize>,
    /// How many of them, the first ones, are tips.
    tip_points: usize,
    /// Where slip lines may be led to.
    pub(crate) tips: Vec<[f64; 2]>,
    pub(crate) guides: Vec<Guide>,
    /// Planes on which slopes may slide.
    pub(crate) slides: Vec<Slide>,
    /// About these triangles are small: so small at the place itself, at most.
    corners: Vec<([f64; 2], f64)>,
    /// The mobile zone where there are no slip lines around tips.
    sides: MobileZone,
    has_tips: bool,
    /// A typical length.
    unit: f64,
    /// Greatest depth of a tip.
    depth: f64,
    /// Greatest friction angle in radians.
    phi: f64,
    datum: f64,
    /// No element is larger.
    pub(crate) largest: f64,
}

/// Where beams start and end, and how long they are.
fn beam_ends(problem: &Problem) -> impl Iterator<Item = ([f64; 2], f64)> {
    let beams = (0..problem.members().len()).filter(|member| problem.bends(*member));
    beams.flat_map(|beam| {
        let [a, b] = problem.member_ends(beam);
        [a, b].map(|end| (end, distance(a, b)))
    })
}

impl Start {
    pub(crate) fn new(problem: &Problem) -> Self {
        let statement = problem.statement();
        let touching = |point: usize| {
            statement.boundaries.iter().filter(move |b| statement.lines[b.line].touches(point))
        };
        let is_face = |b: &Boundary| matches!(b.condition, Condition::Face { .. });
        let on_face: Vec<usize> = (0..statement.points.len()).filter(|p| touching(*p).any(is_face)).collect();
        // Where faces end in the soil, or at soil that is held: there it must tear.
        let tears = |b: &Boundary| is_face(b) || matches!(b.condition, Condition::Fixed | Condition::Far);
        let mut points: Vec<usize> = on_face.iter().copied().filter(|p| touching(*p).all(tears)).collect();
        let at = |p: &usize| statement.points[*p];
        let mut tips: Vec<[f64; 2]> = points.iter().map(at).collect();
        let ahead = problem.velocity()[0].signum();
        let mut guides = Vec::new();
        for tip in points.iter().map(at) {
            let depth = statement.datum - tip[1];
            let phi = statement.regions[0].material.phi_deg.to_radians();
            let flat = FRAC_PI_4 - phi / 2.0;
            let face = face_above(problem, tip, ahead);
            let steepest = face.map_or(flat, |(u, delta)| u - delta - phi - CLEARANCE);
            let slip = slip_line(tip, depth, [flat.min(steepest), flat], phi, ahead, statement.datum);
            guides.push(Guide { points: slip });
            // The soil that follows from behind. Ahead of a face that leans forward its line would cut a wedge off that is
            // too narrow to move.
            if face.is_none_or(|(u, _)| u < FRAC_PI_2 + flat) {
                guides.push(Guide {
                    points: vec![tip, [tip[0] - ahead * depth * flat.tan(), statement.datum]],
                });
            }
        }
        let phi = problem.soils.iter().map(|s| s.flow_tan().atan()).fold(0.0, f64::max);
        let sides = MobileZone::between_sides(problem, phi);
        let has_tips = !tips.is_empty() && phi > 0.0;
        if !has_tips {
            guides.clear();
        }
        let mut corners = on_face;
        let singular = singular_points(problem);
        corners.extend(singular.iter().filter(|p| !touching(**p).any(is_face)));
        let tip_points = points.len();
        points.extend(singular.iter().filter(|p| !tips.contains(&at(p))));
        if tips.is_empty() {
            tips = points.iter().map(at).collect();
        }
        let heights = || statement.points.iter().map(|p| p[1]);
        let low = heights().fold(f64::INFINITY, f64::min);
        let high = heights().fold(statement.datum, f64::max);
        Self {
            slides: slides(problem),
            sides,
            has_tips,
            unit: typical_length(problem),
            depth: tips.iter().map(|t| statement.datum - t[1]).fold(0.0, f64::max),
            points,
            tip_points,
            tips,
            guides,
            phi,
            datum: statement.datum,
            // About the ends of beams triangles are small too, but no fans are needed.
            corners: corners
                .iter()
                .map(|corner| (at(corner), f64::INFINITY))
                .chain(beam_ends(problem).map(|(end, length)| (end, OF_BEAM * length)))
                .collect(),
            largest: 0.4 * (high - low),
        }
    }

    pub(crate) fn fans(&self, level: usize) -> Vec<Fan> {
        let radius = self.unit * FAN * SHRINK.powi(level as i32);
        self.points.iter().map(|&point| Fan { point, radius, angle: SECTOR_DEG.to_radians() }).collect()
    }

    /// Fans of the mesh of a level's lower bound; none if it is that of the upper bound.
    pub(crate) fn lower_fans(&self, level: usize) -> Option<Vec<Fan>> {
        if self.points.len() == self.tip_points {
            return None;
        }
        let mut fans = self.fans(level);
        for fan in &mut fans[self.tip_points..] {
            fan.radius *= LOWER_FAN / FAN;
            fan.angle = (LOWER_SECTOR_DEG * LOWER_SECTOR_SHRINK.powi(level as i32)).to_radians();
        }
        Some(fans)
    }

    /// The soil that may move on a level's mesh, around its slip lines.
    pub(crate) fn mobile(&self, level: usize, guides: &[Guide]) -> MobileZone {
        if !self.has_tips || guides.is_empty() {
            return self.sides.clone();
        }
        let margin = self.depth * (MARGIN * MARGIN_SHRINK.powi(level as i32)).max(LEAST_MARGIN);
        MobileZone::around(guides, margin, self.phi, self.datum).held_below(&self.sides, &self.tips)
    }

    /// Wanted edge length on the first mesh.
    pub(crate) fn size(&self, p: [f64; 2]) -> f64 {
        let beside =
            |(corner, least): &([f64; 2], f64)| least.min(0.1 * self.unit) + 0.3 * distance(p, *corner);
        self.corners.iter().map(beside).fold(self.largest, f64::min)
    }
}
