//! Solving cases, several at a time.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use soilctl_certificate::Solution;
use soilctl_earth_pressure::table::{BracketRow, BracketRules, CellStatus};
use soilctl_earth_pressure::{Blocks, ForceModel};
use soilctl_jobs::each;
use soilctl_limit_analysis::{Bounds, EmbeddedPlate, LimitError, Options, Problem, bound_section};

use super::cases::{Node, key, mixed};
use super::journal::{Entry, Found};
use crate::AppError;
use crate::bound::ScaledPlate;

/// Most elements for the lower bound of plates with ends, which on more gains less than the gap to the upper one.
const SECTION_ELEMENTS: usize = 1500;

/// How every case is solved. No time limit: the result may not depend on the machine.
#[derive(Debug)]
pub(super) struct Solver<'a> {
    pub(super) rules: BracketRules,
    pub(super) save: Option<&'a Path>,
    pub(super) stop: Arc<AtomicBool>,
    /// Rows that are known in plane strain, by their node: only what ends add is left to do.
    pub(super) plane: BTreeMap<[i64; 3], BracketRow>,
}

/// Whether the mechanism in space covers a case.
pub(super) fn may_have_ends([alpha, phi, delta]: Node) -> bool {
    let range = Blocks.valid_range();
    let inside = |(low, high): (f64, f64), x: f64| (low..=high).contains(&x);
    inside(range.alpha_deg, alpha) && inside(range.phi_deg, phi) && inside(range.delta_deg, delta)
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
        let scaled = ScaledPlate::unit(plate);
        let plane = match self.plane.get(&key(node)) {
            Some(row) => Some(Found::Solved(*row)),
            None => self.plane_case(node, &scaled)?,
        };
        let found = match plane {
            Some(Found::Solved(row)) => self.with_ends(row, &scaled)?.map(Found::Solved),
            empty @ (Some(Found::Empty { .. }) | None) => empty,
        };
        Ok(found.map(|found| Entry { found, seconds: Some(start.elapsed().as_secs_f64()) }))
    }

    /// Whether the user has ended the run: what was being solved comes back with bounds all the same, only wider ones.
    fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// The bracket in plane strain; none if it was stopped.
    fn plane_case(&self, node: Node, scaled: &ScaledPlate) -> Result<Option<Found>, AppError> {
        let elements = self.rules.max_elements;
        let solved = scaled.problem().and_then(|problem| Ok((self.bounds(&problem, elements)?, problem)));
        if self.is_stopped() {
            return Ok(None);
        }
        Ok(Some(match solved {
            // True, but of no use: a coefficient is above zero in any case.
            Ok((bounds, _)) if bounds.lower.value <= 0.0 => {
                let reason =
                    format!("no lower bound above 0 was proven with {elements} elements; allow more");
                Found::Empty { node, reason }
            }
            Ok((bounds, problem)) => {
                if let Some(folder) = self.save {
                    scaled.solution(&problem, &bounds).write(&solution_path(folder, node))?;
                }
                Found::Solved(row(node, scaled, &bounds))
            }
            Err(problem) => Found::Empty { node, reason: self.reason(&problem) },
        }))
    }

    /// A row with what is proven of plates with ends, as it is if nothing is; none if it was stopped.
    fn with_ends(&self, row: BracketRow, scaled: &ScaledPlate) -> Result<Option<BracketRow>, AppError> {
        let plane = scaled.problem()?;
        let (case, loads) = scaled.case();
        let Ok(law) = Blocks.proven_law(&case, plane.statement(), loads) else { return Ok(Some(row)) };
        let section = plane.with_width(scaled.slant_width(Blocks::LAW_AT))?;
        let bounds = self.bounds(&section, self.rules.max_elements.min(SECTION_ELEMENTS));
        if self.is_stopped() {
            return Ok(None);
        }
        let Ok(bounds) = bounds else { return Ok(Some(row)) };
        let [lower, upper] = scaled.of_forces([bounds.lower.value, law.without_ends]);
        let [_, term] = scaled.of_forces([law.term, law.term]);
        if lower <= 0.0 {
            return Ok(Some(row));
        }
        if let Some(folder) = self.save
            && let Ok(blocks) = Blocks.proven(&case, section.statement(), loads)
        {
            let solution = scaled.solution(&section, &bounds);
            Solution { upper: None, mechanism: Some(blocks), ..solution }
                .write(&solution_path(folder, row.node()).with_extension("ends.json"))?;
        }
        let (ends_lower, ends_upper, ends_term) = (Some(lower), Some(upper), Some(term));
        Ok(Some(BracketRow { ends_lower, ends_upper, ends_term, ..row }))
    }

    fn bounds(&self, problem: &Problem, max_elements: usize) -> Result<Bounds, LimitError> {
        let options = Options {
            max_gap: self.rules.max_gap,
            max_elements,
            max_work: u64::MAX,
            threads: 1,
            stop: Arc::clone(&self.stop),
            ..Options::default()
        };
        bound_section(problem, &options, &mut |_, _| {})
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

fn row([alpha_deg, phi_deg, delta_deg]: Node, scaled: &ScaledPlate, bounds: &Bounds) -> BracketRow {
    let [lower, upper] = scaled.coefficients(bounds);
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
        ends_lower: None,
        ends_upper: None,
        ends_term: None,
    }
}
