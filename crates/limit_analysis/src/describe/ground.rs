//! What is where: soil, structure or nothing.

use super::arrangement::Arrangement;
use super::error::DescriptionError;
use super::input::Description;
use super::segments::{Cut, Drawing, Owner, Segment};
use crate::vector::{Point, between, cross, distance_to_segment, length};

/// What is at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Occupant {
    Outside,
    Structure(usize),
    Soil {
        region: usize,
        /// Whether it is below the water table.
        submerged: bool,
    },
}

impl Occupant {
    pub(super) fn is_soil(self) -> bool {
        matches!(self, Self::Soil { .. })
    }
}

/// Whether a point is inside a polygon, by the crossings of a ray to the right.
pub(super) fn inside(polygon: &[Point], p: Point) -> bool {
    let mut inside = false;
    let last = polygon.last().into_iter();
    for (a, b) in last.chain(polygon).zip(polygon) {
        if (a[1] > p[1]) != (b[1] > p[1]) {
            let upwards = b[1] > a[1];
            inside ^= (cross(between(*a, *b), between(*a, p)) > 0.0) == upwards;
        }
    }
    inside
}

/// Left and right of an edge, with how far from its middle was looked.
fn beside([a, b]: [Point; 2], by: f64) -> [Point; 2] {
    let along = between(a, b);
    let scale = by / length(along);
    let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let off = [-along[1] * scale, along[0] * scale];
    [[middle[0] + off[0], middle[1] + off[1]], between(off, middle)]
}

/// The edges that matter, with what is on the left and on the right of each.
#[derive(Debug, Clone)]
pub(super) struct Map {
    pub(super) arrangement: Arrangement,
    pub(super) sides: Vec<[Occupant; 2]>,
}

impl Map {
    /// Cuts all segments and drops what does not bound soil.
    pub(super) fn new(
        description: &Description,
        drawing: &Drawing,
        segments: &[Segment],
    ) -> Result<Self, DescriptionError> {
        let title = |owner: Owner| owner_title(description, owner);
        let mut arrangement = Arrangement::new(segments, drawing.snap, &title)?;
        let mut sides = Vec::new();
        for edge in 0..arrangement.edges.len() {
            let at = beside(arrangement.ends(edge), 0.1 * drawing.near);
            sides.push([ground(description, drawing, at[0])?, ground(description, drawing, at[1])?]);
        }
        let is = |edge: usize, wanted: fn(Owner) -> bool| {
            arrangement.edges[edge].uses.iter().any(|(s, _)| wanted(segments[*s].owner))
        };
        let cut = |edge: usize, ground: Occupant| {
            let Occupant::Soil { region, submerged } = ground else { return false };
            arrangement.edges[edge].uses.iter().any(|(s, _)| match segments[*s].owner {
                Owner::Cut(Cut::Water) => submerged,
                Owner::Cut(Cut::Ratio) => description.ratio(region) > 0.0,
                Owner::Cut(Cut::Weight | Cut::Flow) => true,
                _ => false,
            })
        };
        let kept = |edge: usize| {
            let [left, right] = sides[edge];
            let is_line = is(edge, |o| matches!(o, Owner::Plate(_) | Owner::Member(_)));
            let matters = left != right || is_line || cut(edge, left);
            matters && (left.is_soil() || right.is_soil())
        };
        let kept: Vec<bool> = (0..sides.len()).map(kept).collect();
        let mut keep = kept.iter();
        arrangement.edges.retain(|_| *keep.next().unwrap_or(&false));
        let mut keep = kept.iter();
        sides.retain(|_| *keep.next().unwrap_or(&false));
        let map = Self { arrangement, sides };
        map.check_near(drawing, segments, &title)?;
        Ok(map)
    }

    /// Points next to edges that they are not joined to.
    fn check_near(
        &self,
        drawing: &Drawing,
        segments: &[Segment],
        title: &dyn Fn(Owner) -> String,
    ) -> Result<(), DescriptionError> {
        let edges = &self.arrangement.edges;
        let owner = |edge: usize| edges[edge].uses.first().map_or(Owner::Water, |(s, _)| segments[*s].owner);
        let mut corners: Vec<(usize, usize)> =
            edges.iter().enumerate().flat_map(|(e, edge)| edge.ends.map(|p| (p, e))).collect();
        corners.sort_unstable();
        corners.dedup_by_key(|c| c.0);
        for (p, own) in corners {
            let at = self.arrangement.points[p];
            for other in (0..edges.len()).filter(|e| !edges[*e].ends.contains(&p)) {
                if distance_to_segment(at, self.arrangement.ends(other)) < drawing.near {
                    let [first, second] = [own, other].map(|e| title(owner(e)));
                    return Err(DescriptionError::NearlyTouch { first, second, at, least: drawing.near });
                }
            }
        }
        Ok(())
    }
}

impl Description {
    /// Index of a region's soil.
    pub(super) fn soil_of(&self, region: usize) -> usize {
        self.soils.iter().position(|s| s.name == self.regions[region].soil).unwrap_or(0)
    }

    /// Pore pressure ratio of a region's soil.
    pub(super) fn ratio(&self, region: usize) -> f64 {
        self.soils[self.soil_of(region)].pore_pressure_ratio
    }
}

fn ground(description: &Description, drawing: &Drawing, p: Point) -> Result<Occupant, DescriptionError> {
    let mut found =
        drawing.regions.iter().enumerate().filter(|(_, polygon)| inside(polygon, p)).map(|(i, _)| i);
    let region = found.next();
    if let (Some(first), Some(second)) = (region, found.next()) {
        let [first, second] = [first, second].map(|r| description.region_title(r));
        return Err(DescriptionError::Overlap { first, second, at: p });
    }
    if let Some(structure) = drawing.structures.iter().position(|polygon| inside(polygon, p)) {
        return Ok(Occupant::Structure(structure));
    }
    let submerged = drawing.table(p[0]).is_some_and(|y| p[1] < y);
    Ok(region.map_or(Occupant::Outside, |region| Occupant::Soil { region, submerged }))
}

/// How the owner of a segment is called.
pub(super) fn owner_title(description: &Description, owner: Owner) -> String {
    match owner {
        Owner::Region(i) => description.region_title(i),
        Owner::Structure(i) | Owner::Edge(i) => description.structure_title(i),
        Owner::Plate(i) => description.plate_title(i),
        Owner::Boundary(i) => description.boundary_title(i),
        Owner::Member(i) => description.member_title(i),
        Owner::Head(i) => description.head_title(i),
        Owner::Water => "the water table".into(),
        Owner::Cut(Cut::Water) => "the vertical below a point of the water table".into(),
        Owner::Cut(Cut::Ratio) => "the vertical through a corner, needed for pore_pressure_ratio".into(),
        Owner::Cut(Cut::Flow) => "a line along which the pressure of flowing water changes".into(),
        Owner::Cut(Cut::Weight) => "the vertical below a corner, needed where unit weights differ".into(),
    }
}
