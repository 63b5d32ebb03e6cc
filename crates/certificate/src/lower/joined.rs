//! Lines of given shear that follow each other in one direction share one constant.

use crate::CertificateError;
use crate::problem::Problem;
use crate::statement::Condition;

/// What the proof needs to know of lines of given shear that are joined: one or more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joined {
    /// The first line by the statement's boundaries.
    pub(super) first: usize,
    /// Whether they are far.
    pub(super) far: bool,
}

/// For each line of the statement, the lines that it is joined to, if it is one of given shear. Lines are joined where they
/// meet along the soil and both are exactly vertical, or both exactly level, and both far or both not.
pub(super) fn joined(problem: &Problem) -> Result<Vec<Option<Joined>>, CertificateError> {
    let statement = problem.statement;
    // First, each is joined to itself only.
    let mut lines: Vec<Option<Joined>> = vec![None; statement.lines.len()];
    for boundary in statement.boundaries.iter().filter(|b| b.condition.shear_is_given()) {
        let far = boundary.condition == Condition::Far;
        let line = lines[boundary.line].get_or_insert(Joined { first: boundary.line, far });
        if line.far != far {
            let problem = "far on one side and a boundary on the other";
            return Err(CertificateError::BadStatement { place: format!("line {}", boundary.line), problem });
        }
    }
    let index = |line: usize| {
        statement.boundaries.iter().position(|b| b.line == line && b.condition.shear_is_given())
    };
    for run in statement.runs(|b| b.condition.shear_is_given()) {
        let next = run.sides.iter().cycle().skip(1);
        // The last side leads to the first one if the run is closed; if not, `next` is cut short.
        let pairs = if run.closed { run.sides.len() } else { run.sides.len() - 1 };
        for (a, b) in run.sides.iter().zip(next).take(pairs) {
            let (Some(at_a), Some(at_b)) = (lines[a.line], lines[b.line]) else { continue };
            if at_a.far != at_b.far || at_a.first == at_b.first || !in_one_direction(problem, a.line, b.line)
            {
                continue;
            }
            let first = if index(at_a.first) <= index(at_b.first) { at_a.first } else { at_b.first };
            for line in lines.iter_mut().flatten() {
                if line.first == at_a.first || line.first == at_b.first {
                    line.first = first;
                }
            }
        }
    }
    Ok(lines)
}

fn in_one_direction(problem: &Problem, a: usize, b: usize) -> bool {
    let [a, b] = [a, b].map(|line| problem.direction(line));
    (a.x.is_zero() && b.x.is_zero()) || (a.y.is_zero() && b.y.is_zero())
}
