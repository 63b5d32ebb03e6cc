use soilctl_stats::median;

use crate::{Evaluated, Outcome};

/// Length of a cell of a course, in depths of the plate: within one the force is averaged.
pub const CELL_DEPTHS: f64 = 0.1;
/// Fewest samples in a cell.
const FEWEST: usize = 3;
/// A plate that went back by more depths than this pushes soil that it has pushed before.
const LET_GO_DEPTHS: f64 = 0.01;
/// Power of the depth by which forces are brought to the depth at the beginning while the plate rises and sinks: what the weight of the wedge adds goes with its
/// square, what the heap ahead adds with the depth itself.
const DRIFT_POWER: f64 = 1.5;

/// The force of one stroke over its way.
///
/// Wedge and heap of plates at several depths are similar at the same way in depths, where the force goes with the square of the depth (of sand
/// without cohesion); so strokes of one tool angle are compared by `ln F - 2 ln H` over `x / H`.
#[derive(Debug, Clone, PartialEq)]
pub struct Course {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Depth of the plate at the beginning in m.
    pub depth_m: f64,
    /// Way in m at which the soil failed, if that can be told.
    pub failure_m: Option<f64>,
    /// Which preparation of the soil it was made in, by any number: strokes of one have one density. Made as 0.
    preparation: usize,
    cells: Vec<Option<Cell>>,
}

/// What is known of the force while the plate went through a tenth of a depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cell {
    /// Mean of `ln F - 2 ln H` with F in N and H in m.
    pub(super) level: f64,
    /// Depth of the plate in m.
    pub(super) depth_m: f64,
    /// When the plate left the cell, in s on the trace's clock.
    pub(super) time_s: f64,
}

impl Course {
    /// The course of an evaluated stroke; `None` if its force says nothing at any place.
    #[must_use]
    pub fn of(evaluated: &Evaluated) -> Option<Self> {
        let (trace, row) = (&evaluated.trace, &evaluated.row);
        let early = (trace.t_s().len() / 50).max(1);
        let risen_m: Option<Vec<f64>> = trace.channels().z_m.as_ref().map(|z_m| {
            let start_m = median(&mut z_m.iter().take(early).copied().collect::<Vec<_>>());
            z_m.iter().map(|z| z - start_m).collect()
        });
        let failure_m = match &evaluated.analysis.outcome {
            Outcome::Found(point) => Some(point.displacement_m),
            Outcome::Indiscernible(_) => None,
        };
        let samples = trace.t_s().iter().zip(trace.displacement_m()).zip(trace.force_n()).enumerate().map(
            |(place, ((t_s, way_m), force_n))| {
                let risen_m =
                    risen_m.as_ref().and_then(|risen| risen.get(place)).copied().unwrap_or_default();
                CourseSample { t_s: *t_s, way_m: *way_m, force_n: *force_n, depth_m: row.depth_m - risen_m }
            },
        );
        Self::from_samples(row.alpha_deg, row.depth_m, failure_m, samples)
    }

    /// The course of samples in the order of time, of a plate with a tool angle in deg that was so deep in m at the beginning; `None` as above.
    #[must_use]
    pub fn from_samples(
        alpha_deg: f64,
        depth_m: f64,
        failure_m: Option<f64>,
        samples: impl Iterator<Item = CourseSample>,
    ) -> Option<Self> {
        let mut sums: Vec<(f64, f64, f64, usize)> = Vec::new();
        let mut furthest_m = f64::NEG_INFINITY;
        for CourseSample { t_s, way_m, force_n, depth_m: now_m } in samples {
            furthest_m = furthest_m.max(way_m);
            let is_new = way_m >= furthest_m - LET_GO_DEPTHS * depth_m;
            if !(is_new && way_m >= 0.0 && force_n > 0.0 && now_m > 0.0) {
                continue;
            }
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 and above")]
            let cell = (way_m / (CELL_DEPTHS * depth_m)) as usize;
            if cell >= MOST_CELLS {
                break;
            }
            if sums.len() <= cell {
                sums.resize(cell + 1, (0.0, 0.0, 0.0, 0));
            }
            if let Some((levels, depths, time_s, count)) = sums.get_mut(cell) {
                *levels += force_n.ln() - 2.0 * depth_m.ln() - DRIFT_POWER * (now_m / depth_m).ln();
                *depths += now_m;
                *time_s = t_s;
                *count += 1;
            }
        }
        let cells: Vec<Option<Cell>> = sums
            .into_iter()
            .map(|(levels, depths, time_s, count)| {
                let n = count as f64;
                (count >= FEWEST).then(|| Cell { level: levels / n, depth_m: depths / n, time_s })
            })
            .collect();
        cells.iter().any(Option::is_some).then_some(Self {
            alpha_deg,
            depth_m,
            failure_m,
            preparation: 0,
            cells,
        })
    }

    /// The same in a preparation of the soil.
    #[must_use]
    pub fn in_preparation(mut self, preparation: usize) -> Self {
        self.preparation = preparation;
        self
    }

    pub(super) const fn preparation(&self) -> usize {
        self.preparation
    }

    pub(super) fn cell(&self, place: usize) -> Option<&Cell> {
        self.cells.get(place)?.as_ref()
    }

    /// How many cells the stroke went through.
    pub(super) fn len(&self) -> usize {
        self.cells.len()
    }

    /// The cell in which the soil failed.
    pub(super) fn failure_cell(&self) -> Option<usize> {
        let depths = self.failure_m? / (CELL_DEPTHS * self.depth_m);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        let cell = (0.0..MOST_CELLS as f64).contains(&depths).then_some(depths as usize);
        cell
    }
}

/// Cells beyond this, fifty depths, are not looked at.
const MOST_CELLS: usize = 500;

/// A sample of a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CourseSample {
    /// Time in s, on any clock.
    pub t_s: f64,
    /// Way of the plate along the stroke in m.
    pub way_m: f64,
    /// Force on the plate in N.
    pub force_n: f64,
    /// Depth of its lower edge in m.
    pub depth_m: f64,
}
