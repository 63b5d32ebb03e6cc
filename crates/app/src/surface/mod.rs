//! Where the ground breaks ahead of the plate, as a measurement of its friction angle beside that by force.

mod answer;
mod extent;
mod request;
mod words;

use soilctl_soil::{Angle, Plate};
use soilctl_stats::normal_quantile;
use soilctl_strokes::ReadOptions;

pub use answer::{Agreement, Answer, ByForce, Said, Stroke};
use extent::Measured;
pub use extent::Surface;
pub use request::Request;

use crate::estimate::{self, Estimation};
use crate::text::number;
use crate::{AppError, Watch, request as requests};

/// Holds measured break distances against what models say, and what they leave of the friction angle against what forces leave.
///
/// # Errors
/// [`AppError`] if the request or the table makes no sense, no stroke has a break distance, or a file cannot be read.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    requests::check(request)?;
    let found = estimate::run(&request.estimate.request(&request.file), watch)?;
    let (measured, not_measured, deviations) = measured(request)?;
    let delta = found.inputs.delta_deg;
    let force = ByForce::of(&found);
    let said: Vec<Said> = Surface::ALL.iter().map(|surface| said(*surface, &measured, &found)).collect();
    // Where forces leave nothing, distances are predicted for what the surface itself leaves.
    let of = |surface: &Said| found.answer.phi_deg.or(surface.phi_deg);
    let strokes = measured.iter().map(|one| Stroke {
        line: one.line,
        label: one.label.clone(),
        distance_m: one.distance_m,
        sd_m: one.sd_m,
        predicted_m: said
            .iter()
            .map(|s| {
                of(s)
                    .map(|phi| s.surface.range_m(&one.plate, phi, delta))
                    .filter(|range| range[1].is_finite())
            })
            .collect(),
    });
    let mut answer = Answer {
        confidence: request.estimate.is_statistical().then_some(request.estimate.confidence),
        deviations,
        delta_deg: [delta.0, delta.1],
        force,
        strokes: strokes.collect(),
        not_measured,
        models: said,
        verdict: String::new(),
        warnings: Vec::new(),
    };
    answer.verdict = words::verdict(&answer);
    answer.warnings = words::warnings(&answer, &found);
    Ok(answer)
}

/// Strokes with a break distance, how many have none, and how many deviations a band reaches.
fn measured(request: &Request) -> Result<(Vec<Measured>, usize, f64), AppError> {
    let table = request.file.strokes(ReadOptions::default())?;
    let rows: Vec<_> = table.rows().filter_map(|row| Some((row.break_distance_m?, row))).collect();
    if rows.is_empty() {
        return Err(AppError::Request(format!(
            "{} has no break_distance_m, the distance from the plate's face to where the ground broke; measure it along the surface, in m",
            table.name()
        )));
    }
    let deviations = if request.estimate.is_statistical() {
        // All of them together, by Šidák.
        let each = libm::pow(request.estimate.confidence, 1.0 / rows.len() as f64);
        normal_quantile(0.5 * (1.0 - each))
    } else {
        1.0
    };
    let not_measured = table.len() - rows.len();
    let measured = rows.into_iter().map(|(distance_m, row)| {
        let sd_m = row.break_distance_sd_m.or(request.break_sd_m).ok_or_else(|| {
            AppError::Request(format!(
                "{}, line {}: break_distance_m has no break_distance_sd_m; fill it, or give --break-sd, such as 0.003",
                table.name(),
                row.line
            ))
        })?;
        // At failure the plate stands as it was turned by then.
        let alpha_deg = row.alpha_deg + row.turned_deg.unwrap_or(0.0);
        let slope = Angle::from_degrees(request.estimate.loads.beta_deg);
        let plate = Plate::new(Angle::from_degrees(alpha_deg), slope, row.depth_m, row.width_m)?;
        let name = row.stroke_id.clone().unwrap_or_else(|| format!("line {}", row.line));
        Ok(Measured {
            line: row.line,
            label: format!("{name}: {} deg, {} mm", number(row.alpha_deg), number(1e3 * row.depth_m)),
            plate,
            distance_m,
            sd_m,
            band_m: [distance_m - deviations * sd_m, distance_m + deviations * sd_m],
        })
    });
    Ok((measured.collect::<Result<_, AppError>>()?, not_measured, deviations))
}

/// What a model says of the friction angle, and whether forces agree.
fn said(surface: Surface, measured: &[Measured], found: &Estimation) -> Said {
    let phi_deg = surface.friction_deg(measured, found.inputs.delta_deg);
    let both = |by_force: [f64; 2], by_surface: [f64; 2]| {
        let both = [by_force[0].max(by_surface[0]), by_force[1].min(by_surface[1])];
        (both[0] <= both[1]).then_some(both)
    };
    let (agreement, phi_both_deg) = match (found.answer.phi_deg, phi_deg) {
        (_, None) => (Agreement::NoFriction, None),
        (None, Some(_)) => (Agreement::NoForce, None),
        (Some(by_force), Some(by_surface)) => match both(by_force, by_surface) {
            Some(both) => (Agreement::Agrees, Some(both)),
            None if by_surface[1] < by_force[0] => (Agreement::Nearer, None),
            None => (Agreement::Farther, None),
        },
    };
    let density_both_kg_m3 = phi_both_deg.and_then(|phi| answer::densities(&found.answer.region, phi));
    Said { surface, phi_deg, agreement, phi_both_deg, density_both_kg_m3 }
}
