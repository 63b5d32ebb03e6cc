//! Comparison with direct shear at the stresses of the strokes (Hong 2001, Table 7.3 and figure 7-12).

use std::path::Path;

use soilctl_direct_shear::{
    LogLogFit, PointDepth, ShearSeries, StrokeFriction, StrokeLoad, friction_at_stroke, read_shear_points,
};
use soilctl_figure::{Align, Axis, CalloutKind, Figure, HtmlReport, Legend, Marker, Points, Size, Table};
use soilctl_soil::{Angle, Stroke};

use super::Args;
use crate::error::CliError;
use crate::verbs::estimate::work::Work;

/// Depths of the points considered, as fractions of the plate's depth.
const FRACTIONS: [(f64, &str); 2] = [(0.5, "1/2"), (2.0 / 3.0, "2/3")];

pub(super) fn section(page: &mut HtmlReport, args: &Args, file: &Path, work: &Work) -> Result<(), CliError> {
    let series = chosen(args, file)?;
    let fit = LogLogFit::fit(&series.points)?;
    let (Some(phi), Some(centre)) = (work.answer.phi_deg, work.answer.centre) else {
        page.heading("Direct shear");
        page.paragraph("There is no consistent soil to compare direct shear with.");
        return Ok(());
    };
    let setup = work.setup(&args.estimate)?;
    let delta = Angle::from_degrees(f64::midpoint(setup.delta_deg.0, setup.delta_deg.1));
    let unit_weight = centre.density_kg_m3 * setup.gravity_m_s2;
    let at = |fraction: f64| -> Result<Vec<StrokeFriction>, CliError> {
        setup
            .observations
            .iter()
            .map(|o| {
                let stroke = Stroke::new(*o.plate(), o.force_n())?;
                let load =
                    StrokeLoad::new(&stroke, unit_weight, delta, PointDepth::FractionOfPlate(fraction))?;
                Ok(friction_at_stroke(&fit, &load, Angle::from_degrees(centre.phi_deg))?)
            })
            .collect()
    };
    page.heading("Direct shear");
    page.paragraph(format!(
        "Friction angles of the power law ln φ = ln {:.3}° {:+.4} ln(σ/psi) at the stresses of the strokes, which lie \
         between σ_L (far from the plate) and σ_U (beside it).",
        fit.friction_at_1_psi_deg, fit.exponent
    ));
    let columns = ["point at depth", "from (deg)", "to (deg)", "estimate from", "to", "verdict"]
        .map(|c| (c, Align::Right));
    let mut table = Table::new("Friction angle by direct shear and by this estimate", columns);
    let mut bars = vec![("estimate".to_owned(), phi[0], phi[1])];
    let mut extrapolated = false;
    for (fraction, name) in FRACTIONS {
        let found = at(fraction)?;
        let low = found.iter().map(|f| f.lowest_friction.degrees()).fold(f64::MAX, f64::min);
        let high = found.iter().map(|f| f.highest_friction.degrees()).fold(f64::MIN, f64::max);
        extrapolated |= found.iter().any(|f| f.low_extrapolated || f.high_extrapolated);
        let verdict = if low <= phi[1] && phi[0] <= high { "overlap" } else { "apart" };
        table.row([
            format!("{name} of the plate"),
            format!("{low:.1}"),
            format!("{high:.1}"),
            format!("{:.1}", phi[0]),
            format!("{:.1}", phi[1]),
            verdict.to_owned(),
        ])?;
        bars.push((format!("direct shear, {name} depth"), low, high));
    }
    page.table(table);
    let mut figure = Figure::new(
        "Friction angle, estimate and direct shear",
        Axis::linear("").range(-0.5, 2.5)?,
        Axis::linear("Friction angle φ (deg)"),
    )
    .with_legend(Legend::Below);
    for (i, (name, low, high)) in bars.into_iter().enumerate() {
        let middle = f64::midpoint(low, high);
        let label = format!("{low:.1} to {high:.1}°");
        let marker = [Marker::Diamond, Marker::Circle, Marker::Square][i % 3];
        figure.push(
            Points::new(name, vec![(i as f64, middle)])
                .y_error(vec![(middle - low, high - middle)])
                .marker(marker)
                .labels([label]),
        )?;
    }
    page.figure(&figure, Size::new(620, 420)?, "Ranges of the friction angle.")?;
    if extrapolated {
        page.callout(
            CalloutKind::Warning,
            "Extrapolated",
            format!(
                "The strokes' stresses reach outside the tested ones ({:.0} Pa at least), so direct shear is \
                 extrapolated there; the true curve levels off at small stresses.",
                series.points.iter().map(|p| p.normal_stress_pa()).fold(f64::MAX, f64::min)
            ),
        );
    }
    Ok(())
}

fn chosen(args: &Args, file: &Path) -> Result<ShearSeries, CliError> {
    let series = read_shear_points(file)?;
    let names: Vec<String> = series.iter().filter_map(|s| s.soil.clone()).collect();
    let found = match &args.soil {
        None if series.len() == 1 => series.into_iter().next(),
        None => None,
        Some(name) => series.into_iter().find(|s| s.soil.as_ref() == Some(name)),
    };
    found.ok_or_else(|| {
        CliError::Usage(format!(
            "{} holds the soils {}; choose one of them with --soil",
            file.display(),
            names.join(", ")
        ))
    })
}
