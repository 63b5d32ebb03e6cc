//! Free and loaded boundary: the tractions there, and the stress function that goes with them.
//! Where a beam lines the soil they act on that, and the function is the one beyond the beam.
//!
//! Tractions of a stress function on a boundary walked with the soil on the left add up to the change of `(f_y, -f_x)`. So
//! along a run of sides with given tractions `f` is an affine function plus one that follows from the loads: with `T(s)`
//! the traction beyond the reference's, times the length of the side, slopes change by the integral of `T` turned left.

use std::collections::BTreeMap;

use super::ends;
use super::references::ReferenceStresses;
use crate::CertificateError;
use crate::fields::LowerField;
use crate::interval::{Interval, Vector};
use crate::problem::Problem;
use crate::statement::{Boundary, Condition, LineUse, Objective};
use crate::tiling::{Beyond, OnLine, Tiling};

/// One side of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stretch {
    pub(super) side: LineUse,
    /// From its start to its end.
    pub(super) along: Vector,
    /// `T` at its start and end.
    tractions: [Vector; 2],
    /// Value and slopes of the particular function at its start.
    value: Interval,
    slopes: Vector,
}

impl Stretch {
    pub(super) fn traction(&self, s: Interval) -> Vector {
        let [first, last] = self.tractions;
        first * (Interval::ONE - s) + last * s
    }

    /// `T` is linear: its mean up to `s` is that of its ends.
    pub(super) fn slopes_at(&self, s: Interval) -> Vector {
        self.slopes + (self.tractions[0] + self.traction(s)).turned() * s.half()
    }

    pub(super) fn value_at(&self, s: Interval) -> Interval {
        let twice = self.tractions[0] + (self.tractions[0] + self.traction(s));
        let bend = twice.turned().dot(self.along) * s.square() / Interval::point(6.0);
        self.value + s * self.slopes.dot(self.along) + bend
    }

    /// The fraction of the way along the side.
    fn walked(&self, s: Interval) -> Interval {
        if self.side.forward { s } else { Interval::ONE - s }
    }
}

/// A place on a run. Two that are equal are one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) run: usize,
    /// Number of the side in the run; at the end of a side, that of the next one.
    number: usize,
    /// Fraction of the side's line; none at the start of the side.
    s: Option<f64>,
}

/// The particular functions of all runs of free and loaded sides.
pub(super) struct Loads {
    runs: Vec<Vec<Stretch>>,
    /// Run and number of each side.
    numbers: BTreeMap<LineUse, (usize, usize)>,
}

impl Loads {
    pub(super) fn new(
        problem: &Problem,
        references: &ReferenceStresses,
        field: &LowerField,
    ) -> Result<Self, CertificateError> {
        let (mut runs, mut numbers) = (Vec::new(), BTreeMap::new());
        for run in problem.statement.runs(|b| b.condition.is_loaded()) {
            let place = |side: Option<&LineUse>| format!("line {}", side.map_or(0, |s| s.line));
            if run.closed {
                let what = "free or loaded sides all around";
                return Err(CertificateError::NotCovered { place: place(run.sides.first()), what });
            }
            let mut stretches = Vec::new();
            let (mut value, mut slopes) = (Interval::ZERO, Vector::ZERO);
            for side in run.sides {
                let tractions = tractions(problem, references, field, side)?;
                let along = walked(problem, side);
                let stretch = Stretch { side, along, tractions, value, slopes };
                (value, slopes) = (stretch.value_at(Interval::ONE), stretch.slopes_at(Interval::ONE));
                numbers.insert(side, (runs.len(), stretches.len()));
                stretches.push(stretch);
            }
            runs.push(stretches);
        }
        Ok(Self { runs, numbers })
    }

    /// The number of runs.
    pub(super) fn count(&self) -> usize {
        self.runs.len()
    }

    /// The run of a side.
    pub(super) fn run(&self, side: LineUse) -> Option<usize> {
        self.numbers.get(&side).map(|(run, _)| *run)
    }

    /// What is known of a side.
    pub(super) fn stretch(&self, side: LineUse) -> Option<Stretch> {
        self.numbers.get(&side).map(|(run, number)| self.runs[*run][*number])
    }

    /// The sides that a place is on: two where one ends and the next one starts.
    pub(super) fn sides_at(&self, at: Station) -> Vec<LineUse> {
        let before = at.number.checked_sub(1).filter(|_| at.s.is_none());
        let numbers = before.into_iter().chain([at.number]);
        numbers.filter_map(|number| self.runs[at.run].get(number)).map(|stretch| stretch.side).collect()
    }

    /// Whether no more than the reference's tractions act on the sides of a run up to this one.
    pub(super) fn is_at_rest_up_to(&self, side: LineUse) -> bool {
        let zero = |v: &Vector| v.x.is_zero() && v.y.is_zero();
        self.numbers.get(&side).is_some_and(|(run, number)| {
            self.runs[*run].iter().take(number + 1).all(|stretch| stretch.tractions.iter().all(zero))
        })
    }

    /// For each vertex copy, where it is on a run. Edges know, by the side of the line that they are on.
    pub(super) fn stations(
        &self,
        tiling: &Tiling,
        field: &LowerField,
    ) -> Result<Vec<Option<Station>>, CertificateError> {
        let mut stations: Vec<Option<Station>> = vec![None; field.copies.len()];
        for side in tiling.sides() {
            let Beyond::Boundary(on, _) = tiling.beyond(side) else { continue };
            let Some(places) = self.ends(on) else { continue };
            for (copy, station) in ends(field, side).into_iter().zip(places) {
                if *stations[copy].get_or_insert(station) != station {
                    let problem =
                        "it is at two places of free or loaded boundary that do not follow each other";
                    return Err(CertificateError::BadField { place: format!("vertex copy {copy}"), problem });
                }
            }
        }
        Ok(stations)
    }

    /// Where the start and the end of an edge are on its run.
    pub(super) fn ends(&self, on: OnLine) -> Option<[Station; 2]> {
        let (run, number) = self.numbers.get(&on.side).copied()?;
        let [start, end] = if on.side.forward { [0.0, 1.0] } else { [1.0, 0.0] };
        Some([on.start, on.end].map(|s| match s {
            s if s == start => Station { run, number, s: None },
            s if s == end => Station { run, number: number + 1, s: None },
            s => Station { run, number, s: Some(s) },
        }))
    }

    /// Value and slopes of the particular function.
    pub(super) fn jet(&self, at: Station) -> (Interval, Vector) {
        let stretches = &self.runs[at.run];
        let (stretch, s) = match stretches.get(at.number) {
            Some(stretch) => (stretch, at.s.map_or(Interval::ZERO, |s| stretch.walked(Interval::point(s)))),
            None => (&stretches[stretches.len() - 1], Interval::ONE),
        };
        (stretch.value_at(s), stretch.slopes_at(s))
    }

    /// Slopes of the particular function in the middle of an edge; zero if its tractions are not given.
    pub(super) fn middle_slopes(&self, on: OnLine) -> Vector {
        let Some((run, number)) = self.numbers.get(&on.side).copied() else { return Vector::ZERO };
        let stretch = &self.runs[run][number];
        stretch.slopes_at(stretch.walked((Interval::point(on.start) + Interval::point(on.end)).half()))
    }
}

fn walked(problem: &Problem, side: LineUse) -> Vector {
    let along = problem.direction(side.line);
    if side.forward { along } else { -along }
}

/// The given tractions beyond those of the reference at the start and the end of a side, times its length.
fn tractions(
    problem: &Problem,
    references: &ReferenceStresses,
    field: &LowerField,
    side: LineUse,
) -> Result<[Vector; 2], CertificateError> {
    let statement = problem.statement;
    let surcharge = Interval::point(statement.surcharge);
    let mut loads = match problem.condition(side) {
        Some(Condition::Loaded { pressure, shear, live } | Condition::Lined { pressure, shear, live }) => {
            let factor = if live && statement.objective == Objective::Loads {
                Interval::point(field.multiplier)
            } else {
                Interval::ONE
            };
            [0, 1].map(|i| [pressure[i], shear[i]].map(|x| factor * Interval::point(x)))
        }
        Some(Condition::Submerged) => problem.pore_pressure(side).map(|pressure| [pressure, Interval::ZERO]),
        _ => [[surcharge, Interval::ZERO]; 2],
    };
    if !side.forward {
        loads.reverse();
    }
    let along = walked(problem, side);
    let outward = -along.turned();
    let ends = problem.walked(side).map(Vector::point);
    let region = problem.owner(side).unwrap_or(0);
    Ok([0, 1].map(|i| {
        let [pressure, shear] = loads[i];
        // The pressure beyond the surcharge is exactly zero if it is the surcharge.
        let carried = references.of(region).excess(ends[i]).with_mean(pressure - surcharge);
        along * shear - carried.on(outward)
    }))
}

/// Boundary sides at which the effective stress must vanish: nothing acts, or no more than the pore water bears, and the soil has no
/// strength without a load.
pub(super) fn is_bare(problem: &Problem, boundary: &Boundary) -> bool {
    let region = problem.owner(boundary.side()).and_then(|r| problem.statement.regions.get(r));
    boundary.condition.leaves_bare(problem.statement.surcharge)
        && region.is_some_and(|r| r.material.cohesion.is_zero())
}
