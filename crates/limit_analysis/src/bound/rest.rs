//! Whether the ground falls before anything is asked of it.

use soilctl_certificate::{Condition, Objective, Statement};
use soilctl_conic::Status;

use super::{Level, Options, Sides, is_decided, sides};
use crate::error::LimitError;
use crate::problem::Problem;

/// [Work](Options::max_work) that is enough to look for a proof that the ground falls, where it seems to: some seconds.
pub const WORK_TO_FALL: u64 = 300_000;

/// The statement with what is asked for left out: structures are held, live loads are none, and all that acts is what is bounded.
fn at_rest(statement: &Statement) -> Statement {
    let mut rest = Statement { objective: Objective::Everything, width: None, ..statement.clone() };
    for boundary in &mut rest.boundaries {
        if let Condition::Loaded { live: live @ true, pressure, shear }
        | Condition::Lined { live: live @ true, pressure, shear } = &mut boundary.condition
        {
            (*live, *pressure, *shear) = (false, [0.0; 2], [0.0; 2]);
        }
    }
    rest
}

/// Whether the ground seems to fall whatever else acts: on no mesh so far do stresses within the strength bear what acts, or on all of
/// them the flow gains without end. It proves nothing: see [`falls`].
#[must_use]
pub fn seems_to_fall(levels: &[Level]) -> bool {
    let all = |statuses: Vec<Status>, wanted: Status| {
        !statuses.is_empty() && statuses.iter().all(|status| *status == wanted)
    };
    let lower = levels.iter().filter_map(|level| level.lower.map(|solve| solve.status));
    let upper = levels.iter().map(|level| level.upper.status);
    all(lower.collect(), Status::Infeasible) || all(upper.collect(), Status::Unbounded)
}

/// A proof that there is no collapse load, since the ground does not even bear its weight, water and dead loads with all structures
/// held: an upper bound below one on the factor on these. Nothing if none is found with so much [work](Options::max_work), which
/// proves nothing.
///
/// # Errors
///
/// [`LimitError`] as from [`bound`](crate::bound()).
pub fn falls(problem: &Problem, options: &Options, work: u64) -> Result<Option<f64>, LimitError> {
    let rest = Problem::new(at_rest(problem.statement()))?;
    let options = Options {
        max_gap: f64::EPSILON,
        max_work: work.min(options.max_work),
        // What ended the run that asks shall not end this one.
        end: std::sync::Arc::default(),
        ..options.clone()
    };
    let Sides { upper, .. } = sides(&rest, &options, &is_decided, &mut |_, _| {})?;
    Ok(upper.map(|upper| upper.value).filter(|factor| *factor < 1.0))
}
