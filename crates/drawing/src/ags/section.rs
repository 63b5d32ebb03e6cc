//! A cross-section through holes: strata with the same code in two neighbours are joined by straight lines, others taper out at the neighbour.

use super::site::{Hole, Stratum};
use crate::{DrawingError, Outline, Point, Shape};

/// A hole in the section.
#[derive(Debug, Clone)]
pub(super) struct Placed<'a> {
    pub(super) x_m: f64,
    pub(super) hole: &'a Hole,
}

/// The holes that were named, along the line from one to the next; or all of them, on the line between the two that are farthest apart. The second answer
/// is how far a hole is from that line, at most (m).
pub(super) fn placed<'a>(
    holes: &'a [Hole],
    named: &[String],
) -> Result<(Vec<Placed<'a>>, f64), DrawingError> {
    let wanted: Vec<&Hole> = if named.is_empty() {
        holes.iter().collect()
    } else {
        let of = |name: &String| {
            let found = holes.iter().find(|hole| hole.name == *name);
            let lacks = || {
                let words = "is it a LOCA_ID of group LOCA, and in group GEOL?";
                DrawingError::Kind(format!("it has no hole {name} with strata: {words}"))
            };
            found.ok_or_else(lacks)
        };
        named.iter().map(of).collect::<Result<_, _>>()?
    };
    if let [hole] = wanted.as_slice() {
        return Ok((vec![Placed { x_m: 0.0, hole }], 0.0));
    }
    let plans = wanted.iter().map(|hole| {
        let lacks =
            || DrawingError::Kind(format!("hole {} has no coordinates; name others with --holes", hole.name));
        hole.plan.ok_or_else(lacks)
    });
    let plans: Vec<Point> = plans.collect::<Result<_, _>>()?;
    let (mut placed, off_m): (Vec<Placed<'a>>, f64) = if named.is_empty() {
        let (from, along) = line(&plans);
        let off = |p: &Point| (along[0] * (p[1] - from[1]) - along[1] * (p[0] - from[0])).abs();
        let x_m = |p: &Point| along[0] * (p[0] - from[0]) + along[1] * (p[1] - from[1]);
        let mut all: Vec<Placed<'a>> =
            wanted.iter().zip(&plans).map(|(hole, p)| Placed { x_m: x_m(p), hole }).collect();
        all.sort_by(|a, b| a.x_m.total_cmp(&b.x_m));
        (all, plans.iter().map(off).fold(0.0, f64::max))
    } else {
        let mut x_m = 0.0;
        let place = |(i, hole): (usize, &&'a Hole)| {
            if i > 0 {
                x_m += distance(plans[i - 1], plans[i]);
            }
            Placed { x_m, hole }
        };
        (wanted.iter().enumerate().map(place).collect(), 0.0)
    };
    let first = placed.first().map_or(0.0, |it| it.x_m);
    placed.iter_mut().for_each(|it| it.x_m -= first);
    Ok((placed, off_m))
}

fn distance(a: Point, b: Point) -> f64 {
    libm::hypot(b[0] - a[0], b[1] - a[1])
}

/// A point and the direction of the line between the two points that are farthest apart, from west to east.
fn line(plans: &[Point]) -> (Point, Point) {
    let mut ends = ([0.0; 2], [1.0, 0.0]);
    let mut longest = 0.0;
    for (i, a) in plans.iter().enumerate() {
        for b in &plans[i + 1..] {
            let length = distance(*a, *b);
            if length > longest {
                longest = length;
                let (a, b) = if (a[0], a[1]) <= (b[0], b[1]) { (a, b) } else { (b, a) };
                ends = (*a, [(b[0] - a[0]) / length, (b[1] - a[1]) / length]);
            }
        }
    }
    ends
}

/// The areas between two holes.
pub(super) fn between(left: &Placed<'_>, right: &Placed<'_>) -> Vec<Shape> {
    let (a, b) = (&left.hole.strata, &right.hole.strata);
    let mut levels = [left.hole.ground_m, right.hole.ground_m];
    let mut shapes = Vec::new();
    for pair in aligned(a, b) {
        let code = pair.iter().flatten().next().map(|stratum| stratum.code.clone());
        let below = [0, 1].map(|side| pair[side].map_or(levels[side], |stratum| stratum.base_m));
        let x = [left.x_m, right.x_m];
        let mut corners: Vec<Point> =
            vec![[x[0], levels[0]], [x[0], below[0]], [x[1], below[1]], [x[1], levels[1]]];
        corners.dedup();
        if corners.first() == corners.last() {
            corners.pop();
        }
        shapes.extend(code.map(|layer| Shape { layer, corners, outline: Outline::Closed }));
        levels = below;
    }
    shapes
}

/// Level layers as deep to either side as a single hole is deep.
pub(super) fn around(hole: &Hole) -> Vec<Shape> {
    let base_m = hole.strata.last().map_or(hole.ground_m, |last| last.base_m);
    let half = hole.ground_m - base_m;
    let area = |stratum: &Stratum| {
        let Stratum { code, top_m, base_m } = stratum;
        let corners = vec![[-half, *top_m], [-half, *base_m], [half, *base_m], [half, *top_m]];
        Shape { layer: code.clone(), corners, outline: Outline::Closed }
    };
    hole.strata.iter().map(area).collect()
}

/// Pairs of strata that are one, and strata that only one of two holes has, from the top downwards: those pairs whose thinner halves are thickest in
/// all (a longest common subsequence with weights).
fn aligned<'a>(a: &'a [Stratum], b: &'a [Stratum]) -> Vec<[Option<&'a Stratum>; 2]> {
    let thickness = |stratum: &Stratum| stratum.top_m - stratum.base_m;
    let gain = |i: usize, j: usize| (a[i].code == b[j].code).then(|| thickness(&a[i]).min(thickness(&b[j])));
    // best[i][j]: of what is left from i and j on.
    let mut best = vec![vec![0.0_f64; b.len() + 1]; a.len() + 1];
    for i in (0..a.len()).rev() {
        for j in (0..b.len()).rev() {
            let apart = best[i + 1][j].max(best[i][j + 1]);
            best[i][j] = gain(i, j).map_or(apart, |gain| apart.max(gain + best[i + 1][j + 1]));
        }
    }
    let (mut i, mut j) = (0, 0);
    let mut pairs = Vec::new();
    while i < a.len() || j < b.len() {
        let together = i < a.len()
            && j < b.len()
            && gain(i, j).is_some_and(|gain| gain + best[i + 1][j + 1] >= best[i][j]);
        let left_first = j == b.len() || (i < a.len() && best[i + 1][j] >= best[i][j + 1]);
        let (take_left, take_right) = if together { (true, true) } else { (left_first, !left_first) };
        pairs.push([take_left.then(|| &a[i]), take_right.then(|| &b[j])]);
        i += usize::from(take_left);
        j += usize::from(take_right);
    }
    pairs
}
