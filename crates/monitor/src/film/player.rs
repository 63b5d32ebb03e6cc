use std::time::{Duration, Instant};

use super::Reel;
use crate::messages::{PageMessage, PlayerState, text};

/// Time between two states.
const INTERVAL: Duration = Duration::from_millis(30);
/// Slowest and fastest.
const SPEEDS: [f64; 2] = [0.01, 1000.0];

/// A page's own place in a log.
pub(crate) struct Player {
    reel: Box<dyn Reel>,
    /// The state that is shown.
    place: usize,
    time_s: f64,
    playing: bool,
    speed: f64,
    moved: Instant,
    sent: Option<Instant>,
    jumped: bool,
    /// The last request, by its id.
    heard: u64,
    told: Option<PlayerState>,
}

impl Player {
    /// At a time in s.
    pub(super) fn new(reel: Box<dyn Reel>, from_s: f64) -> Self {
        let mut player = Self {
            reel,
            place: 0,
            time_s: 0.0,
            playing: false,
            speed: 1.0,
            moved: Instant::now(),
            sent: None,
            jumped: true,
            heard: 0,
            told: None,
        };
        player.seek(from_s);
        player
    }

    pub(crate) fn play(&mut self, now: Instant) {
        if self.is_at_end() {
            self.seek(f64::MIN);
        }
        (self.playing, self.moved) = (true, now);
    }

    pub(crate) const fn pause(&mut self) {
        self.playing = false;
    }

    /// A request, by its id, is carried out or refused.
    pub(crate) const fn hear(&mut self, id: u64) {
        self.heard = id;
    }

    /// Goes to a time in s; beyond the ends to the ends.
    pub(crate) fn seek(&mut self, time_s: f64) {
        let [first_s, last_s] = self.span_s();
        self.time_s = time_s.max(first_s).min(last_s);
        self.place = self.reel.place_s(self.time_s);
        self.jumped = true;
    }

    /// So many states further, or back; stands still there.
    pub(crate) fn step(&mut self, count: i32) {
        self.playing = false;
        let place = self.place.saturating_add_signed(isize::try_from(count).unwrap_or(0));
        self.seek(self.reel.time_s(place));
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
        [self.reel.time_s(0), self.reel.time_s(usize::MAX)]
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
        let place = self.reel.place_s(self.time_s);
        let state = PlayerState {
            time_s: self.time_s,
            playing: self.playing,
            speed: self.speed,
            at_end: self.is_at_end(),
            id: self.heard,
        };
        if self.jumped || place != self.place {
            let seen = (!self.jumped).then_some(self.place);
            self.reel.tell(seen, place, tell);
            self.place = place;
        }
        if self.told != Some(state) {
            tell(text(&PageMessage::Player(state)));
            self.told = Some(state);
        }
        (self.jumped, self.sent) = (false, Some(now));
    }
}
