//! What members bear, and where they stretch.

use soilctl_certificate::ShownMember;

use super::Point;
use super::flow::FlowResults;
use super::stress::StressResults;
use crate::vector::distance;

/// Points between the ends of each edge at which an axial force is told.
const BETWEEN: usize = 4;

/// A change of velocity below this part of the greatest is rounding.
const ROUNDING: f64 = 1e-6;

/// A piece of a member yields visibly where its ends part by this fraction of the speed that others are compared with.
const YIELDING: f64 = 0.01;

/// The axial force along a member, tension positive.
#[derive(Debug, Clone, PartialEq)]
pub struct AxialForce {
    /// Index of the member.
    pub member: usize,
    /// Start and end of the member.
    pub ends: [Point; 2],
    /// Distances from the start (length), and the force there (force per width).
    pub points: Vec<[f64; 2]>,
}

impl AxialForce {
    /// The point with the greatest tension: distance and force.
    #[must_use]
    pub fn greatest(&self) -> [f64; 2] {
        self.points.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default()
    }

    /// The point with the greatest compression: distance and force.
    #[must_use]
    pub fn least(&self) -> [f64; 2] {
        self.points.iter().copied().min_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or_default()
    }
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
}

impl StressResults {
    /// The axial force of each member.
    #[must_use]
    pub fn axial_forces(&self) -> Vec<AxialForce> {
        let edges = &self.shown.members;
        let of = |member: usize| {
            let mut points: Vec<[f64; 2]> = Vec::new();
            let (mut ends, mut from): (Option<[Point; 2]>, f64) = (None, 0.0);
            for edge in edges.iter().filter(|edge| edge.member == member) {
                ends = Some([ends.map_or(edge.ends[0], |ends| ends[0]), edge.ends[1]]);
                let length = distance(edge.ends[0], edge.ends[1]);
                let [a, b, c] = edge.along;
                let first = usize::from(!points.is_empty());
                points.extend((first..=BETWEEN).map(|i| {
                    let s = i as f64 / BETWEEN as f64;
                    let force = (1.0 - s) * (1.0 - s) * a + 2.0 * s * (1.0 - s) * b + s * s * c;
                    [from + s * length, force]
                }));
                from += length;
            }
            ends.map(|ends| AxialForce { member, ends, points })
        };
        (0..self.statement.members.len()).filter_map(of).collect()
    }
}

impl FlowResults {
    /// Pieces of members that get longer or shorter, from end to end, with jumps to the next piece.
    #[must_use]
    pub fn yielding(&self) -> Vec<[Point; 2]> {
        let edges = &self.shown.members;
        let least = YIELDING * self.speed();
        let is_yielding = |(i, edge): &(usize, &ShownMember)| {
            let [a, b, c] = edge.along;
            let next =
                edges.get(i + 1).filter(|next| next.member == edge.member).map_or(c, |next| next.along[0]);
            [b - a, c - b, next - c].iter().map(|change| change.abs()).sum::<f64>() > least
        };
        edges.iter().enumerate().filter(is_yielding).map(|(_, edge)| edge.ends).collect()
    }

    /// How each member stretches. Ends that are pulled off what they are attached to do not count.
    #[must_use]
    pub fn member_stretches(&self) -> Vec<MemberStretch> {
        let least = ROUNDING * self.speed();
        let of = |member: usize| {
            let velocities: Vec<f64> = (self.shown.members.iter().filter(|edge| edge.member == member))
                .flat_map(|edge| edge.along)
                .collect();
            let (mut longer, mut shorter) = (0.0, 0.0);
            for w in velocities.windows(2) {
                longer += (w[1] - w[0]).max(0.0);
                shorter += (w[0] - w[1]).max(0.0);
            }
            let kept = |x: f64| if x > least { x } else { 0.0 };
            MemberStretch { member, longer: kept(longer), shorter: kept(shorter) }
        };
        (0..self.statement.members.len()).map(of).collect()
    }
}
