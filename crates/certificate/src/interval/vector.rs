use std::ops::{Add, Mul, Neg, Sub};

use super::Interval;

/// A vector in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vector {
    pub(crate) x: Interval,
    pub(crate) y: Interval,
}

impl Vector {
    pub(crate) const ZERO: Self = Self { x: Interval::ZERO, y: Interval::ZERO };

    /// Exactly the vector with these components.
    pub(crate) fn point([x, y]: [f64; 2]) -> Self {
        Self { x: x.into(), y: y.into() }
    }

    pub(crate) fn dot(self, other: Self) -> Interval {
        self.x * other.x + self.y * other.y
    }

    /// Whether it is zero and nothing else.
    pub(crate) fn is_zero(self) -> bool {
        self.x.is_zero() && self.y.is_zero()
    }

    /// Square of the length.
    pub(crate) fn square(self) -> Interval {
        self.x.square() + self.y.square()
    }

    /// Positive if `other` points to the left of `self`.
    pub(crate) fn cross(self, other: Self) -> Interval {
        self.x * other.y - self.y * other.x
    }

    /// A quarter turn to the left.
    pub(crate) fn turned(self) -> Self {
        Self { x: -self.y, y: self.x }
    }
}

impl Add for Vector {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl Sub for Vector {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl Neg for Vector {
    type Output = Self;

    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

impl Mul<Interval> for Vector {
    type Output = Self;

    fn mul(self, factor: Interval) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}
