//! A force model tabulated for many look-ups.

use soilctl_earth_pressure::{Case, ChenLiu, ForceModel, model};
use soilctl_effects::{ALTERNATIVE_MODELS, DirectMechanics, EffectsError, Mechanics, Net};
use soilctl_soil::{Angle, WidthRatio};

use crate::DiagnosisError;
use crate::grid::{Axis, Grid};

/// Half step of the surface slope with which its influence is tabulated, deg: the middle of the slopes that `surface_slope` has.
const BETA_STEP_DEG: f64 = 4.0;

/// Force factors of a model and of the alternatives, interpolated by cubics between tabulated points. Agrees
/// with [`DirectMechanics`] within a few parts in a thousand.
#[derive(Debug, Clone)]
pub struct Surface {
    ln_weight: Grid,
    half_width: Grid,
    /// Linear and quadratic coefficient of ln weight in the surface slope in deg.
    slope: [Grid; 2],
    cohesion_share: Grid,
    surcharge_share: Grid,
    alternatives: Vec<Grid>,
    /// What the ends of a plate as wide as deep add at most, over the force in plane strain; none if the model does not bound that.
    ends: Option<Grid>,
}

impl Surface {
    /// Tabulates a model for tool angles between two ends, in deg.
    ///
    /// # Errors
    /// [`DiagnosisError::Model`] if an alternative model cannot be loaded.
    pub fn new(base: Box<dyn ForceModel>, alpha_deg: (f64, f64)) -> Result<Self, DiagnosisError> {
        let low = (alpha_deg.0 / 5.0).floor() * 5.0 - 10.0;
        let high = (alpha_deg.1 / 5.0).ceil() * 5.0 + 10.0;
        // A whole number, small and positive.
        let alphas = ((high - low) / 5.0).round() as usize + 1;
        let alpha = Axis { start: low, step: 5.0, count: alphas };
        let axis = |step: f64, from: f64, to: f64| Axis {
            start: from,
            step,
            count: ((to - from) / step) as usize + 1,
        };
        let fine = [alpha, axis(2.0, 18.0, 60.0), axis(2.0, 0.0, 48.0)];
        let coarse = [alpha, axis(3.0, 18.0, 60.0), axis(4.0, 0.0, 48.0)];
        let chen = |beta: f64, a: f64, p: f64, d: f64| {
            ChenLiu.predict(&Case::from_deg(a, beta, p, d.min(p))).ok().map(|found| found.net)
        };
        let ln_chen = |beta, a, p, d| chen(beta, a, p, d).map_or(f64::NAN, |net| net.weight.ln());
        let direct = DirectMechanics::new(base);
        let or_nan = |found: Result<(f64, f64), EffectsError>| found.unwrap_or((f64::NAN, f64::NAN));
        let ln_weight = Grid::new(fine, |a, p, d| or_nan(direct.ln_weight(a, 0.0, p, d)).0);
        let half_width = Grid::new(coarse, |a, p, d| or_nan(direct.ln_weight(a, 0.0, p, d)).1);
        let x = BETA_STEP_DEG;
        let linear = Grid::new(coarse, |a, p, d| (ln_chen(x, a, p, d) - ln_chen(-x, a, p, d)) / (2.0 * x));
        let quadratic = Grid::new(coarse, |a, p, d| {
            (ln_chen(x, a, p, d) + ln_chen(-x, a, p, d) - 2.0 * ln_chen(0.0, a, p, d)) / (2.0 * x * x)
        });
        let cohesion_share =
            Grid::new(coarse, |a, p, d| chen(0.0, a, p, d).map_or(f64::NAN, |n| n.cohesion / n.weight));
        let surcharge_share =
            Grid::new(coarse, |a, p, d| chen(0.0, a, p, d).map_or(f64::NAN, |n| n.surcharge / n.weight));
        let ends = direct.model().bounds_ends().then(|| {
            Grid::new(coarse, |a, p, d| most_of_ends(direct.model(), a, p, d.min(p)).unwrap_or(f64::NAN))
        });
        let mut alternatives = Vec::new();
        for id in ALTERNATIVE_MODELS {
            let other = DirectMechanics::new(model(id)?);
            alternatives.push(Grid::new(coarse, |a, p, d| {
                or_nan(other.ln_weight(a, 0.0, p, d)).0 - or_nan(direct.ln_weight(a, 0.0, p, d)).0
            }));
        }
        Ok(Self {
            ln_weight,
            half_width,
            slope: [linear, quadratic],
            cohesion_share,
            surcharge_share,
            alternatives,
            ends,
        })
    }

    /// What the ends of a plate as wide as deep add at most, over the force in plane strain, if the model bounds that.
    pub(crate) fn most_of_ends(&self, alpha: f64, phi: f64, delta: f64) -> Option<f64> {
        self.ends.as_ref().map(|ends| ends.at(alpha, phi, delta.min(phi))).filter(|most| most.is_finite())
    }

    /// Half the log width of the model's bracket.
    pub(crate) fn half_width(&self, alpha: f64, phi: f64, delta: f64) -> f64 {
        let width = self.half_width.at(alpha, phi, delta.min(phi));
        if width.is_finite() { width.max(0.0) } else { 0.0 }
    }
}

/// The same from the model itself.
fn most_of_ends(model: &dyn ForceModel, alpha: f64, phi: f64, delta: f64) -> Option<f64> {
    let square = WidthRatio::new(1.0).ok()?;
    let net = model.at(Angle::from_degrees(alpha), Angle::ZERO, square).ok()?.net(phi, delta).ok()?;
    Some(net.ends_at_most / (net.weight_upper - net.ends_at_most))
}

/// What a look-up outside the tabulated points means.
fn found(value: f64, alpha_deg: f64, phi_deg: f64, delta_deg: f64) -> Result<f64, EffectsError> {
    if value.is_finite() {
        return Ok(value);
    }
    Err(soilctl_earth_pressure::EarthPressureError::Singular {
        model: "diagnosis",
        alpha_deg,
        phi_deg,
        delta_deg,
        reason: "the angles are outside of what the diagnosis searches (phi 18 to 60 deg, delta up to 48 deg)",
    }
    .into())
}

impl Mechanics for Surface {
    fn net(&self, alpha: f64, beta: f64, phi: f64, delta: f64) -> Result<Net, EffectsError> {
        let delta = delta.min(phi);
        let mut ln_weight = self.ln_weight.at(alpha, phi, delta);
        if beta != 0.0 {
            ln_weight += beta * self.slope[0].at(alpha, phi, delta)
                + beta * beta * self.slope[1].at(alpha, phi, delta);
        }
        let weight = found(ln_weight, alpha, phi, delta)?.exp();
        Ok(Net {
            weight,
            cohesion: weight * self.cohesion_share.at(alpha, phi, delta),
            surcharge: weight * self.surcharge_share.at(alpha, phi, delta),
        })
    }

    fn ln_alternative(&self, which: usize, alpha: f64, phi: f64, delta: f64) -> Result<f64, EffectsError> {
        let value = self.alternatives.get(which).map_or(f64::NAN, |grid| grid.at(alpha, phi, delta.min(phi)));
        found(value, alpha, phi, delta)
    }
}
