//! The break point of two lines, the thesis's guideline for gradual failures (section 5.5, figure 5-16).

use soilctl_stats::{Solved, huber};

/// Two lines that meet, fitted to force against displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TwoLines {
    /// Where they meet, in m.
    pub displacement_m: f64,
    /// Force there in N.
    pub force_n: f64,
    /// Standard deviation of that force in N, from the residuals.
    pub sd_n: f64,
    /// Slope of the early line in N/m.
    pub early_n_per_m: f64,
    /// Slope of the late line in N/m.
    pub late_n_per_m: f64,
}

/// Candidates of the break point.
const BREAKS: usize = 80;

/// Robust fit of two lines to nodes (displacement, force); the break is the best of many. `None` if the nodes do
/// not span a displacement.
pub(super) fn fit(nodes: &[[f64; 2]]) -> Option<TwoLines> {
    let mut sorted: Vec<f64> = nodes.iter().map(|node| node[0]).collect();
    sorted.sort_by(f64::total_cmp);
    let (low, high) = (*sorted.first()?, *sorted.last()?);
    let scale = high - low;
    if !(scale.is_finite() && scale > 0.0) {
        return None;
    }
    let solve = |at: f64| -> Option<(Solved<3>, f64)> {
        let rows: Vec<([f64; 3], f64)> = nodes
            .iter()
            .map(|[u, f]| {
                let x = (u - at) / scale;
                ([1.0, x.min(0.0), x.max(0.0)], *f)
            })
            .collect();
        huber(&rows)
    };
    let mut best: Option<(f64, f64, Solved<3>)> = None;
    for k in 0..BREAKS {
        // Between the 4th and the 96th of a hundred nodes: each line needs a few.
        let place = (0.04 + 0.92 * k as f64 / (BREAKS - 1) as f64) * (sorted.len() - 1) as f64;
        let at = sorted.get(place as usize).copied()?;
        let Some((solved, rms)) = solve(at) else { continue };
        if best.as_ref().is_none_or(|(least, ..)| rms < *least) {
            best = Some((rms, at, solved));
        }
    }
    let (rms, at, Solved { x: [force, early, late], inverse }) = best?;
    // The break itself is uncertain too: moving it by one spacing changes the force by the early slope times that.
    let spacing = early.abs() / sorted.len() as f64;
    let sd_n = (rms * rms * inverse[0][0]).sqrt().hypot(spacing / 12.0_f64.sqrt());
    Some(TwoLines {
        displacement_m: at,
        force_n: force,
        sd_n,
        early_n_per_m: early / scale,
        late_n_per_m: late / scale,
    })
}
