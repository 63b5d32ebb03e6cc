use std::fmt;

use crate::{
    Channel, Conditions, Covariate, EffectId, EffectsError, Mechanics, Parameter, Range, Reference, Shape,
    Site, Stroke,
};

/// One effect: what it does to a stroke. Each is defined in a file of the catalogue, with its formula and source.
pub struct Effect {
    /// Id in files and answers.
    pub id: EffectId,
    /// Where it acts.
    pub site: Site,
    /// The parameter that is its amplitude.
    pub parameter: Parameter,
    /// Plausible amplitudes.
    pub range: Range,
    /// What the amplitude leaves open; `None` if nothing.
    pub shape: Option<Shape>,
    /// The recorded condition, beside the geometry of a stroke, along which it changes; `None` if there is none.
    pub varies_with: Option<Covariate>,
    /// Channels that shift by an amount that the amplitude fixes.
    pub linked: &'static [Channel],
    /// Channels that show it with a strength of their own.
    pub responses: &'static [Response],
    /// See [`Effect::needs`].
    pub(crate) needs: Option<Channel>,
    pub(crate) apply: Apply,
    pub(crate) shift: Shift,
    pub(crate) response: Pattern,
}

pub(crate) type Apply = fn(&Acting<'_>, &mut Conditions) -> Result<(), EffectsError>;
/// Channel, amplitude, shape, reading.
pub(crate) type Shift = fn(Channel, f64, f64, &Reading<'_>) -> f64;
/// Channel, shape, stroke, reference.
pub(crate) type Pattern = fn(Channel, f64, &Stroke, &Reference) -> f64;

/// An effect with its amplitude and shape.
#[derive(Debug, Clone, Copy)]
pub struct Active {
    /// The effect.
    pub effect: &'static Effect,
    /// Its amplitude, in the unit of its parameter.
    pub amplitude: f64,
    /// Its shape; ignored by effects without one.
    pub shape: f64,
}

/// What an effect acts with, and on what.
pub struct Acting<'a> {
    /// Amplitude in the unit of its parameter.
    pub amplitude: f64,
    /// Its shape; 0 without one.
    pub shape: f64,
    /// The stroke, as recorded.
    pub stroke: &'a Stroke,
    /// What parameters refer to.
    pub reference: &'a Reference,
    /// The force model.
    pub mechanics: &'a dyn Mechanics,
}

/// Readings of a stroke that shifts of channels depend on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading<'a> {
    /// The stroke.
    pub stroke: &'a Stroke,
    /// Measured failure force, N.
    pub force_n: f64,
    /// Interface friction angle, deg.
    pub delta_deg: f64,
    /// Unit weight of the soil, N/m3.
    pub unit_weight_n_m3: f64,
    /// Step of the external encoders at the tip, m.
    pub encoder_step_m: f64,
}

/// A channel in which an effect shows with a strength that its amplitude does not fix.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// The channel.
    pub channel: Channel,
    /// Mean of the strength, in the unit of the channel.
    pub mean: f64,
    /// Standard deviation of the strength.
    pub sd: f64,
}

impl Effect {
    /// An effect without shape that changes nothing; a definition adds what it does.
    pub(crate) const fn new(id: EffectId, site: Site, parameter: Parameter, range: Range) -> Self {
        Self {
            id,
            site,
            parameter,
            range,
            shape: None,
            varies_with: None,
            linked: &[],
            responses: &[],
            needs: None,
            apply: |_, _| Ok(()),
            shift: |_, _, _, _| 0.0,
            response: |_, _, _, _| 0.0,
        }
    }

    /// Whether the failure force depends on it.
    #[must_use]
    pub const fn acts_on_force(&self) -> bool {
        self.site.acts_on_force()
    }

    /// Shapes that are tried, equally likely beforehand; 0 for an effect without one.
    #[must_use]
    pub fn shapes(&self) -> &'static [f64] {
        self.shape.map_or(&[0.0], |shape| shape.values)
    }

    /// The shape with which a simulated arm shows it: that of an arm whose controller holds what it reads, where there is the choice.
    #[must_use]
    pub fn simulated_shape(&self) -> f64 {
        let mut shapes = self.shapes().iter().copied();
        if self.needs.is_some() { shapes.last() } else { shapes.next() }.unwrap_or(0.0)
    }

    /// A channel without which a shape means the same as another one; `None` if there is no such channel.
    #[must_use]
    pub fn needs(&self, shape: f64) -> Option<Channel> {
        self.needs.filter(|_| shape > 0.5)
    }

    /// Changes the conditions of a stroke. Nothing changes at amplitude 0.
    ///
    /// # Errors
    /// [`EffectsError`] where the force model has no answer.
    pub fn apply(&self, acting: &Acting<'_>, conditions: &mut Conditions) -> Result<(), EffectsError> {
        (self.apply)(acting, conditions)
    }

    /// Shift of a linked channel, in its unit.
    #[must_use]
    pub fn shift(&self, channel: Channel, amplitude: f64, shape: f64, reading: &Reading<'_>) -> f64 {
        (self.shift)(channel, amplitude, shape, reading)
    }

    /// Pattern over the strokes with which a channel responds; to be multiplied by the strength.
    #[must_use]
    pub fn response(&self, channel: Channel, shape: f64, stroke: &Stroke, reference: &Reference) -> f64 {
        (self.response)(channel, shape, stroke, reference)
    }
}

impl fmt::Debug for Effect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id.name())
    }
}
