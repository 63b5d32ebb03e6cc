use std::collections::BTreeSet;

use soilctl_stats::{mean_and_sd, t_quantile};

use super::course::{CELL_DEPTHS, Cell, Course};
use crate::ProcessError;

/// Fewest strokes of one kind that say what the soil explains.
pub const FEWEST_REFERENCES: usize = 4;
/// Cells between the usual failure and the one that all later ones are compared with.
const AFTER_FAILURE: usize = 1;

/// What is asked of an alarm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Test {
    /// Probability that a stroke with nothing ahead alarms.
    pub false_alarms: f64,
    /// Probability that a region leaves out what the bounds and the scatter allow.
    pub left_out: f64,
}

/// What the soil explains: the courses of strokes of one kind, each but itself.
#[derive(Debug, Clone, PartialEq)]
pub struct Expected {
    /// The cell that later ones are compared with.
    first: usize,
    /// Level there.
    level: Spread,
    /// Growth from there to each later cell, as long as enough strokes went there.
    growth: Vec<Spread>,
}

/// Mean and standard deviation over strokes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Spread {
    mean: f64,
    sd: f64,
    strokes: usize,
    /// As many of them are independent of each other.
    independent: usize,
}

impl Spread {
    fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let values: Vec<f64> = values.collect();
        let (mean, sd) = mean_and_sd(&values)?;
        (values.len() >= FEWEST_REFERENCES).then_some(Self {
            mean,
            sd,
            strokes: values.len(),
            independent: values.len(),
        })
    }

    /// By how much one more stroke lies above the mean, over the standard deviation of that difference.
    fn score(&self, value: f64) -> f64 {
        let sd = self.sd_of_difference();
        let above = value - self.mean;
        if sd > 0.0 {
            above / sd
        } else if above > 0.0 {
            f64::INFINITY
        } else {
            0.0
        }
    }

    fn sd_of_difference(&self) -> f64 {
        self.sd * (1.0 + 1.0 / self.independent as f64).sqrt()
    }

    fn freedom(&self) -> f64 {
        // Strokes of one preparation do not tell how preparations differ: with one degree nearly nothing is beyond the limit.
        (self.independent as f64 - 1.0).max(1.0)
    }
}

/// One look at a stroke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Look {
    /// Way of the plate in m when the look was possible.
    pub way_m: f64,
    /// The time then, in s on the trace's clock.
    pub time_s: f64,
    /// Depth of the plate in m.
    pub depth_m: f64,
    /// Force over what the soil explains. At the first look by the strokes of its kind, later by these and the force at the first.
    pub ratio: f64,
    /// Above this it alarms.
    pub limit: f64,
    /// Factor by which the ratio may be off, up or down, so that all looks together are with the probability of the region.
    pub factor: f64,
    /// Score over the one at which it alarms.
    strength: f64,
}

impl Look {
    /// Whether the force is more than the soil explains.
    #[must_use]
    pub fn alarms(&self) -> bool {
        self.strength > 1.0
    }
}

/// The first look that alarms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Alarm {
    /// Its place in the list of looks.
    pub look: usize,
    /// Whether the stroke was above the others from the beginning, and did not rise since.
    pub from_the_beginning: bool,
}

/// A stroke, judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Strokes that it was compared with.
    pub references: usize,
    /// Looks that there can be at most, over which the probability of a false alarm is shared out.
    pub planned: usize,
    /// The looks, as far as the stroke went.
    pub looks: Vec<Look>,
    /// The first that alarms.
    pub alarm: Option<Alarm>,
}

impl Judged {
    /// Score over the one at which it alarms, the greatest of all looks.
    #[must_use]
    pub fn strength(&self) -> f64 {
        self.looks.iter().map(|look| look.strength).fold(f64::NEG_INFINITY, f64::max)
    }
}

impl Expected {
    /// What strokes of one kind say.
    ///
    /// # Errors
    /// [`ProcessError::TooFew`] if fewer than [`FEWEST_REFERENCES`] failed the soil and went on.
    pub fn of(references: &[&Course]) -> Result<Self, ProcessError> {
        let few = |found| ProcessError::TooFew {
            what: "strokes to compare with that failed the soil and went on",
            found,
            least: FEWEST_REFERENCES,
        };
        let mut failures: Vec<usize> = references.iter().filter_map(|course| course.failure_cell()).collect();
        failures.sort_unstable();
        let middle = failures.get(failures.len() / 2).ok_or_else(|| few(0))?;
        let first = middle + 1 + AFTER_FAILURE;
        let known = |course: &&&Course| course.cell(first).is_some();
        let used: Vec<&Course> = references.iter().filter(known).copied().collect();
        let level_of = |course: &&Course, place| course.cell(place).map(|cell: &Cell| cell.level);
        let level = Spread::of(used.iter().filter_map(|course| level_of(course, first)))
            .ok_or_else(|| few(used.len()))?;
        // The force itself goes by the density, which is that of the preparation.
        let preparations: BTreeSet<usize> = used.iter().map(|course| course.preparation()).collect();
        let level = Spread { independent: preparations.len(), ..level };
        let longest = used.iter().map(|course| course.len()).max().unwrap_or_default();
        // As far as half of them went: what only a few did would take its share of false alarms from all looks.
        let enough = |spread: &Spread| 2 * spread.strokes >= used.len();
        let growth = (first + 1..longest).map_while(|place| {
            let grown = |course: &&Course| Some(level_of(course, place)? - level_of(course, first)?);
            Spread::of(used.iter().filter_map(grown)).filter(enough)
        });
        let growth: Vec<Spread> = growth.collect();
        if growth.is_empty() { Err(few(0)) } else { Ok(Self { first, level, growth }) }
    }

    /// Looks that there can be.
    fn planned(&self) -> usize {
        1 + self.growth.len()
    }

    /// Judges a stroke that is none of those it is compared with.
    ///
    /// # Errors
    /// [`ProcessError::OutOfRange`] of a probability that is not above 0 and below 0.5; [`ProcessError::TooFew`] if the stroke ended before it
    /// could be compared; [`ProcessError::Unlike`] if its force is less than theirs from the beginning, which nothing that is buried makes it.
    pub fn judge(&self, course: &Course, test: &Test) -> Result<Judged, ProcessError> {
        for (what, value) in
            [("probability of a false alarm", test.false_alarms), ("probability left out", test.left_out)]
        {
            if !(value > 0.0 && value < 0.5) {
                let allowed = "above 0 and below 0.5";
                return Err(ProcessError::OutOfRange { what, value, unit: "", allowed });
            }
        }
        let first = course.cell(self.first).ok_or(ProcessError::TooFew {
            what: "cells of a tenth of a depth in the stroke",
            found: course.len(),
            least: self.first + 1,
        })?;
        let planned = self.planned();
        let look = |place: usize, cell: &Cell, spread: &Spread, value: f64| {
            let quantile = |tail: f64| t_quantile(tail / planned as f64, spread.freedom());
            let (most, within) = (quantile(test.false_alarms)?, quantile(0.5 * test.left_out)?);
            let sd = spread.sd_of_difference();
            Some(Look {
                way_m: (place + 1) as f64 * CELL_DEPTHS * course.depth_m,
                time_s: cell.time_s,
                depth_m: cell.depth_m,
                ratio: (value - spread.mean).exp(),
                limit: (most * sd).exp(),
                factor: (within * sd).exp(),
                strength: spread.score(value) / most,
            })
        };
        let mut looks: Vec<Look> = look(self.first, first, &self.level, first.level).into_iter().collect();
        if let Some(first) = looks.first().filter(|look| look.strength < -1.0) {
            return Err(ProcessError::Unlike { ratio: first.ratio, limit: 1.0 / first.limit });
        }
        for (place, spread) in (self.first + 1..).zip(&self.growth) {
            let Some(cell) = course.cell(place) else { continue };
            looks.extend(look(place, cell, spread, cell.level - first.level));
        }
        let place = looks.iter().position(Look::alarms);
        let alarm = place.map(|look| Alarm { look, from_the_beginning: look == 0 });
        Ok(Judged { references: self.level.strokes, planned, looks, alarm })
    }
}
