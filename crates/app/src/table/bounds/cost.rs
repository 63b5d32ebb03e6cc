//! How long cases take.

use std::time::Instant;

use soilctl_earth_pressure::table::BracketRules;

use super::cases::Node;
use super::journal::Entry;
use crate::text::duration;

/// Times of this table's cases: a formula fitted to measured ones, scaled by what was measured here.
#[derive(Debug)]
pub(super) struct Cost {
    rules: BracketRules,
    /// Measured over estimated time.
    scale: f64,
    /// Number of cases behind the scale.
    pub(super) measured: usize,
}

impl Cost {
    pub(super) fn new(rules: BracketRules, known: &[Entry]) -> Self {
        let (mut spent, mut estimated, mut measured) = (0.0, 0.0, 0);
        for entry in known {
            if let Some(seconds) = entry.seconds {
                spent += seconds;
                estimated += seconds_here(rules, entry.node());
                measured += 1;
            }
        }
        Self { rules, scale: if estimated > 0.0 { spent / estimated } else { 1.0 }, measured }
    }

    /// Estimated time of a case in seconds.
    pub(super) fn seconds(&self, node: Node) -> f64 {
        self.scale * seconds_here(self.rules, node)
    }

    pub(super) fn time_left(&self, todo: &[Node], threads: usize) -> TimeLeft<'_> {
        let left = todo.iter().map(|node| self.seconds(*node)).sum();
        TimeLeft { cost: self, start: Instant::now(), cases: todo.len(), done: 0, past: 0.0, left, threads }
    }
}

/// Time of a case in seconds, on one core of the machine it was fitted on. Of 50 measured cases (alpha 85 deg, phi 20 to
/// 50 deg, delta 0 to 30 deg, gaps of 5 and 1 %, 1500 to 12000 elements) each is met within a factor of 3.2 and the sum
/// within 11 %. A case refines until its gap is reached or its elements are spent; more friction and rougher plates need
/// more of them.
fn seconds_here(rules: BracketRules, [_, phi, delta]: Node) -> f64 {
    let rough = delta / phi;
    let for_one_percent = 3000.0 * (phi / 30.0) * (1.0 + 1.6 * rough * rough);
    let needed = for_one_percent * (0.01 / rules.max_gap).powf(0.55);
    let elements = needed.max(600.0).min(rules.max_elements as f64);
    2.0 * (phi / 40.0) * (elements / 1000.0).powf(1.3)
}

/// The time left of a run.
#[derive(Debug)]
pub(super) struct TimeLeft<'a> {
    cost: &'a Cost,
    start: Instant,
    cases: usize,
    done: usize,
    /// Estimated work of the cases done and of those left, in seconds.
    past: f64,
    left: f64,
    threads: usize,
}

impl TimeLeft<'_> {
    pub(super) fn done(&mut self, entry: &Entry) {
        let seconds = self.cost.seconds(entry.node());
        self.done += 1;
        self.past += seconds;
        self.left = (self.left - seconds).max(0.0);
    }

    pub(super) fn words(&self) -> String {
        // In the beginning, before every thread has finished a few cases, the estimate says more than the clock.
        let pace = if self.done < 3 * self.threads {
            1.0 / self.threads as f64
        } else {
            self.start.elapsed().as_secs_f64() / self.past
        };
        format!("{} of {} cases, {} left", self.done, self.cases, duration(pace * self.left))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_elements_and_smaller_gaps_never_cost_less() {
        for phi in [20.0, 35.0, 55.0] {
            for delta in [0.0, phi / 2.0, phi] {
                let at = |max_gap, max_elements| {
                    seconds_here(BracketRules { max_gap, max_elements }, [80.0, phi, delta])
                };
                for gap in [0.1, 0.02, 0.003] {
                    assert!(at(gap, 1000) <= at(gap, 5000) && at(gap, 5000) <= at(gap, 50_000));
                    assert!(at(gap, 5000) <= at(gap / 2.0, 5000));
                }
            }
        }
    }
}
