//! An order of elimination: nested dissection by coordinates (George 1973). Nothing is proven; a bad order only takes
//! longer.

/// A part of the order: what separates its children from each other, eliminated after them.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) groups: Vec<usize>,
    pub(super) children: Vec<usize>,
}

/// Largest part that is not cut any more.
const LEAF: usize = 24;

/// Parts, children before what separates them; the last is the whole.
pub(super) fn dissect(places: &[[f64; 3]], neighbours: &[Vec<usize>]) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut side = vec![0; places.len()];
    if !places.is_empty() {
        cut((0..places.len()).collect(), places, neighbours, &mut side, &mut parts);
    }
    parts
}

/// Cuts some groups in half, and again; returns the number of their part. `side` is scratch.
fn cut(
    mut groups: Vec<usize>,
    places: &[[f64; 3]],
    neighbours: &[Vec<usize>],
    side: &mut [u8],
    parts: &mut Vec<Part>,
) -> usize {
    let mut children = Vec::new();
    if groups.len() > LEAF {
        let extent = |axis: usize| {
            let along = groups.iter().map(|&g| places[g][axis]);
            along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
        };
        let axis = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
        groups.sort_by(|&a, &b| places[a][axis].total_cmp(&places[b][axis]).then(a.cmp(&b)));
        let right = groups.split_off(groups.len() / 2);
        groups.iter().for_each(|&g| side[g] = 1);
        right.iter().for_each(|&g| side[g] = 2);
        let touches = |g: usize, other: u8| neighbours[g].iter().any(|&n| side[n] == other);
        let at_left: Vec<usize> = groups.iter().copied().filter(|&g| touches(g, 2)).collect();
        let at_right: Vec<usize> = right.iter().copied().filter(|&g| touches(g, 1)).collect();
        groups.iter().chain(&right).for_each(|&g| side[g] = 0);
        let separator = if at_left.len() <= at_right.len() { at_left } else { at_right };
        separator.iter().for_each(|&g| side[g] = 3);
        let [left, right] = [groups, right].map(|half| half.into_iter().filter(|&g| side[g] != 3).collect());
        separator.iter().for_each(|&g| side[g] = 0);
        for half in [left, right] {
            let half: Vec<usize> = half;
            if !half.is_empty() {
                children.push(cut(half, places, neighbours, side, parts));
            }
        }
        groups = separator;
    }
    parts.push(Part { groups, children });
    parts.len() - 1
}
