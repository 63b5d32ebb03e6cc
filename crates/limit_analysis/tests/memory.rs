//! A run stays within the memory that it was given. The only test of its process, whose peak it reads.
#![allow(clippy::unwrap_used, reason = "a test")]

use soilctl_limit_analysis::{EmbeddedPlate, Ended, LimitError, Options, bound};

/// Peak memory of this process in bytes, where the system tells.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM"))?;
    Some(1024 * line.split_whitespace().nth(1)?.parse::<u64>().ok()?)
}

#[test]
fn a_run_ends_before_it_leaves_its_memory() {
    let problem = EmbeddedPlate { delta_deg: 15.0, ..EmbeddedPlate::default() }.problem().unwrap();
    for (max_memory_bytes, threads) in [(300_000_000, 1), (400_000_000, 2)] {
        let options =
            Options { max_gap: 0.0, max_work: u64::MAX, max_memory_bytes, threads, ..Options::default() };
        let bounds = bound(&problem, &options, &mut |_, _| {}).unwrap();
        assert_eq!(bounds.ended, Ended::Memory);
        // It uses what it has: more than the first mesh.
        assert!(bounds.levels.len() > 1);
        assert!(peak().is_none_or(|p| p < max_memory_bytes), "{:?} of {max_memory_bytes}", peak());
    }
    let none = Options { max_memory_bytes: 1_000_000, ..Options::default() };
    assert!(matches!(bound(&problem, &none, &mut |_, _| {}), Err(LimitError::NothingProven { .. })));
}
