//! How what single strokes of a simulated arm showed is carried over to the strokes of a campaign.

use std::collections::BTreeMap;

use soilctl_effects::Channel;
use soilctl_strokes::StrokeRow;

use crate::data::Data;
use crate::learnt::Shown;
use crate::unsteadiness::Unsteadiness;

/// A tool angle (deg), radius and depth (both relative) by which a stroke is as much another one as by each of the others.
const APART: [f64; 3] = [5.0, 0.3, 0.3];

/// Differences to the same strokes without the effect, at one amplitude.
#[derive(Debug, Clone)]
pub(crate) struct Node {
    pub(crate) amplitude: f64,
    /// Of ln of force over squared depth, by stroke of the campaign.
    pub(crate) ln_force: Vec<f64>,
    pub(crate) channels: BTreeMap<Channel, Vec<f64>>,
}

/// How what single strokes of a few kinds showed is carried over to the strokes of a campaign.
pub(crate) struct Transfer<'a> {
    pub(crate) data: &'a Data,
    /// The single strokes without the effect.
    pub(crate) plain: &'a Data,
    /// What the catalogue says that a column of a stroke shows of an amplitude, if it does.
    pub(crate) formula: &'a dyn Fn(&Data, usize, Channel, f64) -> Option<f64>,
    /// By how much single strokes go their own way.
    pub(crate) unsteadiness: &'a Unsteadiness,
}

impl Transfer<'_> {
    /// Responses at each amplitude, for every stroke of the campaign.
    pub(crate) fn nodes(&self, shown: &[Shown<'_>]) -> Vec<Node> {
        let Self { plain, unsteadiness, .. } = *self;
        let mut nodes: Vec<Node> = shown
            .iter()
            .map(|shown| Node { amplitude: shown.amplitude, ln_force: Vec::new(), channels: BTreeMap::new() })
            .collect();
        // Depths are recorded: what a plate that rises or sinks loses of its force by the square of its depth, the force model knows.
        let at_depth = |data: &Data, k: usize| Some(data.ln_force[k] - 2.0 * data.rows[k].depth_m.ln());
        let forces = self.differences(shown, &at_depth);
        let variance = unsteadiness.mean_variance(None).max(bent(shown, &forces));
        for (node, differences) in nodes.iter_mut().zip(&forces) {
            node.ln_force = self.carried(differences, &|_, _| None, variance);
        }
        for channel in plain.channels.keys() {
            if shown.iter().any(|shown| !shown.with.channels.contains_key(channel)) {
                continue;
            }
            let of = self.differences(shown, &|data, k| data.channels.get(channel)?[k]);
            let variance = unsteadiness.mean_variance(Some(*channel)).max(bent(shown, &of));
            for (node, differences) in nodes.iter_mut().zip(&of) {
                let amplitude = node.amplitude;
                let formula = |data: &Data, stroke| (self.formula)(data, stroke, *channel, amplitude);
                node.channels.insert(*channel, self.carried(differences, &formula, variance));
            }
        }
        nodes
    }

    /// What a signal of the single strokes differs by from `plain`, at each amplitude: place of a stroke in `plain`, and value.
    fn differences(
        &self,
        shown: &[Shown<'_>],
        signal: &dyn Fn(&Data, usize) -> Option<f64>,
    ) -> Vec<Vec<(usize, f64)>> {
        let of = |shown: &Shown<'_>| {
            let rows = self.plain.rows.iter().enumerate();
            let difference = |(i, row): (usize, &StrokeRow)| {
                Some((i, signal(shown.with, shown.with.place_of(row)?)? - signal(self.plain, i)?))
            };
            rows.filter_map(difference).collect()
        };
        shown.iter().map(of).collect()
    }

    /// A response of every stroke of the campaign, from differences of single strokes (place in `plain`, value): a part that all share, which goes as the
    /// formula goes from stroke to stroke if there is one, and what the single stroke that is most like it has beyond. Either part is drawn to nothing
    /// by the share of its square that is to be expected of strokes that go their own way, of which a difference has this variance (James & Stein 1961).
    fn carried(
        &self,
        differences: &[(usize, f64)],
        formula: &dyn Fn(&Data, usize) -> Option<f64>,
        variance: f64,
    ) -> Vec<f64> {
        let pattern = |data: &Data, stroke: usize| formula(data, stroke).unwrap_or(1.0);
        let sum = |of: &dyn Fn(usize, f64) -> f64| differences.iter().map(|&(i, d)| of(i, d)).sum::<f64>();
        let square = sum(&|i, _| pattern(self.plain, i).powi(2));
        let share = if square > 0.0 { sum(&|i, d| d * pattern(self.plain, i)) / square } else { 0.0 };
        let common = kept(share * share * square, variance) * share;
        let beyond = |i: usize, d: f64| d - share * pattern(self.plain, i);
        let freedom = differences.len().saturating_sub(1).max(1) as f64;
        let own = kept(sum(&|i, d| beyond(i, d).powi(2)) / freedom, variance);
        let of_stroke = |(stroke, row): (usize, &StrokeRow)| {
            let apart = |&(i, _): &(usize, f64)| distance(row, &self.plain.rows[i]);
            let like = differences.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            like.map_or(0.0, |&(i, d)| common * pattern(self.data, stroke) + own * beyond(i, d))
        };
        self.data.rows.iter().enumerate().map(of_stroke).collect()
    }
}

/// Share of a value that is kept, by its square and what chance alone is expected to make of that.
pub(crate) fn kept(square: f64, chance: f64) -> f64 {
    if square > chance { 1.0 - chance / square } else { 0.0 }
}

/// Variance of a difference by what differences at two amplitudes of a sign are not in proportion: half of it is the stroke's without the effect, which
/// both have.
fn bent(shown: &[Shown<'_>], differences: &[Vec<(usize, f64)>]) -> f64 {
    let (mut squares, mut count) = (0.0, 0);
    for (k, small) in shown.iter().enumerate() {
        for (l, large) in shown.iter().enumerate() {
            let ratio = large.amplitude / small.amplitude;
            if ratio <= 1.0 {
                continue;
            }
            for (i, a) in &differences[k] {
                let Some((_, b)) = differences[l].iter().find(|(j, _)| j == i) else { continue };
                squares += 2.0 * (b - ratio * a).powi(2) / (1.0 + ratio * ratio + (ratio - 1.0).powi(2));
                count += 1;
            }
        }
    }
    squares / f64::from(count.max(1))
}

/// How little two strokes are alike, from 0.
fn distance(a: &StrokeRow, b: &StrokeRow) -> f64 {
    let relative = |a: f64, b: f64| (a - b) / a.max(b).max(f64::MIN_POSITIVE);
    let radius = a.radius_m.zip(b.radius_m).map_or(0.0, |(a, b)| relative(a, b));
    let parts = [a.alpha_deg - b.alpha_deg, radius, relative(a.depth_m, b.depth_m)];
    parts.iter().zip(APART).map(|(part, apart)| (part / apart).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    /// A stroke that differs by 1 and, at twice the amplitude, by 3 instead of 2: a square of 1, of a sum of variances 1 + 2² + (2 - 1)², of which a
    /// difference has 2. What goes in proportion, and another sign, say nothing.
    #[test]
    fn what_is_not_in_proportion_is_chance() {
        let with = Data::new(
            "t",
            vec![StrokeRow {
                alpha_deg: 90.0,
                depth_m: 0.02,
                width_m: 0.1,
                force_n: 5.0,
                ..StrokeRow::default()
            }],
            soilctl_strokes::Campaign::default(),
        )
        .unwrap();
        let shown = [1.0, 2.0, -1.0].map(|amplitude| Shown { amplitude, with: &with });
        let of = |at_two: f64| [vec![(0, 1.0)], vec![(0, at_two)], vec![(0, 7.0)]];
        assert!((bent(&shown, &of(3.0)) - 1.0 / 3.0).abs() < 1e-15);
        assert_eq!((bent(&shown, &of(2.0)), bent(&shown[..1], &of(3.0)[..1])), (0.0, 0.0));
    }
}
