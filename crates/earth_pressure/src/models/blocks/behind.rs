//! The soil behind the plate, which slides down after it: Coulomb's wedge, less what its two ends lose.
//!
//! What moves may touch soil that stands still only where it separates from it at phi or more. So a point moves with
//! the wedge if all directions within phi of the velocity lead from there to the plate. At the distance t behind the
//! plate's plane that leaves the width `w - 2 kappa t`, `kappa = sin(phi) / sqrt(cos(eta)^2 - sin(phi)^2)`, eta being the
//! angle between velocity and the plate's normal.

use crate::minimise::minimise;
use crate::{Case, LoadFactors};

/// Points of the first scan over the rise of the slip plane.
const SCAN: usize = 48;

/// A wedge that slides down behind a plate of slant length 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    /// How much its velocity points down.
    pub(super) sinking: f64,
    pub(super) speed: f64,
    /// Length along the surface, and distance of its far corner from the plate's plane.
    pub(super) surface: f64,
    pub(super) height: f64,
    /// What the width shrinks by over that distance, over the plate's width.
    pub(super) narrowing: f64,
    /// The distance at which it ends: at the far corner, or where both ends meet.
    pub(super) end: f64,
    cos_eta: f64,
}

/// The wedge that pushes hardest; none where the soil behind stands by itself.
pub(super) fn hardest(case: &Case) -> Option<Wedge> {
    let phi = case.friction.radians();
    let weight = |rise: f64| Wedge::new(case, rise).map_or(f64::NAN, |found| -found.factors(case).weight);
    let (rise, least) = minimise(phi, std::f64::consts::FRAC_PI_2 + phi, SCAN, weight)?;
    if least < 0.0 { Wedge::new(case, rise) } else { None }
}

/// Active factors on that wedge.
pub(super) fn active(case: &Case) -> LoadFactors {
    hardest(case).map_or(LoadFactors::default(), |wedge| wedge.factors(case))
}

impl Wedge {
    /// The wedge above a plane that rises at this angle backwards from the tip.
    fn new(case: &Case, rise: f64) -> Option<Self> {
        let (alpha, beta) = (case.tool_angle.radians(), case.surface_slope.radians());
        let (phi, delta) = (case.friction.radians(), case.interface.radians());
        let sinking = rise - phi;
        // The triangle has the angles alpha - rise at the tip and 180 deg - alpha - beta at the plate's top.
        let surface = libm::sin(alpha - rise) / libm::sin(rise + beta);
        let height = surface * libm::sin(alpha + beta);
        let power = libm::sin(alpha + delta - sinking);
        let cos_eta = libm::sin(alpha - sinking);
        let sin_phi = libm::sin(phi);
        if surface.is_nan() || surface <= 0.0 || height <= 0.0 || power <= 1e-6 || cos_eta <= sin_phi {
            return None;
        }
        let narrowing = 2.0 * sin_phi / (cos_eta * cos_eta - sin_phi * sin_phi).sqrt()
            * case.width_ratio.depth_over_width()
            / libm::sin(alpha);
        // The section shrinks to a point at `height`, the width to nothing at `1 / narrowing`.
        let end = height.min(1.0 / narrowing);
        let speed = libm::sin(alpha + delta) / power;
        Some(Self { sinking, speed, surface, height, narrowing, end, cos_eta })
    }

    /// The same wedge behind a plate that is so many times as wide.
    pub(super) fn at_width(&self, times: f64) -> Self {
        let narrowing = self.narrowing / times;
        Self { narrowing, end: self.height.min(1.0 / narrowing), ..*self }
    }

    /// What it adds to the force, per width.
    fn factors(&self, case: &Case) -> LoadFactors {
        let Self { sinking, speed, surface, height, narrowing, end, cos_eta } = *self;
        let plate = libm::sin(case.tool_angle.radians() + case.interface.radians());
        let volume = end
            - end * end / (2.0 * height)
            - narrowing * (end * end / 2.0 - end * end * end / (3.0 * height));
        let sunk_area = surface / height * (end - narrowing * end * end / 2.0);
        let sinks = speed * libm::sin(sinking);
        let slip = speed * (cos_eta - libm::sin(sinking + case.surface_slope.radians()) * sunk_area);
        LoadFactors {
            weight: 2.0 * volume * sinks / plate,
            surcharge: sunk_area * sinks / plate,
            cohesion: slip / (libm::tan(case.friction.radians()) * plate),
            // The force for adhesion is that beside it, so the work is done on how the soil moves along the plate.
            adhesion: speed * libm::cos(case.tool_angle.radians() - sinking) / plate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::coulomb::Coulomb;
    use proptest::prelude::*;
    use soilctl_soil::WidthRatio;

    proptest! {
        /// A plate without ends has Coulomb's wedge behind it, found there by balancing forces.
        #[test]
        fn in_plane_strain_it_is_coulombs_wedge(alpha in 60.0..115.0, beta in -12.0..12.0, phi in 15.0..48.0, ratio in 0.05..0.9) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            let (ours, coulomb) = (active(&case), Coulomb::active(&case));
            for (a, b) in [(ours.weight, coulomb.weight), (ours.surcharge, coulomb.surcharge), (ours.cohesion, coulomb.cohesion), (ours.adhesion, coulomb.adhesion)] {
                prop_assert!((a - b).abs() < 1e-5 * (1.0 + b.abs()), "{ours:?} {coulomb:?}");
            }
        }

        /// Ends take from the thrust, the more the narrower the plate.
        #[test]
        fn narrower_plates_have_less_behind_them(alpha in 60.0..115.0, phi in 15.0..48.0, wide in 0.2..20.0) {
            let case = |ratio: f64| Case::level_deg(alpha, phi, 0.5 * phi).with_width_ratio(WidthRatio::new(ratio).unwrap());
            let (narrow, wider) = (active(&case(0.7 * wide)).weight, active(&case(wide)).weight);
            prop_assert!(narrow <= wider * (1.0 + 1e-9) && wider <= Coulomb::active(&case(wide)).weight * (1.0 + 1e-9));
        }
    }
}
