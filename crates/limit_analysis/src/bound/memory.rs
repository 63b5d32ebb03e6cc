//! How much memory a level needs, before it is built.
//!
//! Nearly all of it is the factor of the solver's system and what leads to it, whose size grows as `n log n` with the
//! elements of a plane mesh. Peaks of whole runs on a footing on sand, at 917, 1,459 and 2,940 elements, were 46, 73 and
//! 147 MB; on an embedded plate, at 864, 1,550 and 3,370 elements, 49, 118 and 172 MB: 4 to 5 kB times `n log2 n`.

/// More than the greatest measured, in bytes.
const PER_ELEMENT: f64 = 7e3;

/// What the process needs without any.
const BASE: f64 = 16e6;

/// An upper estimate, in bytes, for the program on so many elements.
fn bytes(elements: f64) -> f64 {
    PER_ELEMENT * elements * elements.max(2.0).log2()
}

/// Whether two programs may be in memory at the same time.
pub(super) fn both_fit(max_bytes: u64, elements: [usize; 2]) -> bool {
    max_bytes == u64::MAX || BASE + elements.map(|n| bytes(n as f64)).iter().sum::<f64>() <= max_bytes as f64
}

/// The most elements of one program that fit; infinite where memory is not limited.
pub(super) fn capacity(max_bytes: u64) -> f64 {
    if max_bytes == u64::MAX {
        return f64::INFINITY;
    }
    let fits = |elements: f64| BASE + bytes(elements) <= max_bytes as f64;
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
            let most = capacity(max);
            let needed = |elements: f64| BASE + bytes(elements);
            assert!(needed(most) <= max as f64 && needed(1.01 * most + 1.0) > max as f64);
            assert!(!both_fit(max, [most as usize; 2]) && both_fit(max, [most as usize / 3; 2]));
        }
        assert_eq!(capacity(1_000_000), 0.0);
        assert_eq!(capacity(u64::MAX), f64::INFINITY);
        assert!(both_fit(u64::MAX, [1_000_000; 2]));
    }
}
