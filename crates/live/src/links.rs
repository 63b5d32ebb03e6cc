//! What the threads of a session share: lock-free rings, and counters of what they could not hold.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};

use rtrb::{Consumer, Producer, RingBuffer};
use soilctl_controller::{
    Commands, Event, FaultRecord, HandLimit, HandTarget, Outputs, Refusal, Request, Sensed,
};

use crate::hand::{HandFrame, TouchFrame};

/// States that wait for the server.
const STATES: usize = 256;
/// Events that wait for the server.
const EVENTS: usize = 4096;
/// Requests that wait for the servo, and answers that wait for the server. It asks for no more at a time.
pub(crate) const REQUESTS: usize = 64;

/// What one tick looked like.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Snapshot {
    pub(crate) sensed: Sensed,
    pub(crate) commands: Commands,
    pub(crate) outputs: Outputs,
    pub(crate) homed: bool,
    pub(crate) waiting: bool,
    pub(crate) paused: bool,
    pub(crate) fault: Option<FaultRecord>,
    pub(crate) stroke_radius_m: Option<f64>,
    pub(crate) safe_force_n: Option<f64>,
    pub(crate) led: Option<Led>,
    /// Ticks by which a session in real time has fallen behind the clock.
    pub(crate) behind_ticks: u64,
}

/// A plate that is led by hand.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Led {
    pub(crate) hand: u32,
    pub(crate) target: HandTarget,
    pub(crate) limit: HandLimit,
    pub(crate) load: f64,
}

/// What the server asks of the servo.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ask {
    /// Comes back in the answer.
    pub(crate) token: u64,
    pub(crate) what: What,
}

/// The kinds of [`Ask`].
#[derive(Debug, Clone, Copy)]
pub(crate) enum What {
    /// For the controller.
    Request(Request),
    /// Let simulated time go on for so many ticks.
    Advance(u32),
}

/// Hands, or what they touch, that wait for the other side.
const HANDS: usize = 16;

/// The servo's ends of a device.
pub(crate) struct HandEnds {
    pub(crate) hands: Consumer<HandFrame>,
    pub(crate) touches: Producer<TouchFrame>,
}

/// The other ends.
pub(crate) struct DeviceEnds {
    pub(crate) hands: Producer<HandFrame>,
    pub(crate) touches: Consumer<TouchFrame>,
}

/// Both ends of a device's rings.
pub(crate) fn device_links() -> (HandEnds, DeviceEnds) {
    let (hands_in, hands) = RingBuffer::new(HANDS);
    let (touches, touches_out) = RingBuffer::new(HANDS);
    (HandEnds { hands, touches }, DeviceEnds { hands: hands_in, touches: touches_out })
}

/// What became of an [`Ask`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Answer {
    pub(crate) token: u64,
    pub(crate) tick: u64,
    pub(crate) refused: Option<Refusal>,
}

/// Flags and counters of a session.
#[derive(Debug, Default)]
pub(crate) struct Shared {
    /// The session shall end.
    pub(crate) stop: AtomicBool,
    /// The servo has ended.
    pub(crate) ended: AtomicBool,
    /// The emergency stop is pressed.
    pub(crate) emergency_stop: AtomicBool,
    /// Rises as long as the server lives: the heartbeat of a session in real time.
    pub(crate) heartbeat: AtomicU32,
    /// Steps that are not in the log.
    pub(crate) log_dropped: AtomicU64,
    /// States that did not fit into their ring.
    pub(crate) states_dropped: AtomicU64,
    /// Events that did not fit into their ring.
    pub(crate) events_dropped: AtomicU64,
    /// The last tick.
    pub(crate) tick: AtomicU64,
}

/// The servo's ends.
pub(crate) struct ServoEnds {
    pub(crate) asks: Consumer<Ask>,
    pub(crate) answers: Producer<Answer>,
    states: Producer<Snapshot>,
    events: Producer<(u64, Event)>,
    pub(crate) shared: Arc<Shared>,
}

/// The server's ends.
pub(crate) struct ServerEnds {
    pub(crate) asks: Producer<Ask>,
    pub(crate) answers: Consumer<Answer>,
    pub(crate) states: Consumer<Snapshot>,
    pub(crate) events: Consumer<(u64, Event)>,
    pub(crate) shared: Arc<Shared>,
}

/// Both ends of new rings.
pub(crate) fn links() -> (ServoEnds, ServerEnds) {
    let shared = Arc::new(Shared::default());
    let (asks_in, asks) = RingBuffer::new(REQUESTS);
    let (answers, answers_out) = RingBuffer::new(REQUESTS);
    let (states, states_out) = RingBuffer::new(STATES);
    let (events, events_out) = RingBuffer::new(EVENTS);
    let servo = ServoEnds { asks, answers, states, events, shared: Arc::clone(&shared) };
    let server =
        ServerEnds { asks: asks_in, answers: answers_out, states: states_out, events: events_out, shared };
    (servo, server)
}

impl ServoEnds {
    /// Hands on a state; what does not fit is counted.
    pub(crate) fn state(&mut self, snapshot: Snapshot) {
        if self.states.push(snapshot).is_err() {
            self.shared.states_dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Hands on an event; what does not fit is counted.
    pub(crate) fn event(&mut self, tick: u64, event: Event) {
        if self.events.push((tick, event)).is_err() {
            self.shared.events_dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Answers; there is always room, since there are no more questions than places.
    pub(crate) fn answer(&mut self, token: u64, tick: u64, refused: Option<Refusal>) {
        let _ = self.answers.push(Answer { token, tick, refused });
    }
}
