//! Flows of soil without friction, by a stream function.

use super::power::Power;
use super::resistance::Resistance;
use super::{Piece, VelocityField};
use crate::element::Local;
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::tiling::after;

impl VelocityField<'_> {
    /// What a triangle adds to the power. The flow does not change the volume, by construction.
    ///
    /// The rates are `exx = -eyy = s_xy` and `exy = (s_yy - s_xx)/2`, linear in each part of the element. In terms of the
    /// stresses that would belong to the function, `exx - eyy` is `-2 xy` and `2 exy` is `xx - yy`.
    pub(super) fn stream(&self, triangle: usize, copies: [usize; 3]) -> Power {
        let (local, rigid) = self.local(triangle, copies);
        let [p, q, r] = local.corners;
        let centroid = Vector { x: (p.x + q.x + r.x).third(), y: (p.y + q.y + r.y).third() };
        let area = self.tiling.double_area(triangle).half();
        let strength = &self.problem.strengths[self.tiling.region(triangle)];
        let mut dissipation = Interval::ZERO;
        for (k, nodes) in local.stresses().into_iter().enumerate() {
            let rates = nodes.map(|s| strength.shear_rate(Interval::point(-2.0) * s.xy, s.xx - s.yy));
            let points = [local.corners[after(k, 1)], local.corners[after(k, 2)], centroid];
            let part = Resistance::new(strength, points).of_triangle([Interval::ZERO; 3], rates).all();
            dissipation = dissipation + part * area.third();
        }
        Power::dissipated(dissipation) + self.body(triangle, rigid * area + self.integral(triangle, &local))
    }

    /// The velocity in the three parts of the element.
    pub(super) fn stream_pieces(&self, triangle: usize, copies: [usize; 3]) -> Vec<Piece> {
        let (local, rigid) = self.local(triangle, copies);
        let [p, q, r] = local.corners;
        let centroid = Vector { x: (p.x + q.x + r.x).third(), y: (p.y + q.y + r.y).third() };
        let slopes = local.part_slopes().into_iter().enumerate();
        let piece = |(k, slopes): (usize, [Vector; 6])| {
            let corners = [local.corners[after(k, 1)], local.corners[after(k, 2)], centroid];
            (corners, slopes.map(|slope| rigid - slope.turned()))
        };
        slopes.map(piece).collect()
    }

    /// The local values of the element less the affine function that touches it at corner 0, and the velocity that goes
    /// with that: what is left is small, and so is its rounding.
    fn local(&self, triangle: usize, copies: [usize; 3]) -> (Local, Vector) {
        let corners = self.tiling.corners(triangle);
        let jets = copies.map(|copy| self.stream[copy]);
        let less = |k: usize| {
            if copies[k] == copies[0] {
                return (Interval::ZERO, Vector::ZERO);
            }
            let slopes = jets[k].slopes - jets[0].slopes;
            (jets[k].value - jets[0].value - jets[0].slopes.dot(corners[k] - corners[0]), slopes)
        };
        let edges = self.edges(triangle);
        let across = [0, 1, 2].map(|k| {
            let side = Side { triangle, corner: k };
            self.slope(side) - jets[0].slopes.dot(edges[k].turned())
        });
        let f = [0, 1, 2].map(|k| less(k).0);
        let slopes = [0, 1, 2].map(|k| less(k).1);
        (Local { corners, apex: [false; 3], f, slopes, across }, jets[0].velocity())
    }

    /// The integral of the velocity. With Gauss it is the sum, over the edges, of the function's mean times the edge vector,
    /// with the sign changed; the mean of a cubic follows from values and slopes at the ends.
    fn integral(&self, triangle: usize, local: &Local) -> Vector {
        let edges = self.edges(triangle);
        (0..3).fold(Vector::ZERO, |sum, k| {
            let (a, b) = (after(k, 1), after(k, 2));
            let slope = (local.slopes[a] - local.slopes[b]).dot(edges[k]);
            let mean = (local.f[a] + local.f[b]).half() + slope / Interval::point(12.0);
            sum - edges[k] * mean
        })
    }
}
