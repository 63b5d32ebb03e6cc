use soilctl_earth_pressure::{Case, ForceModel, Loads, check_loads};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2, WidthRatio};

use crate::joint::Unknowns;
use crate::law::{FrictionLaw, ShearBand};
use crate::stress_level::StressLevel;
use crate::{EstimatorError, Observation};

/// Friction angles searched unless the model covers less or the user asks for less, in degrees.
pub const PHI_SEARCH_DEG: (f64, f64) = (5.0, 60.0);
/// Bulk densities searched where nothing is known, in kg/m3: anything that can be called soil.
pub const DENSITY_SEARCH_KG_M3: (f64, f64) = (100.0, 5000.0);
/// Most measurements taken.
pub const MAX_OBSERVATIONS: usize = 4096;

/// Everything an estimate starts from.
#[derive(Clone)]
pub struct Setup<'m> {
    /// The model that links soil and force.
    pub model: &'m dyn ForceModel,
    /// The measurements.
    pub observations: Vec<Observation>,
    /// Interface friction, known to lie between these degrees.
    pub delta_deg: (f64, f64),
    /// Bulk density, known to lie between these kg/m3; `None` if nothing is known.
    pub density_kg_m3: Option<(f64, f64)>,
    /// Friction angles to search in degrees; `None` for [`PHI_SEARCH_DEG`].
    pub phi_search_deg: Option<(f64, f64)>,
    /// Gravity in m/s2.
    pub gravity_m_s2: f64,
    /// Known cohesion, adhesion and surcharge.
    pub loads: Loads,
    /// Cohesion, adhesion, surcharge and slope of the surface that are not all known, in place of [`Setup::loads`] and of the slopes of the plates; `None` if they
    /// are known.
    pub unknowns: Option<Unknowns>,
    /// By how much the end factor of a stroke may differ from one that all share, 0 to 1; 1 if they share nothing. The end
    /// factor is the part of what ends add at most, by a bracket that knows of them, which the ends of a plate do add.
    pub end_tolerance: f64,
    /// Friction as a law of stress; `None` if the soil has one friction angle at all stresses. With a law, phi is the friction angle at its
    /// reference stress.
    pub friction_law: Option<FrictionLaw>,
    /// What tests in direct shear say of the same soil; only with a law.
    pub shear_tests: Vec<ShearBand>,
}

impl<'m> Setup<'m> {
    /// A setup under standard gravity, cohesionless, density unknown; strokes share nothing of their ends.
    #[must_use]
    pub fn new(model: &'m dyn ForceModel, observations: Vec<Observation>, delta_deg: (f64, f64)) -> Self {
        Self {
            model,
            observations,
            delta_deg,
            density_kg_m3: None,
            phi_search_deg: None,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
            loads: Loads::default(),
            unknowns: None,
            end_tolerance: 1.0,
            friction_law: None,
            shear_tests: Vec::new(),
        }
    }

    /// The same with a known density.
    #[must_use]
    pub fn with_density(mut self, low_kg_m3: f64, high_kg_m3: f64) -> Self {
        self.density_kg_m3 = Some((low_kg_m3, high_kg_m3));
        self
    }

    /// The same with other observations.
    #[must_use]
    pub(crate) fn with_observations(&self, observations: Vec<Observation>) -> Self {
        Self { observations, ..self.clone() }
    }

    /// Friction angles that are searched: what was asked for, as far as the model reaches.
    #[must_use]
    pub fn phi_range_deg(&self) -> (f64, f64) {
        let (asked, model) =
            (self.phi_search_deg.unwrap_or(PHI_SEARCH_DEG), self.model.valid_range().phi_deg);
        (asked.0.max(model.0), asked.1.min(model.1))
    }

    /// Densities that are searched.
    #[must_use]
    pub fn density_range_kg_m3(&self) -> (f64, f64) {
        self.density_kg_m3.unwrap_or(DENSITY_SEARCH_KG_M3)
    }

    /// The stress on the slip surfaces of a measurement.
    pub(crate) fn stress_level(&self, observation: &Observation) -> StressLevel {
        StressLevel::of(observation, self.model.valid_range().phi_deg)
    }

    /// Whether strokes share something of their end factors.
    pub(crate) fn shares_ends(&self) -> bool {
        self.model.bounds_ends() && self.end_tolerance < 1.0
    }

    /// Width over depth as the model sees it: plane strain for a model without ends.
    #[must_use]
    pub fn width_ratio(&self, plate: &Plate) -> WidthRatio {
        if self.model.has_ends() { plate.width_ratio() } else { WidthRatio::PLANE_STRAIN }
    }

    /// Refuses unknown loads and slopes, for tasks that do not know them.
    pub(crate) fn check_known_loads(&self, task: &'static str) -> Result<(), EstimatorError> {
        match self.unknowns {
            Some(_) => Err(EstimatorError::KnownLoadsOnly { task }),
            None => Ok(()),
        }
    }

    /// Refuses a law of stress, for tasks that do not know one.
    pub(crate) fn check_one_friction(&self, task: &'static str) -> Result<(), EstimatorError> {
        match self.friction_law {
            Some(_) => Err(EstimatorError::OneFrictionOnly { task }),
            None => Ok(()),
        }
    }

    /// Refuses what cannot be estimated from.
    pub(crate) fn check(&self) -> Result<(), EstimatorError> {
        if self.observations.is_empty() {
            return Err(EstimatorError::NoMeasurement);
        }
        if self.model.is_slow() {
            return Err(EstimatorError::SlowModel { model: self.model.id() });
        }
        if self.observations.len() > MAX_OBSERVATIONS {
            return Err(EstimatorError::TooManyMeasurements {
                count: self.observations.len(),
                limit: MAX_OBSERVATIONS,
            });
        }
        let range = self.model.valid_range();
        let phi = self.phi_range_deg();
        let delta_limit = range.delta_deg.1.min(phi.1);
        interval("delta", self.delta_deg, "deg", (range.delta_deg.0, delta_limit), self.model.id())?;
        interval("phi", phi, "deg", range.phi_deg, self.model.id())?;
        if let Some(density) = self.density_kg_m3 {
            interval("density", density, "kg/m3", DENSITY_SEARCH_KG_M3, "the estimator")?;
        }
        if !(self.gravity_m_s2 > 0.0 && self.gravity_m_s2.is_finite()) {
            interval(
                "gravity",
                (self.gravity_m_s2, self.gravity_m_s2),
                "m/s2",
                (1e-6, 1e3),
                "the estimator",
            )?;
        }
        if let Some(law) = &self.friction_law {
            law.check()?;
        }
        let tolerance = (self.end_tolerance, self.end_tolerance);
        interval("the tolerance of the end factor", tolerance, "", (0.0, 1.0), "the estimator")?;
        for load in [self.loads.cohesion_pa, self.loads.adhesion_pa, self.loads.surcharge_pa] {
            interval("a load", (load, load), "Pa", (0.0, 1e9), "the estimator")?;
        }
        if let Some(unknowns) = &self.unknowns {
            return unknowns.check(self);
        }
        for observation in &self.observations {
            let plate = observation.plate();
            let case = Case {
                tool_angle: plate.tool_angle(),
                surface_slope: plate.surface_slope(),
                width_ratio: self.width_ratio(plate),
                friction: Angle::from_degrees(phi.1),
                interface: Angle::from_degrees(self.delta_deg.0),
            };
            check_loads(self.model, &case, &self.loads)?;
        }
        Ok(())
    }
}

fn interval(
    quantity: &'static str,
    (low, high): (f64, f64),
    unit: &'static str,
    allowed: (f64, f64),
    whose: &str,
) -> Result<(), EstimatorError> {
    // A billionth of slack survives unit conversions.
    let slack = 1e-9 * (1.0 + allowed.1.abs());
    if low <= high && low >= allowed.0 - slack && high <= allowed.1 + slack {
        return Ok(());
    }
    let allowed = format!("an interval within {} to {} {unit} ({whose})", allowed.0, allowed.1);
    Err(EstimatorError::BadInterval { quantity, low, high, unit, allowed })
}
