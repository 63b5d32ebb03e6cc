//! Which value to try next. Places are parts of the way from one end to the other, 0 to 1.

use super::answer::{Found, Verdict};

/// What is known so far.
#[derive(Debug, Clone)]
pub(super) struct Search {
    tried: Vec<(f64, Verdict)>,
    /// How near to each other both answers shall be.
    within: f64,
    most: usize,
}

impl Search {
    pub(super) fn new(within: f64, most: usize) -> Self {
        Self { tried: Vec::new(), within, most }
    }

    pub(super) fn add(&mut self, part: f64, verdict: Verdict) {
        self.tried.push((part, verdict));
        self.tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    }

    /// The next place to try; both ends first.
    pub(super) fn next(&self) -> Option<f64> {
        if self.tried.len() >= self.most {
            return None;
        }
        let is_tried = |part: f64| self.tried.iter().any(|(tried, _)| *tried == part);
        if let Some(end) = [0.0, 1.0].into_iter().find(|end| !is_tried(*end)) {
            return Some(end);
        }
        if !self.is_between() {
            return None;
        }
        // The widest step over which the verdict changes, if it is wider than asked for.
        let steps = self.tried.windows(2).filter(|w| w[0].1 != w[1].1);
        let widest = steps.max_by(|a, b| (a[1].0 - a[0].0).total_cmp(&(b[1].0 - b[0].0)))?;
        (widest[1].0 - widest[0].0 > self.within).then(|| 0.5 * (widest[0].0 + widest[1].0))
    }

    /// Whether one end is enough and the other is not proven to be.
    fn is_between(&self) -> bool {
        match (self.tried.first(), self.tried.last()) {
            (Some((_, a)), Some((_, b))) => (*a == Verdict::Enough) != (*b == Verdict::Enough),
            _ => false,
        }
    }

    /// The value that is enough and nearest to those that are not.
    pub(super) fn enough(&self) -> Option<f64> {
        let is_first = self.tried.first()?.1 == Verdict::Enough;
        let enough =
            self.tried.iter().filter(|(_, verdict)| *verdict == Verdict::Enough).map(|(part, _)| *part);
        match (self.is_between(), is_first) {
            // From the end that is enough, as far as it is without a break.
            (true, true) => {
                self.tried.iter().take_while(|(_, v)| *v == Verdict::Enough).last().map(|(part, _)| *part)
            }
            (true, false) => self
                .tried
                .iter()
                .rev()
                .take_while(|(_, v)| *v == Verdict::Enough)
                .last()
                .map(|(part, _)| *part),
            (false, _) => enough.reduce(f64::min),
        }
    }

    /// The value that is not enough and nearest to that.
    pub(super) fn not_enough(&self) -> Option<f64> {
        let enough = self.enough();
        let not =
            self.tried.iter().filter(|(_, verdict)| *verdict == Verdict::NotEnough).map(|(part, _)| *part);
        match enough {
            Some(at) => not.min_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs())),
            None => not.reduce(f64::max),
        }
    }

    /// How it ended.
    pub(super) fn found(&self, is_stopped: bool) -> Found {
        let ends: Vec<Verdict> =
            [self.tried.first(), self.tried.last()].into_iter().flatten().map(|(_, v)| *v).collect();
        if self.tried.len() < 2 {
            return Found::Undecided;
        }
        match ends[..] {
            [Verdict::Enough, Verdict::Enough] => Found::BothEnough,
            [Verdict::NotEnough, Verdict::NotEnough] if self.enough().is_none() => Found::NeitherEnough,
            _ if !self.is_between() => Found::Undecided,
            _ if !self.is_in_order() => Found::NotInOrder,
            _ => {
                let apart = self.enough().zip(self.not_enough()).map(|(a, b)| (a - b).abs());
                match apart {
                    Some(apart) if apart <= self.within => Found::Within,
                    // What is left is open at the given gap.
                    Some(_) if !is_stopped && self.next().is_none() && self.tried.len() < self.most => {
                        Found::Open
                    }
                    _ => Found::Undecided,
                }
            }
        }
    }

    /// Whether values are enough from some place on, and not enough up to some other.
    fn is_in_order(&self) -> bool {
        let rank = |verdict: Verdict| match verdict {
            Verdict::NotEnough => 0,
            Verdict::Open => 1,
            Verdict::Enough => 2,
        };
        let ranks: Vec<i32> = self.tried.iter().map(|(_, verdict)| rank(*verdict)).collect();
        ranks.is_sorted() || ranks.iter().rev().is_sorted()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// What comes out where values below `low` are not enough and those from `high` on are.
    fn searched(low: f64, high: f64, within: f64, turned: bool) -> (Option<f64>, Option<f64>, Found, usize) {
        let mut search = Search::new(within, 40);
        while let Some(part) = search.next() {
            let at = if turned { 1.0 - part } else { part };
            let verdict = match at {
                at if at < low => Verdict::NotEnough,
                at if at >= high => Verdict::Enough,
                _ => Verdict::Open,
            };
            search.add(part, verdict);
        }
        (search.not_enough(), search.enough(), search.found(false), search.tried.len())
    }

    #[test]
    fn both_answers_are_as_near_as_was_asked() {
        for turned in [false, true] {
            let (not, enough, found, count) = searched(0.37, 0.37, 0.01, turned);
            let at = if turned { 0.63 } else { 0.37 };
            let (not, enough) = (not.unwrap(), enough.unwrap());
            assert!((enough - not).abs() <= 0.01 && (enough - at).abs() <= 0.01 && (not - at).abs() <= 0.01);
            assert_eq!(found, Found::Within);
            assert!(count <= 10);
        }
    }

    #[test]
    fn what_the_bounds_leave_open_is_found_from_both_sides() {
        let (not, enough, found, _) = searched(0.3, 0.45, 0.01, false);
        let (not, enough) = (not.unwrap(), enough.unwrap());
        assert!((0.29..0.3).contains(&not) && (0.45..=0.46).contains(&enough), "{not} {enough}");
        assert_eq!(found, Found::Open);
    }

    #[test]
    fn ends_alone_may_tell() {
        assert_eq!(searched(2.0, 3.0, 0.1, false), (Some(1.0), None, Found::NeitherEnough, 2));
        let (_, enough, found, count) = searched(-2.0, -1.0, 0.1, false);
        assert_eq!((enough, found, count), (Some(0.0), Found::BothEnough, 2));
        assert_eq!(searched(-1.0, 2.0, 0.1, false).2, Found::Undecided);
    }

    #[test]
    fn values_out_of_order_are_told() {
        let mut search = Search::new(0.01, 10);
        for (part, verdict) in [
            (0.0, Verdict::NotEnough),
            (1.0, Verdict::Enough),
            (0.5, Verdict::Enough),
            (0.75, Verdict::NotEnough),
        ] {
            search.add(part, verdict);
        }
        assert_eq!(search.found(true), Found::NotInOrder);
        assert_eq!(search.enough(), Some(1.0));
    }
}
