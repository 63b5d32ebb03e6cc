//! What a simulated arm shows of an effect, stroke by stroke and signal by signal, in place of the catalogue's formulas: these do not
//! know what the controller makes of it.

use soilctl_effects::{Channel, Effect, EffectId, Stroke};

use crate::data::Data;
use crate::transfer::{Node, Transfer};
use crate::unsteadiness::Unsteadiness;

/// A response counts if it is this part of what the readings of a column scatter by, root mean square over the strokes at the largest
/// amplitude that was simulated: less is noise of the simulation. Empirical.
const LEAST_SHARE: f64 = 0.25;
/// Part of the square of a response by which the larger amplitude of a sign may differ from the smaller one in proportion. More is no response,
/// but a stroke that went another way for reasons of its own. Empirical.
const MOST_BENT: f64 = 0.5;
/// Strokes of a simulated arm with an effect of one amplitude.
#[derive(Debug, Clone, Copy)]
pub struct Shown<'a> {
    /// Amplitude in the unit of the effect's parameter, not 0.
    pub amplitude: f64,
    /// What the arm's logs gave.
    pub with: &'a Data,
}

/// Responses of all strokes of a campaign to an effect.
#[derive(Debug, Clone)]
pub struct Learnt {
    /// By size of the amplitude, for both signs.
    nodes: Vec<Node>,
    /// Share of the amplitude that acts on each stroke.
    local: Vec<f64>,
    /// Columns that show it.
    channels: Vec<Channel>,
    /// Of a setting.
    alike: Option<Node>,
    /// Amplitude that the arm has that told what to expect: responses are what readings differ by from there.
    about: f64,
}

impl Learnt {
    /// Responses of the strokes of `data`, from those few that were simulated without the effect (`plain`) and with it, by the same
    /// noise. Each stroke of the campaign takes those of the simulated stroke that is most like it.
    ///
    /// An effect that grows with time acts on a stroke with the share of its amplitude that is reached then: `shown` has it as it is at
    /// the end.
    #[must_use]
    pub fn new(effect: &'static Effect, data: &Data, plain: &Data, shown: &[Shown<'_>]) -> Self {
        let local = data.strokes.iter().map(|stroke| share(effect, stroke)).collect();
        let formula = |data: &Data, stroke: usize, channel: Channel, amplitude: f64| {
            let has_one = effect.linked.contains(&channel);
            has_one.then(|| effect.shift(channel, amplitude, effect.simulated_shape(), &data.reading(stroke)))
        };
        let transfer = Transfer { data, plain, formula: &formula, unsteadiness: &data.unsteadiness };
        let mut nodes = transfer.nodes(shown);
        nodes.sort_by(|a, b| a.amplitude.abs().total_cmp(&b.amplitude.abs()));
        let mut learnt = Self { nodes, local, channels: Vec::new(), alike: None, about: 0.0 };
        let seen = |channel: &Channel| {
            let scatter = crate::channels::spread(&data.beyond_expected(*channel)).max(f64::MIN_POSITIVE);
            data.channels.contains_key(channel)
                && learnt.size(*channel) >= LEAST_SHARE * scatter
                && learnt.is_consistent(*channel)
        };
        learnt.channels = Channel::ALL.into_iter().filter(seen).collect();
        learnt
    }

    /// Responses of the strokes of `data` to a setting of the simulated arm: half the difference between strokes with it higher (`up`) and lower
    /// (`down`) by the same factor, for an amplitude of 1; `plain` are the strokes with the setting as it is.
    #[must_use]
    pub fn of_setting(data: &Data, plain: &Data, up: &Data, down: &Data) -> Self {
        let unsteadiness = Unsteadiness::default();
        let transfer = Transfer { data, plain, formula: &|_, _, _, _| None, unsteadiness: &unsteadiness };
        let nodes =
            transfer.nodes(&[(1.0, up), (-1.0, down)].map(|(amplitude, with)| Shown { amplitude, with }));
        let mut learnt =
            Self { nodes, local: vec![1.0; data.rows.len()], channels: Vec::new(), alike: None, about: 0.0 };
        let seen = |channel: &Channel| {
            let scatter = crate::channels::spread(&data.beyond_expected(*channel)).max(f64::MIN_POSITIVE);
            data.channels.contains_key(channel)
                && learnt.size(*channel) >= LEAST_SHARE * scatter
                && learnt.is_odd(*channel)
        };
        let channels = Channel::ALL.into_iter().filter(seen).collect();
        learnt.channels = channels;
        learnt.alike = Some(combined(&learnt.nodes, |_| 0.5));
        learnt.nodes = vec![combined(&learnt.nodes, |amplitude| 0.5 * amplitude)];
        learnt
    }

    /// Of a setting: what a higher and a lower one do alike, which is nothing that goes with the setting.
    pub(crate) fn alike(&self) -> Option<&Node> {
        self.alike.as_ref()
    }

    /// Columns that show the effect.
    pub(crate) fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// Whether strokes of the simulated arm survived amplitudes of a sign: one that none survives is not that of strokes that were made.
    pub(crate) fn has_sign(&self, sign: f64) -> bool {
        self.nodes.iter().any(|node| node.amplitude * sign > 0.0)
    }

    /// The same where strokes are compared with an arm that has this amplitude of the effect.
    pub(crate) fn about(&self, amplitude: f64) -> Self {
        Self { about: amplitude, ..self.clone() }
    }

    /// Change of ln force of a stroke by an amplitude.
    pub(crate) fn ln_force(&self, stroke: usize, amplitude: f64) -> f64 {
        self.at(stroke, amplitude, |node| node.ln_force.get(stroke).copied())
    }

    /// Change of a column of a stroke by an amplitude; 0 of a column that does not show it.
    pub(crate) fn shift(&self, channel: Channel, stroke: usize, amplitude: f64) -> f64 {
        if !self.channels.contains(&channel) {
            return 0.0;
        }
        self.at(stroke, amplitude, |node| node.channels.get(&channel)?.get(stroke).copied())
    }

    /// What an amplitude does beyond what that of the arm does.
    fn at(&self, stroke: usize, amplitude: f64, value: impl Fn(&Node) -> Option<f64>) -> f64 {
        let there = if self.about == 0.0 { 0.0 } else { self.response(stroke, self.about, &value) };
        self.response(stroke, amplitude, &value) - there
    }

    /// A parabola through nothing at no amplitude and the two nodes of its sign, a line beyond them and if there is one only.
    fn response(&self, stroke: usize, amplitude: f64, value: &impl Fn(&Node) -> Option<f64>) -> f64 {
        let amplitude = amplitude * self.local.get(stroke).copied().unwrap_or_default();
        let of_sign = self.nodes.iter().filter(|node| node.amplitude * amplitude > 0.0);
        let points: Vec<(f64, f64)> =
            of_sign.filter_map(|node| Some((node.amplitude.abs(), value(node)?))).collect();
        curve(&points, amplitude.abs())
    }

    /// Whether a column responds to the two amplitudes of a sign much as their sizes are to each other.
    fn is_consistent(&self, channel: Channel) -> bool {
        let (mut bent, mut all) = (0.0, 0.0);
        for (i, small) in self.nodes.iter().enumerate() {
            let larger = self.nodes[i + 1..].iter().find(|node| node.amplitude * small.amplitude > 0.0);
            let Some(large) = larger else { continue };
            let ratio = large.amplitude / small.amplitude;
            let pairs = small.channels.get(&channel).into_iter().flatten();
            for (a, b) in pairs.zip(large.channels.get(&channel).into_iter().flatten()) {
                bent += (b - ratio * a).powi(2);
                all += b * b;
            }
        }
        bent <= MOST_BENT * all
    }

    /// Whether a column responds to a setting that is lower much as to one that is higher, with the other sign.
    fn is_odd(&self, channel: Channel) -> bool {
        let (mut even, mut all) = (0.0, 0.0);
        if let [up, down] = self.nodes.as_slice() {
            let pairs = up.channels.get(&channel).into_iter().flatten();
            for (a, b) in pairs.zip(down.channels.get(&channel).into_iter().flatten()) {
                even += 0.5 * (a + b).powi(2);
                all += a * a + b * b;
            }
        }
        even <= MOST_BENT * all
    }

    /// Root mean square of what a column shows of the largest amplitude of either sign.
    fn size(&self, channel: Channel) -> f64 {
        let of = |node: &Node| {
            let values = node.channels.get(&channel)?;
            let squares = values.iter().zip(&self.local).map(|(value, local)| (value * local).powi(2));
            Some((squares.sum::<f64>() / values.len().max(1) as f64).sqrt())
        };
        self.nodes.iter().filter_map(of).fold(0.0, f64::max)
    }
}

/// The sum of a setting's nodes, each times a share that goes by its amplitude (1 higher, -1 lower).
fn combined(nodes: &[Node], share: impl Fn(f64) -> f64) -> Node {
    let sum = |of: &dyn Fn(&Node) -> Vec<f64>| -> Vec<f64> {
        let mut parts = nodes.iter().map(|node| (share(node.amplitude), of(node)));
        let Some((share, first)) = parts.next() else { return Vec::new() };
        let first: Vec<f64> = first.iter().map(|value| share * value).collect();
        parts.fold(first, |sum, (share, more)| sum.iter().zip(&more).map(|(a, b)| a + share * b).collect())
    };
    let channels = nodes.first().into_iter().flat_map(|node| node.channels.keys());
    let channels = channels
        .map(|channel| (*channel, sum(&|node| node.channels.get(channel).cloned().unwrap_or_default())));
    Node { amplitude: 1.0, channels: channels.collect(), ln_force: sum(&|node| node.ln_force.clone()) }
}

/// Value at `x` of the response that is 0 at 0 and goes through `points`, of which the first two count, by rising x above 0.
fn curve(points: &[(f64, f64)], x: f64) -> f64 {
    match *points {
        [] => 0.0,
        [(x1, y1)] => y1 / x1 * x,
        [(x1, y1), (x2, y2), ..] => {
            let (s1, s2) = (y1 / x1, y2 / x2);
            let bend = (s2 - s1) / (x2 - x1);
            let within = x.min(x2);
            let slope_at_end = s1 + bend * (2.0 * x2 - x1);
            within * (s1 + bend * (within - x1)) + slope_at_end * (x - within)
        }
    }
}

/// Share of an effect's amplitude that acts on a stroke.
fn share(effect: &Effect, stroke: &Stroke) -> f64 {
    if effect.id == EffectId::ForceDrift { stroke.time_fraction.unwrap_or(0.0) } else { 1.0 }
}

/// The effect that is to be simulated in strokes without a history, to learn how strokes respond to another one: a drift is a bias that
/// grows. `None` of effects that such strokes do not show: those that depend on other strokes, or on where and when a stroke is made.
#[must_use]
pub fn simulated_as(id: EffectId) -> Option<EffectId> {
    if id == EffectId::ForceDrift {
        return Some(EffectId::ForceBias);
    }
    id.effect().varies_with.is_none().then_some(id)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::StrokeRow;

    use super::*;

    #[test]
    fn a_curve_goes_through_its_points_and_on_as_a_line() {
        let square = |x: f64| 3.0 * x + 0.5 * x * x;
        let points = [(1.0, square(1.0)), (2.0, square(2.0))];
        for x in [0.0, 0.4, 1.0, 1.7, 2.0] {
            assert!((curve(&points, x) - square(x)).abs() < 1e-12, "{x}");
        }
        // Slope 3 + 2 at the end.
        assert!((curve(&points, 4.0) - (square(2.0) + 2.0 * 5.0)).abs() < 1e-12);
        assert_eq!((curve(&[(2.0, 6.0)], 3.0), curve(&[], 1.0)), (9.0, 0.0));
    }

    /// Single strokes of two forces, of an arm whose cables stretch by 0.4 mm/N: strokes of other forces show what they have by their own force. What
    /// strokes do that go their own way is no response, whether all kinds do it or one.
    #[test]
    fn what_single_strokes_show_goes_to_others_as_the_formula_goes_and_chance_does_not() {
        let data = |strokes: &[(f64, f64)]| {
            let row = |(i, &(force_n, way_m)): (usize, &(f64, f64))| StrokeRow {
                stroke_id: Some(format!("s{i}")),
                alpha_deg: 80.0 + 10.0 * i as f64,
                depth_m: 0.025,
                width_m: 0.1,
                force_n,
                displacement_at_failure_m: Some(way_m),
                ..StrokeRow::default()
            };
            let rows = strokes.iter().enumerate().map(row).collect();
            Data::new("t", rows, soilctl_strokes::Campaign::default()).unwrap()
        };
        let effect = EffectId::CableFlex.effect();
        let plain = data(&[(4.0, 3e-3), (8.0, 5e-3)]);
        let with = data(&[(4.0, 3e-3 + 4.0 * 4e-4), (8.0, 5e-3 + 8.0 * 4e-4)]);
        let mut campaign = data(&[(5.0, 4e-3), (12.0, 6e-3)]);
        let at = |campaign: &Data, with: &Data, stroke: usize| {
            let shown = [Shown { amplitude: 4e-4, with }];
            Learnt::new(effect, campaign, &plain, &shown).nodes[0].channels[&Channel::Displacement][stroke]
        };
        for (stroke, force_n) in [(0, 5.0), (1, 12.0)] {
            assert!((at(&campaign, &with, stroke) - force_n * 4e-4).abs() < 1e-12);
        }
        // Ways that differ by 1 mm for no reason are what a response of some tenths of one is then.
        let still = data(&[(4.0, 3e-3), (8.0, 5e-3)]);
        let (up, down) = (data(&[(4.0, 4e-3), (8.0, 6e-3)]), data(&[(4.0, 4e-3), (8.0, 6e-3)]));
        campaign.doubt(Learnt::of_setting(&campaign, &still, &up, &down));
        let chance = data(&[(4.0, 3e-3 + 8e-4), (8.0, 5e-3 - 3e-4)]);
        for stroke in [0, 1] {
            assert_eq!(at(&campaign, &chance, stroke), 0.0);
        }
        // Much more than chance stays, but for the share of its square that chance is expected to have.
        let large = data(&[(4.0, 3e-3 + 4.0 * 4e-3), (8.0, 5e-3 + 8.0 * 4e-3)]);
        let variance = 4.0 / 3.0 * 1e-6;
        let kept = 1.0 - variance / ((4.0_f64.powi(2) + 8.0_f64.powi(2)) * 4e-3 * 4e-3);
        // The amplitude is one tenth of what was seen: ten times the formula.
        assert!((at(&campaign, &large, 1) - kept * 12.0 * 4e-3).abs() < 1e-9);
    }

    /// A column that follows a setting up and down says nothing of jumps; one stroke that leaves its way with both ends of one of two settings has
    /// half the square of that as the mean, and 4/3 of it as the variance of a difference.
    #[test]
    fn strokes_that_go_their_own_way_are_unsteady() {
        let row = |force_n: f64, z: f64| StrokeRow {
            stroke_id: Some("s".to_owned()),
            alpha_deg: 90.0,
            depth_m: 0.025,
            width_m: 0.1,
            force_n,
            z_drift_m: Some(z),
            ..StrokeRow::default()
        };
        let data = |ln: f64, z: f64| {
            Data::new("t", vec![row(5.0 * ln.exp(), z)], soilctl_strokes::Campaign::default()).unwrap()
        };
        let plain = data(0.0, 0.0);
        let mut unsteady = Unsteadiness::default();
        let add = |up: &Data, down: &Data, to: &mut Unsteadiness| {
            to.add(Learnt::of_setting(&plain, &plain, up, down).alike().unwrap());
        };
        add(&data(0.1, 2e-3), &data(-0.1, -2e-3), &mut unsteady);
        assert!(unsteady.variance(None, 0) < 1e-18 && unsteady.variance(Some(Channel::ZDrift), 0) < 1e-18);
        add(&data(0.3, 3e-3), &data(0.3, 3e-3), &mut unsteady);
        assert!((unsteady.variance(None, 0) - 4.0 / 3.0 * 0.3 * 0.3 / 2.0).abs() < 1e-12);
        assert!((unsteady.variance(Some(Channel::ZDrift), 0) - 4.0 / 3.0 * 9e-6 / 2.0).abs() < 1e-15);
        assert_eq!(unsteady.variance(Some(Channel::PostSlope), 0), 0.0);
    }

    #[test]
    fn a_drift_is_learnt_from_a_bias_and_what_needs_other_strokes_not_at_all() {
        assert_eq!(simulated_as(EffectId::ForceDrift), Some(EffectId::ForceBias));
        assert_eq!(simulated_as(EffectId::Backlash), Some(EffectId::Backlash));
        for id in [EffectId::RateEffect, EffectId::AdjacentStroke, EffectId::RadiusDependence] {
            assert_eq!(simulated_as(id), None, "{id}");
        }
    }
}
