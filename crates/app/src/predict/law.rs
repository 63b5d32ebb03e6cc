//! The prediction of a plate in soil whose friction falls with stress.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_earth_pressure::{
    Case, EQUIVALENT_OVER_MEAN, EarthPressureError, mean_slip_stress_over_pressure,
};
use soilctl_estimator::FrictionLaw;
use soilctl_soil::{Angle, Plate};

use super::answer::Answer;
use super::{Request, single};
use crate::AppError;
use crate::request::check_slopes;
use crate::text::number;

/// Steps towards the friction at the stress that it brings about itself; each is nearer by a factor of three or more.
const STEPS: usize = 24;

/// What a law of stress leaves open: ranges over its slopes, over what is known of the stress where the soil slips, and over the bracket of the
/// model if it has one.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LawPrediction {
    /// Slopes of the law (deg a decade).
    pub slope_deg_per_decade: [f64; 2],
    /// Normal stress (Pa) at which the friction angle is the one of the inputs.
    pub reference_stress_pa: f64,
    /// Normal stress (Pa) where the soil slips.
    pub slip_stress_pa: [f64; 2],
    /// Friction angle (deg) there; the coefficients, the force and the sensitivity of this answer are those of its middle.
    pub phi_deg: [f64; 2],
    /// Failure force (N).
    pub force_n: [f64; 2],
}

pub(super) fn predict(request: &Request, alpha_deg: f64, slopes: (f64, f64)) -> Result<Answer, AppError> {
    let wrong = |problem: &str| AppError::Request(problem.to_owned());
    check_slopes(slopes).map_err(|problem| wrong(&format!("--friction-law: {problem}")))?;
    let Some(reference_stress_pa) = request.reference_stress_pa else {
        return Err(wrong("give --reference-stress PA, at which --phi is the friction angle"));
    };
    let loads = &request.loads;
    if loads.cohesion_pa != 0.0 || loads.adhesion_pa != 0.0 || loads.surcharge_pa != 0.0 {
        return Err(wrong(
            "--friction-law is for soil without --cohesion, --adhesion and --surcharge: the stress where it slips is known for its weight alone",
        ));
    }
    let (Some(depth_m), Some(width_m), Some(_)) = (request.depth_m, request.width_m, request.density_kg_m3)
    else {
        return Err(wrong("--friction-law needs --depth, --width and --density: stresses go with all three"));
    };
    let plate =
        Plate::new(Angle::from_degrees(alpha_deg), Angle::from_degrees(loads.beta_deg), depth_m, width_m)?;
    let law = FrictionLaw { slope_deg_per_decade: slopes, reference_stress_pa };
    let stroke = Stroke { request, alpha_deg, area_m2: plate.slant_length_m() * width_m, law };
    let ends = [stroke.end(0)?, stroke.end(1)?];
    let [low, high] = [&ends[0], &ends[1]];
    let phi_deg = [low.phi_deg, high.phi_deg];
    let middle = stroke.with_friction(f64::midpoint(phi_deg[0], phi_deg[1]));
    let mut answer = single::predict(&middle, alpha_deg, true)?;
    let slip_stress_pa = [high.stress_pa, low.stress_pa];
    answer.inputs.phi_deg = request.phi()?;
    answer.notes.push(format!(
        "friction is {} to {} deg at the stress where this soil slips, {} to {} Pa; coefficients and force are those of its middle, {} deg",
        number(phi_deg[0]),
        number(phi_deg[1]),
        number(slip_stress_pa[0]),
        number(slip_stress_pa[1]),
        number(f64::midpoint(phi_deg[0], phi_deg[1]))
    ));
    answer.friction_law = Some(LawPrediction {
        slope_deg_per_decade: slopes.into(),
        reference_stress_pa,
        slip_stress_pa,
        phi_deg,
        force_n: [low.force_n[0], high.force_n[1]],
    });
    Ok(answer)
}

struct Stroke<'a> {
    request: &'a Request,
    alpha_deg: f64,
    area_m2: f64,
    law: FrictionLaw,
}

/// The weakest or the strongest that the law lets the soil be.
struct End {
    phi_deg: f64,
    stress_pa: f64,
    force_n: [f64; 2],
}

impl Stroke<'_> {
    /// The same question about a soil with one friction angle.
    fn with_friction(&self, phi_deg: f64) -> Request {
        Request {
            phi_deg: Some(phi_deg),
            friction_law: None,
            reference_stress_pa: None,
            ..self.request.clone()
        }
    }

    /// The least friction (0) is that at the greatest stress, the greatest (1) that at the least.
    fn end(&self, end: usize) -> Result<End, AppError> {
        let reference_deg = self.request.phi()?;
        let mut phi_deg = reference_deg;
        let mut found = self.stress(phi_deg, end)?;
        for _ in 0..STEPS {
            let next = self.law.friction_range_deg(reference_deg, [found.0; 2])[end];
            let is_done = (next - phi_deg).abs() < 1e-6;
            phi_deg = next;
            found = self.stress(phi_deg, end)?;
            if is_done {
                break;
            }
        }
        Ok(End { phi_deg, stress_pa: found.0, force_n: found.1 })
    }

    /// The normal stress where a soil with this friction slips, and the force: both ends of it.
    fn stress(&self, phi_deg: f64, end: usize) -> Result<(f64, [f64; 2]), AppError> {
        let answer = single::predict(&self.with_friction(phi_deg), self.alpha_deg, false)?;
        let force = answer.force_n.unwrap_or(f64::NAN);
        let part = |bound: Option<f64>| bound.zip(answer.k_net).map_or(1.0, |(bound, net)| bound / net);
        let forces = [force * part(answer.k_net_lower), force * part(answer.k_net_upper)];
        let case = Case::from_deg(
            self.alpha_deg,
            self.request.loads.beta_deg,
            phi_deg,
            answer.inputs.delta_deg.unwrap_or(0.0),
        );
        let mean = mean_slip_stress_over_pressure(&case)? * libm::cos(case.interface.radians());
        // The least friction goes with the greatest stress.
        let stress = forces[1 - end] / self.area_m2 * mean * EQUIVALENT_OVER_MEAN[1 - end];
        if stress > 0.0 && stress.is_finite() {
            Ok((stress, forces))
        } else {
            Err(EarthPressureError::Singular {
                model: "chen",
                alpha_deg: self.alpha_deg,
                phi_deg,
                delta_deg: case.interface.degrees(),
                reason: "the stress where the soil slips is not known here",
            }
            .into())
        }
    }
}
