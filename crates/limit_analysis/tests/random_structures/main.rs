//! Random ground with every kind of structure in it, and of every law of strength: lower bounds are below upper ones, and what is stronger
//! bears no less.
//!
//! What is asserted is order, not tightness, so each problem is solved on one coarse mesh. A comparison counts only where both of its sides
//! are proven.
#![allow(clippy::unwrap_used, reason = "tests")]

mod bodies;
mod draw;
mod ground;
mod kinds;
mod stronger;

use std::collections::BTreeMap;

use draw::Draw;
use soilctl_limit_analysis::{Description, LimitError, OneSide, Options, bound};

/// Element steps: no more than the first mesh, of some 600 elements, is paid for.
const WORK: u64 = 1;
/// Strengths of each problem that are made greater, one at a time.
const STRENGTHS: usize = 1;

/// Proven bounds in the units of the problem; infinite where there is none.
fn bounds(it: &Description) -> Result<[f64; 2], LimitError> {
    let described = it.described()?;
    let options = Options { max_work: WORK, ..Options::default() };
    let bounds = match bound(&described.problem()?, &options, &mut |_, _| {}) {
        Ok(found) => [found.lower.value, found.upper.value],
        Err(LimitError::NothingProven { proven, .. }) => match proven {
            Some(OneSide::Lower(lower)) => [lower, f64::INFINITY],
            Some(OneSide::Upper(upper)) => [f64::NEG_INFINITY, upper],
            None => [f64::NEG_INFINITY, f64::INFINITY],
        },
        Err(other) => return Err(other),
    };
    Ok(described.in_units(bounds))
}

/// What was compared, and how often it was in order.
#[derive(Default)]
struct Tally {
    /// Problems of each kind with both bounds, with one, and with a comparison that counts.
    kinds: BTreeMap<&'static str, [usize; 3]>,
    /// Comparisons that count, of each strength.
    strengths: BTreeMap<&'static str, usize>,
    /// Refused in words, or without a load at which they fail.
    refused: BTreeMap<String, usize>,
    gaps: Vec<f64>,
    wrong: Vec<String>,
}

impl Tally {
    fn problem(&mut self, seed: u64) {
        let mut draw = Draw::new(seed);
        let (kind, it) = kinds::any(&mut draw);
        let weak = match bounds(&it) {
            Ok(weak) => weak,
            Err(why) => {
                *self.refused.entry(format!("{kind}: {why}")).or_default() += 1;
                return;
            }
        };
        let both = weak.iter().all(|bound| bound.is_finite());
        let mut counts = both;
        if both {
            self.gaps.push((weak[1] - weak[0]) / (0.5 * (weak[0].abs() + weak[1].abs())));
        }
        if weak[0] > weak[1] {
            self.tell(format!("{seed}, {kind}: {weak:?}"));
        }
        let mut strengths = stronger::strengths(&it);
        for _ in 0..STRENGTHS.min(strengths.len()) {
            let (name, more) = strengths.swap_remove(draw.index(strengths.len()));
            let mut strong = it.clone();
            more(&mut strong);
            let strong = match bounds(&strong) {
                Ok(strong) => strong,
                // Stronger, it may bear anything.
                Err(LimitError::NoCollapse { .. }) => continue,
                Err(why) => {
                    self.tell(format!("{seed}, {kind}, {name}: {why}"));
                    continue;
                }
            };
            if strong[0] > strong[1] || weak[0] > strong[1] {
                self.tell(format!("{seed}, {kind}, {name}: {weak:?}, stronger {strong:?}"));
            }
            if weak[0].is_finite() && strong[1].is_finite() {
                counts = true;
                *self.strengths.entry(name).or_default() += 1;
            }
        }
        let of_kind = self.kinds.entry(kind).or_default();
        of_kind[usize::from(!both)] += 1;
        of_kind[2] += usize::from(counts);
    }

    /// What must not be, at once: the rest may take long.
    fn tell(&mut self, wrong: String) {
        eprintln!("WRONG {wrong}");
        self.wrong.push(wrong);
    }

    fn counted(&self) -> usize {
        self.kinds.values().map(|of_kind| of_kind[2]).sum()
    }

    /// In a few lines, also on the way, since a thousand take long.
    fn print(&mut self) {
        for (kind, [both, one, counted]) in &self.kinds {
            eprintln!("{kind}: both bounds of {both}, not both of {one}, {counted} count");
        }
        for (name, count) in &self.strengths {
            eprintln!("  {name}: {count}");
        }
        for (why, count) in &self.refused {
            eprintln!("refused {count}: {why}");
        }
        self.gaps.sort_by(f64::total_cmp);
        if let Some(median) = self.gaps.get(self.gaps.len() / 2) {
            eprintln!("median gap {median}");
        }
    }
}

/// `STRUCTURES` is how many shall count, `STRUCTURES_FROM` the seed of the first.
#[test]
fn what_is_stronger_bears_no_less() {
    let asked =
        |name: &str, ordinary: u64| std::env::var(name).map_or(ordinary, |count| count.parse().unwrap());
    let (ordinary, first) = (asked("STRUCTURES", 5) as usize, asked("STRUCTURES_FROM", 0));
    let mut tally = Tally::default();
    // Those that are refused, or of which nothing is proven, do not count.
    let mut seed = first;
    while tally.counted() < ordinary {
        tally.problem(seed);
        seed += 1;
        if (seed - first).is_multiple_of(100) {
            eprintln!("{} of {} count", tally.counted(), seed - first);
            tally.print();
        }
        assert!(seed - first < 20 + 2 * ordinary as u64, "too few count");
    }
    tally.print();
    assert!(tally.wrong.is_empty(), "{} of {seed}: {:#?}", tally.wrong.len(), tally.wrong);
}
