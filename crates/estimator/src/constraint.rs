//! Measurements as constraints on density: for given phi and delta, a force interval is a density interval.

use soilctl_earth_pressure::{EarthPressureError, ModelSlice};

use crate::end_factor::EndFactors;
use crate::law::FrictionLaw;
use crate::stress_level::StressLevel;
use crate::{EstimatorError, Observation, Setup};

/// Densities consistent with a measurement at one (phi, delta), in kg/m3.
pub(crate) type Band = [f64; 2];

/// All measurements of one geometry: `F = scale density K_weight + rest(phi, delta)`, F in an interval.
pub(crate) struct Constraint<'m> {
    slice: Box<dyn ModelSlice + 'm>,
    /// N per unit of coefficient and kg/m3.
    scale: f64,
    /// `L w` times each load in N: surcharge, cohesion, adhesion.
    loads_n: [f64; 3],
    low_n: f64,
    high_n: f64,
    /// The law of stress, if friction follows one, and the stress of the measurement.
    law: Option<(FrictionLaw, StressLevel)>,
}

/// What a model says of a measurement at one (phi, delta): net weight factors, what ends add to them at most, and the force of the other loads
/// in N. Where the soil's friction is an interval, lower ones are of the least and upper ones of the greatest friction.
#[derive(Clone, Copy)]
pub(crate) struct Net {
    lower: f64,
    upper: f64,
    ends_at_most: [f64; 2],
    rest_n: [f64; 2],
}

impl Net {
    /// The bracket of the weight factor for end factors in an interval.
    fn bracket(&self, ends: EndFactors) -> (f64, f64) {
        let [of_lower, of_upper] = self.ends_at_most;
        (self.lower + ends.low * of_lower, self.upper - (1.0 - ends.high) * of_upper)
    }

    /// One net for friction between two angles.
    fn between(weak: Self, strong: Self) -> Self {
        Self {
            lower: weak.lower,
            upper: strong.upper,
            ends_at_most: [weak.ends_at_most[0], strong.ends_at_most[1]],
            rest_n: [weak.rest_n[0], strong.rest_n[1]],
        }
    }
}

impl Constraint<'_> {
    /// Takes another law of stress, such as a slice of the one it has; nothing if it has none.
    pub(crate) fn follow(&mut self, law: FrictionLaw) {
        if let Some((own, _)) = &mut self.law {
            *own = law;
        }
    }

    /// How many decades the stress of the measurement is from the reference of its law, at most, for friction angles of sand.
    pub(crate) fn decades(&self, delta_deg: f64) -> Option<f64> {
        let (law, level) = self.law.as_ref()?;
        level.decades(law, delta_deg)
    }

    /// What the model says at a point. `None` where it carries any load (Coulomb's singular corner), so that no finite
    /// force is consistent.
    pub(crate) fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<Option<Net>, EarthPressureError> {
        let Some((law, level)) = &self.law else { return self.net_of(phi_deg, delta_deg) };
        let Some([weak, strong]) = level.friction_deg(law, phi_deg, delta_deg) else { return Ok(None) };
        // No interface is rougher than the soil beside it: there the soil slides on itself.
        let of = |phi: f64| self.net_of(phi, delta_deg.min(phi));
        let (Some(weak), Some(strong)) = (of(weak)?, of(strong)?) else { return Ok(None) };
        Ok(Some(Net::between(weak, strong)))
    }

    /// The same for the friction that the soil has in this measurement.
    fn net_of(&self, phi_deg: f64, delta_deg: f64) -> Result<Option<Net>, EarthPressureError> {
        match self.slice.net(phi_deg, delta_deg) {
            Ok(net) if net.weight_lower > 0.0 => {
                let [surcharge, cohesion, adhesion] = self.loads_n;
                let f = net.factors;
                Ok(Some(Net {
                    lower: net.weight_lower,
                    upper: net.weight_upper,
                    ends_at_most: [net.ends_at_most; 2],
                    rest_n: [surcharge * f.surcharge + cohesion * f.cohesion + adhesion * f.adhesion; 2],
                }))
            }
            Ok(_) | Err(EarthPressureError::Singular { .. }) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Densities that the measurement leaves, for end factors in an interval.
    pub(crate) fn band(&self, net: &Net, ends: EndFactors) -> Band {
        let (lower, upper) = net.bracket(ends);
        // The denominators swap where the force left for the weight is negative, so that the interval stays one.
        let divide = |force: f64, k: f64, k_negative: f64| {
            force / (self.scale * if force >= 0.0 { k } else { k_negative })
        };
        let [least, greatest] = net.rest_n;
        [divide(self.low_n - greatest, upper, lower), divide(self.high_n - least, lower, upper)]
    }

    /// Force per density and force without density, by the geometric mean of the bracket.
    pub(crate) fn force_parts(&self, net: &Net, ends: EndFactors) -> (f64, f64) {
        let (lower, upper) = net.bracket(ends);
        (self.scale * (lower * upper).sqrt(), f64::midpoint(net.rest_n[0], net.rest_n[1]))
    }
}

/// One constraint for each observation, in order.
pub(crate) fn each<'m>(setup: &Setup<'m>) -> Result<Vec<Constraint<'m>>, EstimatorError> {
    setup.observations.iter().map(|observation| constraint(setup, observation)).collect()
}

/// Constraints of a setup, those of one geometry merged into the intersection of their intervals (which may be
/// empty: low above high). Without other loads the tool angle, the slope and, for a model of plates with ends, the width
/// over depth make a geometry.
pub(crate) fn merged<'m>(setup: &Setup<'m>) -> Result<Vec<Constraint<'m>>, EstimatorError> {
    // Under a law of stress each measurement has a friction of its own.
    if setup.friction_law.is_some() {
        return each(setup);
    }
    let loads = setup.loads.any().is_some();
    let mut keyed: Vec<([u64; 5], Constraint<'m>)> = Vec::new();
    for observation in &setup.observations {
        let plate = observation.plate();
        let size = if loads { [plate.depth_m(), plate.width_m()] } else { [0.0; 2] };
        let ends = setup.width_ratio(plate).depth_over_width();
        let key = [plate.tool_angle().radians(), plate.surface_slope().radians(), ends, size[0], size[1]]
            .map(f64::to_bits);
        match keyed.iter_mut().find(|(k, _)| *k == key) {
            Some((_, known)) => {
                // Same angle, other size: forces scale with L^2 w.
                let ratio = known.scale / scale(setup, observation);
                known.low_n = known.low_n.max(observation.low_n() * ratio);
                known.high_n = known.high_n.min(observation.high_n() * ratio);
            }
            None => keyed.push((key, constraint(setup, observation)?)),
        }
    }
    Ok(keyed.into_iter().map(|(_, c)| c).collect())
}

fn scale(setup: &Setup<'_>, observation: &Observation) -> f64 {
    let plate = observation.plate();
    0.5 * setup.gravity_m_s2 * plate.slant_length_m().powi(2) * plate.width_m()
}

/// The constraint of one measurement.
pub(crate) fn constraint<'m>(
    setup: &Setup<'m>,
    observation: &Observation,
) -> Result<Constraint<'m>, EstimatorError> {
    let plate = observation.plate();
    let slice = setup.model.at(plate.tool_angle(), plate.surface_slope(), setup.width_ratio(plate)).map_err(
        |source| EstimatorError::Model { context: format!("measurement {}: ", observation.label()), source },
    )?;
    let area = plate.slant_length_m() * plate.width_m();
    let loads = &setup.loads;
    Ok(Constraint {
        slice,
        scale: scale(setup, observation),
        loads_n: [loads.surcharge_pa * area, loads.cohesion_pa * area, loads.adhesion_pa * area],
        low_n: observation.low_n(),
        high_n: observation.high_n(),
        law: setup.friction_law.map(|law| (law, setup.stress_level(observation))),
    })
}
