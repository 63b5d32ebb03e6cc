//! Segments cut where they meet: points and edges that share ends only.

use std::collections::BTreeMap;

use super::error::DescriptionError;
use super::segments::{Owner, Segment};
use crate::vector::{Point, between, cross, distance_to_segment, dot, length};

/// Most points after cutting: bounds time and memory for lines that cross each other everywhere.
const MAX_POINTS: usize = 5000;

/// A piece of one or several segments.
#[derive(Debug, Clone)]
pub(super) struct Edge {
    pub(super) ends: [usize; 2],
    /// The segments on it, and whether they run the same way.
    pub(super) uses: Vec<(usize, bool)>,
}

/// The pieces of all segments.
#[derive(Debug, Clone, Default)]
pub(super) struct Arrangement {
    pub(super) points: Vec<Point>,
    pub(super) edges: Vec<Edge>,
}

/// Where two segments cross inside both.
fn crossing([a, b]: [Point; 2], [c, d]: [Point; 2]) -> Option<Point> {
    let (ab, cd, ac) = (between(a, b), between(c, d), between(a, c));
    let turn = cross(ab, cd);
    if turn.abs() <= 1e-15 * length(ab) * length(cd) {
        return None;
    }
    let (s, t) = (cross(ac, cd) / turn, cross(ac, ab) / turn);
    let inside = |x: f64| x > 0.0 && x < 1.0;
    (inside(s) && inside(t)).then(|| {
        // What is vertical or level stays so exactly.
        [0, 1].map(|i| match () {
            () if ab[i] == 0.0 => a[i],
            () if cd[i] == 0.0 => c[i],
            () => a[i] + s * ab[i],
        })
    })
}

/// Whether the boxes around two segments are apart.
fn apart(a: [Point; 2], b: [Point; 2], by: f64) -> bool {
    [0, 1].into_iter().any(|i| {
        a[0][i].max(a[1][i]) + by < b[0][i].min(b[1][i]) || b[0][i].max(b[1][i]) + by < a[0][i].min(a[1][i])
    })
}

impl Arrangement {
    /// Cuts all segments where they meet; what is within `snap` is one. `title` names a segment's owner.
    pub(super) fn new(
        segments: &[Segment],
        snap: f64,
        title: &dyn Fn(Owner) -> String,
    ) -> Result<Self, DescriptionError> {
        let mut all = Self::default();
        let mut on: Vec<Vec<usize>> = Vec::new();
        for segment in segments {
            let ends = [all.point(segment.ends[0], snap)?, all.point(segment.ends[1], snap)?];
            on.push(ends.to_vec());
        }
        for (i, first) in segments.iter().enumerate() {
            for (j, second) in segments.iter().enumerate().skip(i + 1) {
                if apart(first.ends, second.ends, snap) {
                    continue;
                }
                let ends = [[on[i][0], on[i][1]], [on[j][0], on[j][1]]];
                let mut joined = ends[0].iter().any(|p| ends[1].contains(p));
                for (own, [own_ends, others]) in [(i, ends), (j, [ends[1], ends[0]])] {
                    for p in others.into_iter().filter(|p| !own_ends.contains(p)) {
                        // What a third segment has shown to be on it counts too: where lines that run together would cross is rounding.
                        let is_known = on[own].contains(&p);
                        if is_known || distance_to_segment(all.points[p], segments[own].ends) <= snap {
                            joined = true;
                            check_self(first, second, all.points[p], title)?;
                            if !is_known {
                                on[own].push(p);
                            }
                        }
                    }
                }
                if joined {
                    continue;
                }
                if let Some(at) = crossing(first.ends, second.ends) {
                    check_self(first, second, at, title)?;
                    let p = all.point(at, snap)?;
                    for own in [i, j] {
                        if !on[own].contains(&p) {
                            on[own].push(p);
                        }
                    }
                }
            }
        }
        all.join(segments, on);
        Ok(all)
    }

    /// Index of a point, new if there is none so close.
    fn point(&mut self, at: Point, snap: f64) -> Result<usize, DescriptionError> {
        let near = |p: &Point| (p[0] - at[0]).abs() <= snap && (p[1] - at[1]).abs() <= snap;
        if let Some(found) = self.points.iter().position(near) {
            return Ok(found);
        }
        if self.points.len() >= MAX_POINTS {
            let count = self.points.len() + 1;
            return Err(DescriptionError::TooMuch {
                what: "points where lines meet",
                count,
                limit: MAX_POINTS,
            });
        }
        self.points.push(at);
        Ok(self.points.len() - 1)
    }

    /// Makes edges of the points on each segment.
    fn join(&mut self, segments: &[Segment], on: Vec<Vec<usize>>) {
        let mut known: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for (index, mut points) in on.into_iter().enumerate() {
            let [a, b] = segments[index].ends;
            let along = between(a, b);
            let place = |p: &usize| dot(between(a, self.points[*p]), along);
            points.sort_by(|p, q| place(p).total_cmp(&place(q)));
            points.dedup();
            for pair in points.windows(2) {
                let [p, q] = [pair[0], pair[1]];
                let key = [p.min(q), p.max(q)];
                let edge = *known.entry(key).or_insert_with(|| {
                    self.edges.push(Edge { ends: key, uses: Vec::new() });
                    self.edges.len() - 1
                });
                self.edges[edge].uses.push((index, p < q));
            }
        }
    }

    pub(super) fn ends(&self, edge: usize) -> [Point; 2] {
        self.edges[edge].ends.map(|p| self.points[p])
    }
}

/// A polygon or line must not meet itself but where one segment follows another.
fn check_self(
    first: &Segment,
    second: &Segment,
    at: Point,
    title: &dyn Fn(Owner) -> String,
) -> Result<(), DescriptionError> {
    if first.owner != second.owner || matches!(first.owner, Owner::Cut(_)) {
        return Ok(());
    }
    let problem = format!("it crosses or touches itself at ({:.6}, {:.6})", at[0], at[1]);
    Err(DescriptionError::entry(title(first.owner), problem))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::describe::segments::Cut;

    #[test]
    fn lines_that_run_together_do_not_cross() {
        // On the slope of a dam, between two points that other cuts have shown to be on it.
        let slope = [[24.0, 0.0], [14.0, 5.0]];
        let [a, b] = [[20.573418905511858, 1.713290547244072], [20.940460336710384, 1.529769831644808]];
        let cut = |ends| Segment { ends, owner: Owner::Cut(Cut::Flow), number: 0 };
        let segments = [
            Segment { ends: slope, owner: Owner::Region(0), number: 0 },
            cut([a, [20.546658990751563, 1.2926499571922816]]),
            cut([b, [20.91296435124675, 1.168858719304908]]),
            cut([a, b]),
        ];
        let found = Arrangement::new(&segments, 2.4e-8, &|_| String::new()).unwrap();
        assert_eq!(found.points.len(), 6, "{:?}", found.points);
        assert_eq!(found.edges.len(), 5);
    }
}
