//! How much memory a level needs, before it is built.
//!
//! Nearly all of it is the factor of the solver's system and what leads to it, whose size grows as `n log n` with the
//! elements of a plane mesh. Peaks of whole runs on a footing on sand, at 917, 1,459 and 2,940 elements, were 46, 73 and
//! 147 MB; on an embedded plate, at 864, 1,550 and 3,370 elements, 49, 118 and 172 MB: 4 to 5 kB times `n log2 n`.

/// More than the greatest measured, in bytes.
const PER_ELEMENT: f64 = 7e3;

/// What the process needs without any.
const BASE: f64 = 16e6;

/// An upper estimate, in bytes, for a level of so many elements.
fn bytes(elements: f64, both_at_once: bool) -> f64 {
    let one = PER_ELEMENT * elements * elements.max(2.0).log2();
    BASE + if both_at_once { 2.0 * one } else { one }
}

/// The most elements that fit; infinite where memory is not limited. With `both_at_once` two programs are solved at the
/// same time.
pub(super) fn capacity(max_bytes: u64, both_at_once: bool) -> f64 {
    if max_bytes == u64::MAX {
        return f64::INFINITY;
    }
    let fits = |elements: f64| bytes(elements, both_at_once) <= max_bytes as f64;
    if !fits(1.0) {
        return 0.0;
    }
    let (mut low, mut high) = (1.0, max_bytes as f64 / PER_ELEMENT + 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if fits(middle) { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_fits_fits_and_little_more_does_not() {
        for max in [20_000_000, 200_000_000, 8_000_000_000_u64] {
            for both in [false, true] {
                let most = capacity(max, both);
                assert!(bytes(most, both) <= max as f64 && bytes(1.01 * most + 1.0, both) > max as f64);
            }
        }
        assert_eq!(capacity(1_000_000, false), 0.0);
        assert_eq!(capacity(u64::MAX, true), f64::INFINITY);
    }
}
