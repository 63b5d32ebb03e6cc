//! Which cases a run is about, and the order in which they are solved.

use soilctl_jobs::Shard;

/// Tool angle, friction angle and interface friction angle in degrees.
pub(super) type Node = [f64; 3];

/// A node as something that can be compared: the same after going through a file or another step width.
pub(super) fn key(node: Node) -> [i64; 3] {
    node.map(|degrees| (degrees * 1e9).round() as i64)
}

/// The nodes of a grid with delta up to phi, by alpha, then phi, then delta; of these the shard's.
pub(super) fn cases(axes: &[Vec<f64>; 3], shard: Option<Shard>) -> Vec<Node> {
    let [alphas, phis, deltas] = axes;
    let mut cases = Vec::new();
    for &alpha in alphas {
        for &phi in phis {
            cases.extend(deltas.iter().filter(|delta| **delta <= phi).map(|delta| [alpha, phi, *delta]));
        }
    }
    let all = cases.into_iter().enumerate();
    all.filter(|(place, _)| shard.is_none_or(|shard| shard.has(*place))).map(|(_, case)| case).collect()
}

/// The places 0 to `count` mixed so that any run of them is spread over the whole: neighbours cost alike, so the time
/// of the first few would otherwise say nothing about the rest.
pub(super) fn mixed(count: usize) -> Vec<usize> {
    let common = |mut a: usize, mut b: usize| {
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    // The golden section strides most evenly.
    let mut stride = (count as f64 * 0.618).round() as usize;
    while common(stride, count) > 1 {
        stride += 1;
    }
    (0..count).map(|i| i * stride % count).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Grid;

    #[test]
    fn the_shards_of_appendix_c_make_its_287_sets() {
        let all = cases(&Grid::AppendixC.axes(), None);
        assert_eq!(all.len(), 287);
        assert_eq!(cases(&Grid::Wide.axes(), None).len(), 612);
        let mut united: Vec<Node> =
            (1..=4).flat_map(|i| cases(&Grid::AppendixC.axes(), format!("{i}/4").parse().ok())).collect();
        united.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(united, all);
    }

    #[test]
    fn mixing_leaves_no_case_out() {
        for count in [0, 1, 2, 3, 7, 100, 287, 612] {
            let mut places = mixed(count);
            places.sort_unstable();
            assert_eq!(places, (0..count).collect::<Vec<_>>(), "{count}");
        }
    }
}
