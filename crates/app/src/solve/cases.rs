//! Bounds on each of the cases of a problem file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_jobs::each;
use soilctl_limit_analysis::describe::Case;
use web_time::Instant;

use super::answer::gap;
use super::{Asked, Request, Solved, one};
use crate::limits::Budget;
use crate::watch::OneOfMany;
use crate::{AppError, Interrupted, Watch};

/// What was found for one case of a problem file, or one value of its sweeps.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CaseAnswer {
    /// Its name: that of the case, and the values of the sweeps.
    pub name: String,
    /// The values that it sets, by parameter.
    pub values: BTreeMap<String, f64>,
    /// Lower bound, over the partial factor on resistance; null if there are no bounds.
    pub lower: Option<f64>,
    /// Upper bound, likewise.
    pub upper: Option<f64>,
    /// As that of the whole answer.
    pub gap: Option<f64>,
    /// Whether both bounds are proven.
    pub certified: bool,
    /// Whether a factor is proven to be one or more: what the case asks for. Null if the bounds do not tell, and where forces or
    /// accelerations are bounded.
    pub enough: Option<bool>,
    /// Why there are no bounds; null if there are.
    pub problem: Option<String>,
}

impl CaseAnswer {
    fn of(case: &Case) -> Self {
        Self {
            name: case.name.clone(),
            values: case.values.clone(),
            lower: None,
            upper: None,
            gap: None,
            certified: false,
            enough: None,
            problem: Some("it was not begun before the run was ended".into()),
        }
    }

    fn solved(mut self, solved: &mut Solved, resistance: f64) -> Self {
        let answer = &mut solved.answer;
        if resistance != 1.0 {
            // One rounding, outwards.
            answer.lower = (answer.lower / resistance).next_down();
            answer.upper = (answer.upper / resistance).next_up();
            answer.gap = gap(answer.lower, answer.upper);
        }
        let is_factor = match answer.quantity {
            Asked::LoadFactor | Asked::WeightFactor | Asked::FactorOfSafety => true,
            Asked::ForceKnPerM | Asked::AccelerationOverG => false,
        };
        self.enough = match (answer.lower >= 1.0, answer.upper < 1.0) {
            (true, _) if is_factor => Some(true),
            (_, true) if is_factor => Some(false),
            _ => None,
        };
        self.problem = None;
        Self {
            lower: Some(answer.lower),
            upper: Some(answer.upper),
            gap: answer.gap,
            certified: answer.certified,
            ..self
        }
    }
}

/// The file of a case for `--save`: its number goes before the ending.
fn save_as(path: &Path, index: usize) -> PathBuf {
    path.with_extension(format!("{}.json", index + 1))
}

/// The time that is left, shared among the cases that are left.
fn share(budget: &Budget, begun: Instant, left: usize) -> Option<f64> {
    let seconds = budget.max_seconds? - begun.elapsed().as_secs_f64();
    let at_once = (budget.threads as usize).clamp(1, left.max(1));
    Some((seconds * at_once as f64 / left.max(1) as f64).max(1e-3))
}

/// What was found, and the least bound with its solution.
struct Found {
    cases: Vec<CaseAnswer>,
    governing: Option<(usize, Solved)>,
    work: u64,
    /// Why the first that was not saved was not.
    unsaved: Option<AppError>,
}

impl Found {
    fn add(&mut self, index: usize, case: &Case, result: Result<Solved, AppError>) {
        match result {
            Ok(mut solved) => {
                self.cases[index] = CaseAnswer::of(case).solved(&mut solved, case.resistance);
                self.work += solved.answer.work;
                self.unsaved = self.unsaved.take().or(solved.unsaved.take());
                let lower = solved.answer.lower;
                let is_less = self.governing.as_ref().is_none_or(|(other, least)| {
                    lower < least.answer.lower || (lower == least.answer.lower && index < *other)
                });
                if is_less {
                    self.governing = Some((index, solved));
                }
            }
            Err(problem) => self.cases[index].problem = Some(problem.to_string()),
        }
    }
}

/// Bounds all cases. The bounds of the answer are the least of all cases, its fields those of the case with the least lower bound.
pub(super) fn run(request: &Request, cases: &[Case], watch: &dyn Watch) -> Result<Solved, AppError> {
    let begun = Instant::now();
    let stop = watch.stop(Interrupted::KeepsResults);
    let left = AtomicUsize::new(cases.len());
    let mut found =
        Found { cases: cases.iter().map(CaseAnswer::of).collect(), governing: None, work: 0, unsaved: None };
    let todo: Vec<(usize, &Case)> = cases.iter().enumerate().collect();
    let work = |(index, case): &(usize, &Case)| -> Result<_, AppError> {
        let left = left.fetch_sub(1, Ordering::Relaxed);
        let seconds = share(&request.budget, begun, left);
        let budget = Budget { threads: 1, max_seconds: seconds, ..request.budget.clone() };
        let save = request.save.as_ref().map(|path| save_as(path, *index));
        let watch = OneOfMany { watch, name: Some(&case.name) };
        Ok(Some(one(&budget, save.as_deref(), case.description.clone(), &watch)))
    };
    watch.begin(cases.len() as u64, "cases");
    let done = each(&todo, request.budget.threads as usize, &stop, work, |(index, case), result| {
        watch.advance(1);
        found.add(*index, case, result);
        Ok(())
    });
    watch.end();
    done?;
    let Found { cases, governing, work, unsaved } = found;
    let unsolved: Vec<&CaseAnswer> = cases.iter().filter(|case| case.problem.is_some()).collect();
    let why = |case: &CaseAnswer| format!("{}: {}", case.name, case.problem.as_deref().unwrap_or_default());
    let Some((index, mut solved)) = governing else {
        let why: Vec<String> = unsolved.iter().map(|case| why(case)).collect();
        return Err(AppError::Request(format!("no case has bounds: {}", why.join("; "))));
    };
    for case in &unsolved {
        watch.note(&format!("no bounds for {}; the least bounds are those of the others", why(case)));
    }
    solved.unsaved = unsaved;
    let answer = &mut solved.answer;
    answer.upper = cases.iter().filter_map(|case| case.upper).fold(answer.upper, f64::min);
    answer.gap = gap(answer.lower, answer.upper);
    answer.certified = unsolved.is_empty() && cases.iter().all(|case| case.certified);
    answer.governing = Some(cases[index].name.clone());
    answer.work = work;
    answer.seconds = begun.elapsed().as_secs_f64();
    answer.cases = cases;
    Ok(solved)
}
