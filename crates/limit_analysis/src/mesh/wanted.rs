//! The wanted size, at any point.

use super::MeshError;
use super::domain::Domain;
use super::fan::Disc;
use crate::vector::{Point, distance};

/// How much the wanted size may grow per unit of distance: 30 % from element to element.
pub(super) const GROWTH: f64 = 0.3;

/// Smallest size that is worked with, in least distances. It keeps vertices apart by much more than rounding.
const FINEST: f64 = 30.0;

/// The wanted size as the user gives it, and how many triangles are allowed.
pub(super) struct Wanted<'a> {
    pub(super) size: &'a dyn Fn(Point) -> f64,
    /// Bounds on the size: what can be resolved, and the extent of the outline.
    pub(super) range: [f64; 2],
    pub(super) max_triangles: usize,
    /// Centre and radius of each fan, and length of its outer edges.
    fans: Vec<(Point, f64, f64)>,
}

impl<'a> Wanted<'a> {
    pub(super) fn new(
        size: &'a dyn Fn(Point) -> f64,
        domain: &Domain,
        discs: &[Disc],
        max_triangles: usize,
    ) -> Result<Self, MeshError> {
        let range = [FINEST * domain.least, distance(domain.frame[0], domain.frame[2])];
        let mut wanted = Self { size, range, max_triangles, fans: Vec::new() };
        let mut triangles = 0;
        for (fan, disc) in discs.iter().enumerate() {
            let (count, chord) = disc.extent();
            triangles += count;
            wanted.allow(triangles)?;
            if chord < range[0] {
                let what = "the length of its outer edges, after making room for other lines,";
                let allowed = "at least 3e-8 of the outline's extent";
                return Err(MeshError::BadFan { fan, what, value: chord, allowed });
            }
            wanted.fans.push((disc.centre, disc.radius, chord));
        }
        Ok(wanted)
    }

    /// The wanted size at a point.
    pub(super) fn at(&self, p: Point) -> Result<f64, MeshError> {
        let size = (self.size)(p);
        if size.is_nan() || size <= 0.0 {
            return Err(MeshError::BadSize { x: p[0], y: p[1], size });
        }
        // Elements around a fan fit to its outer edges, which are not split.
        let grown =
            |&(centre, radius, _): &(Point, f64, f64)| GROWTH * (distance(centre, p) - radius).max(0.0);
        let least = self.fans.iter().map(|f| f.2 - grown(f)).fold(self.range[0], f64::max);
        let most = self.fans.iter().map(|f| f.2 + grown(f)).fold(self.range[1], f64::min);
        Ok(size.max(least).min(most).clamp(self.range[0], self.range[1]))
    }

    /// Refuses more triangles than are allowed.
    pub(super) fn allow(&self, count: usize) -> Result<(), MeshError> {
        let limit = self.max_triangles;
        if count > limit { Err(MeshError::TooManyTriangles { count, limit }) } else { Ok(()) }
    }
}
