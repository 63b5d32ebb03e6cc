//! Strength of clay that depends on the direction of the stress: an ellipse, as the certificate's documentation says.

use soilctl_certificate::Material;

/// The ellipse for a cohesion of one, in the plane of half the difference of the normal stresses (tension positive) and the shear stress.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ellipse {
    pub(crate) middle: f64,
    pub(crate) level: f64,
    pub(crate) shear: f64,
}

/// That of strength which is the same in all directions.
pub(crate) const ROUND: Ellipse = Ellipse { middle: 0.0, level: 1.0, shear: 1.0 };

impl Ellipse {
    pub(crate) fn of(m: &Material) -> Self {
        m.anisotropy.map_or(ROUND, |of| Self {
            middle: 0.5 * (1.0 - of.passive),
            level: 0.5 * (1.0 + of.passive),
            shear: of.shear,
        })
    }

    /// What a strain rate takes up for a cohesion of one, from `exx - eyy` and `2 exy`.
    pub(crate) fn rate(&self, difference: f64, shear: f64) -> f64 {
        self.middle * difference + (self.level * difference).hypot(self.shear * shear)
    }

    /// What slip along an edge takes up for a cohesion of one, the soil on the left moving forwards.
    pub(crate) fn along(&self, [x, y]: [f64; 2], slip: f64) -> f64 {
        let square = x * x + y * y;
        self.rate(-2.0 * x * y / square * slip, (x * x - y * y) / square * slip)
    }

    /// The same of a unit of slip forwards, and backwards.
    pub(crate) fn both_ways(&self, edge: [f64; 2]) -> [f64; 2] {
        // Exactly, which arithmetic would not show.
        if *self == ROUND { [1.0; 2] } else { [1.0, -1.0].map(|slip| self.along(edge, slip)) }
    }
}
