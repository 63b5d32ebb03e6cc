//! Lines along which the shear stress is given: there the slope of the stress function across the line is known up to
//! a constant.

use soilctl_certificate::Condition;

use super::macro_element::turned;
use super::shape::Unknown;
use crate::form::Form;
use crate::problem::Problem;
use crate::program::Program;

/// Whether the condition fixes the shear stress.
pub(crate) fn shear_is_given(condition: Condition) -> bool {
    match condition {
        Condition::Smooth | Condition::Far => true,
        Condition::Face { delta_deg, adhesion } => delta_deg == 0.0 && adhesion == 0.0,
        Condition::Free | Condition::Fixed => false,
    }
}

/// The slope across a line of given shear as a function of the position along it.
#[derive(Debug, Clone)]
pub(crate) struct Across {
    /// The line's normal: its vector turned left.
    pub(crate) n: [f64; 2],
    /// What the slope must change by per unit of `s`, at both ends.
    shear: [f64; 2],
    /// Where the constant below holds.
    origin: f64,
    constant: Form,
    /// The unknown behind the constant, if the line touches no chain.
    pub(crate) free: Option<Unknown>,
}

/// How a line of given shear meets free boundaries.
#[derive(Debug, Clone, Default)]
pub(crate) struct Touching {
    pub(crate) given: bool,
    pub(crate) far: bool,
    /// Chains and the position on the line, 0 or 1.
    pub(crate) chains: Vec<(usize, f64)>,
}

impl Across {
    pub(crate) fn new(
        problem: &Problem,
        line: usize,
        touching: &Touching,
        chains: &[[Form; 3]],
        program: &mut Program,
    ) -> Self {
        let [p, q] = problem.ends(line);
        let t = [q[0] - p[0], q[1] - p[1]];
        let n = turned(t);
        let shear = |at: [f64; 2]| {
            let [xx, yy, xy] = problem.reference(at);
            xx * t[0] * n[0] + yy * t[1] * n[1] + xy * (t[0] * n[1] + t[1] * n[0])
        };
        // Far lines carry the shear of the reference, all others none.
        let shear = if touching.far { [0.0; 2] } else { [shear(p), shear(q)] };
        let (origin, constant, free) = match touching.chains.first() {
            Some(&(chain, origin)) => {
                let [_, gx, gy] = &chains[chain];
                (origin, Form::default().plus(n[0], gx).plus(n[1], gy), None)
            }
            None => {
                let free = Unknown { index: program.unknown(), unit: n[0].hypot(n[1]) };
                (0.0, free.form(), Some(free))
            }
        };
        Self { n, shear, origin, constant, free }
    }

    pub(crate) fn at(&self, s: f64) -> Form {
        let [a, b] = self.shear;
        let integral = |s: f64| a * s + (b - a) * s * s / 2.0;
        Form::constant(integral(s) - integral(self.origin)).plus(1.0, &self.constant)
    }
}
