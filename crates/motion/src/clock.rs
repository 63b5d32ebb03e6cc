//! One clock for messages that carry a stamp of their sender and the time at which they were logged.
//!
//! Stamps tell more exactly when something was measured, the log's time when it was received. As long as the two differ by a
//! nearly constant latency, stamps are taken. A sender whose clock was set meanwhile shows as a step of that difference: from
//! there on stamps are moved by the step, so that the log's time decides on how much time has passed.

use soilctl_stats::median;

/// The latency of a message may differ from that of its neighbours by so much before its sender's clock is suspected, in ns.
const MOST_JITTER_NS: i64 = 250_000_000;
/// Stamps that are older than the log's time by more than this are no late messages but wrong, in ns.
const MOST_DELAY_NS: i64 = 30_000_000_000;
/// So many messages with one and the same new difference are a step, fewer are stragglers.
const CONFIRMED: usize = 20;

/// A message's two times, in ns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Times {
    /// Stamp of the sender; `None` if it was not set.
    pub stamp_ns: Option<i64>,
    /// When it was logged.
    pub logged_ns: i64,
}

/// A step of a sender's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// When, by the repaired clock, in ns.
    pub at_ns: i64,
    /// By how much the clock was set ahead, in ns; negative if back.
    pub by_ns: i64,
}

/// The times of a topic on one clock.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Repaired {
    /// When each message was measured, in ns, in the order given.
    pub times_ns: Vec<i64>,
    /// What the log's time is ahead of the stamps before any step, in ns: the latency, if both clocks agree. `None` without stamps.
    pub latency_ns: Option<i64>,
    /// Steps of the sender's clock.
    pub steps: Vec<Step>,
    /// Messages without a stamp, which got the log's time less the latency.
    pub unstamped: u64,
    /// Messages whose stamp lies after they were logged, or long before, and which got the log's time as well.
    pub wrong_stamps: u64,
    /// Messages that stand behind a later one.
    pub disordered: u64,
}

/// Stamps from this one on, in s, are taken to be those of a wall clock; times count from the whole second before the first.
pub const WALL_CLOCK_S: i64 = 1_000_000;
/// Clocks of two senders that differ by more than this are not the same clock, in ns.
const SAME_CLOCK_NS: i64 = 1_000_000_000;

/// The one clock of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Clock {
    /// Where it begins, in s of the stamps: 0, or a whole second of a wall clock.
    pub origin_s: i64,
    /// By how much the log's time is ahead of it in ns; `None` if that is not known.
    pub latency_ns: Option<i64>,
}

impl Clock {
    /// A clock with its origin at the whole second before the first time, if that is one of a wall clock.
    #[must_use]
    pub fn beginning(first_ns: Option<i64>, latency_ns: Option<i64>) -> Self {
        let first_s = first_ns.map_or(0, |ns| ns.div_euclid(1_000_000_000));
        Self { origin_s: if first_s >= WALL_CLOCK_S { first_s } else { 0 }, latency_ns }
    }

    /// A time in ns of the stamps as s on this clock.
    #[must_use]
    pub fn seconds(&self, ns: i64) -> f64 {
        let origin_ns = self.origin_s.saturating_mul(1_000_000_000);
        #[allow(
            clippy::cast_precision_loss,
            reason = "a tenth of a microsecond after ten years from the origin"
        )]
        let since = ns.saturating_sub(origin_ns) as f64;
        since * 1e-9
    }

    /// A time in s on this clock as ns of the stamps.
    #[must_use]
    pub fn ns(&self, t_s: f64) -> i64 {
        #[allow(clippy::cast_possible_truncation, reason = "saturates")]
        let since = (t_s * 1e9).round() as i64;
        self.origin_s.saturating_mul(1_000_000_000).saturating_add(since)
    }

    /// A time of the log in ns as s on this clock.
    #[must_use]
    pub fn seconds_of_log(&self, logged_ns: i64) -> f64 {
        self.seconds(logged_ns.saturating_sub(self.latency_ns.unwrap_or(0)))
    }

    /// The times of a topic's messages in ns of the stamps, on this clock.
    #[must_use]
    pub fn place(&self, messages: &[Times]) -> Repaired {
        let mut repaired = repair(messages);
        repaired.onto(self.latency_ns);
        repaired
    }
}

impl Repaired {
    /// Moves a topic onto a clock that the log's time is ahead of by `latency_ns`, unless it is on it already.
    pub(crate) fn onto(&mut self, latency_ns: Option<i64>) {
        let Some(latency_ns) = latency_ns else { return };
        let own_ns = self.latency_ns.unwrap_or(0);
        let apart_ns = own_ns.saturating_sub(latency_ns);
        if self.latency_ns.is_none() || apart_ns.saturating_abs() > SAME_CLOCK_NS {
            self.times_ns.iter_mut().for_each(|time| *time = time.saturating_add(apart_ns));
        }
    }
}

/// Puts the messages of a topic, in the order of the log, on one clock.
#[must_use]
pub fn repair(messages: &[Times]) -> Repaired {
    if log_is_of_no_use(messages) {
        let stamped = messages.iter().map(|m| Times { logged_ns: m.stamp_ns.unwrap_or(m.logged_ns), ..*m });
        let mut found = with_log(&stamped.collect::<Vec<_>>());
        found.latency_ns = None;
        return found;
    }
    with_log(messages)
}

/// Whether all was logged within a fraction of the time over which it was measured, as when a converter wrote the log.
fn log_is_of_no_use(messages: &[Times]) -> bool {
    let typical = |times: &mut dyn Iterator<Item = i64>| -> f64 {
        let mut times: Vec<i64> = times.collect();
        times.sort_unstable();
        #[allow(clippy::cast_precision_loss, reason = "a nanosecond in a million is nothing")]
        let mut steps: Vec<f64> =
            times.windows(2).map(|pair| pair[1].saturating_sub(pair[0]) as f64).collect();
        median(&mut steps)
    };
    let logged = || messages.iter().map(|m| m.logged_ns);
    let stamped = typical(&mut messages.iter().filter_map(|m| m.stamp_ns));
    let span = logged().max().unwrap_or(0).saturating_sub(logged().min().unwrap_or(0));
    #[allow(clippy::cast_precision_loss, reason = "a nanosecond in a million is nothing")]
    let (span, expected) = (span as f64, stamped * messages.len() as f64);
    typical(&mut logged()) < 0.1 * stamped && span < 0.5 * expected
}

fn with_log(messages: &[Times]) -> Repaired {
    let mut order: Vec<usize> = (0..messages.len()).collect();
    // Parts of a log need not follow one another in time.
    order.sort_by_key(|k| messages[*k].logged_ns);
    let stamped: Vec<(usize, i64)> = order
        .iter()
        .filter_map(|k| Some((*k, messages[*k].logged_ns.saturating_sub(messages[*k].stamp_ns?))))
        .collect();
    let logged: Vec<i64> = stamped.iter().map(|(k, _)| messages[*k].logged_ns).collect();
    let levels = levels(&stamped.iter().map(|(_, difference)| *difference).collect::<Vec<_>>(), &logged);
    let latency_ns = levels.first().map(|level| level.difference_ns);
    let unstamped = (messages.len() - stamped.len()) as u64;
    let mut times_ns: Vec<i64> =
        messages.iter().map(|m| m.logged_ns.saturating_sub(latency_ns.unwrap_or(0))).collect();
    let (mut steps, mut wrong_stamps) = (Vec::new(), 0);
    for (number, level) in levels.iter().enumerate() {
        let moved = level.difference_ns.saturating_sub(latency_ns.unwrap_or(0));
        for (k, difference_ns) in &stamped[level.from..level.to] {
            let late_ns = difference_ns.saturating_sub(level.difference_ns);
            if (-MOST_JITTER_NS..MOST_DELAY_NS).contains(&late_ns) {
                times_ns[*k] = messages[*k].stamp_ns.unwrap_or_default().saturating_add(moved);
            } else {
                wrong_stamps += 1;
            }
        }
        if let Some(before) = number.checked_sub(1).and_then(|n| levels.get(n))
            && let Some((first, _)) = stamped.get(level.from)
        {
            let by_ns = before.difference_ns.saturating_sub(level.difference_ns);
            steps.push(Step { at_ns: times_ns[*first], by_ns });
        }
    }
    let mut latest = i64::MIN;
    let disordered = times_ns.iter().filter(|time| {
        let behind = **time < latest;
        latest = latest.max(**time);
        behind
    });
    let disordered = disordered.count() as u64;
    Repaired { times_ns, latency_ns, steps, unstamped, wrong_stamps, disordered }
}

/// Messages `from..to` that share a difference of the two clocks.
struct Level {
    from: usize,
    to: usize,
    difference_ns: i64,
}

/// Cuts the differences, in the order of the log's times, where they step and stay.
fn levels(differences_ns: &[i64], logged_ns: &[i64]) -> Vec<Level> {
    let mut found = Vec::new();
    let (mut from, mut k) = (0, 0);
    let mut usual = middle(differences_ns.get(..differences_ns.len().min(CONFIRMED)).unwrap_or_default());
    while let Some(now) = differences_ns.get(k) {
        let ahead = &differences_ns[k..differences_ns.len().min(k + CONFIRMED)];
        let near = |level: i64, value: i64| value.saturating_sub(level).saturating_abs() <= MOST_JITTER_NS;
        // What a stalled network held back comes all at once, each message with another difference.
        let held_back = || {
            let drift_ns = ahead[CONFIRMED - 1].saturating_sub(ahead[0]).saturating_abs();
            drift_ns > logged_ns[k + CONFIRMED - 1].saturating_sub(logged_ns[k])
        };
        let stays = ahead.len() == CONFIRMED
            && ahead.iter().all(|value| near(*now, *value) && !near(usual, *value))
            && !held_back();
        if stays {
            found.push(Level { from, to: k, difference_ns: usual });
            (from, usual) = (k, middle(ahead));
        } else if near(usual, *now) {
            // Clocks run apart slowly.
            usual += (now - usual) / 64;
        }
        k += 1;
    }
    if !differences_ns.is_empty() {
        found.push(Level { from, to: differences_ns.len(), difference_ns: usual });
    }
    for level in &mut found {
        level.difference_ns = middle(&differences_ns[level.from..level.to]);
    }
    found
}

#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    reason = "differences beyond 100 days may lose a ns"
)]
fn middle(values_ns: &[i64]) -> i64 {
    let Some(first) = values_ns.first() else { return 0 };
    let mut apart: Vec<f64> = values_ns.iter().map(|value| value.saturating_sub(*first) as f64).collect();
    first.saturating_add(median(&mut apart) as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: i64 = 1_000_000_000;

    /// Messages every 10 ms, logged 3 ms later.
    fn messages(count: i64) -> Vec<Times> {
        (0..count)
            .map(|k| {
                let stamp = 1_700_000_000 * SECOND + k * 10_000_000;
                Times { stamp_ns: Some(stamp), logged_ns: stamp + 3_000_000 + 1000 * (k % 7) }
            })
            .collect()
    }

    #[test]
    fn stamps_are_kept_where_nothing_is_wrong() {
        let messages = messages(200);
        let found = repair(&messages);
        assert!(found.steps.is_empty() && found.unstamped == 0 && found.disordered == 0);
        let stamps: Vec<_> = messages.iter().filter_map(|m| m.stamp_ns).collect();
        assert_eq!(found.times_ns, stamps);
    }

    #[test]
    fn a_clock_that_is_set_is_moved_back() {
        for by in [-3600 * SECOND, -2 * SECOND, SECOND, 500_000 * SECOND] {
            let whole = messages(300);
            let mut set = whole.clone();
            set[120..].iter_mut().for_each(|m| m.stamp_ns = m.stamp_ns.map(|ns| ns + by));
            let found = repair(&set);
            assert_eq!(found.steps.len(), 1);
            assert!((found.steps[0].by_ns - by).abs() < 10_000, "{by}: {:?}", found.steps);
            for (time, message) in found.times_ns.iter().zip(&whole) {
                assert!((time - message.stamp_ns.unwrap()).abs() < 10_000);
            }
        }
    }

    #[test]
    fn a_stalled_network_is_no_step() {
        let mut held = messages(300);
        // For 2 s nothing gets through, then all at once.
        let released = held[200].logged_ns;
        held[100..200].iter_mut().for_each(|m| m.logged_ns = released);
        let found = repair(&held);
        assert!(found.steps.is_empty());
        assert!(found.times_ns.iter().zip(&held).all(|(time, m)| Some(*time) == m.stamp_ns));
    }

    #[test]
    fn without_stamps_the_logs_time_counts() {
        let mut bare = messages(50);
        bare.iter_mut().for_each(|m| m.stamp_ns = None);
        let found = repair(&bare);
        assert_eq!((found.unstamped, found.latency_ns), (50, None));
        assert!(found.times_ns.iter().zip(&bare).all(|(time, m)| *time == m.logged_ns));
        let mut some = messages(100);
        some[40].stamp_ns = None;
        let found = repair(&some);
        assert!((found.times_ns[40] - messages(100)[40].stamp_ns.unwrap()).abs() < 10_000);
        some.swap(3, 5);
        assert_eq!(repair(&some).disordered, 2);
        assert_eq!(repair(&[]), Repaired::default());
    }

    #[test]
    fn a_log_that_was_written_at_once_says_nothing_of_time() {
        let mut converted = messages(500);
        for (k, message) in (0..).zip(&mut converted) {
            message.logged_ns = 1_800_000_000 * SECOND + k;
        }
        let found = repair(&converted);
        assert!(found.steps.is_empty() && found.wrong_stamps == 0 && found.latency_ns.is_none());
        assert!(found.times_ns.iter().zip(&converted).all(|(time, m)| Some(*time) == m.stamp_ns));
    }

    #[test]
    fn times_at_the_ends_of_the_range_do_not_overflow() {
        let odd = [i64::MIN, -1, 0, 1, i64::MAX];
        let messages: Vec<Times> = odd
            .iter()
            .flat_map(|stamp| odd.map(|logged| Times { stamp_ns: Some(*stamp), logged_ns: logged }))
            .collect();
        assert_eq!(repair(&messages).times_ns.len(), 25);
    }
}
