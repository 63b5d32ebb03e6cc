//! What soil and faces dissipate.
//!
//! With the dilation `e` and the shear rate `g` at most `c cot(phi) e`, or, if tension is limited to `t`, `t e + Q max(g -
//! e, 0)`: the documentation of `soilctl-certificate` says why. Like there, factors are linear between corners, and the
//! lesser of the two counts for a whole triangle or edge.

use soilctl_certificate::{Linear, Material};

use super::Point;
use crate::anisotropy::{Ellipse, ROUND};
use crate::envelope::{Envelope, greatest};
use crate::vector::between;

/// Strength of a soil or a face.
#[derive(Debug, Clone)]
pub(super) struct Strength {
    sin: f64,
    cos: f64,
    cohesion: Linear,
    tension: Option<f64>,
    envelope: Option<Envelope>,
    ellipse: Ellipse,
}

impl Strength {
    pub(super) fn of_soil(m: &Material) -> Self {
        let (sin, cos) = m.phi_deg.to_radians().sin_cos();
        Self {
            sin,
            cos,
            cohesion: m.cohesion,
            tension: m.tension,
            envelope: Envelope::of(m),
            ellipse: Ellipse::of(m),
        }
    }

    pub(super) fn of_face(delta_deg: f64, adhesion: f64) -> Self {
        let (sin, cos) = delta_deg.to_radians().sin_cos();
        Self { sin, cos, cohesion: Linear::uniform(adhesion), tension: None, envelope: None, ellipse: ROUND }
    }

    /// What counts as the shear rate, from strain rates `[exx, eyy, 2 exy]`.
    pub(super) fn shear_rate(&self, [exx, eyy, shear]: [f64; 3]) -> f64 {
        self.ellipse.rate(exx - eyy, shear)
    }

    /// Opening over slip that the flow rule demands.
    pub(super) fn tan(&self) -> f64 {
        self.envelope.as_ref().map_or(self.sin / self.cos, |envelope| envelope.flattest.tan())
    }

    fn cohesion(&self, p: Point) -> f64 {
        self.cohesion.at(p).max(0.0)
    }

    /// The greatest shear stress that is borne at a mean effective stress, tension positive.
    pub(super) fn shear(&self, mean: f64, p: Point) -> f64 {
        self.borne(mean, p)[0]
    }

    /// The same with the sine of the friction angle at that stress.
    fn borne(&self, mean: f64, p: Point) -> [f64; 2] {
        let own = [self.cohesion(p) * self.cos - mean * self.sin, self.sin];
        let further = self.envelope.iter().flat_map(|envelope| &envelope.inside);
        let lines = further.map(|line| [line.cohesion * line.cos - mean * line.sin, line.sin]);
        let [least, sin] = lines.fold(own, |a, b| if b[0] < a[0] { b } else { a });
        [least.max(0.0), sin]
    }

    /// Normal stress, compression positive, on the planes that slip at a mean effective stress, tension positive.
    pub(super) fn on_slip_surface(&self, mean: f64, p: Point) -> f64 {
        let [shear, sin] = self.borne(mean, p);
        -mean - shear * sin
    }

    /// Tension at the apex of the cone.
    fn apex(&self, p: Point) -> f64 {
        let c = self.cohesion(p);
        if c == 0.0 { 0.0 } else { c * self.cos / self.sin }
    }

    fn radius(&self, tension: f64, p: Point) -> f64 {
        ((self.cohesion(p) * self.cos - tension * self.sin) / (1.0 - self.sin)).max(0.0)
    }

    /// The lesser of `mean` of the two limits, each with its factors on `e` and on `max(g - e, 0)`.
    fn least<const N: usize>(&self, points: [Point; N], mean: impl Fn([f64; N], [f64; N]) -> f64) -> f64 {
        let cut = self.tension.or((self.sin == 0.0).then_some(0.0));
        let cut = cut.map(|t| mean([t; N], points.map(|p| self.radius(t, p))));
        let apex = (self.sin > 0.0).then(|| mean(points.map(|p| self.apex(p)), [0.0; N]));
        match (apex, cut) {
            (Some(a), Some(b)) => a.min(b),
            (a, b) => a.or(b).unwrap_or(0.0),
        }
    }

    /// Mean power over a triangle, per area, from dilation and shear rate at its corners.
    pub(super) fn in_triangle(&self, points: [Point; 3], e: [f64; 3], g: [f64; 3]) -> f64 {
        if let Some(envelope) = &self.envelope {
            return [0, 1, 2].map(|i| greatest(&envelope.circles, e[i], g[i])).iter().sum::<f64>() / 3.0;
        }
        let beyond = [0, 1, 2].map(|i| (g[i] - e[i]).max(0.0));
        self.least(points, |on_e, on_rest| over_triangle(on_e, e) + over_triangle(on_rest, beyond))
    }

    /// Mean power along an edge, per length, from opening and slip at their three control points.
    pub(super) fn in_layer(&self, points: [Point; 2], opening: [f64; 3], slip: [f64; 3]) -> f64 {
        if let Some(envelope) = &self.envelope {
            let power = |i: usize| greatest(&envelope.circles, opening[i], opening[i].hypot(slip[i]));
            return [0, 1, 2].map(power).iter().sum::<f64>() / 3.0;
        }
        let rate = |i: usize| {
            if self.ellipse == ROUND {
                (opening[i].hypot(slip[i]) - opening[i].max(0.0)).max(0.0)
            } else {
                self.ellipse.along(between(points[0], points[1]), slip[i])
            }
        };
        let beyond = [0, 1, 2].map(rate);
        self.least(points, |on_e, on_rest| over_edge(on_e, opening) + over_edge(on_rest, beyond))
    }
}

/// Mean of the product of two functions that are linear between corners.
pub(super) fn over_triangle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let paired: f64 = (0..3).map(|i| a[i] * b[i]).sum();
    (a.iter().sum::<f64>() * b.iter().sum::<f64>() + paired) / 12.0
}

/// Mean over an edge of a linear function times a quadratic one, given by its Bernstein coefficients.
pub(super) fn over_edge([start, end]: [f64; 2], [a, b, c]: [f64; 3]) -> f64 {
    (start * (3.0 * a + 2.0 * b + c) + end * (a + 2.0 * b + 3.0 * c)) / 12.0
}
