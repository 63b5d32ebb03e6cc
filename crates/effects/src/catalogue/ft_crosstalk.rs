use super::EffectId;
use crate::{Channel, Effect, Parameter, Range, SensorSite, Shape, Site};

/// True and read tangent of the friction angle.
fn tangents(delta_deg: f64, crosstalk: f64) -> (f64, f64) {
    let tan = libm::tan(delta_deg.to_radians());
    (tan, tan + crosstalk)
}

/// A part x of the normal force N leaks into the tangential channel, which reads `N (tan delta + x)`: the friction angle is
/// read high, and the resultant by `sqrt((1 + (tan delta + x)^2) / (1 + tan^2 delta))`. A controller that holds the angle that
/// is read (shape 1) shows it only after failure. The soil then fails at a true tangent that is x less (2), and its strength is that of this
/// angle.
///
/// Source: own derivation.
pub(super) static EFFECT: Effect = Effect {
    shape: Some(Shape { parameter: None, values: &[0.0, 1.0, 2.0] }),
    needs: Some(Channel::SlipAngle),
    apply: |a, c| {
        let (mut tan, mut leaky) = tangents(c.delta_deg, a.amplitude);
        if a.shape > 1.5 {
            (tan, leaky) = ((tan - a.amplitude).max(0.0), tan);
            c.delta_deg = libm::atan(tan).to_degrees();
        }
        c.ln_factor += 0.5 * libm::log((1.0 + leaky * leaky) / (1.0 + tan * tan));
        Ok(())
    },
    linked: &[Channel::FrictionAngle, Channel::SlipAngle],
    shift: |channel, amplitude, shape, reading| {
        if channel == Channel::FrictionAngle && shape > 0.5 {
            return 0.0;
        }
        let (tan, leaky) = tangents(reading.delta_deg, amplitude);
        (libm::atan(leaky) - libm::atan(tan)).to_degrees()
    },
    ..Effect::new(
        EffectId::FtCrosstalk,
        Site::Sensor(SensorSite::Crosstalk),
        Parameter { name: "crosstalk", unit: "1" },
        Range::either(0.02, 0.15),
    )
};
