//! Measurements as constraints on density: for given phi and delta, a force interval is a density interval.

use soilctl_earth_pressure::{EarthPressureError, ModelSlice};

use crate::end_factor::EndFactors;
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
}

/// What a model says of a measurement at one (phi, delta): net weight factors, and the force of the other loads in N.
#[derive(Clone, Copy)]
pub(crate) struct Net {
    lower: f64,
    upper: f64,
    ends_at_most: f64,
    rest_n: f64,
}

impl Net {
    /// The bracket of the weight factor for end factors in an interval.
    fn bracket(&self, ends: EndFactors) -> (f64, f64) {
        (self.lower + ends.low * self.ends_at_most, self.upper - (1.0 - ends.high) * self.ends_at_most)
    }
}

impl Constraint<'_> {
    /// What the model says at a point. `None` where it carries any load (Coulomb's singular corner), so that no finite
    /// force is consistent.
    pub(crate) fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<Option<Net>, EarthPressureError> {
        match self.slice.net(phi_deg, delta_deg) {
            Ok(net) if net.weight_lower > 0.0 => {
                let [surcharge, cohesion, adhesion] = self.loads_n;
                let f = net.factors;
                Ok(Some(Net {
                    lower: net.weight_lower,
                    upper: net.weight_upper,
                    ends_at_most: net.ends_at_most,
                    rest_n: surcharge * f.surcharge + cohesion * f.cohesion + adhesion * f.adhesion,
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
        [divide(self.low_n - net.rest_n, upper, lower), divide(self.high_n - net.rest_n, lower, upper)]
    }

    /// Force per density and force without density, by the geometric mean of the bracket.
    pub(crate) fn force_parts(&self, net: &Net, ends: EndFactors) -> (f64, f64) {
        let (lower, upper) = net.bracket(ends);
        (self.scale * (lower * upper).sqrt(), net.rest_n)
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
    })
}
