//! Beams: lines along which the stress function and its slopes may jump.
//!
//! Let `t` point along a beam and `n` to its left, and let `f` and `g` be the stress functions on its left and on its right; where the beam
//! lines the soil, that of the loads on its outer side takes the place of one of them. The tractions of a stress function on a path add up to
//! the change of its slopes, turned, and their moment to the change of its value. So what the beam bears at a section is
//!
//! ```text
//! moment  M = f - g          shear force  V = t . grad (f - g) = dM/ds          axial force  N = n . grad (f - g)
//! ```
//!
//! and it is in equilibrium with the tractions on both of its sides, whatever `f` and `g` are. Along an edge `M` is cubic, `V` and `N` are
//! quadratic: they are within their limits if their Bernstein coefficients are. From one edge to the next they go on, but for the slopes
//! where another member is attached, since all triangles around a vertex on one side of the beam share the value there.
//! The references of the soils on both sides have the same tractions on the line, so they add nothing.

use super::StressFunction;
use super::loads::Station;
use super::members::{Bent, SectionForces, place};
use crate::CertificateError;
use crate::fields::Jet;
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::tiling::{Beyond, MemberEdge, OnLine, after};

/// A stress function along an edge of a beam, from its start to its end.
#[derive(Debug, Clone, Copy)]
struct Trace {
    value: [Interval; 2],
    slopes: [Vector; 2],
    /// Slope in the middle along the beam's normal, times the length of the edge.
    middle: Interval,
}

/// A beam along an edge.
pub(super) struct BeamEdge {
    /// The edge, from its start to its end.
    along: Vector,
    left: Trace,
    right: Trace,
    /// Whether both traces are one function near the start and the end, by how they are built.
    meets: [bool; 2],
}

impl BeamEdge {
    /// Whether nothing acts on the start or the end.
    pub(super) fn ends_free(&self, end: bool) -> bool {
        self.meets[usize::from(end)]
    }

    pub(super) fn forces(&self) -> SectionForces {
        let length = self.along.square().sqrt();
        let t = self.along * (Interval::ONE / length);
        let [m0, m1] = [0, 1].map(|i| self.left.value[i] - self.right.value[i]);
        let jumps = [0, 1].map(|i| self.left.slopes[i] - self.right.slopes[i]);
        let [v0, v1] = jumps.map(|jump| jump.dot(t));
        let [a, b] = jumps.map(|jump| jump.dot(t.turned()));
        let middle = (self.left.middle - self.right.middle) / length;
        let third = length / Interval::point(3.0);
        let moment = [m0, m0 + v0 * third, m1 - v1 * third, m1];
        // The slope of the cubic.
        let between = (moment[2] - moment[1]) / third;
        let bent = Bent { moment, shear: [v0, between, v1] };
        SectionForces { axial: [a, Interval::point(2.0) * middle - (a + b).half(), b], bent: Some(bent) }
    }
}

impl StressFunction<'_> {
    pub(super) fn beam_edge(&self, edge: &MemberEdge) -> Result<BeamEdge, CertificateError> {
        if self.field.gauges.len() > self.loads.count().max(1) {
            let what = "a beam where the stress function has branches around bodies";
            return Err(CertificateError::NotCovered { place: place(edge), what });
        }
        let [start, end] = self.tiling.ends_on_member(edge);
        let along = end - start;
        let of_soil = |side: Side| self.trace(side, along);
        let (left, right) = match edge.sides {
            [Some(left), Some(right)] => (of_soil(left), of_soil(right)),
            [Some(left), None] => (of_soil(left), self.outside(left, along)?),
            [None, Some(right)] => (self.outside(right, along)?, of_soil(right)),
            [None, None] => {
                return Err(CertificateError::BadField {
                    place: place(edge),
                    problem: "there is no soil along it",
                });
            }
        };
        Ok(BeamEdge { along, left, right, meets: self.meets(edge) })
    }

    /// Value and slopes of the function at a vertex copy, in full.
    fn whole(&self, copy: usize) -> (Interval, Vector) {
        let jet = self.jets[copy];
        let at = self.tiling.position(self.field.copies[copy].vertex);
        let (more, steeper) = self.surfaces.jet(jet.surface, at);
        (
            jet.f + self.gauges.value(jet.base, 0, at) + more,
            jet.slopes + self.gauges.gradient(jet.base, 0) + steeper,
        )
    }

    /// That of the soil. The edge may be walked either way.
    fn trace(&self, side: Side, along: Vector) -> Trace {
        let [a, b] = self.in_order(side);
        let ((f, df), (g, dg)) = (self.whole(a), self.whole(b));
        let apex = |copy: usize| self.apexes[copy];
        let own = self.tiling.corners(side.triangle);
        let walked = own[after(side.corner, 2)] - own[after(side.corner, 1)];
        let middle = if apex(a) || apex(b) {
            // Stored slopes are not used. Beyond the polynomial the slope across is known to first order at the apex, where it vanishes, and
            // grows with the square of the distance up to that at the other end.
            let surface = self.surfaces.of_triangle(side.triangle);
            let [p, q] = [a, b].map(|copy| self.tiling.position(self.field.copies[copy].vertex));
            let n = along.turned();
            let at = Vector { x: (p.x + q.x).half(), y: (p.y + q.y).half() };
            let beyond = |slopes: Vector, p: Vector| (slopes - self.surfaces.jet(surface, p).1).dot(n);
            let frame = self.gauges.gradient(self.jets[a].base, 0);
            let rest = [(df - frame, p), (dg - frame, q)].map(|(slopes, p)| beyond(slopes, p));
            let quarter = Interval::point(0.25);
            (rest[0] + rest[1]) * quarter + (self.surfaces.jet(surface, at).1 + frame).dot(n)
        } else {
            let slope = self.slope(side, 0, walked.turned());
            if self.is_left(side) { slope } else { -slope }
        };
        Trace { value: [f, g], slopes: [df, dg], middle }
    }

    /// Whether the triangle is on the beam's left.
    fn is_left(&self, side: Side) -> bool {
        self.tiling.member(side).is_some_and(|on| on.is_left)
    }

    /// Vertex copies at the start and the end of an edge, as the member goes.
    fn in_order(&self, side: Side) -> [usize; 2] {
        let [a, b] = self.ends(side);
        if self.is_left(side) { [a, b] } else { [b, a] }
    }

    /// That of the loads on the outer side of a beam that lines the soil.
    fn outside(&self, side: Side, along: Vector) -> Result<Trace, CertificateError> {
        let (on, [start, end], run) = self.lined(side)?;
        let [p, q] = self.in_order(side).map(|copy| self.tiling.position(self.field.copies[copy].vertex));
        let gradient = self.gauges.gradient(run, 0);
        let at = |(f, slopes): (Interval, Vector), p: Vector| {
            (f + self.gauges.value(run, 0, p), slopes + gradient)
        };
        let ((f, df), (g, dg)) = (at(self.loads.jet(start), p), at(self.loads.jet(end), q));
        let middle = (self.loads.middle_slopes(on) + gradient).dot(along.turned());
        Ok(Trace { value: [f, g], slopes: [df, dg], middle })
    }

    /// Where an edge of a beam that lines the soil is on its run, from the beam's start to its end.
    fn lined(&self, side: Side) -> Result<(OnLine, [Station; 2], usize), CertificateError> {
        let found = match self.tiling.beyond(side) {
            Beyond::Boundary(on, _) => {
                self.loads.ends(on).zip(self.loads.run(on.side)).map(|found| (on, found))
            }
            Beyond::Soil(_) => None,
        };
        let Some((on, ([a, b], run))) = found else {
            let problem = "what is beyond the beam is not known";
            return Err(CertificateError::BadField { place: side.to_string(), problem });
        };
        Ok((on, if self.is_left(side) { [a, b] } else { [b, a] }, run))
    }

    /// Whether there is nothing but one function at the start and at the end of an edge.
    fn meets(&self, edge: &MemberEdge) -> [bool; 2] {
        let gauge = |copy: usize| {
            let Jet::Gauge { gauge } = self.field.copies[copy].jet else { return None };
            self.stations[copy].map(|station| (gauge, station))
        };
        match edge.sides {
            [Some(left), Some(right)] => {
                let (a, b) = (self.in_order(left), self.in_order(right));
                [0, 1].map(|i| a[i] == b[i] || (gauge(a[i]).is_some() && gauge(a[i]) == gauge(b[i])))
            }
            [Some(side), None] | [None, Some(side)] => {
                let copies = self.in_order(side);
                let outer = self.lined(side).ok();
                [0, 1].map(|i| outer.is_some_and(|(_, ends, run)| gauge(copies[i]) == Some((run, ends[i]))))
            }
            [None, None] => [false; 2],
        }
    }

    /// Checks that a beam bears its moment and its shear force along an edge.
    pub(super) fn check_bending(&self, edge: &MemberEdge, bent: Bent) -> Result<(), CertificateError> {
        let Some(most) = self.problem.statement.members[edge.member()].bending else { return Ok(()) };
        let [moment, shear] =
            [most.moment, most.shear].map(|force| self.divisor.part(Interval::point(force)));
        let spares = bent.moment.into_iter().map(|m| ("moment of the beam to spare", moment - m, moment + m));
        let shears =
            bent.shear.into_iter().map(|v| ("shear force of the beam to spare", shear - v, shear + v));
        for (quantity, above, below) in spares.chain(shears) {
            if let Some(spare) = [above, below].into_iter().find(|spare| !spare.is_at_least_zero()) {
                let (place, low, unit) = (place(edge), spare.lo(), "force");
                return Err(CertificateError::NotProven { quantity, place, low, unit });
            }
        }
        Ok(())
    }
}
