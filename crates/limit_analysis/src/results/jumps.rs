use soilctl_certificate::{Adjoins, Condition, Side};

use super::Point;
use super::flow::FlowResults;
use super::strength::{Strength, over_edge};
use crate::vector::distance;

/// Differences below this fraction of the greatest velocity are rounding.
const ROUNDING: f64 = 1e-12;

/// By what fraction of itself a jump may miss the flow rule of a soil that is still taken to be the one that shears.
const MISSED: f64 = 1e-6;

/// An edge across which the velocity jumps: between two triangles, or between soil and structure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// First and last point of the edge, walked with the soil on the left (length).
    pub ends: [Point; 2],
    /// Index of the triangle on the left.
    pub triangle: usize,
    /// Bernstein coefficients (start, middle, end) of the velocity on the left relative to that on the right, along the
    /// edge.
    pub slip: [f64; 3],
    /// The same across the edge, to the left: how fast it opens.
    pub opening: [f64; 3],
    /// Plastic dissipation per length of the edge, on average (stress times velocity).
    pub dissipation: f64,
    /// Whether the structure is on the right, not soil.
    pub at_structure: bool,
    /// Power of the pore pressure on the opening, per length.
    pub(super) by_water: f64,
}

impl Jump {
    /// Length of the edge.
    #[must_use]
    pub fn length(&self) -> f64 {
        let [a, b] = self.ends;
        distance(b, a)
    }

    /// The greatest relative speed of its three control points.
    #[must_use]
    pub fn speed(&self) -> f64 {
        (0..3).map(|i| self.slip[i].hypot(self.opening[i])).fold(0.0, f64::max)
    }
}

impl FlowResults {
    /// All edges across which the velocity jumps, each once.
    #[must_use]
    pub fn jumps(&self) -> Vec<Jump> {
        let least = ROUNDING * self.speed();
        let mut jumps = Vec::new();
        for (triangle, adjoins) in self.shown.adjoins.iter().enumerate() {
            for (corner, adjoins) in adjoins.iter().enumerate() {
                let jump = match *adjoins {
                    Adjoins::Soil(Side { triangle: other, corner: there })
                        if (triangle, corner) < (other, there) =>
                    {
                        self.between(triangle, corner, other, there)
                    }
                    Adjoins::Boundary { condition: Condition::Face { delta_deg, adhesion }, .. } => {
                        self.at_face(triangle, corner, Strength::of_face(delta_deg, adhesion))
                    }
                    _ => continue,
                };
                if jump.speed() > least {
                    jumps.push(jump);
                }
            }
        }
        jumps
    }

    fn jump(&self, triangle: usize, corner: usize, beyond: [Point; 3]) -> Jump {
        let here = self.on_edge(triangle, corner);
        let ends = self.ends(triangle, corner);
        let [a, b] = ends;
        let length = distance(b, a);
        let t = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let difference = [0, 1, 2].map(|i| [here[i][0] - beyond[i][0], here[i][1] - beyond[i][1]]);
        let slip = difference.map(|[x, y]| x * t[0] + y * t[1]);
        let opening = difference.map(|[x, y]| y * t[0] - x * t[1]);
        Jump { ends, triangle, slip, opening, dissipation: 0.0, at_structure: false, by_water: 0.0 }
    }

    fn between(&self, triangle: usize, corner: usize, other: usize, there: usize) -> Jump {
        let [end, middle, start] = self.on_edge(other, there);
        let mut jump = self.jump(triangle, corner, [start, middle, end]);
        // A thin layer of the soil of either side; that which allows it and dissipates less.
        let allowed = MISSED * jump.speed();
        let soils = [triangle, other].map(|t| {
            let material = self.material(t);
            let strength = Strength::of_soil(material);
            let mut missed: f64 = 0.0;
            for i in 0..3 {
                missed = missed.max(jump.slip[i].abs() * strength.tan() - jump.opening[i]);
                if strength.tan() == 0.0 && material.tension.is_none() {
                    missed = missed.max(jump.opening[i]);
                }
            }
            let power = strength.in_layer(jump.ends, jump.opening, jump.slip);
            let pore = jump.ends.map(|p| material.pore_pressure.at(p));
            (missed, power, over_edge(pore, jump.opening))
        });
        let best = soils
            .into_iter()
            .min_by(|a, b| (a.0 > allowed).cmp(&(b.0 > allowed)).then((a.1 - a.2).total_cmp(&(b.1 - b.2))));
        if let Some((_, power, water)) = best {
            (jump.dissipation, jump.by_water) = (power, water);
        }
        jump
    }

    fn at_face(&self, triangle: usize, corner: usize, strength: Strength) -> Jump {
        let mut jump = self.jump(triangle, corner, [self.statement.objective.velocity(); 3]);
        let pore = jump.ends.map(|p| self.material(triangle).pore_pressure.at(p));
        jump.dissipation = strength.in_layer(jump.ends, jump.opening, jump.slip);
        jump.by_water = over_edge(pore, jump.opening);
        jump.at_structure = true;
        jump
    }
}
