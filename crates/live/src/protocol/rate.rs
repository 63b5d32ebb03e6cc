use std::time::Instant;

/// Lines that a client may send in a second, in the long run.
pub const LINES_PER_SECOND: u32 = 100;
/// Lines that it may send at once.
pub const BURST_LINES: u32 = 200;

/// Bounds how many lines a client may send.
#[derive(Debug)]
pub struct Rate {
    left: f64,
    last: Instant,
}

impl Rate {
    /// A client that has said nothing yet.
    #[must_use]
    pub fn new(now: Instant) -> Self {
        Self { left: f64::from(BURST_LINES), last: now }
    }

    /// Whether one more line is allowed now.
    pub fn allow(&mut self, now: Instant) -> bool {
        let passed_s = now.saturating_duration_since(self.last).as_secs_f64();
        self.last = now;
        self.left = (self.left + passed_s * f64::from(LINES_PER_SECOND)).min(f64::from(BURST_LINES));
        if self.left < 1.0 {
            return false;
        }
        self.left -= 1.0;
        true
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;

    #[test]
    fn a_burst_is_allowed_and_then_the_rate() {
        let start = Instant::now();
        let mut rate = Rate::new(start);
        let at_once = (0..1000).filter(|_| rate.allow(start)).count();
        assert_eq!(at_once, 200);
        let later = (1..=10_000).filter(|&n| rate.allow(start + Duration::from_millis(n))).count();
        assert!((999..=1001).contains(&later), "{later}");
    }
}
