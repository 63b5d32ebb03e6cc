//! Members: they move along with the soil or slide in it, and stretch.
//!
//! With `w` the velocity of a member along itself, virtual work demands of it `int N dw`, at most `tension dw` where that is
//! positive and `-compression dw` where it is negative. Along an edge `w` is quadratic: it goes up and down by no more than its
//! Bernstein coefficients do, one after the other. Jumps between edges, and to what an end is attached to, count alike.
//!
//! The soil slides past each face under a flow rule of its own, that of a layer which bears a part of the soil's shear strength. Across,
//! a member is as flexible as can be, so its velocity across need not be continuous: it has no part in `w`.

use std::collections::BTreeMap;

use super::VelocityField;
use super::edge_velocity::EdgeVelocity;
use super::power::Power;
use super::resistance::Resistance;
use crate::CertificateError;
use crate::fields::{Flow, MemberFlow, MemberMotion, StreamJet};
use crate::interval::Interval;
use crate::mesh::Side;
use crate::problem::Strength;
use crate::tiling::{OnMember, after};

/// A member, Bernstein coefficients of its velocity along itself on an edge, and what soil that slides past there dissipates.
type PieceFlow = (usize, ([Interval; 3], Power));

fn bad(side: Side, problem: &'static str) -> CertificateError {
    CertificateError::BadField { place: side.to_string(), problem }
}

impl VelocityField<'_> {
    /// What all members add to the power. Checks the flow rule along them.
    pub(super) fn members(&self) -> Result<Power, CertificateError> {
        let pieces = self.pieces_of_members()?;
        let mut power = Power::ZERO;
        for (i, (member, (along, slid))) in pieces.iter().enumerate() {
            let [a, b, c] = *along;
            let member = *member;
            power = power + *slid + self.stretched(member, a, b) + self.stretched(member, b, c);
            let is_first = i.checked_sub(1).is_none_or(|i| pieces[i].0 != member);
            if is_first && let Some(velocity) = self.problem.velocity_at_end(member, false)? {
                power = power + self.stretched(member, velocity, a);
            }
            match pieces.get(i + 1).filter(|(next, _)| *next == member) {
                Some((_, ([start, ..], _))) => power = power + self.stretched(member, c, *start),
                None => {
                    if let Some(velocity) = self.problem.velocity_at_end(member, true)? {
                        power = power + self.stretched(member, c, velocity);
                    }
                }
            }
        }
        Ok(power)
    }

    /// The flow of each edge of a member, in order.
    fn pieces_of_members(&self) -> Result<Vec<PieceFlow>, CertificateError> {
        let flows: BTreeMap<Side, &MemberFlow> = (self.field.members.iter())
            .map(|flow| (Side { triangle: flow.triangle, corner: flow.corner }, flow))
            .collect();
        let edges = self.tiling.along_members();
        if self.field.members.len() != edges.len() || flows.len() != edges.len() {
            let (found, needed) = (self.field.members.len(), edges.len());
            let each = "triangle edge on the left of a member, each once";
            return Err(CertificateError::Length { list: "members", found, needed, each });
        }
        let mut pieces = Vec::with_capacity(edges.len());
        for (side, other, on) in &edges {
            let known = flows.get(side);
            let flow = known.ok_or_else(|| bad(*side, "it is on a member whose motion is not given"))?;
            pieces.push((on.piece.member, self.member_edge(*side, *other, on, flow.motion)?));
        }
        Ok(pieces)
    }

    /// Velocities of all members along themselves, edge by edge.
    pub(super) fn along_members(&self) -> Result<Vec<[Interval; 3]>, CertificateError> {
        Ok(self.pieces_of_members()?.into_iter().map(|(_, (along, _))| along).collect())
    }

    /// What a member dissipates where its velocity along itself changes.
    fn stretched(&self, member: usize, from: Interval, to: Interval) -> Power {
        let m = &self.problem.statement.members[member];
        let [tension, compression] = [m.tension, m.compression].map(Interval::point);
        let change = to - from;
        Power::dissipated(tension * change.or_zero() + compression * (-change).or_zero())
    }

    /// Bernstein coefficients of the velocity of a member along itself, on an edge, and what the soil dissipates that slides past both
    /// faces.
    fn member_edge(
        &self,
        side: Side,
        other: Side,
        on: &OnMember,
        motion: [MemberMotion; 3],
    ) -> Result<([Interval; 3], Power), CertificateError> {
        let length = self.along(side).square().sqrt();
        let (left, right) = (self.slide(side), self.slide(other).reversed());
        let keeps = [side, other].map(|s| self.keeps_volume(s));
        if keeps == [true; 2] && !self.moves_as_one_across(side, other) {
            return Err(bad(
                side,
                "soil that keeps its volume is not proven to move alike across the member",
            ));
        }
        let mut member = EdgeVelocity { slip: [Interval::ZERO; 3], opening: [Interval::ZERO; 3] };
        let (mut from_left, mut from_right) = (left.less(member), member.less(right));
        for (i, motion) in motion.into_iter().enumerate() {
            let (along, across) = match motion {
                MemberMotion::Soil => {
                    if !self.is_one_soil(side, other, i) {
                        return Err(bad(
                            side,
                            "the soil is not proven to be one on both sides of the member",
                        ));
                    }
                    member.slip[i] = left.slip[i];
                    for relative in [&mut from_left, &mut from_right] {
                        (relative.slip[i], relative.opening[i]) = (Interval::ZERO, Interval::ZERO);
                    }
                    continue;
                }
                MemberMotion::Along { along } => (along, None),
                MemberMotion::Free { along, across } => (along, Some(across)),
            };
            member.slip[i] = Interval::point(along) * length;
            from_left.slip[i] = left.slip[i] - member.slip[i];
            from_right.slip[i] = member.slip[i] - right.slip[i];
            member.opening[i] = match (across, keeps) {
                (Some(across), _) => Interval::point(across) * length,
                (None, [true, _]) => left.opening[i],
                (None, [false, true]) => right.opening[i],
                (None, [false, false]) => {
                    return Err(bad(side, "its motion across must be given beside soil that dilates"));
                }
            };
            from_left.opening[i] = left.opening[i] - member.opening[i];
            from_right.opening[i] = member.opening[i] - right.opening[i];
            // Exactly, which arithmetic would not show.
            if across.is_none() && keeps[0] {
                from_left.opening[i] = Interval::ZERO;
            }
            if across.is_none() && (!keeps[0] || keeps[1]) {
                from_right.opening[i] = Interval::ZERO;
            }
        }
        let bond = Interval::point(self.problem.statement.members[on.piece.member].bond);
        let of = |side: Side, relative| {
            self.bond(side, &self.problem.strengths[self.tiling.region(side.triangle)], bond, relative)
        };
        let power = of(side, from_left)? + of(other, from_right)?;
        Ok((member.slip.map(|slip| slip / length), power))
    }

    /// Whether the flow of a triangle cannot change the volume.
    fn keeps_volume(&self, side: Side) -> bool {
        let region = &self.problem.statement.regions[self.tiling.region(side.triangle)];
        let is_closed = region.material.phi_deg == 0.0 && region.material.tension.is_none();
        is_closed || matches!(self.field.flows[side.triangle], Flow::Stream { .. })
    }

    /// Whether the velocity across an edge is one on both sides, exactly: those of stream functions whose copies at both ends are
    /// one or depend on each other, or of soil at rest.
    fn moves_as_one_across(&self, side: Side, other: Side) -> bool {
        match [side, other].map(|s| self.field.flows[s.triangle]) {
            [Flow::Stream { corners: here, .. }, Flow::Stream { corners: there, .. }] => {
                [(1, 2), (2, 1)].into_iter().all(|(i, j)| {
                    let (a, b) = (here[after(side.corner, i)], there[after(other.corner, j)]);
                    let depends = |a: usize, b: usize| {
                        matches!(self.field.stream[a].jet, StreamJet::Kinked { copy, line, .. }
                            if copy == b && self.is_on_same_member(side, line))
                    };
                    a == b || depends(a, b) || depends(b, a)
                })
            }
            [Flow::Quadratic(here), Flow::Quadratic(there)] => {
                here.iter().chain(&there).all(|node| self.velocities[*node].is_zero())
            }
            _ => false,
        }
    }

    /// Whether a line is a piece of the member that an edge is on. All pieces of a member are in one line.
    fn is_on_same_member(&self, side: Side, line: usize) -> bool {
        let member = self.tiling.member(side).map(|on| on.piece.member);
        member.is_some() && self.problem.piece(line).map(|piece| piece.member) == member
    }

    /// Whether the velocity of the soil at a control point of an edge is one on both sides, exactly.
    fn is_one_soil(&self, side: Side, other: Side, i: usize) -> bool {
        match [side, other].map(|s| self.field.flows[s.triangle]) {
            [Flow::Quadratic(here), Flow::Quadratic(there)] => {
                let (a, b) = (Self::on_edge(here, side)[i], Self::on_edge(there, other)[2 - i]);
                a == b || (self.velocities[a].is_zero() && self.velocities[b].is_zero())
            }
            [Flow::Stream { corners: here, .. }, Flow::Stream { corners: there, .. }] => match i {
                0 => here[after(side.corner, 1)] == there[after(other.corner, 2)],
                2 => here[after(side.corner, 2)] == there[after(other.corner, 1)],
                _ => false,
            },
            _ => false,
        }
    }

    /// What sliding past a face dissipates. Checks that it opens as much as the friction of the face demands.
    fn bond(
        &self,
        side: Side,
        strength: &Strength,
        bond: Interval,
        slide: EdgeVelocity,
    ) -> Result<Power, CertificateError> {
        let tan = bond * strength.friction.tan();
        let may_open = !strength.friction.sin.is_zero() || strength.tension.is_some();
        for (i, (open, slip)) in slide.opening.into_iter().zip(slide.slip).enumerate() {
            let spares = if may_open { [open - slip * tan, open + slip * tan] } else { [open, -open] };
            if let Some(spare) = spares.into_iter().find(|spare| !spare.is_at_least_zero()) {
                let quantity = "opening beside a member beyond what the friction demands";
                let place = format!("{side}, control point {i} of 3");
                let (low, unit) = (spare.lo(), "velocity*length");
                return Err(CertificateError::NotProven { quantity, place, low, unit });
            }
        }
        // Along the edge either way: what is linear along it is given at its start and its end as the member goes.
        let resistance = Resistance::new(strength, self.ends(side));
        let reversed = |[a, b, c]: [Interval; 3]| [c, b, a];
        let is_left = self.tiling.member(side).is_some_and(|on| on.is_left);
        let [opening, slip] = [slide.opening, slide.slip].map(|of| if is_left { of } else { reversed(of) });
        let resisted = resistance.of_bond(bond, opening, slip);
        Ok(Power::resisted(resisted, &self.problem.statement.objective))
    }
}
