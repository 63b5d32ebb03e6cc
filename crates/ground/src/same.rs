//! Whether places have one soil.

use soilctl_stats::normal_tail;

/// The probability that the greatest of several standard normal deviations, in magnitude, is at least that of these by chance, however they are
/// correlated: `1 - (1 - p)^m` of the greatest (Šidák 1967). 1 of none.
#[must_use]
pub fn p_of_deviations(deviations: &[f64]) -> f64 {
    let greatest = deviations.iter().fold(0.0, |most: f64, z| most.max(z.abs()));
    let one = (2.0 * normal_tail(greatest)).min(1.0);
    // As -expm1(m ln(1 - p)), so that small probabilities keep their digits.
    if one >= 1.0 { 1.0 } else { -libm::expm1(deviations.len() as f64 * libm::log1p(-one)) }
}

/// Puts places into groups of one soil, by complete linkage: the two groups go together whose least alike members are most alike, as long as
/// no two members are known to differ and `together` finds a soil for all of them. `likeness` of two different places grows with how alike they are;
/// `None` if they differ. Groups are in the order of their first members.
///
/// # Errors
/// What `together` says.
pub fn groups<E>(
    count: usize,
    likeness: impl Fn(usize, usize) -> Option<f64>,
    mut together: impl FnMut(&[usize]) -> Result<bool, E>,
) -> Result<Vec<Vec<usize>>, E> {
    let mut groups: Vec<Vec<usize>> = (0..count).map(|place| vec![place]).collect();
    let mut refused: Vec<Vec<usize>> = Vec::new();
    loop {
        let mut best: Option<(f64, Vec<usize>, [usize; 2])> = None;
        for (i, a) in groups.iter().enumerate() {
            for (j, b) in groups.iter().enumerate().skip(i + 1) {
                let pairs = a.iter().flat_map(|p| b.iter().map(move |q| (*p, *q)));
                let least = pairs
                    .map(|(p, q)| likeness(p, q))
                    .try_fold(f64::INFINITY, |least, one| Some(least.min(one?)));
                let Some(least) = least else { continue };
                if best.as_ref().is_some_and(|(most, ..)| least <= *most) {
                    continue;
                }
                let mut all: Vec<usize> = a.iter().chain(b).copied().collect();
                all.sort_unstable();
                if !refused.contains(&all) {
                    best = Some((least, all, [i, j]));
                }
            }
        }
        let Some((_, all, [i, j])) = best else { return Ok(groups) };
        if together(&all)? {
            groups.remove(j);
            groups[i] = all;
        } else {
            refused.push(all);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of one deviation it is the two-sided p; of independent ones that of the greatest, 0.05 at 1.96 for one and 2.236 for two.
    #[test]
    fn the_probability_is_that_of_the_greatest() {
        assert!((p_of_deviations(&[-1.959_964]) - 0.05).abs() < 1e-7);
        assert!((p_of_deviations(&[2.236_477, 0.3]) - 0.05).abs() < 1e-6);
        assert_eq!((p_of_deviations(&[]), p_of_deviations(&[0.0])), (1.0, 1.0));
        assert!(p_of_deviations(&[9.0, 0.0]) > 0.0);
    }

    #[test]
    fn no_two_members_of_a_group_differ() {
        // On a line, places less than 2 apart do not differ: 0 and 1, 2 and 3; 1 and 2 are alike too, but 0 and 2 are not.
        let at = [0.0, 1.0, 2.2, 3.1, 9.0_f64];
        let likeness = |i: usize, j: usize| {
            let distance: f64 = (at[i] - at[j]).abs();
            (distance < 2.0).then_some(-distance)
        };
        let found = groups::<()>(5, likeness, |_| Ok(true)).unwrap();
        assert_eq!(found, [vec![0, 1], vec![2, 3], vec![4]]);
        // If no soil is found for 2 and 3, 2 may go with 1.
        let found = groups::<()>(5, likeness, |all| Ok(all != [2, 3])).unwrap();
        assert_eq!(found, [vec![0, 1], vec![2], vec![3], vec![4]]);
    }
}
