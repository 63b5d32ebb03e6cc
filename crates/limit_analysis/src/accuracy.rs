//! How exactly the programs of bounds are solved.

use soilctl_conic::Accuracy;

/// For upper bounds: the gap shows in the bound.
pub(crate) const FLOW: Accuracy =
    Accuracy { gap: 1e-5, feasibility: 1e-8, steps: 1e-10, regularisation: 1e-10 };

/// For upper bounds that seem infeasible: above 40 degrees of friction that may be the regularisation's doing. With less of
/// it the last digits suffer, so this is no first choice.
pub(crate) const FLOW_AGAIN: Accuracy = Accuracy { regularisation: 1e-12, ..FLOW };

/// For upper bounds whose solver fails: with much friction or far sides its systems are so badly conditioned that steps come
/// to nothing. Most of these programs are solved with more regularisation.
pub(crate) const FLOW_STEADY: Accuracy = Accuracy { regularisation: 1e-8, ..FLOW };

/// For lower bounds: what a stress field misses its cones by costs much of the bound. Their systems are also much worse
/// conditioned (fourth order against second): with the regularisation that is best for flows, programs of 5,000
/// elements at 45 degrees of friction stall.
pub(crate) const STRESS: Accuracy =
    Accuracy { gap: 1e-6, feasibility: 1e-8, steps: 1e-8, regularisation: 1e-13 };

/// For lower bounds of soil with curved strength: many lines that are nearly parallel make their programs stall with as little regularisation.
pub(crate) const STRESS_BELOW_LINES: Accuracy = Accuracy { regularisation: 1e-11, ..STRESS };

/// For lower bounds in space: their semidefinite cones do not bear less regularisation, and gain nothing by more accuracy.
pub(crate) const SPACE: Accuracy =
    Accuracy { gap: 1e-6, feasibility: 1e-6, steps: 1e-9, regularisation: 1e-7 };

/// Solves a program of a test to the end.
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "helper of tests")]
pub(crate) fn solve_through(program: &soilctl_conic::Program, accuracy: Accuracy) -> soilctl_conic::Answer {
    let how = soilctl_conic::How { accuracy, factorisation: None, seconds: None, dump: None };
    soilctl_conic::solve(program, how, [&std::sync::Arc::default(); 2]).unwrap()
}
