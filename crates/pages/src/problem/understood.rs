//! What a problem was understood to mean, as data for a page that draws it itself: the same facts as in the drawing.

use serde::Serialize;
use soilctl_app::solve::BoundaryKind;
use soilctl_limit_analysis::results::Point;

use super::{Load, Scene};

/// What is drawn of a problem beside what its file says word for word, in m and kPa. Sides are walked with the soil on the left.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Understood {
    /// The outline of the soil, piece by piece.
    pub sides: Vec<UnderstoodSide>,
    /// Loads on sides.
    pub loads: Vec<UnderstoodLoad>,
    /// Pressure on all free sides.
    pub surcharge: f64,
    /// The water table over the whole width, or the level of open water.
    pub table: Vec<Vec<Point>>,
    /// The free surface of water that flows, in pieces.
    pub free_surface: Vec<Vec<Point>>,
    /// Open water above the ground.
    pub ponds: Vec<Vec<Point>>,
    /// From where the structure moves whose force is bounded, and in which direction, of length one.
    pub motion: Option<[Point; 2]>,
    /// Accelerations: words, and the direction in which they push the soil.
    pub shaking: Vec<(String, Point)>,
}

/// A piece of the outline.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UnderstoodSide {
    /// Its ends.
    pub ends: [Point; 2],
    /// What holds there.
    pub kind: BoundaryKind,
}

/// A load along a straight side.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct UnderstoodLoad {
    /// The ends of the side.
    pub ends: [Point; 2],
    /// Pressure at both ends.
    pub pressure: [f64; 2],
    /// Shear stress on the soil along the side, at both ends.
    pub shear: [f64; 2],
    /// Whether its factor is what is bounded.
    pub live: bool,
}

impl Scene {
    /// The same as data.
    pub(crate) fn understood(self) -> Understood {
        let load = |Load { ends, pressure, shear, live }| UnderstoodLoad { ends, pressure, shear, live };
        Understood {
            sides: self.sides.into_iter().map(|(ends, kind)| UnderstoodSide { ends, kind }).collect(),
            loads: self.loads.into_iter().map(load).collect(),
            surcharge: self.surcharge,
            table: self.table,
            free_surface: self.free_surface,
            ponds: self.ponds,
            motion: self.motion.map(|(_, from, to)| [from, to]),
            shaking: self.shaking,
        }
    }
}
