//! Whether a coefficient grows with each angle, as it does in every model.

use soilctl_earth_pressure::table::PredictionTable;

use super::Violation;

fn places(table: &PredictionTable) -> impl Iterator<Item = [usize; 3]> {
    let [n0, n1, n2] = [0, 1, 2].map(|d| table.axes()[d].len());
    (0..n0).flat_map(move |i| (0..n1).flat_map(move |j| (0..n2).map(move |k| [i, j, k])))
}

fn node(table: &PredictionTable, at: [usize; 3]) -> [f64; 3] {
    [0, 1, 2].map(|d| table.axes()[d][at[d]])
}

/// Neighbours between which the coefficient fails to grow, wherever it lies between its ends; more friction or a plate
/// leaning further back resists more in every model.
pub(super) fn violations(lower: &PredictionTable, upper: &PredictionTable) -> Vec<Violation> {
    let mut found = Vec::new();
    for at in places(lower) {
        let Some(here) = lower.cell(at[0], at[1], at[2]) else { continue };
        for (d, along) in ["alpha", "phi", "delta"].into_iter().enumerate() {
            let mut next = at;
            next[d] += 1;
            if next[d] == lower.axes()[d].len() {
                continue;
            }
            let Some(there) = upper.cell(next[0], next[1], next[2]) else { continue };
            if there.k_net <= here.k_net {
                let (from, to) = (node(lower, at), node(lower, next));
                found.push(Violation { along, from, to, k_from: here.k_net, k_to: there.k_net });
            }
        }
    }
    found
}

/// Unfilled nodes at which a model could answer.
pub(super) fn empty_nodes(table: &PredictionTable) -> Vec<[f64; 3]> {
    places(table)
        .filter(|at| table.cell(at[0], at[1], at[2]).is_none())
        .map(|at| node(table, at))
        .filter(|[_, phi, delta]| delta <= phi)
        .collect()
}
