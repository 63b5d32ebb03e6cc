//! The only plates that stress fields in space are for.

use crate::CertificateError;
use crate::ends::plate::EndedPlate;
use crate::interval::{Interval, Vector};
use crate::problem::Problem;
use crate::statement::{Condition, Statement};

/// A thin upright plate with ends, moved across its faces, in soil with friction and weight only.
#[derive(Debug)]
pub(super) struct UprightPlate {
    pub(super) phi_deg: f64,
    pub(super) delta_deg: f64,
    pub(super) depth: Interval,
    /// Weight of a unit of volume.
    pub(super) unit_weight: Interval,
    /// Its upper edge.
    pub(super) top: Vector,
    pub(super) half_width: f64,
    pub(super) speed: Interval,
    /// Whether it moves to where x is less: behind is ahead then.
    pub(super) moves_back: bool,
}

pub(super) fn not_covered<T>(place: &str, what: &'static str) -> Result<T, CertificateError> {
    Err(CertificateError::NotCovered { place: place.into(), what })
}

impl UprightPlate {
    /// Reads the plate from a statement.
    ///
    /// # Errors
    ///
    /// [`CertificateError`] if that is not what it states.
    pub(super) fn new(statement: &Statement) -> Result<Self, CertificateError> {
        let problem = Problem::new(statement)?;
        let plate = EndedPlate::new(&problem)?;
        if !plate.down.x.is_zero() {
            return not_covered("the plate", "a stress field in space needs an upright one");
        }
        if !plate.gravity.x.is_zero() {
            return not_covered("gravity", "a stress field in space needs a level surface");
        }
        if !(plate.cohesion.is_zero() && plate.surcharge.is_zero()) {
            let what = "a stress field in space is for weight alone: no cohesion, no surcharge";
            return not_covered("the soil", what);
        }
        let Some(delta_deg) = alike(statement) else {
            let what = "a stress field in space needs faces of one friction, without adhesion";
            return not_covered("the plate", what);
        };
        if !(plate.velocity.y.is_zero() && plate.velocity.x.is_not_zero()) {
            let what = "a stress field in space is for plates that move across their faces";
            return not_covered("the velocity", what);
        }
        Ok(Self {
            phi_deg: plate.material.phi_deg,
            delta_deg,
            depth: -plate.down.y,
            unit_weight: Interval::point(plate.material.unit_weight) * -plate.gravity.y,
            top: plate.top,
            half_width: plate.half_width,
            speed: plate.velocity.x.abs(),
            moves_back: !plate.velocity.x.is_positive(),
        })
    }
}

/// The friction of the plate's faces, if it is one and they have no adhesion.
fn alike(statement: &Statement) -> Option<f64> {
    let faces = statement.boundaries.iter().filter_map(|boundary| match boundary.condition {
        Condition::Face { delta_deg, adhesion } => Some([delta_deg, adhesion]),
        _ => None,
    });
    let all: Vec<[f64; 2]> = faces.collect();
    let first = *all.first()?;
    (first[1] == 0.0 && all.iter().all(|face| *face == first)).then_some(first[0])
}
