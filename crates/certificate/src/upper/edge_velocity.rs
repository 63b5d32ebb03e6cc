//! Velocities along an edge.

use super::VelocityField;
use crate::fields::Flow;
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::tiling::{Beyond, after};

/// A velocity, quadratic along an edge, in parts along the edge vector and along that turned left, both times the edge's
/// length: Bernstein coefficients at the start, in the middle, at the end. As a relative velocity of the soil on the left
/// these are slip and opening.
#[derive(Debug, Clone, Copy)]
pub(super) struct EdgeVelocity {
    pub(super) slip: [Interval; 3],
    pub(super) opening: [Interval; 3],
}

impl EdgeVelocity {
    /// From the velocities at the control points.
    pub(super) fn new(along: Vector, velocities: [Vector; 3]) -> Self {
        Self { slip: velocities.map(|v| v.dot(along)), opening: velocities.map(|v| v.dot(along.turned())) }
    }

    /// The same, seen from the other side.
    pub(super) fn reversed(self) -> Self {
        let turned = |[a, b, c]: [Interval; 3]| [-c, -b, -a];
        Self { slip: turned(self.slip), opening: turned(self.opening) }
    }

    /// Relative to another one along the same edge.
    pub(super) fn less(self, other: Self) -> Self {
        let less = |a: [Interval; 3], b: [Interval; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
        Self { slip: less(self.slip, other.slip), opening: less(self.opening, other.opening) }
    }
}

impl VelocityField<'_> {
    /// The edge of a triangle as a vector.
    pub(super) fn along(&self, side: Side) -> Vector {
        self.edges(side.triangle)[side.corner]
    }

    /// Positions of the start and the end of an edge.
    pub(super) fn ends(&self, side: Side) -> [Vector; 2] {
        let corners = self.tiling.corners(side.triangle);
        [1, 2].map(|i| corners[after(side.corner, i)])
    }

    /// Control points of a quadratic flow on an edge: at its start, in the middle, at its end.
    pub(super) fn on_edge(nodes: [usize; 6], side: Side) -> [usize; 3] {
        [nodes[after(side.corner, 1)], nodes[3 + side.corner], nodes[after(side.corner, 2)]]
    }

    /// Velocity of a triangle along an edge.
    pub(super) fn slide(&self, side: Side) -> EdgeVelocity {
        match self.field.flows[side.triangle] {
            Flow::Quadratic(nodes) => EdgeVelocity::new(
                self.along(side),
                Self::on_edge(nodes, side).map(|node| self.velocities[node]),
            ),
            Flow::Stream { corners, .. } => self.slide_of_stream(side, corners),
        }
    }

    /// Velocity on the left of an edge relative to that on the right.
    pub(super) fn jump(&self, side: Side, other: Side) -> EdgeVelocity {
        let [here, there] = [side, other].map(|s| self.field.flows[s.triangle]);
        let (Flow::Quadratic(here), Flow::Quadratic(there)) = (here, there) else {
            return self.slide(side).less(self.slide(other).reversed());
        };
        let (here, [end, middle, start]) = (Self::on_edge(here, side), Self::on_edge(there, other));
        let there = [start, middle, end];
        EdgeVelocity::new(self.along(side), [0, 1, 2].map(|i| self.difference(here[i], there[i])))
    }

    /// With `d` the edge vector and `n` that turned left, `v . d = grad s . n` and `v . n = -grad s . d`. The second is the
    /// derivative of a cubic along the edge with its sign changed, so its coefficients follow from values and slopes at
    /// the ends.
    fn slide_of_stream(&self, side: Side, corners: [usize; 3]) -> EdgeVelocity {
        let [a, b] = [1, 2].map(|i| self.stream[corners[after(side.corner, i)]]);
        let (d, two, three) = (self.along(side), Interval::point(2.0), Interval::point(3.0));
        let [over_a, over_b] = [a, b].map(|jet| jet.slopes.dot(d.turned()));
        let middle = two * self.slope(side) - (over_a + over_b).half();
        let [to_b, from_a] = [b, a].map(|jet| jet.slopes.dot(d));
        let flow = (to_b + from_a) - three * (b.value - a.value);
        EdgeVelocity { slip: [over_a, middle, over_b], opening: [-from_a, flow, -to_b] }
    }

    /// The slope of a stream function across the middle of an edge, along the edge vector turned left.
    pub(super) fn slope(&self, side: Side) -> Interval {
        let stored = |side: Side| match self.field.flows[side.triangle] {
            Flow::Stream { slopes, .. } => Interval::point(slopes[side.corner]),
            Flow::Quadratic(_) => Interval::ZERO,
        };
        match self.tiling.beyond(side) {
            Beyond::Soil(other) if other < side && self.is_glued(side, other) => -stored(other),
            _ => stored(side),
        }
    }

    /// Whether the stream function and its slopes go on across an edge, on which there is no member: both triangles have it, with the same vertex
    /// copies at both ends of the edge; they also use the same slope across its middle then.
    pub(super) fn is_glued(&self, side: Side, other: Side) -> bool {
        if self.tiling.member(side).is_some() {
            return false;
        }
        let ends = |side: Side| match self.field.flows[side.triangle] {
            Flow::Stream { corners, .. } => Some([1, 2].map(|i| corners[after(side.corner, i)])),
            Flow::Quadratic(_) => None,
        };
        match (ends(side), ends(other)) {
            (Some([a, b]), Some([c, d])) => a == d && b == c,
            _ => false,
        }
    }
}
