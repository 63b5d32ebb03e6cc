//! Edges of a mesh as few long lines.

use std::collections::BTreeMap;

/// Numbers to the last digit.
pub(super) fn bits<const N: usize>(numbers: [f64; N]) -> [u64; N] {
    numbers.map(|x| (x + 0.0).to_bits())
}

/// All edges of some triangles, each once, in lines that are walked from edge to edge as long as there is one left. Corners
/// are the same where their keys are.
pub(super) fn trails<'a, P: Copy + 'a, K: Ord + Copy>(
    triangles: impl Iterator<Item = &'a [P; 3]>,
    key: impl Fn(P) -> K,
) -> Vec<Vec<P>> {
    let mut met: BTreeMap<K, BTreeMap<K, P>> = BTreeMap::new();
    for t in triangles {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            met.entry(key(a)).or_default().insert(key(b), b);
            met.entry(key(b)).or_default().insert(key(a), a);
        }
    }
    // A trail ends where an odd number of edges meet, so it had better start at such a point.
    let (odd, even): (Vec<K>, Vec<K>) = met.keys().copied().partition(|k| met[k].len() % 2 == 1);
    let mut trails = Vec::new();
    for start in odd.into_iter().chain(even) {
        loop {
            let mut trail: Vec<P> = Vec::new();
            let mut here = start;
            while let Some((there, p)) = met.get_mut(&here).and_then(BTreeMap::pop_first) {
                let back = met.get_mut(&there).and_then(|m| m.remove(&here));
                if trail.is_empty() {
                    trail.extend(back);
                }
                trail.push(p);
                here = there;
            }
            if trail.is_empty() {
                break;
            }
            trails.push(trail);
        }
    }
    trails
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_edge_is_walked_once() {
        let (a, b, c, d) = ([0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]);
        let found = trails([[a, b, c], [a, c, d]].iter(), bits);
        let mut edges: Vec<[[u64; 2]; 2]> = found
            .iter()
            .flat_map(|t| t.windows(2))
            .map(
                |w| if bits(w[0]) < bits(w[1]) { [bits(w[0]), bits(w[1])] } else { [bits(w[1]), bits(w[0])] },
            )
            .collect();
        edges.sort_unstable();
        assert_eq!(edges.len(), 5);
        edges.dedup();
        assert_eq!(edges.len(), 5);
        // Two corners with three edges: one trail.
        assert_eq!(found.len(), 1);
    }
}
