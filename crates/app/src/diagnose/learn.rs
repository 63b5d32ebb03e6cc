//! How the simulated arm shows effects: single strokes like those of the campaign, without and with each effect, by the same noise; and how
//! their readings vary together, by other noise.

use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::Instant;

use soilctl_campaign::{CampaignError, Plan, Setting};
use soilctl_diagnosis::{Data, Learnt, RecordedTraces, Shown, simulated_as};
use soilctl_effects::{Effect, EffectEntry, EffectId, ModelFile, ParameterValue};
use soilctl_jobs::each;
use soilctl_strokes::Campaign;

use super::kept::{Kept, kept};
use crate::machine::cores;
use crate::watch::Silent;
use crate::{AppError, Interrupted, Watch};

/// Noise of the single strokes: the same without and with an effect, so that what differs is the effect.
const SEED: u64 = 0x1ea2;
/// How often the single strokes are made once more with other noise, which tells how the readings of a stroke vary together.
const REPEATS: u64 = 4;
/// Steps in deg and kg/m3 to which the soil of single strokes is rounded: responses are differences, which change little with the soil, and
/// campaigns in much the same soil share them. It is the soil as it was known before the strokes were looked at, for an effect that is there
/// moves the fitted one.
const SOIL_STEPS: [f64; 2] = [2.0, 50.0];

/// Mean depth in m that model files of single strokes have.
const REFERENCE_DEPTH_M: f64 = 0.025;

/// Whether work came to its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Progress {
    /// All of it is done.
    Done,
    /// The user ended it; what is finished is kept.
    Stopped,
}

/// Strokes of one kind each on the simulated arm.
pub(super) struct Learning<'a> {
    plan: Plan,
    /// The soil as it was known before, rounded, without effects that are looked for.
    plain: ModelFile,
    campaign: &'a Campaign,
    /// Where tables are kept: each in a folder that is named by what it is of.
    store: &'a Path,
    watch: &'a dyn Watch,
}

impl<'a> Learning<'a> {
    /// Strokes like those of a plan.
    pub(super) fn new(
        plan: &Plan,
        plain: &ModelFile,
        data: &Data,
        campaign: &'a Campaign,
        store: &'a Path,
        watch: &'a dyn Watch,
    ) -> Result<Self, AppError> {
        Ok(Self { plan: plan.apart()?, plain: known_before(plain, data), campaign, store, watch })
    }

    /// Learns all effects that are not known and whose formulas do not know the controller.
    pub(super) fn all(&self, data: &mut Data, candidates: &[EffectId]) -> Result<Progress, AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        let stopped = || stop.load(Ordering::Relaxed);
        let wanted: Vec<(EffectId, EffectId)> = candidates
            .iter()
            .filter(|id| id.effect().site.passes_the_controller())
            .filter_map(|id| Some((*id, simulated_as(*id)?)))
            .collect();
        let mut simulated: Vec<EffectId> = wanted.iter().map(|(_, of)| *of).collect();
        simulated.sort_unstable();
        simulated.dedup();
        let others = self.others(&simulated)?;
        let runs = 1 + others.len();
        let each = self.plan.strokes().strokes().len();
        let clock = Instant::now();
        let Some(plain) = self.table(&self.plan, &self.plain)? else {
            if stopped() {
                return Ok(Progress::Stopped);
            }
            self.watch.note("no single stroke of the simulated arm has a failure force: effects are judged by their formulas");
            return Ok(Progress::Done);
        };
        self.watch.note(&format!(
            "how the simulated arm shows {} effects, and {} of its settings that nobody measures: {runs} times {each} single strokes, at most \
             {:.0} min by the first {each}; what is there of an earlier run is used",
            simulated.len(),
            Setting::ALL.len(),
            clock.elapsed().as_secs_f64() * runs as f64 / 60.0
        ));
        if self.make(&others)? == Progress::Stopped {
            return Ok(Progress::Stopped);
        }
        // What settings do tells by how much strokes go their own way.
        if self.settings(data, &plain)? == Progress::Stopped {
            return Ok(Progress::Stopped);
        }
        for id in simulated {
            let effect = id.effect();
            let mut tables = Vec::new();
            for amplitude in amplitudes(effect) {
                match self.table(&self.plan, &with(&self.plain, effect, amplitude)) {
                    Ok(Some(table)) => tables.push((amplitude, table)),
                    Ok(None) if stopped() => return Ok(Progress::Stopped),
                    Ok(None) => {}
                    Err(AppError::Campaign(problem @ CampaignError::Effect { .. })) => {
                        self.watch.note(&problem.to_string());
                    }
                    Err(problem) => return Err(problem),
                }
            }
            // Amplitudes under which no soil fails are left out; a sign that has none left cannot be that of a campaign that has failures.
            if tables.is_empty() {
                self.watch
                    .note(&format!("{id} lets no single stroke fail the soil: it is judged by its formula"));
                continue;
            }
            let shown: Vec<Shown<'_>> =
                tables.iter().map(|(amplitude, with)| Shown { amplitude: *amplitude, with }).collect();
            for (wanted, _) in wanted.iter().filter(|(_, of)| *of == id) {
                data.learn(*wanted, Learnt::new(wanted.effect(), data, &plain, &shown));
            }
        }
        self.noise(data, &plain)
    }

    /// Plan, model file and seed of all tables but the first: settings, effects and other noise.
    fn others(&self, effects: &[EffectId]) -> Result<Vec<(Plan, ModelFile, u64)>, AppError> {
        let mut all: Vec<(Plan, ModelFile, u64)> = Vec::new();
        for setting in Setting::ALL {
            for factor in [setting.most(), 1.0 / setting.most()] {
                all.push((self.plan.with_setting(setting, factor)?, self.plain.clone(), SEED));
            }
        }
        for effect in effects.iter().map(|id| id.effect()) {
            let files = amplitudes(effect).into_iter().map(|amplitude| with(&self.plain, effect, amplitude));
            all.extend(files.map(|file| (self.plan.clone(), file, SEED)));
        }
        all.extend((1..=REPEATS).map(|further| (self.plan.clone(), self.plain.clone(), SEED + further)));
        Ok(all)
    }

    /// Makes all of these tables that are not there, side by side: single strokes of one table leave cores idle at its end.
    fn make(&self, all: &[(Plan, ModelFile, u64)]) -> Result<Progress, AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        self.watch.begin(all.len() as u64, "times the single strokes");
        let made = each(
            all,
            cores(),
            &stop,
            |(plan, file, seed)| match kept(plan, file, *seed, None, self.store, (1, &Silent(self.watch))) {
                // Whoever asks for it is told.
                Err(AppError::Campaign(CampaignError::Effect { .. })) | Ok(_) => Ok(Some(())),
                Err(problem) => Err(problem),
            },
            |_, ()| {
                self.watch.advance(1);
                Ok(())
            },
        );
        self.watch.end();
        made?;
        Ok(if stop.load(Ordering::Relaxed) { Progress::Stopped } else { Progress::Done })
    }

    /// Learns how the readings of a stroke vary together.
    fn noise(&self, data: &mut Data, plain: &Data) -> Result<Progress, AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        let mut others = Vec::new();
        for further in 1..=REPEATS {
            match self.table_of(&self.plan, &self.plain, SEED + further)? {
                Some(table) => others.push(table),
                None if stop.load(Ordering::Relaxed) => return Ok(Progress::Stopped),
                None => {}
            }
        }
        if !data.vary_as(&std::iter::once(plain).chain(&others).collect::<Vec<_>>()) {
            self.watch.note("too few single strokes fail the soil again to tell how readings of a stroke vary together: they are weighed as independent");
        }
        Ok(Progress::Done)
    }

    /// Learns what the settings do in which the simulated arm may be off.
    fn settings(&self, data: &mut Data, plain: &Data) -> Result<Progress, AppError> {
        let stop = self.watch.stop(Interrupted::KeepsResults);
        for setting in Setting::ALL {
            let off = |factor: f64| self.table(&self.plan.with_setting(setting, factor)?, &self.plain);
            let (up, down) = (off(setting.most())?, off(1.0 / setting.most())?);
            match (up, down) {
                (Some(up), Some(down)) => data.doubt(Learnt::of_setting(data, plain, &up, &down)),
                (None, _) | (_, None) if stop.load(Ordering::Relaxed) => return Ok(Progress::Stopped),
                (None, _) | (_, None) => self.watch.note(&format!(
                    "{} off by a factor of {} lets no single stroke fail the soil: taken as it is",
                    setting.name(),
                    setting.most()
                )),
            }
        }
        Ok(Progress::Done)
    }

    /// Strokes with the soil and the effects of a model file; `None` if no stroke has a failure force, or it was stopped.
    fn table(&self, plan: &Plan, file: &ModelFile) -> Result<Option<Data>, AppError> {
        self.table_of(plan, file, SEED)
    }

    /// The same under a seed of its own.
    fn table_of(&self, plan: &Plan, file: &ModelFile, seed: u64) -> Result<Option<Data>, AppError> {
        let Some(Kept { strokes, traces }) = kept(plan, file, seed, None, self.store, (cores(), self.watch))?
        else {
            return Ok(None);
        };
        let mut data = Data::new(strokes.name(), strokes.rows().collect(), self.campaign.clone())?;
        let _ = RecordedTraces::read(&traces, &strokes)?.add_to(&mut data);
        data.compare_everything();
        Ok(Some(data))
    }
}

/// A model file of the soil as it was known before, in round numbers, and nothing of the campaign that it was fitted to but the effects.
fn known_before(plain: &ModelFile, data: &Data) -> ModelFile {
    let mut file = plain.clone();
    let soil = &mut file.soil;
    let [deg, kg_m3] = SOIL_STEPS;
    let set_deg = data.reference.delta_set_deg.unwrap_or(soil.delta_deg.value);
    for (entry, value) in [
        (&mut soil.phi_deg, (data.phi.mean / deg).round() * deg),
        (&mut soil.delta_deg, (set_deg / deg).round() * deg),
        (&mut soil.delta_offset_deg, 0.0),
        (&mut soil.density_kg_m3, (data.density.mean / kg_m3).round() * kg_m3),
    ] {
        (entry.value, entry.sd) = (value, 0.0);
    }
    "hand".clone_into(&mut file.status);
    (file.equivalence_set, file.held_out, file.data_hash) = (Vec::new(), None, String::new());
    let reference = &mut file.reference;
    // Single strokes have neither clock nor neighbours, and no effect that is learnt refers to a mean depth or angle.
    (reference.time_s, reference.base_deg, reference.speed_mps, reference.delta_set_deg) =
        (None, None, None, None);
    (reference.depth_m, reference.alpha_deg) = (REFERENCE_DEPTH_M, 90.0);
    reference.batches.clear();
    file
}

/// Amplitudes that are simulated: the middle and the end of what is plausible, of each sign.
fn amplitudes(effect: &Effect) -> Vec<f64> {
    let range = effect.range;
    range.signs().iter().flat_map(|sign| [sign * range.typical(), sign * range.high]).collect()
}

/// The model file with one more effect.
pub(super) fn with(plain: &ModelFile, effect: &Effect, amplitude: f64) -> ModelFile {
    let value = |value: f64, unit: &str| ParameterValue { value, sd: 0.0, unit: unit.to_owned() };
    let shape = effect.simulated_shape();
    let mut parameters = std::collections::BTreeMap::from([(
        effect.parameter.name.to_owned(),
        value(amplitude, effect.parameter.unit),
    )]);
    if let Some(parameter) = effect.shape.and_then(|shape| shape.parameter) {
        parameters.insert(parameter.name.to_owned(), value(shape, parameter.unit));
    }
    let mut file = plain.clone();
    file.effects.push(EffectEntry { id: effect.id, parameters, shape, log_bayes_factor: 0.0 });
    file
}
