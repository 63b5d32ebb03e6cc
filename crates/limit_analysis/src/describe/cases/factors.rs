//! Partial factors, chosen and applied.

use super::{CaseEntry, Effect, Factors};
use crate::describe::check::{self, Range};
use crate::describe::error::DescriptionError;
use crate::describe::input::Description;
use crate::describe::parts::{Action, Kind, Profile};
use crate::describe::reduce::Divisors;

/// Partial factors are of this order.
const RANGE: Range = Range { low: 0.01, high: 100.0, words: "0.01 to 100" };

/// What a factor on resistance under design approach 2 depends on.
const DA2_RESISTANCE: &str = "design approach 2 divides the resistance by a factor that depends on what fails: give \
    factors.resistance (recommended: bearing 1.4, sliding 1.1, earth resistance 1.4, slopes 1.1)";

impl CaseEntry {
    /// All factors of a case: its own, then those of its approach, then one.
    pub(super) fn factors_for(
        &self,
        problem: &Description,
        title: &str,
    ) -> Result<Factors, DescriptionError> {
        let own = self.factors;
        for (key, value) in own.named() {
            if let Some(value) = value {
                check::number(title, key, value, RANGE)?;
            }
        }
        let mut preset = self.approach.map(super::Approach::factors).unwrap_or_default();
        if preset.weight.is_some_and(|w| w != 1.0) && own.weight.is_none() {
            match self.soil_weight {
                Some(Effect::Unfavourable) => {}
                Some(Effect::Favourable) => preset.weight = Some(1.0),
                None => {
                    return Err(DescriptionError::entry(
                        title,
                        "its approach multiplies unfavourable weight of soil: say soil_weight = \"favourable\" or \
                         \"unfavourable\", or give factors.weight",
                    ));
                }
            }
        }
        if self.approach.is_some() && own.resistance.is_none() && preset.resistance.is_none() {
            return Err(DescriptionError::entry(title, DA2_RESISTANCE));
        }
        let weight = own.weight.or(preset.weight);
        let factors = Factors {
            friction: own.friction.or(preset.friction),
            cohesion: own.cohesion.or(preset.cohesion),
            undrained: own.undrained.or(preset.undrained),
            weight,
            water: own.water.or(weight),
            permanent: own.permanent.or(preset.permanent),
            variable: own.variable.or(preset.variable),
            resistance: own.resistance.or(preset.resistance),
        };
        factors.know_actions(problem, title)?;
        Ok(factors)
    }
}

impl Factors {
    /// Its values with their keys.
    #[must_use]
    pub fn named(&self) -> [(&'static str, Option<f64>); 8] {
        [
            ("factors.friction", self.friction),
            ("factors.cohesion", self.cohesion),
            ("factors.undrained", self.undrained),
            ("factors.weight", self.weight),
            ("factors.water", self.water),
            ("factors.permanent", self.permanent),
            ("factors.variable", self.variable),
            ("factors.resistance", self.resistance),
        ]
    }

    /// Refuses loads of which nobody says what they are, where that matters.
    fn know_actions(&self, problem: &Description, title: &str) -> Result<(), DescriptionError> {
        let [permanent, variable] = [self.permanent, self.variable].map(|f| f.unwrap_or(1.0));
        if permanent == 1.0 && variable == 1.0 {
            return Ok(());
        }
        let unknown = |entry: String, key: &str| {
            DescriptionError::entry(
                entry,
                format!(
                    "{title} multiplies permanent loads by {permanent} and variable ones by {variable}: say {key} = \
                     \"permanent\", \"variable\" or \"favourable\""
                ),
            )
        };
        let loads = problem.boundaries.iter().enumerate().filter(|(_, b)| b.kind == Kind::Load);
        for (index, load) in loads {
            if load.action.is_none() {
                return Err(unknown(problem.boundary_title(index), "action"));
            }
        }
        if problem.surcharge_kpa > 0.0 && problem.surcharge_action.is_none() {
            return Err(unknown("the problem".into(), "surcharge_action"));
        }
        Ok(())
    }

    fn on(&self, action: Option<Action>) -> f64 {
        match action {
            Some(Action::Permanent) => self.permanent.unwrap_or(1.0),
            Some(Action::Variable) => self.variable.unwrap_or(1.0),
            Some(Action::Favourable) | None => 1.0,
        }
    }

    /// Applies all but the factor on resistance.
    pub(super) fn apply(&self, problem: &mut Description, title: &str) -> Result<(), DescriptionError> {
        let one = |factor: Option<f64>| factor.unwrap_or(1.0);
        let [friction, cohesion, undrained] = [self.friction, self.cohesion, self.undrained].map(one);
        if friction != cohesion
            && let Some(soil) = problem.soils.iter().find(|soil| soil.strength.is_some())
        {
            let problem = format!(
                "factors.friction is {friction} and factors.cohesion {cohesion}, but the strength of soil \"{}\" does not tell friction from cohesion; give \
                 both the same",
                soil.name
            );
            return Err(DescriptionError::entry(title, problem));
        }
        // Pullout is a resistance, and has factors of its own.
        problem.weaken(Divisors { friction, cohesion, undrained, pullout: 1.0 });
        for soil in &mut problem.soils {
            soil.unit_weight_kn_m3 *= one(self.weight);
        }
        if let Some(water) = &mut problem.water {
            water.unit_weight_kn_m3 *= one(self.water);
        } else if !problem.heads.is_empty() {
            problem.seepage.get_or_insert_default().unit_weight_kn_m3 *= one(self.water);
        } else if one(self.water) != one(self.weight)
            && problem.soils.iter().any(|s| s.pore_pressure_ratio > 0.0)
        {
            let problem =
                "pore pressures by a ratio go with the weight of soil: factors.water must be factors.weight";
            return Err(DescriptionError::entry(title, problem));
        }
        problem.surcharge_kpa *= self.on(problem.surcharge_action);
        for load in &mut problem.boundaries {
            let by = self.on(load.action);
            for profile in [&mut load.pressure_kpa, &mut load.shear_kpa].into_iter().flatten() {
                *profile = match *profile {
                    Profile::Uniform(value) => Profile::Uniform(by * value),
                    Profile::Linear(ends) => Profile::Linear(ends.map(|value| by * value)),
                };
            }
        }
        Ok(())
    }
}
