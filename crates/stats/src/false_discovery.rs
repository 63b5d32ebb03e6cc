/// Which hypotheses are rejected if at most this part of the rejected ones may be true on average: those up to the largest `k` whose `k`-th least p
/// is at most `k rate / m` (Benjamini & Hochberg 1995), for independent and positively dependent tests.
#[must_use]
pub fn benjamini_hochberg(p: &[f64], rate: f64) -> Vec<bool> {
    let mut sorted = p.to_vec();
    sorted.sort_by(f64::total_cmp);
    let count = sorted.len() as f64;
    let limits = sorted.iter().zip(1..).filter(|(p, k)| **p <= f64::from(*k) * rate / count);
    let most = limits.map(|(p, _)| *p).last();
    p.iter().map(|p| most.is_some_and(|most| *p <= most)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the paper, section 3.2: fifteen p-values, of which four are rejected at 0.05 and Bonferroni would reject three.
    #[test]
    fn the_example_of_the_paper() {
        let p = [
            0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344, 0.0459, 0.3240, 0.4262, 0.5719,
            0.6528, 0.7590, 1.000,
        ];
        let rejected = benjamini_hochberg(&p, 0.05);
        assert_eq!(rejected.iter().filter(|r| **r).count(), 4);
        assert!(rejected[..4].iter().all(|r| *r));
        // Whatever their order.
        let turned: Vec<f64> = p.iter().rev().copied().collect();
        assert!(benjamini_hochberg(&turned, 0.05)[11..].iter().all(|r| *r));
        assert!(benjamini_hochberg(&[], 0.05).is_empty() && benjamini_hochberg(&[0.2], 0.05) == [false]);
    }
}
