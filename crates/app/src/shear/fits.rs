//! The curves of one soil.

use soilctl_direct_shear::{
    ConstantFit, DirectShearError, FrictionCurve, LogLogFit, Misfit, ShearPoint, ShearSeries, SlopeFloorFit,
    compare_curves,
};

use super::answer::{Constant, Point, PowerLaw, SlopeFloor, SoilAnswer};

/// Slack when a stress is compared with the tested ones, for the rounding of unit conversions.
const RANGE_SLACK: f64 = 1e-9;

/// A soil with the curves that could be fitted.
#[derive(Debug)]
pub struct Fitted {
    soil: Option<String>,
    /// The tests, by increasing stress.
    pub points: Vec<ShearPoint>,
    /// The power law.
    pub power: Option<LogLogFit>,
    /// The slope that ends on a floor.
    pub floor: Option<SlopeFloorFit>,
    constant: Option<ConstantFit>,
    best: Option<String>,
    /// Why the others could not.
    pub(super) problems: Vec<DirectShearError>,
}

impl Fitted {
    pub(super) fn of(series: ShearSeries, weights: Option<&[f64]>, fit_limit_pa: f64) -> Self {
        let ShearSeries { soil, mut points } = series;
        let mut problems = Vec::new();
        let power = kept(LogLogFit::fit_below(&points, fit_limit_pa), &mut problems);
        let floor = kept(SlopeFloorFit::fit(&points, weights), &mut problems);
        let constant = kept(ConstantFit::fit(&points, weights), &mut problems);
        let best = compare_curves(&points, weights).ok().map(|comparison| comparison.verdict);
        points.sort_by(|a, b| a.normal_stress_pa().total_cmp(&b.normal_stress_pa()));
        Self { soil, points, power, floor, constant, best, problems }
    }

    /// Name of the soil, for sentences.
    #[must_use]
    pub fn name(&self) -> &str {
        self.soil.as_deref().unwrap_or("the soil")
    }

    /// The curves to read angles from: those that follow the stress, or the constant if there is no other.
    pub(super) fn curves(&self) -> Vec<&dyn FrictionCurve> {
        let power = self.power.as_ref().map(|fit| fit as &dyn FrictionCurve);
        let floor = self.floor.as_ref().map(|fit| fit as &dyn FrictionCurve);
        let constant = self.constant.as_ref().map(|fit| fit as &dyn FrictionCurve);
        match (power, floor) {
            (None, None) => constant.into_iter().collect(),
            _ => power.into_iter().chain(floor).collect(),
        }
    }

    /// Lowest and highest tested stress in Pa.
    #[must_use]
    pub fn tested_pa(&self) -> (f64, f64) {
        let stresses = self.points.iter().map(|point| point.normal_stress_pa());
        stresses.fold((f64::INFINITY, 0.0), |(low, high), stress| (stress.min(low), stress.max(high)))
    }

    pub(super) fn is_below_tested(&self, stress_pa: f64) -> bool {
        stress_pa < self.tested_pa().0 * (1.0 - RANGE_SLACK)
    }

    pub(super) fn is_above_tested(&self, stress_pa: f64) -> bool {
        stress_pa > self.tested_pa().1 * (1.0 + RANGE_SLACK)
    }

    /// Points and curves as they are answered, nothing read off them yet.
    pub(super) fn answer(&self) -> SoilAnswer {
        SoilAnswer {
            soil: self.soil.clone(),
            points: self.points.iter().map(|point| self.point(point)).collect(),
            power_law: self.power.as_ref().map(power_law),
            slope_floor: self.floor.as_ref().map(slope_floor),
            constant: self.constant.as_ref().map(constant),
            best: self.best.clone(),
            at: Vec::new(),
            stroke: None,
        }
    }

    fn point(&self, point: &ShearPoint) -> Point {
        let stress_pa = point.normal_stress_pa();
        let on = |curve: &dyn FrictionCurve| Some(curve.friction_at(stress_pa).ok()?.friction.degrees());
        Point {
            normal_stress_pa: stress_pa,
            friction_angle_deg: point.friction().degrees(),
            power_law_deg: self.power.as_ref().and_then(|fit| on(fit)),
            slope_floor_deg: self.floor.as_ref().and_then(|fit| on(fit)),
        }
    }
}

/// Why no soil has any curve; `None` if one has.
pub(super) fn nothing_fitted(fitted: &[Fitted]) -> Option<&DirectShearError> {
    if fitted.iter().any(|one| !one.curves().is_empty()) {
        return None;
    }
    fitted.iter().find_map(|one| one.problems.last())
}

fn kept<T>(fit: Result<T, DirectShearError>, problems: &mut Vec<DirectShearError>) -> Option<T> {
    fit.map_err(|problem| problems.push(problem)).ok()
}

fn power_law(fit: &LogLogFit) -> PowerLaw {
    let Misfit { points, rms_deg, worst_residual_deg, .. } = fit.misfit;
    PowerLaw {
        a_deg_at_1_psi: fit.friction_at_1_psi_deg,
        b: fit.exponent,
        ln_a_standard_error: fit.ln_friction_standard_error,
        b_standard_error: fit.exponent_standard_error,
        points,
        rms_deg,
        worst_residual_deg,
        stress_range_pa: fit.stress_range_pa().into(),
    }
}

fn slope_floor(fit: &SlopeFloorFit) -> SlopeFloor {
    let Misfit { points, rms_deg, worst_residual_deg, .. } = fit.misfit;
    SlopeFloor {
        floor_deg: fit.floor.degrees(),
        slope_deg_per_decade: fit.slope_deg_per_decade,
        floor_stress_pa: fit.floor_stress_pa,
        floor_stress_settled: fit.floor_stress_settled,
        points,
        rms_deg,
        worst_residual_deg,
        stress_range_pa: fit.stress_range_pa().into(),
    }
}

fn constant(fit: &ConstantFit) -> Constant {
    let Misfit { points, rms_deg, worst_residual_deg, .. } = fit.misfit;
    Constant {
        friction_angle_deg: fit.friction.degrees(),
        points,
        rms_deg,
        worst_residual_deg,
        stress_range_pa: fit.stress_range_pa().into(),
    }
}
