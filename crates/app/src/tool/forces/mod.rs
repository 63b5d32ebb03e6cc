//! Forces that the soil bears on a tool that does not turn, whatever their direction.
//!
//! A force F of the tool on the soil is safe if some stress field that balances it is borne everywhere. Safe forces are a convex set, since stress
//! fields may be averaged, and by the theorems of limit analysis its support in the direction d, the greatest `F . d`, is the force of the tool along its motion when it is
//! moved in the direction d without turning. So each direction of motion says two things:
//!
//! - the upper bound is a line beyond which no force is borne: `F . d <= U`;
//! - the stress field of the lower bound balances a force with both its components, which is safe.
//!
//! The hull of these forces is safe, and beyond the polygon of these lines all fail. Each component is proven by the certificate's check of the same field for a
//! motion along it, from both sides.

mod answer;
mod polygon;

use std::path::Path;
use std::sync::atomic::Ordering;

pub use answer::{DirectionAnswer, ForcesAnswer};
use soilctl_certificate::{LowerField, Objective, Statement, prove_lower};
use soilctl_limit_analysis::OneSide;

use super::ground::Placed;
use super::request::Setting;
use super::shape::Point;
use crate::files::numbered;
use crate::limits::Budget;
use crate::solve::{self, Solved};
use crate::watch::OneOfMany;
use crate::{AppError, Interrupted, Watch};

/// All directions, of which the first, level and ahead, is solved already. With it comes why the first solution that was not saved was not.
pub(super) fn run(
    setting: &Setting,
    placed: &Placed,
    ahead: &Solved,
    budget: &Budget,
    save: Option<&Path>,
    count: u32,
    watch: &dyn Watch,
) -> (ForcesAnswer, Option<AppError>) {
    let stop = watch.stop(Interrupted::KeepsResults);
    let mut unsaved = None;
    let mut directions = vec![of_solved(0.0, setting, ahead)];
    watch.begin(u64::from(count), "directions");
    watch.advance(1);
    for k in 1..count {
        let direction_deg = 360.0 * f64::from(k) / f64::from(count);
        let found = if stop.load(Ordering::Relaxed) {
            of_none(direction_deg, None, "the run was ended before this direction".into())
        } else {
            let turned = Setting { direction_deg, ..setting.clone() };
            let save = save.map(|path| numbered(path, &k.to_string()));
            let watch = OneOfMany { watch, name: None };
            match solve::one_or_side(budget, save.as_deref(), placed.alone(&turned), &watch) {
                Ok(mut solved) => {
                    unsaved = unsaved.or(solved.unsaved.take());
                    of_solved(direction_deg, setting, &solved)
                }
                Err((side, problem)) => of_none(direction_deg, side, problem.to_string()),
            }
        };
        directions.push(found);
        watch.advance(1);
    }
    watch.end();
    (ForcesAnswer::new(directions), unsaved)
}

/// What one direction says.
fn of_solved(direction_deg: f64, setting: &Setting, solved: &Solved) -> DirectionAnswer {
    let [lower, upper] = super::answer::times([solved.answer.lower, solved.answer.upper], 1e3);
    let field = solved.kept.first().and_then(|kept| kept.solution.lower.as_ref()).map(|claim| &claim.field);
    let unit = 1e3 * solved.described.length_m * solved.described.stress_kpa;
    let force = field.and_then(|field| balanced(&solved.described.statement, field, setting.loads.beta_deg));
    DirectionAnswer {
        direction_deg,
        lower_n_per_m: Some(lower),
        upper_n_per_m: Some(upper),
        force_n_per_m: force.map(|force| force.map(|f| f * unit)),
        problem: None,
    }
}

fn of_none(direction_deg: f64, side: Option<OneSide>, problem: String) -> DirectionAnswer {
    let [lower, upper] = match side {
        Some(OneSide::Lower(lower)) => [Some((1e3 * lower).next_down()), None],
        Some(OneSide::Upper(upper)) => [None, Some((1e3 * upper).next_up())],
        None => [None; 2],
    };
    DirectionAnswer {
        direction_deg,
        lower_n_per_m: lower,
        upper_n_per_m: upper,
        force_n_per_m: None,
        problem: Some(problem),
    }
}

/// The force that a stress field balances, level and upwards, in units of the statement: what is proven of it from both sides differs by rounding.
fn balanced(statement: &Statement, field: &LowerField, beta_deg: f64) -> Option<Point> {
    let along = |direction_deg: f64| {
        let (sin, cos) = (direction_deg - beta_deg).to_radians().sin_cos();
        let turned =
            Statement { objective: Objective::Structure { velocity: [cos, sin] }, ..statement.clone() };
        prove_lower(&turned, field).ok()
    };
    let between = |direction_deg: f64| Some(0.5 * (along(direction_deg)? - along(direction_deg + 180.0)?));
    Some([between(0.0)?, between(90.0)?])
}
