//! Fields in plain numbers, for tables and pictures: what the proofs look at, without a proof.

use crate::CertificateError;
use crate::fields::{LowerField, UpperField};
use crate::interval::{Interval, Vector};
use crate::lower::element::NodeStresses;
use crate::lower::{SectionForces, node_stresses};
use crate::mesh::Side;
use crate::problem::finite;
use crate::statement::{Condition, LineUse, Statement};
use crate::tiling::{Beyond, Tiling};
use crate::upper::piece_velocities;

/// What an edge of a triangle adjoins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Adjoins {
    /// The edge of another triangle, with the same vertices.
    Soil(Side),
    /// A boundary.
    Boundary {
        /// The side of a line.
        side: LineUse,
        /// Fractions of the line at which the edge starts and ends, walked with the triangle on the left.
        ends: [f64; 2],
        /// What holds there.
        condition: Condition,
    },
}

/// A stress field in plain numbers. Edge `k` of a triangle lies opposite to corner `k`.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownStress {
    /// Corners of each triangle, counter-clockwise.
    pub corners: Vec<[[f64; 2]; 3]>,
    /// What the edges of each triangle adjoin.
    pub adjoins: Vec<[Adjoins; 3]>,
    /// Total stresses `[xx, yy, xy]`, tension positive, in units of the statement. Each triangle has three parts, in which
    /// they are linear: part `k` lies at edge `k`, its nodes are corner `k + 1`, corner `k + 2` and the centroid.
    pub parts: Vec<[[[f64; 3]; 3]; 3]>,
    /// Axial forces of members, tension positive: an entry for each edge, one member after the other, from start to end.
    pub members: Vec<ShownMember>,
}

/// What there is along a triangle edge on a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShownMember {
    /// Index of the member.
    pub member: usize,
    /// Start and end of the edge, as the member goes.
    pub ends: [[f64; 2]; 2],
    /// A quadratic polynomial along it, as Bernstein coefficients: of the axial force, or of the member's velocity along itself.
    pub along: [f64; 3],
    /// What a beam does across itself, or how bars slip in the soil.
    pub across: Option<ShownAcross>,
}

/// What a beam does across itself along a triangle edge, or how bars slip there: Bernstein coefficients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShownAcross {
    /// In a stress field: cubic and quadratic.
    Forces {
        /// Bending moment.
        moment: [f64; 4],
        /// Shear force.
        shear: [f64; 3],
    },
    /// In a flow, its velocity to its left: quadratic. The beam yields where the slope of this changes.
    Velocity([f64; 3]),
    /// In a flow, how much faster bars of a row move along themselves than the soil at them, where that holds on to them: quadratic.
    Slip([f64; 3]),
}

/// A flow in plain numbers. Edge `k` of a triangle lies opposite to corner `k`.
#[derive(Debug, Clone, PartialEq)]
pub struct ShownFlow {
    /// Corners of each triangle, counter-clockwise.
    pub corners: Vec<[[f64; 2]; 3]>,
    /// What the edges of each triangle adjoin.
    pub adjoins: Vec<[Adjoins; 3]>,
    /// The pieces of each triangle on which the velocity is a polynomial: one, or three for soil without friction, piece
    /// `k` at edge `k`.
    pub pieces: Vec<Vec<FlowPiece>>,
    /// Velocities of members along themselves, likewise. Where these grow, it stretches, also from one edge to the next.
    pub members: Vec<ShownMember>,
}

/// A quadratic velocity on a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlowPiece {
    /// Corners of the triangle, counter-clockwise. Of a piece of three, the last is the centroid.
    pub corners: [[f64; 2]; 3],
    /// Bernstein coefficients `sum_i l_i^2 b_i + sum_{i<j} 2 l_i l_j b_ij` in barycentric coordinates: at corners 0, 1, 2,
    /// then on edges 0, 1, 2.
    pub control: [[f64; 2]; 6],
}

/// The stresses of a field that proves a lower bound, to about the last digits of double precision.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem, if the field is not built as it must be, or if a stress is
/// too large for a number. Whether the soil bears the stresses is not checked.
pub fn show_stress(statement: &Statement, field: &LowerField) -> Result<ShownStress, CertificateError> {
    node_stresses(statement, field, |tiling, stresses, of_members| {
        let plain = |triangle: usize, nodes: NodeStresses| -> Result<_, CertificateError> {
            let parts = nodes.map(|part| part.map(|s| [s.xx, s.yy, s.xy].map(|x| x.middle())));
            for x in parts.iter().flatten().flatten() {
                finite("stress", || format!("triangle {triangle}"), *x, "stress")?;
            }
            Ok(parts)
        };
        let parts = stresses.into_iter().enumerate().map(|(t, nodes)| plain(t, nodes));
        Ok(ShownStress {
            corners: corners(tiling),
            adjoins: adjoins(tiling),
            parts: parts.collect::<Result<_, _>>()?,
            members: members(
                tiling,
                of_members?.into_iter().map(forces).collect(),
                "force in a member",
                "force",
            )?,
        })
    })?
}

/// The velocities of a field that proves an upper bound, to about the last digits of double precision.
///
/// # Errors
///
/// [`CertificateError`] if the statement is not a problem, if the field is not built as it must be, or if a velocity is
/// too large for a number. Whether the soil can flow like this is not checked.
pub fn show_flow(statement: &Statement, field: &UpperField) -> Result<ShownFlow, CertificateError> {
    piece_velocities(statement, field, |tiling, all, along| {
        let mut pieces = Vec::with_capacity(all.len());
        for (triangle, found) in all.into_iter().enumerate() {
            let found = found.into_iter().map(|(corners, control)| FlowPiece {
                corners: corners.map(plain),
                control: control.map(plain),
            });
            let found: Vec<FlowPiece> = found.collect();
            for x in found.iter().flat_map(|p| p.control).flatten() {
                finite("velocity", || format!("triangle {triangle}"), x, "velocity")?;
            }
            pieces.push(found);
        }
        let velocities =
            along?.into_iter().zip(tiling.along_members()).map(|([along, across, slip], edge)| {
                let member = &statement.members[edge.member()];
                let velocity = || ShownAcross::Velocity(across.map(Interval::middle));
                let slips = || ShownAcross::Slip(slip.map(Interval::middle));
                let bent = member.bending.is_some().then(velocity);
                (along, bent.or_else(|| member.pullout.is_some().then(slips)))
            });
        let members = members(tiling, velocities.collect(), "velocity of a member", "velocity")?;
        Ok(ShownFlow { corners: corners(tiling), adjoins: adjoins(tiling), pieces, members })
    })?
}

/// What there is on the edges of members, given for each.
fn members(
    tiling: &Tiling,
    all: Vec<([Interval; 3], Option<ShownAcross>)>,
    quantity: &'static str,
    unit: &'static str,
) -> Result<Vec<ShownMember>, CertificateError> {
    let mut shown = Vec::with_capacity(all.len());
    for (edge, (along, across)) in tiling.along_members().into_iter().zip(all) {
        let ends = tiling.ends_on_member(&edge).map(plain);
        let along = along.map(Interval::middle);
        let numbers = match across {
            None => Vec::new(),
            Some(ShownAcross::Forces { moment, shear }) => moment.into_iter().chain(shear).collect(),
            Some(ShownAcross::Velocity(velocity) | ShownAcross::Slip(velocity)) => velocity.to_vec(),
        };
        for x in along.into_iter().chain(numbers) {
            finite(quantity, || format!("member {}", edge.member()), x, unit)?;
        }
        shown.push(ShownMember { member: edge.member(), ends, along, across });
    }
    Ok(shown)
}

fn forces(forces: SectionForces) -> ([Interval; 3], Option<ShownAcross>) {
    let across = forces.bent.map(|bent| ShownAcross::Forces {
        moment: bent.moment.map(Interval::middle),
        shear: bent.shear.map(Interval::middle),
    });
    (forces.axial, across)
}

fn plain(v: Vector) -> [f64; 2] {
    [v.x.middle(), v.y.middle()]
}

fn corners(tiling: &Tiling) -> Vec<[[f64; 2]; 3]> {
    (0..tiling.mesh.triangles.len()).map(|t| tiling.corners(t).map(plain)).collect()
}

fn adjoins(tiling: &Tiling) -> Vec<[Adjoins; 3]> {
    let one = |triangle: usize, corner: usize| match tiling.beyond(Side { triangle, corner }) {
        Beyond::Soil(other) => Adjoins::Soil(other),
        Beyond::Boundary(on, condition) => {
            Adjoins::Boundary { side: on.side, ends: [on.start, on.end], condition }
        }
    };
    (0..tiling.mesh.triangles.len()).map(|t| [0, 1, 2].map(|k| one(t, k))).collect()
}
