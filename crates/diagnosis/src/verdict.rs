//! What may be said of a campaign.

use soilctl_effects::{Channel, Covariate, EffectId};

use crate::explanation::{Dependence, Explanation};
use crate::generic::varies;
use crate::search::{Scored, ScoredShape, Search, THRESHOLD};

/// What a diagnosis ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// Nothing is missing that these data could show.
    None,
    /// One set of effects explains the campaign, and nothing else does nearly as well.
    Named,
    /// Several effects explain it about equally well.
    Ambiguous,
    /// An effect explains it, but so does a shape without a name.
    Provisional,
    /// Something is missing that is not in the catalogue.
    Unknown,
    /// The design could not show any effect.
    NotTestable,
}

impl Status {
    /// As answers and model files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Named => "named",
            Self::Ambiguous => "ambiguous",
            Self::Provisional => "provisional",
            Self::Unknown => "unknown",
            Self::NotTestable => "not_testable",
        }
    }
}

/// Sets within this ln Bayes factor of the best are equivalent: odds of 7 to 1 at most, where "positive" evidence begins at 3 to 1 (Kass &
/// Raftery 1995). So are those within this part of it more, for formulas are not nature's, unless a reading denies them. Empirical.
const EQUIVALENT: f64 = 2.0;
const EQUIVALENT_SHARE: f64 = 0.05;
/// Effects that only a condition that must vary tells apart, whatever their formulas make of the same strokes.
const CONFOUNDED: [(EffectId, EffectId, Covariate); 1] =
    [(EffectId::DensityGradient, EffectId::SideEffects3d, Covariate::Width)];
/// Part of the best set's ln Bayes factor that one with the confounded effect in its place must have to be as likely, if both may shift all forces
/// alike: where a formula is 1 is a convention. Empirical.
const CONFOUNDED_SHARE: f64 = 0.6;
/// ln Bayes factor by which a shape without a name must beat the best effects to be believed instead: 20 to 1. Empirical.
const UNKNOWN_MARGIN: f64 = 3.0;
/// ln Bayes factor of such a shape on top of the named effects from which these are not all that is missing: 20 to 1. Empirical.
const LEFT_OVER: f64 = 3.0;
/// Part of what the effects explain that their formulas may leave over; a shape that beats them by more than half of it leaves them
/// provisional. Empirical.
const LEFT_OVER_SHARE: f64 = 0.15;

/// The best explanation, what else it could be, and the verdict.
#[derive(Debug, Clone)]
pub(crate) struct Verdict {
    pub(crate) status: Status,
    /// The best set of effects, if any is worth naming.
    pub(crate) best: Option<Scored>,
    /// ln Bayes factor of each effect of the best set: what taking it out costs.
    pub(crate) factors: Vec<f64>,
    /// What the data do not tell apart, best first.
    pub(crate) equivalents: Vec<Explanation>,
    /// What a shape without a name depends on and its ln Bayes factor, if the verdict speaks of one.
    pub(crate) shape: Option<(Dependence, f64)>,
    /// That shape, if it is all that explains the campaign.
    pub(crate) instead_of_effects: Option<ScoredShape>,
    /// All effects alone, best first.
    pub(crate) singles: Vec<Scored>,
}

/// Weighs sets of effects and shapes without a name.
pub(crate) fn judge(search: &Search<'_>) -> Verdict {
    let sizes = search.sets();
    let mut best: Option<&Scored> = None;
    for scored in sizes.iter().filter_map(|of_size| of_size.first()) {
        if scored.score() > best.map_or(0.0, Scored::score) {
            best = Some(scored);
        }
    }
    let decided = search.setup.data.decided.as_ref();
    let set = decided.and_then(|decided| search.together(&decided.best));
    let best = if decided.is_some() { set.as_ref() } else { best };
    let singles = sizes.first().cloned().unwrap_or_default();
    let shapes = search.shapes_on(None);
    // The odds against any one of them, and a margin, as an effect pays; the margin is empirical.
    let multiplicity = (search.shapes.len().max(1) as f64).ln() + 1.2;
    let shape_score = |shape: &ScoredShape| shape.log_bayes - multiplicity;
    let shape = shapes.into_iter().next().filter(|shape| shape_score(shape) > 0.0);
    let lead = shape.as_ref().map(shape_score).unwrap_or_default() - best.map_or(0.0, Scored::score);
    let Some(best) = best else {
        let status = if shape.is_some() { Status::Unknown } else { Status::None };
        let equivalents = shape.iter().map(|shape| Explanation::Unknown(shape.over)).collect();
        return Verdict {
            status,
            best: None,
            factors: Vec::new(),
            equivalents,
            shape: shape.as_ref().map(|shape| (shape.over, shape.log_bayes)),
            instead_of_effects: shape,
            singles,
        };
    };
    let of_size: &[Scored] = match decided {
        None => &sizes[best.spec.choices.len() - 1],
        Some(_) => &[],
    };
    let mut equivalents: Vec<Explanation> = Vec::new();
    for id in decided.iter().flat_map(|decided| decided.best.iter().chain(&decided.as_likely)) {
        equivalents.push(Explanation::Effect(*id));
    }
    let as_likely = |scored: &&Scored| {
        let form = if search.is_denied_by_a_reading(&scored.spec) { 0.0 } else { EQUIVALENT_SHARE };
        scored.log_bayes > (1.0 - form) * best.log_bayes - EQUIVALENT
            || (confounded(search, best, scored)
                && search.at_any_level(scored) > CONFOUNDED_SHARE * search.at_any_level(best))
    };
    for scored in of_size.iter().filter(as_likely) {
        for id in scored.spec.ids().into_iter().map(Explanation::Effect) {
            if !equivalents.contains(&id) {
                equivalents.push(id);
            }
        }
    }
    let turns = turns_the_slip(search, best);
    for id in TURN_ALIKE.map(Explanation::Effect) {
        if turns && !equivalents.contains(&id) {
            equivalents.push(id);
        }
    }
    let factors = factors(best, &sizes);
    let on_force = best.spec.on_force();
    let more = if on_force { search.shapes_on(Some(best)).into_iter().next() } else { None };
    let left_over =
        more.filter(|more| more.log_bayes - multiplicity > LEFT_OVER + LEFT_OVER_SHARE * best.log_bayes);
    let instead = if on_force { search.shape_instead(best) } else { None };
    let status = if lead > UNKNOWN_MARGIN + LEFT_OVER_SHARE * best.log_bayes && on_force {
        Status::Unknown
    } else if (lead > 0.5 * LEFT_OVER_SHARE * best.log_bayes && on_force)
        || left_over.is_some()
        || instead.is_some()
    {
        Status::Provisional
    } else if turns || equivalents.len() > best.spec.choices.len() {
        Status::Ambiguous
    } else {
        Status::Named
    };
    let instead_of_effects = shape.clone().filter(|_| status == Status::Unknown);
    let shape = match status {
        Status::Unknown => shape,
        Status::Provisional => left_over.or(shape),
        _ => None,
    };
    let shape = shape.map(|shape| (shape.over, shape.log_bayes));
    let shape = if status == Status::Provisional { instead.or(shape) } else { shape };
    if let Some((over, _)) = shape {
        let at = if status == Status::Unknown { 0 } else { equivalents.len() };
        equivalents.insert(at, Explanation::Unknown(over));
    }
    Verdict { status, best: Some(best.clone()), factors, equivalents, shape, instead_of_effects, singles }
}

/// What turns the force after failure alike: interface friction and cross-talk of the sensor.
pub const TURN_ALIKE: [EffectId; 2] = [EffectId::InterfaceFrictionOffset, EffectId::FtCrosstalk];

/// Whether a set has effects that turn the force after failure alike, and a trace shows the slip. What is left of their difference in
/// forces and columns goes with the soil, the posture and the zero of the sensor: however much likelier one of them is, or both, none is
/// firm, for each has been seen to take the other's place, and both that of one.
fn turns_the_slip(search: &Search<'_>, best: &Scored) -> bool {
    let data = search.setup.data;
    // A simulated arm that was tried with each may have told them apart.
    data.decided.is_none()
        && data.channels.contains_key(&Channel::SlipAngle)
        && best.spec.ids().iter().any(|id| TURN_ALIKE.contains(id))
}

/// Whether two sets differ by confounded effects only, and the condition that would tell these apart is always the same.
fn confounded(search: &Search<'_>, one: &Scored, other: &Scored) -> bool {
    let (of_one, of_other) = (one.spec.ids(), other.spec.ids());
    let left = |ids: &[EffectId], others: &[EffectId]| -> Vec<EffectId> {
        ids.iter().copied().filter(|id| !others.contains(id)).collect()
    };
    let pair = (left(&of_one, &of_other), left(&of_other, &of_one));
    let (&[a], &[b]) = (pair.0.as_slice(), pair.1.as_slice()) else { return false };
    CONFOUNDED.iter().any(|&(x, y, condition)| {
        ((a, b) == (x, y) || (a, b) == (y, x)) && !varies(search.setup.data, condition)
    })
}

/// What each effect of a set earns over the best set without it.
fn factors(best: &Scored, sizes: &[Vec<Scored>]) -> Vec<f64> {
    let ids = best.spec.ids();
    if ids.len() == 1 {
        return vec![best.log_bayes];
    }
    let smaller = sizes.get(ids.len() - 2).map_or(&[][..], Vec::as_slice);
    ids.iter()
        .map(|out| {
            let without = smaller.iter().find(|set| {
                let of_set = set.spec.ids();
                !of_set.contains(out) && of_set.iter().all(|id| ids.contains(id))
            });
            without.map_or(THRESHOLD, |set| best.log_bayes - set.log_bayes)
        })
        .collect()
}
