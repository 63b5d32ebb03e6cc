use std::f64::consts::PI;

use super::Interval;

/// Sine and cosine of an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Angle {
    pub(crate) sin: Interval,
    pub(crate) cos: Interval,
}

impl Angle {
    pub(crate) fn tan(self) -> Interval {
        self.sin / self.cos
    }

    /// Any number if the angle is zero.
    pub(crate) fn cot(self) -> Interval {
        self.cos / self.sin
    }

    /// `x cot`, for a cohesion the tension at the apex of its cone; nothing of nothing, also if the angle is zero.
    pub(crate) fn cot_times(self, x: Interval) -> Interval {
        if x.is_zero() { x } else { x * self.cot() }
    }
}

/// Sine and cosine of an angle in degrees, from 0 up to 90. The platform's functions come without a guarantee.
pub(crate) fn angle(degrees: f64) -> Angle {
    if degrees <= 45.0 {
        let (sin, cos) = small(Interval::point(degrees));
        Angle { sin, cos }
    } else {
        let (cos, sin) = small(Interval::point(90.0) - Interval::point(degrees));
        Angle { sin, cos }
    }
}

/// Sine and cosine from 0 to 45 degrees.
fn small(degrees: Interval) -> (Interval, Interval) {
    // The double nearest to pi is below pi.
    let pi = Interval::new(PI, PI.next_up());
    let x = degrees * pi / Interval::point(180.0);
    let xx = x.square();
    (x * series(xx, 1.0), series(xx, 0.0))
}

/// `1 - xx/((n+1)(n+2)) (1 - xx/((n+3)(n+4)) (...))` for `xx` from 0 to 1: the sine over its argument for `n` = 1, the
/// cosine for `n` = 0. What is left out after the last bracket is, like all of them, between 0 and 1.
fn series(xx: Interval, n: f64) -> Interval {
    (0..13).rev().fold(Interval::new(0.0, 1.0), |bracket, k| {
        let m = n + 2.0 * f64::from(k);
        Interval::ONE - xx * bracket / Interval::point((m + 1.0) * (m + 2.0))
    })
}
