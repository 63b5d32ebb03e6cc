//! Free and loaded boundaries: there the stress function is known up to an affine function.

use std::collections::BTreeMap;

use soilctl_certificate::{Condition, LineUse, Objective, Run};
use soilctl_conic::Form;

use super::reference::ReferenceStress;
use crate::problem::Problem;
use crate::vector::{Point, turned};

fn dot(a: Point, b: &[Form; 2]) -> Form {
    Form::default().plus(a[0], &b[0]).plus(a[1], &b[1])
}

/// A vector of forms, a quarter turn to the left.
fn left([x, y]: &[Form; 2]) -> [Form; 2] {
    [Form::default().plus(-1.0, y), x.clone()]
}

/// What the loads demand along one side, walked with the soil on the left.
#[derive(Debug, Clone)]
struct Side {
    run: usize,
    /// From its start to its end.
    along: Point,
    /// Value and slopes at its start.
    start: (Form, [Form; 2]),
    /// Traction that the stress function must carry at the start and the end, times the length.
    traction: [[Form; 2]; 2],
}

/// All free and loaded sides.
#[derive(Debug, Clone, Default)]
pub(crate) struct Loads {
    pub(crate) runs: Vec<Run>,
    sides: BTreeMap<LineUse, Side>,
}

impl Loads {
    pub(crate) fn new(problem: &Problem, reference: &ReferenceStress) -> Self {
        let runs = problem.statement().runs(|b| b.condition.is_loaded());
        let mut sides = BTreeMap::new();
        for (number, run) in runs.iter().enumerate() {
            let mut start = (Form::default(), [Form::default(), Form::default()]);
            for side in &run.sides {
                let this = Side::new(problem, reference, number, *side, start);
                start = this.at(1.0);
                sides.insert(*side, this);
            }
        }
        Self { runs, sides }
    }

    /// The run of a side.
    pub(crate) fn run(&self, side: LineUse) -> Option<usize> {
        Some(self.sides.get(&side)?.run)
    }

    /// The sides at a place on a side: it and, where it starts or ends, the one before or after.
    pub(crate) fn sides_at(&self, side: LineUse, is_start: bool, is_end: bool) -> Vec<LineUse> {
        let Some(run) = self.run(side) else { return Vec::new() };
        let sides = &self.runs[run].sides;
        let place = sides.iter().position(|other| *other == side).unwrap_or(0);
        let before = place.checked_sub(1).filter(|_| is_start);
        let after = Some(place + 1).filter(|next| is_end && *next < sides.len());
        before.into_iter().chain([place]).chain(after).map(|i| sides[i]).collect()
    }

    /// Whether no more than the reference's tractions act on the sides of a run up to this one.
    pub(crate) fn is_at_rest_up_to(&self, side: LineUse) -> bool {
        let Some(run) = self.run(side) else { return false };
        let mut sides = self.runs[run].sides.iter();
        let up_to = sides.position(|other| *other == side).unwrap_or(0);
        let zero = |f: &Form| f.constant == 0.0 && f.terms.iter().all(|t| t.1 == 0.0);
        self.runs[run].sides[..=up_to]
            .iter()
            .all(|side| self.sides.get(side).is_some_and(|s| s.traction.iter().flatten().all(zero)))
    }

    /// Value, slopes and traction, beyond the run's affine function, at a fraction of the way along a side or beyond its ends.
    pub(crate) fn beyond(&self, side: LineUse, s: f64) -> (Form, [Form; 2], [Form; 2]) {
        let zero = || [Form::default(), Form::default()];
        let Some(this) = self.sides.get(&side) else { return (Form::default(), zero(), zero()) };
        let (value, slopes) = this.at(s);
        (value, slopes, this.mixed(1.0 - s, s))
    }

    /// Value and slopes, beyond the run's affine function, at a fraction of the line itself.
    pub(crate) fn at(&self, side: LineUse, s: f64) -> [Form; 3] {
        let Some(this) = self.sides.get(&side) else {
            return std::array::from_fn(|_| Form::default());
        };
        let (value, [x, y]) = this.at(if side.forward { s } else { 1.0 - s });
        [value, x, y]
    }
}

impl Side {
    fn new(
        problem: &Problem,
        reference: &ReferenceStress,
        run: usize,
        side: LineUse,
        start: (Form, [Form; 2]),
    ) -> Self {
        let mut ends = problem.ends(side.line);
        let region = problem.owner(side).unwrap_or(0);
        let condition = problem.condition(side).unwrap_or(Condition::Free);
        let (mut pressure, mut shear, live) = match condition {
            Condition::Loaded { pressure, shear, live } | Condition::Lined { pressure, shear, live } => {
                (pressure, shear, live)
            }
            Condition::Submerged => (problem.statement().pore_pressure(side), [0.0; 2], false),
            _ => ([reference.surcharge(); 2], [0.0; 2], false),
        };
        if !side.forward {
            ends.reverse();
            pressure.reverse();
            shear.reverse();
        }
        let along = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
        let out = [along[1], -along[0]];
        let factor = if live && problem.statement().objective == Objective::Loads {
            reference.factor()
        } else {
            Form::constant(1.0)
        };
        let traction = std::array::from_fn(|i| {
            let [xx, yy, xy] = reference.at(region, ends[i]);
            std::array::from_fn(|axis| {
                let on = if axis == 0 { [&xx, &xy] } else { [&xy, &yy] };
                Form::default()
                    .plus(shear[i] * along[axis] - pressure[i] * out[axis], &factor)
                    .plus(-out[0], on[0])
                    .plus(-out[1], on[1])
            })
        });
        Self { run, along, start, traction }
    }

    /// The tractions of start and end, so much of each.
    fn mixed(&self, a: f64, b: f64) -> [Form; 2] {
        let [t0, t1] = &self.traction;
        std::array::from_fn(|i| Form::default().plus(a, &t0[i]).plus(b, &t1[i]))
    }

    /// Value and slopes at a fraction of the side: tractions add up to the change of the slopes, turned.
    fn at(&self, s: f64) -> (Form, [Form; 2]) {
        // With T(s) = (1 - s) T0 + s T1.
        let [dx, dy] = left(&self.mixed(s - s * s / 2.0, s * s / 2.0));
        let slopes = [self.start.1[0].clone().plus(1.0, &dx), self.start.1[1].clone().plus(1.0, &dy)];
        let bent = left(&self.mixed(s * s / 2.0 - s * s * s / 6.0, s * s * s / 6.0));
        let value =
            self.start.0.clone().plus(s, &dot(self.along, &self.start.1)).plus(1.0, &dot(self.along, &bent));
        (value, slopes)
    }
}

/// The edge vector turned left, for the slope across an edge.
pub(crate) fn across(edge: Point, slopes: &[Form; 3]) -> Form {
    let n = turned(edge);
    Form::default().plus(n[0], &slopes[1]).plus(n[1], &slopes[2])
}
