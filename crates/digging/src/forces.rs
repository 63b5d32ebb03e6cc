//! Which forces of the plate fail the soil, by their inclination to the plate's normal (Hong 2001, section 5.3.3 and figure 5-13).
//!
//! A force whose inclination is within the friction on the plate moves the plate and the soil at it as one. What soil bears then does not
//! depend on the plate's friction: it is what it would bear of a plate whose friction is that inclination (`K(phi, delta = inclination)`).
//!
//! - *Bears for certain*: a stress field for a plate of friction `i` is one for every rougher plate, so that a proven lower bound at
//!   `delta = i` is one at the inclination `i`.
//! - *Fails for certain*: an upper bound whose mechanism moves a rigid triangle at the plate (Chen and Liu's) holds at the inclination `i`, since
//!   the plate may move with that triangle. The upper bound of a table, whose soil slips on the plate, holds at full friction only.
//!
//! A force that points up along the plate steeper than the friction makes it slip out. One that points further down makes it dive, unless the
//! soil below its edge holds it; then no more is borne than by a perfectly rough plate (`delta = phi`).

use soilctl_earth_pressure::{Case, ChenLiu, ForceModel};
use soilctl_soil::{Angle, Plate};

use crate::{DiggingError, Soils};

/// What becomes of a plate that is pushed with an inclination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// It sticks to the soil in all soils.
    Sticks,
    /// It sticks or slips, by how rough it is within what is known.
    Open,
    /// It slips up along the soil.
    SlipsUp,
    /// It goes down, unless the soil below its edge holds it.
    Dives,
}

/// What soil bears of forces of one inclination, over all soils.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Borne {
    /// Inclination of the plate's force to its normal in deg, positive downwards.
    pub inclination_deg: f64,
    /// What becomes of the plate.
    pub contact: Contact,
    /// Force in N that every soil bears; `None` where nothing is proven.
    pub bears_n: Option<f64>,
    /// Force in N that fails every soil; `None` beyond what any plate transmits.
    pub fails_n: Option<f64>,
}

/// A plate's tool angle, depth and load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bite {
    /// Tool angle in deg.
    pub tool_angle_deg: f64,
    /// Depth of the lower edge below the surface in m.
    pub depth_m: f64,
    /// Mean height of the heap ahead above that surface in m.
    pub heap_m: f64,
    /// Width of the plate in m.
    pub width_m: f64,
}

/// What all soils bear of a force at an inclination (deg).
///
/// # Errors
/// [`DiggingError::Soil`] for a plate that is none, [`DiggingError::Model`] for angles that Chen and Liu's model does not cover. Where `model`
/// does not cover them nothing is borne for certain.
pub fn borne(
    model: &dyn ForceModel,
    soils: &Soils,
    bite: &Bite,
    inclination_deg: f64,
) -> Result<Borne, DiggingError> {
    let [delta_low, delta_high] = soils.delta_deg();
    let size = inclination_deg.abs();
    let contact = if size <= delta_low {
        Contact::Sticks
    } else if size <= delta_high {
        Contact::Open
    } else if inclination_deg < 0.0 {
        Contact::SlipsUp
    } else {
        Contact::Dives
    };
    let least_phi = soils.ranges()[0][0];
    let fails_n = match contact {
        // A plate that slips out leaves the soil as it is, and bears nothing.
        Contact::SlipsUp => None,
        Contact::Sticks | Contact::Open | Contact::Dives if size > least_phi => None,
        Contact::Sticks | Contact::Open | Contact::Dives => {
            Some(fails_n(model, soils, bite, inclination_deg)?)
        }
    };
    let bears_n = match contact {
        Contact::Sticks if inclination_deg >= 0.0 => bears_n(model, soils, bite, inclination_deg)?,
        Contact::Sticks | Contact::Open | Contact::SlipsUp | Contact::Dives => None,
    };
    Ok(Borne { inclination_deg, contact, bears_n, fails_n })
}

/// The force in N with which the plate slips on the soil while it fails, at full friction: at least and at most, over all soils. This is what
/// a plate takes that keeps its depth.
///
/// # Errors
/// As [`borne`].
pub fn sliding_n(
    model: &dyn ForceModel,
    soils: &Soils,
    bite: &Bite,
) -> Result<(Option<f64>, f64), DiggingError> {
    let [low, high] = soils.delta_deg();
    Ok((bears_n(model, soils, bite, low)?, fails_n(model, soils, bite, high)?))
}

/// Greatest force in N that all soils bear for certain: the least of the weakest ones. The heap is left out, since it may have run off.
fn bears_n(
    model: &dyn ForceModel,
    soils: &Soils,
    bite: &Bite,
    inclination_deg: f64,
) -> Result<Option<f64>, DiggingError> {
    let Some(tool_angle_deg) = covered_deg(model, bite) else { return Ok(None) };
    let scale = scale_n(soils, bite)?;
    let mut least = f64::INFINITY;
    for (case, density) in soils.corners(false, tool_angle_deg, inclination_deg) {
        least = least.min(density * scale * model.predict(&case)?.net_lower.0);
    }
    Ok(least.is_finite().then_some(least))
}

/// Least force in N that fails all soils: the greatest of the strongest ones.
fn fails_n(
    model: &dyn ForceModel,
    soils: &Soils,
    bite: &Bite,
    inclination_deg: f64,
) -> Result<f64, DiggingError> {
    let range = model.valid_range();
    let scale = scale_n(soils, bite)?;
    let slant_m = bite.depth_m / libm::sin(bite.tool_angle_deg.to_radians());
    let mut most = 0.0_f64;
    for (case, density) in soils.corners(true, bite.tool_angle_deg, inclination_deg) {
        let ahead = ChenLiu::sticking(&case)?;
        let mut weight = ahead.weight;
        if inclination_deg >= 0.0 {
            // The soil behind pushes along.
            weight = ChenLiu.predict(&case)?.net.weight;
            let phi_deg = case.friction.degrees();
            let covers = inclination_deg <= range.delta_deg.1
                && phi_deg >= range.phi_deg.0
                && phi_deg <= range.phi_deg.1;
            if let Some(deg) = covered_deg(model, bite).filter(|_| covers) {
                let case = Case { tool_angle: Angle::from_degrees(deg), ..case };
                weight = weight.max(model.predict(&case)?.net_upper.0);
            }
        }
        let heap = density * soils.gravity_m_s2() * bite.heap_m * slant_m * bite.width_m * ahead.surcharge;
        most = most.max(density * scale * weight + heap);
    }
    Ok(most)
}

/// The tool angle in deg, if the model covers it; what is off by rounding counts as its end.
fn covered_deg(model: &dyn ForceModel, bite: &Bite) -> Option<f64> {
    let (low, high) = model.valid_range().alpha_deg;
    let deg = bite.tool_angle_deg.max(low).min(high);
    ((deg - bite.tool_angle_deg).abs() < 1e-6).then_some(deg)
}

/// `1/2 g L^2 w`: a force in N by density and coefficient.
fn scale_n(soils: &Soils, bite: &Bite) -> Result<f64, DiggingError> {
    let plate =
        Plate::new(Angle::from_degrees(bite.tool_angle_deg), Angle::ZERO, bite.depth_m, bite.width_m)?;
    Ok(0.5 * soils.gravity_m_s2() * plate.slant_length_m().powi(2) * plate.width_m())
}
