//! Direct shear beside the estimate, as a table and a figure.

use soilctl_app::report::ShearComparison;
use soilctl_figure::{Align, Axis, CalloutKind, Figure, HtmlReport, Legend, Marker, Points, Size, Table};

use crate::PageError;

pub(super) fn section(page: &mut HtmlReport, found: Option<&ShearComparison>) -> Result<(), PageError> {
    let Some(found) = found else {
        page.heading("Direct shear");
        page.paragraph("There is no consistent soil to compare direct shear with.");
        return Ok(());
    };
    page.heading("Direct shear");
    page.paragraph(format!(
        "Friction angles of the power law ln φ = ln {:.3}° {:+.4} ln(σ/psi) at the stresses of the strokes, which lie \
         between σ_L (far from the plate) and σ_U (beside it).",
        found.fit.friction_at_1_psi_deg, found.fit.exponent
    ));
    let columns = ["point at depth", "from (deg)", "to (deg)", "estimate from", "to", "verdict"]
        .map(|c| (c, Align::Right));
    let mut table = Table::new("Friction angle by direct shear and by this estimate", columns);
    let phi = found.estimate_deg;
    let mut bars = vec![("estimate".to_owned(), phi[0], phi[1])];
    for range in &found.ranges {
        let [low, high] = range.friction_deg;
        table.row([
            format!("{} of the plate", range.fraction),
            format!("{low:.1}"),
            format!("{high:.1}"),
            format!("{:.1}", phi[0]),
            format!("{:.1}", phi[1]),
            if range.overlaps { "overlap" } else { "apart" }.to_owned(),
        ])?;
        bars.push((format!("direct shear, {} depth", range.fraction), low, high));
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
    if let Some(lowest_pa) = found.extrapolated_below_pa {
        page.callout(
            CalloutKind::Warning,
            "Extrapolated",
            format!(
                "The strokes' stresses reach outside the tested ones ({:.0} Pa at least), so direct shear is \
                 extrapolated there; the true curve levels off at small stresses.",
                lowest_pa
            ),
        );
    }
    Ok(())
}
