//! The triangulation of lines and fans, before anything is refined.

use std::collections::BTreeSet;

use super::MeshError;
use super::cut::Profile;
use super::domain::Domain;
use super::fan::Disc;
use super::guide::Forced;
use super::place::place;
use super::triangulation::triangulate;
use super::wanted::Wanted;
use super::work::{Held, Kind, Node, Work};
use crate::vector::Point;

impl<'a> Work<'a> {
    /// Cuts the lines, at the places where guides meet them and in between, adds the fans, and triangulates.
    pub(super) fn new(
        domain: &'a Domain<'a>,
        wanted: &'a Wanted<'a>,
        profiles: &[Profile],
        forced: &[Forced],
        discs: &[Disc],
    ) -> Result<Self, MeshError> {
        let node = |at, kind, size| Node { at, kind, size };
        let mut nodes: Vec<Node> =
            domain.frame.iter().map(|&p| node(p, Kind::Frame, f64::INFINITY)).collect();
        let mut corner = vec![0; domain.statement.points.len()];
        for &c in &domain.corners {
            corner[c] = nodes.len();
            nodes.push(node(domain.statement.points[c], Kind::Corner(c), f64::INFINITY));
        }
        let mut constraints = Vec::new();
        // The vertices next to each line's ends.
        let mut next = Vec::with_capacity(profiles.len());
        for (line, profile) in profiles.iter().enumerate() {
            let (ends, length) = (domain.statement.lines[line], domain.length(line));
            for (point, size) in [ends.from, ends.to].into_iter().zip(profile.ends()) {
                nodes[corner[point]].size = nodes[corner[point]].size.min(size);
            }
            let mut last = corner[ends.from];
            let Forced { free, met } = &forced[line];
            let first = nodes.len();
            let mut push = |s: f64| {
                constraints.push([last, nodes.len()]);
                last = nodes.len();
                nodes.push(node(domain.on_line(line, s), Kind::Line { line, s }, profile.size(s * length)));
            };
            let mut start = free[0];
            if start > 0.0 {
                push(start);
            }
            for &s in met.iter().chain([&free[1]]) {
                profile.cuts(start * length, s * length).into_iter().for_each(|x| push(x / length));
                if s < 1.0 {
                    push(s);
                }
                start = s;
            }
            constraints.push([last, corner[ends.to]]);
            next.push([first, last]);
        }
        let mut held = Held::new();
        for disc in discs {
            let first = |(line, starts): (usize, bool)| next[line][usize::from(!starts)];
            held.append(&mut place(disc, wanted, &mut nodes, corner[disc.corner], first)?);
        }
        let on_lines: BTreeSet<[usize; 2]> = constraints.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        constraints.extend(held.keys().filter(|e| !on_lines.contains(*e)));
        let points: Vec<Point> = nodes.iter().map(|n| n.at).collect();
        let cdt = triangulate(&points, &constraints)?;
        let mut work = Self { domain, wanted, nodes, cdt, held, triangles: 0 };
        work.count()?;
        work.grade_all();
        Ok(work)
    }
}
