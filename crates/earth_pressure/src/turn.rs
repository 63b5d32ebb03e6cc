//! Sums of angles by the addition formulas, so that each angle's sine and cosine are computed once.

use std::ops::{Add, Neg, Sub};

/// An angle as its sine and cosine.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Turn {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
}

impl Turn {
    pub(crate) fn of(radians: f64) -> Self {
        let (sin, cos) = libm::sincos(radians);
        Self { sin, cos }
    }

    /// The angle between 0 and 180 degrees with this cotangent.
    pub(crate) fn with_cotangent(cotangent: f64) -> Self {
        let sin = 1.0 / (1.0 + cotangent * cotangent).sqrt();
        Self { sin, cos: cotangent * sin }
    }

    /// 180 degrees less the angle.
    pub(crate) fn supplement(self) -> Self {
        Self { sin: self.sin, cos: -self.cos }
    }
}

impl Add for Turn {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }
}

impl Neg for Turn {
    type Output = Self;

    fn neg(self) -> Self {
        Self { sin: -self.sin, cos: self.cos }
    }
}

impl Sub for Turn {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
