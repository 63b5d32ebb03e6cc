//! All grounds of a shape that explain strokes: boxes of unknowns, cut until they are excluded, or known well enough.
//!
//! Over a box the two densities that a stroke leaves lie between two straight lines, so that what all strokes leave is a convex polygon. A box without one holds
//! no ground. Its middle may hold one, which is then a witness. Boxes that would widen what witnesses span the most are cut first; those that would
//! hardly widen it count as if they held grounds all over. So nothing is lost, however soon the search ends.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::densities::Densities;
use super::forward::{Ground, Shape, Stroke};

/// A box whose forces are known to this share is not cut further.
const FINEST: f64 = 0.003;
/// What forces change by: a degree of friction angle, of friction on the plate, all of the ends, and the depth of a step by itself.
const BY_PHI: f64 = 0.06;
const BY_DELTA: f64 = 0.04;
const BY_ENDS: f64 = 0.2;
const BY_STEP: f64 = 0.5;

/// Something that is asked of all grounds that explain the strokes.
#[derive(Debug, Clone)]
pub enum Asked {
    /// The friction angle in deg between top (0) and bottom (1).
    Friction(f64),
    /// By how much it is greater at the bottom, in deg.
    FrictionGrowth,
    /// The density in kg/m3 between top and bottom.
    Density(f64),
    /// By how much it is greater at the bottom, in kg/m3.
    DensityGrowth,
    /// The depth of the step in m.
    StepDepth,
    /// The logarithm of the force in N of a stroke, by whose interval nothing is told.
    LogForce(Stroke),
}

impl Asked {
    /// How exactly it is told.
    fn tolerance(&self) -> f64 {
        match self {
            Self::Friction(_) => 0.25,
            Self::FrictionGrowth => 0.4,
            Self::Density(_) => 20.0,
            Self::DensityGrowth => 30.0,
            Self::StepDepth => 1e-3,
            Self::LogForce(_) => 0.03,
        }
    }
}

/// Nor more exactly than this part of all that is left of it.
const TOLERATED_PART: f64 = 0.04;
/// Logarithms of forces in N that are told: a microgram's weight, and that of a mountain. Beyond, there is no force to speak of, or no end to it.
pub const LOG_FORCE: [f64; 2] = [-18.0, 30.0];

/// Whether grounds of a shape explain strokes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Explains {
    /// None does.
    No,
    /// Some do.
    Yes,
    /// The search ended before it was known.
    Perhaps,
}

/// What a search found.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Whether any ground explains the strokes.
    pub explains: Explains,
    /// Interval of each that was asked, in order; none of what explains the strokes is outside. Empty if nothing explains them.
    pub ranges: Vec<[f64; 2]>,
    /// Whether the intervals are as narrow as their tolerances; otherwise the budget ended, and they may be wider than need be.
    pub is_sharp: bool,
}

/// What is searched.
#[derive(Debug, Clone)]
pub struct Search<'s> {
    /// How ground goes with depth.
    pub shape: Shape,
    /// Strokes.
    pub strokes: &'s [Stroke],
    /// All that is possible.
    pub start: Ground,
    /// Densities that are possible at top and bottom, in kg/m3.
    pub density_kg_m3: [f64; 2],
    /// Most boxes that are looked at.
    pub budget: usize,
}

impl Search<'_> {
    /// Whether any ground explains the strokes.
    #[must_use]
    pub fn explains(&self) -> Explains {
        self.run(&[], true).explains
    }

    /// The intervals of what is asked.
    #[must_use]
    pub fn ranges(&self, asked: &[Asked]) -> Found {
        self.run(asked, false)
    }

    fn run(&self, asked: &[Asked], any: bool) -> Found {
        let mut spanned: Option<Vec<[f64; 2]>> = None;
        let mut open = BinaryHeap::new();
        let mut looked_at = 0;
        let mut is_sharp = true;
        let (mut witnessed, mut fine) = (false, false);
        if let Some(first) = self.open(self.start, 0, asked) {
            open.push(first);
        }
        while let Some(mut top) = open.pop() {
            if any && witnessed {
                break;
            }
            // What witnesses span has grown since the box was put here.
            let sticks_out = self.sticks_out(asked, &top, spanned.as_deref());
            if sticks_out < top.sticks_out {
                top.sticks_out = sticks_out;
                open.push(top);
                continue;
            }
            if sticks_out <= 1.0 || looked_at >= self.budget {
                is_sharp = sticks_out <= 1.0;
                open.push(top);
                break;
            }
            looked_at += 1;
            if let Some(at) = self.open(middle(&top.ground), 0, asked) {
                span(&mut spanned, &at.ranges);
                witnessed = true;
            }
            let Some((dimension, slack)) = self.widest(&top.ground) else { continue };
            if slack <= FINEST {
                fine = true;
                if !any {
                    span(&mut spanned, &top.ranges);
                }
                continue;
            }
            for half in halves(&top.ground, dimension, self.shape) {
                if let Some(half) = self.open(half, top.depth + 1, asked) {
                    open.push(half);
                }
            }
        }
        let explains = match (witnessed, fine || !open.is_empty()) {
            (true, _) => Explains::Yes,
            (false, true) => Explains::Perhaps,
            (false, false) => Explains::No,
        };
        for left in open {
            span(&mut spanned, &left.ranges);
        }
        Found { explains, ranges: spanned.unwrap_or_default(), is_sharp }
    }

    /// A box with what it could hold; `None` if that is nothing.
    fn open(&self, ground: Ground, depth: u32, asked: &[Asked]) -> Option<Open> {
        let mut densities = match self.shape {
            Shape::Uniform => Densities::same(self.density_kg_m3),
            Shape::Gradient { .. } | Shape::Step => Densities::all(self.density_kg_m3),
        };
        for stroke in self.strokes {
            let weights = stroke.weights(self.shape, &ground);
            let [low, high] = stroke.force_n.map(|force| force / stroke.unit_n);
            if !weights.least.iter().all(|c| c.is_finite()) {
                return None;
            }
            densities.cut(weights.least, high);
            if weights.greatest.iter().all(|c| c.is_finite()) {
                densities.cut(weights.greatest.map(|c| -c), -low);
            }
            if densities.is_empty() {
                return None;
            }
        }
        let ranges = asked.iter().map(|asked| range(asked, self.shape, &ground, &densities)).collect();
        Some(Open { sticks_out: f64::INFINITY, depth, ground, ranges })
    }

    /// By how many tolerances a box could widen what is spanned, at most.
    fn sticks_out(&self, asked: &[Asked], of: &Open, spanned: Option<&[[f64; 2]]>) -> f64 {
        let Some(spanned) = spanned else { return f64::INFINITY };
        let beyond = asked.iter().zip(&of.ranges).zip(spanned).map(|((asked, own), spanned)| {
            let tolerance = asked.tolerance().max(TOLERATED_PART * (spanned[1] - spanned[0]));
            (spanned[0] - own[0]).max(own[1] - spanned[1]) / tolerance
        });
        beyond.fold(0.0, f64::max)
    }

    /// The unknown that leaves forces most open, and by how much.
    fn widest(&self, ground: &Ground) -> Option<(usize, f64)> {
        let width = |[low, high]: [f64; 2]| high - low;
        let shares = match self.shape {
            Shape::Uniform => [1.0, 0.0],
            Shape::Gradient { .. } => [0.6, 0.6],
            Shape::Step => {
                let step = f64::midpoint(ground.step_m[0], ground.step_m[1]);
                let above = self.strokes.iter().map(|s| (step / s.depth_m).min(1.0).powi(2)).sum::<f64>();
                let above = above / self.strokes.len().max(1) as f64;
                [above.max(0.2), (1.0 - above).max(0.2)]
            }
        };
        let of_step = match self.shape {
            Shape::Uniform | Shape::Gradient { .. } => 0.0,
            Shape::Step => BY_STEP * width(ground.step_m) / ground.step_m[1],
        };
        [
            BY_PHI * shares[0] * width(ground.phi_deg[0]),
            BY_PHI * shares[1] * width(ground.phi_deg[1]),
            BY_DELTA * width(ground.delta_deg),
            BY_ENDS * width(ground.ends),
            of_step,
        ]
        .into_iter()
        .enumerate()
        .max_by(|(_, a), (_, b)| a.total_cmp(b))
    }
}

/// A box that may hold grounds, with intervals of what is asked.
struct Open {
    sticks_out: f64,
    depth: u32,
    ground: Ground,
    ranges: Vec<[f64; 2]>,
}

impl Ord for Open {
    /// What sticks out most, then what is cut finest, so that a first witness is found soon.
    fn cmp(&self, other: &Self) -> Ordering {
        self.sticks_out.total_cmp(&other.sticks_out).then(self.depth.cmp(&other.depth))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

fn span(spanned: &mut Option<Vec<[f64; 2]>>, ranges: &[[f64; 2]]) {
    match spanned {
        Some(spanned) => {
            for (own, other) in spanned.iter_mut().zip(ranges) {
                *own = [own[0].min(other[0]), own[1].max(other[1])];
            }
        }
        None => *spanned = Some(ranges.to_vec()),
    }
}

fn middle(ground: &Ground) -> Ground {
    let of = |[low, high]: [f64; 2]| [f64::midpoint(low, high); 2];
    Ground {
        phi_deg: ground.phi_deg.map(of),
        delta_deg: of(ground.delta_deg),
        ends: of(ground.ends),
        step_m: of(ground.step_m),
    }
}

fn halves(ground: &Ground, dimension: usize, shape: Shape) -> [Ground; 2] {
    let cut = |[low, high]: [f64; 2]| {
        let middle = f64::midpoint(low, high);
        [[low, middle], [middle, high]]
    };
    [0, 1].map(|side| {
        let mut half = *ground;
        match dimension {
            0 => half.phi_deg[0] = cut(ground.phi_deg[0])[side],
            1 => half.phi_deg[1] = cut(ground.phi_deg[1])[side],
            2 => half.delta_deg = cut(ground.delta_deg)[side],
            3 => half.ends = cut(ground.ends)[side],
            _ => half.step_m = cut(ground.step_m)[side],
        }
        if shape == Shape::Uniform {
            half.phi_deg[1] = half.phi_deg[0];
        }
        half
    })
}

/// What grounds of a box with these densities could answer.
fn range(asked: &Asked, shape: Shape, ground: &Ground, densities: &Densities) -> [f64; 2] {
    let [top, bottom] = ground.phi_deg;
    match asked {
        Asked::Friction(part) => [0, 1].map(|end| top[end] + part * (bottom[end] - top[end])),
        Asked::FrictionGrowth if shape == Shape::Uniform => [0.0; 2],
        Asked::FrictionGrowth => [bottom[0] - top[1], bottom[1] - top[0]],
        Asked::Density(part) => densities.range([1.0 - part, *part]),
        Asked::DensityGrowth => densities.range([-1.0, 1.0]),
        Asked::StepDepth => ground.step_m,
        Asked::LogForce(stroke) => {
            let weights = stroke.weights(shape, ground);
            let least = densities.range(weights.least)[0] * stroke.unit_n;
            let greatest = densities.range(weights.greatest)[1] * stroke.unit_n;
            [least, greatest].map(|force| libm::log(force).clamp(LOG_FORCE[0], LOG_FORCE[1]))
        }
    }
}
