use crate::{Acting, Active, Base, Conditions, EffectsError, Mechanics, Reference, Stroke};

/// Force in N that is read for a stroke, with all effects.
///
/// # Errors
/// [`EffectsError::Model`] if the force model has no answer under these conditions, [`EffectsError::NoForce`] if
/// the effects leave nothing above 0 N.
pub fn force_n(
    mechanics: &dyn Mechanics,
    stroke: &Stroke,
    reference: &Reference,
    base: &Base,
    effects: &[Active],
) -> Result<f64, EffectsError> {
    let mut conditions = Conditions::plain(stroke.alpha_deg, stroke.depth_m, base);
    for &Active { effect, amplitude, shape } in effects {
        effect.apply(&Acting { amplitude, shape, stroke, reference, mechanics }, &mut conditions)?;
    }
    let c = &conditions;
    let net = mechanics.net(c.alpha_deg, c.beta_deg, c.phi_deg, c.delta_deg)?;
    let slant_m = c.depth_m / libm::sin(c.alpha_deg.to_radians());
    let unit_weight = base.density_kg_m3 * base.gravity_m_s2;
    let weight = 0.5 * unit_weight * slant_m * net.weight;
    let loads = c.cohesion_pa * net.cohesion + c.surcharge_pa * net.surcharge;
    let force_n = slant_m * stroke.width_m * (weight + loads) * libm::exp(c.ln_factor) + c.bias_n;
    if c.depth_m > 0.0 && force_n > 0.0 && force_n.is_finite() {
        Ok(force_n)
    } else {
        Err(EffectsError::NoForce { force_n })
    }
}
