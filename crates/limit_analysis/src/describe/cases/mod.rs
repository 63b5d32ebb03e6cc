//! Load cases and parameter sweeps: one file, many problems.
//!
//! Each `[[case]]` changes values (`set`) and multiplies actions and divides strengths by partial factors, its own or those of
//! a design approach; each `[[sweep]]` gives one parameter several values. Every case is combined with every value of every
//! sweep.

mod approach;
mod entry;
mod factors;
mod path;

use std::collections::BTreeMap;

pub use approach::Approach;
pub use entry::{CaseEntry, Effect, Factors, Setting, SweepEntry};

use super::error::DescriptionError;
use super::input::Description;

/// Most problems that cases and sweeps may make together.
pub const MOST_CASES: usize = 1000;

/// One of the problems that a file with cases or sweeps describes.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// The name of its case, and the values of the sweeps.
    pub name: String,
    /// The values that it sets, by parameter, before partial factors. Points, as of a water table, are not among them.
    pub values: BTreeMap<String, f64>,
    /// The partial factors.
    pub factors: Factors,
    /// What bounds are divided by: the partial factor on resistance.
    pub resistance: f64,
    /// The problem with values set and factors applied; it has no cases itself.
    pub description: Description,
}

impl Description {
    /// The problems that the file describes by cases and sweeps, in its order; none if it has neither.
    ///
    /// # Errors
    ///
    /// [`DescriptionError`] for a parameter that there is none of, a factor out of its range or left open, two cases of one name,
    /// or more than [`MOST_CASES`] problems.
    pub fn cases(&self) -> Result<Vec<Case>, DescriptionError> {
        if self.cases.is_empty() && self.sweeps.is_empty() {
            return Ok(Vec::new());
        }
        let mut count = self.cases.len().max(1);
        let mut sweeps = Vec::new();
        for (index, sweep) in self.sweeps.iter().enumerate() {
            let values = sweep.points(index)?;
            count = count.saturating_mul(values.len());
            sweeps.push((sweep.parameter.as_str(), values));
        }
        if count > MOST_CASES {
            return Err(DescriptionError::TooMuch {
                what: "cases times values of sweeps",
                count,
                limit: MOST_CASES,
            });
        }
        for (index, case) in self.cases.iter().enumerate() {
            if self.cases[..index].iter().any(|earlier| earlier.name == case.name) {
                let problem = "an earlier case has the same name; rename one";
                return Err(DescriptionError::entry(case.title(index), problem));
            }
        }
        let plain = Self { cases: Vec::new(), sweeps: Vec::new(), ..self.clone() };
        let only = [CaseEntry::default()];
        let entries = if self.cases.is_empty() { &only[..] } else { &self.cases };
        let mut cases = Vec::with_capacity(count);
        for (index, entry) in entries.iter().enumerate() {
            for values in combinations(&sweeps) {
                cases.push(case(&plain, entry, index, &values)?);
            }
        }
        Ok(cases)
    }
}

/// Each value of each sweep with each of the others; those of the last sweep change first.
fn combinations<'a>(sweeps: &[(&'a str, Vec<f64>)]) -> Vec<Vec<(&'a str, f64)>> {
    let mut all = vec![Vec::new()];
    for (parameter, values) in sweeps {
        all = all
            .into_iter()
            .flat_map(|before| {
                values.iter().map(move |value| [before.as_slice(), &[(*parameter, *value)]].concat())
            })
            .collect();
    }
    all
}

fn case(
    plain: &Description,
    entry: &CaseEntry,
    index: usize,
    swept: &[(&str, f64)],
) -> Result<Case, DescriptionError> {
    let title = entry.title(index);
    let mut values = BTreeMap::new();
    let mut changes: Vec<(&str, Setting)> =
        entry.set.iter().map(|(parameter, value)| (parameter.as_str(), value.clone())).collect();
    changes.extend(swept.iter().map(|(parameter, value)| (*parameter, Setting::Number(*value))));
    for (parameter, value) in &changes {
        if let Setting::Number(value) = value {
            values.insert((*parameter).to_owned(), *value);
        }
    }
    let mut description = path::set(plain, &title, &changes)?;
    let factors = entry.factors_for(&description, &title)?;
    factors.apply(&mut description, &title)?;
    let mut words: Vec<String> = Vec::new();
    if !entry.name.is_empty() {
        words.push(entry.name.clone());
    }
    words.extend(swept.iter().map(|(parameter, value)| format!("{parameter} = {value}")));
    let name = words.join(", ");
    description.title = Some(match &plain.title {
        Some(title) => format!("{title}, {name}"),
        None => name.clone(),
    });
    Ok(Case { name, values, resistance: factors.resistance.unwrap_or(1.0), factors, description })
}
