use super::{Effect, Reading};
use crate::{Channel, Conditions, EffectsError, Mechanics, Parameter, Range, Reference, Shape, Stroke};

/// Normal force leaks into the tangential channel: the tangent of the friction angle is read high by the crosstalk,
/// and the resultant with it. A controller that holds the angle that is read (shape 1) shows it only after failure.
pub(super) struct FtCrosstalk;

/// True and read tangent of the friction angle.
fn tangents(delta_deg: f64, crosstalk: f64) -> (f64, f64) {
    let tan = delta_deg.to_radians().tan();
    (tan, tan + crosstalk)
}

impl Effect for FtCrosstalk {
    fn id(&self) -> &'static str {
        "ft_crosstalk"
    }

    fn title(&self) -> &'static str {
        "normal force leaks into the tangential channel"
    }

    fn parameter(&self) -> Parameter {
        Parameter { name: "crosstalk", unit: "1" }
    }

    fn range(&self) -> Range {
        Range::either(0.02, 0.15)
    }

    fn apply(
        &self,
        amplitude: f64,
        _shape: f64,
        _stroke: &Stroke,
        _reference: &Reference,
        c: &mut Conditions,
        _mechanics: &dyn Mechanics,
    ) -> Result<(), EffectsError> {
        let (tan, leaky) = tangents(c.delta_deg, amplitude);
        c.ln_factor += 0.5 * ((1.0 + leaky * leaky) / (1.0 + tan * tan)).ln();
        Ok(())
    }

    fn linked(&self) -> &'static [Channel] {
        &[Channel::FrictionAngle, Channel::SlipAngle]
    }

    fn shape(&self) -> Option<Shape> {
        Some(Shape { parameter: None, values: &[0.0, 1.0] })
    }

    fn needs(&self, shape: f64) -> Option<Channel> {
        (shape > 0.5).then_some(Channel::SlipAngle)
    }

    fn shift(
        &self,
        channel: Channel,
        amplitude: f64,
        shape: f64,
        _stroke: &Stroke,
        reading: &Reading,
    ) -> f64 {
        if channel == Channel::FrictionAngle && shape > 0.5 {
            return 0.0;
        }
        let (tan, leaky) = tangents(reading.delta_deg, amplitude);
        (leaky.atan() - tan.atan()).to_degrees()
    }
}
