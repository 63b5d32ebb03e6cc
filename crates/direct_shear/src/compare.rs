use serde::Serialize;

use crate::constant::ConstantFit;
use crate::curve::{FrictionCurve, samples};
use crate::error::DirectShearError;
use crate::loglog::LogLogFit;
use crate::misfit::Misfit;
use crate::point::ShearPoint;
use crate::slope_floor::SlopeFloorFit;

/// Standard deviation of rounding to 0.1 deg, `0.1 / sqrt(12)`: no curve can be better than its data.
const ROUNDING_DEG: f64 = 0.029;
/// Differences of an information criterion below this do not tell two curves apart (Burnham & Anderson 2002).
const TELLS_APART: f64 = 2.0;

/// One curve in a [`CurveComparison`].
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveScore {
    /// Name of the curve.
    pub curve: &'static str,
    /// Parameters fitted, the scatter included.
    pub parameters: usize,
    /// Residuals in degrees.
    pub misfit: Misfit,
    /// Akaike's criterion corrected for few points, up to a constant shared by all curves; `None` when there are
    /// not at least two points more than parameters.
    pub aicc: Option<f64>,
    /// The Bayesian (Schwarz) criterion, up to a constant shared by all curves.
    pub bic: f64,
}

/// Which curve describes a series best, in numbers and in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveComparison {
    /// The curves: constant angle, power law over all points, slope and floor (with three stresses or more).
    pub scores: Vec<CurveScore>,
    /// Best by AICc among those that have one.
    pub best_by_aicc: Option<&'static str>,
    /// Best by BIC.
    pub best_by_bic: &'static str,
    /// Verdict in words.
    pub verdict: String,
}

/// Fits every curve to the same points with the same weights and compares them.
///
/// Needs at least two different stresses. All residuals are judged in degrees, also those of the power
/// law, which is fitted in logarithms. Weights (1 if not given) are relative inverse variances.
///
/// # Errors
/// Those of [`ConstantFit::fit`], [`LogLogFit::fit_all`] and [`SlopeFloorFit::fit`].
pub fn compare_curves(
    points: &[ShearPoint],
    weights: Option<&[f64]>,
) -> Result<CurveComparison, DirectShearError> {
    let constant = ConstantFit::fit(points, weights)?;
    let power = LogLogFit::fit_all(points, weights)?;
    let mut scores = vec![score(&constant, constant.misfit, 2), score(&power, power.misfit, 3)];
    let stresses = crate::curve::distinct_stresses_pa(&samples(points, weights)?).len();
    if stresses >= 3 {
        let broken = SlopeFloorFit::fit(points, weights)?;
        scores.push(score(&broken, broken.misfit, 4));
    }
    let least = |value: fn(&CurveScore) -> Option<f64>| {
        let mut best: Option<(&CurveScore, f64)> = None;
        for score in &scores {
            if let Some(v) = value(score)
                && best.is_none_or(|(_, least)| v < least)
            {
                best = Some((score, v));
            }
        }
        best
    };
    let by_aicc = least(|score| score.aicc);
    let by_bic = least(|score| Some(score.bic)).map_or(&scores[0], |(score, _)| score);
    let verdict = words(&scores, by_aicc.map(|(score, _)| score), by_bic);
    Ok(CurveComparison {
        best_by_aicc: by_aicc.map(|(score, _)| score.curve),
        best_by_bic: by_bic.curve,
        verdict,
        scores,
    })
}

#[allow(clippy::cast_precision_loss)]
fn score(curve: &dyn FrictionCurve, misfit: Misfit, parameters: usize) -> CurveScore {
    let (n, k) = (misfit.points as f64, parameters as f64);
    // Terms that depend on the weights alone are the same for every curve and are left out.
    let minus_two_log_likelihood = 2.0 * n * misfit.weighted_rms_deg.max(ROUNDING_DEG).ln();
    let spare = n - k - 1.0;
    CurveScore {
        curve: curve.name(),
        parameters,
        misfit,
        aicc: (spare > 0.0).then(|| minus_two_log_likelihood + 2.0 * k + 2.0 * k * (k + 1.0) / spare),
        bic: minus_two_log_likelihood + k * n.ln(),
    }
}

fn words(scores: &[CurveScore], aicc: Option<&CurveScore>, bic: &CurveScore) -> String {
    let misfit = |s: &CurveScore| format!("{} (misfit {:.2} deg)", s.curve, s.misfit.weighted_rms_deg);
    let Some(aicc) = aicc else {
        return format!("too few tests to compare by AICc; by BIC the {} describes them best", misfit(bic));
    };
    if aicc.curve != bic.curve {
        return format!(
            "the criteria disagree: AICc, which charges more for each parameter of a small set, prefers the {}, BIC \
             the {}; more loads would decide",
            misfit(aicc),
            misfit(bic)
        );
    }
    let rival = scores.iter().filter(|score| score.curve != aicc.curve).find_map(|score| {
        let by_aicc = score.aicc.zip(aicc.aicc).map(|(theirs, best)| ("AICc", theirs - best));
        let by_bic = Some(("BIC", score.bic - bic.bic));
        let (criterion, behind) =
            [by_aicc, by_bic].into_iter().flatten().find(|(_, behind)| *behind < TELLS_APART)?;
        Some((score, criterion, behind))
    });
    match rival {
        Some((rival, criterion, behind)) => format!(
            "the {} comes first by AICc and by BIC, but the {} is only {behind:.1} behind in {criterion}: these tests \
             do not clearly tell them apart",
            misfit(aicc),
            misfit(rival)
        ),
        None => format!("the {} describes these tests best by AICc and by BIC", misfit(aicc)),
    }
}
