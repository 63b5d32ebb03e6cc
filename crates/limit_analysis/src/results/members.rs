//! What members bear, and where they stretch.

use soilctl_certificate::{ShownAcross, ShownMember};

use super::Point;
use super::flow::FlowResults;
use super::stress::StressResults;
use crate::vector::distance;

/// Points between the ends of each edge at which an axial force is told.
pub(super) const BETWEEN: usize = 4;

/// A change of velocity below this part of the greatest is rounding.
const ROUNDING: f64 = 1e-6;

/// A piece of a member yields visibly where its ends part by this fraction of the speed that others are compared with.
const YIELDING: f64 = 0.01;

/// Distances from the start of a member (length), and what there is at each.
pub type Course = Vec<[f64; 2]>;

/// What a member bears along itself.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberForces {
    /// Index of the member.
    pub member: usize,
    /// Start and end of the member.
    pub ends: [Point; 2],
    /// The axial force, tension positive (force per width).
    pub axial: Course,
    /// What a beam bears by bending.
    pub bending: Option<BeamForces>,
}

/// What a beam bears by bending.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BeamForces {
    /// The bending moment (force times length per width), positive where it stretches the right side of the beam.
    pub moment: Course,
    /// The shear force, the change of the moment along the beam (force per width).
    pub shear: Course,
}

/// The point with the greatest value.
#[must_use]
pub fn greatest(course: &[[f64; 2]]) -> [f64; 2] {
    course.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default()
}

/// The point with the least value.
#[must_use]
pub fn least(course: &[[f64; 2]]) -> [f64; 2] {
    course.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default()
}

/// The point with the value that is farthest from zero.
#[must_use]
pub fn farthest(course: &[[f64; 2]]) -> [f64; 2] {
    let [most, least] = [greatest(course), least(course)];
    if most[1] >= -least[1] { most } else { least }
}

/// A polynomial from its Bernstein coefficients.
pub(super) fn polynomial<const N: usize>(coefficients: [f64; N], s: f64) -> f64 {
    let mut values = coefficients;
    for last in (1..N).rev() {
        for i in 0..last {
            values[i] = (1.0 - s) * values[i] + s * values[i + 1];
        }
    }
    values[0]
}

/// How a member stretches in a flow.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberStretch {
    /// Index of the member.
    pub member: usize,
    /// What it gets longer in a unit of time, added up along the member.
    pub longer: f64,
    /// What it gets shorter, likewise.
    pub shorter: f64,
    /// The greatest speed at which bars of a row slip in the soil at them, where that holds on to them; nothing of other members.
    pub slip: Option<f64>,
    /// Where a beam bends: distances from its start, and how fast it turns there (velocity over length).
    pub hinges: Course,
}

impl StressResults {
    /// What each member bears.
    #[must_use]
    pub fn member_forces(&self) -> Vec<MemberForces> {
        let edges = &self.shown.members;
        let of = |member: usize| {
            let (mut axial, mut bending) = (Course::new(), None::<BeamForces>);
            let (mut ends, mut from): (Option<[Point; 2]>, f64) = (None, 0.0);
            for edge in edges.iter().filter(|edge| edge.member == member) {
                ends = Some([ends.map_or(edge.ends[0], |ends| ends[0]), edge.ends[1]]);
                let length = distance(edge.ends[0], edge.ends[1]);
                let first = usize::from(!axial.is_empty());
                let steps = || (first..=BETWEEN).map(|i| i as f64 / BETWEEN as f64);
                axial.extend(steps().map(|s| [from + s * length, polynomial(edge.along, s)]));
                if let Some(ShownAcross::Forces { moment, shear }) = edge.across {
                    let all = bending.get_or_insert_default();
                    all.moment.extend(steps().map(|s| [from + s * length, polynomial(moment, s)]));
                    // It jumps where another member is attached.
                    let steps = (0..=BETWEEN).map(|i| i as f64 / BETWEEN as f64);
                    all.shear.extend(steps.map(|s| [from + s * length, polynomial(shear, s)]));
                }
                from += length;
            }
            ends.map(|ends| MemberForces { member, ends, axial, bending })
        };
        (0..self.statement.members.len()).filter_map(of).collect()
    }
}

impl FlowResults {
    /// Pieces of members that get longer or shorter, or beside which beams turn, from end to end, with jumps to the next piece.
    #[must_use]
    pub fn yielding(&self) -> Vec<[Point; 2]> {
        let edges = &self.shown.members;
        let least = YIELDING * self.speed();
        let is_yielding = |(i, edge): &(usize, &ShownMember)| {
            let [a, b, c] = edge.along;
            let next = edges.get(i + 1).filter(|next| next.member == edge.member);
            let goes_on = next.map_or(c, |next| next.along[0]);
            let stretch = [b - a, c - b, goes_on - c].iter().map(|change| change.abs()).sum::<f64>();
            let reach: f64 = (edges.iter().filter(|other| other.member == edge.member))
                .map(|other| distance(other.ends[0], other.ends[1]))
                .sum();
            let turns = turn(edge, next).iter().map(|turn| turn.abs()).sum::<f64>();
            stretch > least || turns * reach > least
        };
        edges.iter().enumerate().filter(is_yielding).map(|(_, edge)| edge.ends).collect()
    }

    /// How each member stretches. Ends that are pulled off what they are attached to do not count.
    #[must_use]
    pub fn member_stretches(&self) -> Vec<MemberStretch> {
        let least = ROUNDING * self.speed();
        let of = |member: usize| {
            let edges: Vec<&ShownMember> =
                self.shown.members.iter().filter(|edge| edge.member == member).collect();
            let velocities: Vec<f64> = edges.iter().flat_map(|edge| edge.along).collect();
            let (mut longer, mut shorter) = (0.0, 0.0);
            for w in velocities.windows(2) {
                longer += (w[1] - w[0]).max(0.0);
                shorter += (w[0] - w[1]).max(0.0);
            }
            let whole: f64 = edges.iter().map(|edge| distance(edge.ends[0], edge.ends[1])).sum();
            let (mut hinges, mut from) = (Course::new(), 0.0);
            for (i, edge) in edges.iter().enumerate() {
                let length = distance(edge.ends[0], edge.ends[1]);
                let [within, after] = turn(edge, edges.get(i + 1).copied());
                for (place, turn) in [(from + 0.5 * length, within), (from + length, after)] {
                    if turn.abs() * whole > YIELDING * self.speed() {
                        hinges.push([place, turn]);
                    }
                }
                from += length;
            }
            let kept = |x: f64| if x > least { x } else { 0.0 };
            let slips = edges.iter().filter_map(|edge| match edge.across {
                Some(ShownAcross::Slip(slip)) => Some([0.0, 0.5, 1.0].map(|s| polynomial(slip, s).abs())),
                Some(ShownAcross::Velocity(_) | ShownAcross::Forces { .. }) | None => None,
            });
            let slip = slips.flatten().reduce(f64::max);
            MemberStretch { member, longer: kept(longer), shorter: kept(shorter), slip, hinges }
        };
        (0..self.statement.members.len()).map(of).collect()
    }
}

/// How much faster a beam turns at the end of an edge than at its start, and at the start of the next one than at the end.
fn turn(edge: &ShownMember, next: Option<&ShownMember>) -> [f64; 2] {
    let slopes = |edge: &ShownMember| match edge.across {
        Some(ShownAcross::Velocity([a, b, c])) => {
            let by = 2.0 / distance(edge.ends[0], edge.ends[1]);
            Some([by * (b - a), by * (c - b)])
        }
        Some(ShownAcross::Forces { .. } | ShownAcross::Slip(_)) | None => None,
    };
    let Some([start, end]) = slopes(edge) else { return [0.0; 2] };
    [end - start, next.and_then(slopes).map_or(0.0, |[next, _]| next - end)]
}
