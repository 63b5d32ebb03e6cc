//! Edges of facets, counted: whether facets close up, and what is along the rim where they do not.

use std::collections::BTreeMap;

/// How often each edge is walked, from its lesser vertex to its greater one less the other way.
#[derive(Debug, Default)]
pub(super) struct Edges(BTreeMap<[usize; 2], i64>);

impl Edges {
    /// Adds the edges of a triangle, walked forwards or backwards.
    pub(super) fn add(&mut self, corners: [usize; 3], forward: bool) {
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            let sign = if (a < b) == forward { 1 } else { -1 };
            *self.0.entry([a.min(b), a.max(b)]).or_default() += sign;
        }
    }

    /// Edges that are walked more often in one sense than in the other, as often as they are.
    pub(super) fn rim(&self) -> impl Iterator<Item = [usize; 2]> {
        self.0.iter().flat_map(|(&[a, b], &count)| {
            let edge = if count > 0 { [a, b] } else { [b, a] };
            (0..count.unsigned_abs()).map(move |_| edge)
        })
    }

    /// Whether each edge is walked as often in one sense as in the other.
    pub(super) fn is_closed(&self) -> bool {
        self.0.values().all(|&count| count == 0)
    }
}

/// Whether a rim goes once around the rectangle from (0, 0) to (1, `width`), counter-clockwise.
pub(super) fn goes_around(rim: &[[[f64; 2]; 2]], width: f64) -> bool {
    // For each side the coordinate that is constant, its value, and where the other starts and ends.
    let sides =
        [(1, 0.0, [0.0, 1.0]), (0, 1.0, [0.0, width]), (1, width, [1.0, 0.0]), (0, 0.0, [width, 0.0])];
    let mut count = 0;
    let whole = sides.iter().all(|&(axis, value, [start, end])| {
        let mut along: Vec<[f64; 2]> = rim
            .iter()
            .filter(|edge| edge.iter().all(|p| p[axis] == value))
            .map(|edge| edge.map(|p| p[1 - axis]))
            .collect();
        count += along.len();
        along.sort_by(|a, b| a[0].total_cmp(&b[0]));
        if start > end {
            along.reverse();
        }
        let joined = along.windows(2).all(|pair| pair[0][1] == pair[1][0]);
        let forward = along.iter().all(|[from, to]| (to > from) == (end > start));
        let ends = along.first().zip(along.last()).map(|(first, last)| [first[0], last[1]]);
        joined && forward && ends == Some([start, end])
    });
    whole && count == rim.len()
}
