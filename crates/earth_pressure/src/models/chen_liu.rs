//! Chen & Liu's upper bound (1990, section 5.3): a rigid triangle at the plate, a logarithmic-spiral shear zone
//! and a rigid triangle at the surface, with zero wall dilation (v_w = 0); Hong (2001), eqs 4.20 and 4.21.
//!
//! With the plate's top as pole, `r0 = L cos(rho - phi) / cos(phi)` the first radius, `x = alpha - rho - psi`
//! the dip of the last radius and `t = tan(phi)`, the power of the plate's force, `P cos(rho + delta)`, equals
//!
//! ```text
//! weight     1/2 gamma [ L r0 sin(rho) cos(alpha-rho) + r0^2 I(3t) + r0^2 e^(3 t psi) cos(phi) sin(x+beta) cos(x) / cos(x+beta+phi) ]
//! surcharge  q r0 e^(2 t psi) cos(phi) cos(x) / cos(x+beta+phi)
//! cohesion   c [ L sin(rho) + r0 (e^(2 t psi) - 1) / t + r0 e^(2 t psi) sin(x+beta) cos(phi) / cos(x+beta+phi) ]
//! adhesion   c_a L sin(rho)
//! ```
//!
//! with `I(b)` the integral of `e^(b s) cos(alpha-rho-s)` over the spiral. Negating phi and delta and mirroring
//! alpha and beta gives the active side, which is maximised.
//!
//! **Two variables, one search.** The derivative of the weight term by psi at fixed rho is `e^(3 t psi)` times a
//! function of x alone, which vanishes where `tan(x+beta+phi) - tan(x) = 2 tan(phi)`, that is at
//! `x = 45 deg - phi/2 - (beta + omega)/2`, `sin(omega) = sin(beta)/sin(phi)`: the Rankine direction. So psi is
//! known for every rho (0 where the Rankine fan has not opened), and only rho has to be searched. With psi = 0 the
//! mechanism is Coulomb's wedge.

use std::f64::consts::FRAC_PI_2;

use soilctl_soil::{Angle, WidthRatio};

use crate::minimise::minimise;
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::turn::Turn;
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

const ID: &str = "chen";
/// Points of the first scan over rho, on an interval of at most 90 degrees.
const SCAN: usize = 16;

/// Chen & Liu's log-sandwich upper bound.
#[derive(Debug, Clone, Copy, Default)]
pub struct ChenLiu;

impl ChenLiu {
    /// Passive factors of a plate that sticks to the soil and is pushed with a force inclined to its normal by the case's `interface`, which may
    /// be anything from `-phi` to `phi` here: negative where the force points up along the plate.
    ///
    /// The triangle at the plate moves as one piece and the plate with it, so that nothing slips on the plate and its friction does not enter:
    /// an upper bound for every plate that is rough enough to hold the force, Hong (2001), figure 5-13.
    ///
    /// # Errors
    /// [`EarthPressureError::OutsideModel`] outside the model's angles or for an inclination above phi,
    /// [`EarthPressureError::Singular`] where no mechanism fits.
    pub fn sticking(case: &Case) -> Result<LoadFactors, EarthPressureError> {
        let upwards = Case { interface: Angle::from_radians(case.interface.radians().abs()), ..*case };
        Self.valid_range().check(ID, &upwards)?;
        passive(case)
    }
}

impl ForceModel for ChenLiu {
    fn id(&self) -> &'static str {
        ID
    }

    fn reference(&self) -> &'static str {
        "Chen & Liu 1990, Limit Analysis in Soil Mechanics, section 5.3; kinematic upper bound on each side"
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange::closed_form()
    }

    fn has_load_terms(&self, _case: &Case) -> bool {
        true
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        Prediction::from_sides(ID, case, passive(case)?, active(case))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        DirectSlice::boxed(self, tool_angle, surface_slope, width_ratio)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.valid_range().check(ID, case)?;
        let mechanism = Mechanism::new(case, 1.0);
        let rho = mechanism.optimum().ok_or_else(|| no_mechanism(case))?.0;
        Ok(Some(FailureSurface::from_tip(case, mechanism.surface(rho))))
    }
}

/// Passive factors on the mechanism of least weight term.
pub(crate) fn passive(case: &Case) -> Result<LoadFactors, EarthPressureError> {
    let mechanism = Mechanism::new(case, 1.0);
    let (rho, _) = mechanism.optimum().ok_or_else(|| no_mechanism(case))?;
    Ok(mechanism.factors(rho))
}

/// Active factors on the mechanism of greatest weight term; none where the soil behind stands by itself.
pub(crate) fn active(case: &Case) -> LoadFactors {
    let mechanism = Mechanism::new(&case.mirrored(), -1.0);
    match mechanism.optimum() {
        Some((rho, least)) if least < 0.0 => mechanism.factors(rho),
        _ => LoadFactors::default(),
    }
}

/// Dips of the first and the last radius ahead of the plate; the same where the fan has not opened.
pub(crate) fn fan(case: &Case) -> Option<(f64, f64)> {
    let mechanism = Mechanism::new(case, 1.0);
    let (rho, _) = mechanism.optimum()?;
    let first = mechanism.alpha - rho;
    Some((first, first - mechanism.psi(rho)))
}

fn no_mechanism(case: &Case) -> EarthPressureError {
    case.singular(ID, "no mechanism of three zones fits between plate and surface")
}

/// The mechanism of one side, angles in radians; friction angles carry the sign of the side.
struct Mechanism {
    alpha: f64,
    beta: f64,
    phi: f64,
    delta: f64,
    /// 1 ahead of the plate (minimise), -1 behind it (maximise).
    sign: f64,
    /// Dip of the last radius once the fan has opened.
    rankine_dip: f64,
    /// The same angles with their sines and cosines: the search over rho then takes one sine and one exponential a step.
    turns: Turns,
}

#[derive(Clone, Copy)]
struct Turns {
    alpha: Turn,
    beta: Turn,
    phi: Turn,
    delta: Turn,
    rankine_dip: Turn,
    /// `3 tan(phi)`.
    b: f64,
}

impl Mechanism {
    fn new(case: &Case, sign: f64) -> Self {
        let (alpha, beta) = (case.tool_angle.radians(), case.slope_below_phi());
        let (phi, delta) = (sign * case.friction.radians(), sign * case.interface.radians());
        let omega = libm::asin((libm::sin(beta) / libm::sin(phi)).clamp(-1.0, 1.0));
        let rankine_dip = 0.5 * (FRAC_PI_2 - phi - beta - omega);
        let turns = Turns {
            alpha: Turn::of(alpha),
            beta: Turn::of(beta),
            phi: Turn::of(phi),
            delta: Turn::of(delta),
            rankine_dip: Turn::of(rankine_dip),
            b: 3.0 * libm::tan(phi),
        };
        Self { alpha, beta, phi, delta, sign, rankine_dip, turns }
    }

    /// Best rho and the signed weight term there (passive K, or minus active K).
    fn optimum(&self) -> Option<(f64, f64)> {
        // Below rho = 0 the first triangle folds over and only the plane wedge (psi = 0) is a mechanism.
        let flattest = (self.alpha + self.beta + self.phi - FRAC_PI_2).min(0.0);
        let steepest = (FRAC_PI_2 - self.delta).min(FRAC_PI_2 + self.phi).min(self.alpha + self.beta);
        minimise(flattest + 1e-9, steepest - 1e-9, SCAN, |rho| self.sign * self.weight(rho))
    }

    /// Opening of the fan that is stationary at this rho.
    fn psi(&self, rho: f64) -> f64 {
        if rho < 0.0 { 0.0 } else { (self.alpha - rho - self.rankine_dip).max(0.0) }
    }

    /// First radius over L.
    fn radius(&self, rho: f64) -> f64 {
        libm::cos(rho - self.phi) / libm::cos(self.phi)
    }

    /// Weight factor with the fan that is stationary at this rho; NaN where the zones do not form.
    fn weight(&self, rho: f64) -> f64 {
        let (rho_turn, psi) = (Turn::of(rho), self.psi(rho));
        if psi > 0.0 {
            self.weight_of(rho_turn, self.turns.rankine_dip, libm::exp(self.turns.b * psi))
        } else {
            self.weight_of(rho_turn, self.turns.alpha - rho_turn, 1.0)
        }
    }

    /// Weight factor by the dip x of the last radius and the growth of the spiral, `e^(3 t psi)`.
    fn weight_of(&self, rho: Turn, x: Turn, growth: f64) -> f64 {
        let Turns { alpha, beta, phi, delta, b, .. } = self.turns;
        let surface = x + beta;
        let (toe, power) = ((surface + phi).cos, (rho + delta).cos);
        if toe <= 0.0 || surface.sin < 0.0 || power <= 0.0 {
            return f64::NAN;
        }
        let (r0, dip) = ((rho - phi).cos / phi.cos, alpha - rho);
        let spiral = (growth * (b * x.cos - x.sin) - (b * dip.cos - dip.sin)) / (b * b + 1.0);
        let triangle = growth * phi.cos * surface.sin * x.cos / toe;
        r0 * (rho.sin * dip.cos + r0 * (spiral + triangle)) / power
    }

    /// All factors with the fan that is stationary at this rho.
    fn factors(&self, rho: f64) -> LoadFactors {
        let psi = self.psi(rho);
        let x = self.alpha - rho - psi;
        let (r0, t) = (self.radius(rho), libm::tan(self.phi));
        let growth = libm::exp(2.0 * t * psi);
        let last = r0 * growth * libm::cos(self.phi) / libm::cos(x + self.beta + self.phi);
        let power = libm::cos(rho + self.delta);
        let fan = r0 * libm::expm1(2.0 * t * psi) / t;
        LoadFactors {
            weight: self.weight(rho),
            surcharge: last * libm::cos(x) / power,
            cohesion: (libm::sin(rho) + fan + last * libm::sin(x + self.beta)) / power,
            adhesion: libm::sin(rho) / power,
        }
    }

    /// Failure surface from the tip at the origin, L = 1: slip line, spiral, slip line.
    fn surface(&self, rho: f64) -> Vec<(f64, f64)> {
        const CHORDS: usize = 48;
        let psi = self.psi(rho);
        let top = (-libm::cos(self.alpha), libm::sin(self.alpha));
        let (r0, t) = (self.radius(rho), libm::tan(self.phi));
        let mut points = vec![(0.0, 0.0)];
        for i in 0..=CHORDS {
            let s = psi * i as f64 / CHORDS as f64;
            let (r, dip) = (r0 * libm::exp(t * s), self.alpha - rho - s);
            points.push((top.0 + r * libm::cos(dip), top.1 - r * libm::sin(dip)));
            if psi == 0.0 {
                break;
            }
        }
        let last = r0 * libm::exp(t * psi) * libm::cos(self.phi)
            / libm::cos(self.alpha - rho - psi + self.beta + self.phi);
        points.push((top.0 + last * libm::cos(self.beta), top.1 + last * libm::sin(self.beta)));
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Coulomb;
    use crate::test_support::rel;
    use proptest::prelude::*;

    proptest! {
        /// Brute force over both variables finds nothing better on either side.
        #[test]
        fn the_reduced_search_finds_the_two_variable_optimum(alpha in 40.0..110.0, beta in -12.0..12.0, phi in 15.0..50.0, ratio in 0.0..0.95) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            prop_assume!(alpha > phi + 3.0);
            for (sign, side) in [(1.0, case), (-1.0, case.mirrored())] {
                let mechanism = Mechanism::new(&side, sign);
                let (_, best) = mechanism.optimum().unwrap();
                let mut brute = f64::INFINITY;
                for i in 0..=120 {
                    for j in 0..=120 {
                        let (rho, psi) = (1.5 * f64::from(i) / 120.0, 2.2 * f64::from(j) / 120.0);
                        let x = mechanism.alpha - rho - psi;
                        let growth = libm::exp(3.0 * libm::tan(mechanism.phi) * psi);
                        let value = sign * mechanism.weight_of(Turn::of(rho), Turn::of(x), growth);
                        if value.is_finite() { brute = brute.min(value) }
                    }
                }
                prop_assert!(best <= brute + 1e-9 * brute.abs(), "{best} {brute}");
            }
        }

        /// A force that points up along the plate: never above Coulomb's wedge that moves ahead, found by trying all planes, and little below it, since
        /// a plane is nearly the best mechanism there. Without friction on the plate it is the passive side of the model itself.
        #[test]
        fn a_force_that_lifts(alpha in 50.0..100.0, phi in 20.0..45.0, ratio in 0.05..0.9) {
            let lift_deg: f64 = ratio * phi;
            let case = Case::from_deg(alpha, 0.0, phi, -lift_deg);
            let found = ChenLiu::sticking(&case).unwrap().weight;
            let (a, f, d) = (case.tool_angle.radians(), case.friction.radians(), case.interface.radians());
            // Forces on the wedge above a plane at the dip t: weight, the plate's force, and that of the plane at phi to its normal.
            let wedge = |t: f64| {
                let area = 0.5 * (a + t).sin() * a.sin() / t.sin();
                2.0 * area * (t + f).sin() / (a + d + t + f).sin()
            };
            let planes = (1..2000).map(|i| f64::from(i) * (std::f64::consts::PI - a) / 2000.0);
            let best = planes.filter(|t| t + f <= FRAC_PI_2 && a + d + t + f < std::f64::consts::PI).map(wedge).fold(f64::INFINITY, f64::min);
            prop_assert!(found <= best * (1.0 + 1e-9) && found > 0.9 * best, "{found} {best}");
            let smooth = Case::from_deg(alpha, 0.0, phi, 0.0);
            prop_assert_eq!(ChenLiu::sticking(&smooth).unwrap(), passive(&smooth).unwrap());
        }

        /// Without a fan the mechanism is one sliding plane, so it cannot be above Coulomb's wedge.
        #[test]
        fn never_above_coulomb(alpha in 45.0..110.0, beta in -10.0..10.0, phi in 15.0..45.0, ratio in 0.0..1.0) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            if let (Ok(chen), Ok(coulomb)) = (ChenLiu.predict(&case), Coulomb.predict(&case)) {
                prop_assert!(chen.passive.unwrap().weight <= coulomb.passive.unwrap().weight * (1.0 + 1e-9));
            }
        }

        /// Caquot's theorem of corresponding states: a cohesion c with adhesion c tan(delta)/tan(phi) acts like
        /// a pressure c / tan(phi) on every boundary.
        #[test]
        fn corresponding_states(alpha in 50.0..110.0, phi in 15.0..45.0, ratio in 0.05..0.95) {
            let case = Case::level_deg(alpha, phi, ratio * phi);
            let k = passive(&case).unwrap();
            let (t, d) = (case.friction.tan(), case.interface.radians());
            // Pressure p on surface and plate; the plate's normal pressure p is part of the inclined force.
            let sum = k.cohesion + k.adhesion * libm::tan(d) / t;
            prop_assert!(rel(sum, (k.surcharge - 1.0 / libm::cos(d)) / t) < 1e-6, "{sum} {}", (k.surcharge - 1.0 / libm::cos(d)) / t);
        }
    }

    #[test]
    fn smooth_vertical_wall_is_rankine() {
        let p = ChenLiu.predict(&Case::level_deg(90.0, 30.0, 0.0)).unwrap();
        let (passive, active) = (p.passive.unwrap(), p.active.unwrap());
        assert!(rel(passive.weight, 3.0) < 1e-9 && rel(active.weight, 1.0 / 3.0) < 1e-9);
        assert!(rel(passive.cohesion, 2.0 * 3f64.sqrt()) < 1e-6 && rel(passive.surcharge, 3.0) < 1e-6);
    }

    #[test]
    fn soil_under_a_flat_plate_does_not_push() {
        assert_eq!(active(&Case::level_deg(35.0, 40.0, 20.0)).weight, 0.0);
        assert!(active(&Case::level_deg(50.0, 40.0, 20.0)).weight > 0.0);
    }
}
