//! The error budget: what each source of error does to a force (Hong 2001, section 6.7.4).

use soilctl_earth_pressure::{Case, ChenLiu, EarthPressureError, Input, sensitivity_percent};
use soilctl_soil::Angle;

use crate::estimate::Estimation;

/// Accuracy of a plate's angle and of the ground's level (deg).
const TOOL_ANGLE_DEG: f64 = 1.0;
const SURFACE_DEG: f64 = 1.0;
/// Friction angle (deg) where no soil is consistent.
const USUAL_PHI_DEG: f64 = 40.0;
/// Tool angles that are shown.
const MOST_ANGLES: usize = 6;

/// A source of error.
#[derive(Debug, Clone)]
pub struct ErrorSource {
    /// The source with its size.
    pub name: String,
    /// Effect on the force in per cent, by tool angle.
    pub percent: Vec<f64>,
}

/// What each source of error does to a force, by Chen & Liu's model.
#[derive(Debug, Clone)]
pub struct ErrorBudget {
    /// Friction angle of the soil (deg).
    pub phi_deg: f64,
    /// Interface friction (deg).
    pub delta_deg: f64,
    /// Tool angles (deg).
    pub tool_angles_deg: Vec<f64>,
    /// The sources, all of them together as if independent, and the half width of the band that was used.
    pub sources: Vec<ErrorSource>,
}

impl ErrorBudget {
    pub(super) fn of(estimation: &Estimation) -> Self {
        let answer = &estimation.answer;
        let phi_deg = match (&answer.best_estimate, answer.phi_deg) {
            (Some(best), _) => best.phi_deg,
            _ => USUAL_PHI_DEG,
        };
        let (low, high) = estimation.inputs.delta_deg;
        let delta_deg = f64::midpoint(low, high).min(phi_deg - 2.0).max(0.0);
        let mut tool_angles_deg: Vec<f64> = answer.measurements.iter().map(|m| m.alpha_deg).collect();
        tool_angles_deg.sort_by(f64::total_cmp);
        tool_angles_deg.dedup();
        tool_angles_deg.truncate(MOST_ANGLES);
        let mut budget = Self { phi_deg, delta_deg, tool_angles_deg, sources: Vec::new() };
        budget.fill(estimation);
        budget
    }

    fn fill(&mut self, estimation: &Estimation) {
        let campaign = &estimation.inputs.campaign;
        let angles = self.tool_angles_deg.clone();
        let delta_sd = campaign.delta_sd_deg;
        for (name, input, step) in [
            (format!("interface friction ± {delta_sd:.1}°"), Input::Interface, delta_sd),
            (format!("tool angle ± {TOOL_ANGLE_DEG:.1}°"), Input::ToolAngle, TOOL_ANGLE_DEG),
            (format!("surface slope ± {SURFACE_DEG:.1}°"), Input::SurfaceSlope, SURFACE_DEG),
        ] {
            let effects = angles.iter().map(|&alpha| {
                let beta_deg = estimation.request.loads.beta_deg;
                let base = Case::from_deg(alpha, beta_deg, self.phi_deg, self.delta_deg);
                sensitivity_percent(&ChenLiu, &base, input, Angle::from_degrees(step))
            });
            // Beyond the closed form's range there is nothing to say about this source.
            if let Ok(percent) = effects.collect::<Result<Vec<_>, EarthPressureError>>() {
                self.sources.push(ErrorSource { name, percent });
            }
        }
        let measured = |alpha: f64| estimation.answer.measurements.iter().find(|m| m.alpha_deg == alpha);
        let depth_sd = campaign.depth_sd_m;
        self.push(format!("depth ± {:.2} mm", 1e3 * depth_sd), |alpha| {
            200.0 * depth_sd / measured(alpha).map_or(f64::INFINITY, |m| m.depth_m)
        });
        let density = 100.0 * campaign.density_sd_rel;
        self.push(format!("density ± {density:.1} %"), |_| density);
        let sensor = 100.0 * campaign.instrument.force_gain_sd;
        self.push(format!("force sensor ± {sensor:.0} %"), |_| sensor);
        let all = |i: usize| self.sources.iter().map(|s| s.percent[i] * s.percent[i]).sum::<f64>().sqrt();
        let percent = (0..angles.len()).map(all).collect();
        self.sources.push(ErrorSource { name: "all, independent".into(), percent });
        self.push("half width of the band used".into(), |alpha| {
            measured(alpha).map_or(0.0, |m| 50.0 * (m.force_high_n - m.force_low_n) / m.force_n)
        });
    }

    fn push(&mut self, name: String, percent: impl Fn(f64) -> f64) {
        let percent = self.tool_angles_deg.iter().map(|&alpha| percent(alpha)).collect();
        self.sources.push(ErrorSource { name, percent });
    }
}
