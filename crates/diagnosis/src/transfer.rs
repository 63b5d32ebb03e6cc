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
    /// Responses at one amplitude, for every stroke of the campaign.
    pub(crate) fn node(&self, shown: &Shown<'_>) -> Node {
        let Self { plain, unsteadiness, .. } = *self;
        let (amplitude, with) = (shown.amplitude, shown.with);
        let rows = plain.rows.iter().enumerate();
        let pairs: Vec<(usize, usize)> = rows.filter_map(|(i, row)| Some((i, with.place_of(row)?))).collect();
        let of = |has: &dyn Fn(usize, usize) -> Option<f64>| -> Vec<(usize, f64)> {
            pairs.iter().filter_map(|&(i, j)| Some((i, has(i, j)?))).collect()
        };
        // Depths are recorded: what a plate that rises or sinks loses of its force by the square of its depth, the force model knows.
        let at_depth = |data: &Data, k: usize| data.ln_force[k] - 2.0 * data.rows[k].depth_m.ln();
        let forces = of(&|i, j| Some(at_depth(with, j) - at_depth(plain, i)));
        let ln_force = self.carried(&forces, &|_, _| None, unsteadiness.mean_variance(None));
        let channels = plain.channels.iter().filter_map(|(channel, before)| {
            let after = with.channels.get(channel)?;
            let differences = of(&|i, j| Some(after[j]? - before[i]?));
            let formula = |data: &Data, stroke| (self.formula)(data, stroke, *channel, amplitude);
            Some((*channel, self.carried(&differences, &formula, unsteadiness.mean_variance(Some(*channel)))))
        });
        let channels = channels.collect();
        Node { amplitude, ln_force, channels }
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
        let kept = |square: f64, noise: f64| if square > noise { 1.0 - noise / square } else { 0.0 };
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

/// How little two strokes are alike, from 0.
fn distance(a: &StrokeRow, b: &StrokeRow) -> f64 {
    let relative = |a: f64, b: f64| (a - b) / a.max(b).max(f64::MIN_POSITIVE);
    let radius = a.radius_m.zip(b.radius_m).map_or(0.0, |(a, b)| relative(a, b));
    let parts = [a.alpha_deg - b.alpha_deg, radius, relative(a.depth_m, b.depth_m)];
    parts.iter().zip(APART).map(|(part, apart)| (part / apart).powi(2)).sum()
}
