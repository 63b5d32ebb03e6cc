//! Members: they go along with the soil or let it slide past, stretch, and bend if they are beams.

use soilctl_certificate::{Bending, Condition, MemberFlow, MemberMotion};
use soilctl_conic::Form;

use super::edge_velocity::EdgeVelocity;
use super::nodes::Element;
use super::strength::{Limit, over_edge};
use super::{Builder, Edge, Side};
use crate::members::{MemberEdge, beam_at_end, member_edges, velocity_at_end};
use crate::problem::Soil;
use crate::vector::{Point, between, dot, length, midpoint, turned};

/// A beam's strength over what a typical stress does to one of its length, beyond which no flow is likely to bend it.
const ENOUGH_TO_BEND: f64 = 30.0;

/// What soil hands to bars over a typical stress in it, beyond which no flow is likely to slip along them: the soil itself bears less.
const ENOUGH_TO_STICK: f64 = 1e3;

/// How a member moves along one edge.
#[derive(Debug, Clone)]
pub(crate) struct MemberPiece {
    pub(crate) edge: MemberEdge,
    /// Bernstein coefficients of its velocity along itself and across, to its left: of a row of bars, that of the soil right at them.
    pub(crate) along: [Form; 3],
    pub(crate) across: [Form; 3],
    /// How much faster than that bars move along themselves.
    pub(crate) slip: [Form; 3],
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
    /// Its own velocity along itself.
    fn own(&self) -> [Form; 3] {
        [0, 1, 2].map(|i| self.along[i].clone().plus(1.0, &self.slip[i]))
    }

    /// How fast a beam turns at the start and the end.
    fn turns(&self) -> [Form; 2] {
        let [a, b, c] = &self.across;
        let by = 2.0 / self.edge.length();
        [(a, b), (b, c)].map(|(from, to)| Form::default().plus(by, to).plus(-by, from))
    }

    pub(super) fn saved(&self, x: &[f64]) -> MemberFlow {
        let motion = |i: usize| match self.kinds[i] {
            Kind::Soil => MemberMotion::Soil,
            Kind::Along => MemberMotion::Along { along: self.along[i].value(x) },
            Kind::Free => {
                MemberMotion::Free { along: self.along[i].value(x), across: self.across[i].value(x) }
            }
        };
        let Side { triangle, corner } = self.edge.first();
        let slip = self.slip.each_ref().map(|slip| slip.value(x));
        MemberFlow { triangle, corner, motion: [0, 1, 2].map(motion), slip }
    }
}

/// What soil that slides past a face dissipates at both ends of an edge: for each unit of opening, and of slip, or of all power if it has an
/// envelope. Of
/// strength that depends on the direction it is that for a rate of one.
pub(crate) fn bond(soil: &Soil, bond: f64, ends: &[Point; 2]) -> [[f64; 2]; 2] {
    if soil.is_isochoric {
        return [[0.0; 2], ends.map(|p| bond * soil.cohesion.at(p).max(0.0))];
    }
    let limit = Limit::around(soil, ends);
    let slip = |p: Point| match &limit {
        Limit::Apex => 0.0,
        Limit::Tension(t) => bond * (soil.cohesion.at(p) - t * soil.tan).max(0.0),
        Limit::Envelope(_) => 1.0,
    };
    [ends.map(|p| limit.tension(soil, p)), ends.map(slip)]
}

impl Builder<'_> {
    /// Adds all members: what sliding along them dissipates, and what their stretching and bending does.
    pub(super) fn add_members(&mut self) -> Vec<MemberPiece> {
        let edges = member_edges(self.meshed.problem, self.meshed.mesh, self.meshed.topology);
        let pieces: Vec<MemberPiece> = edges.into_iter().map(|edge| self.add_member_edge(edge)).collect();
        for (i, piece) in pieces.iter().enumerate() {
            let member = piece.edge.member;
            let [a, b, c] = &piece.own();
            self.add_stretch(member, a, b);
            self.add_stretch(member, b, c);
            let [turns, turned] = piece.turns();
            self.add_bend(member, &turned.clone().plus(-1.0, &turns), &Form::default());
            let is_of = |other: &&MemberPiece| other.edge.member == member;
            if i.checked_sub(1).and_then(|i| pieces.get(i)).filter(is_of).is_none() {
                if let Some(velocity) = self.end_of_member(&pieces, member, 0) {
                    self.add_stretch(member, &velocity, a);
                }
                self.add_clamp(member, 0, &turns, &piece.across[0]);
            }
            match pieces.get(i + 1).filter(is_of) {
                Some(next) => {
                    self.add_stretch(member, c, &next.own()[0]);
                    let turn = next.turns()[0].clone().plus(-1.0, &turned);
                    self.add_bend(member, &turn, &next.across[0].clone().plus(-1.0, &piece.across[2]));
                }
                None => {
                    if let Some(velocity) = self.end_of_member(&pieces, member, 1) {
                        self.add_stretch(member, c, &velocity);
                    }
                    self.add_clamp(member, 1, &turned, &piece.across[2]);
                }
            }
        }
        pieces
    }

    /// Velocity along a member of what an end of it is attached to.
    fn end_of_member(&self, pieces: &[MemberPiece], member: usize, end: usize) -> Option<Form> {
        let problem = self.meshed.problem;
        let Some(beam) = beam_at_end(problem, member, end) else {
            return velocity_at_end(problem, member, end).map(Form::constant);
        };
        let at = problem.member_ends(member)[end];
        // As the certificate has it: the end of the piece before, or the start of the first.
        let [along, across] = pieces.iter().filter(|piece| piece.edge.member == beam).find_map(|piece| {
            let i = if piece.edge.ends[1] == at { 2 } else { 0 };
            (i == 2 || piece.edge.ends[0] == at).then(|| [&piece.along[i], &piece.across[i]])
        })?;
        let unit = |member: usize| {
            let [a, b] = problem.member_ends(member);
            let d = between(a, b);
            d.map(|x| x / length(d))
        };
        let (t, d) = (unit(beam), unit(member));
        Some(Form::default().plus(dot(t, d), along).plus(dot(turned(t), d), across))
    }

    /// What a beam dissipates at an end that is clamped.
    fn add_clamp(&mut self, member: usize, end: usize, turn: &Form, step: &Form) {
        let m = &self.meshed.problem.members()[member];
        if m.bending.is_some() && m.attached[end] {
            self.add_bend(member, turn, step);
        }
    }

    /// A beam turns, or slips across itself.
    fn add_bend(&mut self, member: usize, turn: &Form, step: &Form) {
        let problem = self.meshed.problem;
        let Some(Bending { moment, shear }) = problem.members()[member].bending else { return };
        let [a, b] = problem.member_ends(member);
        let (length, middle) = (length(between(a, b)), midpoint(a, b));
        let stress = (0..problem.soils.len())
            .map(|region| problem.stress_scale(region, middle, length))
            .fold(f64::MIN_POSITIVE, f64::max);
        // Proofs know the strength as it is; for the program's accuracy more than enough is too much.
        let enough = ENOUGH_TO_BEND * stress * length;
        for (most, change) in [(moment.min(enough * length), turn), (shear.min(enough), step)] {
            if change.terms.is_empty() {
                continue;
            }
            let size = Form::unknown(self.program.unknown(), 1.0);
            self.power.dissipate(most, &size);
            self.program.non_negative(size.clone().plus(1.0, change));
            self.program.non_negative(size.plus(-1.0, change));
        }
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
        let Some([side, other]) = edge.both() else { return false };
        let [Element::Quadratic(here), Element::Quadratic(there)] =
            [side, other].map(|s| self.elements[s.triangle])
        else {
            return false;
        };
        let on = |nodes: [usize; 6], side: Side| {
            [nodes[(side.corner + 1) % 3], nodes[3 + side.corner], nodes[(side.corner + 2) % 3]]
        };
        let (a, b) = (on(here, side)[i], on(there, other)[2 - i]);
        let is_still = |node: usize| self.velocities[node].iter().all(|v| v.terms.is_empty());
        a == b || (is_still(a) && is_still(b))
    }

    /// How bars of a row slip in the soil at them.
    fn add_slip_of_bars(&mut self, edge: &MemberEdge) -> [Form; 3] {
        let mut slip = [Form::default(), Form::default(), Form::default()];
        let Some(gripped) = edge.gripped(&self.meshed.problem.members()[edge.member]) else { return slip };
        let region = self.meshed.mesh.triangles[edge.first().triangle].region;
        let length = edge.length();
        let stress = self.meshed.problem.stress_scale(region, midpoint(edge.ends[0], edge.ends[1]), length);
        let [from, to] = gripped.most;
        if from.min(to) > ENOUGH_TO_STICK * stress {
            return slip;
        }
        for (slip, most) in slip.iter_mut().zip(over_edge(gripped.most)) {
            *slip = Form::unknown(self.program.unknown(), 1.0);
            if most > 0.0 {
                let size = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(most * length / 3.0, &size);
                self.program.non_negative(size.clone().plus(1.0, slip));
                self.program.non_negative(size.plus(-1.0, slip));
            }
        }
        slip
    }

    fn add_member_edge(&mut self, edge: MemberEdge) -> MemberPiece {
        let soils = [
            edge.sides[0].map(|side| self.slide(side)),
            edge.sides[1].map(|side| self.slide(side).reversed()),
        ];
        let keeps = edge.sides.map(|side| side.is_some_and(|s| self.meshed.is_isochoric(s.triangle)));
        let empty = || [Form::default(), Form::default(), Form::default()];
        let slip = self.add_slip_of_bars(&edge);
        let mut piece = MemberPiece { edge, along: empty(), across: empty(), slip, kinds: [Kind::Soil; 3] };
        for i in 0..3 {
            if let Some(soil) = soils[0].as_ref().filter(|_| self.is_one_soil(&piece.edge, i)) {
                piece.along[i] = soil.slip[i].clone();
                piece.across[i] = soil.opening[i].clone();
                continue;
            }
            piece.along[i] = Form::unknown(self.program.unknown(), 1.0);
            let mut across = self.beams.get(&piece.edge.member).map(|beam| {
                let [from, to] = piece.edge.place;
                beam.across([from, 0.5 * (from + to), to][i])
            });
            let with = (0..2).find(|on| keeps[*on]).and_then(|on| soils[on].as_ref());
            (piece.kinds[i], piece.across[i]) = match with {
                Some(soil) => (Kind::Along, soil.opening[i].clone()),
                None => {
                    (Kind::Free, across.take().unwrap_or_else(|| Form::unknown(self.program.unknown(), 1.0)))
                }
            };
        }
        let own = EdgeVelocity { slip: piece.along.clone(), opening: piece.across.clone() };
        for (on, (side, soil)) in piece.edge.sides.into_iter().zip(soils).enumerate() {
            let (Some(side), Some(soil)) = (side, soil) else { continue };
            // On the right it is the member that moves away from the soil.
            let past = if on == 0 { soil.less(&own) } else { own.clone().less(&soil) };
            self.add_face_of_member(&piece, side, keeps[on], &past);
            if let Edge::Boundary(Condition::Lined { pressure, shear, live }) = self.meshed.edge(side) {
                let velocity = if on == 0 { own.clone() } else { own.clone().reversed() };
                self.add_load_on_beam(side, &velocity, [pressure, shear], live);
            }
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
        let tan = part * soil.flow_tan();
        let [forwards, backwards] = soil.ellipse.both_ways(between(ends[0], ends[1]));
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
            if let Some(envelope) = &soil.envelope {
                let tractions: Vec<Point> = envelope.tractions.iter().map(|[n, s]| [*n, part * s]).collect();
                let sliding = Form::unknown(self.program.unknown(), 1.0);
                self.program.non_negative(sliding.clone().plus(1.0, &past.slip[i]));
                self.program.non_negative(sliding.clone().plus(-1.0, &past.slip[i]));
                self.add_greatest(&tractions, &past.opening[i], &sliding, length / 3.0);
            } else if slip[i] > 0.0 {
                let most = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(slip[i] * length / 3.0, &most);
                self.program.non_negative(most.clone().plus(backwards, &past.slip[i]));
                self.program.non_negative(most.plus(-forwards, &past.slip[i]));
            }
        }
    }
}
