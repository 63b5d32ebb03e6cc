//! Whether the ground falls before anything is asked of it.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use soilctl_certificate::{Condition, Objective, Statement, UpperField};

use super::{Bound, Options, Sides, sides};
use crate::error::LimitError;
use crate::problem::Problem;

/// The statement with what is asked for left out: structures are held, live loads are none, and all that acts is what is bounded.
fn at_rest(statement: &Statement) -> Statement {
    let mut rest = Statement { objective: Objective::Everything, width: None, ..statement.clone() };
    for boundary in &mut rest.boundaries {
        if let Condition::Loaded { live: live @ true, pressure, shear } = &mut boundary.condition {
            (*live, *pressure, *shear) = (false, [0.0; 2], [0.0; 2]);
        }
    }
    rest
}

/// A proof that there is no collapse load, since the ground does not even bear its weight, water and dead loads with all structures
/// held: an upper bound below one on the factor on these. Nothing if none is found in so many seconds, which proves nothing.
///
/// # Errors
///
/// [`LimitError`] as from [`bound`](crate::bound()).
pub fn falls(
    problem: &Problem,
    options: &Options,
    seconds: f64,
) -> Result<Option<(Statement, Bound<UpperField>)>, LimitError> {
    let rest = Problem::new(at_rest(problem.statement()))?;
    // What stopped the run that asks shall not stop this one.
    let options = Options {
        max_gap: f64::EPSILON,
        max_seconds: Some(options.max_seconds.map_or(seconds, |s| s.min(seconds))),
        stop: Arc::new(AtomicBool::new(false)),
        ..options.clone()
    };
    let decided = |_: &[_], [lower, upper]: [Option<f64>; 2]| {
        lower.is_some_and(|l| l >= 1.0) || upper.is_some_and(|u| u < 1.0)
    };
    let Sides { upper, .. } = sides(&rest, &options, &decided, &mut |_, _| {})?;
    Ok(upper.filter(|upper| upper.value < 1.0).map(|upper| (rest.statement().clone(), upper)))
}
