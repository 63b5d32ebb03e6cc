//! Heads by Newton's method, with permeability that falls where the pressure is below zero, and air as an active set.

use crate::error::SeepageError;
use crate::ground::Ground;
use crate::linear::{Term, solve};
use crate::nodes::{Hold, Nodes};

/// Permeability of dry soil over that of saturated soil.
const DRY: f64 = 1e-2;

/// Height in which it falls to that, over the height of the triangle: less takes more steps, and lets less flow through above the free
/// surface.
const FRINGE: f64 = 0.25;

/// Most steps; known cases take 5 to 30.
const MOST_STEPS: usize = 300;

/// What heads may still change by at the end, as a part of the height of the soil and the range of heads together.
const SETTLED: f64 = 1e-10;

/// Shortest part of a Newton step before a step with fixed permeability is made instead.
const LEAST_PART: f64 = 1.0 / 64.0;

/// A steady flow.
#[derive(Debug, Clone, PartialEq)]
pub struct Flow {
    /// For each triangle, the total head at its corners in m.
    pub heads: Vec<[f64; 3]>,
    /// For each entry of given heads, what flows into the soil there in m3/s for a metre of width; negative where it flows out.
    pub inflow: Vec<f64>,
    /// What comes out in air, likewise: zero or negative.
    pub air: f64,
    /// Steps until the free surface was found.
    pub steps: usize,
}

/// What the equations know of a triangle.
struct Element {
    nodes: [usize; 3],
    /// Flow out of corner `i` for a head of one at corner `j`, at full permeability.
    conductance: [[f64; 3]; 3],
    /// Height in which the permeability falls.
    fringe: f64,
    /// Heights of the corners.
    y: [f64; 3],
}

impl Element {
    /// The part of the permeability that is left, and how it grows with the head at each corner: the mean of those at the middles
    /// of the edges.
    fn permeable(&self, heads: &[f64]) -> (f64, [f64; 3]) {
        let pressure = [0, 1, 2].map(|i| heads[self.nodes[i]] - self.y[i]);
        let (mut part, mut growth) = (0.0, [0.0; 3]);
        for k in 0..3 {
            let [i, j] = [(k + 1) % 3, (k + 2) % 3];
            let left = 1.0 + 0.5 * (pressure[i] + pressure[j]) / self.fringe;
            part += left.clamp(DRY, 1.0) / 3.0;
            if left > DRY && left < 1.0 {
                growth[i] += 0.5 / (3.0 * self.fringe);
                growth[j] += 0.5 / (3.0 * self.fringe);
            }
        }
        (part, growth)
    }

    fn flows(&self, heads: &[f64]) -> [f64; 3] {
        let h = self.nodes.map(|n| heads[n]);
        self.conductance.map(|row| row[0] * h[0] + row[1] * h[1] + row[2] * h[2])
    }
}

/// The equations of a ground.
struct Equations {
    nodes: Nodes,
    elements: Vec<Element>,
}

impl Equations {
    /// What enters the soil at each node.
    fn inflow(&self, heads: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; heads.len()];
        for element in &self.elements {
            let (part, _) = element.permeable(heads);
            for (node, flow) in element.nodes.into_iter().zip(element.flows(heads)) {
                all[node] += part * flow;
            }
        }
        all
    }

    /// The change of free heads that would remove an imbalance, by Newton's method or with permeabilities held.
    fn step(
        &self,
        heads: &[f64],
        inflow: &[f64],
        unknown: &[Option<usize>],
        newton: bool,
    ) -> Result<Vec<f64>, SeepageError> {
        let mut terms: Vec<Term> = Vec::with_capacity(9 * self.elements.len());
        for element in &self.elements {
            let ((part, growth), flows) = (element.permeable(heads), element.flows(heads));
            for (i, flow) in flows.iter().enumerate() {
                for (j, growth) in growth.iter().enumerate() {
                    let [Some(row), Some(column)] = [i, j].map(|k| unknown[element.nodes[k]]) else {
                        continue;
                    };
                    let more = if newton { flow * growth } else { 0.0 };
                    terms.push((row, column, part * element.conductance[i][j] + more));
                }
            }
        }
        let size = unknown.iter().flatten().count();
        let mut right = vec![0.0; size];
        for (node, number) in unknown.iter().enumerate() {
            if let Some(number) = number {
                right[*number] = -inflow[node];
            }
        }
        let found = if size == 0 { Vec::new() } else { solve(size, &terms, &right)? };
        Ok(unknown.iter().map(|number| number.map_or(0.0, |n| found[n])).collect())
    }
}

impl Ground {
    /// The steady flow.
    ///
    /// # Errors
    ///
    /// [`SeepageError`] for input that is out of range, soil that no given head reaches, and a free surface that is not found.
    pub fn flow(&self) -> Result<Flow, SeepageError> {
        self.check()?;
        let nodes = Nodes::new(self)?;
        let greatest = self.triangles.iter().flat_map(|t| t.permeability).fold(0.0, f64::max);
        let elements = self.elements(&nodes, greatest)?;
        let equations = Equations { nodes, elements };
        let (heads, inflow, steps) = equations.solve()?;
        let Nodes { of, holds, .. } = equations.nodes;
        let mut flow = Flow { heads: Vec::with_capacity(of.len()), inflow: Vec::new(), air: 0.0, steps };
        flow.heads.extend(of.iter().map(|corners| corners.map(|node| heads[node])));
        for (hold, inflow) in holds.iter().zip(inflow) {
            match hold {
                Hold::Head { entry, .. } => {
                    let count = flow.inflow.len().max(entry + 1);
                    flow.inflow.resize(count, 0.0);
                    flow.inflow[*entry] += greatest * inflow;
                }
                Hold::Air => flow.air += greatest * inflow,
                Hold::Nothing => {}
            }
        }
        Ok(flow)
    }

    fn elements(&self, nodes: &Nodes, greatest: f64) -> Result<Vec<Element>, SeepageError> {
        let mut elements = Vec::with_capacity(self.triangles.len());
        for (t, triangle) in self.triangles.iter().enumerate() {
            let p = triangle.corners.map(|c| self.points[c]);
            // Gradients of the heads, times twice the area.
            let gradient = |k: usize| {
                let [a, b] = [p[(k + 1) % 3], p[(k + 2) % 3]];
                [a[1] - b[1], b[0] - a[0]]
            };
            let g = [0, 1, 2].map(gradient);
            let double = g[0][0] * g[1][1] - g[0][1] * g[1][0];
            let y = p.map(|p| p[1]);
            let height = y.iter().copied().fold(f64::NEG_INFINITY, f64::max)
                - y.iter().copied().fold(f64::INFINITY, f64::min);
            if !(double > 0.0 && height > 0.0) {
                return Err(SeepageError::Flat { triangle: t });
            }
            let [kx, ky] = triangle.permeability.map(|k| k / greatest / (2.0 * double));
            let conductance = g.map(|a| g.map(|b| kx * a[0] * b[0] + ky * a[1] * b[1]));
            elements.push(Element { nodes: nodes.of[t], conductance, fringe: FRINGE * height, y });
        }
        Ok(elements)
    }
}

impl Equations {
    /// Heads, what enters at each node, and the steps it took.
    fn solve(&self) -> Result<(Vec<f64>, Vec<f64>, usize), SeepageError> {
        let Nodes { at, holds, .. } = &self.nodes;
        let given =
            || holds.iter().filter_map(|h| if let Hold::Head { head, .. } = h { Some(*head) } else { None });
        let [low, high] = [given().fold(f64::INFINITY, f64::min), given().fold(f64::NEG_INFINITY, f64::max)];
        let heights = || at.iter().map(|p| p[1]);
        let height = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        let settled = SETTLED * (height + high - low);
        // Water comes out where the head would stand above the ground.
        let mut wet: Vec<bool> =
            holds.iter().zip(at).map(|(h, p)| *h == Hold::Air && 0.5 * (low + high) > p[1]).collect();
        let mut heads = vec![0.5 * (low + high); at.len()];
        let fix = |heads: &mut [f64], wet: &[bool]| {
            for (node, hold) in holds.iter().enumerate() {
                match hold {
                    Hold::Head { head, .. } => heads[node] = *head,
                    Hold::Air if wet[node] => heads[node] = at[node][1],
                    Hold::Air | Hold::Nothing => {}
                }
            }
        };
        fix(&mut heads, &wet);
        let mut change = f64::INFINITY;
        for step in 0..MOST_STEPS {
            let mut count = 0;
            let number = |(node, hold): (usize, &Hold)| {
                let is_free = !matches!(hold, Hold::Head { .. }) && !wet[node];
                is_free.then(|| {
                    count += 1;
                    count - 1
                })
            };
            let unknown: Vec<Option<usize>> = holds.iter().enumerate().map(number).collect();
            let imbalance = |inflow: &[f64]| -> f64 {
                let free = unknown.iter().zip(inflow).filter(|(number, _)| number.is_some());
                free.map(|(_, flow)| flow * flow).sum::<f64>().sqrt()
            };
            let mut inflow = self.inflow(&heads);
            let before = imbalance(&inflow);
            let by = self.step(&heads, &inflow, &unknown, true)?;
            let moved = |by: &[f64], part: f64| -> Vec<f64> {
                heads.iter().zip(by).map(|(head, by)| head + part * by).collect()
            };
            let mut part = 1.0;
            let mut next = moved(&by, part);
            change = by.iter().fold(0.0, |most: f64, by| most.max(by.abs()));
            while change > settled && part > LEAST_PART {
                inflow = self.inflow(&next);
                if imbalance(&inflow) <= (1.0 - 0.1 * part) * before {
                    break;
                }
                part *= 0.5;
                next = moved(&by, part);
            }
            if change > settled && part <= LEAST_PART {
                let by = self.step(&heads, &self.inflow(&heads), &unknown, false)?;
                next = moved(&by, 1.0);
            }
            heads = next;
            inflow = self.inflow(&heads);
            // A node in air lets water out, or has no pressure to.
            let change_of_air = |(node, is_wet): (usize, &bool)| match holds[node] {
                Hold::Air if *is_wet => inflow[node] <= settled,
                Hold::Air => heads[node] > at[node][1] + settled,
                Hold::Head { .. } | Hold::Nothing => false,
            };
            let now: Vec<bool> = wet.iter().enumerate().map(change_of_air).collect();
            let is_same = now == wet;
            wet = now;
            fix(&mut heads, &wet);
            if is_same && change <= settled {
                let inflow = self.inflow(&heads);
                return Ok((heads, inflow, step + 1));
            }
        }
        Err(SeepageError::NotFound { steps: MOST_STEPS, change })
    }
}
