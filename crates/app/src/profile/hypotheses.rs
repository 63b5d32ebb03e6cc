//! What strokes leave of each way in which ground may go with depth.

use std::sync::atomic::AtomicBool;

use soilctl_ground::p_of_deviations;
use soilctl_ground::profile::{Asked, Explains, Found, Ground, Search, Shape, Stroke};
use soilctl_jobs::each;
use soilctl_stats::normal_quantile;

use super::answer::{Hypothesis, Kind, Level, Ranges, StepSlice};
use super::strokes::Strokes;
use crate::{AppError, Watch};

/// Boxes that are looked at for ranges of one hypothesis or of one slice of a step, and for whether there is a ground at all.
const BUDGET: usize = 25_000;
const BUDGET_OF_ANY: usize = 8_000;
/// Slices of the depth of a step.
pub(super) const SLICES: usize = 8;
/// Depths of a profile.
const LEVELS: usize = 21;
/// Parts of the way down at which a gradient is asked about.
const PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Most that bands are widened by, and how closely the factor is told.
const WIDEST: f64 = 10.0;
const FACTOR_TOLERANCE: f64 = 0.03;

/// A hypothesis, and intervals of the logarithms of forces of candidates for the next stroke; empty if it is inconsistent.
pub(super) type Judged = (Hypothesis, Vec<[f64; 2]>);

/// What strokes leave of a kind of ground. `each_band` is the probability with which a band holds its true force, `None` for bounds.
pub(super) fn hypothesis(
    kind: Kind,
    strokes: &Strokes<'_>,
    candidates: &[Stroke],
    each_band: Option<f64>,
    watch: &dyn Watch,
) -> Result<Judged, AppError> {
    let forces = candidates.iter().cloned().map(Asked::LogForce);
    let mut asked: Vec<Asked> = match kind {
        Kind::OneSoil => vec![Asked::Friction(0.0), Asked::Density(0.0)],
        Kind::Gradient => PARTS.iter().flat_map(|p| [Asked::Friction(*p), Asked::Density(*p)]).collect(),
        Kind::Step => {
            let ends = [0.0, 1.0].into_iter();
            ends.flat_map(|p| [Asked::Friction(p), Asked::Density(p)]).chain([Asked::StepDepth]).collect()
        }
    };
    asked.extend([Asked::FrictionGrowth, Asked::DensityGrowth]);
    let own = asked.len();
    asked.extend(forces);
    let slices: Vec<[f64; 2]> = match kind {
        Kind::OneSoil | Kind::Gradient => vec![strokes.step_m],
        Kind::Step => slices(strokes.step_m),
    };
    // Slices are searched side by side; their order does not depend on which is done first.
    let mut by_slice: Vec<Option<Found>> = vec![None; slices.len()];
    let numbered: Vec<(usize, [f64; 2])> = slices.iter().copied().enumerate().collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    // Seconds at most: nothing stops it in between, so that no slice is missing.
    let stop = AtomicBool::new(false);
    let one = |(_, step_m): &(usize, [f64; 2])| {
        let start = Ground { step_m: *step_m, ..strokes.start };
        Ok::<_, AppError>(Some(search(kind, strokes, &strokes.strokes, start, BUDGET).ranges(&asked)))
    };
    each(&numbered, threads, &stop, one, |(place, _), found| {
        by_slice[*place] = Some(found);
        watch.advance(1);
        Ok(())
    })?;
    let found = slices.into_iter().zip(by_slice).filter_map(|(step_m, found)| Some((step_m, found?)));
    let all: Vec<([f64; 2], Found)> = found.filter(|(_, found)| found.explains != Explains::No).collect();
    let consistent = !all.is_empty();
    let widening = if consistent { Some(1.0) } else { widening(kind, strokes) };
    let mut forces = Vec::new();
    for (_, found) in &all {
        span(&mut forces, found.ranges.get(own..).unwrap_or_default());
    }
    let hypothesis = Hypothesis {
        kind,
        consistent,
        is_certain: !consistent || all.iter().any(|(_, found)| found.explains == Explains::Yes),
        widening,
        p: each_band.filter(|_| !consistent).map(|each| p(strokes, widening.unwrap_or(WIDEST), each)),
        ranges: all.iter().map(|(_, found)| ranges(kind, &found.ranges)).reduce(Ranges::hull),
        step_m: match kind {
            Kind::OneSoil | Kind::Gradient => None,
            Kind::Step => all.iter().map(|(_, found)| found.ranges[4]).reduce(hull),
        },
        slices: match kind {
            Kind::OneSoil | Kind::Gradient => Vec::new(),
            Kind::Step => all
                .iter()
                .map(|(_, found)| StepSlice { step_m: found.ranges[4], ranges: ranges(kind, &found.ranges) })
                .collect(),
        },
        profile: if consistent { profile(kind, strokes, &all) } else { Vec::new() },
        is_sharp: all.iter().all(|(_, found)| found.is_sharp),
    };
    Ok((hypothesis, forces))
}

fn slices([low, high]: [f64; 2]) -> Vec<[f64; 2]> {
    let at = |i: usize| low + (high - low) * i as f64 / SLICES as f64;
    (0..SLICES).map(|i| [at(i), at(i + 1)]).collect()
}

fn search<'s>(
    kind: Kind,
    of: &Strokes<'_>,
    strokes: &'s [Stroke],
    start: Ground,
    budget: usize,
) -> Search<'s> {
    let shape = match kind {
        Kind::OneSoil => Shape::Uniform,
        Kind::Gradient => Shape::Gradient { to_m: of.depths_m[1] },
        Kind::Step => Shape::Step,
    };
    Search { shape, strokes, start, density_kg_m3: of.density_kg_m3, budget }
}

/// The least factor on the bands with which some ground explains the strokes; `None` beyond the widest.
fn widening(kind: Kind, of: &Strokes<'_>) -> Option<f64> {
    let explains = |factor: f64| {
        let observed = of.setup.observations.iter().map(|o| o.scaled(factor));
        let strokes: Vec<Stroke> = observed
            .zip(&of.strokes)
            .map(|(o, stroke)| Stroke { force_n: [o.low_n(), o.high_n()], ..stroke.clone() })
            .collect();
        // Unknown counts as explained: so the factor is rather too small, and its probability too great.
        search(kind, of, &strokes, of.start, BUDGET_OF_ANY).explains() != Explains::No
    };
    let (mut low, mut high) = (1.0, 1.0);
    while !explains(high) {
        if high >= WIDEST {
            return None;
        }
        low = high;
        high = (1.5 * high).min(WIDEST);
    }
    while high - low > FACTOR_TOLERANCE * low {
        let middle = f64::midpoint(low, high);
        if explains(middle) { high = middle } else { low = middle }
    }
    Some(low)
}

/// The probability that some band has to be widened so much, at most, each being that of a normal logarithm.
fn p(of: &Strokes<'_>, factor: f64, each: f64) -> f64 {
    let reach = normal_quantile(0.5 * (1.0 - each));
    let least = of.setup.observations.iter().map(|o| {
        let sd = libm::log(o.high_n() / o.force_n()) / reach;
        libm::log1p(factor * (o.high_n() / o.force_n() - 1.0)) / sd
    });
    let least = least.fold(f64::INFINITY, f64::min);
    p_of_deviations(&vec![least; of.setup.observations.len()])
}

fn hull(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

fn span(all: &mut Vec<[f64; 2]>, ranges: &[[f64; 2]]) {
    if all.is_empty() {
        all.extend_from_slice(ranges);
    } else {
        all.iter_mut().zip(ranges).for_each(|(a, b)| *a = hull(*a, *b));
    }
}

impl Ranges {
    fn hull(a: Self, b: Self) -> Self {
        Self {
            phi_top_deg: hull(a.phi_top_deg, b.phi_top_deg),
            phi_bottom_deg: hull(a.phi_bottom_deg, b.phi_bottom_deg),
            phi_growth_deg: hull(a.phi_growth_deg, b.phi_growth_deg),
            density_top_kg_m3: hull(a.density_top_kg_m3, b.density_top_kg_m3),
            density_bottom_kg_m3: hull(a.density_bottom_kg_m3, b.density_bottom_kg_m3),
            density_growth_kg_m3: hull(a.density_growth_kg_m3, b.density_growth_kg_m3),
        }
    }
}

/// Ranges in the order of what is asked of a kind.
fn ranges(kind: Kind, of: &[[f64; 2]]) -> Ranges {
    let bottom = match kind {
        Kind::OneSoil => 0,
        Kind::Gradient => 2 * (PARTS.len() - 1),
        Kind::Step => 2,
    };
    let growth = match kind {
        Kind::OneSoil => 2,
        Kind::Gradient => 2 * PARTS.len(),
        Kind::Step => 5,
    };
    Ranges {
        phi_top_deg: of[0],
        phi_bottom_deg: of[bottom],
        phi_growth_deg: of[growth],
        density_top_kg_m3: of[1],
        density_bottom_kg_m3: of[bottom + 1],
        density_growth_kg_m3: of[growth + 1],
    }
}

/// Ranges over depth.
fn profile(kind: Kind, of: &Strokes<'_>, all: &[([f64; 2], Found)]) -> Vec<Level> {
    let levels = (0..LEVELS).map(|i| i as f64 / (LEVELS - 1) as f64);
    let at = |part: f64| {
        let depth_m = part * of.depths_m[1];
        let of_each = all.iter().map(|(step_m, found)| {
            let level = |phi_deg, density_kg_m3| Level { depth_m, phi_deg, density_kg_m3 };
            let r = &found.ranges;
            match kind {
                Kind::OneSoil => level(r[0], r[1]),
                Kind::Gradient => {
                    // Between two depths that were asked about, straight lines between their ends enclose all straight lines.
                    let (i, t) = place(part);
                    let between = |q: usize| {
                        let (a, b) = (r[2 * i + q], r[2 * (i + 1).min(PARTS.len() - 1) + q]);
                        [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
                    };
                    level(between(0), between(1))
                }
                Kind::Step if depth_m < step_m[0] => level(r[0], r[1]),
                Kind::Step if depth_m > step_m[1] => level(r[2], r[3]),
                Kind::Step => level(hull(r[0], r[2]), hull(r[1], r[3])),
            }
        });
        of_each.reduce(|a, b| Level {
            depth_m,
            phi_deg: hull(a.phi_deg, b.phi_deg),
            density_kg_m3: hull(a.density_kg_m3, b.density_kg_m3),
        })
    };
    levels.filter_map(at).collect()
}

/// The part asked about below a part, and how far beyond it that is.
fn place(part: f64) -> (usize, f64) {
    let steps = (PARTS.len() - 1) as f64;
    let at = part * steps;
    (at as usize, at.fract())
}
