//! What makes a stroke doubtful: said as flags in its row, or a reason to refuse it.

use super::survey::Survey;
use soilctl_motion::Series;

/// So many equal readings in a row at the end of an axis's range are a sensor that can't follow.
const CLIPPED: usize = 5;
/// Wrenches that are missing for longer than this while the force rises are a gap, in s, and than ten intervals.
const GAP_S: f64 = 0.1;
const GAP_INTERVALS: f64 = 10.0;

/// What a flag of a stroke in a log of another program says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Doubt {
    /// Readings stand still at the end of their range.
    Clipped,
    /// Wrenches or joint states are missing while the force rises.
    Gap,
    /// A clock was set during the contact.
    Clock,
    /// The tare is uncertain by more than 3 % of the force.
    Tare,
    /// Most of that is from a weight that free air does not tell, having one posture.
    Posture,
    /// Fewer than half of the contacts gave a stroke.
    FewStrokes,
}

impl Doubt {
    /// As it stands in tables.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Clipped => "clipped",
            Self::Gap => "gap",
            Self::Clock => "clock",
            Self::Tare => "tare",
            Self::Posture => "posture",
            Self::FewStrokes => "few_strokes",
        }
    }
}

/// Values at which axes of a sensor stand still at the ends of their range: the lowest and the highest of each force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Stops {
    low: [Option<f64>; 3],
    high: [Option<f64>; 3],
}

impl Stops {
    /// From all readings of a log. A sensor whose readings never change has none.
    pub(crate) fn of(wrenches: &Series<[f64; 6]>) -> Self {
        let mut stops = Self::default();
        for axis in 0..3 {
            let values = || wrenches.values.iter().map(|wrench| wrench[axis]);
            let (low, high) =
                values().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            if high <= low {
                continue;
            }
            stops.low[axis] = stands(values(), low).then_some(low);
            stops.high[axis] = stands(values(), high).then_some(high);
        }
        stops
    }

    /// Whether readings are at an end.
    pub(crate) fn hit(&self, wrenches: &[[f64; 6]]) -> bool {
        (0..3).any(|axis| {
            let at = |end: Option<f64>| {
                end.is_some_and(|end| wrenches.iter().filter(|wrench| wrench[axis] == end).count() >= CLIPPED)
            };
            at(self.low[axis]) || at(self.high[axis])
        })
    }
}

/// Whether values stand at `end` for several readings in a row, while other readings are hardly ever the same twice.
fn stands(values: impl Iterator<Item = f64>, end: f64) -> bool {
    let (mut at_end, mut longest, mut same, mut others, mut before) = (0, 0, 0_u64, 0_u64, None);
    for value in values {
        at_end = if value == end { at_end + 1 } else { 0 };
        longest = longest.max(at_end);
        if value != end {
            others += 1;
            same += u64::from(before == Some(value));
        }
        before = Some(value);
    }
    // Coarse steps of a sensor repeat everywhere.
    longest >= CLIPPED && 4 * same < others
}

/// Longest time without wrenches between two times, if it is longer than usual, in s.
pub(crate) fn gap(survey: &Survey, from_s: f64, to_s: f64) -> Option<f64> {
    let most_s = GAP_S.max(GAP_INTERVALS * survey.interval_s);
    let within = survey.gaps.iter().filter(|[begin, end]| *begin < to_s && *end > from_s);
    within.map(|[begin, end]| end - begin).filter(|length| *length > most_s).max_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(values: impl Iterator<Item = f64>) -> Series<[f64; 6]> {
        let values: Vec<_> = values.map(|value| [value, 0.0, 0.0, 0.0, 0.0, 0.0]).collect();
        Series { t_s: (0..values.len()).map(|k| k as f64).collect(), values }
    }

    #[test]
    fn readings_that_stand_at_the_end_are_clipped() {
        let wave = |k: i32| 10.0 * (f64::from(k) * 0.01).sin() + 0.01 * (f64::from(k) * 1.7).sin();
        let free = series((0..2000).map(wave));
        assert!(!Stops::of(&free).hit(&free.values));
        let cut = series((0..2000).map(|k| wave(k).min(8.0)));
        let stops = Stops::of(&cut);
        assert!(stops.hit(&cut.values));
        assert!(!stops.hit(&cut.values[300..500]), "where it is far from its end");
        let coarse = series((0..2000).map(|k| wave(k).round()));
        assert!(!Stops::of(&coarse).hit(&coarse.values));
        let dead = series((0..100).map(|_| 1.0));
        assert!(!Stops::of(&dead).hit(&dead.values));
    }
}
