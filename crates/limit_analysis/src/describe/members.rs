//! Members: the edges along them, and where they may be.

use soilctl_certificate::{LineUse, Member};

use super::error::DescriptionError;
use super::fill::Units;
use super::ground::Map;
use super::holds::Holds;
use super::input::Description;
use super::parts::MemberEnd;
use super::plan::Plan;
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
            let in_soil =
                |walk: &LineUse| map.left_of(*walk).is_soil() && map.left_of(walk.reversed()).is_soil();
            if (covered - length(along)).abs() > ROUNDING * length(along) || !path.iter().all(in_soil) {
                return Err(wrong(
                    "it must have soil on both sides all along; let it end where the soil does",
                ));
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
            let corners = |walk: &LineUse| map.walked(*walk);
            let points: Vec<usize> = path
                .iter()
                .take(1)
                .map(|w| corners(w)[0])
                .chain(path.iter().map(|w| corners(w)[1]))
                .collect();
            for (i, point) in points.iter().enumerate() {
                let at = map.arrangement.points[*point];
                if let Some((_, other)) = taken.iter().find(|(p, _)| p == point) {
                    let other = self.member_title(*other);
                    return Err(wrong(format!(
                        "it meets {other} at ({:.6}, {:.6}), which no proof covers; keep them apart",
                        at[0], at[1]
                    )));
                }
                let holds: Vec<(LineUse, Holds)> = (plan.holds.iter())
                    .filter(|(walk, _)| map.walked(**walk).contains(point))
                    .map(|(walk, holds)| (*walk, *holds))
                    .collect();
                let is_inner = i > 0 && i + 1 < points.len();
                if is_inner && !holds.is_empty() {
                    return Err(wrong(format!(
                        "it touches the outline or a structure at ({:.6}, {:.6}), between its ends; let it end there",
                        at[0], at[1]
                    )));
                }
                if is_inner {
                    continue;
                }
                let end = if i == 0 { MemberEnd::Start } else { MemberEnd::End };
                self.check_end(plan, path, entry.attached.contains(&end), &holds).map_err(|problem| {
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
        holds: &[(LineUse, Holds)],
    ) -> Result<(), &'static str> {
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
                "is attached, but there is no structure, plate, fixed or smooth side that it could be attached to",
            ),
            (true, true, true) => Err("is attached both to a structure that moves and to what is at rest"),
            _ => Ok(()),
        }
    }

    /// The members of the statement.
    pub(super) fn statement_members(&self, plan: &Plan, units: &Units) -> Vec<Member> {
        let force = |kn_per_m: f64| units.stress(kn_per_m) / units.length_m;
        let member = |(entry, path): (&super::MemberEntry, &Vec<LineUse>)| Member {
            name: entry.name.clone(),
            path: path.clone(),
            tension: force(entry.tensile_kn_per_m),
            compression: force(entry.compressive_kn_per_m),
            bond: entry.bond_factor,
            attached: [MemberEnd::Start, MemberEnd::End].map(|end| entry.attached.contains(&end)),
        };
        self.members.iter().zip(&plan.members).map(member).collect()
    }
}
