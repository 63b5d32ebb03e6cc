//! Sums, products and quotients of doubles, rounded down.
//!
//! The standard library has no directed rounding. The nearest double is at most one step from the true value, so one
//! step down is below it. The step is left out where the operation is known to be exact; this keeps zeros that
//! cancel exactly, and a sum of small integers, free of noise. Rounding up is rounding down of the opposite.

/// A number not above `a + b`.
pub(super) fn add_down(a: f64, b: f64) -> f64 {
    let sum = a + b;
    // The error of the sum, exactly (Knuth, The Art of Computer Programming 2, section 4.2.2), unless it overflows.
    let b_part = sum - a;
    let error = (a - (sum - b_part)) + (b - b_part);
    if error >= 0.0 && error.is_finite() { sum } else { sum.next_down() }
}

/// A number not above `a b`. Zero times infinity is zero: infinite ends stand for finite numbers of any size.
pub(super) fn mul_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let product = a * b;
    if product_is_exact(a, b, product) { product } else { product.next_down() }
}

/// A number not above `a / b`, `b` not zero.
pub(super) fn div_down(a: f64, b: f64) -> f64 {
    if a == 0.0 {
        return 0.0;
    }
    let quotient = a / b;
    let back = quotient * b;
    if back == a && product_is_exact(quotient, b, back) { quotient } else { quotient.next_down() }
}

/// Whether the significant bits of both factors, of which there are up to 53 each, are few enough for the product.
fn product_is_exact(a: f64, b: f64, product: f64) -> bool {
    /// Below, bits may be lost to underflow.
    const LEAST: f64 = 1e-290;
    let zeros = |x: f64| (x.to_bits() | 1 << 52).trailing_zeros();
    let (a_zeros, b_zeros) = (zeros(a), zeros(b));
    let few = a_zeros + b_zeros >= 53 || a_zeros == 52 || b_zeros == 52;
    few && a.abs() > LEAST && b.abs() > LEAST && product.abs() > LEAST && product.is_finite()
}
