//! The interface friction that the sweep tells, and whether it tells any.

use super::answer::Delta;
use crate::process::Friction;

/// A sweep that leaves a larger standard deviation in deg tells nothing.
const MOST_SD_DEG: f64 = 2.0;
/// Least half width of the interval in deg: set-points are no closer to the truth (section 5.4 of the thesis).
const LEAST_HALF_DEG: f64 = 1.0;
/// Half width in deg of what the published value is trusted for.
const PUBLISHED_HALF_DEG: f64 = 3.0;

/// What the sweep tells, beside what is true.
pub(super) fn compared(found: &Friction, true_deg: f64) -> Delta {
    let half_deg = (2.0 * found.sd_deg).max(LEAST_HALF_DEG);
    let interval_deg = around(found.delta_deg, half_deg);
    Delta {
        delta_deg: found.delta_deg,
        sd_deg: found.sd_deg,
        interval_deg,
        above_deg: found.above_deg,
        below_deg: found.below_deg,
        error_deg: found.delta_deg - true_deg,
        holds_truth: (interval_deg[0]..=interval_deg[1]).contains(&true_deg),
        determined: found.above_deg.is_some() && found.sd_deg <= MOST_SD_DEG,
    }
}

/// Why the sweep does not count, if it does not.
pub(super) fn objection(delta: &Delta) -> Option<String> {
    (!delta.determined).then(|| match delta.above_deg {
        None => "no set-point shows a significant lift at failure, so the sweep says nothing of the interface friction"
            .to_owned(),
        Some(_) => format!(
            "the lifts leave a standard deviation of {:.1} deg, more than {MOST_SD_DEG} deg",
            delta.sd_deg
        ),
    })
}

/// The interval that friction angle and density are estimated with, in deg.
pub(super) fn interval_deg(delta: Option<&Delta>, published_deg: f64) -> [f64; 2] {
    match delta {
        Some(delta) if delta.determined => delta.interval_deg,
        _ => around(published_deg, PUBLISHED_HALF_DEG),
    }
}

/// Friction is not negative.
fn around(middle_deg: f64, half_deg: f64) -> [f64; 2] {
    [(middle_deg - half_deg).max(0.0), middle_deg + half_deg]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sweep(delta_deg: f64, sd_deg: f64, above_deg: Option<f64>) -> Friction {
        Friction {
            delta_deg,
            sd_deg,
            above_deg,
            below_deg: None,
            lift_per_deg: 0.5,
            strokes: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// A flat sweep has its mean in the middle of what was searched, which may be the truth; it still tells nothing.
    #[test]
    fn a_sweep_without_lift_does_not_count_even_if_it_is_right() {
        let found = compared(&sweep(23.0, 6.9, None), 23.0);
        assert!(!found.determined && found.holds_truth && objection(&found).is_some());
        assert_eq!(interval_deg(Some(&found), 25.0), [22.0, 28.0]);
    }

    #[test]
    fn an_interval_is_two_standard_deviations_and_at_least_two_degrees_wide() {
        let found = compared(&sweep(21.0, 1.2, Some(18.0)), 23.0);
        assert!(found.determined && objection(&found).is_none());
        assert!((found.interval_deg[1] - 23.4).abs() < 1e-12 && found.holds_truth);
        assert_eq!(interval_deg(Some(&found), 40.0), found.interval_deg);
        let sharp = compared(&sweep(21.0, 0.02, Some(18.0)), 23.0);
        assert_eq!((sharp.interval_deg, sharp.holds_truth), ([20.0, 22.0], false));
        assert_eq!(compared(&sweep(0.5, 0.02, Some(0.4)), 0.0).interval_deg[0], 0.0);
    }
}
