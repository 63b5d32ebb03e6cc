//! Runs that prove one side only say so.

use soilctl_limit_analysis::describe::{Described, Quantity};
use soilctl_limit_analysis::{LimitError, OneSide};

use crate::AppError;
use crate::text::number;

fn words(what: &str, side: OneSide, problem: &LimitError) -> AppError {
    let (at, value) = match side {
        OneSide::Lower(value) => ("at least", value),
        OneSide::Upper(value) => ("at most", value),
    };
    AppError::Request(format!("only one side is proven: {what} is {at} {}; {problem}", number(value)))
}

/// What a failed run has proven of a described problem, in the units of its file.
pub(super) fn of_problem(problem: AppError, described: &Described) -> AppError {
    let (side, error) = match problem {
        AppError::Limit(error @ LimitError::NothingProven { proven: Some(side), .. }) => (side, error),
        other => return other,
    };
    let what = match described.quantity {
        Quantity::ForceKnPerM => "the force in kN/m",
        Quantity::LoadFactor => "the factor on the live loads",
        Quantity::WeightFactor => "the factor on the unit weights",
        Quantity::Acceleration => "the horizontal acceleration over gravity",
    };
    words(what, in_units(side, described), &error)
}

/// In the units of the file, rounded outwards.
fn in_units(side: OneSide, described: &Described) -> OneSide {
    match side {
        OneSide::Lower(value) => OneSide::Lower(described.in_units([value; 2])[0]),
        OneSide::Upper(value) => OneSide::Upper(described.in_units([value; 2])[1]),
    }
}

/// The side that a failed run has proven, in the units of its file; none if it proved nothing.
pub(super) fn proven(problem: &AppError, described: &Described) -> Option<OneSide> {
    match problem {
        AppError::Limit(LimitError::NothingProven { proven: Some(side), .. }) => {
            Some(in_units(*side, described))
        }
        _ => None,
    }
}

/// The same of a factor of safety.
pub(super) fn of_safety(problem: LimitError) -> AppError {
    match problem {
        LimitError::NothingProven { proven: Some(side), .. } => words("the factor of safety", side, &problem),
        problem => problem.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn failed(side: OneSide) -> LimitError {
        LimitError::NothingProven { proven: Some(side), spent: "1 level".into(), advice: "allow more" }
    }

    #[test]
    fn a_factor_of_safety_is_told_from_the_side_that_is_proven() {
        for (side, words) in [
            (OneSide::Lower(1.25), "only one side is proven: the factor of safety is at least 1.25; no pair"),
            (OneSide::Upper(2.5), "only one side is proven: the factor of safety is at most 2.5; no pair"),
        ] {
            let told = of_safety(failed(side)).to_string();
            assert!(told.starts_with(words) && told.ends_with("(1 level); allow more"), "{told}");
        }
        let nothing = LimitError::NothingProven { proven: None, spent: String::new(), advice: "" };
        assert!(!of_safety(nothing).to_string().contains("only one side"));
    }
}
