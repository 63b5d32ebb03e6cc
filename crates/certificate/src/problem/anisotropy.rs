//! Strength of clay that depends on the direction of the stress.
//!
//! With `c` the cohesion, the states of stress that are borne are an ellipse around `((xx - yy)/2, xy) = (c e, 0)` with the half-axes `c a` and
//! `c b`. A strain rate without dilation, with `g = exx - eyy` and `h = 2 exy`, takes up `(xx - yy)/2 g + xy h`, at most
//! `c (e g + sqrt((a g)^2 + (b h)^2))`. So all that is proven for one strength in all directions holds with the distance from the middle over
//! the half-axes in place of the radius of Mohr's circle, and with that directed rate in place of the shear rate.

use crate::interval::{Interval, Vector};
use crate::statement;

/// The ellipse for a cohesion of one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Anisotropy {
    middle: Interval,
    level: Interval,
    shear: Interval,
}

impl Anisotropy {
    pub(crate) fn new(of: &statement::Anisotropy) -> Self {
        let passive = Interval::point(of.passive);
        Self {
            middle: (Interval::ONE - passive).half(),
            level: (Interval::ONE + passive).half(),
            shear: Interval::point(of.shear),
        }
    }

    /// Half the difference of the normal stresses and the shear stress as they count where there is one strength in all directions.
    pub(crate) fn round(&self, cohesion: Interval, half_difference: Interval, xy: Interval) -> [Interval; 2] {
        [(half_difference - self.middle * cohesion) / self.level, xy / self.shear]
    }

    /// The greatest shear stress along `t` for a cohesion of one, times the square of `t`: forwards and backwards on the soil to its left.
    pub(crate) fn along(&self, t: Vector) -> [Interval; 2] {
        let [difference, shear] = Self::sheared(t);
        [self.rate(difference, shear), self.rate(-difference, -shear)]
    }

    /// What a thin layer along `t` takes up for a cohesion of one, from the slip of the soil to its left.
    pub(crate) fn of_slip(&self, t: Vector, slip: Interval) -> Interval {
        let [difference, shear] = Self::sheared(t).map(|rate| rate / t.square());
        self.rate(difference * slip, shear * slip)
    }

    /// `exx - eyy` and `2 exy` of a unit of slip along `t` in a layer, times the square of `t`. With `n` the unit vector to the left of `t`, strain
    /// rates are half of `n t' + t n'`.
    fn sheared(t: Vector) -> [Interval; 2] {
        [-(Interval::point(2.0) * t.x * t.y), t.x.square() - t.y.square()]
    }

    /// What a strain rate takes up for a cohesion of one, from `exx - eyy` and `2 exy`. It is convex, and twice the rate takes up twice as much.
    pub(crate) fn rate(&self, difference: Interval, shear: Interval) -> Interval {
        if difference.is_zero() && shear.is_zero() {
            return Interval::ZERO;
        }
        let length = ((self.level * difference).square() + (self.shear * shear).square()).sqrt();
        (self.middle * difference + length).or_zero()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the greatest `t . stress . n`, with `n` to the left of `t`, of all states on the ellipse, found by trying.
    #[test]
    fn shear_along_a_direction_is_the_greatest_of_all_states_either_way() {
        let (passive, shear) = (0.4, 0.7);
        let it = Anisotropy::new(&statement::Anisotropy { passive, shear });
        for t in [[1.0, 0.0], [0.0, -2.0], [1.0, 1.0], [1.0, -1.0], [-3.0, 1.0], [0.3, 2.0]] {
            let [x, y] = t;
            let on_left = |turn: f64| {
                let difference = 0.5 * (1.0 - passive) + 0.5 * (1.0 + passive) * turn.cos();
                let xy = shear * turn.sin();
                // The mean stress shears nothing.
                difference * (-x * y) - difference * (y * x) + xy * (x * x - y * y)
            };
            let all = || (0..=20_000).map(|i| on_left(f64::from(i) * std::f64::consts::TAU / 20_000.0));
            let found = [all().fold(f64::MIN, f64::max), -all().fold(f64::MAX, f64::min)];
            for (bears, best) in it.along(Vector::point(t)).into_iter().zip(found) {
                assert!(best <= bears.hi() && bears.lo() <= best * (1.0 + 1e-6), "{t:?}: {bears:?} {best}");
            }
            let slips = [1.0, -1.0].map(|slip| it.of_slip(Vector::point(t), Interval::point(slip)));
            for (takes, best) in slips.into_iter().zip(found) {
                let best = best / (x * x + y * y);
                assert!(best <= takes.hi() && takes.lo() <= best * (1.0 + 1e-6), "{t:?}: {takes:?} {best}");
            }
        }
    }
}
