//! The answer of `diagnose` in words.

use soilctl_app::diagnose::{Answer, NearestAnswer};
use soilctl_app::text::{columns, number};

use crate::output::Words;

/// Most disagreements.
const MOST_PLACES: usize = 8;

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}: {}\n", self.status, self.sentence());
        for effect in &self.effects {
            let parameters: Vec<String> =
                effect.parameters.iter().map(|(name, p)| format!("{name} {}", p.text())).collect();
            text += &format!(
                "  {} (ln Bayes factor {:.1}): {}\n",
                effect.id,
                effect.log_bayes_factor,
                parameters.join(", ")
            );
        }
        for term in &self.empirical {
            text += &format!(
                "  over {} (ln Bayes factor {:.1}): ",
                term.over.join(" and "),
                term.log_bayes_factor
            );
            text += &term.points().iter().map(|point| point.text()).collect::<Vec<_>>().join(", ");
            text += "; in the patch as an empirical term\n";
        }
        if !self.nearest.is_empty() {
            let near = |of: &NearestAnswer| format!("{} ({:.1})", of.id, of.log_bayes_factor);
            text += &format!(
                "  nearest in the catalogue, ln Bayes factor: {}\n",
                self.nearest.iter().map(near).collect::<Vec<_>>().join(", ")
            );
        }
        let mut rows = vec![vec!["gap".to_owned(), "before".into(), "after".into()]];
        let shown = |value: Option<f64>| value.map_or_else(|| "-".into(), |v| format!("{v:.4}"));
        rows.push(vec!["rms of ln force".into(), shown(Some(self.gap.before)), shown(Some(self.gap.after))]);
        rows.push(vec!["held out".into(), shown(self.gap.heldout_before), shown(self.gap.heldout_after)]);
        rows.push(vec![
            "chi2 / n".into(),
            shown(self.gap.chi2_per_n_before),
            shown(self.gap.chi2_per_n_after),
        ]);
        // Columns of the trace that the effects explain.
        for of in self.gap_by_channel.iter().filter(|of| of.channel != "force_n") {
            if of.delta_elpd > 2.0 * of.delta_elpd_se && of.delta_elpd > 1.0 {
                let name = format!("{}, held out (sd)", of.channel);
                rows.push(vec![name, format!("{:.2}", of.before), format!("{:.2}", of.after)]);
            }
        }
        text += &columns(&rows);
        for place in self.located.iter().take(MOST_PLACES) {
            text += &format!(
                "where: {}{} over {} (p {})\n",
                place.channel,
                place.phase.as_ref().map_or_else(String::new, |phase| format!(" ({phase})")),
                place.covariate,
                number(place.p_adjusted)
            );
        }
        if self.located.len() > MOST_PLACES {
            text += &format!("where: and {} more\n", self.located.len() - MOST_PLACES);
        }
        for disagreement in &self.disagreements {
            text += &format!("note: {disagreement}\n");
        }
        if let Some(beyond) = &self.beyond_known {
            text += &format!("note: {beyond}\n");
        }
        if let Some(sentence) = self.resimulation() {
            text += &format!("note: {sentence}\n");
        }
        if let Some(next) = &self.next_experiment {
            text += &format!("next: {} (power {:.2}; {})\n", next.text, next.power, next.design_csv);
            if let Some(plan) = &next.plan {
                text += &format!("next: {plan} is a plan of it, after the strokes that were made\n");
            } else if let Some(why) = &next.no_plan_because {
                text += &format!("next: no plan of it: {why}\n");
            }
        }
        text += &format!("patch: {}\n", self.patch);
        if let Some(twin) = &self.twin {
            text +=
                &format!("twin: {twin} is the same for `simulate`, with the soil that all signals ask for\n");
        }
        if let Some(report) = &self.report {
            text += &format!("report: {report}\n");
        }
        text
    }
}
