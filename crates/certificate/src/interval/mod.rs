//! Intervals with ends rounded outwards: if the arguments of an operation lie in their intervals, the true result lies
//! in the interval returned.

mod root;
mod rounding;
#[cfg(test)]
pub(crate) mod tests;
mod trigonometry;
mod vector;

use std::ops::{Add, Div, Mul, Neg, Sub};

pub(crate) use trigonometry::{Angle, angle};
pub(crate) use vector::Vector;

use rounding::{add_down, div_down, mul_down};

/// All numbers from `lo` to `hi`. Neither is NaN, `lo <= hi`, `lo < inf`, `hi > -inf`.
///
/// An interval stands for one finite number that is not known better. Hence zero times any interval is zero, exactly.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Interval {
    lo: f64,
    hi: f64,
}

impl Interval {
    pub(crate) const ZERO: Self = Self { lo: 0.0, hi: 0.0 };
    pub(crate) const ONE: Self = Self { lo: 1.0, hi: 1.0 };
    /// Any number: nothing can be proven with it.
    const ANY: Self = Self { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Exactly `x`; any number if that is not finite.
    pub(crate) const fn point(x: f64) -> Self {
        if x.is_finite() { Self { lo: x, hi: x } } else { Self::ANY }
    }

    /// From `lo` to `hi`; any number if that is not an interval.
    pub(crate) const fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi && lo < f64::INFINITY && hi > f64::NEG_INFINITY { Self { lo, hi } } else { Self::ANY }
    }

    /// Lower end.
    pub(crate) fn lo(self) -> f64 {
        self.lo
    }

    /// Upper end.
    pub(crate) fn hi(self) -> f64 {
        self.hi
    }

    /// A number in the middle, as good as any where nothing is to be proven.
    pub(crate) fn middle(self) -> f64 {
        0.5 * self.lo + 0.5 * self.hi
    }

    /// Whether it is zero and nothing else.
    pub(crate) fn is_zero(self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    /// Whether it is proven to be at least zero.
    pub(crate) fn is_at_least_zero(self) -> bool {
        self.lo >= 0.0
    }

    /// Whether it is proven to be above zero.
    pub(crate) fn is_positive(self) -> bool {
        self.lo > 0.0
    }

    /// Whether it is proven not to be zero.
    pub(crate) fn is_not_zero(self) -> bool {
        self.lo > 0.0 || self.hi < 0.0
    }

    /// Its square, which is never negative.
    pub(crate) fn square(self) -> Self {
        let product = self * self;
        Self { lo: product.lo.max(0.0), hi: product.hi }
    }

    /// Half of it.
    pub(crate) fn half(self) -> Self {
        self * Self::point(0.5)
    }

    /// A third of it.
    pub(crate) fn third(self) -> Self {
        self / Self::point(3.0)
    }
}

impl From<f64> for Interval {
    fn from(x: f64) -> Self {
        Self::point(x)
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { lo: add_down(self.lo, other.lo), hi: -add_down(-self.hi, -other.hi) }
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let up = |x: f64, y: f64| -mul_down(-x, y);
        // Which ends make the extreme products follows from the signs.
        match (a.lo >= 0.0, a.hi <= 0.0, b.lo >= 0.0, b.hi <= 0.0) {
            (true, _, true, _) => Self { lo: mul_down(a.lo, b.lo), hi: up(a.hi, b.hi) },
            (true, _, _, true) => Self { lo: mul_down(a.hi, b.lo), hi: up(a.lo, b.hi) },
            (true, ..) => Self { lo: mul_down(a.hi, b.lo), hi: up(a.hi, b.hi) },
            (_, true, ..) => -(-a * b),
            (_, _, true, _) | (_, _, _, true) => b * a,
            _ => Self {
                lo: mul_down(a.lo, b.hi).min(mul_down(a.hi, b.lo)),
                hi: up(a.lo, b.lo).max(up(a.hi, b.hi)),
            },
        }
    }
}

impl Div for Interval {
    type Output = Self;

    /// Any number if the divisor may be zero.
    fn div(self, other: Self) -> Self {
        if other.hi < 0.0 {
            return -self / -other;
        }
        if other.lo <= 0.0 {
            return Self::ANY;
        }
        let low_by = if self.lo >= 0.0 { other.hi } else { other.lo };
        let high_by = if self.hi >= 0.0 { other.lo } else { other.hi };
        Self::new(div_down(self.lo, low_by), -div_down(-self.hi, high_by))
    }
}
