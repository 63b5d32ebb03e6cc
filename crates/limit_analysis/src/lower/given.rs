//! Lines along which the shear stress is given: there the slope of the stress function across the line is known up to
//! a constant, which lines that go on straight have in common.

use soilctl_certificate::{Condition, LineUse};
use soilctl_conic::{Form, Program};

use super::reference::ReferenceStress;
use super::unknown_jet::Unknown;
use crate::problem::Problem;
use crate::vector::{between, turned};

/// The slope across a line of given shear as a function of the position along it.
#[derive(Debug, Clone)]
pub(crate) struct Across {
    /// The line's normal: its vector turned left.
    pub(crate) n: [f64; 2],
    /// What the slope must change by per unit of `s`, at both ends.
    shear: [Form; 2],
    /// Where the constant below holds.
    origin: f64,
    constant: Form,
    /// The unknown behind the constant, if the lines touch no gauge.
    pub(crate) free: Option<Unknown>,
    /// Lines that share a constant have the same number.
    pub(crate) group: usize,
}

/// Where lines of given shear meet free boundaries: for each line, gauges with their slopes there and the position on
/// the line, 0 or 1.
pub(crate) type Touching = Vec<Vec<(usize, [Form; 2], f64)>>;

/// Groups of sides of given shear, in the order of their walk, that go on straight: all vertical or all level, and all
/// far or all not.
fn groups(problem: &Problem) -> Vec<Vec<LineUse>> {
    let kind = |side: LineUse| {
        let [p, q] = problem.ends(side.line);
        let axis = if p[0] == q[0] {
            Some(0)
        } else if p[1] == q[1] {
            Some(1)
        } else {
            None
        };
        let far = problem.condition(side) == Some(Condition::Far);
        axis.map(|a| (a, far))
    };
    let mut groups: Vec<Vec<LineUse>> = Vec::new();
    let mut seen = vec![false; problem.statement().lines.len()];
    for run in problem.statement().runs(|b| b.condition.shear_is_given()) {
        let mut parts: Vec<Vec<LineUse>> = Vec::new();
        for side in run.sides {
            // Both sides of a thin plate have one slope across.
            if std::mem::replace(&mut seen[side.line], true) {
                continue;
            }
            match parts.last_mut() {
                Some(part) if kind(side).is_some() && kind(part[part.len() - 1]) == kind(side) => {
                    part.push(side);
                }
                _ => parts.push(vec![side]),
            }
        }
        // A closed run may start in the middle of a straight piece.
        if run.closed
            && parts.len() > 1
            && kind(parts[0][0]).is_some()
            && kind(parts[0][0]) == parts.last().and_then(|p| kind(*p.last()?))
            && let Some(mut last) = parts.pop()
        {
            last.append(&mut parts[0]);
            parts[0] = last;
        }
        groups.append(&mut parts);
    }
    groups
}

/// The slopes across all lines of given shear, one entry a line of the statement.
pub(crate) fn slopes_across(
    problem: &Problem,
    reference: &ReferenceStress,
    touching: &Touching,
    program: &mut Program,
) -> Vec<Option<Across>> {
    let mut all: Vec<Option<Across>> = vec![None; problem.statement().lines.len()];
    let boundaries = &problem.statement().boundaries;
    let index = |side: &LineUse| boundaries.iter().position(|b| b.side() == *side);
    let mut groups = groups(problem);
    // Unknowns are handed out in the order of the lines.
    groups.sort_by_key(|g| g.iter().map(|s| s.line).min());
    for (group, sides) in groups.iter().enumerate() {
        let touched = sides.iter().position(|s| !touching[s.line].is_empty());
        let least = (0..sides.len()).min_by_key(|i| index(&sides[*i])).unwrap_or(0);
        let anchor = touched.unwrap_or(least);
        let mut bare: Vec<Across> =
            sides.iter().map(|s| Across::without_constant(problem, reference, *s, group)).collect();
        let n = bare[anchor].n;
        match touching[sides[anchor].line].first() {
            Some((_, [gx, gy], at)) => {
                bare[anchor].origin = *at;
                bare[anchor].constant = Form::default().plus(n[0], gx).plus(n[1], gy);
            }
            None => {
                let free = Unknown { index: program.unknown(), unit: n[0].hypot(n[1]) };
                bare[anchor].constant = free.form();
                bare[anchor].free = Some(free);
            }
        }
        // From the anchor on, forwards and backwards: at a joint both lines have the same slope across per length.
        let carry = |bare: &mut Vec<Across>, from: usize, to: usize| {
            let exit = if to > from { sides[from].forward } else { !sides[from].forward };
            let entry = if to > from { !sides[to].forward } else { sides[to].forward };
            let end = |forward: bool| if forward { 1.0 } else { 0.0 };
            let (n, m) = (bare[from].n, bare[to].n);
            let ratio = if n[0] == 0.0 { m[1] / n[1] } else { m[0] / n[0] };
            bare[to].constant = Form::default().plus(ratio, &bare[from].at(end(exit)));
            bare[to].origin = end(entry);
        };
        for to in anchor + 1..sides.len() {
            carry(&mut bare, to - 1, to);
        }
        for to in (0..anchor).rev() {
            carry(&mut bare, to + 1, to);
        }
        for (side, across) in sides.iter().zip(bare) {
            all[side.line] = Some(across);
        }
    }
    all
}

impl Across {
    fn without_constant(problem: &Problem, reference: &ReferenceStress, side: LineUse, group: usize) -> Self {
        let [p, q] = problem.ends(side.line);
        let t = between(p, q);
        let n = turned(t);
        let region = problem.owner(side).unwrap_or(0);
        let shear = |at: [f64; 2]| {
            let [xx, yy, xy] = reference.at(region, at);
            Form::default().plus(t[0] * n[0], &xx).plus(t[1] * n[1], &yy).plus(t[0] * n[1] + t[1] * n[0], &xy)
        };
        // Far lines carry the shear of the reference, all others none.
        let far = problem.condition(side) == Some(Condition::Far);
        let shear = if far { [Form::default(), Form::default()] } else { [shear(p), shear(q)] };
        Self { n, shear, origin: 0.0, constant: Form::default(), free: None, group }
    }

    pub(crate) fn at(&self, s: f64) -> Form {
        let [a, b] = &self.shear;
        let weights = |s: f64| (s - s * s / 2.0, s * s / 2.0);
        let (to, from) = (weights(s), weights(self.origin));
        self.constant.clone().plus(to.0 - from.0, a).plus(to.1 - from.1, b)
    }
}
