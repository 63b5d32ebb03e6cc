//! Proven bounds on the force of a tool that need not be flat.

mod answer;
mod ends;
mod file;
mod forces;
mod ground;
mod request;
mod shape;
mod table;

use std::path::Path;

pub(crate) use answer::notes;
pub use answer::{Answer, PieceAnswer, ToolAnswer};
use ends::Above;
pub use ends::{EndsAnswer, FrontAnswer};
pub use file::{ArcEntry, PieceEntry, TOOL_SCHEMA, ToolFile};
pub use forces::{DirectionAnswer, ForcesAnswer};
pub(crate) use ground::{Placed, SOIL};
pub use request::{Request, Setting};
pub use shape::AlphaOf;
pub(crate) use shape::meet;
use soilctl_limit_analysis::{Description, LimitError};
pub use table::{RowAnswer, TableAnswer};

use crate::files::{can_be_written, save};
use crate::limits::Budget;
use crate::solve::{self, Solved};
use crate::{AppError, Watch};

/// The answer, and the fields behind it.
#[derive(Debug)]
pub struct Bounded {
    /// The answer.
    pub answer: Answer,
    /// The problem, its fields, and whether the solution was saved.
    pub solved: Solved,
}

impl Bounded {
    /// The answer of a run that did all it was asked for.
    ///
    /// # Errors
    /// [`AppError`] if the solution could not be saved.
    pub fn complete(self) -> Result<Answer, AppError> {
        self.solved.unsaved.map_or(Ok(self.answer), Err)
    }
}

/// Bounds the force of a tool.
///
/// # Errors
/// [`AppError`] if request or tool file make no sense, there is no folder for a file, or there are no bounds.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Bounded, AppError> {
    crate::request::check(request)?;
    for path in [&request.save, &request.problem, &request.table].into_iter().flatten() {
        can_be_written(path)?;
    }
    let placed = Placed::new(&request.setting)?;
    if request.width_m.is_some() {
        ends::check(&request.setting, &placed)?;
    }
    let table = request.table.as_deref();
    table.map_or(Ok(()), |table| table::check(request, &placed.file, table))?;
    let notes = notes(&request.setting, &placed, request.width_m.is_some());
    notes.iter().for_each(|note| watch.note(note));
    let mut found = bounded(request, &placed, notes, watch)?;
    if let Some(path) = table {
        found.answer.table = Some(table::run(request, &placed.file, path, watch)?);
    }
    Ok(found)
}

/// Bounds the force of a tool in its place.
fn bounded(
    request: &Request,
    placed: &Placed,
    notes: Vec<String>,
    watch: &dyn Watch,
) -> Result<Bounded, AppError> {
    let description = placed.alone(&request.setting);
    if let Some(path) = &request.problem {
        write_problem(&description, path)?;
    }
    let Some(width_m) = request.width_m else {
        return in_plane(request, placed, description, notes, watch);
    };
    let above = Above::new(&request.setting, placed, width_m, watch)?;
    let mut solved = solve::with_ends(&request.budget, description, width_m, watch)?;
    solved.kept.push(above.kept());
    solved.unsaved = request.save.as_deref().and_then(|path| solve::write(&solved.kept, path).err());
    let answer = Answer::new(&request.setting, placed, &solved, Some((above, width_m)), notes)?;
    Ok(Bounded { answer, solved })
}

/// Bounds in plane strain, in the direction asked for or in all.
fn in_plane(
    request: &Request,
    placed: &Placed,
    description: Description,
    notes: Vec<String>,
    watch: &dyn Watch,
) -> Result<Bounded, AppError> {
    let save = request.save.as_deref();
    let setting = &request.setting;
    let Some(count) = request.forces else {
        let solved = solve::one(&request.budget, save, description, watch)?;
        let answer = Answer::new(setting, placed, &solved, None, notes)?;
        return Ok(Bounded { answer, solved });
    };
    if setting.direction_deg != 0.0 {
        return Err(AppError::Request(format!(
            "--direction is {} deg, but --forces looks into all directions; leave one of them out",
            setting.direction_deg
        )));
    }
    // What time there is is shared among the directions.
    let share = |seconds: f64| seconds / f64::from(count);
    let budget = Budget { max_seconds: request.budget.max_seconds.map(share), ..request.budget.clone() };
    let mut solved = solve::one(&budget, save, description, watch)?;
    let (forces, unsaved) = forces::run(setting, placed, &solved, &budget, save, count, watch);
    solved.unsaved = solved.unsaved.take().or(unsaved);
    let answer = Answer { forces: Some(forces), ..Answer::new(setting, placed, &solved, None, notes)? };
    Ok(Bounded { answer, solved })
}

/// Writes a problem file.
pub(crate) fn write_problem(description: &Description, path: &Path) -> Result<(), AppError> {
    if path.extension().is_none_or(|ending| ending != "toml") {
        return Err(AppError::Request(format!(
            "--problem is {}; the name must end in .toml",
            path.display()
        )));
    }
    save(path, description.to_toml().map_err(LimitError::from)?.as_bytes())
}
