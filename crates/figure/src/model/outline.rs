//! Outlines of polygons that lie side by side.

use std::collections::BTreeMap;

/// The bits of a number, the same for both zeros.
pub(crate) fn bits(value: f64) -> u64 {
    (value + 0.0).to_bits()
}

/// The outline of polygons that may have edges in common: what of their edges is not walked both ways. Corners are the same
/// where their keys are.
pub(crate) fn outline<'a, P: Copy + 'a, K: Ord + Copy>(
    rings: impl Iterator<Item = &'a [P]>,
    key: impl Fn(P) -> K,
) -> Vec<Vec<P>> {
    let mut from: BTreeMap<K, Vec<P>> = BTreeMap::new();
    for ring in rings {
        for (i, &a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            // The same edge walked the other way is gone.
            let back = from.get_mut(&key(b)).and_then(|ends| {
                ends.iter().position(|end| key(*end) == key(a)).map(|at| ends.swap_remove(at))
            });
            if back.is_none() {
                from.entry(key(a)).or_default().push(b);
            }
        }
    }
    let mut outlines = Vec::new();
    from.retain(|_, ends| !ends.is_empty());
    while let Some(&start) = from.keys().next() {
        let mut ring = Vec::new();
        let mut here = start;
        while let Some(ends) = from.get_mut(&here) {
            let Some(next) = ends.pop() else { break };
            if ends.is_empty() {
                from.remove(&here);
            }
            ring.push(next);
            here = key(next);
        }
        outlines.push(ring);
    }
    outlines
}
