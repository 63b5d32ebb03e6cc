//! The page of a problem, and the drawing of its file.

mod calculation;
mod given;

use std::path::Path;

use soilctl_app::solve::check::Checked;
use soilctl_app::solve::{Asked, Solved, TrialAnswer};
use soilctl_app::text::{number, number_or_dash, rounded_down, rounded_up, sentence_case};
use soilctl_figure::{Align, Figure, HtmlReport, Size, Table};

use crate::PageError;
use crate::limits::{self, PageContent, bounds_table, level_table, proven};
use crate::problem::Scene;
pub use crate::problem::{Understood, UnderstoodLoad, UnderstoodSide};

/// A problem file as it was understood: soils, water, supports, structures, and what acts; and the size at which it is legible.
///
/// # Errors
/// [`PageError`] if it cannot be drawn.
pub fn drawing(Checked { description, described, .. }: &Checked) -> Result<(Figure, Size), PageError> {
    Scene::of_file(description, described).figure()
}

/// The facts of that drawing as data, for a page that draws them itself.
#[must_use]
pub fn understood(Checked { description, described, .. }: &Checked) -> Understood {
    Scene::of_file(description, described).understood()
}

/// The page of bounds on what a problem file asks for: on paper, the calculation that an engineer keeps.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(found: &Solved, file: &Path) -> Result<HtmlReport, PageError> {
    let scene = Scene::of_file(&found.description, &found.described);
    let mut page = limits::page(&found.fields, &scene, content(found, file)?, &found.answer.results)?;
    calculation::add(&mut page, found, file)?;
    Ok(page)
}

fn content(found: &Solved, file: &Path) -> Result<PageContent, PageError> {
    let answer = &found.answer;
    let what = sentence_case(answer.quantity.words());
    let mut bounds = bounds_table();
    let least = if answer.cases.is_empty() { what.clone() } else { format!("{what}, least of all cases") };
    bounds.row([least, number(answer.lower), number(answer.upper)])?;
    for case in &answer.cases {
        bounds.row([case.name.clone(), number_or_dash(case.lower), number_or_dash(case.upper)])?;
    }
    let (kind, text) = proven(answer.gap, answer.max_gap, answer.ended);
    let short = what.split(" (").next().unwrap_or(&what).split(',').next().unwrap_or(&what).to_owned();
    let unit = if answer.quantity == Asked::ForceKnPerM { " kN/m" } else { "" };
    let title =
        format!("{short}: between {} and {}{unit}", rounded_down(answer.lower), rounded_up(answer.upper));
    let name = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Ok(PageContent {
        kind: "Bounds on a collapse load",
        subtitle: match &answer.governing {
            Some(case) => format!("{name}: {}; figures of {case}", answer.quantity.words()),
            None => format!("{name}: {}", answer.quantity.words()),
        },
        verdict: (kind, title, text),
        bounds,
        inputs: given::tables(found)?,
        given: Vec::new(),
        steps: if answer.trials.is_empty() {
            level_table(&answer.levels)?
        } else {
            Some(trial_table(&answer.trials)?)
        },
    })
}

fn trial_table(trials: &[TrialAnswer]) -> Result<Table, PageError> {
    let columns = ["strength divided by", "bears at least", "bears at most"].map(|c| (c, Align::Right));
    let mut table =
        Table::new("Factors that were tried, and what the soil then bears of all that acts", columns);
    for trial in trials {
        table.row([
            number(trial.factor),
            number_or_dash(trial.borne_lower),
            number_or_dash(trial.borne_upper),
        ])?;
    }
    Ok(table)
}
