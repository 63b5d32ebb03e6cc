//! What a search for a design answers.

use schemars::JsonSchema;
use serde::Serialize;

use crate::Outcome;
use crate::solve::Asked;
use crate::text::number;

/// The least that is enough, by proven bounds.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Answer {
    /// Title of the problem; null if it has none.
    pub title: Option<String>,
    /// What must reach it.
    pub quantity: Asked,
    /// What changes; null if all numbers go from one file to another, and values are parts of that way.
    pub parameter: Option<String>,
    /// What the quantity must reach.
    pub wanted: f64,
    /// How the search ended.
    pub found: Found,
    /// The value that is proven to be enough and nearest to those that are not; null if none is.
    pub enough_at: Option<f64>,
    /// The value that is proven not to be enough and nearest to that; null if none is.
    pub not_enough_at: Option<f64>,
    /// All values that were tried, in ascending order.
    pub tried: Vec<Tried>,
    /// Time spent in s.
    pub seconds: f64,
    /// The answer in a sentence.
    pub verdict: String,
}

/// How a search ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Found {
    /// A value that is enough and one that is not are as near to each other as was asked.
    Within,
    /// As near as bounds of this gap allow: values between have bounds on both sides of what is wanted.
    Open,
    /// Both ends are enough, so the least lies beyond.
    BothEnough,
    /// No end is enough, proven for both.
    NeitherEnough,
    /// More of it is enough, then less, then more again: there is no least.
    NotInOrder,
    /// The budget or the user ended it before, or nothing was proven at an end.
    Undecided,
}

/// What is proven of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The lower bound reaches what is wanted.
    Enough,
    /// The upper bound does not, or the ground falls before anything is asked of it.
    NotEnough,
    /// Neither is proven.
    Open,
}

/// A value that was tried.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Tried {
    /// The value, or the part of the way between two files.
    pub value: f64,
    /// Proven lower bound, no sharper than it takes to decide, of cases the least; null if one of them has none.
    pub lower: Option<f64>,
    /// Proven upper bound, likewise; null if none of them has one.
    pub upper: Option<f64>,
    /// The case of the file that has not enough, or else the first that is open; null if all have enough or the file has no cases.
    pub case: Option<String>,
    /// What follows.
    pub verdict: Verdict,
    /// How the run ended that leaves it open, or why it could not begin; null if it is not open.
    pub why: Option<String>,
}

impl Answer {
    /// The verdict in a sentence.
    pub(super) fn words(&self) -> String {
        let what = self.parameter.as_deref().unwrap_or("the part of the way");
        let wanted = number(self.wanted);
        let bounds = |value: Option<f64>| {
            let tried = self.tried.iter().find(|one| Some(one.value) == value)?;
            let proven = match (tried.lower, tried.upper) {
                (Some(lower), Some(upper)) => format!("{} to {}", number(lower), number(upper)),
                (Some(lower), None) => format!("at least {}", number(lower)),
                (None, Some(upper)) => format!("at most {}", number(upper)),
                (None, None) => "no bounds".to_owned(),
            };
            Some(format!("{} ({proven})", number(tried.value)))
        };
        let (enough, not) = (bounds(self.enough_at), bounds(self.not_enough_at));
        let both = match (&enough, &not) {
            (Some(enough), Some(not)) => {
                format!("{what} = {enough} is proven to reach {wanted}, and {not} not to")
            }
            (Some(enough), None) => {
                format!("{what} = {enough} is proven to reach {wanted}; no value is proven not to")
            }
            (None, Some(not)) => {
                format!("no value is proven to reach {wanted}; {what} = {not} is proven not to")
            }
            (None, None) => format!("nothing is proven about {wanted}"),
        };
        match self.found {
            Found::Within => format!("{both}."),
            Found::Open => {
                format!("{both}; between them bounds lie on both sides of it: --max-gap makes them sharper.")
            }
            Found::BothEnough => {
                format!("Both ends reach {wanted}, so the least lies beyond {}.", enough.unwrap_or_default())
            }
            Found::NeitherEnough => format!("No end reaches {wanted}: {both}."),
            Found::NotInOrder => {
                format!(
                    "There is no least: values that reach {wanted} and values that do not take turns. {both}."
                )
            }
            Found::Undecided => format!("It ended before it was decided: {both}."),
        }
    }
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.design/1";

    fn outcome(&self) -> Outcome {
        match self.found {
            Found::Within | Found::BothEnough => Outcome::Done,
            Found::NeitherEnough => Outcome::Negative,
            Found::Open | Found::NotInOrder | Found::Undecided => Outcome::Partial,
        }
    }
}
