//! Strength envelopes of several straight lines.
//!
//! A line of the friction angle `phi` and the cohesion `c` bears, at the mean effective stress `p` (tension positive), circles of Mohr of
//! the radius `a - b p` with `a = c cos(phi)` and `b = sin(phi)`; several lines bear the least of these.

use crate::CertificateError;
use crate::interval::{Angle, Interval, angle};
use crate::statement::{self, Material, StrengthLine};

/// A straight line that strength is below.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Straight {
    pub(crate) friction: Angle,
    pub(crate) cohesion: Interval,
}

/// Lines that limit the strength, steepest first.
#[derive(Debug, Clone)]
pub(crate) struct Envelope {
    /// Those of the strength that lower bounds obey, beside that of the material's own friction and cohesion.
    pub(crate) inside: Vec<Straight>,
    /// All those of the strength of upper bounds. Never empty.
    pub(crate) outside: Vec<Straight>,
    /// Those of them that circles of Mohr touch.
    pub(crate) touched: Vec<Straight>,
}

/// A stress at which lines meet: a mean effective stress, tension positive, and the radius of Mohr's circle; or a normal stress and the
/// shear stress beside it.
pub(crate) type StressPoint = (Interval, Interval);

impl Straight {
    fn new(line: StrengthLine) -> Self {
        Self { friction: angle(line.phi_deg), cohesion: Interval::point(line.cohesion) }
    }

    /// The radius at a mean effective stress.
    fn radius(&self, mean: Interval) -> Interval {
        self.cohesion * self.friction.cos - self.friction.sin * mean
    }

    /// Where the radius is zero.
    pub(crate) fn apex(&self) -> Interval {
        self.friction.cot_times(self.cohesion)
    }

    /// Where this and a flatter line bear the same circle.
    pub(crate) fn meets(&self, flatter: &Self) -> StressPoint {
        let more = flatter.cohesion * flatter.friction.cos - self.cohesion * self.friction.cos;
        let mean = -more / (self.friction.sin - flatter.friction.sin);
        (mean, self.radius(mean))
    }

    /// Where this and a flatter line bear the same shear stress: the normal stress, tension positive, and the shear stress.
    pub(crate) fn crosses(&self, flatter: &Self) -> StressPoint {
        let tan = self.friction.tan();
        let normal = -(flatter.cohesion - self.cohesion) / (tan - flatter.friction.tan());
        (normal, self.cohesion - tan * normal)
    }
}

/// The lines that circles of Mohr touch: where an envelope bends more than the circle below it, none does. Any of them bound what soil
/// bears, so which are chosen matters for tightness only.
fn touched(lines: &[Straight]) -> Vec<Straight> {
    let mut kept: Vec<Straight> = Vec::new();
    for line in lines {
        while let Some(last) = kept.last() {
            let first = kept.len().checked_sub(2).map_or_else(|| last.apex(), |i| kept[i].meets(last).0);
            if last.meets(line).0.middle() < first.middle() {
                break;
            }
            kept.pop();
        }
        kept.push(*line);
    }
    kept
}

/// The line of a material's own friction angle and cohesion.
fn own(material: &Material) -> StrengthLine {
    StrengthLine { phi_deg: material.phi_deg, cohesion: material.cohesion.at_origin }
}

impl Envelope {
    pub(crate) fn new(material: &Material, envelope: &statement::Envelope) -> Self {
        let inside: Vec<Straight> = envelope.inside.iter().copied().map(Straight::new).collect();
        let outside: Vec<Straight> = if envelope.outside.is_empty() {
            let own = Straight::new(own(material));
            std::iter::once(own).chain(inside.iter().copied()).collect()
        } else {
            envelope.outside.iter().copied().map(Straight::new).collect()
        };
        Self { touched: touched(&outside), inside, outside }
    }
}

/// Checks that the lines are in order, and the outer ones nowhere below the inner ones.
pub(super) fn check(material: &Material, place: impl Fn() -> String) -> Result<(), CertificateError> {
    let Some(envelope) = &material.envelope else { return Ok(()) };
    let bad = |problem| Err(CertificateError::BadStatement { place: place(), problem });
    if material.phi_deg == 0.0 || material.cohesion.gradient != [0.0; 2] {
        return bad(
            "an envelope needs a friction angle above zero and a cohesion that is the same everywhere",
        );
    }
    let inside: Vec<StrengthLine> =
        std::iter::once(own(material)).chain(envelope.inside.iter().copied()).collect();
    let falls = |lines: &[StrengthLine]| lines.windows(2).all(|two| two[0].phi_deg > two[1].phi_deg);
    let corners = corners(&inside);
    let are_in_order =
        |corners: &[StressPoint]| corners.windows(2).all(|two| (two[0].0 - two[1].0).is_positive());
    if !(falls(&inside) && are_in_order(&corners)) {
        return bad("each line of an envelope must be flatter than the one before, and the lowest somewhere");
    }
    if envelope.outside.is_empty() {
        return Ok(());
    }
    if !(falls(&envelope.outside) && are_in_order(&self::corners(&envelope.outside))) {
        return bad(
            "each outer line of an envelope must be flatter than the one before, and the lowest somewhere",
        );
    }
    let flattest = inside.last().map_or(0.0, |line| line.phi_deg);
    for outer in &envelope.outside {
        let line = Straight::new(*outer);
        let is_above = |(normal, shear): &StressPoint| {
            (line.cohesion - line.friction.tan() * *normal - *shear).is_at_least_zero()
        };
        if outer.phi_deg < flattest || !corners.iter().all(is_above) {
            return bad("the outer lines of an envelope must be nowhere below the inner ones");
        }
    }
    Ok(())
}

/// Where lines that follow each other bear the same shear stress; first, where the first ends.
fn corners(lines: &[StrengthLine]) -> Vec<StressPoint> {
    let lines: Vec<Straight> = lines.iter().copied().map(Straight::new).collect();
    let apex = lines.first().map(|line| (line.apex(), Interval::ZERO));
    apex.into_iter().chain(lines.windows(2).map(|two| two[0].crosses(&two[1]))).collect()
}
