//! Proven bounds on the force of a tool that need not be flat.

mod answer;
mod ends;
mod file;
mod ground;
mod request;
mod shape;

use std::path::Path;

pub(crate) use answer::notes;
pub use answer::{Answer, PieceAnswer, ToolAnswer};
pub use ends::{EndsAnswer, FrontAnswer};
pub use file::{ArcEntry, PieceEntry, TOOL_SCHEMA, ToolFile};
pub(crate) use ground::{Placed, SOIL};
pub use request::{Request, Setting};
pub use shape::AlphaOf;
pub(crate) use shape::meet;
use ends::Above;
use soilctl_limit_analysis::{Description, LimitError};

use crate::files::{can_be_written, save};
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
    for path in [&request.save, &request.problem].into_iter().flatten() {
        can_be_written(path)?;
    }
    let placed = Placed::new(&request.setting)?;
    let notes = notes(&request.setting, &placed, request.width_m.is_some());
    if request.width_m.is_some() {
        ends::check(&request.setting, &placed)?;
    }
    notes.iter().for_each(|note| watch.note(note));
    let description = placed.alone(&request.setting);
    if let Some(path) = &request.problem {
        write_problem(&description, path)?;
    }
    let save = request.save.as_deref();
    let Some(width_m) = request.width_m else {
        let solved = solve::one(&request.budget, save, description, watch)?;
        let answer = Answer::new(&request.setting, &placed, &solved, None, notes)?;
        return Ok(Bounded { answer, solved });
    };
    let above = Above::new(&request.setting, &placed, width_m, watch)?;
    let mut solved = solve::with_ends(&request.budget, description, width_m, watch)?;
    solved.kept.push(above.kept());
    solved.unsaved = save.and_then(|path| solve::write(&solved.kept, path).err());
    let answer = Answer::new(&request.setting, &placed, &solved, Some((above, width_m)), notes)?;
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
