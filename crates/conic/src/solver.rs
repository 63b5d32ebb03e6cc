//! Clarabel, asked.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettings, DefaultSolver, IPSolver, SolverJSONReadWrite, SolverStatus, SupportedConeT,
};
use schemars::JsonSchema;
use serde::Serialize;

use crate::error::ConicError;
use crate::program::{Cone, Program};

/// How a solve ended. None of these proves anything: a certificate does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// To the accuracy asked for.
    Solved,
    /// To a lower accuracy.
    #[serde(rename = "almost_solved")]
    Almost,
    /// The cones cannot all be met: in a lower bound, soil that fails under its own weight; in an upper bound, a
    /// structure that cannot move.
    Infeasible,
    /// The objective has no limit.
    Unbounded,
    /// The user's time was up, or the user stopped the run.
    Stopped,
    /// Numerical trouble or too many steps.
    Failed,
}

/// What came back from the solver.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The unknowns, whatever the status says of them.
    pub x: Vec<f64>,
    /// How it ended.
    pub status: Status,
    /// Steps.
    pub iterations: u32,
    /// Time that they took.
    pub seconds: f64,
    /// What factorised them.
    pub factorisation: Factorisation,
    /// Unknowns and rows.
    pub size: usize,
    /// For each row of the program its multiplier, in units of the objective: by how much the least objective falls for each
    /// unit that is added to the row's form. Those of a cone lie in its dual.
    pub multipliers: Vec<f64>,
}

/// What factorises the linear systems of the solver's steps. With either a program has the same answer, bit for bit, on any
/// number of threads; bits of the two differ, and both are as good.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Factorisation {
    /// Clarabel's QDLDL: one column after another, in plain arithmetic, so bits are those of any other machine.
    Qdldl,
    /// Faer: blocks of columns, with the vector instructions that the processor has and blocks that fit its caches, so bits
    /// are those of any machine with the same processor.
    Faer,
}

impl Factorisation {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Qdldl, Self::Faer];

    /// The choice where the user makes none: by the size of the program only.
    fn of(program: &Program) -> Self {
        let is_small = program.unknowns + program.rows.len() < FAER_FROM;
        if is_small || cfg!(not(target_pointer_width = "64")) { Self::Qdldl } else { Self::Faer }
    }

    /// Its name, also for Clarabel.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Qdldl => "qdldl",
            Self::Faer => "faer",
        }
    }
}

/// Unknowns and rows of a program from which on faer takes clearly less time: 40,000 triangles of an upper bound or 20,000 of
/// a lower one, more than any run has that is not asked for them. `benches/scaling.rs` measures it.
const FAER_FROM: usize = 500_000;

/// The solver, as certificates name it.
pub const SOLVER: &str = "Clarabel 0.11.1";

/// How exactly a program is solved, relative to numbers of the order of one.
#[derive(Debug, Clone, Copy)]
pub struct Accuracy {
    /// Distance of the primal and the dual objective.
    pub gap: f64,
    /// Residuals.
    pub feasibility: f64,
    /// Residuals of the linear systems of each step.
    pub steps: f64,
    /// What is added to the diagonal of these systems. Rows and columns of small elements are small; the usual 1e-8 drowns
    /// them, and the steps stall.
    pub regularisation: f64,
}

/// Factor on the objective: multipliers of some thousand elements then are of the order of one.
const OBJECTIVE: f64 = 100.0;

/// How to solve a program.
#[derive(Debug, Clone, Copy)]
pub struct How<'a> {
    /// How exactly.
    pub accuracy: Accuracy,
    /// By the program's size if not given.
    pub factorisation: Option<Factorisation>,
    /// The user's limit on time in seconds.
    pub seconds: Option<f64>,
    /// Where a program that ends in numerical trouble is written, as a file from which Clarabel itself can solve it again.
    pub dump: Option<&'a Path>,
}

/// Solves a program on one thread, until one of the flags is set.
///
/// # Errors
///
/// The solver refuses the program, or one that failed cannot be written to [`How::dump`]. That a program has no solution is no error:
/// see [`Answer::status`].
pub fn solve<const N: usize>(
    program: &Program,
    how: How<'_>,
    stops: [&Arc<AtomicBool>; N],
) -> Result<Answer, ConicError> {
    if cfg!(not(all(target_os = "linux", target_pointer_width = "64")))
        && program.cones.contains(&Cone::Semidefinite3)
    {
        let message =
            "semidefinite cones are solved on Linux with addresses of 64 bits only, so far".to_owned();
        return Err(ConicError::Refused { message });
    }
    let factorisation = how.factorisation.unwrap_or_else(|| Factorisation::of(program));
    let (m, n) = (program.rows.len(), program.unknowns);
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); n];
    let mut b = Vec::with_capacity(m);
    for (row, form) in program.rows.iter().enumerate() {
        b.push(form.constant);
        for &(column, coefficient) in form.terms.iter().filter(|t| t.1 != 0.0) {
            columns[column].push((row, -coefficient));
        }
    }
    let mut starts = vec![0];
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for column in &columns {
        for &(row, value) in column {
            rows.push(row);
            values.push(value);
        }
        starts.push(rows.len());
    }
    let mut q = vec![0.0; n];
    for &(i, c) in &program.objective {
        q[i] += OBJECTIVE * c;
    }
    let a = CscMatrix::new(m, n, starts, rows, values);
    let p = CscMatrix::zeros((n, n));
    let refused = |message: String| ConicError::Refused { message };
    let mut solver = DefaultSolver::new(&p, &q, &a, &b, &cones(program), settings(how, factorisation))
        .map_err(|e| refused(e.to_string()))?;
    let stops = stops.map(Arc::clone);
    solver.set_termination_callback(move |_: &_| stops.iter().any(|stop| stop.load(Ordering::Relaxed)));
    solver.solve();
    let solution = &solver.solution;
    let status = match solution.status {
        SolverStatus::Solved => Status::Solved,
        SolverStatus::AlmostSolved => Status::Almost,
        SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => Status::Infeasible,
        SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible => Status::Unbounded,
        SolverStatus::MaxTime | SolverStatus::CallbackTerminated => Status::Stopped,
        _ => Status::Failed,
    };
    if status == Status::Failed
        && let Some(path) = how.dump
    {
        let failed = |e: std::io::Error| ConicError::Dump { path: path.to_owned(), message: e.to_string() };
        let mut file = File::create(path).map_err(failed)?;
        solver.save_to_file(&mut file).map_err(failed)?;
    }
    Ok(Answer {
        x: solution.x.clone(),
        status,
        iterations: solution.iterations,
        seconds: solution.solve_time,
        factorisation,
        size: n + m,
        multipliers: solution.z.iter().map(|z| z / OBJECTIVE).collect(),
    })
}

fn cones(program: &Program) -> Vec<SupportedConeT<f64>> {
    let mut cones: Vec<SupportedConeT<f64>> = Vec::new();
    for cone in &program.cones {
        match (cone, cones.last_mut()) {
            (Cone::NonNegative, Some(SupportedConeT::NonnegativeConeT(count)))
            | (Cone::Zero, Some(SupportedConeT::ZeroConeT(count))) => *count += 1,
            (Cone::NonNegative, _) => cones.push(SupportedConeT::NonnegativeConeT(1)),
            (Cone::Zero, _) => cones.push(SupportedConeT::ZeroConeT(1)),
            (Cone::SecondOrder3, _) => cones.push(SupportedConeT::SecondOrderConeT(3)),
            #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
            (Cone::Semidefinite3, _) => cones.push(SupportedConeT::PSDTriangleConeT(3)),
            #[cfg(not(all(target_os = "linux", target_pointer_width = "64")))]
            (Cone::Semidefinite3, _) => {}
        }
    }
    cones
}

fn settings(how: How<'_>, factorisation: Factorisation) -> DefaultSettings<f64> {
    let How { accuracy, seconds, .. } = how;
    let settings = DefaultSettings {
        verbose: false,
        time_limit: seconds.unwrap_or(f64::INFINITY),
        direct_solve_method: factorisation.name().to_owned(),
        // Faer would otherwise share out its sums among the threads of the machine.
        max_threads: 1,
        presolve_enable: false,
        // Rows and columns are scaled by lengths and stresses already; equilibration undoes that and costs twice the
        // steps.
        equilibrate_enable: false,
        iterative_refinement_reltol: accuracy.steps,
        iterative_refinement_abstol: accuracy.steps,
        static_regularization_constant: accuracy.regularisation,
        tol_gap_rel: accuracy.gap,
        tol_gap_abs: accuracy.gap,
        tol_feas: accuracy.feasibility,
        ..DefaultSettings::default()
    };
    // Matrices of three rows are not worth taking apart.
    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    let settings = DefaultSettings { chordal_decomposition_enable: false, ..settings };
    settings
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]

    use super::*;
    use crate::form::Form;

    #[test]
    fn only_large_programs_are_for_faer() {
        let mut program = Program { unknowns: FAER_FROM - 1, ..Program::default() };
        assert_eq!(Factorisation::of(&program), Factorisation::Qdldl);
        program.unknown();
        assert_eq!(Factorisation::of(&program), Factorisation::Faer);
    }

    /// The least `x` for which `x - M` has no negative eigenvalue is the greatest eigenvalue of `M`, and its multiplier is the
    /// matrix of its eigenvector: by both factorisations.
    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    #[test]
    fn the_greatest_eigenvalue_is_found_with_its_multiplier() {
        let t = 2.0 / 3.0;
        let mut program = Program::default();
        let x = program.unknown();
        program.objective.push((x, 1.0));
        let matrix = [1.5 + t, 0.5 + t, 1.5 + t, t, t, 2.0 + t];
        let on = [1.0, 0.0, 1.0, 0.0, 0.0, 1.0];
        program.semidefinite(std::array::from_fn(|k| {
            Form::constant(-matrix[k]).plus(on[k], &Form::unknown(x, 1.0))
        }));
        let accuracy = Accuracy { gap: 1e-9, feasibility: 1e-9, steps: 1e-12, regularisation: 1e-8 };
        for factorisation in Factorisation::ALL {
            let how = How { accuracy, factorisation: Some(factorisation), seconds: None, dump: None };
            let answer = solve(&program, how, [&Arc::default(); 2]).unwrap();
            assert_eq!(answer.status, Status::Solved);
            assert!((answer.x[0] - 4.0).abs() < 1e-7);
            let off = 2.0_f64.sqrt() / 3.0;
            let expected = [1.0 / 3.0, off, 1.0 / 3.0, off, off, 1.0 / 3.0];
            for (found, expected) in answer.multipliers.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-6, "{:?}", answer.multipliers);
            }
        }
    }

    #[test]
    fn a_program_that_fails_can_be_solved_again_from_its_file() {
        // Numbers far beyond what doubles can balance: x >= 1e300, x <= 1e-300 y, y free.
        let mut program = Program::default();
        let (x, y) = (program.unknown(), program.unknown());
        program.non_negative(Form::unknown(x, 1.0).plus(-1e300, &Form::constant(1.0)));
        program.non_negative(Form::unknown(y, 1e-300).plus(-1.0, &Form::unknown(x, 1.0)));
        program.objective.push((x, 1e300));
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("failed.json");
        let accuracy = Accuracy { gap: 1e-8, feasibility: 1e-8, steps: 1e-10, regularisation: 1e-8 };
        let stop = Arc::new(AtomicBool::new(false));
        let how = How { accuracy, factorisation: None, seconds: None, dump: Some(&path) };
        let answer = solve(&program, how, [&stop]).unwrap();
        assert_eq!(answer.status, Status::Failed);
        let mut file = File::open(&path).unwrap();
        let mut again: DefaultSolver<f64> = DefaultSolver::load_from_file(&mut file, None).unwrap();
        again.solve();
        assert!(!matches!(again.solution.status, SolverStatus::Solved));
    }
}
