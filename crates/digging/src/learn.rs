//! What a stroke teaches of the soil.

use soilctl_earth_pressure::ForceModel;
use soilctl_estimator::{Observation, Setup, estimate};
use soilctl_process::{Channels, FailureSettings, Outcome, Trace, failure_force};
use soilctl_soil::{Angle, Plate};

use crate::{DiggingError, Dug, Soils};

/// Deviations of a failure force that its interval holds.
const DEVIATIONS: f64 = 3.0;
/// By how much the depth may be off, in m: free play, and the coarse step of an external encoder.
const DEPTH_M: f64 = 0.0007;
/// By how much a force may be off beside that, as a part: gain of the sensor, a density that scatters.
const FORCE_REL: f64 = 0.04;
/// Way over the depth up to which a stroke is looked at: loose soil has failed at a quarter of it.
const EARLY: f64 = 0.6;
/// A heap of so many depths loads the soil ahead: the stroke teaches nothing then.
const LEVEL: f64 = 0.05;

/// What is known before the first stroke, and what strokes have said since.
pub struct Knowledge<'m> {
    model: &'m dyn ForceModel,
    before: Soils,
    observations: Vec<Observation>,
    now: Soils,
}

impl<'m> Knowledge<'m> {
    /// What is known beforehand.
    #[must_use]
    pub fn new(model: &'m dyn ForceModel, before: Soils) -> Self {
        Self { model, now: before.clone(), before, observations: Vec::new() }
    }

    /// The soils that are still consistent.
    #[must_use]
    pub const fn soils(&self) -> &Soils {
        &self.now
    }

    /// Strokes that have taught something.
    #[must_use]
    pub fn strokes(&self) -> usize {
        self.observations.len()
    }

    /// Takes in a stroke that was made at a tool angle (deg) with a plate of a width (m), with a heap (m) ahead where it began. Says whether it
    /// taught anything: a stroke whose failure cannot be told does not, nor one into a heap, nor one that contradicts the others.
    ///
    /// # Errors
    /// [`DiggingError::Process`] or [`DiggingError::Estimator`] for a trace or measurement that is none.
    pub fn take(
        &mut self,
        dug: &Dug,
        tool_angle_deg: f64,
        heap_m: f64,
        width_m: f64,
    ) -> Result<Taught, DiggingError> {
        let [phi, density] = self.before.ranges();
        if phi[0] >= phi[1] || density[0] >= density[1] {
            return Ok(Taught::Known);
        }
        let range = self.model.valid_range().alpha_deg;
        if tool_angle_deg < range.0 || tool_angle_deg > range.1 {
            return Ok(Taught::OutsideModel);
        }
        let Some(first) = dug.samples.first() else { return Ok(Taught::NoFailure) };
        let depth_m = dug.surface_z_m - first.z_m;
        if depth_m <= DEPTH_M {
            return Ok(Taught::NoFailure);
        }
        if heap_m > LEVEL * depth_m {
            return Ok(Taught::Heap);
        }
        // Further on the plate pushes a heap, and sinks.
        let early = dug.samples.iter().take_while(|sample| sample.travel_m <= EARLY * depth_m);
        let early: Vec<_> = early.collect();
        let of = |value: fn(&crate::Sample) -> f64| early.iter().map(|s| value(s)).collect::<Vec<f64>>();
        let trace = Trace::new(of(|s| s.time_s), of(|s| s.travel_m), of(|s| s.force_n), Channels::default());
        let Ok(trace) = trace else { return Ok(Taught::NoFailure) };
        let analysis = failure_force(&trace, &FailureSettings::for_depth(depth_m)?);
        let Outcome::Found(point) = analysis.outcome else { return Ok(Taught::NoFailure) };
        let plate = Plate::new(Angle::from_degrees(tool_angle_deg), Angle::ZERO, depth_m, width_m)?;
        let half_n = DEVIATIONS * point.sd_n + point.force_n * (2.0 * DEPTH_M / depth_m + FORCE_REL);
        let label = format!("stroke {}", self.observations.len() + 1);
        let observation = Observation::new(label, plate, point.force_n, half_n)?;
        self.observations.push(observation);
        let delta = self.before.delta_deg();
        let mut setup = Setup::new(self.model, self.observations.clone(), (delta[0], delta[1]))
            .with_density(density[0], density[1]);
        setup.phi_search_deg = Some((phi[0], phi[1]));
        setup.gravity_m_s2 = self.before.gravity_m_s2();
        let region = estimate(&setup)?.region;
        match Soils::of_region(&region, delta, setup.gravity_m_s2)? {
            Some(soils) => {
                self.now = soils;
                Ok(Taught::Region { force_n: point.force_n, half_n })
            }
            None => {
                self.observations.pop();
                Ok(Taught::Contradicts { force_n: point.force_n, half_n })
            }
        }
    }
}

/// What became of a stroke's measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Taught {
    /// It narrowed the region, or confirmed it.
    Region {
        /// Failure force in N.
        force_n: f64,
        /// Half width of its interval in N.
        half_n: f64,
    },
    /// No soil of what was known explains it together with the others; it was left out.
    Contradicts {
        /// Failure force in N.
        force_n: f64,
        /// Half width of its interval in N.
        half_n: f64,
    },
    /// Friction angle or density were known exactly, so that there was nothing to narrow.
    Known,
    /// Its failure cannot be told.
    NoFailure,
    /// It was made into a heap.
    Heap,
    /// Its tool angle is none of the force model.
    OutsideModel,
}
