//! Steps of a displacement that comes in steps.

use soilctl_stats::median;

/// Changes below this share of the largest ones are no steps. Empirical, as are all others here.
const STILL: f64 = 0.3;
/// How far a change may be from a multiple of the step, over the step.
const OFF: f64 = 0.15;
/// Part of the changes that must be multiples.
const REGULAR: f64 = 0.9;
/// Steps that the smallest change may have.
const MOST_STEPS: u32 = 3;
/// Times that a change must be followed by one of another size: what moves evenly makes equal changes, too.
const ALTERNATIONS: usize = 6;

/// The smallest repeated step, in the unit of the displacement; `None` if it does not come in steps.
pub(super) fn repeated_step(displacement: &[f64]) -> Option<f64> {
    let changes: Vec<f64> = displacement.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let mut sorted = changes.clone();
    sorted.sort_by(f64::total_cmp);
    // The third largest, for an encoder may jump.
    let large = *sorted.iter().rev().nth(2)?;
    if large <= 0.0 {
        return None;
    }
    let steps: Vec<f64> = sorted.iter().copied().filter(|change| *change >= STILL * large).collect();
    let smallest = steps[steps.len() / 10];
    // What moves fast makes no single steps: the smallest change may be some of them.
    (1..=MOST_STEPS).find_map(|count| lattice(&changes, &sorted, &steps, smallest / f64::from(count)))
}

/// The step near a guess of which all large changes are multiples.
fn lattice(changes: &[f64], sorted: &[f64], steps: &[f64], guess: f64) -> Option<f64> {
    let step = median(&mut steps.iter().map(|change| change / (change / guess).round()).collect::<Vec<_>>());
    let regular =
        steps.iter().filter(|change| (*change / step - (*change / step).round()).abs() < OFF).count();
    let least = steps.first()?;
    let still = sorted.iter().filter(|change| *change < least).all(|change| *change < OFF * step);
    let alternations =
        changes.windows(2).filter(|pair| (pair[0] / step).round() != (pair[1] / step).round()).count();
    let stepped = still
        && regular as f64 >= REGULAR * steps.len() as f64
        && alternations >= ALTERNATIONS
        && step.is_finite();
    stepped.then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An even motion, read in steps of a size.
    fn read(per_sample: f64, step: f64) -> Vec<f64> {
        (0..300).map(|i| (f64::from(i) * per_sample / step).floor() * step).collect()
    }

    #[test]
    fn steps_are_found_at_any_speed() {
        for per_sample in [0.07, 0.3, 0.83, 1.27, 2.6] {
            let found = repeated_step(&read(per_sample, 1.0));
            assert!(found.is_some_and(|step| (step - 1.0).abs() < 1e-9), "{per_sample}: {found:?}");
        }
    }

    #[test]
    fn what_moves_evenly_or_trembles_has_no_steps() {
        let even: Vec<f64> = (0..300).map(|i| 0.2 * f64::from((i - 100).max(0))).collect();
        assert_eq!(repeated_step(&even), None);
        // Angles of a turning wheel: no lattice.
        let trembling: Vec<f64> =
            (0..300).map(|i| f64::from(i) + 0.4 * f64::from(i * i % 17) / 17.0).collect();
        assert_eq!(repeated_step(&trembling), None);
        assert_eq!(repeated_step(&[0.0; 50]), None);
        assert_eq!(repeated_step(&[]), None);
    }
}
