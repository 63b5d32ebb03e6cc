//! The error budget as a table.

use soilctl_app::report::ErrorBudget;
use soilctl_app::text::number;
use soilctl_figure::{Align, HtmlReport, Table};

use crate::PageError;

pub(super) fn section(page: &mut HtmlReport, budget: &ErrorBudget) -> Result<(), PageError> {
    page.heading("Error budget");
    page.paragraph(format!(
        "Effect of each source on the force in per cent, by Chen & Liu's model at φ = {:.1}° and δ = {:.1}°. \
         Accuracies of interface friction, depth and density are those of the campaign (or its defaults). Reading a \
         gradual failure early biases forces at large tool angles low by a further 5 to 10 %.",
        budget.phi_deg, budget.delta_deg
    ));
    let columns = std::iter::once(("source".to_owned(), Align::Left))
        .chain(budget.tool_angles_deg.iter().map(|a| (format!("{}°", number(*a)), Align::Right)));
    let mut table = Table::new("Effect on the force (%), by tool angle", columns);
    for source in &budget.sources {
        let effects = source.percent.iter().map(|effect| format!("{effect:.1}"));
        table.row(std::iter::once(source.name.clone()).chain(effects))?;
    }
    page.table(table);
    Ok(())
}
