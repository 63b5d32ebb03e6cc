//! A campaign as the diagnosis sees it.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_effects::{
    Active, Channel, Covariate, EffectId, EmpiricalTerm, Loaded, Reading, Reference, Stroke,
};
use soilctl_soil::STANDARD_GRAVITY_M_S2;
use soilctl_strokes::{Campaign, StrokeRow, TraceTable};

use crate::DiagnosisError;
use crate::correlation::Correlation;
use crate::decided::Decided;
use crate::diagnosis::FoundEffect;
use crate::learnt::Learnt;
use crate::traces::{PhaseKey, traced};
use crate::unsteadiness::Unsteadiness;

/// Density that dry sand has if nobody weighed it, kg/m3, and its relative standard deviation. Empirical: the four soils of
/// `data/soils.csv` have 1430 to 1600.
const USUAL_DENSITY: (f64, f64) = (1550.0, 0.1);
/// Friction angle of soils nobody tested, deg, and its standard deviation. Empirical.
const USUAL_PHI: (f64, f64) = (38.0, 6.0);
/// Interface friction if there was no set-point, deg, and its standard deviation. Empirical: some two thirds of the friction angle.
const USUAL_DELTA: (f64, f64) = (22.0, 5.0);

/// A value with its standard deviation, before the strokes are looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub sd: f64,
}

/// An effect that is known before the strokes are looked at: part of the baseline, with its amplitude held.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Known {
    pub(crate) active: Active,
    /// Whether columns that its amplitude fixes show it.
    pub(crate) linked: bool,
    /// Whether columns respond with a strength of their own.
    pub(crate) responds: bool,
}

/// Readings of a campaign that are weighed: columns, and which strokes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Readings {
    /// Columns.
    pub columns: BTreeSet<Channel>,
    /// By stroke, whether it takes part; those beyond the end do.
    pub strokes: Vec<bool>,
}

impl Readings {
    /// Leaves those that `other` has, too.
    pub fn keep(&mut self, other: &Self) {
        self.columns.retain(|column| other.columns.contains(column));
        for (takes_part, also) in self.strokes.iter_mut().zip(&other.strokes) {
            *takes_part &= also;
        }
    }
}

/// Radii that differ by less are one, in m: those of a plan are inches apart.
const SAME_RADIUS_M: f64 = 0.02;

/// Part of the strokes of a kind (one tool angle and radius) that may sink before all of it are taken to be on the brink. Empirical.
const BRINK: f64 = 0.2;

/// Rows up to which a table is a summary: there are four unknowns (soil, interface, density, scatter), and an effect has one or two.
const MOST_SUMMARIES: usize = 6;

/// Strokes and all that is known beside them.
#[derive(Debug, Clone)]
pub struct Data {
    /// Name of the stroke table, for messages.
    pub name: String,
    /// Rows as they were read; [`Data::add_traces`] fills empty cells.
    pub rows: Vec<StrokeRow>,
    /// What was known of the campaign.
    pub campaign: Campaign,
    /// Means and ends that parameters refer to.
    pub reference: Reference,
    /// The strokes as effects see them.
    pub strokes: Vec<Stroke>,
    /// ln of the failure force in N.
    pub ln_force: Vec<f64>,
    /// Index of the batch of each stroke; all 0 without batches.
    pub batch: Vec<usize>,
    /// Number of batches, at least 1.
    pub batches: usize,
    /// Index of the tool angle of each stroke among the different ones.
    pub level: Vec<usize>,
    /// Different tool angles, ascending, in deg.
    pub levels_deg: Vec<f64>,
    /// Trace-derived columns that have at least one cell, and what only traces have.
    pub channels: BTreeMap<Channel, Vec<Option<f64>>>,
    /// Columns of which every cell comes from the traces.
    pub(crate) derived: BTreeSet<Channel>,
    /// Readings phase by phase.
    pub(crate) phases: BTreeMap<PhaseKey, Vec<Option<f64>>>,
    /// What a simulated arm without effects read in the same strokes.
    pub(crate) expected: BTreeMap<Channel, Vec<f64>>,
    /// The same phase by phase.
    pub(crate) expected_phases: BTreeMap<PhaseKey, Vec<f64>>,
    /// Which strokes failed the soil of that arm, too, and are of a kind that is not on the brink.
    pub(crate) made: Vec<bool>,
    /// Whether that arm had the known effects.
    pub(crate) expected_shows_known: bool,
    /// Interface friction of that arm's soil minus the set-point, deg.
    pub(crate) expected_delta_offset_deg: f64,
    /// ln of the force of that arm over the force model's, by stroke: what the scene makes of it, such as the heaps of earlier strokes.
    pub(crate) scene: Option<Vec<f64>>,
    /// How strokes respond to effects, where a simulated arm showed it.
    pub(crate) learnt: BTreeMap<EffectId, Learnt>,
    /// How strokes respond to settings of that arm that nobody measures, for an amplitude of 1.
    pub(crate) twin: Vec<Learnt>,
    /// By how much strokes of that arm go another way for reasons of their own.
    pub(crate) unsteadiness: Unsteadiness,
    /// How the readings of one stroke vary together, where strokes of that arm were repeated.
    pub(crate) correlation: Option<Correlation>,
    /// Whether the free-air readings of the table are taken off the forces.
    tare_is_off: bool,
    /// Effects that are not to be found, but known.
    pub(crate) known: Vec<Known>,
    /// Empirical terms that are known, and what they change of each ln force.
    pub(crate) known_terms: Vec<EmpiricalTerm>,
    pub(crate) known_ln: Vec<f64>,
    /// What a simulated arm that was tried with several sets of effects decided.
    pub(crate) decided: Option<Decided>,
    /// Friction angle, deg.
    pub phi: Prior,
    /// Interface friction minus its set-point, deg.
    pub delta: Prior,
    /// Mean density, kg/m3, with a relative standard deviation.
    pub density: Prior,
    /// Gravity, m/s2.
    pub gravity_m_s2: f64,
}

impl Data {
    /// Prepares a campaign.
    ///
    /// # Errors
    /// [`DiagnosisError::NoStrokes`] without rows.
    pub fn new(name: &str, rows: Vec<StrokeRow>, campaign: Campaign) -> Result<Self, DiagnosisError> {
        let none = || DiagnosisError::NoStrokes { file: name.into() };
        let reference = Reference::of(&rows).ok_or_else(none)?;
        let strokes: Vec<Stroke> = rows.iter().map(|row| Stroke::new(row, &reference)).collect();
        let batch: Vec<usize> = rows
            .iter()
            .map(|row| {
                let name = row.batch.as_deref();
                reference
                    .batches
                    .iter()
                    .position(|b| Some(b.as_str()) == name)
                    .unwrap_or(reference.batches.len())
            })
            .collect();
        let batches = batch.iter().max().map_or(1, |last| last + 1);
        let mut levels_deg: Vec<f64> = rows.iter().map(|row| row.alpha_deg).collect();
        levels_deg.sort_by(f64::total_cmp);
        levels_deg.dedup_by(|a, b| (*a - *b).abs() < 1.0);
        let level = rows.iter().map(|row| nearest(&levels_deg, row.alpha_deg)).collect();
        let densities: Vec<f64> = rows.iter().filter_map(|row| row.density_kg_m3).collect();
        let density = if densities.is_empty() {
            Prior { mean: USUAL_DENSITY.0, sd: USUAL_DENSITY.1 }
        } else {
            let mean = densities.iter().sum::<f64>() / densities.len() as f64;
            Prior { mean, sd: campaign.density_sd_rel.max(0.005) }
        };
        let phi = match (campaign.phi_independent_deg, campaign.phi_independent_sd) {
            (Some(mean), sd) => Prior { mean, sd: sd.unwrap_or(1.0).max(0.1) },
            _ => Prior { mean: USUAL_PHI.0, sd: USUAL_PHI.1 },
        };
        let delta = if reference.delta_set_deg.is_some() {
            Prior { mean: 0.0, sd: campaign.delta_sd_deg.max(0.1) }
        } else {
            Prior { mean: 0.0, sd: USUAL_DELTA.1 }
        };
        let count = rows.len();
        Ok(Self {
            name: name.into(),
            ln_force: rows.iter().map(|row| row.force_n.ln()).collect(),
            campaign,
            reference,
            strokes,
            batch,
            batches,
            level,
            levels_deg,
            channels: columns(&rows, false),
            rows,
            derived: BTreeSet::new(),
            phases: BTreeMap::new(),
            expected: BTreeMap::new(),
            expected_phases: BTreeMap::new(),
            made: vec![true; count],
            expected_shows_known: false,
            expected_delta_offset_deg: 0.0,
            scene: None,
            learnt: BTreeMap::new(),
            twin: Vec::new(),
            unsteadiness: Unsteadiness::default(),
            correlation: None,
            tare_is_off: false,
            known: Vec::new(),
            known_terms: Vec::new(),
            known_ln: vec![0.0; count],
            decided: None,
            phi,
            delta,
            density,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
        })
    }

    /// Fills empty cells from the traces and takes what only traces have. `failure_time_s` says, by stroke, when the soil
    /// failed on the clock of the traces, where that is known; otherwise it is where the failure force is reached. The answer
    /// is the number of strokes with a trace in which the failure was found.
    pub fn add_traces(&mut self, traces: &TraceTable, failure_time_s: &[Option<f64>]) -> usize {
        let found = traced(&self.rows, traces, failure_time_s);
        for (channel, cells) in found.channels {
            if !self.channels.contains_key(&channel) {
                self.derived.insert(channel);
            }
            let column = self.channels.entry(channel).or_insert_with(|| vec![None; cells.len()]);
            for ((old, new), row) in column.iter_mut().zip(cells).zip(&mut self.rows) {
                if let Some(value) = new {
                    old.get_or_insert(value);
                    channel.fill(row, value);
                }
            }
        }
        self.phases = found.phases;
        found.used
    }

    /// Says that the free-air readings of the table have been taken off the forces, so that a bias in them is in no force.
    pub fn tare_taken_off(&mut self) {
        self.tare_is_off = true;
        self.channels.remove(&Channel::TareBefore);
        self.channels.remove(&Channel::TareAfter);
    }

    /// Takes what the scene makes of the force of each stroke from a simulated arm in soil of a known force: ln of the force that was read
    /// over that which the force model gives (`model_n`, by stroke of `simulated`). Strokes are found by their names, since each has other neighbours;
    /// for one that is missing there the mean at its tool angle and radius stands. Strokes whose kind is missing keep what an arm before it said; if
    /// there was none, nothing happens.
    pub fn expect_scene(&mut self, simulated: &Self, model_n: &[f64]) {
        let of = |row: &StrokeRow| -> Option<f64> {
            let found = |is_like: &dyn Fn(&StrokeRow) -> bool| -> Option<f64> {
                let like = simulated.rows.iter().zip(model_n).filter(|(other, _)| is_like(other));
                let ratios: Vec<f64> = like.map(|(other, model)| (other.force_n / model).ln()).collect();
                let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
                mean.is_finite().then_some(mean)
            };
            found(&|other| is_same(row, other)).or_else(|| found(&|other| is_of_a_kind(row, other)))
        };
        let before = |i: usize| self.scene.as_ref()?.get(i).copied();
        self.scene = self.rows.iter().enumerate().map(|(i, row)| of(row).or_else(|| before(i))).collect();
    }

    /// Takes how strokes respond to an effect from a simulated arm, in place of the effect's formulas. To be called after [`Data::expect`].
    pub fn learn(&mut self, id: EffectId, learnt: Learnt) {
        self.learnt.insert(id, learnt);
    }

    /// Takes how strokes respond to a setting of the simulated arm that may be off: forces and columns then share how far it is. To be called
    /// after [`Data::expect`].
    pub fn doubt(&mut self, setting: Learnt) {
        if let Some(alike) = setting.alike() {
            self.unsteadiness.add(alike);
        }
        self.twin.push(setting);
    }

    /// Takes how the readings of one stroke vary together from strokes that the simulated arm made several times with other noise. Fewer than
    /// twelve degrees of freedom (strokes times further repeats) say nothing: readings stay independent, and the answer is `false`.
    pub fn vary_as(&mut self, repeats: &[&Self]) -> bool {
        self.correlation = Correlation::of_repeats(repeats);
        self.correlation.is_some()
    }

    /// Takes also those columns that only a simulated arm says what to expect of: for strokes that are compared with others of that arm.
    pub fn compare_everything(&mut self) {
        self.channels =
            columns(&self.rows, true).into_iter().chain(std::mem::take(&mut self.channels)).collect();
    }

    /// Says that the simulated arm that told what to expect ([`Data::expect_of`]) has effects of these sizes: how strokes respond to them counts from
    /// there, so that errors of responses matter the less the nearer that arm comes to the measured one. To be called after [`Data::learn`]. Without effects, or if
    /// nobody learnt how strokes respond to one of them, nothing can be told of sizes, and the answer is `false`.
    pub fn count_from(&mut self, effects: &[FoundEffect]) -> bool {
        for of in effects {
            let Some(learnt) = self.learnt.get_mut(&of.id) else { return false };
            *learnt = learnt.about(of.amplitude);
        }
        !effects.is_empty()
    }

    /// Empirical terms that are known ([`Data::know`]).
    #[must_use]
    pub fn known_terms(&self) -> &[EmpiricalTerm] {
        &self.known_terms
    }

    /// Columns and strokes of which a simulated arm said what to expect.
    #[must_use]
    pub fn readings(&self) -> Readings {
        let columns = self.expected.keys().filter(|channel| self.channels.contains_key(channel));
        Readings { columns: columns.copied().collect(), strokes: self.made.clone() }
    }

    /// Whether a simulated arm said what to expect.
    pub(crate) fn is_compared(&self) -> bool {
        !self.expected.is_empty()
    }

    /// What a column reads beyond what is expected of it.
    pub(crate) fn beyond_expected(&self, channel: Channel) -> Vec<f64> {
        let expected = self.expected.get(&channel);
        let cells = self.channels.get(&channel).into_iter().flatten().enumerate();
        let beyond = |(i, cell): (usize, &Option<f64>)| Some((*cell)? - expected.map_or(0.0, |all| all[i]));
        cells.filter_map(beyond).collect()
    }

    /// Takes what a simulated arm read in the same strokes, found by their names, as what is to be expected: an arm without
    /// effects, or, if it `shows_known`, with those of [`Data::know`]. Where a stroke is missing there, the mean at its tool angle
    /// and radius stands for it, or else at its tool angle. `delta_offset_deg` is the interface friction there minus the set-point, in deg.
    pub fn expect(&mut self, simulated: &Self, shows_known: bool, delta_offset_deg: f64) {
        self.expect_of(&vec![true; self.len()], simulated, shows_known, delta_offset_deg);
    }

    /// The same where the arm was asked for some of the strokes only: others take no part.
    pub fn expect_of(&mut self, asked: &[bool], simulated: &Self, shows_known: bool, delta_offset_deg: f64) {
        self.expected_shows_known = shows_known;
        self.expected_delta_offset_deg = delta_offset_deg;
        let places: Vec<Option<usize>> = self.rows.iter().map(|row| simulated.place_of(row)).collect();
        // Of a kind that is on the brink of sinking, strokes that do not sink go their own way, too.
        let brink = |i: usize| {
            let kind: Vec<usize> = self.kind(i).into_iter().filter(|j| asked[*j]).collect();
            let sink = kind.iter().filter(|j| places[**j].is_none()).count();
            sink as f64 > BRINK * kind.len() as f64
        };
        self.made = (0..self.rows.len()).map(|i| asked[i] && places[i].is_some() && !brink(i)).collect();
        let all = |cells: &[Option<f64>]| -> Option<Vec<f64>> {
            let mean = |is_like: &dyn Fn(&StrokeRow) -> bool| {
                let of = cells.iter().zip(&simulated.rows).filter(|(_, row)| is_like(row));
                let known: Vec<f64> = of.filter_map(|(cell, _)| *cell).collect();
                (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
            };
            let of = |i: usize| {
                let row = &self.rows[i];
                let same = places[i].and_then(|place| cells[place]);
                same.or_else(|| mean(&|other| is_of_a_kind(row, other)))
                    .or_else(|| mean(&|other| (row.alpha_deg - other.alpha_deg).abs() < 1.0))
                    .or_else(|| mean(&|_| true))
            };
            (0..self.rows.len()).map(of).collect()
        };
        let told = columns(&self.rows, true).into_iter().filter(|(channel, _)| channel.is_compared_only());
        self.channels.extend(told);
        let simulated_columns = columns(&simulated.rows, true)
            .into_iter()
            .chain(simulated.channels.clone())
            .collect::<BTreeMap<_, _>>();
        let expected = simulated_columns.iter().filter(|(channel, _)| self.channels.contains_key(channel));
        self.expected = expected.filter_map(|(channel, cells)| Some((*channel, all(cells)?))).collect();
        let expected = &self.expected;
        self.channels.retain(|channel, _| !channel.is_compared_only() || expected.contains_key(channel));
        let phases = simulated.phases.iter().filter(|(key, _)| self.phases.contains_key(key));
        self.expected_phases = phases.filter_map(|(key, cells)| Some((*key, all(cells)?))).collect();
    }

    /// Strokes of the kind of a stroke, with itself.
    pub(crate) fn kind(&self, stroke: usize) -> Vec<usize> {
        let of_kind = |j: &usize| is_of_a_kind(&self.rows[stroke], &self.rows[*j]);
        (0..self.rows.len()).filter(of_kind).collect()
    }

    /// Takes the effects, the empirical terms and the gravity of a model file as known. Amplitudes are held in every fit, and the effects are not
    /// looked for again; the soil is fitted anew. Parameters, also those of what is found, refer to what the file's refer to.
    pub fn know(&mut self, file: &Loaded) {
        self.known =
            file.effects().iter().map(|&active| Known { active, linked: true, responds: true }).collect();
        self.gravity_m_s2 = file.file().soil.gravity_m_s2;
        self.known_terms = file.file().empirical.clone();
        let of_terms = |row: &StrokeRow| -> f64 {
            let reference = &file.file().reference;
            self.known_terms.iter().map(|term| term.ln_factor(row, reference)).sum()
        };
        self.known_ln = self.rows.iter().map(of_terms).collect();
        // What is known is in what is expected, as a simulated arm reads it or by its formula.
        self.learnt.retain(|id, _| self.known.iter().all(|known| known.active.effect.id != *id));
        if self.known.is_empty() {
            return;
        }
        let (own, theirs) = (self.reference.clone(), &file.file().reference);
        let ordered =
            self.known.iter().any(|known| known.active.effect.varies_with == Some(Covariate::Batch));
        self.refer_to(Reference {
            depth_m: theirs.depth_m,
            alpha_deg: theirs.alpha_deg,
            delta_set_deg: own.delta_set_deg,
            speed_mps: theirs.speed_mps.or(own.speed_mps),
            time_s: theirs.time_s.or(own.time_s),
            base_deg: theirs.base_deg.or(own.base_deg),
            // Other preparations have other names; only a drift over those of the file needs them.
            batches: if ordered { theirs.batches.clone() } else { own.batches },
        });
    }

    /// Known effects that change what a column reads by an amount that is known too.
    pub(crate) fn known_linked(&self, channel: Channel) -> impl Iterator<Item = &Active> {
        let shows = move |known: &&Known| known.linked && known.active.effect.linked.contains(&channel);
        self.known.iter().filter(shows).map(|known| &known.active)
    }

    /// Known effects to which columns respond.
    pub(crate) fn known_responses(&self) -> impl Iterator<Item = &Active> {
        self.known.iter().filter(|known| known.responds).map(|known| &known.active)
    }

    /// Effects that may be missing: those of the catalogue that are not known. Where a simulated arm made the same strokes, their speeds are what
    /// its controller made of them and no condition that somebody set, and none of its strokes tells what another speed does.
    pub(crate) fn possible(&self) -> impl Iterator<Item = EffectId> {
        let known = |id: &EffectId| self.known.iter().any(|known| known.active.effect.id == *id);
        let told = |id: &EffectId| !self.is_compared() || id.effect().varies_with != Some(Covariate::Speed);
        EffectId::ALL.into_iter().filter(move |id| !known(id) && told(id))
    }

    /// Those that are looked for: all, or those that were decided for.
    pub(crate) fn candidates(&self) -> impl Iterator<Item = EffectId> {
        self.possible().filter(|id| self.decided.as_ref().is_none_or(|decided| decided.has(*id)))
    }

    /// Sees the strokes from another reference.
    pub(crate) fn refer_to(&mut self, reference: Reference) {
        self.strokes = self.rows.iter().map(|row| Stroke::new(row, &reference)).collect();
        self.reference = reference;
    }

    /// Where the stroke with the name of another table's stroke is.
    #[must_use]
    pub fn place_of(&self, row: &StrokeRow) -> Option<usize> {
        self.rows.iter().position(|other| is_same(row, other))
    }

    /// Number of strokes.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a campaign is never empty")]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether the table is a summary and no campaign: it has as many rows as there are unknowns.
    #[must_use]
    pub fn is_summary(&self) -> bool {
        self.len() <= MOST_SUMMARIES
    }

    /// Set-point of the interface friction of a stroke, deg; the mean set-point where the cell is empty.
    #[must_use]
    pub fn delta_set_deg(&self, stroke: usize) -> f64 {
        self.rows[stroke].delta_set_deg.or(self.reference.delta_set_deg).unwrap_or(USUAL_DELTA.0)
    }

    /// What shifts of channels depend on.
    pub(crate) fn reading(&self, stroke: usize) -> Reading<'_> {
        Reading {
            stroke: &self.strokes[stroke],
            force_n: self.rows[stroke].force_n,
            delta_deg: self.delta_set_deg(stroke),
            unit_weight_n_m3: self.density.mean * self.gravity_m_s2,
            encoder_step_m: self.campaign.instrument.encoder_step_m,
        }
    }
}

/// Whether two strokes have one name.
fn is_same(a: &StrokeRow, b: &StrokeRow) -> bool {
    a.stroke_id.is_some() && a.stroke_id == b.stroke_id
}

/// Whether two strokes have one tool angle and radius.
pub(crate) fn is_of_a_kind(a: &StrokeRow, b: &StrokeRow) -> bool {
    let near = a.radius_m.zip(b.radius_m).is_none_or(|(a, b)| (a - b).abs() < SAME_RADIUS_M);
    near && (a.alpha_deg - b.alpha_deg).abs() < 1.0
}

/// Trace-derived columns that have at least one cell; with those that are only ever compared, if wanted.
fn columns(rows: &[StrokeRow], compared: bool) -> BTreeMap<Channel, Vec<Option<f64>>> {
    let cells = |channel: Channel| rows.iter().map(|row| channel.of(row)).collect::<Vec<_>>();
    let found = Channel::ALL.into_iter().filter(|channel| compared || !channel.is_compared_only());
    let found = found.map(|channel| (channel, cells(channel)));
    found.filter(|(_, cells)| cells.iter().any(Option::is_some)).collect()
}

fn nearest(levels: &[f64], value: f64) -> usize {
    let mut best = (f64::INFINITY, 0);
    for (i, level) in levels.iter().enumerate() {
        let distance = (level - value).abs();
        if distance < best.0 {
            best = (distance, i);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    fn strokes(of: &[(&str, f64, f64)]) -> Data {
        let row = |&(name, alpha_deg, force_n): &(&str, f64, f64)| StrokeRow {
            stroke_id: Some(name.to_owned()),
            alpha_deg,
            depth_m: 0.02,
            width_m: 0.1,
            force_n,
            radius_m: Some(0.4),
            ..StrokeRow::default()
        };
        Data::new("t", of.iter().map(row).collect(), Campaign::default()).unwrap()
    }

    /// One of five strokes that sinks is left out; with two of them all of their kind are, and those of another kind stay.
    #[test]
    fn a_kind_on_the_brink_is_left_out() {
        let all: Vec<(String, f64, f64)> =
            (0..7).map(|i| (format!("s{i}"), if i < 5 { 90.0 } else { 80.0 }, 1.0)).collect();
        let without = |sinks: &[usize]| {
            let made = all.iter().enumerate().filter(|(i, _)| !sinks.contains(i));
            strokes(
                &made.map(|(_, (name, alpha, force))| (name.as_str(), *alpha, *force)).collect::<Vec<_>>(),
            )
        };
        let taking_part = |sinks: &[usize]| {
            let mut data = without(&[]);
            data.expect(&without(sinks), false, 0.0);
            data.readings().strokes
        };
        assert_eq!(taking_part(&[]), [true; 7]);
        assert_eq!(taking_part(&[2]), [true, true, false, true, true, true, true]);
        assert_eq!(taking_part(&[2, 4]), [false, false, false, false, false, true, true]);
        assert_eq!(taking_part(&[6]), [true, true, true, true, true, false, false]);
    }

    /// A stroke has its own scene; one that sank has that of its kind, and one whose kind sank has what the arm before said, if there was one.
    #[test]
    fn the_scene_is_that_of_the_stroke() {
        let mut data = strokes(&[("a", 90.0, 1.0), ("b", 90.0, 1.0), ("c", 90.0, 1.0), ("d", 80.0, 1.0)]);
        let scene = |data: &Data| data.scene.clone();
        data.expect_scene(&strokes(&[("a", 90.0, 4.0), ("b", 90.0, 9.0)]), &[2.0, 3.0]);
        assert_eq!(scene(&data), None);
        let whole = strokes(&[("a", 90.0, 4.0), ("b", 90.0, 9.0), ("d", 80.0, 5.0)]);
        data.expect_scene(&whole, &[2.0, 3.0, 5.0]);
        let (two, three) = (2.0_f64.ln(), 3.0_f64.ln());
        assert_eq!(scene(&data).unwrap(), [two, three, 0.5 * (two + three), 0.0]);
        data.expect_scene(&strokes(&[("a", 90.0, 6.0), ("d", 90.0, 6.0)]), &[2.0, 3.0]);
        assert_eq!(scene(&data).unwrap()[3], two);
        let before = scene(&data).unwrap();
        data.expect_scene(&strokes(&[("d", 80.0, 10.0)]), &[2.0]);
        assert_eq!(scene(&data).unwrap(), [before[0], before[1], before[2], 5.0_f64.ln()]);
    }
}
