//! Masses and inertias of the links for the URDF. The inertias are those of plain bodies; only masses and centres of
//! mass come from the arm file.

use std::f64::consts::PI;

use crate::config::{Counterweight, Mass};

/// Density of the counterweights' tungsten alloy in kg/m3.
const TUNGSTEN_KG_M3: f64 = 17_600.0;

/// A body of revolution about the link's z axis.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Body {
    pub(crate) mass_kg: f64,
    /// Centre of mass along z, in m.
    pub(crate) centre_m: f64,
    /// Moment of inertia about an axis across z, through the centre, in kg m2.
    pub(crate) across: f64,
    /// About z.
    pub(crate) along: f64,
}

impl Body {
    /// A solid cylinder of the given length and radius whose centre of mass is where the arm file says.
    pub(crate) fn rod(mass: Mass, length_m: f64, radius_m: f64) -> Self {
        let (m, square) = (mass.mass_kg, radius_m * radius_m);
        Self {
            mass_kg: m,
            centre_m: mass.com_m,
            across: m * (3.0 * square + length_m * length_m) / 12.0,
            along: 0.5 * m * square,
        }
    }

    /// A ball of tungsten.
    pub(crate) fn counterweight(weight: Counterweight) -> Self {
        let radius = counterweight_radius_m(weight);
        let inertia = 0.4 * weight.mass_kg * radius * radius;
        Self { mass_kg: weight.mass_kg, centre_m: -weight.behind_m, across: inertia, along: inertia }
    }

    /// Both bodies as one rigid body.
    pub(crate) fn and(self, other: Self) -> Self {
        let mass_kg = self.mass_kg + other.mass_kg;
        let centre_m = (self.mass_kg * self.centre_m + other.mass_kg * other.centre_m) / mass_kg;
        let about =
            |body: Self| body.across + body.mass_kg * (body.centre_m - centre_m) * (body.centre_m - centre_m);
        Self { mass_kg, centre_m, across: about(self) + about(other), along: self.along + other.along }
    }
}

/// Radius of the ball that stands for a counterweight.
pub(crate) fn counterweight_radius_m(weight: Counterweight) -> f64 {
    libm::cbrt(weight.mass_kg / TUNGSTEN_KG_M3 * 0.75 / PI)
}
