//! What diagnoses of hidden campaigns said, counted.

use std::collections::{BTreeMap, BTreeSet};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_stats::median;

use super::super::self_test::Rate;
use super::hidden::{Case, joined};
use super::outside::Outside;
use crate::diagnose::{ChannelGapAnswer, Diagnosed};

/// Status of a campaign of which no stroke failed the soil.
const NO_FAILURES: &str = "no_failures";
/// What stands before the conditions of a shape without a name.
const UNKNOWN: &str = "unknown:";

/// One hidden campaign, and what was said of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Entry {
    /// Its number, from 0.
    pub number: u64,
    /// What was hidden: effects, or `outside_` and a kind that no effect is; empty for nothing.
    pub hidden: Vec<Part>,
    /// Preset of the soil.
    pub soil: String,
    /// What the campaign gave.
    #[serde(flatten)]
    pub said: Said,
    /// What it gave with the strokes that were proposed; null if none were, or they were not made.
    pub follow_up: Option<Said>,
}

/// A part of what was hidden.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Part {
    /// An effect, or `outside_` and a kind that no effect is.
    pub name: String,
    /// Amplitude of the effect in the unit of its parameter, or the largest change of ln force.
    pub amplitude: f64,
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
    /// Amplitudes that were found of hidden effects, each with its standard deviation, by effect.
    pub found: BTreeMap<String, (f64, f64)>,
    /// Root mean square of all readings of batches that were left out, in standard deviations, without and with the effects that were given; null with
    /// fewer than two batches.
    pub gap: Option<(f64, f64)>,
}

impl Said {
    pub(super) fn new(case: &Case, found: &Diagnosed) -> Self {
        let answer = &found.answer;
        let hidden = case.hidden.parts();
        let is_hidden = |id: &str| hidden.iter().any(|(name, _)| *name == id);
        Self {
            strokes: answer.strokes,
            status: answer.status.clone(),
            given: answer.effects.iter().map(|effect| effect.id.to_string()).collect(),
            equivalence_set: answer.equivalence_set.clone(),
            found: found
                .diagnosis
                .effects
                .iter()
                .filter(|of| is_hidden(of.id.name()))
                .map(|of| (of.id.to_string(), (of.amplitude, of.amplitude_sd)))
                .collect(),
            gap: gap(&answer.gap_by_channel),
        }
    }

    pub(super) fn without_failures() -> Self {
        Self {
            strokes: 0,
            status: NO_FAILURES.to_owned(),
            given: Vec::new(),
            equivalence_set: Vec::new(),
            found: BTreeMap::new(),
            gap: None,
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

    /// Whether every effect that is given was hidden.
    fn is_only(&self, hidden: &[Part]) -> bool {
        self.given.iter().all(|id| is_among(id, hidden))
    }
}

fn is_among(id: &str, hidden: &[Part]) -> bool {
    hidden.iter().any(|part| part.name == id)
}

/// Root mean square of the readings of all columns, without and with effects.
fn gap(columns: &[ChannelGapAnswer]) -> Option<(f64, f64)> {
    let readings: usize = columns.iter().map(|of| of.readings).sum();
    let all = |of: &dyn Fn(&ChannelGapAnswer) -> f64| {
        let squares: f64 = columns.iter().map(|column| column.readings as f64 * of(column).powi(2)).sum();
        (squares / readings as f64).sqrt()
    };
    (readings > 0).then(|| (all(&|of| of.before), all(&|of| of.after)))
}

impl Entry {
    pub(super) fn new(case: &Case, said: Said, follow_up: Option<Said>) -> Self {
        Self {
            number: case.number,
            hidden: case
                .hidden
                .parts()
                .into_iter()
                .map(|(name, amplitude)| Part { name: name.to_owned(), amplitude })
                .collect(),
            soil: case.soil.to_owned(),
            said,
            follow_up,
        }
    }

    /// Names of what was hidden, or `none`.
    #[must_use]
    pub fn hidden_name(&self) -> String {
        joined(&self.hidden.iter().map(|part| part.name.as_str()).collect::<Vec<_>>())
    }

    /// What was hidden, if no effect is that.
    fn outside(&self) -> Option<Outside> {
        Outside::ALL.into_iter().find(|of| is_among(of.name(), &self.hidden))
    }

    /// The only effect that was hidden.
    fn only(&self) -> Option<&Part> {
        match self.hidden.as_slice() {
            [one] => Some(one),
            _ => None,
        }
    }
}

/// A gap in standard deviations that is no more than scatter leaves: nothing to close.
const NO_GAP: f64 = 1.05;

/// Rates, and what was said of each hidden effect how often.
pub(super) fn count(entries: &[Entry]) -> (Vec<Rate>, BTreeMap<String, BTreeMap<String, usize>>) {
    let entries: Vec<&Entry> = entries.iter().filter(|entry| entry.said.status != NO_FAILURES).collect();
    let (null, hidden): (Vec<&Entry>, Vec<&Entry>) =
        entries.iter().partition(|entry| entry.hidden.is_empty());
    let (outside, hidden): (Vec<&Entry>, Vec<&Entry>) =
        hidden.into_iter().partition(|entry| entry.outside().is_some());
    let (single, two): (Vec<&Entry>, Vec<&Entry>) =
        hidden.iter().copied().partition(|entry| entry.only().is_some());
    let share = |name: &str, of: &[bool]| {
        let right = of.iter().filter(|is| **is).count();
        let rate = (!of.is_empty()).then(|| right as f64 / of.len() as f64);
        Rate { name: name.to_owned(), rate, of: of.len() }
    };
    let rate = |name: &str, of: &[&Entry], is: &dyn Fn(&Entry) -> bool| {
        share(name, &of.iter().map(|entry| is(entry)).collect::<Vec<_>>())
    };
    let is_first = |entry: &Entry| entry.said.given.first().is_some_and(|id| is_among(id, &entry.hidden));
    let in_set =
        |entry: &Entry| entry.only().is_some_and(|part| entry.said.equivalence_set.contains(&part.name));
    // A firm answer with an effect that is not hidden.
    let is_wrong = |said: &Said, entry: &Entry| said.is_firm() && !said.is_only(&entry.hidden);
    let recalled: Vec<bool> = two
        .iter()
        .flat_map(|entry| entry.hidden.iter().map(|part| entry.said.given.contains(&part.name)))
        .collect();
    let false_names: Vec<bool> =
        two.iter().flat_map(|entry| entry.said.given.iter().map(|id| !is_among(id, &entry.hidden))).collect();
    let followed: Vec<&Entry> = entries.iter().copied().filter(|entry| entry.follow_up.is_some()).collect();
    let after = |entry: &Entry, is: &dyn Fn(&Said) -> bool| entry.follow_up.as_ref().is_some_and(is);
    let right = || hidden.iter().filter(|entry| is_first(entry));
    let sizes = |entry: &Entry| -> Vec<((f64, f64), f64)> {
        let of = |part: &Part| Some((*entry.said.found.get(&part.name)?, part.amplitude));
        entry.hidden.iter().filter_map(of).collect()
    };
    let found: Vec<((f64, f64), f64)> = right().flat_map(|entry| sizes(entry)).collect();
    let mut ratios: Vec<f64> = found.iter().map(|((value, _), truth)| value / truth).collect();
    let mut closed: Vec<f64> = right()
        .filter_map(|entry| entry.said.gap)
        .filter(|(before, _)| *before > NO_GAP)
        .map(|(before, after)| (before - after) / (before - 1.0))
        .collect();
    let middle = |name: &str, values: &mut Vec<f64>| {
        let of = values.len();
        Rate { name: name.to_owned(), rate: (of > 0).then(|| median(values)), of }
    };
    let rates = vec![
        rate("nothing hidden: firm name", &null, &|entry| entry.said.is_firm()),
        rate("one effect hidden: right name first", &single, &is_first),
        rate("one effect hidden: right name in the set", &single, &in_set),
        rate("one effect hidden: firm wrong name", &single, &|entry| is_wrong(&entry.said, entry)),
        share("two effects hidden: recall", &recalled),
        share("two effects hidden: false among names given", &false_names),
        rate("two effects hidden: firm wrong name", &two, &|entry| is_wrong(&entry.said, entry)),
        rate("outside the catalogue: unknown or provisional, over the right condition", &outside, &|entry| {
            entry.outside().is_some_and(|of| !entry.said.is_firm() && entry.said.is_over(of))
        }),
        rate("outside the catalogue: firm wrong name", &outside, &|entry| entry.said.is_firm()),
        rate("several left open, follow-up run: right name, firm", &followed, &|entry| {
            after(entry, &|said| said.is_firm() && !said.given.is_empty() && said.is_only(&entry.hidden))
        }),
        rate("several left open, follow-up run: right name first", &followed, &|entry| {
            after(entry, &|said| said.given.first().is_some_and(|id| is_among(id, &entry.hidden)))
        }),
        rate("several left open, follow-up run: firm wrong name", &followed, &|entry| {
            after(entry, &|said| is_wrong(said, entry))
        }),
        share(
            "right name first: parameter within 2 sd",
            &found.iter().map(|((value, sd), truth)| (value - truth).abs() <= 2.0 * sd).collect::<Vec<_>>(),
        ),
        middle("right name first: median of parameter over truth", &mut ratios),
        middle("right name first: median share of the held-out gap that is closed", &mut closed),
    ];
    let mut confusion: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for entry in entries {
        *confusion.entry(entry.hidden_name()).or_default().entry(entry.said.in_words()).or_default() += 1;
    }
    (rates, confusion)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(hidden: &[(&str, f64)], status: &str, given: &[&str], found: &[(&str, (f64, f64))]) -> Entry {
        let names = |ids: &[&str]| ids.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>();
        let part = |(name, amplitude): &(&str, f64)| Part { name: (*name).to_owned(), amplitude: *amplitude };
        Entry {
            number: 0,
            hidden: hidden.iter().map(part).collect(),
            soil: "ticino_loose".to_owned(),
            said: Said {
                strokes: 12,
                status: status.to_owned(),
                given: names(given),
                equivalence_set: names(given),
                found: found.iter().map(|(id, of)| ((*id).to_owned(), *of)).collect(),
                gap: None,
            },
            follow_up: None,
        }
    }

    /// The rate of this name, and what is behind it.
    fn rate(entries: &[Entry], name: &str) -> (Option<f64>, usize) {
        let rates = count(entries).0;
        let of = rates.iter().find(|rate| rate.name.ends_with(name)).unwrap_or_else(|| panic!("{name}"));
        (of.rate, of.of)
    }

    /// Two of nothing, one of them firmly named; of two effects one right and within 2 sd, one firmly taken for another; strokes that never
    /// failed count nowhere.
    #[test]
    fn rates_by_hand() {
        let entries = [
            entry(&[], "none", &[], &[]),
            entry(&[], "named", &["backlash"], &[]),
            entry(
                &[("force_bias", 0.2)],
                "ambiguous",
                &["force_bias", "backlash"],
                &[("force_bias", (0.3, 0.06))],
            ),
            entry(&[("force_drift", 0.5)], "named", &["force_bias"], &[]),
            entry(&[("force_drift", 0.5)], NO_FAILURES, &[], &[]),
        ];
        for name in [
            "nothing hidden: firm name",
            "one effect hidden: right name first",
            "one effect hidden: right name in the set",
            "one effect hidden: firm wrong name",
        ] {
            assert_eq!(rate(&entries, name), (Some(0.5), 2), "{name}");
        }
        assert_eq!(rate(&entries, "parameter within 2 sd"), (Some(1.0), 1));
        assert_eq!(rate(&entries, "median of parameter over truth"), (Some(0.3 / 0.2), 1));
        let (rates, confusion) = count(&entries);
        assert_eq!(rates.iter().filter(|rate| rate.of > 0).count(), 6);
        assert_eq!(confusion["none"]["named backlash"], 1);
        assert_eq!(confusion["force_drift"], BTreeMap::from([("named force_bias".to_owned(), 1)]));
    }

    /// Of four effects in two pairs three are given, beside one that is not hidden; both sizes of the first pair count. A gap that goes from 5 to 2 where
    /// scatter leaves 1 is closed by three quarters.
    #[test]
    fn pairs_and_gaps_by_hand() {
        let pair = [("force_bias", 0.2), ("backlash", 1e-3)];
        let sizes = [("force_bias", (0.2, 0.01)), ("backlash", (0.9e-3, 0.04e-3))];
        let mut both = entry(&pair, "named", &["force_bias", "backlash"], &sizes);
        both.said.gap = Some((5.0, 2.0));
        let mut other = entry(&pair, "ambiguous", &["cable_flex", "backlash"], &[]);
        other.said.gap = Some((5.0, 1.0));
        let entries = [both, other];
        assert_eq!(rate(&entries, "two effects hidden: recall"), (Some(0.75), 4));
        assert_eq!(rate(&entries, "two effects hidden: false among names given"), (Some(0.25), 4));
        assert_eq!(rate(&entries, "two effects hidden: firm wrong name"), (Some(0.0), 2));
        assert_eq!(rate(&entries, "one effect hidden: right name first"), (None, 0));
        assert_eq!(rate(&entries, "parameter within 2 sd"), (Some(0.5), 2));
        assert_eq!(rate(&entries, "held-out gap that is closed"), (Some(0.75), 1));
        assert_eq!(count(&entries).1["force_bias+backlash"]["named force_bias"], 1);
        let column = |readings, before, after| ChannelGapAnswer {
            channel: "ln_force".to_owned(),
            readings,
            before,
            after,
            delta_elpd: 0.0,
            delta_elpd_se: 0.0,
        };
        assert_eq!(gap(&[column(3, 3.0, 1.0), column(1, 13.0, 1.0)]), Some((7.0, 1.0)));
        assert_eq!(gap(&[]), None);
    }

    /// Of two that were left open, one is told after its follow-up, and one is firmly taken for the other.
    #[test]
    fn follow_ups_by_hand() {
        let open = |given: &[&str]| {
            let mut of = entry(&[("cohesion", 90.0)], "ambiguous", &["cohesion", "surcharge_heap"], &[]);
            of.follow_up = Some(entry(&[], "named", given, &[]).said);
            of
        };
        let entries = [open(&["cohesion"]), open(&["surcharge_heap"])];
        for name in ["run: right name, firm", "run: right name first", "run: firm wrong name"] {
            assert_eq!(rate(&entries, name), (Some(0.5), 2), "{name}");
        }
    }

    /// A corner found over the two conditions in the other order is right, also beside an effect that is provisional; another condition is not, nor is
    /// a firm name, whatever stands beside it.
    #[test]
    fn shapes_by_hand() {
        let said = |status: &str, given: &[&str], set: &str| {
            let mut of = entry(&[("outside_corner", -0.2)], status, given, &[]);
            of.said.equivalence_set.push(set.to_owned());
            of
        };
        let entries = [
            said("unknown", &[], "unknown:depth_m x alpha_deg"),
            said("provisional", &["radius_dependence"], "unknown:alpha_deg x depth_m"),
            said("unknown", &[], "unknown:depth_m"),
            said("named", &["radius_dependence"], "unknown:alpha_deg x depth_m"),
        ];
        assert_eq!(rate(&entries, "unknown or provisional, over the right condition"), (Some(0.5), 4));
        assert_eq!(rate(&entries, "outside the catalogue: firm wrong name"), (Some(0.25), 4));
        assert_eq!(rate(&entries, "one effect hidden: right name first"), (None, 0));
        assert_eq!(count(&entries).1["outside_corner"]["unknown depth_m"], 1);
    }

    #[test]
    fn nothing_has_no_rates() {
        assert!(count(&[]).0.iter().all(|rate| rate.rate.is_none() && rate.of == 0));
    }
}
