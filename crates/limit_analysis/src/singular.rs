//! Where stresses are singular, and how large a problem is.

use soilctl_certificate::{Boundary, Condition, Objective};

use crate::problem::Problem;
use crate::vector::distance;

/// Height of what is not held: from the lowest to the highest point with a free or loaded side; if it is level, the depth
/// of the soil.
pub(crate) fn open_height(problem: &Problem) -> f64 {
    let of = |points: &[[f64; 2]]| {
        let heights = || points.iter().map(|p| p[1]);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    };
    let statement = problem.statement();
    let open: Vec<[f64; 2]> = statement
        .boundaries
        .iter()
        .filter(|b| b.condition.is_loaded())
        .flat_map(|b| problem.ends(b.line))
        .collect();
    let height = of(&open);
    if height > 0.0 { height } else { of(&statement.points) }
}

fn is_live(condition: Condition) -> bool {
    matches!(condition, Condition::Loaded { live: true, .. } | Condition::Lined { live: true, .. })
}

/// Length of the live loads, height of a slope; one for structures.
pub(crate) fn typical_length(problem: &Problem) -> f64 {
    let statement = problem.statement();
    match statement.objective {
        Objective::Structure { .. } => 1.0,
        Objective::Body { .. } | Objective::Everything => open_height(problem),
        Objective::Loads => {
            let live = statement.boundaries.iter().filter(|b| is_live(b.condition));
            let ends = live.map(|b| problem.ends(b.line));
            let length: f64 = ends.map(|[p, q]| distance(p, q)).sum();
            if length > 0.0 { length } else { 1.0 }
        }
    }
}

/// Whether a point is where bare soil without cohesion meets a smooth line, and the weight is not vertical. The stress
/// vanishes there, and the shear stress of the reference along the line must be taken back by a function that no other
/// point of the surface restricts: elements next to the point need a corner inside.
fn is_sheared(problem: &Problem, point: usize) -> bool {
    let s = problem.statement();
    let live = match s.objective {
        Objective::Body { gravity } => gravity[0],
        _ => 0.0,
    };
    if s.surcharge != 0.0 || (s.gravity[0] == 0.0 && live == 0.0) {
        return false;
    }
    let there = |b: &&Boundary| s.lines[b.line].touches(point);
    let touching = || s.boundaries.iter().filter(there);
    let bare = |b: &Boundary| {
        let cohesionless = problem.owner(b.side()).is_some_and(|r| problem.soils[r].cohesion.is_zero());
        matches!(b.condition, Condition::Free | Condition::Submerged) && cohesionless
    };
    let smooth = |b: &Boundary| b.condition.shear_is_given() && b.condition != Condition::Far;
    touching().any(bare) && touching().any(smooth)
}

/// Points at which two sides that are free, loaded or faces meet in a notch of the soil's rim, or in line with different
/// loads; and those that need elements of their own.
pub(crate) fn singular_points(problem: &Problem) -> Vec<usize> {
    let statement = problem.statement();
    let is_open = |c: Condition| c.is_loaded() || matches!(c, Condition::Face { .. });
    // As they are walked with the soil on the left: start, end, and condition there.
    let sides: Vec<(usize, usize, Condition, bool)> = statement
        .boundaries
        .iter()
        .filter(|b| is_open(b.condition))
        .map(|b| {
            let [from, to] = statement.lines[b.line].walked(b.forward);
            let condition = match b.condition {
                Condition::Submerged => {
                    let pressure = statement.pore_pressure(b.side());
                    Condition::Loaded { pressure, shear: [0.0; 2], live: false }
                }
                other => other,
            };
            (from, to, condition, b.forward)
        })
        .collect();
    let at_end = |(_, _, condition, forward): &(usize, usize, Condition, bool), end: bool| match *condition {
        Condition::Loaded { pressure, shear, .. } | Condition::Lined { pressure, shear, .. } => {
            let i = usize::from(*forward == end);
            Some([pressure[i], shear[i]])
        }
        Condition::Free => Some([statement.surcharge, 0.0]),
        _ => None,
    };
    let is_singular = |point: &usize| {
        let [into, out] = [true, false].map(|ends| {
            let mut there = sides.iter().filter(|s| if ends { s.1 == *point } else { s.0 == *point });
            (there.next(), there.next())
        });
        let ((Some(a), None), (Some(b), None)) = (into, out) else { return false };
        let [p, q, r] = [a.0, *point, b.1].map(|i| statement.points[i]);
        let turn = (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]);
        let straight = 1e-6 * distance(q, p) * distance(r, q);
        let is_lined = |c: Condition| matches!(c, Condition::Lined { .. });
        let differ = at_end(a, true) != at_end(b, false)
            || is_live(a.2) != is_live(b.2)
            || is_lined(a.2) != is_lined(b.2);
        turn < -straight || (turn <= straight && differ)
    };
    let is_one = |p: &usize| is_singular(p) || is_sheared(problem, *p);
    (0..statement.points.len()).filter(is_one).collect()
}
