//! Members: they move along with the soil or slide in it, and stretch.
//!
//! With `w` the velocity of a member along itself, virtual work demands of it `int N dw`, at most `tension dw` where that is
//! positive and `-compression dw` where it is negative. Along an edge `w` is quadratic: it goes up and down by no more than its
//! Bernstein coefficients do, one after the other. Jumps between edges, and to what an end is attached to, count alike.
//!
//! Bars of a row slip in the soil right at them, whose velocity `z` is a choice of the flow as that of a sheet is; the soil beside may slide away
//! from that on both sides, as in any layer of it. With `w` the velocity of the bars, what they take from the soil does the work `dN/ds (w -
//! z)`, at most their resistance times the slip.
//!
//! The soil slides past each face under a flow rule of its own, that of a layer which bears a part of the soil's shear strength. Across,
//! a flexible member's velocity need not be continuous: it has no part in `w`. With `u` the velocity across of a beam, virtual work
//! demands `int M d(u') + int V [u]`, at most the greatest moment times all changes of `u'` and the greatest shear force times all jumps of
//! `u`. Along an edge `u` is quadratic, so `u'` changes there by the difference of its values at the ends.

use std::collections::BTreeMap;

use super::VelocityField;
use super::edge_velocity::EdgeVelocity;
use super::means;
use super::power::Power;
use super::resistance::Resistance;
use crate::CertificateError;
use crate::fields::{Flow, MemberFlow, MemberMotion, StreamJet};
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::problem::{Attached, Gripped, Strength};
use crate::statement::{Bending, Condition, Objective};
use crate::tiling::{Beyond, MemberEdge, after};

/// How a member moves along an edge.
#[derive(Debug, Clone, Copy)]
struct PieceFlow {
    member: usize,
    /// Start and end.
    ends: [Vector; 2],
    /// Velocities along itself and across, to its left: Bernstein coefficients.
    along: [Interval; 3],
    across: [Interval; 3],
    /// How much faster bars move along themselves than the soil at them, where that holds on to them.
    slip: [Interval; 3],
    /// What soil dissipates that slides past there, less the power of loads on the other side of a beam.
    beside: Power,
}

impl PieceFlow {
    /// How fast a beam turns at the start and the end of the edge.
    fn turns(&self) -> [Interval; 2] {
        let [a, b, c] = self.across;
        let half = (self.ends[1] - self.ends[0]).square().sqrt().half();
        [(b - a) / half, (c - b) / half]
    }
}

fn bad(side: Side, problem: &'static str) -> CertificateError {
    CertificateError::BadField { place: side.to_string(), problem }
}

impl VelocityField<'_> {
    /// What all members add to the power. Checks the flow rule along them.
    pub(super) fn members(&self) -> Result<Power, CertificateError> {
        let pieces = self.pieces_of_members()?;
        let mut power = Power::ZERO;
        for (i, piece) in pieces.iter().enumerate() {
            let [a, b, c] = piece.along;
            let member = piece.member;
            power = power + piece.beside + self.stretched(member, a, b) + self.stretched(member, b, c);
            let [turns, turned] = piece.turns();
            power = power + self.bent(member, turned - turns, Interval::ZERO);
            let is_first = i.checked_sub(1).is_none_or(|i| pieces[i].member != member);
            if is_first {
                let at_end = self.end_of_member(&pieces, member, false)?;
                power = power + at_end.map_or(Power::ZERO, |v| self.stretched(member, v, a));
            }
            match pieces.get(i + 1).filter(|next| next.member == member) {
                Some(next) => {
                    let step = next.across[0] - piece.across[2];
                    power = power + self.stretched(member, c, next.along[0]);
                    power = power + self.bent(member, next.turns()[0] - turned, step);
                }
                None => {
                    let at_end = self.end_of_member(&pieces, member, true)?;
                    power = power + at_end.map_or(Power::ZERO, |v| self.stretched(member, c, v));
                }
            }
            let is_last = pieces.get(i + 1).is_none_or(|next| next.member != member);
            for (end, is_end, turn, step) in
                [(false, is_first, turns, piece.across[0]), (true, is_last, turned, piece.across[2])]
            {
                let clamped = || Ok(self.problem.end_of(member, end)? == Attached::Ground);
                if is_end && self.problem.bends(member) && clamped()? {
                    power = power + self.bent(member, turn, step);
                }
            }
        }
        Ok(power)
    }

    /// Velocity along a member of what its start or its end is attached to, if it is.
    fn end_of_member(
        &self,
        pieces: &[PieceFlow],
        member: usize,
        end: bool,
    ) -> Result<Option<Interval>, CertificateError> {
        let Attached::Beam(beam) = self.problem.end_of(member, end)? else {
            return self.problem.velocity_at_end(member, end);
        };
        let at = Vector::point(self.problem.statement.points[self.problem.member_end_point(member, end)]);
        let is_here = |p: Vector| (p - at).is_zero();
        let of_beam = |piece: &&PieceFlow| piece.member == beam;
        // It moves as the end of the piece before it does, or as the start of the first one: what a beam's velocity jumps by is counted there.
        let found = pieces.iter().filter(of_beam).find_map(|piece| {
            let i = if is_here(piece.ends[1]) { 2 } else { 0 };
            (i == 2 || is_here(piece.ends[0])).then(|| [piece.along[i], piece.across[i]])
        });
        let [along, across] = found.ok_or_else(|| CertificateError::BadField {
            place: format!("member {member}"),
            problem: "no edge of the beam that it is attached to starts or ends there",
        })?;
        let t = self.problem.along_member(beam);
        Ok(Some((t * along + t.turned() * across).dot(self.problem.along_member(member))))
    }

    /// What a beam dissipates where it turns and slips across itself.
    fn bent(&self, member: usize, turn: Interval, step: Interval) -> Power {
        let Some(Bending { moment, shear }) = self.problem.statement.members[member].bending else {
            return Power::ZERO;
        };
        let size = |x: Interval| x.or_zero() + (-x).or_zero();
        Power::dissipated(Interval::point(moment) * size(turn) + Interval::point(shear) * size(step))
    }

    /// The flow of each edge of a member, in order.
    fn pieces_of_members(&self) -> Result<Vec<PieceFlow>, CertificateError> {
        let flows: BTreeMap<Side, &MemberFlow> = (self.field.members.iter())
            .map(|flow| (Side { triangle: flow.triangle, corner: flow.corner }, flow))
            .collect();
        let edges = self.tiling.along_members();
        if self.field.members.len() != edges.len() || flows.len() != edges.len() {
            let (found, needed) = (self.field.members.len(), edges.len());
            let each = "triangle edge along a member, on its left if there is soil, each once";
            return Err(CertificateError::Length { list: "members", found, needed, each });
        }
        let mut pieces = Vec::with_capacity(edges.len());
        for edge in &edges {
            let known = edge.first().and_then(|side| flows.get(&side));
            let flow = known.ok_or_else(|| CertificateError::BadField {
                place: format!("member {}", edge.member()),
                problem: "there is an edge whose motion is not given",
            })?;
            pieces.push(self.member_edge(edge, flow)?);
        }
        Ok(pieces)
    }

    /// How all members move, edge by edge: along themselves and across, and how bars slip.
    pub(super) fn along_members(&self) -> Result<Vec<[[Interval; 3]; 3]>, CertificateError> {
        let motion = |piece: PieceFlow| [piece.along, piece.across, piece.slip];
        Ok(self.pieces_of_members()?.into_iter().map(motion).collect())
    }

    /// What a member dissipates where its velocity along itself changes.
    fn stretched(&self, member: usize, from: Interval, to: Interval) -> Power {
        let m = &self.problem.statement.members[member];
        let [tension, compression] = [m.tension, m.compression].map(Interval::point);
        let change = to - from;
        Power::dissipated(tension * change.or_zero() + compression * (-change).or_zero())
    }

    /// How a member moves along an edge. Checks that the soil slides past it as its faces demand.
    fn member_edge(&self, edge: &MemberEdge, flow: &MemberFlow) -> Result<PieceFlow, CertificateError> {
        let ends = self.tiling.ends_on_member(edge);
        let length = (ends[1] - ends[0]).square().sqrt();
        let member = edge.member();
        let [left, right] = edge.sides;
        // As the member goes: the soil on its left, and on its right.
        let soils = [left.map(|s| self.slide(s)), right.map(|s| self.slide(s).reversed())];
        let keeps = edge.sides.map(|side| side.is_some_and(|side| self.keeps_volume(side)));
        if let Some([side, other]) = edge.both()
            && keeps == [true; 2]
            && !self.moves_as_one_across(side, other)
        {
            return Err(bad(
                side,
                "soil that keeps its volume is not proven to move alike across the member",
            ));
        }
        let first = edge.first().unwrap_or(Side { triangle: 0, corner: 0 });
        let mut own = EdgeVelocity { slip: [Interval::ZERO; 3], opening: [Interval::ZERO; 3] };
        // Whether the soil on either side goes along exactly, and across exactly.
        let mut along_exactly = [[false; 3]; 2];
        let mut across_exactly = [[false; 3]; 2];
        for (i, motion) in flow.motion.into_iter().enumerate() {
            let (along, across) = match motion {
                MemberMotion::Soil => {
                    let one = edge.both().is_some_and(|[side, other]| self.is_one_soil(side, other, i));
                    let Some(soil) = soils[0].filter(|_| one) else {
                        return Err(bad(
                            first,
                            "the soil is not proven to be one on both sides of the member",
                        ));
                    };
                    (own.slip[i], own.opening[i]) = (soil.slip[i], soil.opening[i]);
                    for exactly in [&mut along_exactly, &mut across_exactly] {
                        exactly.iter_mut().for_each(|on_side| on_side[i] = true);
                    }
                    continue;
                }
                MemberMotion::Along { along } => (along, None),
                MemberMotion::Free { along, across } => (along, Some(across)),
            };
            own.slip[i] = Interval::point(along) * length;
            own.opening[i] = match across {
                Some(across) => Interval::point(across) * length,
                None => {
                    let with = (0..2).find(|side| keeps[*side]);
                    let Some((with, soil)) = with.and_then(|side| Some((side, soils[side]?))) else {
                        return Err(bad(first, "its motion across must be given beside soil that dilates"));
                    };
                    // Exactly, which arithmetic would not show. Soil that keeps its volume on both sides is one across.
                    across_exactly[with][i] = true;
                    across_exactly[1 - with][i] |= keeps == [true; 2];
                    soil.opening[i]
                }
            };
        }
        let bond = Interval::point(self.problem.statement.members[member].bond);
        let mut beside = Power::ZERO;
        for (on, side) in edge.sides.into_iter().enumerate() {
            let (Some(side), Some(soil)) = (side, soils[on]) else { continue };
            // On the right it is the member that moves away from the soil.
            let mut past = if on == 0 { soil.less(own) } else { own.less(soil) };
            for i in 0..3 {
                if along_exactly[on][i] {
                    past.slip[i] = Interval::ZERO;
                }
                if across_exactly[on][i] {
                    past.opening[i] = Interval::ZERO;
                }
            }
            let strength = &self.problem.strengths[self.tiling.region(side.triangle)];
            beside = beside + self.bond(side, strength, bond, past)?;
            beside = beside + self.load_on_beam(side, if on == 0 { own } else { own.reversed() });
        }
        let [mut along, across] = [own.slip, own.opening].map(|of| of.map(|x| x / length));
        let mut slip = flow.slip.map(Interval::point);
        if flow.slip != [0.0; 3] {
            beside = beside + self.slipped(edge, slip.map(|s| s * length))?;
            along = [0, 1, 2].map(|i| along[i] + slip[i]);
        }
        if matches!(self.problem.gripped(&edge.on), Some(Gripped::Free)) {
            slip = [Interval::ZERO; 3];
        }
        Ok(PieceFlow { member, ends, along, across, slip, beside })
    }

    /// What slip of bars in the soil at them takes up, given times the length of the edge: it is at most the polynomial that has the sizes
    /// of its coefficients.
    fn slipped(&self, edge: &MemberEdge, slip: [Interval; 3]) -> Result<Power, CertificateError> {
        let resistance = match self.problem.gripped(&edge.on) {
            Some(Gripped::Free) => return Ok(Power::ZERO),
            Some(Gripped::Partly(most) | Gripped::Whole(most)) => most,
            None => {
                return Err(CertificateError::BadField {
                    place: format!("member {}", edge.member()),
                    problem: "only bars between which the soil goes on slip in the soil at them",
                });
            }
        };
        Ok(Power::dissipated(means::over_edge(resistance, slip.map(Interval::abs))))
    }

    /// What loads do on a beam that lines the soil, given its velocity as the triangle goes.
    fn load_on_beam(&self, side: Side, velocity: EdgeVelocity) -> Power {
        let Beyond::Boundary(on, Condition::Lined { pressure, shear, live }) = self.tiling.beyond(side)
        else {
            return Power::ZERO;
        };
        let objective = self.problem.statement.objective;
        let live = objective == Objective::Everything || (live && objective == Objective::Loads);
        let [pressure, shear] = [pressure, shear].map(|at_ends| at_ends.map(Interval::point));
        Self::load_on(velocity, on, pressure, shear, live)
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
        let tan = bond * strength.flow_friction().tan();
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
