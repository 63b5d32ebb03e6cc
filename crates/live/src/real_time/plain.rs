use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// Time since it was first asked for.
pub(crate) fn now_ns() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

/// Sleeps to an instant of [`now_ns`]; the system may sleep longer by what its timers are worth.
pub(crate) fn sleep_until(deadline_ns: u64) {
    std::thread::sleep(Duration::from_nanos(deadline_ns.saturating_sub(now_ns())));
}

/// No real-time priority is asked for.
pub(crate) const fn fifo(_priority: u8) -> bool {
    false
}

/// No memory is locked.
pub(crate) const fn lock_memory() -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_does_not_wake_before_its_deadline() {
        let deadline = now_ns() + 3_000_000;
        sleep_until(deadline);
        assert!(now_ns() >= deadline);
        sleep_until(deadline);
    }
}
