//! What the strokes say together: interface friction, depth law, statistics of the campaign, comparison with a model.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use soilctl_earth_pressure::{Case, ForceModel, plane_model};
use soilctl_process::log::read_wrenches;
use soilctl_process::table::StrokeRecord;
use soilctl_process::{
    CampaignStroke, DepthPoint, SweepStroke, campaign_statistics, depth_law, interface_friction,
    meant_angles_deg, rubbing_peak,
};
use soilctl_strokes::Campaign;

use super::findings::{Analysis, Comparison, Effect, Friction, Group, Law, Lift, Rubbing};
use super::inputs::Inputs;
use super::request::AnalysisRequest;
use crate::AppError;

/// Depths that differ by less than this share of their mean are one depth.
const SAME_DEPTH: f64 = 0.1;
/// Rubbing counts while the plate is pressed with at least this force in N.
const RUBBING_N: f64 = 1.0;

/// Everything that the strokes allow.
pub(super) fn analyse(
    request: &AnalysisRequest,
    strokes: &[StrokeRecord],
    campaign: &Campaign,
    rubbing: Option<Rubbing>,
) -> Result<Analysis, AppError> {
    let mut analysis = Analysis { slant_m: request.slant_m, rubbing, ..Analysis::default() };
    match sweep(strokes) {
        Ok(friction) => analysis.friction = Some(friction),
        Err(reason) => analysis.no_friction = Some(reason),
    }
    if strokes.is_empty() {
        return Ok(analysis);
    }
    analysis.depth_laws = depth_laws(strokes, campaign)?;
    statistics(request, strokes, &mut analysis)?;
    if let Some(density_kg_m3) = request.density_kg_m3 {
        compare(request, density_kg_m3, strokes, &mut analysis)?;
    }
    Ok(analysis)
}

fn sweep(strokes: &[StrokeRecord]) -> Result<Friction, String> {
    let (mut used, mut names, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    for stroke in strokes {
        match (stroke.row.delta_set_deg, stroke.failure.lift_deg, stroke.failure.lift_sd_deg) {
            (Some(set_deg), Some(lift_deg), Some(lift_sd_deg)) => {
                used.push(SweepStroke { alpha_deg: stroke.row.alpha_deg, set_deg, lift_deg, lift_sd_deg });
                names.push(stroke.name());
            }
            _ => left_out.push(stroke.name().to_owned()),
        }
    }
    let found = interface_friction(&used).map_err(|problem| problem.to_string())?;
    left_out.extend(found.left_out.iter().map(|place| names[*place].to_owned()));
    let mut significance = found.significance.iter();
    let lifts = used.iter().zip(&names).enumerate().filter(|(i, _)| !found.left_out.contains(i));
    let strokes = lifts.map(|(_, (stroke, name))| Lift {
        stroke_id: (*name).to_owned(),
        set_deg: stroke.set_deg,
        lift_deg: stroke.lift_deg,
        lift_sd_deg: stroke.lift_sd_deg,
        significance: significance.next().copied().unwrap_or_default(),
    });
    Ok(Friction {
        delta_deg: found.delta_deg,
        sd_deg: found.sd_deg,
        above_deg: found.above_deg,
        below_deg: found.below_deg,
        lift_per_deg: found.lift_per_deg,
        strokes: strokes.collect(),
        left_out,
    })
}

/// The tool angle that each stroke was meant to have.
fn meant_deg(strokes: &[StrokeRecord]) -> Vec<f64> {
    meant_angles_deg(&strokes.iter().map(|s| s.row.alpha_deg).collect::<Vec<_>>())
}

fn depth_laws(strokes: &[StrokeRecord], campaign: &Campaign) -> Result<Vec<Law>, AppError> {
    let mut laws = Vec::new();
    let meant = meant_deg(strokes);
    let mut angles = meant.clone();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    for alpha_deg in angles {
        let points: Vec<DepthPoint> = strokes
            .iter()
            .zip(&meant)
            .filter(|(_, meant)| **meant == alpha_deg)
            .map(|(s, _)| DepthPoint { depth_m: s.row.depth_m, force_n: s.row.force_n })
            .collect();
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(low, high), p| (low.min(p.depth_m), high.max(p.depth_m)));
        if points.len() < 3 || high - low < SAME_DEPTH * 0.5 * (high + low) {
            continue;
        }
        let law = depth_law(&points, campaign.depth_sd_m)?;
        laws.push(Law {
            alpha_deg,
            strokes: points.len(),
            exponent: law.exponent,
            exponent_95: law.exponent_95,
            quadratic_n_per_m2: law.quadratic_n_per_m2,
            agrees_with_square: law.agrees_with_square,
        });
    }
    Ok(laws)
}

fn statistics(
    request: &AnalysisRequest,
    strokes: &[StrokeRecord],
    analysis: &mut Analysis,
) -> Result<(), AppError> {
    let rows: Vec<CampaignStroke> = strokes
        .iter()
        .zip(meant_deg(strokes))
        .map(|(s, alpha_deg)| CampaignStroke {
            alpha_deg,
            depth_m: s.row.depth_m,
            force_n: s.row.force_n,
            radius_m: s.row.radius_m,
            base_deg: s.row.base_deg,
        })
        .collect();
    let found = campaign_statistics(&rows, request.slant_m)?;
    analysis.groups = found
        .groups
        .iter()
        .map(|group| Group {
            alpha_deg: group.alpha_deg,
            strokes: group.strokes.len(),
            mean_n: group.kept_mean_n,
            sd_n: group.kept_sd_n,
            coefficient_of_variation: group.coefficient_of_variation(),
            outliers: group.outliers.iter().map(|place| strokes[*place].name().to_owned()).collect(),
            model_n: None,
            model_difference: None,
            matched_phi_deg: None,
        })
        .collect();
    let effect = |found: &Option<soilctl_process::Dependence>, unit: &str| {
        found.as_ref().filter(|d| d.effect_se.is_finite() && d.effect_rel.is_finite()).map(|d| Effect {
            effect_rel: d.effect_rel,
            effect_se: d.effect_se,
            p: d.p,
            range: d.range,
            verdict: format!(
                "forces change by {:+.1} ± {:.1} % from {:.3} to {:.3} {unit}, p = {:.3}: {}",
                d.effect_rel * 100.0,
                d.effect_se * 100.0,
                d.range[0],
                d.range[1],
                d.p,
                if d.is_significant() { "significant" } else { "not significant" }
            ),
        })
    };
    analysis.radius = effect(&found.radius, "m");
    analysis.base_angle = effect(&found.base, "deg");
    Ok(())
}

fn compare(
    request: &AnalysisRequest,
    density_kg_m3: f64,
    strokes: &[StrokeRecord],
    analysis: &mut Analysis,
) -> Result<(), AppError> {
    let set: Vec<f64> = strokes.iter().filter_map(|s| s.row.delta_set_deg).collect();
    let mean_set = (!set.is_empty()).then(|| set.iter().sum::<f64>() / set.len() as f64);
    let delta_deg = request
        .delta_deg
        .or(analysis.friction.as_ref().map(|f| f.delta_deg))
        .or(mean_set)
        .ok_or_else(|| {
            AppError::Request("--delta is missing: the strokes have neither a sweep nor set-points".into())
        })?;
    let model = plane_model(&request.model)?;
    let width_m = strokes.iter().map(|s| s.row.width_m).sum::<f64>() / strokes.len() as f64;
    let scale = 0.5 * density_kg_m3 * request.gravity_m_s2 * request.slant_m * request.slant_m * width_m;
    for group in &mut analysis.groups {
        let force =
            |phi_deg: f64| force(model.as_ref(), group.alpha_deg, phi_deg, delta_deg).map(|k| k * scale);
        if let Some(phi_deg) = request.phi_deg {
            let model_n = force(phi_deg)?;
            group.model_n = Some(model_n);
            group.model_difference = Some(group.mean_n / model_n - 1.0);
        }
        group.matched_phi_deg = matched(model.as_ref(), &force, delta_deg, group.mean_n);
    }
    let model = request.model.clone();
    analysis.comparison = Some(Comparison { model, density_kg_m3, delta_deg, phi_deg: request.phi_deg });
    Ok(())
}

/// Net coefficient per slant length, in the middle of a bracket.
fn force(model: &dyn ForceModel, alpha_deg: f64, phi_deg: f64, delta_deg: f64) -> Result<f64, AppError> {
    let found = model.predict(&Case::level_deg(alpha_deg, phi_deg, delta_deg))?;
    Ok((found.net_lower.0 * found.net_upper.0).sqrt())
}

/// Friction angle at which the model's force, which grows with it, is `wanted_n`.
fn matched(
    model: &dyn ForceModel,
    force: &dyn Fn(f64) -> Result<f64, AppError>,
    delta_deg: f64,
    wanted_n: f64,
) -> Option<f64> {
    let (low, high) = model.valid_range().phi_deg;
    let (mut low, mut high) = (low.max(delta_deg), high);
    if !(force(low).ok()? <= wanted_n && wanted_n <= force(high).ok()?) {
        return None;
    }
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if force(middle).ok()? < wanted_n { low = middle } else { high = middle }
    }
    Some(f64::midpoint(low, high))
}

/// Rubbing logs: peaks of the friction angle while the plate is pressed.
pub(super) fn rubbing(logs: &[PathBuf], inputs: &Inputs) -> Result<Option<Rubbing>, AppError> {
    if logs.is_empty() {
        return Ok(None);
    }
    let (mut t_s, mut angle_deg, mut normal_n) = (Vec::new(), Vec::new(), Vec::new());
    let never = AtomicBool::new(false);
    for path in logs {
        // One after the other on one clock, a second apart.
        let from: f64 = t_s.last().map_or(0.0, |t: &f64| t + 1.0);
        for contact in read_wrenches(path, &inputs.settings, &never)? {
            t_s.push(from + contact.t_s);
            angle_deg.push(contact.tangent_n.atan2(contact.normal_n.abs()).to_degrees());
            normal_n.push(contact.normal_n.abs());
        }
    }
    let found = rubbing_peak(&t_s, &angle_deg, &normal_n, RUBBING_N)?;
    let every = t_s.len().div_ceil(4000).max(1);
    let course = (0..t_s.len()).step_by(every).filter(|i| normal_n[*i] >= RUBBING_N);
    Ok(Some(Rubbing {
        peak_deg: found.peak_deg,
        range_deg: found.range_deg,
        peaks: found.peaks,
        course: course.map(|i| (t_s[i], angle_deg[i])).collect(),
    }))
}
