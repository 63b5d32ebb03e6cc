//! Measurements as constraints on density: for given phi and delta, a force interval is a density interval.

use soilctl_earth_pressure::{EarthPressureError, ModelSlice, NetFactors};

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

impl Constraint<'_> {
    /// Band at a point. `None` where the model carries any load (Coulomb's singular corner), so that no finite
    /// force is consistent.
    pub(crate) fn band(&self, phi_deg: f64, delta_deg: f64) -> Result<Option<Band>, EarthPressureError> {
        let Some((net, rest)) = self.net(phi_deg, delta_deg)? else { return Ok(None) };
        // The denominators swap where the force left for the weight is negative, so that the interval stays one.
        let divide = |force: f64, k: f64, k_negative: f64| {
            force / (self.scale * if force >= 0.0 { k } else { k_negative })
        };
        let low = divide(self.low_n - rest, net.weight_upper, net.weight_lower);
        let high = divide(self.high_n - rest, net.weight_lower, net.weight_upper);
        Ok(Some([low, high]))
    }

    /// Force per density and force without density at a point, by the geometric mean of a bracket; `None` as for
    /// [`Self::band`].
    pub(crate) fn force_parts(
        &self,
        phi_deg: f64,
        delta_deg: f64,
    ) -> Result<Option<(f64, f64)>, EarthPressureError> {
        Ok(self.net(phi_deg, delta_deg)?.map(|(net, rest)| (self.scale * net.factors.weight, rest)))
    }

    /// The model's factors and the force of the loads other than weight.
    fn net(&self, phi_deg: f64, delta_deg: f64) -> Result<Option<(NetFactors, f64)>, EarthPressureError> {
        match self.slice.net(phi_deg, delta_deg) {
            Ok(net) if net.weight_lower > 0.0 => {
                let [surcharge, cohesion, adhesion] = self.loads_n;
                let f = net.factors;
                Ok(Some((net, surcharge * f.surcharge + cohesion * f.cohesion + adhesion * f.adhesion)))
            }
            Ok(_) | Err(EarthPressureError::Singular { .. }) => Ok(None),
            Err(error) => Err(error),
        }
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

fn constraint<'m>(setup: &Setup<'m>, observation: &Observation) -> Result<Constraint<'m>, EstimatorError> {
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
