use std::path::Path;

use serde::Serialize;

use super::run::{READING_ALLOWED, reading_ok};
use crate::error::DirectShearError;
use crate::table::Table;

/// Friction of the shear box itself, from a record without soil in both directions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FrictionLoop {
    half_height_n: f64,
    from_m: f64,
    to_m: f64,
}

impl FrictionLoop {
    /// A loop whose half height (at least 0 N) is already known, said to hold from `from_m` to `to_m`.
    ///
    /// # Errors
    /// [`DirectShearError::Loop`] if the half height is negative, or a value not finite or the range empty.
    pub fn new(half_height_n: f64, from_m: f64, to_m: f64) -> Result<Self, DirectShearError> {
        Self::checked(half_height_n, from_m, to_m, "friction loop")
    }

    fn checked(half_height_n: f64, from_m: f64, to_m: f64, file: &str) -> Result<Self, DirectShearError> {
        let refuse = |problem: String| Err(DirectShearError::Loop { file: file.to_owned(), problem });
        if !(from_m.is_finite() && to_m.is_finite() && from_m < to_m) {
            return refuse(format!(
                "the displacements of the two directions have no range in common ({from_m} to {to_m} m); record both \
                 over the same displacement"
            ));
        }
        if !(half_height_n.is_finite() && half_height_n >= 0.0) {
            return refuse(format!(
                "half the loop's height is {half_height_n} N; it must be at least 0 N: check whether forward and \
                 reverse are swapped"
            ));
        }
        Ok(Self { half_height_n, from_m, to_m })
    }

    /// Half the height of the loop in N: the machine friction contained in a shear force.
    #[must_use]
    pub const fn half_height_n(&self) -> f64 {
        self.half_height_n
    }

    /// Ends of the range of displacement in m over which both branches were recorded.
    #[must_use]
    pub const fn range_m(&self) -> (f64, f64) {
        (self.from_m, self.to_m)
    }

    /// A loop from its two branches, each a list of (displacement in m, force in N) in any order.
    ///
    /// Half the difference of the mean forces over the common displacement. The mean is taken instead of
    /// the difference point by point because that would add the noise of the loop to every run, and because a run
    /// may go further than the loop.
    ///
    /// # Errors
    /// [`DirectShearError::Loop`] if a branch has fewer than two points, a reading is not between -1e9 and 1e9, the branches have no
    /// displacement in common, or the forward branch lies below the reverse one.
    pub fn from_branches(forward: &[(f64, f64)], reverse: &[(f64, f64)]) -> Result<Self, DirectShearError> {
        Self::from_named(forward, reverse, "friction loop")
    }

    fn from_named(
        forward: &[(f64, f64)],
        reverse: &[(f64, f64)],
        file: &str,
    ) -> Result<Self, DirectShearError> {
        let refuse =
            |problem: &str| DirectShearError::Loop { file: file.to_owned(), problem: problem.to_owned() };
        if forward.len() < 2 || reverse.len() < 2 {
            return Err(refuse("each direction needs at least two points"));
        }
        if !forward.iter().chain(reverse).all(|point| reading_ok(point.0) && reading_ok(point.1)) {
            return Err(refuse("a reading is not between -1e9 and 1e9; remove that row"));
        }
        let (forward, reverse) = (sorted(forward), sorted(reverse));
        let from = forward[0].0.max(reverse[0].0);
        let to = forward[forward.len() - 1].0.min(reverse[reverse.len() - 1].0);
        let half = if from < to { (mean(&forward, from, to) - mean(&reverse, from, to)) / 2.0 } else { 0.0 };
        Self::checked(half, from, to, file)
    }
}

fn sorted(branch: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut branch = branch.to_vec();
    // The reverse branch is recorded backwards.
    branch.sort_by(|a, b| a.0.total_cmp(&b.0));
    branch
}

/// Mean over `from..to` of the broken line through the points: samples need not be evenly spaced.
fn mean(branch: &[(f64, f64)], from: f64, to: f64) -> f64 {
    let mut integral = 0.0;
    for pair in branch.windows(2) {
        let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
        let (a, b) = (x0.max(from), x1.min(to));
        if b > a {
            let at = |x: f64| y0 + (y1 - y0) * (x - x0) / (x1 - x0);
            integral += f64::midpoint(at(a), at(b)) * (b - a);
        }
    }
    integral / (to - from)
}

/// Reads a friction loop from a CSV file with the columns `displacement_mm, shear_force_n, direction`, the last one
/// `forward` or `reverse`; others are ignored.
///
/// # Errors
/// A [`DirectShearError`] with file, line and column for anything wrong in a cell, and those of
/// [`FrictionLoop::from_branches`].
pub fn read_friction_loop(path: impl AsRef<Path>) -> Result<FrictionLoop, DirectShearError> {
    from_table(&Table::read(path.as_ref())?)
}

/// The same as [`read_friction_loop`] for the bytes of a table; `name` stands in for the file in messages.
///
/// # Errors
/// As [`read_friction_loop`].
pub fn parse_friction_loop(bytes: &[u8], name: &str) -> Result<FrictionLoop, DirectShearError> {
    from_table(&Table::parse(bytes, name)?)
}

fn from_table(table: &Table) -> Result<FrictionLoop, DirectShearError> {
    table.refuse_misspelt(&["displacement_mm", "shear_force_n", "direction"])?;
    let displacement_column = table.require("displacement_mm")?;
    let force_column = table.require("shear_force_n")?;
    let direction_column = table.require("direction")?;
    let (mut forward, mut reverse) = (Vec::new(), Vec::new());
    for row in &table.rows {
        let displacement_mm = table.number(row, displacement_column, READING_ALLOWED, reading_ok)?;
        let force = table.number(row, force_column, READING_ALLOWED, reading_ok)?;
        let branch = match table.text(row, direction_column)? {
            "forward" => &mut forward,
            "reverse" => &mut reverse,
            _ => return Err(table.cell_error(row, direction_column, "`forward` or `reverse`")),
        };
        branch.push((displacement_mm * 1e-3, force));
    }
    FrictionLoop::from_named(&forward, &reverse, &table.file)
}
