//! A force model at one geometry, as a grid of friction angles that boxes of soils are looked up in.

use soilctl_earth_pressure::{EarthPressureError, ModelSlice};

/// Steps of the grid in deg. Logarithms of coefficients curve by some 0.002 per deg2, so that between nodes they are straight within
const PHI_STEP_DEG: f64 = 0.25;
const DELTA_STEP_DEG: f64 = 0.5;
/// this, by which brackets are moved outwards.
const CURVED: f64 = 2e-4;

/// What a model says at a node: logarithms of the lower and the upper weight factor, and what the ends of the plate add to it at most.
#[derive(Debug, Clone, Copy)]
struct Node {
    lower: f64,
    upper: f64,
    ends: f64,
}

/// No load is too much for the model (Coulomb's singular corner), or it has no answer.
const NO_FORCE: Node = Node { lower: f64::INFINITY, upper: f64::INFINITY, ends: 0.0 };

/// Net weight factors by slant length, over friction angles of soil and plate.
#[derive(Debug, Clone)]
pub struct Coefficients {
    phi: Axis,
    delta: Axis,
    /// By delta, then by phi.
    nodes: Vec<Node>,
}

impl Coefficients {
    /// Of a model at one geometry, for friction angles of the soil and on the plate between two angles in deg. Where the plate would be rougher than
    /// the soil, soil slides on itself.
    ///
    /// # Errors
    /// What the model says, other than that it has no finite force.
    pub fn of(
        slice: &dyn ModelSlice,
        phi_deg: (f64, f64),
        delta_deg: (f64, f64),
    ) -> Result<Self, EarthPressureError> {
        let (phi, delta) = (Axis::new(phi_deg, PHI_STEP_DEG), Axis::new(delta_deg, DELTA_STEP_DEG));
        let mut nodes = Vec::with_capacity(phi.count * delta.count);
        for on_plate in delta.values() {
            for friction in phi.values() {
                nodes.push(match slice.net(friction, on_plate.min(friction)) {
                    Ok(net) if net.weight_lower > 0.0 => Node {
                        lower: libm::log(net.weight_lower),
                        upper: libm::log(net.weight_upper),
                        ends: net.ends_at_most,
                    },
                    Ok(_) | Err(EarthPressureError::Singular { .. }) => NO_FORCE,
                    Err(error) => return Err(error),
                });
            }
        }
        Ok(Self { phi, delta, nodes })
    }

    /// Least and greatest weight factor for friction angles (deg) of soil and plate, and parts of what ends add at most, in intervals. Factors grow with the
    /// soil's friction, and over the few degrees that are not known of the plate's they have their extremes at the ends.
    #[must_use]
    pub fn range(&self, phi_deg: [f64; 2], delta_deg: [f64; 2], ends: [f64; 2]) -> [f64; 2] {
        let low = |delta: f64| {
            let node = self.at(phi_deg[0], delta);
            libm::exp(node.lower - CURVED) + ends[0] * node.ends
        };
        let high = |delta: f64| {
            let node = self.at(phi_deg[1], delta);
            libm::exp(node.upper + CURVED) - (1.0 - ends[1]) * node.ends
        };
        if delta_deg[0] == delta_deg[1] {
            return [low(delta_deg[0]), high(delta_deg[0])];
        }
        [low(delta_deg[0]).min(low(delta_deg[1])), high(delta_deg[0]).max(high(delta_deg[1]))]
    }

    /// Logarithm of the factor in the middle of its bracket, without ends; beside soils without a finite force that of the next ones that have one, and at most that of
    /// a factor of a thousand.
    #[must_use]
    pub fn ln_middle(&self, phi_deg: f64, delta_deg: f64) -> f64 {
        const MOST: f64 = 7.0;
        let node = self.at(phi_deg, delta_deg);
        let middle = if node.upper.is_finite() { 0.5 * (node.lower + node.upper) } else { node.lower };
        middle.min(MOST)
    }

    /// Between nodes: logarithms along both angles. Where a node has no force the lower factor is that of those that have one.
    fn at(&self, phi_deg: f64, delta_deg: f64) -> Node {
        let ((i, s), (j, t)) = (self.phi.place(phi_deg), self.delta.place(delta_deg));
        let (right, up) = ((i + 1).min(self.phi.count - 1), (j + 1).min(self.delta.count - 1));
        let node = |column: usize, row: usize| self.nodes[row * self.phi.count + column];
        let corners = [node(i, j), node(right, j), node(i, up), node(right, up)];
        let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t];
        if corners.iter().any(|node| !node.upper.is_finite()) {
            let least = corners.iter().map(|node| node.lower).fold(f64::INFINITY, f64::min);
            return Node { lower: least, upper: f64::INFINITY, ends: 0.0 };
        }
        let mean = |values: [f64; 4]| -> f64 { values.iter().zip(weights).map(|(value, w)| value * w).sum() };
        Node {
            lower: mean(corners.map(|n| n.lower)),
            upper: mean(corners.map(|n| n.upper)),
            ends: mean(corners.map(|n| n.ends)),
        }
    }
}

/// Nodes at even distances.
#[derive(Debug, Clone, Copy)]
struct Axis {
    low: f64,
    step: f64,
    count: usize,
}

impl Axis {
    fn new((low, high): (f64, f64), widest: f64) -> Self {
        let parts = ((high - low) / widest).ceil().max(0.0);
        Self { low, step: if parts > 0.0 { (high - low) / parts } else { 1.0 }, count: parts as usize + 1 }
    }

    fn values(self) -> impl Iterator<Item = f64> {
        (0..self.count).map(move |i| self.low + self.step * i as f64)
    }

    /// The node below a value, and how far beyond it that is in steps; ends beyond the ends.
    fn place(&self, value: f64) -> (usize, f64) {
        let at = ((value - self.low) / self.step).clamp(0.0, (self.count - 1) as f64);
        (at as usize, at.fract())
    }
}
