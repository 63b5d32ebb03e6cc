//! The least of something that is enough: an anchor's strength, a water level, or how far from one drawing towards another.
//!
//! One value is tried after another, each with proven bounds: it is enough if the lower bound reaches what is wanted, and not enough if the upper
//! bound does not. Between the two answers there may be values whose bounds lie on both sides; sharper bounds make their range smaller.

mod answer;
mod between;
mod request;
mod search;

use std::path::Path;
use std::sync::atomic::Ordering;

use soilctl_limit_analysis::describe::SweepEntry;
use soilctl_limit_analysis::{Decision, Description, LimitError, Options, Reach, decide};
use web_time::Instant;

pub use answer::{Answer, Found, Tried, Verdict};
pub use request::Request;

use crate::files::{can_be_written, refuse_over, save};
use crate::limits::{self, Budget};
use crate::solve::{self, Asked};
use crate::{AppError, Interrupted, Unwatched, Watch};
use between::Between;
use search::Search;

/// Values that share the time that is left.
const AT_ONCE: usize = 5;

/// What changes from one value to the next.
enum Changes {
    Parameter { file: Box<Description>, name: String },
    Drawings(Between),
}

/// Searches the least value that is enough.
///
/// # Errors
/// [`AppError`] if the request or a file makes no sense, or the problem does not at one of the ends.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    if let Some(out) = &request.out {
        can_be_written(out)?;
        refuse_over(out, request.replace)?;
    }
    let (changes, [from, to]) = changes(request)?;
    let place = |part: f64| if part == 1.0 { to } else { from + (to - from) * part };
    let begun = Instant::now();
    let stop = watch.stop(Interrupted::KeepsResults);
    let within = request.within.unwrap_or(0.01 * (to - from).abs()) / (to - from).abs();
    let mut search = Search::new(within.clamp(1e-9, 1.0), request.most as usize);
    let mut tried: Vec<Tried> = Vec::new();
    let title = description(&changes, from)?.title;
    // Before the first proof, which may take minutes.
    let asked_at = |end: f64| match solve::check::of(description(&changes, end)?, &Unwatched) {
        Ok(checked) => Ok(checked.answer.quantity),
        Err(problem) => Err(AppError::Request(format!("at {end}: {problem}"))),
    };
    asked_at(from)?;
    let quantity = asked_at(to)?;
    if quantity == Asked::FactorOfSafety && request.wanted <= 0.0 {
        let problem = format!(
            "--wanted is {}, and a factor of safety is above 0; give what it must reach",
            request.wanted
        );
        return Err(AppError::Request(problem));
    }
    let mut is_stopped = false;
    while let Some(part) = search.next() {
        let value = place(part);
        let left_s = request.budget.max_seconds.map(|all| all - begun.elapsed().as_secs_f64());
        if stop.load(Ordering::Relaxed) || left_s.is_some_and(|left| left <= 0.0) {
            is_stopped = true;
            break;
        }
        // How many more there will be is not known; each may take a part of what is left.
        let max_seconds = left_s.map(|left| left / (request.most as usize - tried.len()).min(AT_ONCE) as f64);
        let budget = Budget { max_seconds, ..request.budget.clone() };
        let one = at(&changes, value, request.wanted, &budget, watch)?;
        search.add(part, one.verdict);
        tried.push(one);
    }
    tried.sort_by(|a, b| a.value.total_cmp(&b.value));
    let mut answer = Answer {
        title,
        quantity,
        parameter: request.parameter.clone(),
        wanted: request.wanted,
        found: search.found(is_stopped),
        enough_at: None,
        not_enough_at: None,
        tried,
        seconds: begun.elapsed().as_secs_f64(),
        verdict: String::new(),
    };
    answer.enough_at = search.enough().map(place);
    answer.not_enough_at = search.not_enough().map(place);
    answer.verdict = answer.words();
    if let Some(out) = &request.out {
        write(&changes, &answer, out)?;
    }
    Ok(answer)
}

/// What changes, and between which values.
fn changes(request: &Request) -> Result<(Changes, [f64; 2]), AppError> {
    let wrong = |words: &str| Err(AppError::Request(words.into()));
    match (&request.other, &request.parameter, request.from_value, request.to_value) {
        (Some(other), None, None, None) => {
            Ok((Changes::Drawings(Between::read(&request.file, other)?), [0.0, 1.0]))
        }
        (Some(_), _, _, _) => wrong(
            "a second problem file goes without --parameter, --from and --to: all numbers go from one file to the other",
        ),
        (None, Some(name), Some(from), Some(to)) if from != to => {
            let file = Box::new(Description::read(&request.file).map_err(LimitError::from)?);
            Ok((Changes::Parameter { file, name: name.clone() }, [from, to]))
        }
        (None, Some(_), Some(_), Some(_)) => {
            wrong("--from and --to are one value; nothing changes between them")
        }
        (None, _, _, _) => {
            wrong("give --parameter with --from and --to, or a second problem file to go towards")
        }
    }
}

fn description(changes: &Changes, value: f64) -> Result<Description, AppError> {
    match changes {
        Changes::Parameter { file, name } => {
            let mut description = (**file).clone();
            let sweep = SweepEntry { parameter: name.clone(), values: vec![value], ..SweepEntry::default() };
            description.sweeps.push(sweep);
            Ok(description)
        }
        Changes::Drawings(between) => between.at(value),
    }
}

/// What is proven at a value, over all cases of the file: all of them must have enough.
fn at(
    changes: &Changes,
    value: f64,
    wanted: f64,
    budget: &Budget,
    watch: &dyn Watch,
) -> Result<Tried, AppError> {
    let description = description(changes, value)?;
    let has_cases = !description.cases.is_empty();
    let cases = description.cases().map_err(LimitError::from)?;
    let problems: Vec<(&str, f64, &Description)> = if cases.is_empty() {
        vec![("", 1.0, &description)]
    } else {
        cases.iter().map(|case| (case.name.as_str(), case.resistance, &case.description)).collect()
    };
    let begun = Instant::now();
    let mut tried = Tried {
        value,
        lower: Some(f64::INFINITY),
        upper: None,
        case: None,
        verdict: Verdict::Enough,
        why: None,
    };
    for (index, (name, resistance, problem)) in problems.iter().enumerate() {
        let left_s = budget.max_seconds.map(|all| (all - begun.elapsed().as_secs_f64()).max(1e-3));
        let max_seconds = left_s.map(|left| left / (problems.len() - index) as f64);
        let options = Budget { max_seconds, ..budget.clone() }.options(watch)?;
        match decision(problem, wanted * resistance, &options, watch) {
            Ok(decision) => tried.add(name, *resistance, &decision),
            // Both ends make sense, so what was found so far is worth keeping.
            Err(problem) => tried.leave_open(name, problem.to_string()),
        }
        // One case without enough is enough to know.
        if tried.verdict == Verdict::NotEnough {
            break;
        }
    }
    tried.case = tried.case.filter(|_| has_cases);
    Ok(tried)
}

impl Tried {
    /// One more of the cases.
    fn add(&mut self, name: &str, resistance: f64, decision: &Decision) {
        // One rounding, outwards.
        let over = |bound: f64, outwards: fn(f64) -> f64| {
            if resistance == 1.0 { bound } else { outwards(bound / resistance) }
        };
        let lower = decision.lower.map(|bound| over(bound, f64::next_down));
        let upper = decision.upper.map(|bound| over(bound, f64::next_up));
        self.lower = self.lower.zip(lower).map(|(a, b)| a.min(b));
        self.upper = self.upper.into_iter().chain(upper).reduce(f64::min);
        match decision.reach {
            Reach::Reached => {}
            Reach::Missed => {
                (self.verdict, self.case, self.why) = (Verdict::NotEnough, Some(name.to_owned()), None);
            }
            Reach::Open => self.leave_open(name, decision.ended.to_string()),
        }
    }

    /// One of the cases is open; the first one is told.
    fn leave_open(&mut self, name: &str, why: String) {
        if self.verdict == Verdict::Enough {
            (self.verdict, self.case, self.why) = (Verdict::Open, Some(name.to_owned()), Some(why));
        }
    }
}

/// The problem file with the value that is enough.
fn write(changes: &Changes, answer: &Answer, out: &Path) -> Result<(), AppError> {
    let Some(value) = answer.enough_at else { return Ok(()) };
    let mut description = description(changes, value)?;
    if let Changes::Parameter { file, .. } = changes {
        // Cases and sweeps stay, and the value is set as a case would set it.
        description.cases.clear();
        description.sweeps.drain(..file.sweeps.len());
        let set = description.cases().map_err(LimitError::from)?.into_iter().next();
        description = set.map_or_else(|| (**file).clone(), |case| case.description);
        description.cases.clone_from(&file.cases);
        description.sweeps.clone_from(&file.sweeps);
    }
    save(out, description.to_toml().map_err(LimitError::from)?.as_bytes())
}

/// Whether what a description asks for reaches a value.
fn decision(
    description: &Description,
    wanted: f64,
    options: &Options,
    watch: &dyn Watch,
) -> Result<Decision, AppError> {
    watch.begin(0, "first mesh");
    let decision =
        decide(description, wanted, options, &mut |level, gap| watch.say(&limits::words(level, gap)));
    watch.end();
    Ok(decision?)
}
