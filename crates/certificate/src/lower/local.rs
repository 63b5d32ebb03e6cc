use super::StressFunction;
use super::element::Local;
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::tiling::{Beyond, after};

impl StressFunction<'_> {
    /// The local values of a triangle's element, less the polynomial of its surface and some affine function, which carries no
    /// stress. At apexes nothing is left.
    ///
    /// Values that are stored relative to a gauge stay as they are if that gauge is what is taken away. In a triangle
    /// without an apex also the affine function that touches at corner 0 is taken away: what is left is small, and so
    /// is its rounding.
    pub(super) fn local(&self, triangle: usize) -> Local {
        let copies = self.field.corners[triangle];
        let corners = self.tiling.corners(triangle);
        let apex = copies.map(|copy| self.apexes[copy]);
        // Next to an apex, all have the base of the apex.
        let frame = copies.map(|copy| self.jets[copy].base).into_iter().max().unwrap_or(0);
        let surface = self.surfaces.of_triangle(triangle);
        let mut f = [Interval::ZERO; 3];
        let mut slopes = [Vector::ZERO; 3];
        for k in (0..3).filter(|k| !apex[*k]) {
            let jet = self.jets[copies[k]];
            let (more, steeper) = self.surfaces.beyond(jet.surface, surface, corners[k]);
            f[k] = jet.f + self.gauges.value(jet.base, frame, corners[k]) + more;
            slopes[k] = jet.slopes + self.gauges.gradient(jet.base, frame) + steeper;
        }
        let mut across = [0, 1, 2].map(|k| {
            if apex[after(k, 1)] || apex[after(k, 2)] {
                return Interval::ZERO;
            }
            let [a, b] = [corners[after(k, 1)], corners[after(k, 2)]];
            let n = (b - a).turned();
            let slope = self.slope(Side { triangle, corner: k }, frame, n);
            let middle = Vector { x: (a.x + b.x).half(), y: (a.y + b.y).half() };
            let (_, less) = self.surfaces.jet(surface, middle);
            if less.is_zero() { slope } else { slope - less.dot(n) }
        });
        if apex == [false; 3] {
            let (value, slope) = (f[0], slopes[0]);
            for k in 0..3 {
                let edge = corners[after(k, 2)] - corners[after(k, 1)];
                across[k] = across[k] - slope.dot(edge.turned());
            }
            (f[0], slopes[0]) = (Interval::ZERO, Vector::ZERO);
            for k in 1..3 {
                f[k] = f[k] - value - slope.dot(corners[k] - corners[0]);
                slopes[k] = slopes[k] - slope;
            }
        }
        Local { corners, apex, f, slopes, across }
    }

    /// The slope across the middle of an edge, along its vector turned left, beyond that of the gauge `frame`.
    pub(super) fn slope(&self, side: Side, frame: usize, turned: Vector) -> Interval {
        let stored = |side: Side| Interval::point(self.field.slopes[side.triangle][side.corner]);
        let absolute = |slope: Interval| slope + self.gauges.gradient(0, frame).dot(turned);
        match self.tiling.beyond(side) {
            Beyond::Soil(other) => {
                if let Some(on) = self.tiling.member(side) {
                    return absolute(self.slope_beside_bar(side, other, &on).unwrap_or_else(|| stored(side)));
                }
                let slope = if other < side { -stored(other) } else { stored(side) };
                let [start, end] = self.ends(side);
                if [end, start] == self.ends(other) {
                    return absolute(slope);
                }
                // Between branches: each side has its own.
                slope + self.gauges.gradient(self.jets[start].base, frame).dot(turned)
            }
            Beyond::Boundary(on, condition) if condition.traction_is_given() => {
                let base = self.jets[self.ends(side)[0]].base;
                (self.gauges.gradient(base, frame) + self.loads.middle_slopes(on)).dot(turned)
            }
            Beyond::Boundary(on, condition) if condition.shear_is_given() => {
                // The edge is this part of its line.
                let part = Interval::point(on.end) - Interval::point(on.start);
                let middle = (Interval::point(on.start) + Interval::point(on.end)).half();
                part * self.given.across(&self.gauges, on.side.line, middle, frame)
            }
            Beyond::Boundary(..) => absolute(stored(side)),
        }
    }
}
