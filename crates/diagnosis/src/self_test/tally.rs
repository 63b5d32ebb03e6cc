//! Counts over hidden campaigns.

use std::collections::BTreeMap;

use soilctl_effects::EffectId;
use soilctl_stats::median;

use super::cause::Cause;
use super::run::{Case, Kind, Outcome};
use crate::{Diagnosis, Explanation, Status};

/// A rate with the number of campaigns behind it.
#[derive(Debug, Clone, PartialEq)]
pub struct Rate {
    /// What is counted.
    pub name: &'static str,
    /// The rate; `None` without campaigns.
    pub rate: Option<f64>,
    /// Campaigns, or effects, behind it.
    pub of: usize,
}

/// All rates of a self-test and its confusion matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Tally {
    /// Rates.
    pub rates: Vec<Rate>,
    /// First answer by hidden effect, for lambda of at least 25.
    pub confusion: BTreeMap<String, BTreeMap<String, usize>>,
}

/// Counts how the cases ended.
#[must_use]
pub fn tally(outcomes: &[(Case, Outcome)]) -> Tally {
    let mut rates = Vec::new();
    let mut rate = |name, hits: Vec<bool>| {
        let of = hits.len();
        let right = hits.iter().filter(|hit| **hit).count();
        rates.push(Rate { name, rate: (of > 0).then(|| right as f64 / of as f64), of });
    };
    let kind = |kind: Kind| outcomes.iter().filter(move |(case, _)| case.kind == kind);
    let is_hidden = |case: &Case, id: EffectId| case.causes.contains(&Cause::Effect(id));
    let first_is = |case: &Case, d: &Diagnosis| {
        let first = d.effects.first().map(|found| Cause::Effect(found.id));
        first.as_ref() == case.causes.first()
    };
    let first_right = |(case, o): &&(Case, Outcome)| first_is(case, &o.diagnosis);
    let in_set = |(case, o): &&(Case, Outcome)| {
        o.diagnosis.equivalence_set.iter().any(|explanation| match explanation {
            Explanation::Effect(id) => case.causes[0] == Cause::Effect(*id),
            Explanation::Unknown(_) => false,
        })
    };
    let firm_wrong =
        |(case, o): &&(Case, Outcome)| o.firm() && o.given().iter().any(|id| !is_hidden(case, *id));
    let strength =
        |low: f64, high: f64| move |entry: &&(Case, Outcome)| (low..high).contains(&entry.1.lambdas[0]);
    let all = f64::INFINITY;
    rate("nothing hidden: firm name", kind(Kind::Null).map(|(_, o)| o.firm()).collect());
    for (of, names) in [
        (
            Kind::Single,
            ["lambda >= 25, all columns: right name first", "lambda 8-25, all columns: right name first"],
        ),
        (
            Kind::SingleForces,
            ["lambda >= 25, forces alone: right name first", "lambda 8-25, forces alone: right name first"],
        ),
    ] {
        rate(names[0], kind(of).filter(strength(25.0, all)).map(|e| first_right(&e)).collect());
        rate(names[1], kind(of).filter(strength(8.0, 25.0)).map(|e| first_right(&e)).collect());
    }
    let singles =
        || outcomes.iter().filter(|(case, _)| matches!(case.kind, Kind::Single | Kind::SingleForces));
    let speaks = |entry: &&(Case, Outcome)| !entry.1.given().is_empty();
    rate(
        "lambda 8-25: truth in the set when it speaks",
        singles().filter(strength(8.0, 25.0)).filter(speaks).map(|e| in_set(&e)).collect(),
    );
    rate(
        "lambda >= 25: truth in the set when it speaks",
        singles().filter(strength(25.0, all)).filter(speaks).map(|e| in_set(&e)).collect(),
    );
    rate(
        "lambda >= 25: firm wrong name",
        singles().filter(strength(25.0, all)).map(|e| firm_wrong(&e)).collect(),
    );
    rate(
        "lambda < 8: firm wrong name",
        singles().filter(strength(0.0, 8.0)).map(|e| firm_wrong(&e)).collect(),
    );
    let visible = || kind(Kind::Pair).filter(|(_, o)| o.lambdas.iter().all(|l| *l >= 25.0));
    rate("two visible effects: recall", visible().flat_map(|(case, o)| recalled(case, o)).collect());
    rate(
        "two visible effects: false among names given",
        visible().flat_map(|(case, o)| o.given().into_iter().map(move |id| !is_hidden(case, id))).collect(),
    );
    rate(
        "two visible effects: exactly both",
        visible().map(|(case, o)| o.given().len() == 2 && recalled(case, o).all(|found| found)).collect(),
    );
    rate(
        "outside the catalogue: unknown",
        kind(Kind::Outside).map(|(_, o)| o.diagnosis.status == Status::Unknown).collect(),
    );
    rate("outside the catalogue: firm wrong name", kind(Kind::Outside).map(|e| firm_wrong(&e)).collect());
    let confounded = || kind(Kind::Confounded).filter(strength(25.0, all));
    rate(
        "confounded: ambiguous",
        confounded().map(|(_, o)| o.diagnosis.status == Status::Ambiguous).collect(),
    );
    rate("confounded: firm wrong name", confounded().map(|e| firm_wrong(&e)).collect());
    let followed = || confounded().filter_map(|(case, o)| Some((case, o.followed.as_ref()?)));
    rate(
        "confounded: right name first after the follow-up",
        followed().map(|(case, d)| first_is(case, d)).collect(),
    );
    let mut ratios = Vec::new();
    let mut closed = Vec::new();
    let (mut covered, mut chi2, mut gains) = (Vec::new(), Vec::new(), Vec::new());
    for (_, o) in singles().filter(strength(25.0, all)).filter(first_right) {
        if let (Some(found), Some(hidden)) = (o.diagnosis.effects.first(), o.campaign.hidden.first()) {
            if hidden.cause != Cause::Effect(EffectId::ModelForm) {
                ratios.push(found.amplitude / hidden.size);
                covered.push((found.amplitude - hidden.size).abs() <= 2.0 * found.amplitude_sd);
            }
            if o.diagnosis.comparison.gap.before > o.diagnosis.comparison.gap.after {
                closed.push(gap_left(o));
            }
            chi2.extend(o.diagnosis.comparison.gap.chi2_per_n_after);
            gains.extend(o.diagnosis.comparison.gap.delta_elpd);
        }
    }
    rate("lambda >= 25, named first: parameter within 2 sd", covered);
    for (name, mut values) in [
        ("median of parameter over truth", ratios),
        ("median share of the true gap that is left", closed),
        ("median held-out chi2 / n", chi2),
        ("median gain in elpd", gains),
    ] {
        let of = values.len();
        rates.push(Rate { name, rate: (of > 0).then(|| median(&mut values)), of });
    }
    let mut confusion: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for (case, o) in singles().filter(strength(25.0, all)) {
        let given = o
            .given()
            .first()
            .map_or_else(|| format!("({:?})", o.diagnosis.status).to_lowercase(), |id| id.to_string());
        *confusion.entry(case.causes[0].to_string()).or_default().entry(given).or_default() += 1;
    }
    Tally { rates, confusion }
}

/// Whether each hidden cause is among the effects that were given.
fn recalled<'a>(case: &'a Case, outcome: &'a Outcome) -> impl Iterator<Item = bool> + 'a {
    let given = outcome.given();
    case.causes.iter().map(move |cause| given.iter().any(|id| Cause::Effect(*id) == *cause))
}

/// Root mean square of predicted against true ln force with effects, over the same without.
fn gap_left(o: &Outcome) -> f64 {
    let rms = |model: &[f64]| {
        model.iter().zip(&o.campaign.ln_true).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    rms(&o.diagnosis.comparison.after) / rms(&o.diagnosis.comparison.before)
}
