//! What a field soil may have beside friction and density, known within intervals.

use soilctl_earth_pressure::{Case, Loads, check_loads};
use soilctl_soil::Angle;

use crate::{EstimatorError, Setup};

/// Most measurements of an estimate with such unknowns.
pub(super) const MOST_MEASUREMENTS: usize = 256;
/// Loads taken, in Pa: to the strength of rock.
const LOADS_PA: (f64, f64) = (0.0, 1e9);
/// Adhesion over cohesion: no interface is stickier than the soil beside it.
const SHARES: (f64, f64) = (0.0, 1.0);

/// Cohesion, adhesion, surcharge and the slope of the surface, each known to lie between two values; the same value twice where it is known. All strokes
/// share them, as they share friction and density.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unknowns {
    /// Cohesion in Pa, at least 0.
    pub cohesion_pa: (f64, f64),
    /// Adhesion between soil and plate.
    pub adhesion: Adhesion,
    /// Vertical pressure on the surface in Pa, at least 0.
    pub surcharge_pa: (f64, f64),
    /// Slope of the surface in degrees, positive where it rises ahead of the plate.
    pub slope_deg: (f64, f64),
}

/// What is known of the adhesion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Adhesion {
    /// It lies between these, in Pa.
    Pa((f64, f64)),
    /// It is a part of the cohesion that lies between these, 0 to 1.
    ShareOfCohesion((f64, f64)),
}

/// A quantity that an estimate may not know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Friction angle in degrees.
    Friction,
    /// Interface friction in degrees.
    InterfaceFriction,
    /// Slope of the surface in degrees.
    Slope,
    /// Bulk density in kg/m3.
    Density,
    /// Cohesion in Pa.
    Cohesion,
    /// Adhesion in Pa.
    Adhesion,
    /// Surcharge in Pa.
    Surcharge,
}

impl Quantity {
    /// Those that forces depend on in a straight line, by their place among them; the others are angles.
    pub(super) const LINEAR: [Self; 4] = [Self::Density, Self::Cohesion, Self::Adhesion, Self::Surcharge];
    /// The angles, by their place among them.
    pub(super) const ANGLES: [Self; 3] = [Self::Friction, Self::InterfaceFriction, Self::Slope];
}

impl Unknowns {
    /// Nothing but what is known: these loads and this slope.
    #[must_use]
    pub fn known(loads: &Loads, slope_deg: f64) -> Self {
        Self {
            cohesion_pa: (loads.cohesion_pa, loads.cohesion_pa),
            adhesion: Adhesion::Pa((loads.adhesion_pa, loads.adhesion_pa)),
            surcharge_pa: (loads.surcharge_pa, loads.surcharge_pa),
            slope_deg: (slope_deg, slope_deg),
        }
    }

    /// Least and greatest adhesion in Pa.
    #[must_use]
    pub fn adhesion_pa(&self) -> (f64, f64) {
        match self.adhesion {
            Adhesion::Pa(interval) => interval,
            Adhesion::ShareOfCohesion((low, high)) => (low * self.cohesion_pa.0, high * self.cohesion_pa.1),
        }
    }

    /// What is known of a quantity, by an estimate that starts from a setup.
    #[must_use]
    pub fn interval(&self, setup: &Setup<'_>, quantity: Quantity) -> (f64, f64) {
        match quantity {
            Quantity::Friction => setup.phi_range_deg(),
            Quantity::InterfaceFriction => setup.delta_deg,
            Quantity::Slope => self.slope_deg,
            Quantity::Density => setup.density_range_kg_m3(),
            Quantity::Cohesion => self.cohesion_pa,
            Quantity::Adhesion => self.adhesion_pa(),
            Quantity::Surcharge => self.surcharge_pa,
        }
    }

    /// The quantities that are not known, angles first.
    #[must_use]
    pub fn unknown(&self, setup: &Setup<'_>) -> Vec<Quantity> {
        let all = Quantity::ANGLES.into_iter().chain(Quantity::LINEAR);
        all.filter(|quantity| {
            let (low, high) = self.interval(setup, *quantity);
            low < high || matches!(quantity, Quantity::Friction | Quantity::Density)
        })
        .collect()
    }

    /// The same with one quantity known; friction and density are known to the setup.
    #[must_use]
    pub fn with_known(mut self, quantity: Quantity, value: f64) -> Self {
        let known = (value, value);
        match quantity {
            Quantity::Slope => self.slope_deg = known,
            Quantity::Cohesion => self.cohesion_pa = known,
            Quantity::Adhesion => self.adhesion = Adhesion::Pa(known),
            Quantity::Surcharge => self.surcharge_pa = known,
            Quantity::Friction | Quantity::InterfaceFriction | Quantity::Density => {}
        }
        self
    }

    /// Refuses what is no knowledge, or what the model does not cover.
    pub(crate) fn check(&self, setup: &Setup<'_>) -> Result<(), EstimatorError> {
        interval("the cohesion", self.cohesion_pa, "Pa", LOADS_PA)?;
        interval("the surcharge", self.surcharge_pa, "Pa", LOADS_PA)?;
        match self.adhesion {
            Adhesion::Pa(known) => interval("the adhesion", known, "Pa", LOADS_PA)?,
            Adhesion::ShareOfCohesion(known) => {
                interval("the share of the adhesion", known, "of the cohesion", SHARES)?;
            }
        }
        interval("the slope of the surface", self.slope_deg, "deg", (-90.0, 90.0))?;
        let steepest = self.slope_deg.0.abs().max(self.slope_deg.1.abs());
        let (least_deg, greatest_deg) = setup.phi_range_deg();
        if steepest >= least_deg {
            return Err(EstimatorError::SteepSurface { steepest_deg: steepest, least_deg });
        }
        if setup.friction_law.is_some() {
            return Err(EstimatorError::KnownLoadsOnly { task: "a law of stress" });
        }
        if setup.observations.len() > MOST_MEASUREMENTS {
            let (count, limit) = (setup.observations.len(), MOST_MEASUREMENTS);
            return Err(EstimatorError::TooManyMeasurements { count, limit });
        }
        let loads = Loads {
            cohesion_pa: self.cohesion_pa.1,
            adhesion_pa: self.adhesion_pa().1,
            surcharge_pa: self.surcharge_pa.1,
        };
        for observation in &setup.observations {
            let plate = observation.plate();
            for slope in [self.slope_deg.0, self.slope_deg.1] {
                let case = Case {
                    tool_angle: plate.tool_angle(),
                    surface_slope: Angle::from_degrees(slope),
                    width_ratio: setup.width_ratio(plate),
                    friction: Angle::from_degrees(greatest_deg),
                    interface: Angle::from_degrees(setup.delta_deg.0),
                };
                check_loads(setup.model, &case, &loads)?;
                setup.model.at(case.tool_angle, case.surface_slope, case.width_ratio)?;
            }
        }
        Ok(())
    }
}

fn interval(
    quantity: &'static str,
    (low, high): (f64, f64),
    unit: &'static str,
    (least, most): (f64, f64),
) -> Result<(), EstimatorError> {
    if low <= high && low >= least && high <= most {
        return Ok(());
    }
    let allowed = format!("an interval within {least} to {most} {unit}");
    Err(EstimatorError::BadInterval { quantity, low, high, unit, allowed })
}
