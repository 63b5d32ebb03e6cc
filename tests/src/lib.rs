//! What the cross-crate tests share: the repository's data files, the tables that the documentation shows, and random numbers.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::path::PathBuf;

/// A small reproducible generator (splitmix64), so that the soils are the same on every machine.
#[derive(Debug)]
pub struct Random(pub u64);

impl Random {
    /// Between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// Path of a file in `data/`.
#[must_use]
pub fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../data").join(name)
}

/// A file of `docs/verification`, from which its page is made, holds these numbers to the last digit that it has; with
/// `SOILCTL_ROWS=write` (`cargo xtask rows`) it is written. Lines are what they begin with and their numbers.
///
/// # Panics
/// If they differ, or the file cannot be read or written.
pub fn shown(file: &str, header: &str, lines: &[(String, Vec<f64>)]) {
    const DIGITS: usize = 4;
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../docs/verification").join(file);
    if std::env::var_os("SOILCTL_ROWS").is_some_and(|value| value == "write") {
        let line = |(key, numbers): &(String, Vec<f64>)| {
            let numbers: Vec<_> = numbers.iter().map(|n| format!("{n:.DIGITS$}")).collect();
            format!("{key},{}\n", numbers.join(","))
        };
        let text: String = lines.iter().map(line).collect();
        std::fs::write(path, format!("{header}\n{text}")).unwrap();
        return;
    }
    let text = std::fs::read_to_string(path).unwrap();
    let mut kept = text.lines();
    let advice = "if that is right, `cargo xtask rows` writes docs/verification anew";
    assert_eq!(kept.next(), Some(header), "{file}; {advice}");
    assert_eq!(kept.clone().count(), lines.len(), "{file}; {advice}");
    for ((key, numbers), line) in lines.iter().zip(kept) {
        let there =
            line.strip_prefix(key.as_str()).unwrap_or_else(|| panic!("{file}: {line}, not {key}; {advice}"));
        let there: Vec<f64> = there.split(',').skip(1).map(|n| n.parse().unwrap()).collect();
        assert_eq!(there.len(), numbers.len(), "{file}: {line}; {advice}");
        for (a, b) in there.iter().zip(numbers) {
            assert!((a - b).abs() <= 0.6e-4, "{file}: {line}, now {numbers:?}; {advice}");
        }
    }
}
