//! Members: they go along with the soil or let it slide past, and stretch.

use soilctl_certificate::{MemberFlow, MemberMotion};
use soilctl_conic::Form;

use super::edge_velocity::EdgeVelocity;
use super::nodes::Element;
use super::strength::{Limit, over_edge};
use super::{Builder, Side};
use crate::members::{MemberEdge, member_edges, velocity_at_end};
use crate::problem::Soil;
use crate::vector::Point;

/// How a member moves along one edge.
#[derive(Debug, Clone)]
pub(crate) struct MemberPiece {
    pub(crate) edge: MemberEdge,
    /// Bernstein coefficients of its velocity along itself and across, to its left.
    pub(crate) along: [Form; 3],
    pub(crate) across: [Form; 3],
    kinds: [Kind; 3],
}

/// What a coefficient is known by.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// The soil, which is one on both sides.
    Soil,
    /// Its part along; across it goes with soil that keeps its volume.
    Along,
    Free,
}

impl MemberPiece {
    pub(super) fn saved(&self, x: &[f64]) -> MemberFlow {
        let motion = |i: usize| match self.kinds[i] {
            Kind::Soil => MemberMotion::Soil,
            Kind::Along => MemberMotion::Along { along: self.along[i].value(x) },
            Kind::Free => {
                MemberMotion::Free { along: self.along[i].value(x), across: self.across[i].value(x) }
            }
        };
        let Side { triangle, corner } = self.edge.side;
        MemberFlow { triangle, corner, motion: [0, 1, 2].map(motion) }
    }
}

/// What soil that slides past a face dissipates at both ends of an edge: for each unit of opening, and of slip.
pub(crate) fn bond(soil: &Soil, bond: f64, ends: &[Point; 2]) -> [[f64; 2]; 2] {
    if soil.is_isochoric {
        return [[0.0; 2], ends.map(|p| bond * soil.cohesion.at(p).max(0.0))];
    }
    let limit = Limit::around(soil, ends);
    let slip = |p: Point| match limit {
        Limit::Apex => 0.0,
        Limit::Tension(t) => bond * (soil.cohesion.at(p) - t * soil.tan).max(0.0),
    };
    [ends.map(|p| limit.tension(soil, p)), ends.map(slip)]
}

impl Builder<'_> {
    /// Adds all members: what sliding along them dissipates, and what their stretching does.
    pub(super) fn add_members(&mut self) -> Vec<MemberPiece> {
        let edges = member_edges(self.meshed.problem, self.meshed.mesh, self.meshed.topology);
        let pieces: Vec<MemberPiece> = edges.into_iter().map(|edge| self.add_member_edge(edge)).collect();
        for (i, piece) in pieces.iter().enumerate() {
            let member = piece.edge.member;
            let [a, b, c] = &piece.along;
            self.add_stretch(member, a, b);
            self.add_stretch(member, b, c);
            let problem = self.meshed.problem;
            let is_of = |other: &&MemberPiece| other.edge.member == member;
            if i.checked_sub(1).and_then(|i| pieces.get(i)).filter(is_of).is_none()
                && let Some(velocity) = velocity_at_end(problem, member, 0)
            {
                self.add_stretch(member, &Form::constant(velocity), a);
            }
            match pieces.get(i + 1).filter(is_of) {
                Some(next) => self.add_stretch(member, c, &next.along[0]),
                None => {
                    if let Some(velocity) = velocity_at_end(problem, member, 1) {
                        self.add_stretch(member, c, &Form::constant(velocity));
                    }
                }
            }
        }
        pieces
    }

    /// A change of a member's velocity along itself.
    fn add_stretch(&mut self, member: usize, from: &Form, to: &Form) {
        let m = &self.meshed.problem.members()[member];
        let (tension, compression) = (m.tension, m.compression);
        let change = to.clone().plus(-1.0, from);
        if tension + compression == 0.0 {
            return;
        }
        // The positive part, of which compression takes back what is less than that.
        let longer = Form::unknown(self.program.unknown(), 1.0);
        self.power.dissipate(tension + compression, &longer);
        self.power.dissipate(-compression, &change);
        self.program.non_negative(longer.clone());
        self.program.non_negative(longer.plus(-1.0, &change));
    }

    /// Whether soil is one on both sides at a control point, or at rest on both.
    fn is_one_soil(&self, edge: &MemberEdge, i: usize) -> bool {
        let [Element::Quadratic(here), Element::Quadratic(there)] =
            [edge.side, edge.other].map(|s| self.elements[s.triangle])
        else {
            return false;
        };
        let on = |nodes: [usize; 6], side: Side| {
            [nodes[(side.corner + 1) % 3], nodes[3 + side.corner], nodes[(side.corner + 2) % 3]]
        };
        let (a, b) = (on(here, edge.side)[i], on(there, edge.other)[2 - i]);
        let is_still = |node: usize| self.velocities[node].iter().all(|v| v.terms.is_empty());
        a == b || (is_still(a) && is_still(b))
    }

    fn add_member_edge(&mut self, edge: MemberEdge) -> MemberPiece {
        let (left, right) = (self.slide(edge.side), self.slide(edge.other).reversed());
        let keeps = [edge.side, edge.other].map(|s| self.meshed.is_isochoric(s.triangle));
        let empty = || [Form::default(), Form::default(), Form::default()];
        let mut piece = MemberPiece { edge, along: empty(), across: empty(), kinds: [Kind::Soil; 3] };
        for i in 0..3 {
            if self.is_one_soil(&piece.edge, i) {
                piece.along[i] = left.slip[i].clone();
                piece.across[i] = left.opening[i].clone();
                continue;
            }
            piece.along[i] = Form::unknown(self.program.unknown(), 1.0);
            (piece.kinds[i], piece.across[i]) = match keeps {
                [true, _] => (Kind::Along, left.opening[i].clone()),
                [false, true] => (Kind::Along, right.opening[i].clone()),
                [false, false] => (Kind::Free, Form::unknown(self.program.unknown(), 1.0)),
            };
        }
        let member = EdgeVelocity { slip: piece.along.clone(), opening: piece.across.clone() };
        let past = [left.less(&member), member.clone().less(&right)];
        for ((side, past), keeps) in [edge.side, edge.other].into_iter().zip(past).zip(keeps) {
            self.add_face_of_member(&piece, side, keeps, &past);
        }
        piece
    }

    /// What soil dissipates that slides past a face; it opens as much as the friction of the face demands.
    fn add_face_of_member(&mut self, piece: &MemberPiece, side: Side, keeps: bool, past: &EdgeVelocity) {
        let soil = self.meshed.soil(side.triangle);
        let ends = &piece.edge.ends;
        let part = self.meshed.problem.members()[piece.edge.member].bond;
        let length = piece.edge.length();
        let [opening, slip] = bond(soil, part, ends).map(over_edge);
        let water = over_edge(ends.map(|p| soil.pore_pressure.at(p)));
        let tan = part * soil.tan;
        for i in (0..3).filter(|i| piece.kinds[*i] != Kind::Soil) {
            if !keeps {
                let open = &past.opening[i];
                self.power.dissipate(opening[i] * length / 3.0, open);
                self.power.load(water[i] * length / 3.0, open, self.all);
                let spare = Form::constant(-self.tighten).plus(1.0, open);
                if tan == 0.0 {
                    self.program.non_negative(spare);
                } else {
                    self.program.non_negative(spare.clone().plus(tan, &past.slip[i]));
                    self.program.non_negative(spare.plus(-tan, &past.slip[i]));
                }
            }
            if slip[i] > 0.0 {
                let most = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(slip[i] * length / 3.0, &most);
                self.program.non_negative(most.clone().plus(1.0, &past.slip[i]));
                self.program.non_negative(most.plus(-1.0, &past.slip[i]));
            }
        }
    }
}
