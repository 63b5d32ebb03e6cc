use std::time::Duration;

use soilctl_controller::TICK_RATE_HZ;

use crate::real_time::{SERVO_PRIORITY, fifo, lock_memory, now_ns, sleep_until};
use crate::timing::Timing;

/// Length of a tick in ns.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "2 000 000")]
const PERIOD_NS: u64 = (1e9 / TICK_RATE_HZ) as u64;

/// Wakes a thread at absolute deadlines, one tick apart, so that lateness does not add up.
pub(crate) struct Clock {
    next_ns: u64,
    began_ns: u64,
    timing: Timing,
}

impl Clock {
    /// A clock for the calling thread, which becomes a real-time thread with locked memory as far as that is permitted.
    pub(crate) fn start() -> Self {
        let timing = Timing { fifo: fifo(SERVO_PRIORITY), locked: lock_memory(), ..Timing::default() };
        let now = now_ns();
        Self { next_ns: now + PERIOD_NS, began_ns: now, timing }
    }

    /// Waits for the next deadline. One that is over is an overrun; the ticks that were missed are given up, so that the
    /// thread does not run without a pause to catch up.
    pub(crate) fn wait(&mut self) {
        let before = now_ns();
        if self.timing.lateness.total() > 0 {
            self.timing.busy.add(Duration::from_nanos(before.saturating_sub(self.began_ns)));
        }
        if before > self.next_ns {
            self.timing.overruns += 1;
            let skipped = (before - self.next_ns) / PERIOD_NS;
            self.timing.skipped += skipped;
            self.next_ns += skipped * PERIOD_NS;
        } else {
            sleep_until(self.next_ns);
        }
        self.began_ns = now_ns();
        self.timing.lateness.add(Duration::from_nanos(self.began_ns.saturating_sub(self.next_ns)));
        self.next_ns += PERIOD_NS;
    }

    pub(crate) const fn timing(&self) -> &Timing {
        &self.timing
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No bound on lateness: only that deadlines stand where they should.
    #[test]
    fn ticks_come_at_their_rate() {
        let mut clock = Clock::start();
        let start = now_ns();
        let first = clock.next_ns;
        for _ in 0..50 {
            clock.wait();
            assert!(clock.began_ns + PERIOD_NS >= clock.next_ns, "not before its deadline");
        }
        let timing = *clock.timing();
        assert_eq!(timing.lateness.total(), 50);
        assert_eq!(clock.next_ns, first + (50 + timing.skipped) * PERIOD_NS);
        assert!(now_ns() - start >= 49 * PERIOD_NS);
    }

    #[test]
    fn a_late_tick_is_an_overrun_and_missed_ones_are_given_up() {
        let mut clock = Clock::start();
        clock.wait();
        std::thread::sleep(Duration::from_nanos(4 * PERIOD_NS));
        clock.wait();
        let timing = clock.timing();
        assert!(timing.overruns >= 1 && timing.skipped >= 2, "{timing:?}");
        assert!(clock.next_ns > now_ns(), "it does not run after the clock");
    }
}
