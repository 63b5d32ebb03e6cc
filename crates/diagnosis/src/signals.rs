//! How far what was measured is from what a simulated arm read in the same strokes, signal by signal.

use soilctl_effects::Channel;

use crate::channels::spread;
use crate::data::Data;
use crate::traces::Phase;

/// Fewest strokes that say how a signal scatters.
const FEWEST: usize = 4;

/// The gap of one signal, in standard deviations of its scatter from stroke to stroke.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalGap {
    /// Column of the stroke table, or of the traces.
    pub signal: String,
    /// Part of the stroke; `None` of the column itself.
    pub phase: Option<Phase>,
    /// Strokes that have it in both.
    pub strokes: usize,
    /// Root mean square of measured minus simulated without the effects that were found.
    pub before: f64,
    /// The same with them; `None` if they were not simulated.
    pub after: Option<f64>,
}

/// The gaps of all signals that measured strokes and simulated ones share; the force goes as its logarithm. Strokes are found by their names.
///
/// The scatter is that of the differences about their median (1.4826 times the median absolute deviation), the smaller one of without and
/// with effects, since an effect that goes from stroke to stroke widens it.
#[must_use]
pub fn signal_gaps(data: &Data, before: &Data, after: Option<&Data>) -> Vec<SignalGap> {
    let signals = Signal::all(data);
    signals
        .into_iter()
        .filter_map(|signal| {
            let without = signal.differences(data, before);
            let with = after.map(|after| signal.differences(data, after));
            let scatters = [Some(&without), with.as_ref()].into_iter().flatten();
            let scatter =
                scatters.filter(|all| all.len() >= FEWEST).map(|all| spread(all)).reduce(f64::min)?;
            let rms = |all: &[f64]| {
                let squares = all.iter().map(|difference| (difference / scatter).powi(2)).sum::<f64>();
                (squares / all.len() as f64).sqrt()
            };
            let before = rms(&without);
            let after = with.filter(|all| all.len() >= FEWEST).map(|all| rms(&all));
            let finite = before.is_finite() && after.is_none_or(f64::is_finite);
            let (signal, phase) = signal.name();
            finite.then_some(SignalGap { signal, phase, strokes: without.len(), before, after })
        })
        .collect()
}

/// One number a stroke.
enum Signal {
    Force,
    Column(Channel),
    Phase(&'static str, Phase),
}

impl Signal {
    fn all(data: &Data) -> Vec<Self> {
        let columns = data.channels.keys().map(|channel| Self::Column(*channel));
        let phases = data.phases.keys().map(|(name, phase)| Self::Phase(name, *phase));
        std::iter::once(Self::Force).chain(columns).chain(phases).collect()
    }

    fn name(&self) -> (String, Option<Phase>) {
        match self {
            Self::Force => ("force_n".to_owned(), None),
            Self::Column(channel) => (channel.column().to_owned(), None),
            Self::Phase(name, phase) => ((*name).to_owned(), Some(*phase)),
        }
    }

    fn of(&self, data: &Data, stroke: usize) -> Option<f64> {
        match self {
            Self::Force => data.ln_force.get(stroke).copied(),
            Self::Column(channel) => {
                let in_table = || channel.of(data.rows.get(stroke)?);
                data.channels.get(channel).and_then(|cells| *cells.get(stroke)?).or_else(in_table)
            }
            Self::Phase(name, phase) => *data.phases.get(&(*name, *phase))?.get(stroke)?,
        }
    }

    fn differences(&self, data: &Data, simulated: &Data) -> Vec<f64> {
        let difference = |(i, row): (usize, &soilctl_strokes::StrokeRow)| {
            let j = simulated.place_of(row)?;
            Some(self.of(data, i)? - self.of(simulated, j)?)
        };
        data.rows.iter().enumerate().filter_map(difference).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    fn data(force_n: impl Fn(usize) -> f64, air_n: impl Fn(usize) -> f64) -> Data {
        let row = |i: usize| StrokeRow {
            stroke_id: Some(format!("s{i}")),
            alpha_deg: 90.0,
            depth_m: 0.02,
            width_m: 0.1,
            force_n: force_n(i),
            air_across_n: Some(air_n(i)),
            ..StrokeRow::default()
        };
        let mut data = Data::new("t", (0..9).map(row).collect(), Campaign::default()).unwrap();
        data.compare_everything();
        data
    }

    /// Differences of -0.2 to 0.2 with a median deviation of 0.1 scatter by 0.14826; a shift of 1 N is 6.7 of that.
    #[test]
    fn gaps_are_in_standard_deviations() {
        let noise = |i: usize| 0.05 * (i as f64 - 4.0);
        let plain = data(|_| 10.0, |_| 0.0);
        let measured = data(|_| 10.0, |i| 1.0 + noise(i));
        let with = data(|_| 10.0, |_| 1.0);
        let gaps = signal_gaps(&measured, &plain, Some(&with));
        let air = gaps.iter().find(|gap| gap.signal == "air_across_n").unwrap();
        let scatter = 1.4826 * 0.1;
        let squares = (0..9).map(|i| (1.0 + noise(i)).powi(2)).sum::<f64>();
        assert!((air.before - (squares / 9.0).sqrt() / scatter).abs() < 1e-9, "{air:?}");
        assert!(air.after.unwrap() < 1.0 && air.strokes == 9);
        // Forces that are all the same have no scatter to be measured by.
        assert!(gaps.iter().all(|gap| gap.signal != "force_n"));
    }
}
