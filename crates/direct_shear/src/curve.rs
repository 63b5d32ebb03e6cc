use serde::Serialize;
use soilctl_soil::{Angle, units};

use crate::degrees;
use crate::error::{DirectShearError, check};
use crate::point::{ShearPoint, check_stress};

/// Stresses closer than this (relative) are one load: tests at the same load differ by rounding only.
const SAME_STRESS: f64 = 1e-6;
/// Slack when deciding whether a stress lies inside the tested range, for the rounding of unit conversions.
const RANGE_SLACK: f64 = 1e-9;

/// A friction angle read off a fitted curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FrictionAt {
    /// The normal stress asked for, in Pa.
    pub normal_stress_pa: f64,
    /// The friction angle there.
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    pub friction: Angle,
    /// Whether the stress is below the lowest or above the highest stress of the fit.
    pub extrapolated: bool,
    /// Standard error in degrees of predicting one further test at this stress; `None` if the fit has no
    /// spare point to judge it by, or no linear theory for it. It knows the scatter about the curve, not
    /// whether the curve has the right shape: extrapolated, the true error is larger.
    pub standard_error_deg: Option<f64>,
}

/// A curve of friction angle against normal stress.
pub trait FrictionCurve {
    /// What the curve is called in tables and messages.
    fn name(&self) -> &'static str;

    /// Lowest and highest normal stress of the fit in Pa.
    fn stress_range_pa(&self) -> (f64, f64);

    /// The friction angle at a normal stress (above 1e-6 and below 1e9 Pa).
    ///
    /// # Errors
    /// [`DirectShearError::OutOfRange`] for a stress outside that range, and
    /// [`DirectShearError::ImpossibleFriction`] if the curve leaves the range between 0 and 90 degrees there.
    fn friction_at(&self, normal_stress_pa: f64) -> Result<FrictionAt, DirectShearError>;

    /// Whether a normal stress in Pa lies outside [`FrictionCurve::stress_range_pa`].
    fn is_extrapolated(&self, normal_stress_pa: f64) -> bool {
        let (low, high) = self.stress_range_pa();
        normal_stress_pa < low * (1.0 - RANGE_SLACK) || normal_stress_pa > high * (1.0 + RANGE_SLACK)
    }
}

/// Checks stress and answer of a curve, so that every curve refuses the same things.
pub(crate) fn answer(
    curve: &impl FrictionCurve,
    normal_stress_pa: f64,
    friction_deg: impl Fn(f64) -> f64,
    standard_error_deg: impl Fn(f64) -> Option<f64>,
) -> Result<FrictionAt, DirectShearError> {
    check_stress("normal_stress_pa", normal_stress_pa)?;
    let degrees = friction_deg(normal_stress_pa);
    if !(degrees > 0.0 && degrees < 90.0) {
        return Err(DirectShearError::ImpossibleFriction {
            curve: curve.name(),
            normal_stress_pa,
            friction_deg: degrees,
        });
    }
    Ok(FrictionAt {
        normal_stress_pa,
        friction: Angle::from_degrees(degrees),
        extrapolated: curve.is_extrapolated(normal_stress_pa),
        standard_error_deg: standard_error_deg(normal_stress_pa).filter(|error| error.is_finite()),
    })
}

/// One point as the fits see it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) stress_pa: f64,
    pub(crate) stress_psi: f64,
    pub(crate) angle_deg: f64,
    pub(crate) weight: f64,
}

/// Points and weights in order of stress: the fits then do not depend on the order of the table, not even in
/// the last bit.
pub(crate) fn samples(
    points: &[ShearPoint],
    weights: Option<&[f64]>,
) -> Result<Vec<Sample>, DirectShearError> {
    if let Some(weights) = weights {
        if weights.len() != points.len() {
            return Err(DirectShearError::WeightCount { weights: weights.len(), points: points.len() });
        }
        for weight in weights {
            // Bounded, so that no sum of weights can overflow or vanish.
            check("weight", *weight, "", "above 1e-9 and below 1e9", |w| w > 1e-9 && w < 1e9)?;
        }
    }
    let mut samples: Vec<Sample> = points
        .iter()
        .enumerate()
        .map(|(index, point)| Sample {
            stress_pa: point.normal_stress_pa(),
            stress_psi: units::pa_to_psi(point.normal_stress_pa()),
            angle_deg: point.friction().degrees(),
            weight: weights.map_or(1.0, |weights| weights[index]),
        })
        .collect();
    samples.sort_by(|a, b| {
        (a.stress_pa.total_cmp(&b.stress_pa))
            .then(a.angle_deg.total_cmp(&b.angle_deg))
            .then(a.weight.total_cmp(&b.weight))
    });
    Ok(samples)
}

/// The different stresses in Pa of samples in order of stress.
pub(crate) fn distinct_stresses_pa(samples: &[Sample]) -> Vec<f64> {
    let mut distinct: Vec<f64> = Vec::new();
    for sample in samples {
        if distinct.last().is_none_or(|last| sample.stress_pa > last * (1.0 + SAME_STRESS)) {
            distinct.push(sample.stress_pa);
        }
    }
    distinct
}

/// Refuses samples with fewer than `needed` different stresses.
pub(crate) fn need_stresses(
    curve: &'static str,
    samples: &[Sample],
    needed: usize,
    selection: &str,
) -> Result<(), DirectShearError> {
    let found = distinct_stresses_pa(samples).len();
    if found < needed {
        return Err(DirectShearError::TooFewStresses {
            curve,
            needed,
            found,
            selection: selection.to_owned(),
        });
    }
    Ok(())
}
