//! Solving cases, several at a time.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use soilctl_certificate::{Solution, Statement};
use soilctl_earth_pressure::table::{BracketRow, BracketRules, CellStatus};
use soilctl_earth_pressure::{Blocks, EndLaw};
use soilctl_jobs::each;
use soilctl_limit_analysis::{Bounds, EmbeddedPlate, LimitError, Options, Problem, bound_section};

use super::cases::{Node, mixed};
use super::journal::{Entry, Found};
use crate::AppError;
use crate::bound::ScaledPlate;

/// How every case is solved. No time limit: the result may not depend on the machine.
#[derive(Debug)]
pub(super) struct Solver<'a> {
    pub(super) rules: BracketRules,
    pub(super) save: Option<&'a Path>,
    pub(super) stop: Arc<AtomicBool>,
}

/// Where the solution of a case is saved.
pub(super) fn solution_path(folder: &Path, [alpha, phi, delta]: Node) -> PathBuf {
    folder.join(format!("alpha_{alpha}_phi_{phi}_delta_{delta}.json"))
}

impl Solver<'_> {
    /// Solves cases on so many threads, handing each to `done` as soon as it is solved. What is found does not depend on
    /// the number of threads. Ends early if `stop` is set: cases under way are then dropped, not cut short.
    pub(super) fn solve(
        &self,
        cases: &[Node],
        threads: usize,
        mut done: impl FnMut(Entry) -> Result<(), AppError>,
    ) -> Result<(), AppError> {
        let order: Vec<Node> = mixed(cases.len()).into_iter().map(|place| cases[place]).collect();
        each(&order, threads, &self.stop, |node| self.case(*node), |_, entry| done(entry))
    }

    /// One case; none if it was stopped.
    fn case(&self, node: Node) -> Result<Option<Entry>, AppError> {
        let start = Instant::now();
        let [alpha_deg, phi_deg, delta_deg] = node;
        let plate = EmbeddedPlate { alpha_deg, phi_deg, delta_deg, ..EmbeddedPlate::default() };
        // Any width will do: the lower bound holds for every one.
        let problem = plate.problem().and_then(|problem| problem.with_width(1.0));
        let solved = problem.and_then(|problem| Ok((self.bounds(&problem)?, problem)));
        // Checked last, since a case that the user stops still comes back with bounds, only wider ones.
        if self.stop.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let found = match solved {
            // True, but of no use: a coefficient is above zero in any case.
            Ok((bounds, _)) if bounds.lower.value <= 0.0 => {
                let elements = self.rules.max_elements;
                let reason =
                    format!("no lower bound above 0 was proven with {elements} elements; allow more");
                Found::Empty { node, reason }
            }
            Ok((bounds, problem)) => {
                let scaled = ScaledPlate::unit(plate);
                if let Some(folder) = self.save {
                    Self::save(folder, node, &scaled, &problem, &bounds)?;
                }
                let law = self.law(&scaled, &problem);
                Found::Solved(row(node, &scaled, &bounds, law))
            }
            Err(problem) => Found::Empty { node, reason: self.reason(&problem) },
        };
        Ok(Some(Entry { found, seconds: Some(start.elapsed().as_secs_f64()) }))
    }

    fn bounds(&self, problem: &Problem) -> Result<Bounds, LimitError> {
        let options = Options {
            max_gap: self.rules.max_gap,
            max_elements: self.rules.max_elements,
            max_work: u64::MAX,
            threads: 1,
            stop: Arc::clone(&self.stop),
            ..Options::default()
        };
        bound_section(problem, &options, &mut |_, _| {})
    }

    /// The proof in plane strain, and beside it that of a plate with ends, as far as there is one.
    fn save(
        folder: &Path,
        node: Node,
        scaled: &ScaledPlate,
        problem: &Problem,
        bounds: &Bounds,
    ) -> Result<(), AppError> {
        let path = solution_path(folder, node);
        let solution = scaled.solution(problem, bounds);
        let (case, loads) = scaled.case();
        let width = scaled.slant_width(Blocks::LAW_AT);
        let statement = solution.statement.clone().with_width(width);
        if let Ok(blocks) = Blocks.proven(&case, &statement, loads) {
            let lower = solution.lower.clone();
            Solution { statement, lower, upper: None, mechanism: Some(blocks), ..solution.clone() }
                .write(&path.with_extension("ends.json"))?;
        }
        let statement = Statement { width: None, ..solution.statement.clone() };
        Ok(Solution { statement, ..solution }.write(&path)?)
    }

    /// Upper bounds for every width; none outside the range of the mechanism in space.
    fn law(&self, scaled: &ScaledPlate, problem: &Problem) -> Option<EndLaw> {
        let (case, loads) = scaled.case();
        Blocks.proven_law(&case, problem.statement(), loads).ok()
    }

    /// Why a node stays empty, without the time that it took to find out.
    fn reason(&self, problem: &LimitError) -> String {
        match problem {
            LimitError::NothingProven { .. } => {
                format!("no pair of bounds was proven with {} elements; allow more", self.rules.max_elements)
            }
            other => other.to_string(),
        }
    }
}

fn row(
    [alpha_deg, phi_deg, delta_deg]: Node,
    scaled: &ScaledPlate,
    bounds: &Bounds,
    law: Option<EndLaw>,
) -> BracketRow {
    let [lower, upper] = scaled.coefficients(bounds);
    // Bounds on forces become bounds on coefficients, rounded up.
    let above = |force: f64| scaled.of_forces([force, force])[1];
    BracketRow {
        alpha_deg,
        phi_deg,
        delta_deg,
        lower,
        upper,
        gap: BracketRow::relative_gap(lower, upper),
        // `bound` reports nothing else.
        certified: true,
        lower_elements: bounds.lower.elements,
        upper_elements: bounds.upper.elements,
        status: CellStatus::Solved,
        ends_upper: law.map(|law| above(law.without_ends)),
        ends_term: law.map(|law| above(law.term)),
    }
}
