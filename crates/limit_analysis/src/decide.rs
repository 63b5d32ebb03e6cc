//! Whether what a description asks for reaches a value. Bounds on it are needed only as sharp as that takes, which is little
//! where it is far from the value.

use std::cell::OnceCell;

use crate::bound::{Options, WORK_TO_FALL, falls, is_decided, seems_to_fall, sides};
use crate::describe::{Aim, Described, Description};
use crate::error::LimitError;
use crate::strength::ROUNDING;
use crate::{Ended, Level};

/// What is proven of a quantity and a value that it is to reach.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// The lower bound reaches it.
    Reached,
    /// The upper bound does not reach it, but for rounding (1e-14 of the value), or the ground falls under what it bears before anything is
    /// asked of it.
    Missed,
    /// Neither is proven.
    Open,
}

/// What came of a run.
#[derive(Debug, Clone, Copy)]
pub struct Decision {
    /// What is proven.
    pub reach: Reach,
    /// A lower bound on the quantity in the units of the description, if there is one.
    pub lower: Option<f64>,
    /// An upper bound, likewise.
    pub upper: Option<f64>,
    /// Why there is no more; [`Ended::Gap`] if it is decided.
    pub ended: Ended,
}

/// Decides whether what a description asks for (a force in kN/m, a factor, an acceleration over gravity) reaches a value, which for
/// a factor of safety must be above zero. `progress` is told each level.
///
/// # Errors
///
/// [`LimitError`] if the description or its mesh makes no sense, or bounds on it are not covered. That nothing is proven is
/// no error.
pub fn decide(
    description: &Description,
    wanted: f64,
    options: &Options,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Decision, LimitError> {
    description.check()?;
    // Ground water does not depend on strength, and is found once.
    let pores = description.pore_field()?;
    if description.objective != (Aim::StrengthReduction {}) {
        return of_quantity(&description.described_under(pores.as_ref())?, wanted, options, progress);
    }
    // With strength divided by what is wanted the soil either stands under all that acts or does not. It is divided by a little more, so that
    // rounding the reduced strengths does not matter.
    let factor = wanted * (1.0 + 2.0 * ROUNDING);
    let weaker = description.reduced(factor).described_under(pores.as_ref())?;
    let found = sides(&weaker.problem()?, options, &is_decided, progress)?;
    let [lower, upper] = [found.lower.map(|b| b.value), found.upper.map(|b| b.value)];
    let (reach, lower, upper) = match (lower, upper) {
        (Some(lower), _) if lower >= 1.0 => (Reach::Reached, Some(wanted), None),
        (_, Some(upper)) if upper < 1.0 => (Reach::Missed, None, Some(factor * (1.0 + ROUNDING))),
        _ => (Reach::Open, None, None),
    };
    Ok(Decision::new(reach, lower, upper, found.ended))
}

/// Where bounds on the quantity itself tell.
fn of_quantity(
    described: &Described,
    wanted: f64,
    options: &Options,
    progress: &mut dyn FnMut(&Level, Option<f64>),
) -> Result<Decision, LimitError> {
    let problem = described.problem()?;
    // Whether the ground falls whatever is asked of it; looked for once, if it seems to.
    let falling = OnceCell::new();
    let is_falling = |levels: &[Level]| {
        let ask = || falls(&problem, options, WORK_TO_FALL).is_ok_and(|factor| factor.is_some());
        levels.len() > 1 && seems_to_fall(levels) && *falling.get_or_init(ask)
    };
    let is_enough = |levels: &[Level], [lower, upper]: [Option<f64>; 2]| {
        let lower = lower.map(|bound| in_units(described, bound, 0));
        let upper = upper.map(|bound| in_units(described, bound, 1));
        reach(wanted, lower, upper) != Reach::Open || is_falling(levels)
    };
    let found = sides(&problem, options, &is_enough, progress)?;
    let lower = found.lower.map(|bound| in_units(described, bound.value, 0));
    let upper = found.upper.map(|bound| in_units(described, bound.value, 1));
    let reach = match reach(wanted, lower, upper) {
        // There is no load that it bears.
        Reach::Open if lower.is_none() && is_falling(&found.levels) => Reach::Missed,
        reach => reach,
    };
    Ok(Decision::new(reach, lower, upper, found.ended))
}

impl Decision {
    fn new(reach: Reach, lower: Option<f64>, upper: Option<f64>, ended: Ended) -> Self {
        let ended = if reach == Reach::Open { ended } else { Ended::Gap };
        Self { reach, lower, upper, ended }
    }
}

/// A bound in the units of the description; `side` is 0 for a lower bound, 1 for an upper one.
fn in_units(described: &Described, bound: f64, side: usize) -> f64 {
    described.in_units([bound; 2])[side]
}

fn reach(wanted: f64, lower: Option<f64>, upper: Option<f64>) -> Reach {
    match (lower, upper) {
        (Some(lower), _) if lower >= wanted => Reach::Reached,
        (_, Some(upper)) if upper < wanted => Reach::Missed,
        _ => Reach::Open,
    }
}
