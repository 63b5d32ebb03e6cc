//! Positions on a page.

/// A position on the page in px, y downwards.
pub(crate) type Px = (f64, f64);

/// Hundredths of a px are finer than can be seen, also in print.
pub(crate) fn rounded(px: f64) -> f64 {
    // The sum turns a negative zero into zero.
    (px * 100.0).round() / 100.0 + 0.0
}
