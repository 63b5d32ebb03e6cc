//! The normal stress on the slip surfaces of a stroke, by the friction that the soil may have.

use std::sync::{Arc, OnceLock};

use soilctl_earth_pressure::{Case, EQUIVALENT_OVER_MEAN, mean_slip_stress_over_pressure};
use soilctl_soil::{Angle, Plate};

use crate::law::FrictionLaw;
use crate::{Observation, Setup};

/// Step between nodes of friction angle and of interface friction, in degrees: between them stresses are straight to 0.0001.
const NODE_DEG: f64 = 2.0;
/// Nodes from 0 to 60 deg, where closed forms end.
const NODES: usize = 31;

/// Mean normal stress on slip surfaces over force per area, by friction angle; `None` where no mechanism is.
type Row = Vec<Option<f64>>;

/// What the geometry of a plate says of its stresses: rows by interface friction, found when they are first asked for, and shared by all copies.
#[derive(Debug, Clone)]
pub(crate) struct SlipStresses {
    plate: Plate,
    rows: Arc<[OnceLock<Row>]>,
}

/// They follow from the plate.
impl PartialEq for SlipStresses {
    fn eq(&self, other: &Self) -> bool {
        self.plate == other.plate
    }
}

impl SlipStresses {
    pub(crate) fn of(plate: Plate) -> Self {
        Self { plate, rows: (0..NODES).map(|_| OnceLock::new()).collect() }
    }

    /// Mean normal stress on slip surfaces over force per area.
    fn mean(&self, phi_deg: f64, delta_deg: f64) -> Option<f64> {
        let (row, beyond) = place(delta_deg);
        let (node, between) = place(phi_deg);
        let along = |row: usize| {
            let row = self.rows[row].get_or_init(|| self.row(row));
            let (here, next) = (row[node]?, row[(node + 1).min(NODES - 1)]);
            Some(here + (next.unwrap_or(here) - here) * between)
        };
        let here = along(row)?;
        if beyond == 0.0 {
            return Some(here);
        }
        let next = along((row + 1).min(NODES - 1))?;
        Some(here + (next - here) * beyond)
    }

    fn row(&self, row: usize) -> Row {
        let delta_deg = NODE_DEG * row as f64;
        let mean = |node: usize| {
            // The derivative by the friction angle needs some of it.
            let phi_deg = (NODE_DEG * node as f64).max(0.5 * NODE_DEG);
            let case = Case {
                tool_angle: self.plate.tool_angle(),
                surface_slope: self.plate.surface_slope(),
                width_ratio: self.plate.width_ratio(),
                friction: Angle::from_degrees(phi_deg),
                // No interface is rougher than the soil beside it.
                interface: Angle::from_degrees(delta_deg.min(phi_deg)),
            };
            let mean = mean_slip_stress_over_pressure(&case).ok()?;
            Some(mean * libm::cos(case.interface.radians())).filter(|mean| mean.is_finite() && *mean > 0.0)
        };
        (0..NODES).map(mean).collect()
    }
}

/// The node below an angle in degrees, and how far beyond it that is in steps.
fn place(deg: f64) -> (usize, f64) {
    let at = (deg / NODE_DEG).clamp(0.0, (NODES - 1) as f64);
    (at as usize, at.fract())
}

/// The normal stress on the slip surfaces of an observation.
#[derive(Debug, Clone)]
pub(crate) struct StressLevel {
    /// Force over area of the plate in Pa: least and greatest.
    pressure_pa: [f64; 2],
    /// Friction angles that the model reaches, in degrees.
    reach_deg: (f64, f64),
    stresses: SlipStresses,
}

impl StressLevel {
    /// Of an observation, for friction angles that a model reaches, in degrees.
    pub(crate) fn of(observation: &Observation, reach_deg: (f64, f64)) -> Self {
        let plate = observation.plate();
        let area = plate.slant_length_m() * plate.width_m();
        // A band may reach down to no force, a stress may not.
        let low_n = observation.low_n().max(0.01 * observation.force_n());
        let pressure_pa = [low_n / area, observation.high_n() / area];
        Self { pressure_pa, reach_deg, stresses: observation.slip_stresses().clone() }
    }

    /// The interval of the equivalent stress in Pa, if the soil had this friction; `None` where no mechanism is.
    pub(crate) fn stress_pa(&self, phi_deg: f64, delta_deg: f64) -> Option<[f64; 2]> {
        let mean = self.stresses.mean(phi_deg, delta_deg)?;
        Some([0, 1].map(|end| self.pressure_pa[end] * mean * EQUIVALENT_OVER_MEAN[end]))
    }

    /// How many decades its stress is from the reference at most, were it sand; `None` where no mechanism is.
    pub(crate) fn decades(&self, law: &FrictionLaw, delta_deg: f64) -> Option<f64> {
        const SAND_DEG: f64 = 38.0;
        let stress = self.stress_pa(SAND_DEG, delta_deg)?;
        Some(stress.map(|stress| law.decades(stress).abs()).into_iter().fold(0.0, f64::max))
    }

    /// Least and greatest friction angle in degrees of the stroke at a reference angle, as far as the model reaches.
    pub(crate) fn friction_deg(
        &self,
        law: &FrictionLaw,
        phi_ref_deg: f64,
        delta_deg: f64,
    ) -> Option<[f64; 2]> {
        // Stress falls a little as friction grows, by some 3 % a degree: at 20 deg a decade this still contracts by a factor of four.
        const STEPS: usize = 24;
        let mut found = [phi_ref_deg; 2];
        for (end, phi) in found.iter_mut().enumerate() {
            for _ in 0..STEPS {
                let stress = self.stress_pa(*phi, delta_deg)?;
                let next = law.friction_range_deg(phi_ref_deg, stress)[end];
                let done = (next - *phi).abs() < 1e-7;
                *phi = next;
                if done {
                    break;
                }
            }
        }
        Some(found.map(|phi| phi.clamp(self.reach_deg.0, self.reach_deg.1)))
    }
}

/// The interval of the equivalent normal stress in Pa on the slip surfaces of each measurement, in order, if the soil has friction
/// angles of an interval in degrees (at the reference stress, under a law); `None` where no mechanism is.
#[must_use]
pub fn slip_stress_pa(setup: &Setup<'_>, phi_deg: [f64; 2]) -> Vec<Option<[f64; 2]>> {
    let of = |observation: &Observation| {
        let level = setup.stress_level(observation);
        let mut hull: Option<[f64; 2]> = None;
        for phi in phi_deg {
            for delta in [setup.delta_deg.0, setup.delta_deg.1] {
                let frictions = match &setup.friction_law {
                    Some(law) => level.friction_deg(law, phi, delta)?,
                    None => [phi; 2],
                };
                for friction in frictions {
                    let [low, high] = level.stress_pa(friction, delta)?;
                    hull = Some(hull.map_or([low, high], |[l, h]| [l.min(low), h.max(high)]));
                }
            }
        }
        hull
    };
    setup.observations.iter().map(of).collect()
}
