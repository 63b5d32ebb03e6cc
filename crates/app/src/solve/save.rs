//! Solutions for `soilctl certify`.

use std::path::{Path, PathBuf};

use soilctl_certificate::{LowerField, SCHEMA, Solution, UpperField};
use soilctl_limit_analysis::{Bound, Bounds, Described, SafetyBounds};

use crate::AppError;

/// Both bounds in one file.
pub(super) fn both(path: &Path, described: &Described, bounds: &Bounds) -> Result<(), AppError> {
    write(path, described, Some(&bounds.lower), Some(&bounds.upper))
}

/// Bounds on a factor of safety are of problems of different strength: each has a file of its own. Returns their names.
pub(super) fn safety(path: &Path, safety: &SafetyBounds) -> Result<Vec<PathBuf>, AppError> {
    let named = |part: &str| path.with_extension(format!("{part}.json"));
    let files = vec![named("lower"), named("upper")];
    let lower = write(&files[0], &safety.lower.described, Some(&safety.lower.bound), None);
    // Each is a proof of its own, which need not be lost with the other.
    let upper = write(&files[1], &safety.upper.described, None, Some(&safety.upper.bound));
    lower.and(upper).map(|()| files)
}

fn write(
    path: &Path,
    described: &Described,
    lower: Option<&Bound<LowerField>>,
    upper: Option<&Bound<UpperField>>,
) -> Result<(), AppError> {
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
    Ok(solution.write(path)?)
}
