use soilctl_earth_pressure::{Case, ChenLiu, ForceModel, LoadFactors, model};

use crate::EffectsError;

/// Force models that `model_form` may put in the place of the one in use.
pub const ALTERNATIVE_MODELS: [&str; 4] = ["coulomb", "chen", "log-spiral", "caquot"];

/// Slant-normalised net factors: `F = 1/2 gamma L^2 w weight + L w (c cohesion + q surcharge)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Net {
    /// Soil weight.
    pub weight: f64,
    /// Cohesion.
    pub cohesion: f64,
    /// Surcharge.
    pub surcharge: f64,
}

/// Net factors of a plate; what [`crate::force_n`] is made of.
pub trait Mechanics {
    /// Factors at a tool angle, surface slope, soil friction and interface friction, all in degrees. Interface
    /// friction above that of the soil counts as that of the soil: soil slides on soil first.
    ///
    /// # Errors
    /// [`EffectsError::Model`] where there is no finite answer.
    fn net(&self, alpha_deg: f64, beta_deg: f64, phi_deg: f64, delta_deg: f64) -> Result<Net, EffectsError>;

    /// ln of the weight factor of one of the [`ALTERNATIVE_MODELS`] over that of this model.
    ///
    /// # Errors
    /// As [`Mechanics::net`].
    fn ln_alternative(
        &self,
        which: usize,
        alpha_deg: f64,
        phi_deg: f64,
        delta_deg: f64,
    ) -> Result<f64, EffectsError>;
}

/// Factors straight from a force model.
///
/// A table covers a range of angles and no loads. Outside that range its nearest point is carried on by the ratio
/// that Chen & Liu's upper bound has between the two points; the load factors are Chen & Liu's share of the
/// weight factor.
pub struct DirectMechanics {
    model: Box<dyn ForceModel>,
}

impl DirectMechanics {
    /// Factors from a model.
    #[must_use]
    pub fn new(model: Box<dyn ForceModel>) -> Self {
        Self { model }
    }

    /// The model behind it.
    #[must_use]
    pub fn model(&self) -> &dyn ForceModel {
        self.model.as_ref()
    }

    /// ln of the weight factor of the model, and half the log width of its bracket.
    ///
    /// # Errors
    /// As [`Mechanics::net`].
    pub fn ln_weight(&self, alpha: f64, beta: f64, phi: f64, delta: f64) -> Result<(f64, f64), EffectsError> {
        ln_carried(self.model.as_ref(), alpha, beta, phi, delta)
    }
}

impl Mechanics for DirectMechanics {
    fn net(&self, alpha: f64, beta: f64, phi: f64, delta: f64) -> Result<Net, EffectsError> {
        let weight = libm::exp(self.ln_weight(alpha, beta, phi, delta)?.0);
        let share = chen(alpha, beta, phi, delta)?;
        let scale = weight / share.weight;
        Ok(Net { weight, cohesion: scale * share.cohesion, surcharge: scale * share.surcharge })
    }

    fn ln_alternative(&self, which: usize, alpha: f64, phi: f64, delta: f64) -> Result<f64, EffectsError> {
        let other = model(ALTERNATIVE_MODELS.get(which).copied().unwrap_or_default())?;
        let ours = self.ln_weight(alpha, 0.0, phi, delta)?.0;
        Ok(ln_carried(other.as_ref(), alpha, 0.0, phi, delta)?.0 - ours)
    }
}

fn chen(alpha: f64, beta: f64, phi: f64, delta: f64) -> Result<LoadFactors, EffectsError> {
    Ok(ChenLiu.predict(&Case::from_deg(alpha, beta, phi, delta.min(phi)))?.net)
}

/// ln of the weight factor and half the log width, carried on from the nearest point that the model covers.
fn ln_carried(
    model: &dyn ForceModel,
    alpha: f64,
    beta: f64,
    phi: f64,
    delta: f64,
) -> Result<(f64, f64), EffectsError> {
    let range = model.valid_range();
    let near = |value: f64, (low, high): (f64, f64)| value.clamp(low, high);
    let delta = delta.min(phi);
    let (a, b, p) = (near(alpha, range.alpha_deg), near(beta, range.beta_deg), near(phi, range.phi_deg));
    let d = near(delta, range.delta_deg).min(p);
    let found = model.predict(&Case::from_deg(a, b, p, d))?;
    let half_width = 0.5 * libm::log(found.net_upper.0 / found.net_lower.0);
    let mut ln_weight = libm::log(found.net.weight);
    if (a, b, p, d) != (alpha, beta, phi, delta) {
        ln_weight += libm::log(chen(alpha, beta, phi, delta)?.weight / chen(a, b, p, d)?.weight);
    }
    Ok((ln_weight, half_width))
}
