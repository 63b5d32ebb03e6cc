//! What a diagnosis answers.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_diagnosis::{Data, Diagnosis, Status, signal_gaps};
use soilctl_effects::EffectId;

use super::Against;
use super::Simulated;
use super::disagreements::disagreements;
use super::files::Written;
use super::follow_up::FollowUp;
use super::logs::Resimulation;
use crate::Outcome;
use crate::text::{measured, number};

/// Effects that come nearest to what has no name.
const MOST_NEAREST: usize = 3;

/// Where model and measurement disagree, which effect is missing, and the gap after it is added.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// none, named, ambiguous, provisional, unknown or not_testable; only `named` is firm.
    pub status: String,
    /// Effects of the best explanation, best first; empty unless named, ambiguous or provisional.
    pub effects: Vec<EffectAnswer>,
    /// What takes the place of effects where the status is unknown: a change of the force over conditions of the strokes, which `patch` has. Empty
    /// otherwise.
    pub empirical: Vec<TermAnswer>,
    /// Effects of the catalogue that come nearest where the status is unknown, best first, at most three; empty otherwise.
    pub nearest: Vec<NearestAnswer>,
    /// What the data do not tell apart, best first; ids of effects, or `unknown:<covariate>`.
    pub equivalence_set: Vec<String>,
    /// How far model and measurement are apart.
    pub gap: GapAnswer,
    /// The gap of forces and of each column, on batches that were left out, forces first; empty with fewer than two batches.
    /// `gap.csv` has it along each condition.
    pub gap_by_channel: Vec<ChannelGapAnswer>,
    /// The gap of each signal to the same strokes on the simulated arm; empty if they were not simulated.
    pub signals: Vec<SignalAnswer>,
    /// Whether they were, or why not.
    pub resimulated: Resimulation,
    /// Why logs that are there cannot be simulated again; null otherwise.
    pub not_resimulated_because: Option<String>,
    /// Disagreements of the recalibrated baseline that are more than chance.
    #[serde(rename = "where")]
    pub located: Vec<WhereAnswer>,
    /// Where readings of interface friction, zero or surface say what the verdict does not have, each with the reason.
    pub disagreements: Vec<String>,
    /// The follow-up that would tell most; null if nothing on the menu would.
    pub next_experiment: Option<NextAnswer>,
    /// Model file for `--model-file`.
    pub patch: String,
    /// The same for `simulate`, with the soil that all signals ask for, where `patch` has the one with which the formulas come nearest to the forces; null if
    /// signals were not compared with those of the simulated arm.
    pub twin: Option<String>,
    /// HTML page; null if none was made.
    pub report: Option<String>,
    /// The force model without effects.
    pub model: String,
    /// The model file that the campaign was held against; null without one.
    pub model_file: Option<String>,
    /// Effects of that file, which were taken as known, and its empirical terms as `a term over` their conditions; `patch` has them before those that
    /// were found.
    pub known_effects: Vec<String>,
    /// That strokes lie beyond those from which the empirical terms of that file were made; null if none does.
    pub beyond_known: Option<String>,
    /// Strokes.
    pub strokes: usize,
    /// Strokes whose trace was used.
    pub traces: usize,
    /// Recalibrated friction angle with the effects, deg.
    pub phi_deg: f64,
    /// Recalibrated density with the effects, kg/m3.
    pub density_kg_m3: f64,
    /// Scatter of ln force of one stroke about the baseline.
    pub scatter: f64,
    /// What the design could show of each effect, before the forces were looked at.
    pub testability: Vec<TestabilityAnswer>,
}

/// One effect.
#[derive(Debug, Serialize, JsonSchema)]
pub struct EffectAnswer {
    /// Id in the catalogue.
    #[schemars(with = "String")]
    pub id: EffectId,
    /// Parameters by name.
    pub parameters: BTreeMap<String, ParameterAnswer>,
    /// ln Bayes factor over the explanation without it.
    pub log_bayes_factor: f64,
}

/// A change of the force over one condition of the strokes or two, without a name.
#[derive(Debug, Serialize, JsonSchema)]
pub struct TermAnswer {
    /// Columns of the stroke table.
    pub over: Vec<String>,
    /// Values of each of these, ascending, in the unit of the column; of `batch` its place, from 0.
    pub at: Vec<Vec<f64>>,
    /// Change of ln force there, those of the last condition one after the other; linear between, and held beyond.
    pub ln_force: Vec<f64>,
    /// Standard deviation of each.
    pub sd: Vec<f64>,
    /// ln Bayes factor over the explanation without it.
    pub log_bayes_factor: f64,
}

/// A point of a term.
#[derive(Debug)]
pub struct TermPoint {
    /// Values of the conditions.
    pub at: Vec<f64>,
    /// Change of the force there, relative, with its standard deviation.
    pub change: [f64; 2],
}

impl TermPoint {
    /// In words.
    #[must_use]
    pub fn text(&self) -> String {
        let at: Vec<String> = self.at.iter().map(|value| number(*value)).collect();
        let [change, sd] = self.change.map(|share| 100.0 * share);
        format!("{change:+.1} ± {sd:.1} % at {}", at.join(" x "))
    }
}

impl TermAnswer {
    /// Its points, one after the other.
    #[must_use]
    pub fn points(&self) -> Vec<TermPoint> {
        let last = self.at.last().map_or(1, Vec::len).max(1);
        let values = self.ln_force.iter().zip(&self.sd).enumerate();
        values
            .map(|(k, (ln_force, sd))| {
                let places = if self.at.len() > 1 { vec![k / last, k % last] } else { vec![k] };
                let at = self.at.iter().zip(places).filter_map(|(values, place)| values.get(place).copied());
                let factor = ln_force.exp();
                TermPoint { at: at.collect(), change: [factor - 1.0, factor * sd] }
            })
            .collect()
    }
}

/// An effect that comes near.
#[derive(Debug, Serialize, JsonSchema)]
pub struct NearestAnswer {
    /// Id in the catalogue.
    #[schemars(with = "String")]
    pub id: EffectId,
    /// ln Bayes factor of it alone.
    pub log_bayes_factor: f64,
}

/// A parameter.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ParameterAnswer {
    /// Value; for a choice among force models, its index.
    pub value: f64,
    /// Standard deviation.
    pub sd: f64,
    /// Unit, `1` for a number without.
    pub unit: String,
}

impl ParameterAnswer {
    /// With as many digits as it is known to.
    #[must_use]
    pub fn text(&self) -> String {
        measured(self.value, self.sd, &self.unit)
    }
}

/// Root mean squares of ln force; chi-square and log density are of batches that were left out.
#[derive(Debug, Serialize, JsonSchema)]
pub struct GapAnswer {
    /// Without effects.
    pub before: f64,
    /// With effects.
    pub after: f64,
    /// Without effects, each batch predicted from the others; null with fewer than two batches.
    pub heldout_before: Option<f64>,
    /// With effects, each batch predicted from the others.
    pub heldout_after: Option<f64>,
    /// chi-square a stroke without effects.
    pub chi2_per_n_before: Option<f64>,
    /// chi-square a stroke with effects.
    pub chi2_per_n_after: Option<f64>,
    /// Gain in expected log predictive density.
    pub delta_elpd: Option<f64>,
    /// Its standard error.
    pub delta_elpd_se: Option<f64>,
}

/// The gap of a column, in standard deviations of the prediction with effects.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ChannelGapAnswer {
    /// Column of the stroke table, or of the traces.
    pub channel: String,
    /// Readings.
    pub readings: usize,
    /// Normalised root mean square without effects; the square is chi-square a reading.
    pub before: f64,
    /// The same with effects.
    pub after: f64,
    /// Gain in log predictive density, summed over readings.
    pub delta_elpd: f64,
    /// Its standard error.
    pub delta_elpd_se: f64,
}

/// The gap of a signal to the simulated arm, in standard deviations of its scatter from stroke to stroke.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SignalAnswer {
    /// Column of the stroke table, or of the traces; the force goes as its logarithm.
    pub signal: String,
    /// Phase of the stroke, for readings of traces: loading or after; null for the column itself.
    pub phase: Option<String>,
    /// Strokes that have it.
    pub strokes: usize,
    /// Root mean square of measured minus simulated without effects.
    pub gap_before: f64,
    /// The same with the effects that were found; null if they were not simulated.
    pub gap_after: Option<f64>,
    /// Batches that were left out, predicted without effects, in standard deviations of the prediction; null without such a prediction.
    pub heldout_before: Option<f64>,
    /// The same with effects.
    pub heldout_after: Option<f64>,
}

/// One disagreement.
#[derive(Debug, Serialize, JsonSchema)]
pub struct WhereAnswer {
    /// Column of the stroke table, or of the traces.
    pub channel: String,
    /// Phase of the stroke, for readings of traces: loading or after; null for the column itself.
    pub phase: Option<String>,
    /// Covariate; `all` if all strokes are off what a simulated arm reads.
    pub covariate: String,
    /// Probability of as much by chance, adjusted for the number of tests.
    pub p_adjusted: f64,
}

/// The next experiment.
#[derive(Debug, Serialize, JsonSchema)]
pub struct NextAnswer {
    /// What to do and why.
    pub text: String,
    /// File with the strokes to make.
    pub design_csv: String,
    /// Plan of the campaign with these strokes after its own, for `simulate` and `run`; null if the campaign was not compared with the simulated
    /// arm, or a plan cannot say them.
    pub plan: Option<String>,
    /// Why not, where there could have been one; null otherwise.
    pub no_plan_because: Option<String>,
    /// Chance that it settles the question.
    pub power: f64,
}

/// What the design could show of an effect.
#[derive(Debug, Serialize, JsonSchema)]
pub struct TestabilityAnswer {
    /// Id of the effect.
    pub id: String,
    /// Expected squared signal-to-noise ratio at a typical amplitude.
    pub lambda: f64,
    /// The same at the largest plausible amplitude.
    pub lambda_largest: f64,
    /// yes, if large, absorbed by soil and interface, masked by baselines, or not varied by the design.
    pub verdict: String,
}

impl Answer {
    pub(super) fn new(
        against: &Against,
        data: &Data,
        d: &Diagnosis,
        (simulated, resimulated, not_resimulated_because): (&Simulated, Resimulation, Option<String>),
        traces: usize,
        written: &Written,
        follow_up: FollowUp,
    ) -> Self {
        let gap = &d.comparison.gap;
        Self {
            status: d.status.name().into(),
            effects: d
                .effects
                .iter()
                .map(|found| EffectAnswer {
                    id: found.id,
                    parameters: found
                        .parameters()
                        .into_iter()
                        .map(|(name, p)| (name, ParameterAnswer { value: p.value, sd: p.sd, unit: p.unit }))
                        .collect(),
                    log_bayes_factor: found.log_bayes_factor,
                })
                .collect(),
            empirical: d
                .terms
                .iter()
                .map(|term| TermAnswer {
                    over: term.over.iter().map(ToString::to_string).collect(),
                    at: term.at.clone(),
                    ln_force: term.ln_force.clone(),
                    sd: term.sd.clone(),
                    log_bayes_factor: term.log_bayes_factor,
                })
                .collect(),
            nearest: d
                .alone
                .iter()
                .filter(|(_, log_bayes)| d.status == Status::Unknown && *log_bayes > 0.0)
                .take(MOST_NEAREST)
                .map(|&(id, log_bayes_factor)| NearestAnswer { id, log_bayes_factor })
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
            signals: signals(data, d, simulated),
            resimulated,
            not_resimulated_because,
            located: d
                .located
                .iter()
                .map(|w| WhereAnswer {
                    channel: w.channel.clone(),
                    phase: w.phase.map(|phase| phase.name().into()),
                    covariate: w.covariate.clone(),
                    p_adjusted: w.p_adjusted,
                })
                .collect(),
            disagreements: disagreements(
                data,
                d,
                &against.known().iter().map(|known| known.id).collect::<Vec<_>>(),
                simulated.before.as_ref().map(|before| &before.data),
            ),
            next_experiment: d.next.as_ref().zip(written.next.as_ref()).map(|(next, path)| NextAnswer {
                text: next.text.clone(),
                design_csv: path.display().to_string(),
                plan: follow_up.plan,
                no_plan_because: follow_up.refused,
                power: next.power,
            }),
            patch: written.patch.display().to_string(),
            twin: written.twin.as_ref().map(|path| path.display().to_string()),
            report: None,
            model: against.model.clone(),
            model_file: against.file.as_ref().map(|(path, _)| path.clone()),
            known_effects: against.known_words(),
            beyond_known: against.beyond_terms.clone(),
            strokes: data.len(),
            traces,
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
                    verdict: of.testable.words().into(),
                })
                .collect(),
        }
    }

    /// The outcome in a sentence.
    #[must_use]
    pub fn sentence(&self) -> String {
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

    /// That signals were not compared although they could have been expected to be; `None` otherwise.
    #[must_use]
    pub fn resimulation(&self) -> Option<String> {
        match (self.resimulated, &self.not_resimulated_because) {
            (Resimulation::Compared | Resimulation::NoLogs | Resimulation::NotWanted, _) => None,
            (Resimulation::NotPossible, Some(why)) => {
                Some(format!("signals were not compared with a simulated arm, only the table was read: {why}"))
            }
            (Resimulation::NotPossible, None) => {
                Some("no simulated stroke failed the soil, so that only the table was read".into())
            }
            (Resimulation::Stopped, _) => Some(
                "stopped before all signals were compared with a simulated arm; the same command goes on from here".into(),
            ),
        }
    }
}

fn signals(data: &Data, d: &Diagnosis, simulated: &Simulated) -> Vec<SignalAnswer> {
    let Some(before) = &simulated.before else { return Vec::new() };
    let after = simulated.after.as_ref().map(|after| &after.data);
    let whole = |signal: &str| {
        d.comparison.parts.iter().find(|part| part.covariate.is_none() && part.channel == signal)
    };
    signal_gaps(data, &before.data, after)
        .into_iter()
        .map(|gap| {
            let part = whole(&gap.signal).filter(|_| gap.phase.is_none());
            SignalAnswer {
                heldout_before: part.map(|part| part.before),
                heldout_after: part.map(|part| part.after),
                phase: gap.phase.map(|phase| phase.name().into()),
                signal: gap.signal,
                strokes: gap.strokes,
                gap_before: gap.before,
                gap_after: gap.after,
            }
        })
        .collect()
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.diagnose/1";

    fn outcome(&self) -> Outcome {
        match self.resimulated {
            Resimulation::Stopped => Outcome::Partial,
            Resimulation::Compared
            | Resimulation::NoLogs
            | Resimulation::NotWanted
            | Resimulation::NotPossible => Outcome::Done,
        }
    }
}
