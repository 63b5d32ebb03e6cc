//! What soil dissipates, by its strength.
//!
//! With `p` the mean effective stress and `R` the radius of Mohr's circle, the soil bears
//! `R <= c cos(phi) - p sin(phi)` and, with a greatest tension `t`, `p + R <= t`. Strain with the dilation `e` and the
//! shear rate `g` dissipates at most the greatest `p e + R g`. That is finite if `e >= g sin(phi)`; then it is at most
//!
//! - `c cot(phi) e`, the value at the apex of the cone (or `c g` without friction, where `e` is zero), and
//! - `t e + Q max(g - e, 0)` if there is a `t`, where `Q = max(0, (c cos(phi) - t sin(phi))/(1 - sin(phi)))` is the radius at
//!   which both limits meet: the greatest `p e + R g` is found there or at `(p, R) = (t, 0)`, and where `t >= c cot(phi)`
//!   the first limit alone gives no more than this.
//!
//! The first is linear in the cohesion and in the dilation. In the second, `Q` and `max(g - e, 0)` are convex and not
//! negative, so they are at most the linear (on an edge quadratic) functions with the same values at the corners (with
//! their values at the control points as coefficients), and their product is at most the product of these. The water in
//! the pores adds `-u e`.
//!
//! An envelope is made of straight lines `R <= a - b p`, steepest first, of which a greatest tension is one. Where `e/g` is between the
//! slopes of two that follow each other, these alone bound `p e + R g` by its value where they meet; above the first slope the first
//! bounds it by its value at `R = 0`. So the greatest of these values is a bound, whatever `e/g` is above the last slope. It is convex in
//! the strain rate, so it is at most the linear function through its values at the corners.

use super::means;
use crate::interval::{Angle, Interval, Vector};
use crate::problem::{Anisotropy, Envelope, Straight, Strength, StressPoint};

/// Power of the stresses in soil that flows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Resisted {
    /// At most that of the effective stress.
    pub(super) strength: Interval,
    /// That of the water in the pores, which helps the flow.
    pub(super) water: Interval,
}

impl Resisted {
    /// At most all of it.
    pub(super) fn all(self) -> Interval {
        self.strength - self.water
    }
}

/// Strength at the `N` corners of something over which it is linear.
pub(super) struct Resistance<'a, const N: usize> {
    friction: Angle,
    cohesion: [Interval; N],
    pore_pressure: [Interval; N],
    tension: Option<Interval>,
    envelope: Option<&'a Envelope>,
    anisotropy: Option<Anisotropy>,
    /// The points.
    at: [Vector; N],
}

impl<'a, const N: usize> Resistance<'a, N> {
    /// Strength between these points.
    pub(super) fn new(strength: &'a Strength, points: [Vector; N]) -> Self {
        Self {
            friction: strength.friction,
            // More cohesion never dissipates less.
            cohesion: points.map(|p| strength.cohesion.enclosed(p).or_zero()),
            pore_pressure: points.map(|p| strength.pore_pressure.enclosed(p)),
            tension: strength.tension,
            envelope: strength.envelope.as_ref(),
            anisotropy: strength.anisotropy,
            at: points,
        }
    }

    fn is_frictionless(&self) -> bool {
        self.friction.sin.is_zero()
    }

    /// The tension up to which the pressure on an opening layer is limited beyond what friction and cohesion do. Without
    /// friction, layers open only if there is one, so it does not matter which one is taken if they do not.
    fn cut_off(&self) -> Option<Interval> {
        self.tension.or_else(|| self.is_frictionless().then_some(Interval::ZERO))
    }

    /// `Q` at the corners.
    fn radius(&self, tension: Interval) -> [Interval; N] {
        let Angle { sin, cos } = self.friction;
        self.cohesion.map(|c| ((c * cos - tension * sin) / (Interval::ONE - sin)).or_zero())
    }

    /// `c cot(phi)` at the corners.
    fn apex(&self) -> [Interval; N] {
        self.cohesion.map(|c| self.friction.cot_times(c))
    }

    /// The circles at which the greatest power of an envelope can be found.
    fn circles(&self, envelope: &Envelope) -> Vec<StressPoint> {
        let lines = &envelope.touched;
        let cut = self.tension.and_then(|t| lines.first().map(|line| cut_of(line, t)));
        self.vertices(lines, Straight::meets, cut)
    }

    /// Where lines of an envelope meet one after the other; first, where the first or the greatest tension ends it.
    fn vertices(
        &self,
        lines: &[Straight],
        meets: impl Fn(&Straight, &Straight) -> StressPoint,
        cut: Option<StressPoint>,
    ) -> Vec<StressPoint> {
        let [first, ..] = lines else { return Vec::new() };
        let apex = (first.apex(), Interval::ZERO);
        let ends = match (self.tension, cut) {
            (Some(tension), Some(cut)) if tension.hi() < apex.0.hi() => vec![(tension, Interval::ZERO), cut],
            _ => vec![apex],
        };
        let between = lines.windows(2).map(|two| meets(&two[0], &two[1]));
        // More radius never dissipates less.
        ends.into_iter().chain(between).map(|(mean, radius)| (mean, radius.or_zero())).collect()
    }

    /// The lesser of the two bounds, of those that there are, and what the water does.
    fn least(
        &self,
        apex: impl Fn([Interval; N]) -> Interval,
        cut: impl Fn(Interval, [Interval; N]) -> Interval,
        water: Interval,
    ) -> Resisted {
        let cut = self.cut_off().map(|tension| cut(tension, self.radius(tension)));
        let apex = (!self.is_frictionless()).then(|| apex(self.apex()));
        let strength = match (apex, cut) {
            (Some(a), Some(b)) => a.or_lesser(b),
            (Some(a), None) | (None, Some(a)) => a,
            (None, None) => Interval::ZERO,
        };
        Resisted { strength, water }
    }
}

/// The greatest power of the stresses at some vertices, for one unit of the first and the second kind of rate.
fn greatest(vertices: &[StressPoint], first: Interval, second: Interval) -> Interval {
    let power = |(mean, radius): &StressPoint| *mean * first + *radius * second;
    vertices.iter().map(power).reduce(|a, b| if a.hi() < b.hi() { b } else { a }).unwrap_or(Interval::ZERO)
}

/// Where a line bears the circle that touches the greatest tension.
fn cut_of(line: &Straight, tension: Interval) -> StressPoint {
    let Angle { sin, cos } = line.friction;
    let radius = ((line.cohesion * cos - tension * sin) / (Interval::ONE - sin)).or_zero();
    (tension - radius, radius)
}

fn mean_of_three(of: [Interval; 3]) -> Interval {
    (of[0] + of[1] + of[2]).third()
}

impl Resistance<'_, 3> {
    /// What a triangle dissipates, from dilation and shear rate at the corners, times the area. The flow rule holds.
    pub(super) fn of_triangle(&self, dilation: [Interval; 3], shearing: [Interval; 3]) -> Resisted {
        let mean = means::over_triangle;
        let one = [Interval::ONE; 3];
        let water = mean(self.pore_pressure, dilation);
        if let Some(envelope) = self.envelope {
            let vertices = self.circles(envelope);
            let at_corners = [0, 1, 2].map(|i| greatest(&vertices, dilation[i], shearing[i]));
            return Resisted { strength: mean_of_three(at_corners), water };
        }
        let beyond = [0, 1, 2].map(|i| (shearing[i] - dilation[i]).or_zero());
        self.least(
            |apex| mean(apex, dilation),
            |tension, radius| tension * mean(one, dilation) + mean(radius, beyond),
            water,
        )
    }
}

impl Resistance<'_, 2> {
    /// The rate that slip in a thin layer along the edge takes up. With `t` along the edge and `n` that turned left, the soil on the left moves by the
    /// slip along `t` relative to that on the right, so strain rates are half of `n t' + t n'` times the slip.
    fn directed(&self, anisotropy: Anisotropy, slip: Interval) -> Interval {
        let [from, to] = self.at;
        anisotropy.of_slip(to - from, slip)
    }

    /// What a layer dissipates that bears the part `bond` of the soil's shear strength at each normal stress, likewise. With `t`
    /// the greatest tension, it opens by at least `bond |slip| tan(phi)`, and the greatest power of what it bears is found where the normal
    /// stress is `t`, at most `t opening + bond max(0, c - t tan(phi)) |slip|`; without a limit `t` is `c cot(phi)`. Of strength
    /// that depends on the direction it is that part of what a layer along the edge takes up.
    pub(super) fn of_bond(&self, bond: Interval, opening: [Interval; 3], slip: [Interval; 3]) -> Resisted {
        let mean = means::over_edge;
        let one = [Interval::ONE; 2];
        let sliding = slip.map(|s| self.anisotropy.map_or(s.abs(), |of| self.directed(of, s)));
        let tan = self.friction.tan();
        let water = mean(self.pore_pressure, opening);
        if let Some(envelope) = self.envelope {
            let lines = &envelope.outside;
            let cut = |t: Interval| lines.first().map(|line| (t, line.cohesion - t * line.friction.tan()));
            let vertices = self.vertices(lines, Straight::crosses, self.tension.and_then(cut));
            let at_points = [0, 1, 2].map(|i| greatest(&vertices, opening[i], bond * sliding[i]));
            return Resisted { strength: mean_of_three(at_points), water };
        }
        let beyond = |t: Interval| self.cohesion.map(|c| bond * (c - t * tan).or_zero());
        let cut = self.cut_off().map(|t| t * mean(one, opening) + mean(beyond(t), sliding));
        let apex = (!self.is_frictionless()).then(|| mean(self.apex(), opening));
        let strength = match (apex, cut) {
            (Some(a), Some(b)) => a.or_lesser(b),
            (Some(a), None) | (None, Some(a)) => a,
            (None, None) => Interval::ZERO,
        };
        Resisted { strength, water }
    }

    /// What a layer dissipates, from opening and slip at the control points, times the length. The flow rule holds, and
    /// without friction nor a limit to tension the opening is zero. The dilation of a layer is its opening, its shear rate
    /// the length of the vector of opening and slip. Of strength that depends on the direction it is what a layer along the edge takes up.
    pub(super) fn of_layer(&self, opening: [Interval; 3], slip: [Interval; 3]) -> Resisted {
        let mean = means::over_edge;
        let one = [Interval::ONE; 2];
        let water = mean(self.pore_pressure, opening);
        if let Some(envelope) = self.envelope {
            let vertices = self.circles(envelope);
            let rate = |i: usize| {
                if opening[i].is_zero() {
                    slip[i].abs()
                } else {
                    (opening[i].square() + slip[i].square()).sqrt()
                }
            };
            let at_points = [0, 1, 2].map(|i| greatest(&vertices, opening[i], rate(i)));
            return Resisted { strength: mean_of_three(at_points), water };
        }
        let beyond = [0, 1, 2].map(|i| {
            let (o, s) = (opening[i], slip[i]);
            if let Some(anisotropy) = self.anisotropy {
                return self.directed(anisotropy, s);
            }
            if o.is_zero() { s.abs() } else { ((o.square() + s.square()).sqrt() - o).or_zero() }
        });
        self.least(
            |apex| mean(apex, opening),
            |tension, radius| tension * mean(one, opening) + mean(radius, beyond),
            water,
        )
    }
}
