//! A description turned into a statement, with the way back to its units.

use soilctl_certificate::{Scale, Statement};

use super::seepage::Flowed;
use crate::error::LimitError;
use crate::problem::Problem;

/// What a bound of a described problem is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// Force of the structure on the soil along its motion in kN per metre of width; negative where soil pushes it on.
    ForceKnPerM,
    /// Factor on the live loads.
    LoadFactor,
    /// Factor on the unit weights.
    WeightFactor,
    /// Horizontal acceleration over gravity.
    Acceleration,
}

/// A described problem in the units of the solver.
#[derive(Debug, Clone, PartialEq)]
pub struct Described {
    /// The statement: lengths in units of [`length_m`](Self::length_m) from an origin of its own, stresses in units of
    /// [`stress_kpa`](Self::stress_kpa).
    pub statement: Statement,
    /// Names of the soils of the statement's regions.
    pub soils: Vec<String>,
    /// Unit of length in m: the size of what moves or carries the load.
    pub length_m: f64,
    /// Unit of stress in kPa.
    pub stress_kpa: f64,
    /// What is bounded.
    pub quantity: Quantity,
    /// The problem in words.
    pub title: Option<String>,
    /// How ground water flows, where heads are given.
    pub flowed: Option<Flowed>,
}

impl Described {
    /// The problem for [`crate::bound`].
    ///
    /// # Errors
    ///
    /// [`LimitError`] if the geometry cannot be meshed.
    pub fn problem(&self) -> Result<Problem, LimitError> {
        Problem::new(self.statement.clone())
    }

    /// Lower and upper bound in the units of the description; rounding is outwards.
    #[must_use]
    pub fn in_units(&self, bounds: [f64; 2]) -> [f64; 2] {
        if self.quantity != Quantity::ForceKnPerM {
            return bounds;
        }
        // Two products, one rounding each.
        let slack = 4.0 * f64::EPSILON;
        let [lower, upper] = bounds.map(|b| b * self.length_m * self.stress_kpa);
        [lower - slack * lower.abs(), upper + slack * upper.abs()]
    }

    /// What the units of the statement are, for a saved solution.
    #[must_use]
    pub fn scale(&self) -> Scale {
        let quantity = match self.quantity {
            Quantity::ForceKnPerM => "force of the structure along its motion; in kN/m times",
            Quantity::LoadFactor => "factor on the live loads; one unit of force in kN/m is",
            Quantity::WeightFactor => "factor on the unit weights; one unit of force in kN/m is",
            Quantity::Acceleration => "horizontal acceleration over gravity; one unit of force in kN/m is",
        };
        let title = self.title.as_ref().map_or_else(String::new, |t| format!("{t}: "));
        Scale {
            length_m: Some(self.length_m),
            unit_weight_n_per_m3: Some(1e3 * self.stress_kpa / self.length_m),
            description: Some(format!("{title}{quantity} {}", self.length_m * self.stress_kpa)),
        }
    }
}
