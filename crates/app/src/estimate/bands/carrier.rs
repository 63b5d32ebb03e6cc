//! What each force would have been at the reference of its kind, and how far it may be off.

use soilctl_earth_pressure::{Case, EarthPressureError, ForceModel};
use soilctl_soil::{Angle, WidthRatio};
use soilctl_strokes::{Campaign, Kind, StrokeRow};

use super::super::request::Request;
use super::chosen::{SAME_ALPHA_DEG, Stroke};
use crate::AppError;
use crate::text::number;

/// Forces are carried over some degrees and tenths of the depth in a soil of this friction angle and density.
const USUAL_PHI_DEG: f64 = 40.0;
/// At 30 or 45 deg such a correction is by this share of itself different, by the table of proven bounds at 70 to 100 deg.
const CARRIED_SHARE: f64 = 0.2;
const USUAL_DENSITY_KG_M3: f64 = 1500.0;
const USUAL_END_FACTOR: f64 = 0.5;

/// The plate of a kind.
pub(super) struct Reference {
    pub(super) alpha_deg: f64,
    pub(super) depth_m: f64,
    pub(super) width_m: f64,
}

/// A force at the reference of its kind.
struct Carried {
    force_n: f64,
    /// Relative standard deviation by what is the stroke's own; `None` if the table does not say that of the force.
    sd_rel: Option<f64>,
    /// Logarithm of what tool angle and friction have changed.
    corrected: f64,
}

/// Brings forces to a reference.
pub(super) struct Carrier<'a> {
    pub(super) request: &'a Request,
    pub(super) campaign: &'a Campaign,
    pub(super) friction_deg: Option<f64>,
    /// Of the density between preparations.
    pub(super) density_sd_rel: f64,
    /// What forces are carried by: the estimate's own model if it is one of plates with ends alone, otherwise Chen and Liu's.
    pub(super) by: &'a dyn ForceModel,
    /// What says how much ends add to that at most; half of it is carried by. `None` if plates have no ends, or the model has them.
    pub(super) ends: Option<&'a dyn ForceModel>,
    /// Tool angles that the model covers, in deg.
    pub(super) range: (f64, f64),
}

impl Carrier<'_> {
    /// The strokes of a kind at its reference; `None` of no stroke.
    pub(super) fn kind(
        &self,
        file: &str,
        members: &[&Stroke],
    ) -> Result<Option<(Reference, Kind)>, AppError> {
        let mut angles: Vec<f64> = members.iter().map(|stroke| stroke.row.alpha_deg).collect();
        angles.sort_by(f64::total_cmp);
        let Some(first) = members.first() else { return Ok(None) };
        let middle = angles.get(angles.len() / 2).copied().unwrap_or(first.row.alpha_deg);
        let inside = middle.clamp(self.range.0, self.range.1);
        let reference = Reference {
            // A plate that stood a little outside of what the model covers is carried to the end.
            alpha_deg: if (inside - middle).abs() <= SAME_ALPHA_DEG { inside } else { middle },
            depth_m: members.iter().map(|s| s.row.depth_m).sum::<f64>() / members.len() as f64,
            width_m: first.row.width_m,
        };
        let carried = members.iter().map(|stroke| {
            self.carried(&reference, stroke).map_err(|problem| AppError::Row {
                file: file.to_owned(),
                line: stroke.row.line,
                problem,
            })
        });
        let carried: Vec<Carried> = carried.collect::<Result<_, AppError>>()?;
        let corrected = carried.iter().map(|one| one.corrected).sum::<f64>() / members.len() as f64;
        let common = self.common_rel(&reference, members).map_err(AppError::EarthPressure)?;
        let depth_mm = 1e3 * reference.depth_m;
        let kind = Kind {
            label: format!(
                "{} deg, {} mm",
                number(reference.alpha_deg),
                number((depth_mm * 10.0).round() / 10.0)
            ),
            lines: members.iter().map(|stroke| stroke.row.line).collect(),
            forces_n: carried.iter().map(|one| one.force_n).collect(),
            sds_rel: carried.iter().map(|one| one.sd_rel).collect(),
            common_rel: common.hypot(CARRIED_SHARE * corrected),
        };
        Ok(Some((reference, kind)))
    }

    fn carried(&self, to: &Reference, stroke: &Stroke) -> Result<Carried, EarthPressureError> {
        let row = &stroke.row;
        let friction = stroke.friction_deg;
        let alpha_deg = row.alpha_deg + row.turned_deg.unwrap_or(0.0);
        let here = self.usual_n(alpha_deg, friction, row.depth_m, row.width_m)?;
        // A stroke that does not tell its friction is taken as it is.
        let to_friction = friction.and(self.friction_deg);
        let there = self.usual_n(to.alpha_deg, to_friction, to.depth_m, to.width_m)?;
        let force_n = row.force_n * there / here;
        let beside = self.usual_n(to.alpha_deg, to_friction, row.depth_m, row.width_m)?;
        let corrected = (beside / here).ln();
        let Some(force_sd_n) = row.force_sd_n else {
            return Ok(Carried { force_n, sd_rel: None, corrected });
        };
        let by_depth = self.depth_exponent(alpha_deg, friction, row)?;
        let depth_sd_m = row.depth_sd_m.unwrap_or(self.campaign.depth_sd_m);
        let friction_sd_deg = match (row.friction_angle_deg, friction) {
            (Some(_), _) => row.friction_angle_sd_deg.unwrap_or(self.campaign.instrument.friction_angle_sd),
            (None, Some(_)) => self.campaign.delta_sd_deg,
            (None, None) => 0.0,
        };
        let by_friction = match friction {
            Some(deg) => {
                let more = self.usual_n(alpha_deg, Some(deg + 1.0), row.depth_m, row.width_m)?;
                (more / here).ln()
            }
            None => 0.0,
        };
        let own =
            [force_sd_n / row.force_n, by_depth * depth_sd_m / row.depth_m, by_friction * friction_sd_deg];
        Ok(Carried { force_n, sd_rel: Some(together(&own)), corrected })
    }

    /// What strokes of a kind share: the sensor's gain, the datum of depths, the density of their preparations, the soil ahead.
    fn common_rel(&self, at: &Reference, members: &[&Stroke]) -> Result<f64, EarthPressureError> {
        let Some(first) = members.first() else { return Ok(0.0) };
        let mut batches: Vec<Option<&str>> =
            members.iter().map(|stroke| stroke.row.batch.as_deref()).collect();
        batches.sort_unstable();
        batches.dedup();
        let by_depth = self.depth_exponent(at.alpha_deg, self.friction_deg, &first.row)?;
        let campaign = self.campaign;
        Ok(together(&[
            campaign.instrument.force_gain_sd,
            by_depth * campaign.depth_common_sd_m / at.depth_m,
            self.density_sd_rel / (batches.len() as f64).sqrt(),
            campaign.soil_sd_rel,
        ]))
    }

    /// Relative change of a force with a relative change of the depth: 2 under the soil's weight alone.
    fn depth_exponent(
        &self,
        alpha_deg: f64,
        friction_deg: Option<f64>,
        row: &StrokeRow,
    ) -> Result<f64, EarthPressureError> {
        let at = |depth_m: f64| self.usual_n(alpha_deg, friction_deg, depth_m, row.width_m);
        Ok((at(1.01 * row.depth_m)? / at(row.depth_m)?).ln() / 1.01_f64.ln())
    }

    /// Force in N that a soil of usual strength fails at.
    fn usual_n(
        &self,
        alpha_deg: f64,
        friction_deg: Option<f64>,
        depth_m: f64,
        width_m: f64,
    ) -> Result<f64, EarthPressureError> {
        let loads = &self.request.loads;
        let case = Case {
            tool_angle: Angle::from_degrees(alpha_deg),
            surface_slope: Angle::from_degrees(loads.beta_deg),
            width_ratio: WidthRatio::new(width_m / depth_m)?,
            friction: Angle::from_degrees(USUAL_PHI_DEG),
            interface: Angle::from_degrees(
                friction_deg.unwrap_or(0.5 * USUAL_PHI_DEG).clamp(0.0, USUAL_PHI_DEG),
            ),
        };
        let net = self.by.predict(&case)?.net;
        let slant_m = depth_m / alpha_deg.to_radians().sin();
        let ended = net.weight * self.ended_over_plane(&case)?;
        let weight = 0.5 * USUAL_DENSITY_KG_M3 * loads.gravity_m_s2 * slant_m * ended;
        let others = loads.surcharge_pa * net.surcharge
            + loads.cohesion_pa * net.cohesion
            + loads.adhesion_pa * net.adhesion;
        Ok(slant_m * width_m * (weight + others))
    }

    /// The factor of weight of a plate with ends over that in plane strain, in the nearest case that is covered.
    fn ended_over_plane(&self, case: &Case) -> Result<f64, EarthPressureError> {
        let Some(model) = self.ends else { return Ok(1.0) };
        let range = model.valid_range();
        let alpha_deg = case.tool_angle.degrees().clamp(range.alpha_deg.0, range.alpha_deg.1);
        let delta_deg = case.interface.degrees().clamp(range.delta_deg.0, range.delta_deg.1);
        let slice = model.at(Angle::from_degrees(alpha_deg), Angle::ZERO, case.width_ratio)?;
        let net = slice.net(case.friction.degrees(), delta_deg)?;
        let plane = (net.weight_lower * (net.weight_upper - net.ends_at_most)).sqrt();
        Ok(1.0 + USUAL_END_FACTOR * net.ends_at_most / plane)
    }
}

/// Independent deviations together.
fn together(parts: &[f64]) -> f64 {
    parts.iter().map(|part| part * part).sum::<f64>().sqrt()
}
