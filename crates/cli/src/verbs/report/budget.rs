//! The error budget: what each source of error does to a force (Hong 2001, section 6.7.4).

use soilctl_earth_pressure::{Case, ChenLiu, EarthPressureError, Input, sensitivity_percent};
use soilctl_figure::{Align, HtmlReport, Table};
use soilctl_soil::Angle;

use super::Args;
use crate::error::CliError;
use crate::verbs::estimate::work::Work;

/// Accuracy of a plate's angle, of the ground's level (deg) and of a force sensor in the range of these forces.
const TOOL_ANGLE_DEG: f64 = 1.0;
const SURFACE_DEG: f64 = 1.0;
const FORCE_SENSOR: f64 = 0.01;

pub(super) fn section(page: &mut HtmlReport, args: &Args, work: &Work) -> Result<(), CliError> {
    let phi = match (&work.answer.best_estimate, work.answer.phi_deg) {
        (Some(best), _) => best.phi_deg,
        _ => 40.0,
    };
    let delta = f64::midpoint(work.inputs.delta_deg.0, work.inputs.delta_deg.1).min(phi - 2.0).max(0.0);
    let campaign = &work.inputs.campaign;
    let mut angles: Vec<f64> = work.answer.measurements.iter().map(|m| m.alpha_deg).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    angles.truncate(6);
    let angular = [
        (
            format!("interface friction ± {:.1}°", campaign.delta_sd_deg),
            Input::Interface,
            campaign.delta_sd_deg,
        ),
        (format!("tool angle ± {TOOL_ANGLE_DEG:.1}°"), Input::ToolAngle, TOOL_ANGLE_DEG),
        (format!("surface slope ± {SURFACE_DEG:.1}°"), Input::SurfaceSlope, SURFACE_DEG),
    ];
    let mut rows: Vec<(String, Vec<f64>)> = Vec::new();
    for (name, input, step) in angular {
        let effects = angles.iter().map(|&alpha| {
            let base = Case::from_deg(alpha, args.estimate.loads.beta, phi, delta);
            sensitivity_percent(&ChenLiu, &base, input, Angle::from_degrees(step))
        });
        match effects.collect::<Result<Vec<_>, EarthPressureError>>() {
            Ok(effects) => rows.push((name, effects)),
            // Beyond the closed form's range there is nothing to say about this source.
            Err(_) => continue,
        }
    }
    let depth_at = |alpha: f64| {
        let m = work.answer.measurements.iter().find(|m| m.alpha_deg == alpha);
        m.map_or(f64::INFINITY, |m| m.depth_m)
    };
    let depth = angles.iter().map(|&a| 200.0 * campaign.depth_sd_m / depth_at(a)).collect();
    rows.push((format!("depth ± {:.2} mm", 1e3 * campaign.depth_sd_m), depth));
    let density = 100.0 * campaign.density_sd_rel;
    rows.push((format!("density ± {density:.1} %"), vec![density; angles.len()]));
    rows.push((
        format!("force sensor ± {:.0} %", 100.0 * FORCE_SENSOR),
        vec![100.0 * FORCE_SENSOR; angles.len()],
    ));
    let combined =
        (0..angles.len()).map(|i| rows.iter().map(|(_, e)| e[i] * e[i]).sum::<f64>().sqrt()).collect();
    rows.push(("all, independent".into(), combined));
    let observed = angles
        .iter()
        .map(|&alpha| {
            let m = work.answer.measurements.iter().find(|m| m.alpha_deg == alpha);
            m.map_or(0.0, |m| 50.0 * (m.force_high_n - m.force_low_n) / m.force_n)
        })
        .collect();
    rows.push(("half width of the band used".into(), observed));

    page.heading("Error budget");
    page.paragraph(format!(
        "Effect of each source on the force in per cent, by Chen & Liu's model at φ = {phi:.1}° and δ = {delta:.1}°. \
         Accuracies of interface friction, depth and density are those of the campaign (or its defaults). Reading a \
         gradual failure early biases forces at large tool angles low by a further 5 to 10 %."
    ));
    let columns = std::iter::once(("source".to_owned(), Align::Left))
        .chain(angles.iter().map(|a| (format!("{}°", crate::text::number(*a)), Align::Right)));
    let mut table = Table::new("Effect on the force (%), by tool angle", columns);
    for (name, effects) in rows {
        table.row(std::iter::once(name).chain(effects.iter().map(|e| format!("{e:.1}"))))?;
    }
    page.table(table);
    Ok(())
}
