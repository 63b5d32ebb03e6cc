//! Solutions for `soilctl certify`.

use std::path::{Path, PathBuf};

use soilctl_certificate::{LowerField, SCHEMA, Solution, UpperField};
use soilctl_limit_analysis::{Bound, Bounds, Described, SafetyBounds};

use crate::AppError;

/// A solution for `soilctl certify`.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Which bound it proves, where each has a solution of its own; it goes before the ending of the file's name.
    pub part: Option<&'static str>,
    /// The solution.
    pub solution: Solution,
}

impl Kept {
    /// The file that it is saved to, where the user names `path`.
    #[must_use]
    pub fn file(&self, path: &Path) -> PathBuf {
        self.part.map_or_else(|| path.to_owned(), |part| path.with_extension(format!("{part}.json")))
    }
}

/// Both bounds in one; with ends the lower one only, since a flow in the plane proves nothing then.
pub(super) fn both(described: &Described, bounds: &Bounds) -> Vec<Kept> {
    let upper = described.statement.width.is_none().then_some(&bounds.upper);
    vec![kept(None, described, Some(&bounds.lower), upper)]
}

/// Bounds on a factor of safety are of problems of different strength: each has a solution of its own.
pub(super) fn safety(safety: &SafetyBounds) -> Vec<Kept> {
    vec![
        kept(Some("lower"), &safety.lower.described, Some(&safety.lower.bound), None),
        kept(Some("upper"), &safety.upper.described, None, Some(&safety.upper.bound)),
    ]
}

/// Writes all of them; the first that could not be written does not keep the others from it, since each is a proof of its own.
pub(crate) fn write(kept: &[Kept], path: &Path) -> Result<Vec<PathBuf>, AppError> {
    let written: Vec<_> = kept
        .iter()
        .map(|kept| {
            let file = kept.file(path);
            kept.solution.write(&file).map(|()| file)
        })
        .collect();
    Ok(written.into_iter().collect::<Result<_, _>>()?)
}

fn kept(
    part: Option<&'static str>,
    described: &Described,
    lower: Option<&Bound<LowerField>>,
    upper: Option<&Bound<UpperField>>,
) -> Kept {
    let solution = Solution {
        schema: SCHEMA.to_owned(),
        program: format!("soilctl {}", env!("CARGO_PKG_VERSION")),
        statement: described.statement.clone(),
        scale: described.scale(),
        lower: lower.map(Bound::claim),
        upper: upper.map(Bound::claim),
        mechanism: None,
        space: None,
    };
    Kept { part, solution }
}
