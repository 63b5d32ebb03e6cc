//! What the page of a problem tells.

use std::path::Path;

use soilctl_figure::{Align, Table};

use super::SolveAnswer;
use crate::error::CliError;
use crate::text::{number, number_or_dash, rounded_down, rounded_up, sentence_case};
use crate::verbs::limits::{Told, bounds_table, level_page_table, proven};

impl SolveAnswer {
    pub(super) fn told(&self, file: &Path, max_gap: f64) -> Result<Told, CliError> {
        let what = sentence_case(self.words());
        let mut bounds = bounds_table();
        bounds.row([what.clone(), number(self.lower), number(self.upper)])?;
        let (kind, text) = proven(self.gap, max_gap, self.ended);
        let short = what.split(" (").next().unwrap_or(&what).split(',').next().unwrap_or(&what).to_owned();
        let unit = if self.quantity == "force_kn_per_m" { " kN/m" } else { "" };
        let title =
            format!("{short}: between {} and {}{unit}", rounded_down(self.lower), rounded_up(self.upper));
        let name = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        Ok(Told {
            kind: "Bounds on a collapse load",
            subtitle: format!("{name}: {}", self.words()),
            verdict: (kind, title, text),
            bounds,
            given: Vec::new(),
            steps: if self.trials.is_empty() {
                level_page_table(&self.levels)?
            } else {
                Some(self.trial_table()?)
            },
        })
    }

    fn trial_table(&self) -> Result<Table, CliError> {
        let columns = ["strength divided by", "bears at least", "bears at most"].map(|c| (c, Align::Right));
        let mut table =
            Table::new("Factors that were tried, and what the soil then bears of all that acts", columns);
        for trial in &self.trials {
            table.row([
                number(trial.factor),
                number_or_dash(trial.borne_lower),
                number_or_dash(trial.borne_upper),
            ])?;
        }
        Ok(table)
    }
}
