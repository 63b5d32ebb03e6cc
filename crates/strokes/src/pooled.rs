//! Strokes of one kind as one band: what scatters from stroke to stroke averages out, what they share does not.

use soilctl_stats::t_quantile;

use crate::StrokesError;
use crate::measurements::listed;

/// Degrees of freedom that a stated standard deviation counts for: one that is itself known within a quarter (GUM, G.4.2).
const STATED_FREEDOM: f64 = 8.0;
/// From here on Student's distribution is the normal one within 1e-5.
const MOST_FREEDOM: f64 = 1e6;

/// Strokes of one kind, each brought to the same tool angle, depth, width and friction on the plate.
#[derive(Debug, Clone, PartialEq)]
pub struct Kind {
    /// What they are, for messages, such as `70 deg, 24 mm`.
    pub label: String,
    /// Their lines in the file.
    pub lines: Vec<usize>,
    /// Failure forces in N, above 0, at least one.
    pub forces_n: Vec<f64>,
    /// Relative standard deviation of each force by what differs from stroke to stroke, above 0; `None` if it is not known, and only
    /// the scatter tells it.
    pub sds_rel: Option<Vec<f64>>,
    /// Relative standard deviation of what all of them share, at least 0.
    pub common_rel: f64,
}

/// What strokes of one kind say of their failure force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PooledBand {
    /// Their geometric mean in N.
    pub force_n: f64,
    /// Lower end of the band in N.
    pub low_n: f64,
    /// Upper end in N.
    pub high_n: f64,
    /// Relative standard deviation of one stroke as it scatters; `None` of a single one.
    pub scatter_rel: Option<f64>,
    /// Relative standard deviation of one stroke as stated; `None` if it is not.
    pub stated_rel: Option<f64>,
    /// Relative standard error of the mean, by scatter and statement.
    pub mean_rel: f64,
    /// Relative standard deviation of what the strokes share.
    pub common_rel: f64,
    /// Standard deviations, of mean and shared errors together, that the band reaches on either side.
    pub deviations: f64,
}

/// All bands of a table, and how sure they are.
#[derive(Debug, Clone, PartialEq)]
pub struct Pool {
    /// One band a kind, in order.
    pub bands: Vec<PooledBand>,
    /// Probability with which one band holds its true force.
    pub each: f64,
    /// Scatter over what is stated, where both are known; above 1 the stated deviations were enlarged by it.
    pub scatter_over_stated: Option<f64>,
}

/// One band a kind, so wide that with a probability of `confidence`, above 0 and below 1, all of them together hold their true
/// forces.
///
/// Deviations are relative, and normal in the logarithm. That of a mean is `sqrt(mean of s_i^2 / n)`. Where it is stated how far a
/// stroke is off, the scatter about the means of all kinds may enlarge the `s_i`, all by the same factor, never lessen them; the
/// statement counts as eight degrees of freedom and what the scatter has adds to
/// them. Where nothing is stated, the scatter of all such kinds together is the deviation. What strokes share is added in
/// squares. The quantile is Student's with the effective degrees of freedom of Welch and Satterthwaite, at the confidence
/// `confidence^(1/m)` for each of `m` bands: by Šidák (1967) they hold jointly with at least `confidence`, however their errors are
/// correlated.
///
/// # Errors
/// [`StrokesError::LoneStroke`] if nothing tells a deviation: nothing is stated of a kind, and no such kind has two strokes;
/// [`StrokesError::ZeroSpread`] if all of these are equal.
pub fn pool(file: &str, kinds: &[Kind], confidence: f64) -> Result<Pool, StrokesError> {
    let each = confidence.powf(1.0 / kinds.len().max(1) as f64);
    let (mut stated, mut unstated) = (Scatter::default(), Scatter::default());
    for kind in kinds {
        match &kind.sds_rel {
            Some(sds) => stated.add(kind, |i| sds.get(i).copied().unwrap_or(1.0)),
            None => unstated.add(kind, |_| 1.0),
        }
    }
    let enlarged = ((STATED_FREEDOM + stated.squares) / (STATED_FREEDOM + stated.freedom)).max(1.0);
    let bands = kinds.iter().map(|kind| {
        let count = kind.forces_n.len() as f64;
        let (one, freedom) = match &kind.sds_rel {
            Some(sds) => (enlarged * mean_square(sds), STATED_FREEDOM + stated.freedom),
            None => (unstated.variance(file, kind)?, unstated.freedom),
        };
        let (mean, common) = (one / count, kind.common_rel * kind.common_rel);
        let freedom = freedom * ((mean + common) / mean).powi(2);
        let deviations = t_quantile(0.5 * (1.0 - each), freedom.min(MOST_FREEDOM)).unwrap_or(f64::INFINITY);
        let force_n = mean_log(&kind.forces_n).exp();
        let reach = (deviations * (mean + common).sqrt()).exp();
        Ok(PooledBand {
            force_n,
            low_n: force_n / reach,
            high_n: force_n * reach,
            scatter_rel: scatter(&kind.forces_n),
            stated_rel: kind.sds_rel.as_deref().map(|sds| mean_square(sds).sqrt()),
            mean_rel: mean.sqrt(),
            common_rel: kind.common_rel,
            deviations,
        })
    });
    let bands = bands.collect::<Result<_, StrokesError>>()?;
    let scatter_over_stated = (stated.freedom > 0.0).then(|| (stated.squares / stated.freedom).sqrt());
    Ok(Pool { bands, each, scatter_over_stated })
}

/// Squares of deviations from the means of kinds, and how many of them are free.
#[derive(Debug, Default)]
struct Scatter {
    squares: f64,
    freedom: f64,
}

impl Scatter {
    fn add(&mut self, kind: &Kind, unit: impl Fn(usize) -> f64) {
        let mean = mean_log(&kind.forces_n);
        let off = |(i, force): (usize, &f64)| ((force.ln() - mean) / unit(i)).powi(2);
        self.squares += kind.forces_n.iter().enumerate().map(off).sum::<f64>();
        self.freedom += kind.forces_n.len() as f64 - 1.0;
    }

    /// Of one stroke; the kind is named if it cannot be told.
    fn variance(&self, file: &str, kind: &Kind) -> Result<f64, StrokesError> {
        let (file, label) = (file.to_owned(), kind.label.clone());
        let line = kind.lines.first().copied().unwrap_or_default();
        if self.freedom < 1.0 {
            return Err(StrokesError::LoneStroke { file, line, label });
        }
        // Logarithms of equal forces may differ in their last bit.
        if self.squares < 1e-24 {
            let (lines, count) = (listed(&kind.lines), kind.lines.len());
            return Err(StrokesError::ZeroSpread { file, lines, count, label });
        }
        Ok(self.squares / self.freedom)
    }
}

fn mean_log(forces_n: &[f64]) -> f64 {
    forces_n.iter().map(|force| force.ln()).sum::<f64>() / forces_n.len() as f64
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64
}

/// Sample standard deviation of the logarithms; `None` of one.
fn scatter(forces_n: &[f64]) -> Option<f64> {
    let mean = mean_log(forces_n);
    let squares = forces_n.iter().map(|force| (force.ln() - mean).powi(2)).sum::<f64>();
    (forces_n.len() > 1).then(|| (squares / (forces_n.len() as f64 - 1.0)).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(forces_n: &[f64], sds_rel: Option<&[f64]>, common_rel: f64) -> Kind {
        let lines = (2..forces_n.len() + 2).collect();
        let (forces_n, sds_rel) = (forces_n.to_vec(), sds_rel.map(<[f64]>::to_vec));
        Kind { label: "80 deg".into(), lines, forces_n, sds_rel, common_rel }
    }

    /// Three strokes and nothing stated: the interval of a mean in any textbook, t(2) = 4.3027 at 95 %.
    #[test]
    fn scatter_alone_is_students_interval() {
        let logs = [0.02_f64, -0.01, -0.01];
        let forces: Vec<f64> = logs.iter().map(|x| 5.0 * x.exp()).collect();
        let band = pool("s", &[kind(&forces, None, 0.0)], 0.95).unwrap().bands[0];
        let sd = (0.0006_f64 / 2.0).sqrt();
        assert!((band.force_n - 5.0).abs() < 1e-12 && (band.scatter_rel.unwrap() - sd).abs() < 1e-12);
        assert!(((band.high_n / 5.0).ln() - 4.302_653 * sd / 3.0_f64.sqrt()).abs() < 1e-7);
        assert!(((band.low_n / 5.0).ln() + (band.high_n / 5.0).ln()).abs() < 1e-12);
    }

    /// What is shared stays, however many strokes there are.
    #[test]
    fn a_shared_error_does_not_average_out() {
        let forces: Vec<f64> = (0..400).map(|i| if i % 2 == 0 { 5.0 } else { 5.2 }).collect();
        let band = pool("s", &[kind(&forces, Some(&[0.02; 400]), 0.03)], 0.95).unwrap().bands[0];
        assert!((band.mean_rel - 0.001).abs() < 1e-9);
        // Nearly all of it is shared: the normal quantile.
        assert!(((band.high_n / band.force_n).ln() - 1.959_96 * 0.03_f64.hypot(0.001)).abs() < 1e-5);
    }

    #[test]
    fn strokes_that_scatter_more_than_stated_widen_the_bands_and_less_does_not_narrow_them() {
        let wide = |forces: &[f64]| {
            let found = pool("s", &[kind(forces, Some(&[0.01, 0.01, 0.01]), 0.0)], 0.95).unwrap();
            (found.scatter_over_stated.unwrap(), found.bands[0].mean_rel)
        };
        let (ratio, mean) = wide(&[5.0, 5.5, 6.0]);
        assert!(ratio > 5.0 && mean > 0.01, "{ratio} {mean}");
        let (ratio, mean) = wide(&[5.0, 5.001, 5.002]);
        assert!(ratio < 0.1 && (mean - 0.01 / 3.0_f64.sqrt()).abs() < 1e-12);
    }

    /// Two bands at 1 - sqrt(1 - 0.05): the table of Šidák.
    #[test]
    fn more_bands_are_each_surer() {
        let one = kind(&[5.0], Some(&[0.02]), 0.0);
        let found = pool("s", &[one.clone(), one], 0.95).unwrap();
        assert!((1.0 - found.each - 0.025_320_565).abs() < 1e-9);
        // t(8) at 0.025321 on both sides together, by scipy 1.17: t.ppf(1 - 0.025320565 / 2, 8).
        assert!((found.bands[0].deviations - 2.743_279_026).abs() < 1e-6, "{}", found.bands[0].deviations);
    }

    #[test]
    fn a_force_of_which_nothing_tells_the_deviation_is_refused() {
        let lone = pool("s.csv", &[kind(&[5.0], None, 0.03)], 0.95).unwrap_err();
        assert!(matches!(lone, StrokesError::LoneStroke { line: 2, .. }), "{lone}");
        let equal = pool("s.csv", &[kind(&[5.0, 5.0], None, 0.03)], 0.95).unwrap_err();
        assert!(matches!(equal, StrokesError::ZeroSpread { count: 2, .. }), "{equal}");
        // The scatter of another kind tells that of a lone stroke.
        let both = [kind(&[5.0], None, 0.0), kind(&[7.0, 7.3, 7.1], None, 0.0)];
        assert!(pool("s.csv", &both, 0.95).unwrap().bands[0].mean_rel > 0.01);
    }
}
