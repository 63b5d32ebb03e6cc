//! Points and vectors in space.

use std::ops::{Add, Sub};

use super::plate::EndedPlate;
use crate::CertificateError;
use crate::fields::Position;
use crate::interval::{Interval, Vector};
use crate::problem::finite;

/// A vector in space: x and z in the plane of the statement, y across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spatial {
    pub(super) x: Interval,
    pub(super) y: Interval,
    pub(super) z: Interval,
}

impl Spatial {
    pub(super) const ZERO: Self = Self { x: Interval::ZERO, y: Interval::ZERO, z: Interval::ZERO };

    /// Exactly the vector with these components.
    pub(super) fn point([x, y, z]: [f64; 3]) -> Self {
        Self { x: x.into(), y: y.into(), z: z.into() }
    }

    /// A vector in the plane of the statement.
    pub(super) fn in_plane(v: Vector) -> Self {
        Self { x: v.x, y: Interval::ZERO, z: v.y }
    }

    pub(super) fn dot(self, other: Self) -> Interval {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub(super) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    /// Square of the length.
    pub(super) fn square(self) -> Interval {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// Whether it is zero and nothing else.
    pub(super) fn is_zero(self) -> bool {
        self.x.is_zero() && self.y.is_zero() && self.z.is_zero()
    }
}

impl Add for Spatial {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl Sub for Spatial {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

/// A vertex, and the planes on which it lies exactly.
#[derive(Debug, Clone, Copy)]
pub(super) struct Corner {
    pub(super) at: Spatial,
    pub(super) on_surface: bool,
    /// Where it is in the plate's plane, if it is there: distance down the plate over its length, distance across.
    pub(super) on_plate: Option<[f64; 2]>,
    pub(super) on_symmetry: bool,
}

impl Corner {
    /// Places a vertex, which must lie in the soil on the side of the plane of symmetry where y is positive.
    pub(super) fn new(
        plate: &EndedPlate,
        index: usize,
        position: Position,
    ) -> Result<Self, CertificateError> {
        let place = || format!("vertex {index}");
        let (numbers, y) = match position {
            Position::Inside([x, y, z]) => ([x, y, z], y),
            Position::Surface([x, y]) | Position::Plate([x, y]) => ([x, y, 0.0], y),
        };
        numbers.into_iter().try_for_each(|number| finite("coordinate", place, number, "length"))?;
        let in_soil = match position {
            Position::Inside([_, _, z]) => z < plate.datum,
            Position::Surface(_) => true,
            Position::Plate([s, _]) => s >= 0.0,
        };
        if !in_soil || y < 0.0 {
            let problem =
                "must be in the soil, where y is at least zero, and on the surface only by its kind";
            return Err(CertificateError::BadField { place: place(), problem });
        }
        let across = Interval::point(y);
        let at = match position {
            Position::Inside(at) => Spatial::point(at),
            Position::Surface([x, _]) => Spatial { x: x.into(), y: across, z: plate.datum.into() },
            Position::Plate([s, _]) => {
                let at = plate.top + plate.down * Interval::point(s);
                Spatial { x: at.x, y: across, z: at.y }
            }
        };
        let (on_surface, on_plate) = match position {
            Position::Inside(_) => (false, None),
            Position::Surface(_) => (true, None),
            Position::Plate([s, y]) => (s == 0.0, Some([s, y])),
        };
        Ok(Self { at, on_surface, on_plate, on_symmetry: y == 0.0 })
    }
}
