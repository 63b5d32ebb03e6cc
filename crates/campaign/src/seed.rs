//! Seeds of batches: independent of each other and of the order in which batches run.

/// Seeds of the soil and of the sensors in a batch, from the campaign's seed.
pub(crate) fn of_batch(campaign: u64, batch: usize) -> [u64; 2] {
    let batch = u64::try_from(batch).unwrap_or(u64::MAX);
    let first = mix(mix(campaign) ^ batch);
    [mix(first ^ 1), mix(first ^ 2)]
}

/// A reading of a preparation's density over the true one: a box that is weighed, within 1 %.
pub(crate) fn density_reading(campaign: u64, batch: usize) -> f64 {
    let [soil, _] = of_batch(campaign, batch);
    #[allow(clippy::cast_precision_loss, reason = "53 bits")]
    let share = (mix(soil) >> 11) as f64 / (1_u64 << 53) as f64;
    1.0 + 0.01 * (2.0 * share - 1.0)
}

/// Steele, Lea and Flood's (2014) finaliser of SplitMix64: every bit of the answer depends on every bit of the input.
const fn mix(value: u64) -> u64 {
    let value = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    value ^ (value >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn all_seeds_differ() {
        let all: BTreeSet<u64> =
            (0..100).flat_map(|seed| (0..100).flat_map(move |batch| of_batch(seed, batch))).collect();
        assert_eq!(all.len(), 20_000);
    }
}
