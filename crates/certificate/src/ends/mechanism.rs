//! An upper bound by rigid blocks in translation.
//!
//! Let `V_b` be the velocity of block `b`, and its facets a closed triangulated surface, each facet with the area vector
//! `N` outwards. The surface has a winding number `k_b` around each point, and `v = sum k_b V_b` is a velocity field of
//! bounded variation in the soil: it jumps by `-V_b` across facets beyond which soil is at rest, by `V_c - V_b` across
//! those shared with block `c`. For a statically admissible stress `s` virtual work needs nothing else,
//!
//! ```text
//! F . V  =  sum over facets of  s N . [v]  +  the plate's faces  -  W
//! ```
//!
//! so blocks need not be convex, nor apart from each other: where they overlap, their velocities add, and a sum of jumps
//! that obey the flow rule obeys it. Each jump does if `[v] . N >= |[v]| |N| sin(phi)`, and dissipates `c cot(phi) [v] . N`
//! at most. What is checked of the geometry is that
//!
//! - all vertices lie in the soil, and no block reaches from one side of the plate's plane to the other;
//! - facets close up around each block: each edge is walked as often in one sense as in the other;
//! - facets in the surface, in the plate's plane and in the plane of symmetry are named as such, and no others;
//! - those at one face of the plate cover it once, or there are none and the soil there is at rest.
//!
//! The mechanism is mirrored at y = 0. There the velocity across jumps by twice its part `V_y`, which must open.

use super::chain::{Edges, goes_around};
use super::flow_rule::opened;
use super::plate::EndedPlate;
use super::position::{Corner, Spatial};
use crate::CertificateError;
use crate::fields::{BeyondFacet, Facet, Mechanism};
use crate::interval::{Interval, Vector};
use crate::problem::{Problem, exists, finite};
use crate::statement::Statement;

/// Proves an upper bound on the force that the soil can resist times the structure's velocity, per unit width of a
/// structure that has ends.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a plate of finite width, if the facets are not built as they must be, or
/// if the blocks are not proven to move as the soil allows.
pub fn prove_mechanism(statement: &Statement, mechanism: &Mechanism) -> Result<f64, CertificateError> {
    let problem = Problem::new(statement)?;
    let plate = EndedPlate::new(&problem)?;
    let blocks = Blocks::new(&plate, mechanism)?;
    let mut power = blocks.at_faces()?;
    for index in 0..mechanism.facets.len() {
        power = power + blocks.facet(index)?;
    }
    let bound = (power / Interval::point(plate.half_width)).hi();
    if bound < f64::INFINITY {
        return Ok(bound);
    }
    Err(CertificateError::NotProven {
        quantity: "difference of the largest number and the bound",
        place: "the whole mechanism".into(),
        low: f64::NEG_INFINITY,
        unit: "force*velocity",
    })
}

/// Where the vertices of a mechanism are, rounded: x, y across and z. Nothing is proven.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a plate of finite width, or a vertex is not in its soil.
pub fn show_mechanism(
    statement: &Statement,
    mechanism: &Mechanism,
) -> Result<Vec<[f64; 3]>, CertificateError> {
    let problem = Problem::new(statement)?;
    let plate = EndedPlate::new(&problem)?;
    let corners = mechanism.vertices.iter().enumerate().map(|(i, p)| Corner::new(&plate, i, *p));
    corners.map(|corner| corner.map(|c| [c.at.x, c.at.y, c.at.z].map(Interval::middle))).collect()
}

/// A mechanism whose blocks are closed, each on one side of the plate.
struct Blocks<'a> {
    plate: &'a EndedPlate<'a>,
    mechanism: &'a Mechanism,
    corners: Vec<Corner>,
    velocities: Vec<Spatial>,
    /// For each block, the side of the way down the plate: 0 left, 1 right.
    sides: Vec<usize>,
}

fn bad<T>(place: String, problem: &'static str) -> Result<T, CertificateError> {
    Err(CertificateError::BadField { place, problem })
}

impl<'a> Blocks<'a> {
    fn new(plate: &'a EndedPlate<'a>, mechanism: &'a Mechanism) -> Result<Self, CertificateError> {
        let corners: Vec<Corner> = mechanism
            .vertices
            .iter()
            .enumerate()
            .map(|(i, position)| Corner::new(plate, i, *position))
            .collect::<Result<_, _>>()?;
        for (i, velocity) in mechanism.velocities.iter().enumerate() {
            velocity.iter().try_for_each(|v| finite("velocity", || format!("block {i}"), *v, ""))?;
        }
        let at_side = |(i, corner): (usize, &Corner)| side_of(plate, corner, || format!("vertex {i}"));
        let corner_sides: Vec<Option<usize>> =
            corners.iter().enumerate().map(at_side).collect::<Result<_, _>>()?;
        let count = mechanism.velocities.len();
        let mut edges: Vec<Edges> = (0..count).map(|_| Edges::default()).collect();
        let mut sides: Vec<Option<usize>> = vec![None; count];
        for (i, facet) in mechanism.facets.iter().enumerate() {
            let place = || format!("facet {i}");
            facet.corners.iter().try_for_each(|&c| exists(place, "vertex", c, corners.len()))?;
            exists(place, "block", facet.block, count)?;
            check_plane(facet, facet.corners.map(|c| corners[c]), place)?;
            edges[facet.block].add(facet.corners, true);
            let mut owners = vec![facet.block];
            if let BeyondFacet::Block(other) = facet.beyond {
                exists(place, "block", other, count)?;
                edges[other].add(facet.corners, false);
                owners.push(other);
            }
            for block in owners {
                let mut off_plate = facet.corners.iter().filter_map(|&c| corner_sides[c]);
                if off_plate.any(|side| *sides[block].get_or_insert(side) != side) {
                    return bad(format!("block {block}"), "lies on both sides of the plate's plane");
                }
            }
        }
        if let Some(open) = edges.iter().position(|edges| !edges.is_closed()) {
            return bad(format!("block {open}"), "its facets do not close up");
        }
        let velocities = mechanism.velocities.iter().map(|v| Spatial::point(*v)).collect();
        // A block without a side has no volume.
        let sides = sides.into_iter().map(|side| side.unwrap_or(0)).collect();
        Ok(Self { plate, mechanism, corners, velocities, sides })
    }

    /// What slip at the faces of the plate dissipates where the soil is at rest. Checks that blocks cover each of the
    /// faces once, or not at all.
    fn at_faces(&self) -> Result<Interval, CertificateError> {
        let mut power = Interval::ZERO;
        for (side, name) in ["the face on the left", "the face on the right"].into_iter().enumerate() {
            let at_face = |f: &&Facet| f.beyond == BeyondFacet::Plate && self.sides[f.block] == side;
            let mut facets = self.mechanism.facets.iter().filter(at_face).peekable();
            if facets.peek().is_none() {
                let down = Spatial::in_plane(self.plate.down);
                let across = Spatial { y: Interval::point(self.plate.half_width), ..Spatial::ZERO };
                let outwards = if side == 0 { across.cross(down) } else { down.cross(across) };
                power = power + self.face(side, Spatial::ZERO, outwards, || name.to_owned())?;
                continue;
            }
            let mut edges = Edges::default();
            // Seen from the soil on the left, the way down and the way across turn clockwise.
            facets.for_each(|facet| edges.add(facet.corners, side == 1));
            let place = |c: usize| self.corners[c].on_plate.unwrap_or([f64::NAN; 2]);
            let rim: Vec<[[f64; 2]; 2]> = edges.rim().map(|edge| edge.map(place)).collect();
            if !goes_around(&rim, self.plate.half_width) {
                return bad(name.into(), "facets must cover it once");
            }
        }
        Ok(power)
    }

    /// What a facet adds to dissipation less power of the loads. Checks the flow rule.
    fn facet(&self, index: usize) -> Result<Interval, CertificateError> {
        let facet = &self.mechanism.facets[index];
        let place = || format!("facet {index}");
        let velocity = self.velocities[facet.block];
        let [a, b, c] = facet.corners.map(|c| self.corners[c].at);
        let outwards = (b - a).cross(c - a);
        let outwards = Spatial { x: outwards.x.half(), y: outwards.y.half(), z: outwards.z.half() };
        let plate = self.plate;
        let soil = |jump: Spatial| {
            opened(jump, outwards, plate.soil.friction, place)
                .map(|volume| plate.soil.friction.cot_times(plate.cohesion) * volume)
        };
        let dissipated = match facet.beyond {
            BeyondFacet::Rest => soil(Spatial::ZERO - velocity)?,
            BeyondFacet::Block(other) => {
                let across = self.velocities[other];
                // The volume of the other block is walked backwards.
                return Ok(soil(across - velocity)?
                    - self.work(across, [a, c, b])
                    - self.work(velocity, [a, b, c]));
            }
            // The other half is the mirror image's.
            BeyondFacet::Symmetry => {
                let two = Interval::point(2.0);
                let mirrored = Spatial { y: -(two * velocity.y), ..Spatial::ZERO };
                soil(mirrored)?.half()
            }
            // The surcharge presses down on what rises.
            BeyondFacet::Surface => plate.surcharge * velocity.dot(outwards),
            BeyondFacet::Plate => {
                self.check_turn(facet, place)?;
                self.face(self.sides[facet.block], velocity, outwards, place)?
            }
        };
        Ok(dissipated - self.work(velocity, [a, b, c]))
    }

    /// Power of the weight on the tetrahedron between the plate's top and a facet, moving with `velocity`.
    fn work(&self, velocity: Spatial, [a, b, c]: [Spatial; 3]) -> Interval {
        let from = Spatial::in_plane(self.plate.top);
        let volume_by_6 = (a - from).dot((b - from).cross(c - from));
        let falls = Spatial::in_plane(self.plate.gravity).dot(velocity)
            * Interval::point(self.plate.material.unit_weight);
        volume_by_6 * falls / Interval::point(6.0)
    }

    /// What slip and opening between soil and plate dissipate.
    fn face(
        &self,
        side: usize,
        velocity: Spatial,
        outwards: Spatial,
        place: impl Fn() -> String,
    ) -> Result<Interval, CertificateError> {
        let face = self.plate.faces[side];
        let jump = Spatial::in_plane(self.plate.velocity) - velocity;
        Ok(face.friction.cot_times(face.adhesion) * opened(jump, outwards, face.friction, place)?)
    }

    /// Checks that a facet at a face of the plate turns the right way, as the plate's sides alone tell.
    fn check_turn(&self, facet: &Facet, place: impl Fn() -> String) -> Result<(), CertificateError> {
        let [a, b, c] = facet.corners.map(|c| {
            let [s, y] = self.corners[c].on_plate.unwrap_or([f64::NAN; 2]);
            Vector { x: Interval::point(s), y: Interval::point(y) }
        });
        let area = (b - a).cross(c - a);
        let area = if self.sides[facet.block] == 1 { area } else { -area };
        if area.is_positive() { Ok(()) } else { bad(place(), "at the plate, it must turn its back to it") }
    }
}

/// Checks that a facet is said to be in one of the three planes if it is there.
fn check_plane(
    facet: &Facet,
    corners: [Corner; 3],
    place: impl Fn() -> String,
) -> Result<(), CertificateError> {
    let all = |is: fn(&Corner) -> bool| corners.iter().all(is);
    let found = [
        (BeyondFacet::Surface, all(|c| c.on_surface)),
        (BeyondFacet::Plate, all(|c| c.on_plate.is_some())),
        (BeyondFacet::Symmetry, all(|c| c.on_symmetry)),
    ];
    if found.into_iter().all(|(beyond, is)| is == (facet.beyond == beyond)) {
        return Ok(());
    }
    bad(
        place(),
        "facets in the surface, the plate's plane and the plane of symmetry are named so, and no others",
    )
}

/// The side of the way down the plate on which a vertex lies; none in its plane.
fn side_of(
    plate: &EndedPlate,
    corner: &Corner,
    place: impl Fn() -> String,
) -> Result<Option<usize>, CertificateError> {
    if corner.on_plate.is_some() {
        return Ok(None);
    }
    let at = Vector { x: corner.at.x, y: corner.at.z };
    let left = plate.down.cross(at - plate.top);
    match (left.is_positive(), (-left).is_positive()) {
        (true, _) => Ok(Some(0)),
        (_, true) => Ok(Some(1)),
        _ => bad(place(), "is not proven to be off the plate's plane, nor said to be in it"),
    }
}
