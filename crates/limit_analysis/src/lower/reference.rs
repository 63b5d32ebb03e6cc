//! The reference stress: in equilibrium with the weight of the soil, whatever the stress function adds.

use soilctl_certificate::Objective;
use soilctl_conic::Form;

use crate::problem::Problem;
use crate::vector::Point;

/// A linear function `a + b x + c y`.
type Plane = [f64; 3];

fn at(plane: &Plane, p: Point) -> f64 {
    plane[0] + plane[1] * p[0] + plane[2] * p[1]
}

/// Reference stresses of all regions.
#[derive(Debug, Clone)]
pub(crate) struct ReferenceStress {
    gravity: Point,
    live: Point,
    datum: f64,
    surcharge: f64,
    /// Unit weight of the first region.
    weight: f64,
    /// What the columns of other unit weight above and in a region weigh there, where gravity is one.
    columns: Vec<Plane>,
    /// The unknown factor on loads or the body force.
    pub(crate) multiplier: Option<usize>,
}

impl ReferenceStress {
    pub(crate) fn new(problem: &Problem, multiplier: Option<usize>) -> Self {
        let s = problem.statement();
        let live = match s.objective {
            Objective::Body { gravity } => gravity,
            _ => [0.0; 2],
        };
        Self {
            gravity: s.gravity,
            live,
            datum: s.datum,
            surcharge: s.surcharge,
            weight: problem.soils[0].unit_weight,
            columns: columns(problem),
            multiplier,
        }
    }

    /// Form of the factor: one where there is none.
    pub(crate) fn factor(&self) -> Form {
        self.multiplier.map_or(Form::constant(1.0), |m| Form::unknown(m, 1.0))
    }

    /// Stress `[xx, yy, xy]` at a point of a region, tension positive.
    pub(crate) fn at(&self, region: usize, p: Point) -> [Form; 3] {
        let depth = self.datum - p[1];
        let [gx, gy] = self.gravity;
        let t = if gy == 0.0 { 0.0 } else { gx / gy };
        let vertical = self.weight * gy * depth;
        let column = at(&self.columns[region], p);
        let dead = [
            (1.0 + 2.0 * t * t) * vertical - self.surcharge,
            vertical - self.surcharge + gy * column,
            self.weight * gx * depth,
        ];
        let [hx, hy] = self.live;
        let live =
            [self.weight * hy * depth, self.weight * hy * depth + hy * column, self.weight * hx * depth];
        std::array::from_fn(|i| {
            let mut form = Form::constant(dead[i]);
            if let Some(m) = self.multiplier.filter(|_| live[i] != 0.0) {
                form.add(1.0, &Form::unknown(m, live[i]));
            }
            form
        })
    }

    /// Vertical stress per unit of depth of soil, and the horizontal one that goes with it.
    pub(crate) fn rate(&self, weight: f64) -> Form {
        let mut form = Form::constant(weight * self.gravity[1]);
        if let Some(m) = self.multiplier.filter(|_| self.live[1] != 0.0) {
            form.add(1.0, &Form::unknown(m, weight * self.live[1]));
        }
        form
    }

    pub(crate) fn surcharge(&self) -> f64 {
        self.surcharge
    }
}

/// Sides with the region below them, as `(line, what is above)`.
fn tops(problem: &Problem, region: usize) -> Vec<(usize, Option<usize>)> {
    let s = problem.statement();
    let mut tops = Vec::new();
    for side in s.regions[region].loops.iter().flatten() {
        let [p, q] = problem.ends(side.line);
        let run = if side.forward { q[0] - p[0] } else { p[0] - q[0] };
        if run < 0.0 {
            let above = problem.owner(side.reversed()).filter(|_| problem.condition(*side).is_none());
            // A line through one region has the same reference on both sides.
            if above != Some(region) {
                tops.push((side.line, above));
            }
        }
    }
    tops
}

fn columns(problem: &Problem) -> Vec<Plane> {
    let soils = &problem.soils;
    let weight = soils[0].unit_weight;
    let count = soils.len();
    let mut columns: Vec<Plane> = vec![[0.0; 3]; count];
    if soils.iter().all(|s| s.unit_weight == weight) {
        return columns;
    }
    let tops: Vec<_> = (0..count).map(|r| tops(problem, r)).collect();
    // From the top down: a region is done when all above it are.
    let mut done = vec![false; count];
    for _ in 0..count {
        for region in 0..count {
            let interfaces: Vec<(usize, usize)> =
                tops[region].iter().filter_map(|(line, above)| Some((*line, (*above)?))).collect();
            if done[region] || interfaces.iter().any(|(_, above)| !done[*above]) {
                continue;
            }
            done[region] = true;
            let extra = soils[region].unit_weight - weight;
            if extra == 0.0 && interfaces.iter().all(|(_, above)| columns[*above] == [0.0; 3]) {
                continue;
            }
            let boundary = match tops[region].as_slice() {
                [] => None,
                [(line, _), rest @ ..] => {
                    let level = |l: usize| {
                        let [p, q] = problem.ends(l);
                        (p[1] == q[1]).then_some(p[1])
                    };
                    let same = rest.iter().all(|(l, _)| level(*l).is_some() && level(*l) == level(*line));
                    same.then_some(*line)
                }
            };
            let (line, above) = match interfaces.first() {
                Some((line, above)) => (Some(*line), columns[*above]),
                None => (boundary, [0.0; 3]),
            };
            // Height of the top as a function of x.
            let (height, slope) = match line {
                Some(line) => {
                    let [p, q] = problem.ends(line);
                    let slope = (q[1] - p[1]) / (q[0] - p[0]);
                    (p[1] - slope * p[0], slope)
                }
                None => (problem.statement().datum, 0.0),
            };
            columns[region] = [
                above[0] + above[2] * height + extra * height,
                above[1] + above[2] * slope + extra * slope,
                -extra,
            ];
        }
    }
    columns
}
