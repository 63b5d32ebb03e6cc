//! The power of a flow as a linear function of all unknowns.

use soilctl_certificate::{Condition, Objective};
use soilctl_conic::Form;

use crate::problem::{Problem, Soil};
use crate::singular::{open_height, typical_length};
use crate::vector::distance;

/// A linear function of many unknowns, quick to add to.
#[derive(Debug, Clone, Default)]
struct Sum {
    constant: f64,
    coefficients: Vec<f64>,
}

impl Sum {
    fn add(&mut self, factor: f64, form: &Form) {
        self.constant += factor * form.constant;
        for &(index, coefficient) in &form.terms {
            if self.coefficients.len() <= index {
                self.coefficients.resize(index + 1, 0.0);
            }
            self.coefficients[index] += factor * coefficient;
        }
    }

    fn divided(&self, by: f64) -> Form {
        let terms = self.coefficients.iter().enumerate().filter(|t| *t.1 != 0.0);
        Form { constant: self.constant / by, terms: terms.map(|(i, c)| (i, c / by)).collect() }
    }
}

/// Dissipation less the power of dead loads, and the power of the loads whose factor is bounded.
#[derive(Debug, Clone, Default)]
pub(super) struct Power {
    net: Sum,
    live: Sum,
}

impl Power {
    pub(super) fn dissipate(&mut self, factor: f64, form: &Form) {
        self.net.add(factor, form);
    }

    pub(super) fn load(&mut self, factor: f64, form: &Form, live: bool) {
        if live { self.live.add(factor, form) } else { self.net.add(-factor, form) }
    }

    /// What is to be made small: the force, or the factor for flows on which the live loads' power is `size`.
    pub(super) fn bound(&self, size: f64) -> Form {
        self.net.divided(size)
    }

    /// What must be zero then.
    pub(super) fn normalised(&self, size: f64) -> Form {
        self.live.divided(size).plus(-1.0, &Form::constant(1.0))
    }
}

/// Power of the live loads on velocities of the order of one; one if a structure's force is bounded.
pub(super) fn live_size(problem: &Problem) -> f64 {
    let statement = problem.statement();
    let size = match statement.objective {
        Objective::Structure { .. } => return 1.0,
        Objective::Loads => {
            let on = |b: &soilctl_certificate::Boundary| match b.condition {
                Condition::Loaded { pressure, shear, live: true }
                | Condition::Lined { pressure, shear, live: true } => {
                    let [p, q] = problem.ends(b.line);
                    let sum: f64 = pressure.iter().chain(&shear).map(|x| x.abs()).sum();
                    0.5 * sum * distance(p, q)
                }
                _ => 0.0,
            };
            statement.boundaries.iter().map(on).sum()
        }
        Objective::Body { .. } | Objective::Everything => {
            let gravity = match statement.objective {
                Objective::Body { gravity } => gravity,
                _ => statement.gravity,
            };
            let heaviest = problem.soils.iter().map(|s| s.unit_weight).fold(0.0, f64::max);
            let height = open_height(problem);
            0.5 * heaviest * gravity[0].hypot(gravity[1]) * height * height
        }
    };
    if size > 0.0 { size } else { 1.0 }
}

/// Factors on the objective of a program in which the live loads' power is normalised. The multiplier of that one long
/// row is the objective; the solver stalls before flow rules are met if it is much more than one. Flows of soil without
/// friction meet theirs anyway, and their power needs more figures.
const WITH_FRICTION: f64 = 1e-3;
const WITHOUT_FRICTION: f64 = 1e-2;

/// One of these over what the factor on the loads is likely to be.
pub(super) fn objective_unit(problem: &Problem, live: f64) -> f64 {
    let statement = problem.statement();
    let length = typical_length(problem);
    let at_corners = |material: &soilctl_certificate::Material| {
        statement.points.iter().map(|p| material.cohesion.at(*p)).fold(0.0, f64::max)
    };
    let on_side = |c: Condition| match c {
        Condition::Loaded { pressure, live, .. } | Condition::Lined { pressure, live, .. }
            if !(live && statement.objective == Objective::Loads) =>
        {
            pressure[0].abs().max(pressure[1].abs())
        }
        Condition::Submerged => problem.load(),
        _ => 0.0,
    };
    let cohesion = statement.regions.iter().map(|r| at_corners(&r.material)).fold(0.0, f64::max);
    let weight = problem.soils.iter().map(|s| s.unit_weight).fold(0.0, f64::max);
    let load = statement.boundaries.iter().map(|b| on_side(b.condition)).fold(statement.surcharge, f64::max);
    let dead = match statement.objective {
        Objective::Everything => 0.0,
        _ => load - statement.gravity[1] * weight * length,
    };
    let stress = cohesion + dead;
    let factor = stress * length / live;
    let unit = if problem.soils.iter().all(Soil::has_friction) { WITH_FRICTION } else { WITHOUT_FRICTION };
    if factor > 0.0 { unit / factor } else { unit }
}
