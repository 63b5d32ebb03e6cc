//! Members: the edges along them, and where they may be.

use soilctl_certificate::{Bending, LineUse, Member};

use super::error::DescriptionError;
use super::fill::Units;
use super::ground::Map;
use super::ground::Occupant;
use super::holds::Holds;
use super::input::Description;
use super::parts::{MemberEnd, MemberEntry};
use super::plan::Plan;
use super::pullout::grips;
use super::segments::{Drawing, Owner, Segment};
use crate::error::LimitError;
use crate::vector::{between, dot, length};

/// How much of its length the edges of a member may fall short of it, but for rounding.
const ROUNDING: f64 = 1e-6;

impl Description {
    /// For each member, the edges along it. There must be soil on both sides all along.
    pub(super) fn paths(
        &self,
        drawing: &Drawing,
        map: &Map,
        segments: &[Segment],
    ) -> Result<Vec<Vec<LineUse>>, DescriptionError> {
        let path = |member: usize| {
            let wrong = |problem: &str| DescriptionError::entry(self.member_title(member), problem);
            let line = &drawing.members[member];
            let [a, b] = [line[0], line[1]];
            let along = between(a, b);
            let mut path: Vec<LineUse> = Vec::new();
            for (edge, e) in map.arrangement.edges.iter().enumerate() {
                let of_member = |(s, _): &&(usize, bool)| segments[*s].owner == Owner::Member(member);
                if let Some((_, forward)) = e.uses.iter().find(of_member) {
                    path.push(LineUse { line: edge, forward: *forward });
                }
            }
            let place = |walk: &LineUse| dot(between(a, map.walked_points(*walk)[0]), along);
            path.sort_by(|p, q| place(p).total_cmp(&place(q)));
            let covered: f64 = path
                .iter()
                .map(|walk| {
                    let [p, q] = map.walked_points(*walk);
                    length(between(p, q))
                })
                .sum();
            let bends = self.members[member].bends();
            let in_soil = |walk: &LineUse| {
                let sides = [*walk, walk.reversed()].map(|side| map.left_of(side));
                // Edges without soil on either side are not on the map.
                let may_line = |side: &Occupant| side.is_soil() || (bends && *side == Occupant::Outside);
                sides.iter().all(may_line)
            };
            if (covered - length(along)).abs() > ROUNDING * length(along) || !path.iter().all(in_soil) {
                return Err(wrong(if bends {
                    "a beam must have soil all along, on both sides or on one with nothing beyond; let it end where the soil does"
                } else {
                    "it must have soil on both sides all along; let it end where the soil does"
                }));
            }
            let shared = |walk: &LineUse| {
                map.arrangement.edges[walk.line].uses.iter().find_map(|(s, _)| match segments[*s].owner {
                    Owner::Plate(i) => Some(self.plate_title(i)),
                    Owner::Member(i) if i != member => Some(self.member_title(i)),
                    _ => None,
                })
            };
            match path.iter().find_map(shared) {
                Some(other) => Err(wrong(&format!("it lies on {other}; keep one of both"))),
                None => Ok(path),
            }
        };
        (0..self.members.len()).map(path).collect()
    }

    /// Whether all members are where proofs cover them.
    pub(super) fn check_placed(&self, plan: &Plan) -> Result<(), LimitError> {
        let map = &plan.map;
        let mut taken: Vec<(usize, usize)> = Vec::new();
        let ends = |member: usize| {
            let walked = |walk: Option<&LineUse>| walk.map(|walk| map.walked(*walk));
            let path = &plan.members[member];
            [walked(path.first()).map(|ends| ends[0]), walked(path.last()).map(|ends| ends[1])]
        };
        // A flexible member may end at a beam.
        let may_meet = |point: usize, a: usize, b: usize| {
            [(a, b), (b, a)].into_iter().any(|(beam, tie)| {
                self.members[beam].bends() && !self.members[tie].bends() && ends(tie).contains(&Some(point))
            })
        };
        let beam_at = |point: usize| {
            let goes_through = |path: &[LineUse]| path.iter().any(|walk| map.walked(*walk).contains(&point));
            (0..self.members.len()).find(|m| self.members[*m].bends() && goes_through(&plan.members[*m]))
        };
        for (member, path) in plan.members.iter().enumerate() {
            let entry = &self.members[member];
            let wrong = |problem: String| {
                LimitError::from(DescriptionError::entry(self.member_title(member), problem))
            };
            let level = |axis: usize| {
                path.iter().all(|walk| {
                    let [p, q] = map.walked_points(*walk);
                    p[axis] == q[axis]
                })
            };
            if path.len() > 1 && !level(0) && !level(1) {
                return Err(wrong(
                    "it slopes and meets another line (the edge of a region, the water table, or a cut below one of their \
                     corners) between its ends, which no proof covers; make it level, or keep it within one region"
                        .into(),
                ));
            }
            let along = path.iter().flat_map(|walk| [*walk, walk.reversed()]);
            if along.filter_map(|side| plan.holds.get(&side)).any(|holds| !is_loaded(holds)) {
                return Err(wrong(
                    "it lies along what holds the soil; a beam lines ground that is free or loaded".into(),
                ));
            }
            let corners = |walk: &LineUse| map.walked(*walk);
            let points: Vec<usize> = path
                .iter()
                .take(1)
                .map(|w| corners(w)[0])
                .chain(path.iter().map(|w| corners(w)[1]))
                .collect();
            for (i, point) in points.iter().enumerate() {
                let at = map.arrangement.points[*point];
                let meets = |(p, other): &&(usize, usize)| p == point && !may_meet(*point, member, *other);
                if let Some((_, other)) = taken.iter().find(meets) {
                    let other = self.member_title(*other);
                    return Err(wrong(format!(
                        "it meets {other} at ({:.6}, {:.6}), which no proof covers, other than an end of a bar or sheet at a beam; \
                         keep them apart",
                        at[0], at[1]
                    )));
                }
                let holds: Vec<(LineUse, Holds)> = (plan.holds.iter())
                    .filter(|(walk, _)| map.walked(**walk).contains(point))
                    .map(|(walk, holds)| (*walk, *holds))
                    .collect();
                let is_inner = i > 0 && i + 1 < points.len();
                let is_loaded =
                    |(_, holds): &(LineUse, Holds)| matches!(holds, Holds::Free | Holds::Load { .. });
                if is_inner && !(holds.is_empty() || (entry.bends() && holds.iter().all(is_loaded))) {
                    return Err(wrong(format!(
                        "it touches the outline or a structure at ({:.6}, {:.6}), between its ends; let it end there",
                        at[0], at[1]
                    )));
                }
                if is_inner {
                    continue;
                }
                let end = if i == 0 { MemberEnd::Start } else { MemberEnd::End };
                let is_attached = entry.attached.contains(&end);
                let checked = if entry.bends() {
                    check_end_of_beam(is_attached, &holds)
                } else {
                    let beam = beam_at(*point);
                    if is_attached && beam.is_some_and(|beam| ends(beam).contains(&Some(*point))) {
                        Err(
                            "is attached to the very end of a beam, which no proof covers; attach it a little inside",
                        )
                    } else {
                        self.check_end(plan, path, is_attached, beam.is_some(), &holds)
                    }
                };
                checked.map_err(|problem| {
                    let word = match end {
                        MemberEnd::Start => "start",
                        MemberEnd::End => "end",
                    };
                    wrong(format!("its {word} at ({:.6}, {:.6}) {problem}", at[0], at[1]))
                })?;
            }
            taken.extend(points.into_iter().map(|p| (p, member)));
        }
        Ok(())
    }

    /// What is wrong with an end, given all that holds on boundary sides there.
    fn check_end(
        &self,
        plan: &Plan,
        path: &[LineUse],
        is_attached: bool,
        is_at_beam: bool,
        holds: &[(LineUse, Holds)],
    ) -> Result<(), &'static str> {
        if is_at_beam {
            let is_open = holds.iter().all(|(_, holds)| is_loaded(holds));
            let both = "is both at a beam and at what holds the soil, which no proof covers; move it";
            return if is_open { Ok(()) } else { Err(both) };
        }
        let direction = |walk: &LineUse| {
            let [p, q] = plan.map.walked_points(*walk);
            between(p, q)
        };
        let d = path.first().map_or([0.0; 2], direction);
        let is_square = |walk: &LineUse| {
            let t = direction(walk);
            (d[0] == 0.0 && t[1] == 0.0) || (d[1] == 0.0 && t[0] == 0.0)
        };
        let (mut on_ground, mut on_structure) = (false, false);
        for (walk, holds) in holds {
            match holds {
                Holds::Far => return Err("is on a far side, which no proof covers; let it end before"),
                Holds::Free if self.surcharge_kpa == 0.0 && plan.is_bare(self, walk) => {
                    return Err(
                        "is on free ground without cohesion, which no proof covers: it bears nothing there; let the \
                         member end a little below, or give the soil some cohesion",
                    );
                }
                Holds::Free | Holds::Load { .. } => {}
                Holds::Smooth if is_attached && !is_square(walk) => {
                    return Err(
                        "is attached to a smooth side that is not level or upright and at right angles to it",
                    );
                }
                Holds::Face(face)
                    if is_attached
                        && face.delta_deg == 0.0
                        && face.adhesion_kpa == 0.0
                        && !is_square(walk) =>
                {
                    return Err(
                        "is attached to a smooth face that is not level or upright and at right angles to it",
                    );
                }
                Holds::Smooth | Holds::Fixed => on_ground = true,
                Holds::Face(_) => on_structure = true,
            }
        }
        match (is_attached, on_ground, on_structure) {
            (true, false, false) => Err(
                "is attached, but there is no structure, plate, beam, fixed or smooth side that it could be attached to",
            ),
            (true, true, true) => Err("is attached both to a structure that moves and to what is at rest"),
            _ => Ok(()),
        }
    }

    /// Whether a beam goes along a line.
    pub(super) fn is_lined(&self, plan: &Plan, line: usize) -> bool {
        let on = |(entry, path): (&MemberEntry, &Vec<LineUse>)| {
            entry.bends() && path.iter().any(|walk| walk.line == line)
        };
        self.members.iter().zip(&plan.members).any(on)
    }

    /// The members of the statement.
    pub(super) fn statement_members(&self, plan: &Plan, units: &Units) -> Vec<Member> {
        let force = |kn_per_m: f64| units.stress(kn_per_m) / units.length_m;
        let member = |(entry, path): (&MemberEntry, &Vec<LineUse>)| Member {
            name: entry.name.clone(),
            path: path.clone(),
            tension: force(entry.tensile_kn_per_m),
            compression: force(entry.compressive_kn_per_m),
            bond: entry.bond_factor,
            pullout: grips(entry, path, &plan.map, |kn_per_m2| units.stress(kn_per_m2)),
            attached: [MemberEnd::Start, MemberEnd::End].map(|end| entry.attached.contains(&end)),
            bending: entry.moment_knm_per_m.zip(entry.shear_kn_per_m).map(|(moment, shear)| Bending {
                moment: force(moment) / units.length_m,
                shear: force(shear),
            }),
        };
        self.members.iter().zip(&plan.members).map(member).collect()
    }
}

/// Whether it says what acts, and holds nothing.
fn is_loaded(holds: &Holds) -> bool {
    matches!(holds, Holds::Free | Holds::Load { .. })
}

/// What is wrong with an end of a beam, given all that holds on boundary sides there.
fn check_end_of_beam(is_attached: bool, holds: &[(LineUse, Holds)]) -> Result<(), &'static str> {
    let held: Vec<&Holds> = holds.iter().map(|(_, holds)| holds).filter(|holds| !is_loaded(holds)).collect();
    let is_fixed = held.iter().all(|holds| matches!(holds, Holds::Fixed));
    match (is_attached, held.is_empty()) {
        (false, true) => Ok(()),
        (true, false) if is_fixed => Ok(()),
        (true, _) => Err("is attached, but only a fixed side can clamp the end of a beam"),
        (false, false) => Err(
            "is at what holds the soil; attach it, if that is a fixed side that clamps it, or let it end a little before",
        ),
    }
}
