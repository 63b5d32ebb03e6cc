//! Strength envelopes of several straight lines: cones of the lower program, and rows of the upper one.
//!
//! With `p` the mean effective stress (tension positive), such soil bears circles of Mohr of at most the radius `min_k (c_k cos(phi_k) - p
//! sin(phi_k))`. What it dissipates at the dilation `e` and the shear rate `g` is the greatest `p e + R g` over the corners of that, if
//! `e >= g sin(phi)` for the flattest line.

use std::sync::Arc;

use soilctl_certificate::{Material, StrengthLine};

use crate::vector::Point;

/// A straight line that the strength is below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Line {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    pub(crate) cohesion: f64,
}

impl Line {
    fn new(line: StrengthLine) -> Self {
        let (sin, cos) = line.phi_deg.to_radians().sin_cos();
        Self { sin, cos, cohesion: line.cohesion }
    }

    pub(crate) fn tan(&self) -> f64 {
        self.sin / self.cos
    }

    /// Tension at which it bears nothing.
    fn apex(&self) -> f64 {
        self.cohesion / self.tan()
    }

    /// Where this and a flatter line bear the same circle: mean stress and radius.
    fn meets(&self, flatter: &Self) -> Point {
        let more = flatter.cohesion * flatter.cos - self.cohesion * self.cos;
        let mean = -more / (self.sin - flatter.sin);
        [mean, self.cohesion * self.cos - mean * self.sin]
    }

    /// Where this and a flatter line bear the same shear stress: normal and shear stress.
    fn crosses(&self, flatter: &Self) -> Point {
        let normal = -(flatter.cohesion - self.cohesion) / (self.tan() - flatter.tan());
        [normal, self.cohesion - normal * self.tan()]
    }
}

/// What limits the strength of a soil beside its own line.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Envelope {
    /// Lines that lower bounds obey beside it.
    pub(crate) inside: Vec<Line>,
    /// Mean stress and radius of the circles of which one gives the greatest power in an upper bound.
    pub(crate) circles: Arc<[Point]>,
    /// Normal and shear stresses likewise, on planes along which soil slides past something.
    pub(crate) tractions: Arc<[Point]>,
    /// The flattest line of upper bounds, whose friction the flow rule asks for.
    pub(crate) flattest: Line,
}

impl Envelope {
    /// That of a material, if it has one.
    pub(crate) fn of(material: &Material) -> Option<Self> {
        let envelope = material.envelope.as_ref()?;
        let own = StrengthLine { phi_deg: material.phi_deg, cohesion: material.cohesion.at_origin };
        let lines = |lines: &[StrengthLine]| lines.iter().copied().map(Line::new).collect::<Vec<_>>();
        let inside = lines(&envelope.inside);
        let outside = if envelope.outside.is_empty() {
            [vec![Line::new(own)], inside.clone()].concat()
        } else {
            lines(&envelope.outside)
        };
        let (first, flattest) = (*outside.first()?, *outside.last()?);
        let tension = material.tension.filter(|t| *t < first.apex());
        let corners = |lines: &[Line], meets: fn(&Line, &Line) -> Point, cut: fn(&Line, f64) -> Point| {
            let ends = match tension {
                Some(t) => vec![[t, 0.0], cut(&first, t)],
                None => vec![[lines[0].apex(), 0.0]],
            };
            ends.into_iter().chain(lines.windows(2).map(|two| meets(&two[0], &two[1]))).collect()
        };
        let circle = |line: &Line, t: f64| {
            let radius = ((line.cohesion * line.cos - t * line.sin) / (1.0 - line.sin)).max(0.0);
            [t - radius, radius]
        };
        let traction = |line: &Line, t: f64| [t, line.cohesion - t * line.tan()];
        let circles = corners(&touched(&outside), Line::meets, circle);
        let tractions = corners(&outside, Line::crosses, traction);
        Some(Self { inside, circles, tractions, flattest })
    }

    /// The same with a part of all cohesions.
    pub(crate) fn part(&self, part: f64) -> Self {
        let scaled = |points: &[Point]| points.iter().map(|p| p.map(|x| part * x)).collect();
        let line = |line: &Line| Line { cohesion: part * line.cohesion, ..*line };
        Self {
            inside: self.inside.iter().map(line).collect(),
            circles: scaled(&self.circles),
            tractions: scaled(&self.tractions),
            flattest: line(&self.flattest),
        }
    }
}

/// The lines that circles of Mohr touch: where an envelope bends more than the circle below it, none does.
fn touched(lines: &[Line]) -> Vec<Line> {
    let mut kept: Vec<Line> = Vec::new();
    for line in lines {
        while let Some(last) = kept.last() {
            let first = kept.len().checked_sub(2).map_or_else(|| last.apex(), |i| kept[i].meets(last)[0]);
            if last.meets(line)[0] < first {
                break;
            }
            kept.pop();
        }
        kept.push(*line);
    }
    kept
}

/// The greatest power of some stresses, for one unit of the first and the second kind of rate.
pub(crate) fn greatest(stresses: &[Point], first: f64, second: f64) -> f64 {
    stresses.iter().map(|[a, b]| a * first + b * second).fold(f64::NEG_INFINITY, f64::max)
}
