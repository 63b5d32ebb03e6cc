//! What a whole campaign says: forces at one depth, their scatter, outliers, and whether the arm's configuration
//! shows (section 6.4, tables 6.4 to 6.11).

use soilctl_stats::{mean_and_sd, t_quantile, two_sided_p};

use crate::error::{ProcessError, positive};

/// Tool angles that differ by less, in deg, were set to be the same.
const SAME_ANGLE_DEG: f64 = 0.5;

/// A failure force and where it was measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CampaignStroke {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Measured vertical depth in m.
    pub depth_m: f64,
    /// Failure force in N.
    pub force_n: f64,
    /// Distance from the base axis in m, if known.
    pub radius_m: Option<f64>,
    /// Base angle in deg, if known.
    pub base_deg: Option<f64>,
}

/// Forces at one tool angle, scaled to one depth.
#[derive(Debug, Clone, PartialEq)]
pub struct AngleGroup {
    /// Tool angle in deg.
    pub alpha_deg: f64,
    /// Scaled forces in N, in the order given.
    pub forces_n: Vec<f64>,
    /// Strokes they are from (indices into the input).
    pub strokes: Vec<usize>,
    /// Those that do not belong (indices into the input), at 5 % for the whole group.
    pub outliers: Vec<usize>,
    /// Mean of all in N.
    pub mean_n: f64,
    /// Sample standard deviation of all in N; `None` of one stroke.
    pub sd_n: Option<f64>,
    /// Mean without outliers in N.
    pub kept_mean_n: f64,
    /// Standard deviation without outliers in N.
    pub kept_sd_n: Option<f64>,
}

impl AngleGroup {
    /// Coefficient of variation without outliers: standard deviation over mean.
    #[must_use]
    pub fn coefficient_of_variation(&self) -> Option<f64> {
        self.kept_sd_n.map(|sd| sd / self.kept_mean_n)
    }
}

/// Whether forces depend on how the arm stood.
#[derive(Debug, Clone, PartialEq)]
pub struct Dependence {
    /// Change of force from the least to the greatest value, relative.
    pub effect_rel: f64,
    /// Its standard error.
    pub effect_se: f64,
    /// Probability of an effect at least so large by chance.
    pub p: f64,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Strokes that were compared.
    pub strokes: usize,
}

impl Dependence {
    /// Whether chance would do as much in less than 5 of 100 campaigns.
    #[must_use]
    pub fn is_significant(&self) -> bool {
        self.p < 0.05
    }
}

/// Statistics of a campaign.
#[derive(Debug, Clone, PartialEq)]
pub struct CampaignStatistics {
    /// One group a tool angle, by angle.
    pub groups: Vec<AngleGroup>,
    /// Over the radius; `None` if there is one radius, or it isn't known.
    pub radius: Option<Dependence>,
    /// Over the base angle.
    pub base: Option<Dependence>,
}

/// Groups strokes by tool angle at a nominal slant length and looks for outliers and for effects of the
/// configuration.
///
/// Forces go with the square of depth, so each is multiplied by `(slant_m sin alpha / H)^2` with its measured depth
/// `H`: a stroke made too shallow or too deep counts at the nominal depth. Outliers are found by the generalised
/// extreme Studentised deviate test (Rosner 1983), at most a tenth of a group but at least one.
///
/// # Errors
/// [`ProcessError::OutOfRange`] of a depth, force, or tool angle outside its range; [`ProcessError::TooFew`] without
/// strokes.
pub fn campaign_statistics(
    strokes: &[CampaignStroke],
    slant_m: f64,
) -> Result<CampaignStatistics, ProcessError> {
    positive("nominal slant length", slant_m, "m")?;
    if strokes.is_empty() {
        return Err(ProcessError::TooFew { what: "strokes", found: 0, least: 1 });
    }
    let mut scaled = Vec::with_capacity(strokes.len());
    for stroke in strokes {
        let (alpha, depth_m) = (stroke.alpha_deg, positive("depth", stroke.depth_m, "m")?);
        if !(alpha > 0.0 && alpha < 180.0) {
            return Err(ProcessError::OutOfRange {
                what: "tool angle",
                value: alpha,
                unit: "deg",
                allowed: "above 0 and below 180",
            });
        }
        let nominal = slant_m * alpha.to_radians().sin();
        scaled.push(positive("failure force", stroke.force_n, "N")? * (nominal / depth_m).powi(2));
    }
    let mut angles: Vec<f64> = strokes.iter().map(|s| s.alpha_deg).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let groups: Vec<AngleGroup> = angles.iter().map(|alpha| group(strokes, &scaled, *alpha)).collect();
    let kept: Vec<usize> =
        groups.iter().flat_map(|g| g.strokes.iter().copied().filter(|i| !g.outliers.contains(i))).collect();
    let over = |value: fn(&CampaignStroke) -> Option<f64>| {
        let rows: Vec<(f64, f64, f64)> = kept
            .iter()
            .filter_map(|i| Some((strokes[*i].alpha_deg, value(&strokes[*i])?, scaled[*i].ln())))
            .filter(|row| row.1.is_finite())
            .collect();
        dependence(&rows)
    };
    Ok(CampaignStatistics { radius: over(|s| s.radius_m), base: over(|s| s.base_deg), groups })
}

/// The tool angle that each stroke was meant to have: a plate that came to 69.98 and to 70.01 deg was set to one angle. Strokes whose
/// angles lie within half a degree of the least of them are of one kind, and the middle one of them stands for all.
#[must_use]
pub fn meant_angles_deg(alpha_deg: &[f64]) -> Vec<f64> {
    let mut order: Vec<usize> = (0..alpha_deg.len()).collect();
    order.sort_by(|a, b| alpha_deg[*a].total_cmp(&alpha_deg[*b]));
    let mut meant = alpha_deg.to_vec();
    let mut left = order.as_slice();
    while let Some(least) = left.first() {
        let within =
            left.iter().take_while(|place| alpha_deg[**place] - alpha_deg[*least] <= SAME_ANGLE_DEG).count();
        // At least one, also where an angle is no number.
        let (kind, rest) = left.split_at(within.max(1));
        let middle = alpha_deg[kind[kind.len() / 2]];
        kind.iter().for_each(|place| meant[*place] = middle);
        left = rest;
    }
    meant
}

fn group(strokes: &[CampaignStroke], scaled: &[f64], alpha_deg: f64) -> AngleGroup {
    let members: Vec<usize> = (0..strokes.len()).filter(|i| strokes[*i].alpha_deg == alpha_deg).collect();
    let forces_n: Vec<f64> = members.iter().map(|i| scaled[*i]).collect();
    let outliers: Vec<usize> = outliers(&forces_n).into_iter().map(|k| members[k]).collect();
    let kept: Vec<f64> = members.iter().filter(|i| !outliers.contains(i)).map(|i| scaled[*i]).collect();
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    AngleGroup {
        alpha_deg,
        mean_n: mean(&forces_n),
        sd_n: mean_and_sd(&forces_n).map(|(_, sd)| sd),
        kept_mean_n: mean(&kept),
        kept_sd_n: mean_and_sd(&kept).map(|(_, sd)| sd),
        forces_n,
        strokes: members,
        outliers,
    }
}

/// Positions of outliers by the generalised extreme Studentised deviate test at 5 %.
fn outliers(values: &[f64]) -> Vec<usize> {
    let n = values.len();
    let most = (n / 10).max(1);
    let mut left: Vec<usize> = (0..n).collect();
    let (mut removed, mut found) = (Vec::new(), 0);
    for i in 1..=most {
        // Under five values anything goes.
        if left.len() < 5 {
            break;
        }
        let now: Vec<f64> = left.iter().map(|k| values[*k]).collect();
        let Some((mean, sd)) = mean_and_sd(&now) else { break };
        let Some(place) =
            (0..now.len()).max_by(|a, b| (now[*a] - mean).abs().total_cmp(&(now[*b] - mean).abs()))
        else {
            break;
        };
        let deviate = (now[place] - mean).abs() / sd;
        let (m, freedom) = ((n - i + 1) as f64, (n - i - 1) as f64);
        let Some(t) = t_quantile(0.05 / (2.0 * m), freedom) else { break };
        let critical = (m - 1.0) * t / ((freedom + t * t) * m).sqrt();
        removed.push(left.remove(place));
        if sd > 0.0 && deviate > critical {
            found = i;
        }
    }
    removed.truncate(found);
    removed.sort_unstable();
    removed
}

/// Slope of the logarithm of force over a covariate, with a mean of its own for each tool angle.
fn dependence(rows: &[(f64, f64, f64)]) -> Option<Dependence> {
    let (low, high) =
        rows.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(r.1), h.max(r.1)));
    let mut angles: Vec<f64> = rows.iter().map(|r| r.0).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let freedom = rows.len() as f64 - angles.len() as f64 - 1.0;
    if high <= low || freedom < 1.0 {
        return None;
    }
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for alpha in angles {
        let of: Vec<_> = rows.iter().filter(|r| r.0 == alpha).collect();
        let n = of.len() as f64;
        let (x, y) = (of.iter().map(|r| r.1).sum::<f64>() / n, of.iter().map(|r| r.2).sum::<f64>() / n);
        for row in of {
            xx += (row.1 - x).powi(2);
            xy += (row.1 - x) * (row.2 - y);
            yy += (row.2 - y).powi(2);
        }
    }
    // Radius and tool angle always together: nothing to compare.
    if xx <= 1e-12 * (high - low).powi(2) {
        return None;
    }
    let slope = xy / xx;
    let variance = ((yy - slope * xy).max(0.0) / freedom) / xx;
    let (effect, se) = (slope * (high - low), variance.sqrt() * (high - low));
    Some(Dependence {
        effect_rel: effect.exp_m1(),
        effect_se: se,
        p: two_sided_p(effect / se, freedom),
        range: [low, high],
        strokes: rows.len(),
    })
}
