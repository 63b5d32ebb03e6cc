//! Blocks in space in motion: the mechanism behind the upper bound of a plate with ends, seen from above and ahead.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_app::limits::Fields;
use soilctl_certificate::{BeyondFacet, Mechanism, Objective};
use soilctl_figure::{Axis, Figure, Motion, MovingPoint, Size};

use super::frame::INK;
use crate::PageError;

/// How far the fastest block goes in the end, over the greatest side of the mechanism.
const FARTHEST: f64 = 0.15;
/// From where it is seen: to the side of straight ahead, and above the ground, in radians.
const VIEW: [f64; 2] = [0.6, 0.5];
/// Points of a rim that are nearer to each other than this part of the picture are one.
const NEAR: f64 = 0.004;
const SIZE: [u32; 2] = [900, 620];

/// A point or a velocity as it is seen: to the right and up.
fn seen([x, y, z]: [f64; 3]) -> [f64; 2] {
    let ([aside, ahead], [sin, cos]) = ([VIEW[0].sin(), VIEW[0].cos()], [VIEW[1].sin(), VIEW[1].cos()]);
    // Away from the viewer, who stands ahead of the plate and to its side.
    let away = -(x * ahead + y * aside);
    [x * aside - y * ahead, away * sin + z * cos]
}

/// The rims of the blocks' faces, each moving with its block, the plate, and the ground that heaves as it lies at rest.
pub(super) fn blocks(fields: &Fields) -> Result<Option<(Motion, Size)>, PageError> {
    let Some((mechanism, places)) = &fields.blocks else { return Ok(None) };
    let span = |axis: usize| {
        let ends = places
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p[axis]), high.max(p[axis])]);
        ends[1] - ends[0]
    };
    let side = span(0).max(2.0 * span(1)).max(span(2));
    let speed = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let scale = FARTHEST * side / mechanism.velocities.iter().map(speed).fold(f64::MIN_POSITIVE, f64::max);
    let units = &fields.units;
    let moving = |[x, y, z]: [f64; 3], [u, v, w]: [f64; 3], hand: f64| {
        let (at, by) = (seen([x, hand * y, z]), seen([u, hand * v, w]));
        let [ox, oz] = units.point([0.0; 2]);
        let origin = seen([ox, 0.0, oz]);
        let length = units.length;
        MovingPoint {
            at: (origin[0] + length * at[0], origin[1] + length * at[1]),
            by: (length * scale * by[0], length * scale * by[1]),
        }
    };
    let lines = |rims: &[Rim], velocity: &dyn Fn(&Rim) -> [f64; 3]| {
        let both = |hand: f64| {
            rims.iter().map(move |rim| {
                let line: Vec<_> = rim.line.iter().map(|&v| moving(places[v], velocity(rim), hand)).collect();
                thinned(line, NEAR * side * units.length)
            })
        };
        both(1.0).chain(both(-1.0)).collect::<Vec<_>>()
    };
    let rims = rims(mechanism, places);
    let of = |wanted: &dyn Fn(&Rim) -> bool| rims.iter().filter(|r| wanted(r)).cloned().collect::<Vec<_>>();
    let ground = lines(&of(&|r| r.beyond == BeyondFacet::Surface), &|_| [0.0; 3]);
    let moved = lines(&of(&|r| r.beyond != BeyondFacet::Plate), &|rim| mechanism.velocities[rim.block]);
    let Objective::Structure { velocity: [u, w] } = fields.statement()?.objective else { return Ok(None) };
    let plate = lines(&of(&|r| r.beyond == BeyondFacet::Plate), &|_| [u, 0.0, w]);
    let mut motion = Motion::new(picture(fields, [&ground, &moved, &plate])?);
    motion.lines(ground, 0.8, None).lines(moved, 1.0, None).lines(plate, 3.0, Some(INK));
    Ok(Some((motion, Size::new(SIZE[0], SIZE[1])?)))
}

/// An empty picture of all these lines, with what they reach in motion.
fn picture(fields: &Fields, lines: [&Vec<Vec<MovingPoint>>; 3]) -> Result<Figure, PageError> {
    let all = lines.into_iter().flatten().flatten();
    let ends = all.flat_map(|p| [p.at, (p.at.0 + p.by.0, p.at.1 + p.by.1)]);
    let [low, high] = ends.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
        [[low[0].min(p.0), low[1].min(p.1)], [high[0].max(p.0), high[1].max(p.1)]]
    });
    let margin = 0.04 * (high[0] - low[0]).max(high[1] - low[1]);
    let what = "Upper bound, blocks in space";
    let title = if fields.title.is_empty() { what.to_owned() } else { format!("{what}: {}", fields.title) };
    let unit = &fields.units.length_name;
    let axis = |name: &str, k: usize| {
        Axis::linear(format!("{name} ({unit})")).range(low[k] - margin, high[k] + margin)
    };
    Ok(Figure::new(title, axis("seen from above and ahead", 0)?, axis("up", 1)?).with_equal_aspect()?)
}

/// The rim of the facets that a block has in common with one thing beyond, as a line without what lies in the plane of
/// symmetry.
#[derive(Debug, Clone)]
struct Rim {
    block: usize,
    beyond: BeyondFacet,
    line: Vec<usize>,
}

/// Rims of all faces but those to soil at rest; one between two blocks is there for each.
fn rims(mechanism: &Mechanism, places: &[[f64; 3]]) -> Vec<Rim> {
    let key = |beyond: BeyondFacet| match beyond {
        BeyondFacet::Rest | BeyondFacet::Symmetry => None,
        BeyondFacet::Block(other) => Some(3 + other),
        BeyondFacet::Surface => Some(0),
        BeyondFacet::Plate => Some(1),
    };
    /// What is beyond a face, and edges of its facets that are walked in one sense only.
    struct Face {
        beyond: BeyondFacet,
        edges: BTreeSet<[usize; 2]>,
    }
    let mut faces: BTreeMap<(usize, usize), Face> = BTreeMap::new();
    for facet in &mechanism.facets {
        let Some(beyond) = key(facet.beyond) else { continue };
        let new = || Face { beyond: facet.beyond, edges: BTreeSet::new() };
        let Face { edges, .. } = faces.entry((facet.block, beyond)).or_insert_with(new);
        for k in 0..3 {
            let edge = [facet.corners[k], facet.corners[(k + 1) % 3]];
            // An edge that is walked both ways is inside.
            if !edges.remove(&[edge[1], edge[0]]) {
                edges.insert(edge);
            }
        }
    }
    let mut rims = Vec::new();
    for ((block, _), Face { beyond, edges }) in faces {
        let off_symmetry = |edge: &&[usize; 2]| edge.iter().any(|&v| places[v][1] != 0.0);
        let next: BTreeMap<usize, usize> = edges.iter().filter(off_symmetry).map(|&[a, b]| (a, b)).collect();
        let ends: BTreeSet<usize> = next.values().copied().collect();
        let start = next.keys().find(|v| !ends.contains(v)).or(next.keys().next());
        let mut line: Vec<usize> = start.copied().into_iter().collect();
        while let Some(&to) = line.last().and_then(|v| next.get(v)).filter(|_| line.len() <= next.len()) {
            line.push(to);
        }
        if let BeyondFacet::Block(other) = beyond {
            rims.push(Rim { block: other, beyond, line: line.clone() });
        }
        rims.push(Rim { block, beyond, line });
    }
    rims
}

/// A line without points that are too near to the last one that is kept.
fn thinned(line: Vec<MovingPoint>, near: f64) -> Vec<MovingPoint> {
    let count = line.len();
    let mut kept: Vec<MovingPoint> = Vec::new();
    for (i, point) in line.into_iter().enumerate() {
        let far =
            kept.last().is_none_or(|last| (last.at.0 - point.at.0).hypot(last.at.1 - point.at.1) > near);
        if far || i + 1 == count {
            kept.push(point);
        }
    }
    kept
}
