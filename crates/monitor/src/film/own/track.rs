use soilctl_live::protocol::{Event, Hello, StateMessage};

use super::sample::{Sample, Words};
use crate::film::{halve, overview};
use crate::messages::{LogMessage, StrokeSpan};
use crate::scene::Scene;
use crate::soil::Snapshot;

/// States that are kept. When there are more, every second one goes, so that memory stays bounded: 2.3 h at full rate.
const MOST_SAMPLES: usize = 1 << 18;
/// Events that are kept.
pub(super) const MOST_EVENTS: usize = 4000;

/// A log, ready to be played.
#[derive(Debug)]
pub(crate) struct Track {
    pub(crate) hello: Hello,
    pub(crate) scene: Scene,
    pub(super) samples: Vec<Sample>,
    pub(super) words: Words,
    /// Every so many states of 31 a second is kept.
    pub(super) stride: u64,
    pub(super) events: Vec<Event>,
    pub(super) events_left_out: usize,
    pub(super) strokes: Vec<StrokeSpan>,
    pub(super) damage: Vec<String>,
    /// The surface before the sample with this number.
    pub(super) surfaces: Vec<(usize, Snapshot)>,
}

impl Track {
    /// Adds a state, if it is one that is kept; `number` counts them all.
    pub(super) fn push(&mut self, number: u64, state: &StateMessage, true_deg: [f64; 5]) -> bool {
        if !number.is_multiple_of(self.stride) {
            return false;
        }
        self.samples.push(Sample::new(state, true_deg, &mut self.words));
        true
    }

    /// Whether there are as many states as may be kept.
    pub(super) fn is_full(&self) -> bool {
        self.samples.len() >= MOST_SAMPLES
    }

    /// Lets every second state go. Numbers of samples in `surfaces` follow.
    pub(super) fn thin(&mut self) {
        halve(&mut self.samples);
        self.stride *= 2;
        for (number, _) in &mut self.surfaces {
            *number /= 2;
        }
    }

    /// How many states there are.
    pub(crate) fn len(&self) -> usize {
        self.samples.len()
    }

    /// A state; the last one beyond the end.
    pub(crate) fn state(&self, number: usize) -> StateMessage {
        let sample = self.samples.get(number).or(self.samples.last());
        let state = sample.map(|sample| sample.state(&self.words)).unwrap_or_default();
        // A log does not hold it, but the table and the angle of which it is made.
        let safe_force_n = state.friction_angle_deg.and_then(|angle_deg| self.scene.safe_force_n(angle_deg));
        StateMessage { safe_force_n, ..state }
    }

    /// Time of a state in s.
    pub(crate) fn time_s(&self, number: usize) -> f64 {
        self.samples.get(number).or(self.samples.last()).map_or(0.0, Sample::time_s)
    }

    /// Number of the last state that is not after a time in s.
    pub(crate) fn place_s(&self, time_s: f64) -> usize {
        // Times such as 0.1 s are no floating-point numbers.
        self.samples.partition_point(|sample| sample.time_s() <= time_s + 1e-9).saturating_sub(1)
    }

    /// What is wrong with the file.
    pub(crate) fn damage(&self) -> &[String] {
        &self.damage
    }

    /// The log as a whole.
    pub(crate) fn message(&self) -> LogMessage {
        let (from_s, to_s) = (self.time_s(0), self.time_s(usize::MAX));
        #[allow(clippy::cast_precision_loss, reason = "small")]
        let state_s = self.stride as f64 * 0.032;
        LogMessage {
            from_s,
            to_s,
            state_s,
            strokes: self.strokes.clone(),
            events: self.events.clone(),
            events_left_out: self.events_left_out,
            overview_n: overview(self.samples.iter().map(Sample::force_n)),
            damage: self.damage.clone(),
            notes: Vec::new(),
        }
    }
}
