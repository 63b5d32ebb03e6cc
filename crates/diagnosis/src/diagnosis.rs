//! The whole diagnosis of a campaign.

use soilctl_effects::{Active, EffectId, EmpiricalTerm};

use crate::DiagnosisError;
use crate::data::{Data, Readings};
use crate::explanation::Explanation;
use crate::gap::{Comparison, FittedSoil, compare, soil};
use crate::localise::{Where, localise};
use crate::next::{Found, NextExperiment, next};
use crate::search::{Scored, Search};
use crate::settle::settled;
use crate::setup::FitSetup;
use crate::spec::{Choice, Spec};
use crate::surface::Surface;
use crate::term::term;
use crate::testability::{Expected, LEAST_LAMBDA, expected};
use crate::verdict::{Status, judge};

/// An effect that was found.
#[derive(Debug, Clone)]
pub struct FoundEffect {
    /// Which one.
    pub id: EffectId,
    /// Amplitude in the unit of its parameter.
    pub amplitude: f64,
    /// Standard deviation of the amplitude.
    pub amplitude_sd: f64,
    /// Its shape, 0 for effects without one.
    pub shape: f64,
    /// ln Bayes factor over the explanation without it.
    pub log_bayes_factor: f64,
}

/// What a campaign says.
#[derive(Debug, Clone)]
pub struct Diagnosis {
    /// The outcome.
    pub status: Status,
    /// Effects of the best explanation, best first; empty unless named, ambiguous or provisional.
    pub effects: Vec<FoundEffect>,
    /// What takes the place of effects where none of the catalogue explains the campaign: a term of the conditions of the strokes, if it is unknown.
    pub terms: Vec<EmpiricalTerm>,
    /// What the data do not tell apart, best first.
    pub equivalence_set: Vec<Explanation>,
    /// What the design could show of each effect.
    pub expected: Vec<Expected>,
    /// Disagreements of the recalibrated baseline that are more than chance.
    pub located: Vec<Where>,
    /// ln Bayes factor of each effect alone, best first.
    pub alone: Vec<(EffectId, f64)>,
    /// The gap and the predictions without and with the effects.
    pub comparison: Comparison,
    /// The follow-up that would tell most.
    pub next: Option<NextExperiment>,
    /// Scatter of ln force of one stroke about the baseline.
    pub scatter: f64,
}

impl Diagnosis {
    /// Whether effects, or a term in their place, were found.
    #[must_use]
    pub fn has_found(&self) -> bool {
        !self.effects.is_empty() || !self.terms.is_empty()
    }
}

/// Diagnoses a campaign against a force model and the effects that are known ([`Data::know`]).
///
/// # Errors
/// [`DiagnosisError::NoFit`] if no soil explains the forces at all.
pub fn diagnose(data: &Data, surface: &Surface) -> Result<Diagnosis, DiagnosisError> {
    let mut settled = settled(data, surface)?;
    // What is said of a set is told by sizes for which responses ask: those that are held are of an arm for which responses are not.
    let held = settled.decided.as_mut().map(|decided| std::mem::take(&mut decided.held)).unwrap_or_default();
    let data = &settled;
    let first = FitSetup::new(data, surface, data.phi.mean);
    let phi_deg = Search::new(&first)?.baseline.soil[0];
    let setup = FitSetup::new(data, surface, phi_deg);
    let search = Search::new(&setup)?;
    let expected = expected(&setup, phi_deg, data.possible());
    // With a handful of strokes the largest amplitudes alone could be seen, which is no test of anything.
    let testable = expected.iter().filter(|of| of.lambda >= LEAST_LAMBDA).count() > 0 && !data.is_summary();
    let verdict = judge(&search);
    let status = if testable { verdict.status } else { Status::NotTestable };
    let mut effects = Vec::new();
    let mut spec = Spec::default();
    if let (Status::Named | Status::Ambiguous | Status::Provisional, Some(best)) = (status, &verdict.best) {
        spec = best.spec.clone();
        effects = effects_of(data, best);
        for (effect, factor) in effects.iter_mut().zip(&verdict.factors) {
            effect.log_bayes_factor = *factor;
            if let Some(size) = held.get(&effect.id) {
                (effect.amplitude, effect.amplitude_sd) = *size;
            }
        }
    }
    let shape = verdict.instead_of_effects.as_ref().filter(|_| status == Status::Unknown);
    spec.generic = shape.map(|shape| shape.columns.clone()).unwrap_or_default();
    let amplitudes: Vec<f64> = effects.iter().map(|effect| effect.amplitude).collect();
    let failed = || DiagnosisError::NoFit {
        file: data.name.clone(),
        model: "the force model".into(),
        problem: "a batch left out could not be predicted".into(),
    };
    let comparison = compare(&setup, &spec, &amplitudes).ok_or_else(failed)?;
    let (coefficients, covariance) = &comparison.shape;
    let terms = shape.and_then(|shape| term(data, shape, (coefficients, covariance))).into_iter().collect();
    effects.sort_by(|a, b| b.log_bayes_factor.total_cmp(&a.log_bayes_factor));
    let equivalence_set = if testable { verdict.equivalents } else { Vec::new() };
    // Effects as they were fitted together come before the same ones alone.
    let together = effects.iter().map(|found| Active {
        effect: found.id.effect(),
        amplitude: found.amplitude,
        shape: found.shape,
    });
    let alone = verdict.singles.iter().filter_map(|single| {
        let (choice, &(amplitude, _)) = single.spec.choices.first().zip(single.fit.amplitudes.first())?;
        Some(Active { effect: choice.effect, amplitude, shape: choice.shape })
    });
    let fitted: Vec<Active> = together.chain(alone).collect();
    let first = effects.iter().find(|found| found.id.effect().acts_on_force());
    let open = match first.filter(|_| status == Status::Named) {
        // What is named together is not to be told apart.
        Some(first) => vec![Explanation::Effect(first.id)],
        None => equivalence_set.clone(),
    };
    // That of the forces under what was found.
    let scatter = verdict.best.as_ref().filter(|best| best.spec.on_force() && !effects.is_empty());
    let found = Found {
        fitted: &fitted,
        scatter: scatter.map_or(search.baseline.scatter, |best| best.fit.scatter),
        shape: verdict.shape,
    };
    let next = next(&setup, phi_deg, found, &open, &expected);
    Ok(Diagnosis {
        status,
        effects,
        terms,
        equivalence_set,
        located: localise(&setup, &search.baseline),
        expected,
        alone: verdict
            .singles
            .iter()
            .filter_map(|scored| Some((*scored.spec.ids().first()?, scored.log_bayes)))
            .collect(),
        comparison,
        next,
        scatter: search.baseline.scatter,
    })
}

/// Effects of a set, all with the ln Bayes factor of the whole set.
fn effects_of(data: &Data, set: &Scored) -> Vec<FoundEffect> {
    let found = set.spec.choices.iter().zip(&set.fit.amplitudes);
    let effect = |(choice, (amplitude, sd)): (&Choice, &(f64, f64))| {
        let held = data.held(choice.effect.id).map(|(_, sd)| sd);
        FoundEffect {
            id: choice.effect.id,
            amplitude: *amplitude,
            amplitude_sd: held.unwrap_or_else(|| sd.hypot(FORM_ERROR * amplitude)),
            shape: choice.shape,
            log_bayes_factor: set.log_bayes,
        }
    };
    found.map(effect).collect()
}

/// Effects with their sizes, and the soil beside them.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The effects; none if strokes speak against one of them.
    pub effects: Vec<FoundEffect>,
    /// The soil.
    pub soil: FittedSoil,
}

/// Sizes and soil that strokes tell of a set that was decided for ([`Data::decide`]), or the soil without effects if it is empty or none was, without
/// weighing whether they are there. The soil is the one that all readings ask for; that of [`diagnose`] is the one with which formulas come nearest to the forces. `strokes`
/// says by stroke which tell them; those beyond its end do.
///
/// # Errors
/// As [`diagnose`].
pub fn fitted(data: &Data, surface: &Surface, strokes: &[bool]) -> Result<Fitted, DiagnosisError> {
    let data = &settled(data, surface)?;
    let first = FitSetup::new(data, surface, data.phi.mean);
    let phi_deg = Search::new(&first)?.baseline.soil[0];
    let setup = FitSetup::new(data, surface, phi_deg);
    let search = Search::of_strokes(&setup, taking_part(data, strokes))?;
    let set = data.decided.as_ref().and_then(|decided| search.together(&decided.best));
    let effects = set.as_ref().map(|set| effects_of(data, set)).unwrap_or_default();
    let fit =
        set.as_ref().filter(|set| setup.needs_forces(&set.spec)).map_or(&search.baseline, |set| &set.fit);
    let soil = soil(&setup, fit);
    Ok(Fitted { effects, soil })
}

/// ln of the probability of forces and columns, with what is known and nothing else: to be compared between what is expected of the same
/// readings ([`Data::expect`]) under one set of known effects ([`Data::know`]) and another. `of` are the columns and strokes of which all of them say
/// what to expect ([`Data::readings`]): each adds to it.
///
/// # Errors
/// As [`diagnose`].
pub fn log_evidence(data: &Data, surface: &Surface, of: &Readings) -> Result<f64, DiagnosisError> {
    let mut data = data.clone();
    data.channels.retain(|channel, _| of.columns.contains(channel));
    let data = &settled(&data, surface)?;
    let first = FitSetup::new(data, surface, data.phi.mean);
    let phi_deg = Search::new(&first)?.baseline.soil[0];
    let setup = FitSetup::new(data, surface, phi_deg);
    Ok(Search::of_strokes(&setup, taking_part(data, &of.strokes))?.log_evidence())
}

/// Whether each stroke takes part; those beyond the end do.
fn taking_part(data: &Data, strokes: &[bool]) -> Vec<bool> {
    (0..data.len()).map(|i| strokes.get(i).copied().unwrap_or(true)).collect()
}

/// Relative error of an amplitude because nature's formula is not ours. Empirical: with it, 90 % of the amplitudes of hidden campaigns
/// are within two standard deviations.
const FORM_ERROR: f64 = 0.08;
