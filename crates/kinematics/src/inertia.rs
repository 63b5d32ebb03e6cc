//! Masses and inertias of the links. The inertias are those of plain bodies; only masses and centres of mass come from
//! the arm file.

use std::f64::consts::PI;

use crate::Arm;
use crate::config::{Counterweight, Mass};

/// Half the thickness of the links, in m; not in the thesis.
pub(crate) const COLUMN_RADIUS_M: f64 = 0.05;
pub(crate) const LINK_RADIUS_M: f64 = 0.025;
pub(crate) const HAND_RADIUS_M: f64 = 0.015;

/// Density of the counterweights' tungsten alloy in kg/m3.
const TUNGSTEN_KG_M3: f64 = 17_600.0;

/// A link with its counterweight, as a body of revolution about the link's z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkBody {
    /// Mass in kg.
    pub mass_kg: f64,
    /// Centre of mass along z from the link's inner joint (column: from the table), in m.
    pub centre_m: f64,
    /// Moment of inertia about an axis across z, through the centre, in kg m2.
    pub across_kg_m2: f64,
    /// Moment of inertia about z in kg m2.
    pub along_kg_m2: f64,
}

impl Arm {
    /// The five moving links from the base outwards, counterweights included: column, upper arm, forearm, twist, hand.
    ///
    /// Masses and centres are those of the arm file; the inertias are those of solid rods of the links' lengths and of
    /// tungsten balls, since the thesis prints none. The URDF holds the same numbers.
    #[must_use]
    pub fn link_bodies(&self) -> [LinkBody; 5] {
        let config = self.config();
        let (lengths, masses, weights) = (&config.links, &config.masses, &config.counterweights);
        [
            LinkBody::rod(masses.base, lengths.base_height_m, COLUMN_RADIUS_M),
            LinkBody::rod(masses.upper_arm, lengths.upper_arm_m, LINK_RADIUS_M)
                .and(LinkBody::counterweight(weights.shoulder)),
            LinkBody::rod(masses.forearm, lengths.forearm_m, LINK_RADIUS_M)
                .and(LinkBody::counterweight(weights.elbow)),
            LinkBody::rod(masses.twist, lengths.twist_m + 2.0 * LINK_RADIUS_M, LINK_RADIUS_M),
            LinkBody::rod(masses.hand, lengths.hand_m, HAND_RADIUS_M),
        ]
    }
}

impl LinkBody {
    /// A solid cylinder of the given length and radius whose centre of mass is where the arm file says.
    pub(crate) fn rod(mass: Mass, length_m: f64, radius_m: f64) -> Self {
        let (m, square) = (mass.mass_kg, radius_m * radius_m);
        Self {
            mass_kg: m,
            centre_m: mass.com_m,
            across_kg_m2: m * (3.0 * square + length_m * length_m) / 12.0,
            along_kg_m2: 0.5 * m * square,
        }
    }

    /// A ball of tungsten.
    pub(crate) fn counterweight(weight: Counterweight) -> Self {
        let radius = counterweight_radius_m(weight);
        let inertia = 0.4 * weight.mass_kg * radius * radius;
        Self {
            mass_kg: weight.mass_kg,
            centre_m: -weight.behind_m,
            across_kg_m2: inertia,
            along_kg_m2: inertia,
        }
    }

    /// Both bodies as one rigid body.
    pub(crate) fn and(self, other: Self) -> Self {
        let mass_kg = self.mass_kg + other.mass_kg;
        let centre_m = (self.mass_kg * self.centre_m + other.mass_kg * other.centre_m) / mass_kg;
        let about = |body: Self| {
            body.across_kg_m2 + body.mass_kg * (body.centre_m - centre_m) * (body.centre_m - centre_m)
        };
        Self {
            mass_kg,
            centre_m,
            across_kg_m2: about(self) + about(other),
            along_kg_m2: self.along_kg_m2 + other.along_kg_m2,
        }
    }
}

/// Radius of the ball that stands for a counterweight.
pub(crate) fn counterweight_radius_m(weight: Counterweight) -> f64 {
    libm::cbrt(weight.mass_kg / TUNGSTEN_KG_M3 * 0.75 / PI)
}
