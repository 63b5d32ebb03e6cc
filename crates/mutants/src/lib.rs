//! Files made to do harm, for tests of all that reads files of strangers: whatever byte is wrong, nothing panics or hangs.
//!
//! `SOILCTL_MUTANTS` says how many of each kind are made, 40 without it; `cargo xtask verify` makes 2500. The targets in `fuzz/` look for
//! more from the same corpus.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No mutant of a file of some tens of kB may take longer.
pub const LONGEST: Duration = Duration::from_secs(10);

/// An arm whose joints the recordings of the corpus name.
pub const ARM: &str = include_str!("../../../fuzz/corpus/urdf/arm.urdf");

/// How many mutants of each kind are asked for.
#[must_use]
pub fn count() -> usize {
    std::env::var("SOILCTL_MUTANTS").ok().and_then(|text| text.parse().ok()).unwrap_or(40)
}

/// Recordings in every container, files before folders of split ones, each in the order of their names.
///
/// # Panics
/// If they are not there.
#[must_use]
pub fn recordings() -> (Vec<PathBuf>, Vec<PathBuf>) {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/data");
    let entries = std::fs::read_dir(&data).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
    let is_recording = |path: &PathBuf| path.extension().is_none_or(|ending| ending != "py");
    let mut all: Vec<PathBuf> = entries.filter(is_recording).collect();
    all.sort();
    let (files, folders): (Vec<_>, Vec<_>) = all.into_iter().partition(|path| path.is_file());
    assert!(files.len() >= 8 && !folders.is_empty(), "recordings in {}: {files:?}", data.display());
    (files, folders)
}

/// Asks as many mutants of each file of [`recordings`] as [`count`] says, one after the other; none may take too long.
///
/// # Errors
/// If a file cannot be read or written.
///
/// # Panics
/// If one takes longer than [`LONGEST`].
pub fn each_mutant(seed: u64, mut ask: impl FnMut(&Path)) -> std::io::Result<()> {
    let folder = tempfile::tempdir()?;
    let mut random = Random(seed);
    for file in recordings().0 {
        let bytes = std::fs::read(&file)?;
        let path = folder.path().join(file.file_name().unwrap_or_default());
        for _ in 0..count() {
            std::fs::write(&path, random.mutant(&bytes))?;
            in_time(&path, || ask(&path));
        }
    }
    Ok(())
}

/// Fails if what is done with a file takes too long.
///
/// # Panics
/// If it does.
pub fn in_time(path: &Path, ask: impl FnOnce()) {
    let begun = Instant::now();
    ask();
    let taken = begun.elapsed();
    assert!(taken < LONGEST, "{} takes {taken:?}", path.display());
}

/// A linear congruence, so that a seed makes the same mutants everywhere.
#[derive(Debug, Clone)]
pub struct Random(pub u64);

impl Random {
    /// A number from 0 on and below `end`; 0 if that is 0.
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % end.max(1)
    }

    /// Some bytes changed, cut out or doubled, or the end cut off.
    pub fn mutant(&mut self, bytes: &[u8]) -> Vec<u8> {
        let mut changed = bytes.to_vec();
        for _ in 0..=self.below(8) {
            let at = self.below(changed.len());
            match self.below(5) {
                0 => changed.truncate(at.max(1)),
                1 => {
                    let end = (at + self.below(200)).min(changed.len());
                    let piece = changed.get(at..end).unwrap_or_default().to_vec();
                    changed.splice(at..at, piece);
                }
                2 => drop(changed.drain(at..(at + self.below(64)).min(changed.len()))),
                _ => {
                    if let (Some(byte), Ok(other)) = (changed.get_mut(at), u8::try_from(self.below(256))) {
                        *byte = other;
                    }
                }
            }
            if changed.is_empty() {
                changed.push(0);
            }
        }
        changed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_makes_the_same_mutants_and_they_differ() {
        let bytes: Vec<u8> = (0..=255).collect();
        let made = |seed: u64| {
            let mut random = Random(seed);
            (0..100).map(|_| random.mutant(&bytes)).collect::<Vec<_>>()
        };
        assert_eq!(made(1), made(1));
        assert!(made(1).iter().filter(|mutant| **mutant != bytes).count() > 95);
        assert!(made(1).iter().any(|mutant| mutant.len() > bytes.len()));
        assert_eq!(Random(1).mutant(&[]).len(), 1);
    }
}
