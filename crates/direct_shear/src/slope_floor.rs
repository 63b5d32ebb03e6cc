use serde::Serialize;
use soilctl_soil::{Angle, units};
use soilctl_stats::Line;

use crate::curve::{FrictionAt, FrictionCurve, Sample, answer, distinct_stresses_pa, need_stresses, samples};
use crate::degrees;
use crate::error::{DirectShearError, check};
use crate::misfit::Misfit;
use crate::point::ShearPoint;

const NAME: &str = "slope and floor";

/// Friction falls by a fixed angle a decade of stress down to a floor:
/// `phi = floor + slope * max(0, log10(sigma_floor / sigma))`.
///
/// The floor is sliding friction, the slope the dilatancy that low stress leaves to the soil (Lee & Seed 1967, in
/// Hong 2001, section 6.7.1).
///
/// On table 6.13 with the four low loads weighted 3 to 1 the weighted RMS residuals are 0.76, 0.36, 0.81 and 0.26 deg
/// (loose Ticino, Nevada, rained Ticino, glass); a constant misses by 3.4, 2.6, 2.5 and 2.0 deg. Single tests
/// depart by up to 1.4, 0.8, 1.8 and 0.5 deg. The rained soil's unweighted RMS is 0.97 deg, and 0.56 deg if its
/// printed 43.0 deg at 1.16 psi is taken for a misprint of 40.0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SlopeFloorFit {
    /// Friction angle at and above the floor stress.
    #[serde(rename = "floor_deg", serialize_with = "degrees::one")]
    pub floor: Angle,
    /// Fall of the friction angle in degrees for each factor of ten in stress, at least 0.
    pub slope_deg_per_decade: f64,
    /// Stress in Pa above which the angle is constant.
    pub floor_stress_pa: f64,
    /// Whether the points settle the floor stress. They do not if they show no slope, if a single load lies on
    /// the slope (any break up to the next load fits equally well; the gentlest slope is given), or if
    /// friction still falls at the highest load, which is then taken for the floor stress.
    pub floor_stress_settled: bool,
    /// Residuals of the points.
    pub misfit: Misfit,
    /// Lowest fitted stress in Pa.
    pub lowest_stress_pa: f64,
    /// Highest fitted stress in Pa.
    pub highest_stress_pa: f64,
}

/// One least-squares solution; `break_log` is log10 of the floor stress in psi.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    floor_deg: f64,
    slope: f64,
    break_log: f64,
    settled: bool,
}

impl Candidate {
    fn at(&self, stress_psi: f64) -> f64 {
        self.floor_deg + self.slope * (self.break_log - stress_psi.log10()).max(0.0)
    }
}

impl SlopeFloorFit {
    /// Least squares over all points; weights multiply the squared residuals and are 1 if not given.
    ///
    /// The break is found exactly. With the break between two adjacent loads the points below it lie on a free line
    /// and the others on a constant, both linear problems; should their crossing fall outside the two loads, the
    /// best break of that interval is one of its ends, because the allowed sets (slope at least 0) are convex
    /// and meet only there. The best of all intervals is returned.
    ///
    /// # Errors
    /// [`DirectShearError::TooFewStresses`] with fewer than three different stresses (there are three unknowns),
    /// errors of the weights, [`DirectShearError::ImpossibleFriction`] if the floor is not an angle between 0 and
    /// 90 degrees, [`DirectShearError::Overflow`] if a fitted number is not finite.
    pub fn fit(points: &[ShearPoint], weights: Option<&[f64]>) -> Result<Self, DirectShearError> {
        let samples = samples(points, weights)?;
        need_stresses(NAME, &samples, 3, "all points")?;
        let mut best: Option<(f64, Candidate)> = None;
        for candidate in candidates(&samples) {
            let sse: f64 =
                samples.iter().map(|s| s.weight * (s.angle_deg - candidate.at(s.stress_psi)).powi(2)).sum();
            if sse.is_finite() && best.as_ref().is_none_or(|(least, _)| sse < *least) {
                best = Some((sse, candidate));
            }
        }
        let overflow = DirectShearError::Overflow { curve: NAME };
        let Some((_, found)) = best else { return Err(overflow) };
        let fit = Self {
            floor: Angle::from_degrees(found.floor_deg),
            slope_deg_per_decade: found.slope,
            floor_stress_pa: units::psi_to_pa(10f64.powf(found.break_log)),
            floor_stress_settled: found.settled,
            misfit: Misfit::of(&samples, |sample| found.at(sample.stress_psi)),
            lowest_stress_pa: samples.first().map_or(0.0, |sample| sample.stress_pa),
            highest_stress_pa: samples.last().map_or(0.0, |sample| sample.stress_pa),
        };
        // A straight line through very uneven points can end below zero.
        if !(found.floor_deg > 0.0 && found.floor_deg < 90.0) {
            return Err(DirectShearError::ImpossibleFriction {
                curve: NAME,
                normal_stress_pa: fit.floor_stress_pa,
                friction_deg: found.floor_deg,
            });
        }
        if fit.slope_deg_per_decade.is_finite() && fit.floor_stress_pa.is_finite() && fit.misfit.is_finite() {
            Ok(fit)
        } else {
            Err(overflow)
        }
    }
}

fn candidates(samples: &[Sample]) -> Vec<Candidate> {
    let data: Vec<(f64, f64, f64)> =
        samples.iter().map(|s| (s.stress_psi.log10(), s.angle_deg, s.weight)).collect();
    let knots: Vec<f64> =
        distinct_stresses_pa(samples).into_iter().map(|stress| units::pa_to_psi(stress).log10()).collect();
    let last = knots.len() - 1;
    let level: Vec<(f64, f64, f64)> = data.iter().map(|d| (0.0, d.1, d.2)).collect();
    let flat = Line::fit(&level);
    let mut found =
        vec![Candidate { floor_deg: flat.mean_y, slope: 0.0, break_log: knots[0], settled: false }];
    for k in 1..=last {
        // Break at load k: one linear problem in h = max(0, break - x).
        let at_knot: Vec<_> = data.iter().map(|d| ((knots[k] - d.0).max(0.0), d.1, d.2)).collect();
        let line = Line::fit(&at_knot);
        let settled = k > 1 && k < last;
        found.push(Candidate { floor_deg: line.at(0.0), slope: line.slope, break_log: knots[k], settled });
        // Break between loads k and k + 1: a free line below, a constant above, if they cross in between.
        // With a single load below, the line is not determined, and the candidates at the loads cover it.
        if k + 1 > last {
            continue;
        }
        let split = data.partition_point(|d| d.0 < f64::midpoint(knots[k], knots[k + 1]));
        let (below, above) = (Line::fit(&data[..split]), Line::fit(&level[split..]));
        let crossing = below.mean_x + (above.mean_y - below.mean_y) / below.slope;
        if crossing >= knots[k] && crossing <= knots[k + 1] {
            let slope = -below.slope;
            found.push(Candidate { floor_deg: above.mean_y, slope, break_log: crossing, settled: true });
        }
    }
    found.retain(|candidate| candidate.slope >= 0.0);
    found
}

impl FrictionCurve for SlopeFloorFit {
    fn name(&self) -> &'static str {
        NAME
    }

    fn stress_range_pa(&self) -> (f64, f64) {
        (self.lowest_stress_pa, self.highest_stress_pa)
    }

    /// No standard error is given: the break makes the error of prediction anything but normal.
    fn friction_at(&self, normal_stress_pa: f64) -> Result<FrictionAt, DirectShearError> {
        let degrees = |stress_pa: f64| {
            let decades = (self.floor_stress_pa / stress_pa).log10().max(0.0);
            self.floor.degrees() + self.slope_deg_per_decade * decades
        };
        answer(self, normal_stress_pa, degrees, |_| None)
    }
}

/// Weights for tests that were averaged at low loads and made once at high loads: `ratio` below
/// `stress_limit_pa`, 1 from there on (Hong 2001: three kept tests below 2.5 psi, one above).
///
/// # Errors
/// [`DirectShearError::OutOfRange`] unless the ratio is above 1e-9 and below 1e9 and the limit above 0 Pa.
pub fn low_load_weights(
    points: &[ShearPoint],
    stress_limit_pa: f64,
    ratio: f64,
) -> Result<Vec<f64>, DirectShearError> {
    check("stress_limit_pa", stress_limit_pa, "Pa", "above 0 Pa", |limit| limit > 0.0)?;
    check("ratio", ratio, "", "above 1e-9 and below 1e9", |r| r > 1e-9 && r < 1e9)?;
    Ok(points.iter().map(|p| if p.normal_stress_pa() < stress_limit_pa { ratio } else { 1.0 }).collect())
}
