//! What diagnoses of hidden campaigns said, counted.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_stats::median;

use super::super::self_test::Rate;
use super::hidden::{Case, Hidden};
use super::outside::Outside;
use crate::diagnose::Diagnosed;

/// Status of a campaign of which no stroke failed the soil.
const NO_FAILURES: &str = "no_failures";
/// What stands before the conditions of a shape without a name.
const UNKNOWN: &str = "unknown:";

/// One hidden campaign, and what was said of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Entry {
    /// Its number, from 0.
    pub number: u64,
    /// What was hidden: an effect, or `outside_` and a kind that no effect is; null for nothing.
    pub hidden: Option<String>,
    /// Amplitude of the effect in the unit of its parameter, or the largest change of ln force; null for nothing.
    pub amplitude: Option<f64>,
    /// Preset of the soil.
    pub soil: String,
    /// What the campaign gave.
    #[serde(flatten)]
    pub said: Said,
    /// What it gave with the strokes that were proposed; null if none were, or they were not made.
    pub follow_up: Option<Said>,
}

/// What a diagnosis said.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Said {
    /// Strokes that failed the soil.
    pub strokes: usize,
    /// Status of the diagnosis; `no_failures` if no stroke failed the soil.
    pub status: String,
    /// Effects that were given, best first.
    pub given: Vec<String>,
    /// What was not told apart.
    pub equivalence_set: Vec<String>,
    /// Amplitude that was found of the hidden effect, with its standard deviation; null if it was not given.
    pub found: Option<(f64, f64)>,
}

impl Said {
    pub(super) fn new(case: &Case, found: &Diagnosed) -> Self {
        let answer = &found.answer;
        let of_hidden = match case.hidden {
            Hidden::Effect(id, _) => found.diagnosis.effects.iter().find(|of| of.id == id),
            Hidden::Nothing | Hidden::Outside(..) => None,
        };
        Self {
            strokes: answer.strokes,
            status: answer.status.clone(),
            given: answer.effects.iter().map(|effect| effect.id.to_string()).collect(),
            equivalence_set: answer.equivalence_set.clone(),
            found: of_hidden.map(|of| (of.amplitude, of.amplitude_sd)),
        }
    }

    pub(super) fn without_failures() -> Self {
        Self {
            strokes: 0,
            status: NO_FAILURES.to_owned(),
            given: Vec::new(),
            equivalence_set: Vec::new(),
            found: None,
        }
    }

    /// Status, with the first effect where one was given, or the conditions of a shape without a name.
    #[must_use]
    pub fn in_words(&self) -> String {
        match (self.given.first(), self.equivalence_set.first()) {
            (Some(first), _) => format!("{} {first}", self.status),
            (None, Some(shape)) => format!("{} {}", self.status, shape.trim_start_matches(UNKNOWN)),
            (None, None) => self.status.clone(),
        }
    }

    /// Whether a shape without a name is given, or left beside effects, over the conditions of what was hidden.
    fn is_over(&self, of: Outside) -> bool {
        let wanted: BTreeSet<&str> = of.over().iter().map(|condition| condition.column()).collect();
        let shapes = self.equivalence_set.iter().filter_map(|given| given.strip_prefix(UNKNOWN));
        shapes.map(|over| over.split(" x ").collect::<BTreeSet<_>>()).any(|over| over == wanted)
    }

    fn is_firm(&self) -> bool {
        self.status == "named"
    }

    fn is_only(&self, hidden: Option<&String>) -> bool {
        self.given.iter().all(|id| Some(id) == hidden)
    }
}

impl Entry {
    pub(super) fn new(case: &Case, said: Said, follow_up: Option<Said>) -> Self {
        Self {
            number: case.number,
            hidden: (case.hidden != Hidden::Nothing).then(|| case.hidden.name().to_owned()),
            amplitude: match case.hidden {
                Hidden::Nothing => None,
                Hidden::Effect(_, size) | Hidden::Outside(_, size) => Some(size),
            },
            soil: case.soil.to_owned(),
            said,
            follow_up,
        }
    }

    /// What was hidden, if no effect is that.
    fn outside(&self) -> Option<Outside> {
        Outside::ALL.into_iter().find(|of| Some(of.name()) == self.hidden.as_deref())
    }
}

/// Rates, and what was said of each hidden effect how often.
pub(super) fn count(entries: &[Entry]) -> (Vec<Rate>, BTreeMap<String, BTreeMap<String, usize>>) {
    let entries: Vec<&Entry> = entries.iter().filter(|entry| entry.said.status != NO_FAILURES).collect();
    let (hidden, null): (Vec<&Entry>, Vec<&Entry>) = entries.iter().partition(|entry| entry.hidden.is_some());
    let (outside, hidden): (Vec<&Entry>, Vec<&Entry>) =
        hidden.into_iter().partition(|entry| entry.outside().is_some());
    let rate = |name: &str, of: &[&Entry], is: &dyn Fn(&Entry) -> bool| {
        let right = of.iter().filter(|entry| is(entry)).count();
        let share = (!of.is_empty()).then(|| right as f64 / of.len() as f64);
        Rate { name: name.to_owned(), rate: share, of: of.len() }
    };
    let is_first = |entry: &Entry| entry.said.given.first() == entry.hidden.as_ref();
    let in_set =
        |entry: &Entry| entry.hidden.as_ref().is_some_and(|id| entry.said.equivalence_set.contains(id));
    // A firm answer with an effect that is not hidden.
    let is_wrong = |said: &Said, entry: &Entry| said.is_firm() && !said.is_only(entry.hidden.as_ref());
    let followed: Vec<&Entry> = entries.iter().copied().filter(|entry| entry.follow_up.is_some()).collect();
    let after = |entry: &Entry, is: &dyn Fn(&Said) -> bool| entry.follow_up.as_ref().is_some_and(is);
    let found: Vec<((f64, f64), f64)> =
        hidden.iter().filter(|e| is_first(e)).filter_map(|e| e.said.found.zip(e.amplitude)).collect();
    let within = found.iter().filter(|((value, sd), truth)| (value - truth).abs() <= 2.0 * sd).count();
    let mut ratios: Vec<f64> = found.iter().map(|((value, _), truth)| value / truth).collect();
    let of_found =
        |name: &str, value: Option<f64>| Rate { name: name.to_owned(), rate: value, of: found.len() };
    let rates = vec![
        rate("nothing hidden: firm name", &null, &|entry| entry.said.is_firm()),
        rate("one effect hidden: right name first", &hidden, &is_first),
        rate("one effect hidden: right name in the set", &hidden, &in_set),
        rate("one effect hidden: firm wrong name", &hidden, &|entry| is_wrong(&entry.said, entry)),
        rate("outside the catalogue: unknown or provisional, over the right condition", &outside, &|entry| {
            entry.outside().is_some_and(|of| !entry.said.is_firm() && entry.said.is_over(of))
        }),
        rate("outside the catalogue: firm wrong name", &outside, &|entry| entry.said.is_firm()),
        rate("several left open, follow-up run: right name, firm", &followed, &|entry| {
            after(entry, &|said| {
                said.is_firm() && !said.given.is_empty() && said.is_only(entry.hidden.as_ref())
            })
        }),
        rate("several left open, follow-up run: right name first", &followed, &|entry| {
            after(entry, &|said| said.given.first() == entry.hidden.as_ref())
        }),
        rate("several left open, follow-up run: firm wrong name", &followed, &|entry| {
            after(entry, &|said| is_wrong(said, entry))
        }),
        of_found(
            "right name first: parameter within 2 sd",
            (!found.is_empty()).then(|| within as f64 / found.len() as f64),
        ),
        of_found(
            "right name first: median of parameter over truth",
            (!ratios.is_empty()).then(|| median(&mut ratios)),
        ),
    ];
    let mut confusion: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for entry in entries {
        let of = entry.hidden.clone().unwrap_or_else(|| "none".to_owned());
        *confusion.entry(of).or_default().entry(entry.said.in_words()).or_default() += 1;
    }
    (rates, confusion)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(hidden: Option<(&str, f64)>, status: &str, given: &[&str], found: Option<(f64, f64)>) -> Entry {
        let names = |ids: &[&str]| ids.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>();
        Entry {
            number: 0,
            hidden: hidden.map(|(id, _)| id.to_owned()),
            amplitude: hidden.map(|(_, size)| size),
            soil: "ticino_loose".to_owned(),
            said: Said {
                strokes: 12,
                status: status.to_owned(),
                given: names(given),
                equivalence_set: names(given),
                found,
            },
            follow_up: None,
        }
    }

    /// Two of nothing, one of them firmly named; of two effects one right and within 2 sd, one firmly taken for another; strokes that never
    /// failed count nowhere.
    #[test]
    fn rates_by_hand() {
        let (rates, confusion) = count(&[
            entry(None, "none", &[], None),
            entry(None, "named", &["backlash"], None),
            entry(Some(("force_bias", 0.2)), "ambiguous", &["force_bias", "backlash"], Some((0.3, 0.06))),
            entry(Some(("force_drift", 0.5)), "named", &["force_bias"], None),
            entry(Some(("force_drift", 0.5)), NO_FAILURES, &[], None),
        ]);
        let all: Vec<(Option<f64>, usize)> = rates.iter().map(|rate| (rate.rate, rate.of)).collect();
        let half = (Some(0.5), 2);
        let ratio = (Some(0.3 / 0.2), 1);
        let none = (None, 0);
        assert_eq!(all, [half, half, half, half, none, none, none, none, none, (Some(1.0), 1), ratio]);
        assert_eq!(confusion["none"]["named backlash"], 1);
        assert_eq!(confusion["force_drift"], BTreeMap::from([("named force_bias".to_owned(), 1)]));
    }

    /// Of two that were left open, one is told after its follow-up, and one is firmly taken for the other.
    #[test]
    fn follow_ups_by_hand() {
        let open = |given: &[&str]| {
            let mut of = entry(Some(("cohesion", 90.0)), "ambiguous", &["cohesion", "surcharge_heap"], None);
            of.follow_up = Some(entry(None, "named", given, None).said);
            of
        };
        let (rates, _) = count(&[open(&["cohesion"]), open(&["surcharge_heap"])]);
        let of =
            |name: &str| rates.iter().find(|rate| rate.name.ends_with(name)).map(|rate| (rate.rate, rate.of));
        for name in ["run: right name, firm", "run: right name first", "run: firm wrong name"] {
            assert_eq!(of(name), Some((Some(0.5), 2)), "{name}");
        }
    }

    /// A corner found over the two conditions in the other order is right, also beside an effect that is provisional; another condition is not, nor is
    /// a firm name, whatever stands beside it.
    #[test]
    fn shapes_by_hand() {
        let said = |status: &str, given: &[&str], set: &str| {
            let mut of = entry(Some(("outside_corner", -0.2)), status, given, None);
            of.said.equivalence_set.push(set.to_owned());
            of
        };
        let (rates, confusion) = count(&[
            said("unknown", &[], "unknown:depth_m x alpha_deg"),
            said("provisional", &["radius_dependence"], "unknown:alpha_deg x depth_m"),
            said("unknown", &[], "unknown:depth_m"),
            said("named", &["radius_dependence"], "unknown:alpha_deg x depth_m"),
        ]);
        let of = |name: &str| rates.iter().find(|rate| rate.name == name).map(|rate| (rate.rate, rate.of));
        assert_eq!(
            of("outside the catalogue: unknown or provisional, over the right condition"),
            Some((Some(0.5), 4))
        );
        assert_eq!(of("outside the catalogue: firm wrong name"), Some((Some(0.25), 4)));
        assert_eq!(of("one effect hidden: right name first"), Some((None, 0)));
        assert_eq!(confusion["outside_corner"]["unknown depth_m"], 1);
    }

    #[test]
    fn nothing_has_no_rates() {
        assert!(count(&[]).0.iter().all(|rate| rate.rate.is_none() && rate.of == 0));
    }
}
