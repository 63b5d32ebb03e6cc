//! Strength of clay that depends on the direction of the stress.
//!
//! With `c` the cohesion, the states of stress that are borne are an ellipse around `((xx - yy)/2, xy) = (c e, 0)` with the half-axes `c a` and
//! `c b`. A strain rate without dilation, with `g = exx - eyy` and `h = 2 exy`, takes up `(xx - yy)/2 g + xy h`, at most
//! `c (e g + sqrt((a g)^2 + (b h)^2))`. So all that is proven for one strength in all directions holds with the distance from the middle over
//! the half-axes in place of the radius of Mohr's circle, and with that directed rate in place of the shear rate.

use crate::interval::Interval;
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

    /// What a strain rate takes up for a cohesion of one, from `exx - eyy` and `2 exy`. It is convex, and twice the rate takes up twice as much.
    pub(crate) fn rate(&self, difference: Interval, shear: Interval) -> Interval {
        if difference.is_zero() && shear.is_zero() {
            return Interval::ZERO;
        }
        let length = ((self.level * difference).square() + (self.shear * shear).square()).sqrt();
        (self.middle * difference + length).or_zero()
    }
}
