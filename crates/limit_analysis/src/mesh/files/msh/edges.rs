//! The edges of a file's mesh that belong to its outline.

use std::collections::{BTreeMap, BTreeSet};

use super::super::FileError;
use super::GUIDES;
use super::parts::Parts;
use super::read::Raw;

/// An edge on a line of the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Edge {
    pub(super) ends: [usize; 2],
    /// Regions on the left and on the right.
    pub(super) regions: [Option<usize>; 2],
    /// The curve that it is part of, if the file says so.
    pub(super) curve: Option<i64>,
    /// Physical groups, ascending.
    pub(super) groups: Vec<i64>,
}

/// A line element.
struct Mark {
    tag: u64,
    ends: [usize; 2],
    curve: i64,
    groups: Vec<i64>,
}

/// Line elements by their sorted ends.
type Marks = BTreeMap<[usize; 2], Mark>;

/// The edges of the outline, those of curves first, in the order of the file; and the edges of guides.
pub(super) fn hard_edges(raw: &mut Raw, parts: &Parts) -> Result<(Vec<Edge>, Vec<[usize; 2]>), FileError> {
    let (marks, mut guides) = marks(raw, parts)?;
    let regions = |[a, b]: [usize; 2]| [parts.left([a, b]), parts.left([b, a])];
    let mut edges = Vec::new();
    let mut by_curve: Vec<&Mark> = marks.values().collect();
    by_curve.sort_by_key(|m| (m.curve, m.tag));
    for m in by_curve {
        let regions = regions(m.ends);
        edges.push(Edge { ends: m.ends, regions, curve: Some(m.curve), groups: m.groups.clone() });
    }
    for &(ends, _) in &parts.sides {
        let regions = regions(ends);
        // Of an interface, that side is taken which comes first.
        let first = regions[1].is_none() || regions[0] < regions[1];
        if regions[0] != regions[1] && first && !marks.contains_key(&sorted(ends)) {
            edges.push(Edge { ends, regions, curve: None, groups: Vec::new() });
        }
    }
    let on_lines: BTreeSet<[usize; 2]> = edges.iter().map(|e| sorted(e.ends)).collect();
    guides.retain(|g| !on_lines.contains(g));
    Ok((edges, guides))
}

/// Line elements that are on lines of the outline by their sorted ends, and those on guides.
fn marks(raw: &mut Raw, parts: &Parts) -> Result<(Marks, Vec<[usize; 2]>), FileError> {
    let mut elements = std::mem::take(&mut raw.elements[1]);
    elements.sort_by_key(|e| e.tag);
    if let Some(pair) = elements.windows(2).find(|p| p[0].tag == p[1].tag) {
        return Err(FileError::Twice { line: pair[1].line, what: "line element", tag: pair[1].tag });
    }
    let grouped = elements.iter().any(|e| !raw.groups(e, 1).is_empty());
    let mut marks = Marks::new();
    let mut guides = Vec::new();
    for e in &elements {
        let nodes = [e.nodes[0], e.nodes[1]];
        if let Some(&tag) = nodes.iter().find(|n| !raw.nodes.contains_key(n)) {
            return Err(FileError::Missing { line: e.line, what: "node", tag });
        }
        let groups = raw.groups(e, 1);
        let counts = !grouped || !groups.is_empty();
        let ends = match nodes.map(|n| parts.vertex(n)) {
            [Some(a), Some(b)] if parts.left([a, b]).or(parts.left([b, a])).is_some() => [a, b],
            _ if counts => return Err(FileError::LooseLine { line: e.line, tag: e.tag }),
            _ => continue,
        };
        if groups.iter().any(|&g| raw.names.get(&(1, g)).is_some_and(|name| name == GUIDES)) {
            guides.push(sorted(ends));
            continue;
        }
        let [left, right] = [parts.left(ends), parts.left([ends[1], ends[0]])];
        if !counts && left == right {
            continue;
        }
        let new = || Mark { tag: e.tag, ends, curve: e.entity, groups: Vec::new() };
        let mark = marks.entry(sorted(ends)).or_insert_with(new);
        mark.groups.extend(groups);
        mark.groups.sort_unstable();
        mark.groups.dedup();
    }
    guides.sort_unstable();
    guides.dedup();
    Ok((marks, guides))
}

fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}
