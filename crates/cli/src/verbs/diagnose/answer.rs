//! What `diagnose` answers, in data and in words.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_diagnosis::{Phase, Testable};
use soilctl_effects::EffectId;

use super::Work;
use super::files::{Written, parameters, status};
use crate::output::Words;
use crate::text::{columns, measured, number};

/// Most disagreements in the answer in words.
const MOST_PLACES: usize = 8;

/// Where model and measurement disagree, which effect is missing, and the gap after it is added.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DiagnosisAnswer {
    /// none, named, ambiguous, provisional, unknown or not_testable; only `named` is firm.
    pub(super) status: String,
    /// Effects of the best explanation, best first; empty unless named, ambiguous or provisional.
    pub(super) effects: Vec<EffectAnswer>,
    /// What the data do not tell apart, best first; ids of effects, or `unknown:<covariate>`.
    pub(super) equivalence_set: Vec<String>,
    /// How far model and measurement are apart.
    pub(super) gap: GapAnswer,
    /// The gap of forces and of each column, on batches that were left out, forces first; empty with fewer than two batches.
    /// `gap.csv` has it along each condition.
    pub(super) gap_by_channel: Vec<ChannelGapAnswer>,
    /// Disagreements of the recalibrated baseline that are more than chance.
    #[serde(rename = "where")]
    pub(super) located: Vec<WhereAnswer>,
    /// The follow-up that would tell most; null if nothing on the menu would.
    pub(super) next_experiment: Option<NextAnswer>,
    /// Model file for `--model-file`.
    pub(super) patch: String,
    /// HTML page.
    pub(super) report: String,
    /// The force model without effects.
    pub(super) model: String,
    /// The model file that the campaign was held against; null without one.
    pub(super) model_file: Option<String>,
    /// Effects of that file, which were taken as known; `patch` has them before those that were found.
    pub(super) known_effects: Vec<String>,
    /// Strokes.
    pub(super) strokes: usize,
    /// Strokes whose trace was used.
    pub(super) traces: usize,
    /// Recalibrated friction angle with the effects, deg.
    pub(super) phi_deg: f64,
    /// Recalibrated density with the effects, kg/m3.
    pub(super) density_kg_m3: f64,
    /// Scatter of ln force of one stroke about the baseline.
    pub(super) scatter: f64,
    /// What the design could show of each effect, before the forces were looked at.
    pub(super) testability: Vec<TestabilityAnswer>,
}

/// One effect.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EffectAnswer {
    /// Id in the catalogue.
    #[schemars(with = "String")]
    pub(super) id: EffectId,
    /// Parameters by name.
    pub(super) parameters: BTreeMap<String, ParameterAnswer>,
    /// ln Bayes factor over the explanation without it.
    pub(super) log_bayes_factor: f64,
}

/// A parameter.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ParameterAnswer {
    /// Value; for a choice among force models, its index.
    pub(super) value: f64,
    /// Standard deviation.
    pub(super) sd: f64,
    /// Unit, `1` for a number without.
    pub(super) unit: String,
}

impl ParameterAnswer {
    /// With as many digits as it is known to.
    pub(super) fn text(&self) -> String {
        measured(self.value, self.sd, &self.unit)
    }
}

/// Root mean squares of ln force; chi-square and log density are of batches that were left out.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct GapAnswer {
    /// Without effects.
    pub(super) before: f64,
    /// With effects.
    pub(super) after: f64,
    /// Without effects, each batch predicted from the others; null with fewer than two batches.
    pub(super) heldout_before: Option<f64>,
    /// With effects, each batch predicted from the others.
    pub(super) heldout_after: Option<f64>,
    /// chi-square a stroke without effects.
    pub(super) chi2_per_n_before: Option<f64>,
    /// chi-square a stroke with effects.
    pub(super) chi2_per_n_after: Option<f64>,
    /// Gain in expected log predictive density.
    pub(super) delta_elpd: Option<f64>,
    /// Its standard error.
    pub(super) delta_elpd_se: Option<f64>,
}

/// The gap of a column, in standard deviations of the prediction with effects.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct ChannelGapAnswer {
    /// Column of the stroke table, or of the traces.
    pub(super) channel: String,
    /// Readings.
    pub(super) readings: usize,
    /// Normalised root mean square without effects; the square is chi-square a reading.
    pub(super) before: f64,
    /// The same with effects.
    pub(super) after: f64,
    /// Gain in log predictive density, summed over readings.
    pub(super) delta_elpd: f64,
    /// Its standard error.
    pub(super) delta_elpd_se: f64,
}

/// One disagreement.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct WhereAnswer {
    /// Column of the stroke table, or of the traces.
    pub(super) channel: String,
    /// Phase of the stroke, for readings of traces: loading or after; null for the column itself.
    pub(super) phase: Option<String>,
    /// Covariate; `all` if all strokes are off what a simulated arm reads.
    pub(super) covariate: String,
    /// Probability of as much by chance, adjusted for the number of tests.
    pub(super) p_adjusted: f64,
}

/// The next experiment.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct NextAnswer {
    /// What to do and why.
    pub(super) text: String,
    /// File with the strokes to make.
    pub(super) design_csv: String,
    /// Chance that it settles the question.
    pub(super) power: f64,
}

/// What the design could show of an effect.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct TestabilityAnswer {
    /// Id of the effect.
    pub(super) id: String,
    /// Expected squared signal-to-noise ratio at a typical amplitude.
    pub(super) lambda: f64,
    /// The same at the largest plausible amplitude.
    pub(super) lambda_largest: f64,
    /// yes, if large, absorbed by soil and interface, or not varied by the design.
    pub(super) verdict: String,
}

impl DiagnosisAnswer {
    pub(super) fn new(work: &Work, written: &Written) -> Self {
        let d = &work.diagnosis;
        let gap = &d.comparison.gap;
        Self {
            status: status(d.status).into(),
            effects: d
                .effects
                .iter()
                .map(|found| EffectAnswer {
                    id: found.id,
                    parameters: parameters(found)
                        .into_iter()
                        .map(|(name, p)| (name, ParameterAnswer { value: p.value, sd: p.sd, unit: p.unit }))
                        .collect(),
                    log_bayes_factor: found.log_bayes_factor,
                })
                .collect(),
            equivalence_set: d.equivalence_set.iter().map(ToString::to_string).collect(),
            gap: GapAnswer {
                before: gap.before,
                after: gap.after,
                heldout_before: gap.heldout_before,
                heldout_after: gap.heldout_after,
                chi2_per_n_before: gap.chi2_per_n_before,
                chi2_per_n_after: gap.chi2_per_n_after,
                delta_elpd: gap.delta_elpd,
                delta_elpd_se: gap.delta_elpd_se,
            },
            gap_by_channel: d
                .comparison
                .parts
                .iter()
                .filter(|part| part.covariate.is_none())
                .map(|part| ChannelGapAnswer {
                    channel: part.channel.into(),
                    readings: part.readings,
                    before: part.before,
                    after: part.after,
                    delta_elpd: part.delta_elpd,
                    delta_elpd_se: part.delta_elpd_se,
                })
                .collect(),
            located: d
                .located
                .iter()
                .map(|w| WhereAnswer {
                    channel: w.channel.clone(),
                    phase: w.phase.map(phase),
                    covariate: w.covariate.clone(),
                    p_adjusted: w.p_adjusted,
                })
                .collect(),
            next_experiment: d.next.as_ref().zip(written.next.as_ref()).map(|(next, path)| NextAnswer {
                text: next.text.clone(),
                design_csv: path.display().to_string(),
                power: next.power,
            }),
            patch: written.patch.display().to_string(),
            report: written.report.display().to_string(),
            model: work.against.model.clone(),
            model_file: work.against.file.as_ref().map(|(path, _)| path.clone()),
            known_effects: work.against.known().iter().map(|known| known.id.to_string()).collect(),
            strokes: work.data.len(),
            traces: work.recorded.as_ref().map_or(0, |recorded| recorded.used),
            phi_deg: d.comparison.soil_after.phi_deg,
            density_kg_m3: d.comparison.soil_after.density_kg_m3,
            scatter: d.scatter,
            testability: d
                .expected
                .iter()
                .map(|of| TestabilityAnswer {
                    id: of.id.to_string(),
                    lambda: of.lambda,
                    lambda_largest: of.lambda_largest,
                    verdict: testable(of.testable).into(),
                })
                .collect(),
        }
    }

    /// The outcome in a sentence.
    pub(super) fn sentence(&self) -> String {
        let names = self.equivalence_set.join(", ");
        match self.status.as_str() {
            "none" if !self.known_effects.is_empty() => {
                format!(
                    "beside {}, nothing is missing that these strokes could show",
                    self.known_effects.join(", ")
                )
            }
            "none" => "nothing is missing that these strokes could show".into(),
            "named" => {
                let told = |e: &EffectAnswer| format!("{} ({})", e.id, e.id.title());
                format!("missing: {}", self.effects.iter().map(told).collect::<Vec<_>>().join(" and "))
            }
            "ambiguous" => format!("something is missing; these explain it about equally well: {names}"),
            "provisional" => {
                format!("something is missing, and a shape without a name explains it as well: {names}")
            }
            "unknown" => format!("something is missing that is not in the catalogue: {names}"),
            _ => "these strokes cannot tell any effect from the soil itself; see the next experiment".into(),
        }
    }
}

/// A phase as it is written.
fn phase(phase: Phase) -> String {
    match phase {
        Phase::Loading => "loading",
        Phase::After => "after",
    }
    .into()
}

/// What the design could show, in words.
pub(super) const fn testable(testable: Testable) -> &'static str {
    match testable {
        Testable::Yes => "yes",
        Testable::IfLarge => "if large",
        Testable::Absorbed => "absorbed by phi, density and delta",
        Testable::NotVaried => "not testable with this design",
    }
}

impl soilctl_app::Answer for DiagnosisAnswer {
    const SCHEMA: &'static str = "soilctl.diagnose/1";
}

impl Words for DiagnosisAnswer {
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
        if let Some(next) = &self.next_experiment {
            text += &format!("next: {} (power {:.2}; {})\n", next.text, next.power, next.design_csv);
        }
        text += &format!("patch: {}\nreport: {}\n", self.patch, self.report);
        text
    }
}
