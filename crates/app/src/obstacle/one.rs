//! One problem after the other, and what each says against that without the body.

use std::sync::atomic::Ordering;

use soilctl_limit_analysis::{Description, OneSide};
use web_time::Instant;

use super::{DistanceAnswer, Request};
use crate::files::numbered;
use crate::limits::Budget;
use crate::solve::{self, Solved};
use crate::watch::OneOfMany;
use crate::{AppError, Interrupted, Watch};

/// What was found of all problems.
pub(super) struct Series {
    pub(super) without: Solved,
    pub(super) rows: Vec<DistanceAnswer>,
    pub(super) work: u64,
    pub(super) unsaved: Option<AppError>,
}

impl Series {
    /// Bounds the problem without the body, then those with it at each distance.
    pub(super) fn run(
        request: &Request,
        alone: Description,
        with: Vec<(f64, Description)>,
        watch: &dyn Watch,
    ) -> Result<Self, AppError> {
        let begun = Instant::now();
        let all = watch.stop(Interrupted::KeepsResults);
        let count = with.len();
        let one = |left: usize, word: &str, description: Description| {
            // What is left of the time is shared among what is left to do.
            let share = |seconds: f64| ((seconds - begun.elapsed().as_secs_f64()) / left as f64).max(1e-3);
            let budget =
                Budget { max_seconds: request.budget.max_seconds.map(share), ..request.budget.clone() };
            let save = request.save.as_deref().map(|path| numbered(path, word));
            let watch = OneOfMany { watch, name: None };
            solve::one_or_side(&budget, save.as_deref(), description, &watch)
        };
        watch.begin(1 + count as u64, "distances");
        let without = one(1 + count, "without", alone);
        watch.advance(1);
        let mut series = match without {
            Ok(without) => Self { work: without.answer.work, without, rows: Vec::new(), unsaved: None },
            Err((_, problem)) => {
                watch.end();
                return Err(*problem);
            }
        };
        series.unsaved = series.without.unsaved.take();
        for (index, (ahead_m, description)) in with.into_iter().enumerate() {
            let found = if all.load(Ordering::Relaxed) {
                Err((None, Box::new(AppError::Request("the run was ended before this distance".into()))))
            } else {
                one(count - index, &(index + 1).to_string(), description)
            };
            series.add(ahead_m, found);
            watch.advance(1);
        }
        watch.end();
        Ok(series)
    }

    fn add(&mut self, ahead_m: f64, found: Result<Solved, (Option<OneSide>, Box<AppError>)>) {
        let (bounds, problem) = match found {
            Ok(mut found) => {
                self.work += found.answer.work;
                self.unsaved = self.unsaved.take().or(found.unsaved.take());
                (newtons(&found).map(Some), None)
            }
            Err((Some(OneSide::Lower(lower)), problem)) => {
                ([Some((1e3 * lower).next_down()), None], Some(problem))
            }
            Err((Some(OneSide::Upper(upper)), problem)) => {
                ([None, Some((1e3 * upper).next_up())], Some(problem))
            }
            Err((None, problem)) => ([None; 2], Some(problem)),
        };
        let problem = problem.map(|problem| problem.to_string());
        self.rows.push(DistanceAnswer { problem, ..row(ahead_m, bounds, newtons(&self.without)) });
    }
}

/// Bounds in N/m, rounded outwards.
pub(super) fn newtons(solved: &Solved) -> [f64; 2] {
    [(1e3 * solved.answer.lower).next_down(), (1e3 * solved.answer.upper).next_up()]
}

/// The force at a distance, against that without the body. Soil that sticks to a body at rest may not move there, and strength in the place of soil of
/// the same weight takes motions away: all flows with the body are flows without it as well. So the force is no less with it.
fn row(ahead_m: f64, [own, upper]: [Option<f64>; 2], [least, most]: [f64; 2]) -> DistanceAnswer {
    let lower_is_without = own.is_none_or(|own| own < least);
    let lower = if lower_is_without { Some(least) } else { own };
    // Forces over forces say something only if both are pushes.
    let is_push = least > 0.0;
    let ratio = |bound: Option<f64>, other: f64| bound.filter(|_| is_push).map(|bound| bound / other);
    let gap = lower.zip(upper).filter(|(l, u)| l * u > 0.0).map(|(l, u)| (2.0 * (u - l) / (u + l)).abs());
    DistanceAnswer {
        ahead_m,
        lower_n_per_m: lower,
        upper_n_per_m: upper,
        ratio_lower: ratio(lower, most).map(|ratio| ratio.next_down().max(1.0)),
        ratio_upper: ratio(upper, least).map(f64::next_up),
        gap,
        lower_is_without,
        problem: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_holds_without_the_body_holds_with_it() {
        let row_of = |found| row(0.1, found, [10.0, 11.0]);
        let low = row_of([Some(9.0), Some(12.0)]);
        assert_eq!((low.lower_n_per_m, low.lower_is_without), (Some(10.0), true));
        assert_eq!(low.ratio_lower, Some(1.0));
        assert!(low.ratio_upper.is_some_and(|ratio| (ratio - 1.2).abs() < 1e-12 && ratio > 1.2));
        let none = row_of([None; 2]);
        assert_eq!((none.lower_n_per_m, none.upper_n_per_m, none.ratio_upper), (Some(10.0), None, None));
        let near = row_of([Some(22.0), None]);
        assert!(!near.lower_is_without && near.gap.is_none());
        assert!(near.ratio_lower.is_some_and(|ratio| ratio <= 2.0 && ratio > 1.999));
    }
}
