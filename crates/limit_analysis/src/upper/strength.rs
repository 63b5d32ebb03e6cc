//! What soil with friction dissipates.
//!
//! Strain with the dilation `e` and the shear rate `g` dissipates at most `c cot(phi) e`. A greatest tension `t` below that
//! of the cone's apex makes it at most `t e + Q max(g - e, 0)`, with `Q` the radius of Mohr's circle where both limits meet.
//! The water in the pores adds `-u e`.

use std::sync::Arc;

use crate::envelope::greatest;
use crate::problem::Soil;
use crate::vector::Point;

/// Which limit counts. Of apex and tension not both: the bound is the lesser one for a whole triangle or edge.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Limit {
    Apex,
    Tension(f64),
    /// The circles of an envelope, of which one gives the greatest power at each corner.
    Envelope(Arc<[Point]>),
}

impl Limit {
    /// The lower limit around some points.
    pub(crate) fn around(soil: &Soil, points: &[Point]) -> Self {
        if let Some(envelope) = &soil.envelope {
            return Self::Envelope(Arc::clone(&envelope.circles));
        }
        let cohesion: f64 = points.iter().map(|p| soil.cohesion.at(*p)).sum();
        match soil.cut_off {
            Some(t) if t * points.len() as f64 <= cohesion / soil.tan => Self::Tension(t),
            _ => Self::Apex,
        }
    }

    /// Factor on the dilation, without what the water does.
    pub(crate) fn tension(&self, soil: &Soil, p: Point) -> f64 {
        match self {
            Self::Apex => soil.tension(p),
            Self::Tension(t) => *t,
            Self::Envelope(_) => 0.0,
        }
    }

    /// Factor on [`Self::beyond`].
    pub(crate) fn radius(&self, soil: &Soil, p: Point) -> f64 {
        match self {
            Self::Apex => 0.0,
            Self::Tension(t) => ((soil.cohesion.at(p) * soil.cos - t * soil.sin) / (1.0 - soil.sin)).max(0.0),
            Self::Envelope(_) => 1.0,
        }
    }

    /// What dissipates beside the dilation, from that and the shear rate: what the one is above the other; of an envelope all power.
    pub(crate) fn beyond(&self, dilation: f64, shearing: f64) -> f64 {
        match self {
            Self::Apex | Self::Tension(_) => (shearing - dilation).max(0.0),
            Self::Envelope(circles) => greatest(circles, dilation, shearing),
        }
    }
}

/// Factors on three values at the corners of a triangle that give three times the mean of the linear function between
/// them times another one.
pub(super) fn over_triangle(a: [f64; 3]) -> [f64; 3] {
    let more = a.map(|x| x - a[0]);
    more.map(|x| a[0] + 0.25 * (more[0] + more[1] + more[2] + x))
}

/// The same for the Bernstein coefficients of a quadratic polynomial along an edge, and a linear function given at the
/// ends.
pub(super) fn over_edge([from, to]: [f64; 2]) -> [f64; 3] {
    let more = to - from;
    [from + 0.25 * more, from + 0.5 * more, from + 0.75 * more]
}
