use serde::{Deserialize, Serialize};

use crate::config::StrokeLaw;
use crate::{SequenceId, StrokeSpec, Trajectory};

/// What the operator's side wants in one tick.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Commands {
    /// Must change at least every `safety.heartbeat_ticks` ticks while the arm is driven.
    pub heartbeat: u32,
    /// The emergency stop is pressed.
    pub emergency_stop: bool,
    /// At most one request for each tick.
    pub request: Option<Request>,
}

/// A request. What cannot be done is refused with [`EventKind::Refused`](crate::EventKind::Refused) and changes nothing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Switch the amplifiers on and hold the arm where it is. Only when off and without a fault.
    Enable,
    /// Switch the amplifiers off.
    Disable,
    /// Leave the safe state after a fault, to off. Refused while the emergency stop is pressed.
    Reset,
    /// Start a sequence. Only when no other runs and, but for homing, after homing.
    Start(SequenceId),
    /// End sequence and trajectories and hold the arm where it is.
    Abort,
    /// Append a trajectory to the ring. Only when no sequence runs. That of a hand begins only when nothing else is to be done; while it
    /// runs, another one of the same hand is where the hand is now, and one of another hand is refused.
    Push(Trajectory),
    /// Go on after a pause of a sequence: the soil is prepared.
    Continue,
    /// Switch storage on or off.
    Store(bool),
    /// Average the force sensor's bias from now on; the plate must be in free air.
    BiasForce,
    /// The stroke that insert-stroke-pullout makes.
    Stroke(StrokeSpec),
    /// The stroke of the plan at which a campaign begins, counted from 0.
    PlanIndex(u16),
    /// Change a value until the state is made anew.
    Tune(Tunable),
}

/// Values that may be changed during a run.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Tunable {
    /// Speed of moves as a fraction of the settings', 0.01 to 1.
    SpeedScale(f64),
    /// `l_rate` in m/s; above 0, at most 0.1.
    LeadRate(f64),
    /// Whether insertion accommodates.
    Accommodate(bool),
    /// Law of later strokes.
    Law(StrokeLaw),
}
