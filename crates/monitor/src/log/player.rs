use std::sync::Arc;
use std::time::{Duration, Instant};

use super::track::Track;
use crate::feed::text;
use crate::messages::{PageMessage, PlayerState};
use crate::soil::{Known, Surface};
use soilctl_live::protocol::ServerMessage;

/// Time between two states.
const INTERVAL: Duration = Duration::from_millis(30);
/// Curves that a page gets when it goes to another time, in states.
const HISTORY: usize = 3750;
/// Slowest and fastest.
const SPEEDS: [f64; 2] = [0.01, 1000.0];

/// A page's own place in a log.
#[derive(Debug)]
pub(crate) struct Player {
    track: Arc<Track>,
    surface: Surface,
    /// States that the surface has followed.
    followed: usize,
    known: Known,
    /// The state that is shown.
    place: usize,
    time_s: f64,
    playing: bool,
    speed: f64,
    moved: Instant,
    sent: Option<Instant>,
    jumped: bool,
    told: Option<PlayerState>,
}

impl Player {
    /// At the beginning, or a time in s.
    pub(crate) fn new(track: Arc<Track>, from_s: f64) -> Result<Self, crate::MonitorError> {
        let surface = Surface::new(&track.scene)?;
        let now = Instant::now();
        let mut player = Self {
            surface,
            followed: 0,
            known: Known::default(),
            place: 0,
            time_s: 0.0,
            playing: false,
            speed: 1.0,
            moved: now,
            sent: None,
            jumped: true,
            told: None,
            track,
        };
        player.seek(from_s);
        Ok(player)
    }

    pub(crate) fn play(&mut self, now: Instant) {
        if self.is_at_end() {
            self.seek(0.0);
        }
        (self.playing, self.moved) = (true, now);
    }

    pub(crate) const fn pause(&mut self) {
        self.playing = false;
    }

    /// Goes to a time in s; beyond the ends to the ends.
    pub(crate) fn seek(&mut self, time_s: f64) {
        let [first_s, last_s] = self.span_s();
        self.time_s = time_s.max(first_s).min(last_s);
        self.place = self.track.place_s(self.time_s);
        self.jumped = true;
    }

    /// So many states further, or back; stands still there.
    pub(crate) fn step(&mut self, count: i32) {
        self.playing = false;
        let place = self.place.saturating_add_signed(isize::try_from(count).unwrap_or(0));
        self.seek(self.track.time_s(place.min(self.track.len().saturating_sub(1))));
    }

    /// How many times as fast as real time.
    pub(crate) fn set_speed(&mut self, speed: f64, now: Instant) -> Result<(), String> {
        let [slowest, fastest] = SPEEDS;
        if !(speed >= slowest && speed <= fastest) {
            return Err(format!("the speed is {speed}; it must be from {slowest} to {fastest}"));
        }
        self.go_on(now);
        self.speed = speed;
        Ok(())
    }

    fn span_s(&self) -> [f64; 2] {
        [self.track.time_s(0), self.track.time_s(usize::MAX)]
    }

    fn is_at_end(&self) -> bool {
        self.time_s >= self.span_s()[1]
    }

    fn go_on(&mut self, now: Instant) {
        if self.playing {
            let passed_s = now.saturating_duration_since(self.moved).as_secs_f64();
            self.time_s = (self.time_s + passed_s * self.speed).min(self.span_s()[1]);
            self.playing = !self.is_at_end();
        }
        self.moved = now;
    }

    /// What there is to tell now.
    pub(crate) fn poll(&mut self, now: Instant, tell: &mut dyn FnMut(String)) {
        let due = self.sent.is_none_or(|sent| now.saturating_duration_since(sent) >= INTERVAL);
        if !due && !self.jumped {
            return;
        }
        self.go_on(now);
        let place = self.track.place_s(self.time_s);
        let state = PlayerState {
            time_s: self.time_s,
            playing: self.playing,
            speed: self.speed,
            at_end: self.is_at_end(),
        };
        if self.jumped || place != self.place {
            let history = if self.jumped {
                self.track.history(place.saturating_sub(HISTORY), place, true)
            } else {
                self.track.history(self.place + 1, place, false)
            };
            self.surface_at(place);
            if let Some(patch) = self.known.update(self.surface.grid(), &self.surface.heights()) {
                tell(text(&PageMessage::Soil(patch)));
            }
            tell(text(&PageMessage::History(history)));
            tell(text(&ServerMessage::State(Box::new(self.track.state(place)))));
            self.place = place;
        }
        if self.told != Some(state) {
            tell(text(&PageMessage::Player(state)));
            self.told = Some(state);
        }
        (self.jumped, self.sent) = (false, Some(now));
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
            self.surface.follow(sample.true_deg(), sample.homed(), sample.waiting());
        }
        self.followed = wanted;
    }
}
