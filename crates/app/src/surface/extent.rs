//! Where models let the ground break.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::{Case, ChenLiu, Coulomb, ForceModel, LogSpiral};
use soilctl_estimator::PHI_SEARCH_DEG;
use soilctl_soil::{Angle, Plate};

/// Friction angles are told to this, outwards, in deg.
const FINEST_DEG: f64 = 0.01;
/// Steps that a search begins with.
const COARSE: usize = 55;
/// How far extents between two friction angles may be outside of those at both, over their difference.
const CURVED: f64 = 0.2;

/// A statement of where the ground breaks. None of them is proven: limit analysis proves forces, not where soil fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Surface {
    /// Coulomb's plane wedge.
    Coulomb,
    /// Ohde's logarithmic spiral with Rankine's zone.
    LogSpiral,
    /// Chen and Liu's mechanism of an upper bound, whose soil dilates by its friction angle.
    Chen,
    /// The same for a soil that does not dilate at all, with strength after Davis (1968): `tan(phi*) = sin(phi)`.
    ChenWithoutDilation,
}

impl Surface {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Coulomb, Self::LogSpiral, Self::Chen, Self::ChenWithoutDilation];

    /// Its name for people.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coulomb => "Coulomb's wedge",
            Self::LogSpiral => "the log-spiral",
            Self::Chen => "Chen & Liu",
            Self::ChenWithoutDilation => "Chen & Liu without dilation",
        }
    }

    /// Distance in m along the surface from the plate's face to where the slip surface meets it; infinite where the model has none.
    pub(super) fn distance_m(self, plate: &Plate, phi_deg: f64, delta_deg: f64) -> f64 {
        let friction_deg = match self {
            Self::Coulomb | Self::LogSpiral | Self::Chen => phi_deg,
            Self::ChenWithoutDilation => libm::atan(libm::sin(phi_deg.to_radians())).to_degrees(),
        };
        let case = Case {
            tool_angle: plate.tool_angle(),
            surface_slope: plate.surface_slope(),
            width_ratio: soilctl_soil::WidthRatio::PLANE_STRAIN,
            friction: Angle::from_degrees(friction_deg),
            interface: Angle::from_degrees(delta_deg.min(friction_deg)),
        };
        let surface = match self {
            Self::Coulomb => Coulomb.failure_surface(&case),
            Self::LogSpiral => LogSpiral::CORRECT.failure_surface(&case),
            Self::Chen | Self::ChenWithoutDilation => ChenLiu.failure_surface(&case),
        };
        match surface {
            Ok(Some(surface)) => surface.extent() * plate.slant_length_m(),
            Ok(None) | Err(_) => f64::INFINITY,
        }
    }

    /// Least and greatest distance in m over intervals of the friction angle and of friction on the plate, from their ends and middles.
    pub(super) fn range_m(self, plate: &Plate, phi_deg: [f64; 2], delta_deg: (f64, f64)) -> [f64; 2] {
        let deltas = [delta_deg.0, f64::midpoint(delta_deg.0, delta_deg.1), delta_deg.1];
        let phis = [phi_deg[0], f64::midpoint(phi_deg[0], phi_deg[1]), phi_deg[1]];
        let all = phis.iter().flat_map(|phi| deltas.iter().map(|delta| self.distance_m(plate, *phi, *delta)));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], d| [low.min(d), high.max(d)])
    }

    /// Friction angles (deg) at which the model explains all distances, enclosed in steps of a hundredth; `None` if there are none. Every stroke
    /// may have its own friction on the plate within what is known of it, so nothing that explains them with one is lost.
    pub(super) fn friction_deg(self, measured: &[Measured], delta_deg: (f64, f64)) -> Option<[f64; 2]> {
        // Strokes of one plate are asked about once, with what their bands share.
        let mut plates: Vec<(Plate, [f64; 2])> = Vec::new();
        for one in measured {
            match plates.iter_mut().find(|(plate, _)| *plate == one.plate) {
                Some((_, band)) => *band = [band[0].max(one.band_m[0]), band[1].min(one.band_m[1])],
                None => plates.push((one.plate, one.band_m)),
            }
        }
        if plates.iter().any(|(_, [low, high])| low > high) {
            return None;
        }
        let (low, high) = (PHI_SEARCH_DEG.0.max(delta_deg.0), PHI_SEARCH_DEG.1);
        let step = (high - low) / COARSE as f64;
        let mut open: Vec<[f64; 2]> =
            (0..COARSE).rev().map(|i| [low + step * i as f64, low + step * (i + 1) as f64]).collect();
        let mut found: Option<[f64; 2]> = None;
        while let Some([a, b]) = open.pop() {
            // Between what is found nothing new is learnt.
            if found.is_some_and(|[low, high]| low <= a && b <= high)
                || !self.may_explain(&plates, [a, b], delta_deg)
            {
                continue;
            }
            if b - a <= FINEST_DEG {
                found = Some(found.map_or([a, b], |[low, high]| [low.min(a), high.max(b)]));
            } else {
                let middle = f64::midpoint(a, b);
                open.extend([[middle, b], [a, middle]]);
            }
        }
        found
    }

    fn may_explain(self, plates: &[(Plate, [f64; 2])], phi_deg: [f64; 2], delta_deg: (f64, f64)) -> bool {
        plates.iter().all(|(plate, band_m)| {
            let [low, high] = self.range_m(plate, phi_deg, delta_deg);
            let slack = if high.is_finite() { CURVED * (high - low) } else { 0.0 };
            low - slack <= band_m[1] && high + slack >= band_m[0] && low.is_finite()
        })
    }
}

/// A break distance with its band.
pub(super) struct Measured {
    pub(super) line: usize,
    pub(super) label: String,
    pub(super) plate: Plate,
    pub(super) distance_m: f64,
    pub(super) sd_m: f64,
    pub(super) band_m: [f64; 2],
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plate(alpha: f64, depth_m: f64) -> Plate {
        Plate::new(Angle::from_degrees(alpha), Angle::ZERO, depth_m, 0.1).unwrap()
    }

    /// Ahead of a smooth upright wall every one of them is Rankine's wedge: depth times tan(45 deg + phi/2).
    #[test]
    fn ahead_of_a_smooth_wall_it_is_rankines_wedge() {
        for phi in [25.0, 35.0, 45.0_f64] {
            let rankine = |phi: f64| 0.03 * (45.0 + 0.5 * phi).to_radians().tan();
            for surface in [Surface::Coulomb, Surface::LogSpiral, Surface::Chen] {
                let found = surface.distance_m(&plate(90.0, 0.03), phi, 0.0);
                assert!(
                    (found / rankine(phi) - 1.0).abs() < 2e-3,
                    "{surface:?} {phi}: {found} {}",
                    rankine(phi)
                );
            }
            let reduced = phi.to_radians().sin().atan().to_degrees();
            let found = Surface::ChenWithoutDilation.distance_m(&plate(90.0, 0.03), phi, 0.0);
            assert!((found / rankine(reduced) - 1.0).abs() < 2e-3);
        }
    }

    /// What a model says at a soil is explained at that soil, for any strokes and any friction on the plate within what is known.
    #[test]
    fn the_truth_of_a_model_is_never_lost() {
        let mut state = 7u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        for round in 0..40 {
            let surface = Surface::ALL[round % 4];
            let (phi, delta) = (25.0 + 22.0 * random(), 5.0 + 15.0 * random());
            let shift = 2.0 * random() - 1.0;
            let measured: Vec<Measured> = (0..3)
                .map(|_| {
                    let plate = plate(60.0 + 40.0 * random(), 0.02 + 0.02 * random());
                    let truth = surface.distance_m(&plate, phi, delta);
                    let half = truth * (0.002 + 0.05 * random());
                    let read = truth + half * (2.0 * random() - 1.0);
                    Measured {
                        line: 0,
                        label: String::new(),
                        plate,
                        distance_m: read,
                        sd_m: half,
                        band_m: [read - half, read + half],
                    }
                })
                .collect();
            if measured.iter().any(|one| !one.distance_m.is_finite()) {
                continue;
            }
            let found = surface.friction_deg(&measured, (delta - 1.0 + shift, delta + 1.0 + shift));
            assert!(
                found.is_some_and(|[low, high]| low <= phi && phi <= high),
                "{surface:?} {phi} {delta}: {found:?}"
            );
        }
    }
}
