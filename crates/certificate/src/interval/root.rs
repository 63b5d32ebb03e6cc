use super::Interval;

impl Interval {
    /// Its square root, for numbers that are at least zero. The hardware's root is the double nearest to the true one.
    pub(crate) fn sqrt(self) -> Self {
        // Roots of squares of small whole numbers are exact.
        let exact = |root: f64| root.fract() == 0.0 && root < 67_108_864.0;
        let root = |x: f64| x.max(0.0).sqrt();
        let known = |x: f64| exact(root(x)) && root(x) * root(x) == x.max(0.0);
        let down = |x: f64| if known(x) { root(x) } else { root(x).next_down().max(0.0) };
        let up = |x: f64| if known(x) { root(x) } else { root(x).next_up() };
        Self { lo: down(self.lo), hi: up(self.hi) }
    }

    /// Its absolute value.
    pub(crate) fn abs(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Self { lo: 0.0, hi: self.hi.max(-self.lo) }
        }
    }

    /// Itself, or zero if it is below that.
    pub(crate) fn or_zero(self) -> Self {
        Self { lo: self.lo.max(0.0), hi: self.hi.max(0.0) }
    }

    /// The one with the lesser upper end: of two numbers that are both not below a third, the better bound.
    pub(crate) fn or_lesser(self, other: Self) -> Self {
        if other.hi < self.hi { other } else { self }
    }
}
