//! Velocities along an edge.

use soilctl_conic::Form;

use super::Velocity;

/// A velocity, quadratic along an edge: Bernstein coefficients at the start, in the middle and at the end of its parts
/// along the edge and across it, to the left. As a relative velocity of the soil on the left these are slip and opening.
#[derive(Debug, Clone, Default)]
pub(super) struct EdgeVelocity {
    pub(super) slip: [Form; 3],
    pub(super) opening: [Form; 3],
}

impl EdgeVelocity {
    /// From velocities at control points; `t` is the edge's unit vector.
    pub(super) fn new(t: [f64; 2], velocities: &[Velocity; 3]) -> Self {
        let part =
            |d: [f64; 2]| velocities.each_ref().map(|v| Form::default().plus(d[0], &v[0]).plus(d[1], &v[1]));
        Self { slip: part(t), opening: part([-t[1], t[0]]) }
    }

    /// From a stream function with given values and slopes at the ends and slope across the middle; `d` is the edge
    /// vector. With `n` that turned left, `v . d = grad s . n` and `v . n = -grad s . d`, the derivative of a cubic.
    pub(super) fn of_stream(d: [f64; 2], [a, b]: [&[Form; 3]; 2], across: &Form) -> Self {
        let length = d[0].hypot(d[1]);
        let slope = |jet: &[Form; 3], d: [f64; 2]| Form::default().plus(d[0], &jet[1]).plus(d[1], &jet[2]);
        let n = [-d[1], d[0]];
        let (over_a, over_b) = (slope(a, n), slope(b, n));
        let middle = Form::default().plus(2.0, across).plus(-0.5, &over_a).plus(-0.5, &over_b);
        let (from_a, to_b) = (slope(a, d), slope(b, d));
        let flow = to_b.clone().plus(1.0, &from_a).plus(-3.0, &b[0]).plus(3.0, &a[0]);
        let by = |factor: f64, form: &Form| Form::default().plus(factor / length, form);
        Self {
            slip: [by(1.0, &over_a), by(1.0, &middle), by(1.0, &over_b)],
            opening: [by(-1.0, &from_a), by(1.0, &flow), by(-1.0, &to_b)],
        }
    }

    /// The same, seen from the other side.
    pub(super) fn reversed(self) -> Self {
        let turned = |[a, b, c]: [Form; 3]| [c, b, a].map(|f| Form::default().plus(-1.0, &f));
        Self { slip: turned(self.slip), opening: turned(self.opening) }
    }

    /// Relative to another one along the same edge.
    pub(super) fn less(self, other: &Self) -> Self {
        let less = |a: [Form; 3], b: &[Form; 3]| {
            let mut parts = a;
            parts.iter_mut().zip(b).for_each(|(a, b)| a.add(-1.0, b));
            parts
        };
        Self { slip: less(self.slip, &other.slip), opening: less(self.opening, &other.opening) }
    }
}
