//! Where the push that fails the soil begins. Before, an insertion's load fades, free play is taken up, and the plate may be
//! let go and pushed again; none of this is part of the curve.

use crate::blocks::Blocks;

/// The rise is near its end at this share of it.
const HIGH: f64 = 0.9;
/// It begins below this share.
const LOW: f64 = 0.15;

/// First block of the greatest rise of the force.
pub(super) fn of_rise(blocks: &Blocks) -> usize {
    let (t, f) = (&blocks.t_s, &blocks.f_n);
    let (mut low, mut from, mut rise) = (0, 0, 0.0);
    for (k, force) in f.iter().enumerate() {
        if *force < f[low] {
            low = k;
        }
        if force - f[low] > rise {
            (from, rise) = (low, force - f[low]);
        }
    }
    let share = |k: usize| (f[k] - f[from]) / rise;
    let Some(near) = (from..f.len()).find(|k| share(*k) >= HIGH) else { return from };
    // The bend from waiting to pushing is furthest below the line that joins both ends.
    let below = |k: usize| HIGH * (t[k] - t[from]) / (t[near] - t[from]) - share(k);
    (from..near).filter(|k| share(*k) < LOW).max_by(|a, b| below(*a).total_cmp(&below(*b))).unwrap_or(from)
}
