//! The user's clock. Nothing else in this crate decides by time, and a run that it changed says [`Ended::Time`](super::Ended).

use web_time::Instant;

/// Time since the start of a run, and the user's limit on it.
#[derive(Debug)]
pub(crate) struct Clock {
    start: Instant,
    limit: Option<f64>,
}

impl Clock {
    /// Starts now; `limit` is in seconds.
    pub(crate) fn start(limit: Option<f64>) -> Self {
        Self { start: Instant::now(), limit }
    }

    /// Seconds since the start.
    pub(crate) fn elapsed(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// Seconds left, none without a limit.
    pub(crate) fn left(&self) -> Option<f64> {
        self.limit.map(|limit| (limit - self.elapsed()).max(0.0))
    }

    /// Whether something that takes so many seconds still fits.
    pub(crate) fn allows(&self, seconds: f64) -> bool {
        self.left().is_none_or(|left| left > 0.0 && seconds <= left)
    }
}
