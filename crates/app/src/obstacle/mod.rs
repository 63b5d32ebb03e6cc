//! A tool near a buried rigid body: from what distance on the force says that something is there.

mod answer;
mod body;
mod one;
mod request;

pub use answer::{Answer, DistanceAnswer, Verdict};
use body::Body;
use one::Series;
pub use request::{BodyKind, Request};
use soilctl_limit_analysis::Description;
use web_time::Instant;

use crate::files::{can_be_written, numbered, table_form};
use crate::tool::{Placed, ToolAnswer, notes, write_problem};
use crate::{AppError, Watch};

/// Distances to look at if none are given, in units of what of the tool is in the ground.
const DISTANCES: [f64; 7] = [0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0];

/// Most distances of a table.
const MOST: usize = 100;

/// The answer, and what went wrong with files beside it.
#[derive(Debug)]
pub struct Found {
    /// The answer.
    pub answer: Answer,
    /// Why the first file that was not saved was not: bounds that took their time are not lost with a file.
    pub unsaved: Option<AppError>,
}

impl Found {
    /// The answer of a run that did all it was asked for.
    ///
    /// # Errors
    /// [`AppError`] if a solution or the table could not be saved.
    pub fn complete(self) -> Result<Answer, AppError> {
        self.unsaved.map_or(Ok(self.answer), Err)
    }
}

/// Bounds the force of a tool at each distance of a body.
///
/// # Errors
/// [`AppError`] if request or tool file make no sense, a file cannot be written, or there are no bounds without the body.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Found, AppError> {
    crate::request::check(request)?;
    for path in [&request.save, &request.problem, &request.table].into_iter().flatten() {
        can_be_written(path)?;
    }
    request.table.as_deref().map(table_form).transpose()?;
    let begun = Instant::now();
    let placed = Placed::new(&request.setting)?;
    let distances = distances(request, &placed)?;
    let bodies =
        distances.iter().map(|ahead| Body::new(request, &placed, *ahead)).collect::<Result<Vec<_>, _>>()?;
    let Some(nearest) = bodies.first() else {
        return Err(AppError::Request("give at least one distance with --ahead".into()));
    };
    let stone_cohesion_pa = nearest.stone_cohesion_pa(request, &placed);
    let notes = all_notes(request, &placed);
    notes.iter().for_each(|note| watch.note(note));
    let alone = placed.alone(&request.setting);
    let with: Vec<Description> = bodies.iter().map(|body| body.description(request, &placed)).collect();
    // What is wrong with any of them is said before the first proof, which may take minutes.
    for description in &with {
        description.described()?;
    }
    write_problems(request, &alone, &with)?;
    let Series { without, rows, work, unsaved } =
        Series::run(request, alone, distances.into_iter().zip(with).collect(), watch)?;
    let [without_lower_n_per_m, without_upper_n_per_m] = one::newtons(&without);
    let mut answer = Answer {
        answer: Verdict::Open,
        without_lower_n_per_m,
        without_upper_n_per_m,
        certified: true,
        distances: rows,
        shows_to_m: None,
        hidden_from_m: None,
        scatter: request.scatter,
        body: request.body,
        body_top_m: request.body_top_m,
        body_height_m: request.body_height_m,
        body_length_m: request.body_length_m.unwrap_or(request.body_height_m),
        stone_cohesion_pa,
        tool: ToolAnswer::new(&placed, &request.setting),
        direction_deg: request.setting.direction_deg,
        verdict: String::new(),
        notes,
        work,
        seconds: begun.elapsed().as_secs_f64(),
        max_gap: request.budget.max_gap,
        without_gap: without.answer.gap,
    };
    answer.conclude();
    let table = request.table.as_deref().and_then(|path| answer.write_table(path).err());
    Ok(Found { answer, unsaved: unsaved.or(table) })
}

/// Distances near to far.
fn distances(request: &Request, placed: &Placed) -> Result<Vec<f64>, AppError> {
    let mut all = request.ahead_m.clone();
    if all.is_empty() {
        all = DISTANCES.iter().map(|part| part * placed.size_m()).collect();
    }
    if all.len() > MOST {
        return Err(AppError::Request(format!(
            "--ahead has {} distances; it may have {MOST} at most",
            all.len()
        )));
    }
    all.sort_by(f64::total_cmp);
    all.dedup();
    Ok(all)
}

/// What hardly anybody means, and what the solver does not find.
fn all_notes(request: &Request, placed: &Placed) -> Vec<String> {
    let mut notes = notes(&request.setting, placed, false);
    if request.body == BodyKind::Fixed && placed.has_smooth_face() {
        notes.push(
            "beside a tool with a perfectly smooth face no stresses around a body at rest are found, so lower bounds are those without the body; a \
             friction angle of a degree or two has some"
                .into(),
        );
    }
    notes
}

/// Problem files, if they are asked for.
fn write_problems(request: &Request, alone: &Description, with: &[Description]) -> Result<(), AppError> {
    let Some(path) = &request.problem else { return Ok(()) };
    write_problem(alone, &numbered(path, "without"))?;
    for (index, description) in with.iter().enumerate() {
        write_problem(description, &numbered(path, &(index + 1).to_string()))?;
    }
    Ok(())
}
