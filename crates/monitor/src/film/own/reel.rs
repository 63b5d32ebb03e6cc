use std::sync::Arc;

use soilctl_live::protocol::ServerMessage;

use super::track::Track;
use crate::MonitorError;
use crate::film::{Reel, curve};
use crate::messages::{History, PageMessage, text};
use crate::soil::{Known, Surface};

/// States of a log and the surface of the soil that goes with them.
pub(in crate::film) struct OwnReel {
    track: Arc<Track>,
    surface: Surface,
    /// States that the surface has followed.
    followed: usize,
    known: Known,
}

impl OwnReel {
    pub(in crate::film) fn new(track: Arc<Track>) -> Result<Self, MonitorError> {
        Ok(Self { surface: Surface::new(&track.scene)?, followed: 0, known: Known::default(), track })
    }

    /// The surface as it is after a state.
    fn surface_at(&mut self, place: usize) {
        let wanted = place + 1;
        let kept = self.track.surfaces.partition_point(|(number, _)| *number <= wanted);
        let best = kept.checked_sub(1).and_then(|number| self.track.surfaces.get(number));
        if let Some((number, snapshot)) = best
            && (self.followed > wanted || self.followed < *number)
        {
            self.surface.restore(snapshot);
            self.followed = *number;
        }
        for sample in self.track.samples.get(self.followed..wanted).unwrap_or_default() {
            self.surface.follow(sample.true_deg(), None, sample.homed(), sample.waiting());
        }
        self.followed = wanted;
    }
}

impl Reel for OwnReel {
    fn place_s(&self, time_s: f64) -> usize {
        self.track.place_s(time_s)
    }

    fn time_s(&self, number: usize) -> f64 {
        self.track.time_s(number)
    }

    fn tell(&mut self, seen: Option<usize>, place: usize, tell: &mut dyn FnMut(String)) {
        let mut history = History { replace: seen.is_none(), ..History::default() };
        curve(seen, place).for_each(|number| history.push(&self.track.state(number)));
        self.surface_at(place);
        if let Some(patch) = self.known.update(self.surface.grid(), &self.surface.heights()) {
            tell(text(&PageMessage::Soil(patch)));
        }
        tell(text(&PageMessage::History(history)));
        tell(text(&ServerMessage::State(Box::new(self.track.state(place)))));
    }
}
