//! The plate that stands for a tool from above: a front that all of tool and side plates lie behind, with the soil between as a plug.
//!
//! The tool moves along the level with the velocity V, in soil without cohesion. Let B be all points from which some point of tool or side plates lies behind
//! within the angle phi of the direction of the motion, as far as a plane, the front: the union of cones that widen along the motion, cut off by it. All of
//! it moves with V.
//!
//! - The surface of a union of such cones rises by no more than the tangent of phi across the motion for one along it, so soil that stays at rest separates from B at
//!   the angle phi or more: the flow rule holds there, and nothing dissipates. Where the tool itself is in that surface, it holds too, since no piece is
//!   rougher than the soil. Below a bottom that is flatter than phi, B reaches deeper than the tool; beside side plates, and beside the tool's own ends, it is
//!   wider. (Soil at rest right below a rough bottom, or beside a rough side plate, would be no mechanism: there it would slide without opening.)
//! - Its velocity is level, so its weight has no power.
//! - The front is a rectangle as wide as B is there at most, from the surface down to the deepest point of B there. Where it goes beyond B the soil just behind it is at
//!   rest, and what moves ahead of it jumps by V and by what blocks move against a plate as rough as soil. Both jumps obey the flow rule of soil if the
//!   front has a tool angle between phi and 180 degrees less phi, and so does their sum.
//!
//! So the blocks ahead of a plate with this front, as rough as the soil, with soil at rest behind it, are a mechanism for the tool as well, and the power of
//! their weight bounds its force. That holds for every tool angle of the front.

use crate::tool::shape::Point;

/// A front that a tool lies behind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Front {
    pub(super) alpha_deg: f64,
    /// Vertical depth of its lower edge.
    pub(super) depth_m: f64,
    pub(super) width_m: f64,
}

/// By how much a front is larger than it has to be, relative to the tool: far more than rounding, far less than matters.
const SLACK: f64 = 1e-9;

impl Front {
    /// The front of this tool angle that touches points of a tool and its side plates, below a level surface at zero; none unless its tool angle is above phi and
    /// below 180 degrees less phi.
    pub(super) fn new(points: &[Point], phi_deg: f64, alpha_deg: f64, width_m: f64) -> Option<Self> {
        if !(alpha_deg > phi_deg && alpha_deg < 180.0 - phi_deg) {
            return None;
        }
        let (sin, cos) = alpha_deg.to_radians().sin_cos();
        let tan = phi_deg.to_radians().tan();
        let out = |p: &Point| p[0] * sin + p[1] * cos;
        let touching = points.iter().map(out).fold(f64::NEG_INFINITY, f64::max);
        let size = points.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        // From a point, along the motion to the front; from there its cone goes on down along the front, and sideways.
        let ahead = |p: &Point| (touching - out(p)) / sin;
        let down = tan / (1.0 - tan * cos / sin);
        let aside = tan * sin / (sin * sin - (tan * cos).powi(2)).sqrt();
        let depth = points.iter().map(|p| down * ahead(p) - p[1]).fold(0.0, f64::max);
        let reach = aside * points.iter().map(ahead).fold(0.0, f64::max);
        let slack = SLACK * (size + width_m);
        let front = Self { alpha_deg, depth_m: depth + slack, width_m: width_m + 2.0 * reach + 2.0 * slack };
        (front.depth_m.is_finite() && front.width_m.is_finite()).then_some(front)
    }

    /// Slant length.
    pub(super) fn length_m(&self) -> f64 {
        self.depth_m / self.alpha_deg.to_radians().sin()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The cone behind which a point is, walked: whether the direction from the point to the other is within phi of the motion.
    fn in_cone(from: [f64; 3], to: [f64; 3], phi_deg: f64) -> bool {
        let [x, y, z] = [0, 1, 2].map(|k| to[k] - from[k]);
        x > 0.0 && y.hypot(z) <= x * phi_deg.to_radians().tan()
    }

    #[test]
    fn a_flat_tool_is_its_own_front() {
        let front =
            Front::new(&[[0.3, -0.4], [0.0, 0.0]], 35.0, 0.4f64.atan2(0.3).to_degrees(), 2.0).unwrap();
        assert!((front.depth_m - 0.4).abs() < 1e-8 && (front.width_m - 2.0).abs() < 1e-8);
        assert!((front.length_m() - 0.5).abs() < 1e-8);
    }

    #[test]
    fn below_a_level_bottom_it_goes_down_at_the_friction_angle() {
        let bucket = [[0.06, -0.1], [0.0, -0.1], [0.0, 0.0]];
        let front = Front::new(&bucket, 30.0, 90.0, 1.0).unwrap();
        let reach = 0.06 * 30f64.to_radians().tan();
        assert!((front.depth_m - 0.1 - reach).abs() < 1e-8);
        assert!((front.width_m - 1.0 - 2.0 * reach).abs() < 1e-8);
    }

    #[test]
    fn flat_fronts_are_none() {
        let plate = [[0.0, -1.0], [0.0, 0.0]];
        assert_eq!(Front::new(&plate, 35.0, 35.0, 1.0), None);
        assert_eq!(Front::new(&plate, 35.0, 145.0, 1.0), None);
    }

    proptest! {
        /// Whatever of the front's plane is in the cone of a point of the tool is in the rectangle.
        #[test]
        fn the_rectangle_covers_all_cones(
            points in prop::collection::vec(prop::array::uniform2(-1.0..0.0_f64), 2..6), phi in 5.0..50.0_f64, part in 0.02..0.98_f64,
            at in prop::array::uniform2(-3.0..3.0_f64), one in 0_usize..6, end in 0.0..1.0_f64,
        ) {
            let alpha = phi + part * (180.0 - 2.0 * phi);
            let front = Front::new(&points, phi, alpha, 1.0).unwrap();
            let (sin, cos) = alpha.to_radians().sin_cos();
            let touching = points.iter().map(|p| p[0] * sin + p[1] * cos).fold(f64::NEG_INFINITY, f64::max);
            // A place on the plane, by its depth and its distance from the middle.
            let [down, aside] = at;
            let place = [(touching + down * cos) / sin, aside, -down];
            let p = points[one % points.len()];
            let from = [p[0], end * 0.5, p[1]];
            prop_assume!(down >= 0.0);
            if in_cone(from, place, phi) {
                prop_assert!(down <= front.depth_m && aside.abs() <= 0.5 * front.width_m, "{front:?} {place:?}");
            }
        }
    }
}
