//! A log: read once, kept small, played by each page for itself.

mod bag;
mod own;
mod player;

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

pub(crate) use self::player::Player;
use crate::MonitorError;
use crate::messages::{PageMessage, text};
use soilctl_live::protocol::ServerMessage;
use soilctl_motion::Settings;
use soilctl_session::is_own;

/// What a player plays: states in the order of time.
trait Reel: Send {
    /// Number of the last state that is not after a time in s.
    fn place_s(&self, time_s: f64) -> usize;

    /// Time of a state in s; of the last one beyond the end.
    fn time_s(&self, number: usize) -> f64;

    /// Tells what a page needs to show a state. `seen` is the state that it showed before, whose curves go on; none if they
    /// begin anew.
    fn tell(&mut self, seen: Option<usize>, place: usize, tell: &mut dyn FnMut(String));
}

/// A log that was read.
#[derive(Debug, Clone)]
pub(crate) enum Film {
    /// A log of our own controller.
    Own(Arc<own::Track>),
    /// A bag of any program.
    Bag(Arc<bag::Track>),
}

impl Film {
    /// Reads a log; as a bag if it is not one of ours, or if the settings say how.
    pub(crate) fn load(path: &Path, settings: &Settings) -> Result<Self, MonitorError> {
        if *settings == Settings::default()
            && is_own(path, &AtomicBool::new(false))
            && let Some(track) = own::load(path)?
        {
            return Ok(Self::Own(Arc::new(track)));
        }
        Ok(Self::Bag(Arc::new(bag::load(path, settings)?)))
    }

    /// What each page is greeted with.
    pub(crate) fn greeting(&self, path: &Path) -> Vec<String> {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
        let (hello, scene, log) = match self {
            Self::Own(track) => {
                (track.hello.clone(), track.scene.message(&name, false, false), track.message())
            }
            Self::Bag(track) => (track.hello(), track.scene(&name), track.message()),
        };
        vec![
            text(&ServerMessage::Hello(hello)),
            text(&PageMessage::Scene(Box::new(scene))),
            text(&PageMessage::Log(&log)),
        ]
    }

    /// What is wrong with the file; that is left out.
    pub(crate) fn damage(&self) -> &[String] {
        match self {
            Self::Own(track) => track.damage(),
            Self::Bag(track) => track.damage(),
        }
    }

    /// What was odd, or could not be used.
    pub(crate) fn notes(&self) -> &[String] {
        match self {
            Self::Own(_) => &[],
            Self::Bag(track) => track.notes(),
        }
    }

    /// Meshes that pages ask for by their numbers.
    pub(crate) fn meshes(&self) -> Vec<Arc<[u8]>> {
        match self {
            Self::Own(_) => Vec::new(),
            Self::Bag(track) => track.meshes().to_vec(),
        }
    }

    /// A page's own place in it, beginning at a time in s.
    pub(crate) fn player(&self, from_s: f64) -> Result<Player, MonitorError> {
        Ok(Player::new(
            match self {
                Self::Own(track) => Box::new(own::OwnReel::new(Arc::clone(track))?),
                Self::Bag(track) => Box::new(Arc::clone(track)),
            },
            from_s,
        ))
    }
}

/// Curves that a page gets when it goes to another time, in states.
const HISTORY: usize = 3750;
/// Points of a curve that a page gets at once.
const MOST_POINTS: usize = 1500;
/// Parts of the overview.
const OVERVIEW: usize = 600;

/// Lets every second one go, the first one stays.
fn halve<T>(list: &mut Vec<T>) {
    let mut keep = false;
    list.retain(|_| {
        keep = !keep;
        keep
    });
}

/// States whose curves a page gets for a state, at most [`MOST_POINTS`] of them, the last one always.
fn curve(seen: Option<usize>, place: usize) -> impl Iterator<Item = usize> {
    let from = seen.map_or(place.saturating_sub(HISTORY), |seen| seen + 1);
    let stride = (place.saturating_sub(from) / MOST_POINTS).max(1);
    (from..=place).filter(move |number| (place - number).is_multiple_of(stride))
}

/// The largest values in even parts.
fn overview(values: impl ExactSizeIterator<Item = f32>) -> Vec<f32> {
    let count = values.len().max(1);
    let mut largest = vec![0.0_f32; OVERVIEW.min(count)];
    let parts = largest.len();
    for (number, value) in values.enumerate() {
        if let Some(part) = largest.get_mut(number * parts / count) {
            *part = part.max(value);
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_go_on_without_a_gap_and_end_at_the_state() {
        assert_eq!(curve(Some(4), 7).collect::<Vec<_>>(), [5, 6, 7]);
        assert_eq!(curve(None, 2).collect::<Vec<_>>(), [0, 1, 2]);
        let long: Vec<_> = curve(None, 100_000).collect();
        assert!(long.len() <= 2 * MOST_POINTS && long.last() == Some(&100_000));
    }

    #[test]
    fn an_overview_keeps_the_largest() {
        let largest = overview((0..6000_u16).map(|n| if n == 3333 { 9.0 } else { 1.0 }));
        assert_eq!((largest.len(), largest[333], largest[332]), (OVERVIEW, 9.0, 1.0));
        assert_eq!(overview([].into_iter()), [0.0]);
    }
}
