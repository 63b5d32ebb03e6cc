//! Friction that falls with the logarithm of stress: one unknown more, its slope.
//!
//! A stroke has the friction `phi_ref - slope log10(sigma / sigma_ref)`, where sigma is the equivalent normal stress on its slip
//! surfaces ([`soilctl_earth_pressure::mean_slip_stress_over_pressure`] times the pressure that was measured). Of sigma only an
//! interval is known, and the slope is cut into slices; so a stroke has an interval of friction angles at each reference angle of a slice, and
//! the band of the stroke reaches from the lower bound at the least angle to the upper bound at the greatest.

use soilctl_earth_pressure::{Case, EQUIVALENT_OVER_MEAN, mean_slip_stress_over_pressure};
use soilctl_soil::Angle;

use crate::{EstimatorError, Observation, Setup};

/// Slopes that are searched unless the user says otherwise, in degrees a decade of stress: sands have 3 to 6 (Hong 2001, table 6.13).
pub const SLOPE_SEARCH_DEG: (f64, f64) = (0.0, 8.0);
/// Most slope in degrees a decade.
pub const MAX_SLOPE_DEG: f64 = 20.0;
/// Widest slices in degrees a decade.
const WIDEST_SLICE_DEG: f64 = 1.0;
/// Narrowest ones: half a decade from the reference, friction angles are known to 0.06 deg in it.
const NARROWEST_SLICE_DEG: f64 = 0.25;
/// What a slice leaves open of the friction angle of a stroke, in degrees, where its width allows.
const OPEN_DEG: f64 = 0.12;
/// Reference stresses taken, in Pa: from a grain of dust to a rock's strength.
pub const REFERENCE_STRESS_PA: (f64, f64) = (1.0, 1e8);

/// Friction as a law of stress, `phi = phi_ref - slope log10(sigma / sigma_ref)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionLaw {
    /// The slope in degrees a decade, known to lie between these; at least 0.
    pub slope_deg_per_decade: (f64, f64),
    /// Normal stress in Pa at which the friction angle is `phi_ref`.
    pub reference_stress_pa: f64,
}

impl FrictionLaw {
    /// Decades of a stress in Pa above the reference.
    pub(crate) fn decades(&self, stress_pa: f64) -> f64 {
        libm::log10(stress_pa / self.reference_stress_pa)
    }

    /// The friction angle in degrees at a stress in Pa.
    #[must_use]
    pub fn friction_deg(&self, phi_ref_deg: f64, slope: f64, stress_pa: f64) -> f64 {
        phi_ref_deg - slope * self.decades(stress_pa)
    }

    /// Least and greatest friction angle at stresses of an interval, for the slopes of the law.
    #[must_use]
    pub fn friction_range_deg(&self, phi_ref_deg: f64, stress_pa: [f64; 2]) -> [f64; 2] {
        let (low, high) = self.slope_deg_per_decade;
        let at = |stress: f64| [low, high].map(|slope| self.friction_deg(phi_ref_deg, slope, stress));
        let (light, heavy) = (at(stress_pa[0]), at(stress_pa[1]));
        [heavy[0].min(heavy[1]), light[0].max(light[1])]
    }

    /// The law in slices whose slopes differ little, for stresses up to so many decades from the reference.
    pub(crate) fn slices(self, decades: f64) -> impl Iterator<Item = Self> {
        let (low, high) = self.slope_deg_per_decade;
        let width = (OPEN_DEG / decades).clamp(NARROWEST_SLICE_DEG, WIDEST_SLICE_DEG);
        let count = ((high - low) / width).ceil().max(1.0) as usize;
        let at = move |i: usize| low + (high - low) * i as f64 / count as f64;
        (0..count).map(move |i| Self { slope_deg_per_decade: (at(i), at(i + 1)), ..self })
    }

    pub(crate) fn check(&self) -> Result<(), EstimatorError> {
        let interval = |quantity, (low, high): (f64, f64), unit, allowed: (f64, f64)| {
            if low <= high && low >= allowed.0 && high <= allowed.1 {
                return Ok(());
            }
            let allowed = format!("an interval within {} to {} {unit}", allowed.0, allowed.1);
            Err(EstimatorError::BadInterval { quantity, low, high, unit, allowed })
        };
        let slope = self.slope_deg_per_decade;
        interval("the fall of friction with stress", slope, "deg/decade", (0.0, MAX_SLOPE_DEG))?;
        let stress = (self.reference_stress_pa, self.reference_stress_pa);
        interval("the reference stress", stress, "Pa", REFERENCE_STRESS_PA)
    }
}

/// What a test in direct shear says: at its normal stress the friction angle lies in an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShearBand {
    /// Normal stress in Pa.
    pub stress_pa: f64,
    /// Least and greatest friction angle in degrees.
    pub friction_deg: [f64; 2],
}

/// Step of the friction angle between nodes of a [`StressLevel`], in degrees: between them the logarithm of the stress is straight
/// to 0.0001.
const NODE_DEG: f64 = 1.0;

/// The normal stress on the slip surfaces of a stroke, by the friction that the soil may have.
#[derive(Debug, Clone)]
pub(crate) struct StressLevel {
    /// Force over area of the plate in Pa: least and greatest.
    pressure_pa: [f64; 2],
    /// Friction angles that the model reaches, in degrees.
    reach_deg: (f64, f64),
    /// Interface frictions of the nodes in degrees, growing.
    deltas_deg: Vec<f64>,
    /// Mean normal stress on slip surfaces over force per area, a row for each interface friction; `None` where no mechanism is.
    mean: Vec<Vec<Option<f64>>>,
}

impl StressLevel {
    /// Of an observation, for friction angles that a model reaches and an interval of interface friction, in degrees.
    pub(crate) fn of(observation: &Observation, reach_deg: (f64, f64), delta_deg: (f64, f64)) -> Self {
        let plate = observation.plate();
        let area = plate.slant_length_m() * plate.width_m();
        // A band may reach down to no force, a stress may not.
        let low_n = observation.low_n().max(0.01 * observation.force_n());
        let mut deltas_deg = vec![delta_deg.0, f64::midpoint(delta_deg.0, delta_deg.1), delta_deg.1];
        deltas_deg.dedup();
        let nodes = ((reach_deg.1 - reach_deg.0) / NODE_DEG).ceil() as usize;
        let mean_at = |phi_deg: f64, delta_deg: f64| {
            let case = Case {
                tool_angle: plate.tool_angle(),
                surface_slope: plate.surface_slope(),
                width_ratio: plate.width_ratio(),
                friction: Angle::from_degrees(phi_deg),
                interface: Angle::from_degrees(delta_deg.min(phi_deg)),
            };
            let mean = mean_slip_stress_over_pressure(&case).ok()?;
            Some(mean * libm::cos(case.interface.radians())).filter(|mean| mean.is_finite() && *mean > 0.0)
        };
        let row = |&delta: &f64| {
            (0..=nodes).map(|i| mean_at(reach_deg.0 + NODE_DEG * i as f64, delta)).collect::<Vec<_>>()
        };
        let mean = deltas_deg.iter().map(row).collect();
        Self { pressure_pa: [low_n / area, observation.high_n() / area], reach_deg, deltas_deg, mean }
    }

    /// The interval of the equivalent stress in Pa, if the soil had this friction; `None` where no mechanism is.
    pub(crate) fn stress_pa(&self, phi_deg: f64, delta_deg: f64) -> Option<[f64; 2]> {
        let mean = self.mean(phi_deg, delta_deg)?;
        Some([0, 1].map(|end| self.pressure_pa[end] * mean * EQUIVALENT_OVER_MEAN[end]))
    }

    fn mean(&self, phi_deg: f64, delta_deg: f64) -> Option<f64> {
        let (low, high) = self.reach_deg;
        let place = (phi_deg.clamp(low, high) - low) / NODE_DEG;
        let node = place.floor() as usize;
        let along = |row: &[Option<f64>]| {
            let here = (*row.get(node)?)?;
            let next = row.get(node + 1).copied().flatten().unwrap_or(here);
            Some(here + (next - here) * (place - node as f64))
        };
        let [first, .., last] = &self.deltas_deg[..] else { return along(self.mean.first()?) };
        let delta = delta_deg.clamp(*first, *last);
        let after = self.deltas_deg.iter().position(|&node| node >= delta)?.max(1);
        let (a, b) = (self.deltas_deg[after - 1], self.deltas_deg[after]);
        let (below, above) = (along(&self.mean[after - 1])?, along(&self.mean[after])?);
        Some(below + (above - below) * (delta - a) / (b - a))
    }

    /// How many decades its stress is from the reference at most, were it sand; `None` where no mechanism is.
    pub(crate) fn decades(&self, law: &FrictionLaw) -> Option<f64> {
        const SAND_DEG: f64 = 38.0;
        let stress = self.stress_pa(SAND_DEG, *self.deltas_deg.first()?)?;
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
