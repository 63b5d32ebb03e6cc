use super::StressFunction;
use super::element::NodeStresses;
use super::surfaces::AT_REST;
use crate::CertificateError;
use crate::ends::{Splice, SpliceLimit};
use crate::fields::LowerField;
use crate::interval::{Angle, Interval, Vector};
use crate::problem::{Anisotropy, Straight, Strength, Stress};
use crate::statement::{Objective, Statement};
use crate::tiling::after;

/// What cohesion, adhesion and tension are divided by. A factor `m` on everything that acts is proven by the `m`-th part of
/// such stresses: in equilibrium with what acts, and within the strength of the same friction and the `m`-th part of the
/// rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divisor(Option<Interval>);

impl Divisor {
    pub(super) fn new(statement: &Statement, field: &LowerField) -> Result<Self, CertificateError> {
        if statement.objective != Objective::Everything {
            return Ok(Self(None));
        }
        if field.multiplier > 0.0 && field.multiplier < f64::INFINITY {
            return Ok(Self(Some(Interval::point(field.multiplier))));
        }
        let problem = "its factor on everything that acts must be above zero";
        Err(CertificateError::BadField { place: "the field".into(), problem })
    }

    /// The part of a stress. None of nothing is nothing.
    pub(super) fn part(self, stress: Interval) -> Interval {
        match self.0 {
            Some(factor) if !stress.is_zero() => stress / factor,
            _ => stress,
        }
    }
}

/// The strength at one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limit<'a> {
    friction: Angle,
    cohesion: Interval,
    /// Further lines of an envelope, with what divides their cohesions; nothing if these do not count.
    further: &'a [Straight],
    divisor: Option<Divisor>,
    pub(super) pore_pressure: Interval,
    tension: Option<Interval>,
    anisotropy: Option<Anisotropy>,
    /// What follows from the ends of a structure.
    splice: Option<SpliceLimit>,
}

impl<'a> Limit<'a> {
    pub(super) fn at(strength: &'a Strength, divisor: Divisor, splice: Option<&Splice>, p: Vector) -> Self {
        let Strength { friction, cohesion, pore_pressure, tension, envelope: _, anisotropy } = strength;
        let (cohesion, pore_pressure) = (divisor.part(cohesion.enclosed(p)), pore_pressure.enclosed(p));
        let (tension, splice) = (tension.map(|t| divisor.part(t)), splice.map(|splice| splice.at(p)));
        let (further, divisor) = (strength.further(), Some(divisor));
        let anisotropy = *anisotropy;
        Self { friction: *friction, cohesion, further, divisor, pore_pressure, tension, anisotropy, splice }
    }

    /// What a change of stress must be within so that any multiple of it can be added to a state within strength, where the
    /// pore pressure changes as given.
    pub(super) fn of_changes(
        strength: &'a Strength,
        splice: Option<&Splice>,
        pore_pressure: Interval,
    ) -> Self {
        let tension = strength.tension.map(|_| Interval::ZERO);
        let splice = splice.map(Splice::of_changes);
        Self {
            friction: strength.friction,
            cohesion: Interval::ZERO,
            further: strength.further(),
            divisor: None,
            pore_pressure,
            tension,
            anisotropy: strength.anisotropy,
            splice,
        }
    }

    /// Friction angle and cohesion of all lines.
    fn lines(&self) -> impl Iterator<Item = (Angle, Interval)> {
        let cohesion = |line: &Straight| self.divisor.map_or(Interval::ZERO, |by| by.part(line.cohesion));
        let further = self.further.iter().map(move |line| (line.friction, cohesion(line)));
        std::iter::once((self.friction, self.cohesion)).chain(further)
    }

    /// The least that there may be to spare; at least zero if the state is proven to be one the soil can bear. With the
    /// effective stress, `r = sqrt(((xx - yy)/2)^2 + xy^2)` and `m = (xx + yy)/2`, that is one with
    /// `c cos(phi) - sin(phi) m >= r` for all lines of the strength and, if tension is limited, `tension - m >= r`; ends limit `r` twice more. Of strength
    /// that depends on the direction `r` is the distance from the middle of the ellipse over its half-axes.
    fn spare(&self, mean: Interval, half_difference: Interval, xy: Interval) -> f64 {
        let Self { pore_pressure, tension, splice, .. } = *self;
        let mean = mean + pore_pressure;
        let [half_difference, xy] = match self.anisotropy {
            Some(anisotropy) => anisotropy.round(self.cohesion, half_difference, xy),
            None => [half_difference, xy],
        };
        let radius_square = half_difference.square() + xy.square();
        let [greatest, least] = splice.map_or([None; 2], |splice| splice.radii(mean).map(Some));
        let lines = self.lines().map(|(friction, cohesion)| cohesion * friction.cos - friction.sin * mean);
        let bounds = lines.chain([tension.map(|t| t - mean), greatest, least].into_iter().flatten());
        let spare = |bound: Interval| {
            if bound.is_at_least_zero() && (bound.square() - radius_square).is_at_least_zero() {
                return 0.0;
            }
            // For the message only; never zero.
            (bound.lo() - radius_square.hi().sqrt()).min(-f64::MIN_POSITIVE)
        };
        bounds.map(spare).fold(0.0, f64::min)
    }

    /// What each line of the strength bears of shear along `t` at an effective normal stress, both times the square of `t`; the stress is
    /// given times that. Of shear that moves the soil to the left of `t` forwards, and backwards.
    pub(super) fn shear_strengths(&self, normal: Interval, t: Vector) -> impl Iterator<Item = [Interval; 2]> {
        let ways = self.anisotropy.map_or([t.square(); 2], |of| of.along(t));
        let bears = move |friction: Angle, cohesion: Interval| {
            ways.map(|way| cohesion * way - friction.tan() * normal)
        };
        self.lines().map(move |(friction, cohesion)| bears(friction, cohesion))
    }

    /// Checks that a stress state is one the soil can bear.
    pub(super) fn check(
        &self,
        stress: &Stress,
        quantity: &'static str,
        place: impl Fn() -> String,
    ) -> Result<(), CertificateError> {
        let Stress { xx, yy, xy } = *stress;
        self.check_parts((xx + yy).half(), (xx - yy).half(), xy, quantity, place)
    }

    /// The same for a stress given by half the sum and half the difference of its normal parts.
    pub(super) fn check_parts(
        &self,
        mean: Interval,
        half_difference: Interval,
        xy: Interval,
        quantity: &'static str,
        place: impl Fn() -> String,
    ) -> Result<(), CertificateError> {
        let low = self.spare(mean, half_difference, xy);
        if low >= 0.0 {
            Ok(())
        } else {
            Err(CertificateError::NotProven { quantity, place: place(), low, unit: "stress" })
        }
    }
}

impl StressFunction<'_> {
    /// The strength in a triangle at a point.
    pub(super) fn limit(&self, triangle: usize, p: Vector) -> Limit<'_> {
        let strength = &self.problem.strengths[self.tiling.region(triangle)];
        Limit::at(strength, self.divisor, self.splice.as_ref(), p)
    }

    /// Positions of the nodes of a part of a triangle.
    fn nodes(&self, triangle: usize, part: usize) -> [Vector; 3] {
        let corners = self.tiling.corners(triangle);
        let [p, q, r] = corners;
        let sum = p + q + r;
        let centroid = Vector { x: sum.x.third(), y: sum.y.third() };
        [corners[after(part, 1)], corners[after(part, 2)], centroid]
    }

    /// Total stresses at the nodes of a triangle.
    pub(super) fn stresses(&self, triangle: usize) -> NodeStresses {
        let (region, surface) = (self.tiling.region(triangle), self.surfaces.of_triangle(triangle));
        let apex = self.field.corners[triangle].map(|copy| self.apexes[copy]);
        let mut stresses = self.local(triangle).stresses();
        for (k, part) in stresses.iter_mut().enumerate() {
            for (node, (stress, p)) in part.iter_mut().zip(self.nodes(triangle, k)).enumerate() {
                // Exactly, which arithmetic would not show.
                if surface != AT_REST && node < 2 && apex[after(k, 1 + node)] {
                    let water = self.surfaces.water(surface);
                    *stress = water.map_or(Stress::ZERO, |water| Stress::ZERO.with_mean(-water.enclosed(p)));
                    continue;
                }
                let more = self.surfaces.stress(surface, region, p);
                stress.xx = stress.xx + more.xx;
                stress.yy = stress.yy + more.yy;
                stress.xy = stress.xy + more.xy;
            }
        }
        stresses
    }

    /// Whether the effective stress at a corner is exactly zero, which arithmetic would not show: the stress there is the pressure of the
    /// water on the surface, and that is the pore pressure of the same soil.
    fn bears_nothing(&self, triangle: usize, corner: usize) -> bool {
        let surface = self.surfaces.of_triangle(triangle);
        let strength = &self.problem.strengths[self.tiling.region(triangle)];
        let is_apex = self.apexes[self.field.corners[triangle][corner]];
        surface != AT_REST && is_apex && self.surfaces.water(surface) == Some(strength.pore_pressure)
    }

    /// Checks that the soil bears the stresses of a triangle. They are linear in each part, as are cohesion and pore
    /// pressure, and the states that a soil bears are a convex set of all these together, so the nodes decide.
    pub(super) fn check_strength(
        &self,
        triangle: usize,
        stresses: &NodeStresses,
    ) -> Result<(), CertificateError> {
        for (k, part) in stresses.iter().enumerate() {
            for (node, (stress, p)) in part.iter().zip(self.nodes(triangle, k)).enumerate() {
                let place = || {
                    let node = ["its first corner", "its last corner", "the centroid"][node];
                    format!("triangle {triangle}, part at edge {k}, {node}")
                };
                let limit = self.limit(triangle, p);
                if node < 2 && self.bears_nothing(triangle, after(k, 1 + node)) {
                    let dry = Limit { pore_pressure: Interval::ZERO, ..limit };
                    dry.check(&Stress::ZERO, "strength to spare", place)?;
                } else {
                    limit.check(stress, "strength to spare", place)?;
                }
            }
        }
        Ok(())
    }
}
