use soilctl_certificate::{Adjoins, Condition, FlowPiece, Objective};

use super::Point;
use super::flow::{FlowResults, area, invariants, strain_rates};
use super::strength::{Strength, over_edge, over_triangle};
use crate::vector::between;

/// The power balance of a flow, per unit width (force times velocity).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Power {
    /// Plastic dissipation in the soil. Soil without cohesion dissipates nothing: dilation takes back what shearing costs.
    pub in_soil: f64,
    /// The same along lines where the velocity jumps, and at the structure.
    pub along_jumps: f64,
    /// What the pore pressure does as the soil dilates.
    pub by_water: f64,
    /// What the weight does.
    pub by_weight: f64,
    /// What surcharge and other dead loads do.
    pub by_loads: f64,
    /// What the loads or the body force do whose factor is bounded; zero if a structure's force or the factor on all that
    /// acts is.
    pub live: f64,
}

impl Power {
    /// The upper bound that follows; none if a factor is bounded and the load does no work.
    #[must_use]
    pub fn bound(&self, objective: &Objective) -> Option<f64> {
        let dissipated = self.in_soil + self.along_jumps;
        let acts = self.by_water + self.by_weight + self.by_loads;
        let net = dissipated - acts;
        match objective {
            Objective::Structure { .. } => Some(net),
            Objective::Loads | Objective::Body { .. } => (self.live > 0.0).then_some(net / self.live),
            Objective::Everything => (acts > 0.0).then_some(dissipated / acts),
        }
    }
}

impl FlowResults {
    /// Plastic dissipation per area, on average over each piece of each triangle (stress over time).
    #[must_use]
    pub fn dissipation(&self) -> Vec<Vec<f64>> {
        self.each_piece(|triangle, piece| {
            let strength = Strength::of_soil(self.material(triangle));
            let [e, g] = dilation_and_shear(piece, &strength);
            strength.in_triangle(piece.corners, e, g)
        })
    }

    /// Greatest shear strain rate, on average over each piece of each triangle (velocity over length).
    #[must_use]
    pub fn shear_rate(&self) -> Vec<Vec<f64>> {
        self.each_piece(|_, piece| {
            over_triangle([1.0; 3], strain_rates(piece).map(|rate| invariants(rate)[1]))
        })
    }

    fn each_piece(&self, of: impl Fn(usize, &FlowPiece) -> f64) -> Vec<Vec<f64>> {
        let all = self.pieces().iter().enumerate();
        all.map(|(t, pieces)| pieces.iter().map(|piece| of(t, piece)).collect()).collect()
    }

    /// Where the power goes, and comes from.
    #[must_use]
    pub fn power(&self) -> Power {
        let mut power = Power::default();
        for (triangle, pieces) in self.pieces().iter().enumerate() {
            for piece in pieces {
                self.add_piece(triangle, piece, &mut power);
            }
            for corner in 0..3 {
                self.add_loads(triangle, corner, &mut power);
            }
        }
        for jump in self.jumps() {
            power.along_jumps += jump.length() * jump.dissipation;
            power.by_water += jump.length() * jump.by_water;
        }
        power
    }

    fn add_piece(&self, triangle: usize, piece: &FlowPiece, power: &mut Power) {
        let material = self.material(triangle);
        let (area, strength) = (area(piece), Strength::of_soil(material));
        let [e, g] = dilation_and_shear(piece, &strength);
        power.in_soil += area * strength.in_triangle(piece.corners, e, g);
        let pore = piece.corners.map(|p| material.pore_pressure.at(p));
        power.by_water += area * over_triangle(pore, e);
        let mean = [0, 1].map(|axis| piece.control.iter().map(|b| b[axis]).sum::<f64>() / 6.0);
        let work = |[x, y]: Point| material.unit_weight * area * (x * mean[0] + y * mean[1]);
        power.by_weight += work(self.statement.gravity);
        if let Objective::Body { gravity } = self.statement.objective {
            power.live += work(gravity);
        }
    }

    fn add_loads(&self, triangle: usize, corner: usize, power: &mut Power) {
        let Adjoins::Boundary { side, ends: s, condition } = self.shown.adjoins[triangle][corner] else {
            return;
        };
        let (pressure, shear, live) = match condition {
            Condition::Free => ([self.statement.surcharge; 2], [0.0; 2], false),
            Condition::Loaded { pressure, shear, live } => (pressure, shear, live),
            Condition::Submerged => {
                let (line, water) = (self.statement.lines[side.line], self.material(triangle).pore_pressure);
                let pressure = [line.from, line.to].map(|point| water.at(self.statement.points[point]));
                (pressure, [0.0; 2], false)
            }
            // What acts on a beam is not the soil's.
            Condition::Lined { .. }
            | Condition::Fixed
            | Condition::Smooth
            | Condition::Far
            | Condition::Face { .. } => return,
        };
        let [a, b] = self.ends(triangle, corner);
        let d = between(a, b);
        let v = self.on_edge(triangle, corner);
        let at = |[from, to]: [f64; 2]| s.map(|s| from + s * (to - from));
        let work = over_edge(at(pressure), v.map(|v| v[1] * d[0] - v[0] * d[1]))
            + over_edge(at(shear), v.map(|v| v[0] * d[0] + v[1] * d[1]));
        if live && self.statement.objective == Objective::Loads {
            power.live += work;
        } else {
            power.by_loads += work;
        }
    }
}

/// At the corners of a piece.
fn dilation_and_shear(piece: &FlowPiece, strength: &Strength) -> [[f64; 3]; 2] {
    let rates = strain_rates(piece);
    [rates.map(|rate| invariants(rate)[0]), rates.map(|rate| strength.shear_rate(rate))]
}
