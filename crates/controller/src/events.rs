use serde::{Deserialize, Serialize};

use crate::{Fault, HandLimit, SequenceId, Trajectory};

/// Events that one tick can report; more are counted in [`Events::dropped`].
pub const MOST_EVENTS: usize = 24;

/// Something worth a line in a log.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// What happened.
    pub kind: EventKind,
    /// Joint, motor, channel, step or stroke, whichever fits the kind; 0 if none.
    pub index: u16,
    /// The number behind it; see the kind for its unit.
    pub value: f64,
    /// The limit that `value` is compared with, or 0.
    pub limit: f64,
}

/// What can happen.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum EventKind {
    /// A limit is broken; the arm is in the safe state. Value and limit in the fault's unit.
    Fault(Fault),
    /// A fault was reset.
    Reset,
    /// The amplifiers are on.
    Enabled,
    /// The amplifiers are off by request.
    Disabled,
    /// A request was refused.
    Refused(Refusal),
    /// A trajectory begins.
    TrajectoryStarted(TrajectoryKind),
    /// A trajectory ended; value: its ticks.
    TrajectoryEnded(TrajectoryKind, Finish),
    /// A sequence begins.
    SequenceStarted(SequenceId),
    /// A sequence goes to the step `index`.
    SequenceStep(SequenceId),
    /// A sequence ended well.
    SequenceSucceeded(SequenceId),
    /// A sequence gave up at the step `index`.
    SequenceFailed(SequenceId),
    /// All joints were at their stops; encoders are referenced.
    Homed,
    /// The force sensor's bias was taken; value: its force in N.
    BiasTaken,
    /// The soil's surface was found; value: its height in m.
    SurfaceFound,
    /// A wall was found; index 0 to 3 for +x, -x, +y, -y; value: the tip's coordinate in m.
    WallFound,
    /// The plate is inserted; value: depth of the lower edge in m; limit: the depth wanted.
    Inserted,
    /// A stroke ended; value: the largest force towards the base in N; limit: the lead in m.
    StrokeEnded,
    /// Rise of the force angle over its set-point at failure in degrees; limit: what counts as lifting.
    Lift,
    /// Rise of the plate after the soil failed in m; limit: what counts as lifting.
    Rise,
    /// The friction sweep's answer in degrees.
    FrictionFound,
    /// A sequence waits for [`Request::Continue`](crate::Request::Continue); index: the stroke to come.
    Waiting,
    /// Storage was switched on; index: number of the segment, modulo 65536.
    StorageOn,
    /// Storage was switched off.
    StorageOff,
    /// What holds the arm back while it follows a hand has changed; value: the load as a share of what is allowed.
    HandLimit(HandLimit),
}

/// Why a request was refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Refusal {
    /// Not in this mode: off, ready or fault.
    Mode,
    /// A sequence runs.
    Busy,
    /// The arm is not homed.
    NotHomed,
    /// The ring is full.
    RingFull,
    /// A number is not finite or not in its range.
    Value,
    /// Nothing waits.
    NothingWaits,
    /// The emergency stop is still pressed.
    EmergencyStop,
    /// Another hand leads the plate.
    OtherHand,
}

/// A trajectory without its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the names are those of `Trajectory`, which documents them")]
pub enum TrajectoryKind {
    Hold,
    JointMove,
    CartesianMove,
    JointTouch,
    CartesianTouch,
    Insert,
    Stroke,
    JointVelocity,
    Follow,
}

impl Trajectory {
    /// Which kind it is.
    #[must_use]
    pub const fn kind(&self) -> TrajectoryKind {
        match self {
            Self::Hold { .. } => TrajectoryKind::Hold,
            Self::JointMove { .. } => TrajectoryKind::JointMove,
            Self::CartesianMove { .. } => TrajectoryKind::CartesianMove,
            Self::JointTouch { .. } => TrajectoryKind::JointTouch,
            Self::CartesianTouch { .. } => TrajectoryKind::CartesianTouch,
            Self::Insert { .. } => TrajectoryKind::Insert,
            Self::Stroke { .. } => TrajectoryKind::Stroke,
            Self::JointVelocity { .. } => TrajectoryKind::JointVelocity,
            Self::Follow { .. } => TrajectoryKind::Follow,
        }
    }
}

/// How a trajectory ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Finish {
    /// It came to its end.
    Completed,
    /// It touched something.
    Contact,
    /// It went all its way without touching anything.
    NoContact,
    /// A stroke reached its longest way.
    TravelLimit,
    /// A stroke reached its largest lead.
    LeadLimit,
    /// A stroke took too long.
    TimeLimit,
    /// The arm cannot pull a stroke harder.
    TorqueLimit,
    /// The arm cannot go there.
    Unreachable,
    /// It was aborted.
    Aborted,
    /// The hand that led the plate let go, or its connection was lost.
    LetGo,
}

impl Finish {
    /// Whether it did what it was for.
    #[must_use]
    pub const fn is_success(self) -> bool {
        !matches!(self, Self::NoContact | Self::Unreachable | Self::Aborted)
    }
}

/// The events of one tick, in order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Events {
    list: [Event; MOST_EVENTS],
    length: usize,
    dropped: u32,
}

impl Default for Events {
    fn default() -> Self {
        let none = Event { kind: EventKind::Reset, index: 0, value: 0.0, limit: 0.0 };
        Self { list: [none; MOST_EVENTS], length: 0, dropped: 0 }
    }
}

impl Events {
    pub(crate) fn push(&mut self, kind: EventKind, index: usize, value: f64, limit: f64) {
        if let Some(place) = self.list.get_mut(self.length) {
            *place = Event { kind, index: u16::try_from(index).unwrap_or(u16::MAX), value, limit };
            self.length += 1;
        } else {
            self.dropped = self.dropped.saturating_add(1);
        }
    }

    pub(crate) fn say(&mut self, kind: EventKind) {
        self.push(kind, 0, 0.0, 0.0);
    }

    /// The events.
    #[must_use]
    pub fn as_slice(&self) -> &[Event] {
        self.list.get(..self.length).unwrap_or(&[])
    }

    /// How many more there were.
    #[must_use]
    pub const fn dropped(&self) -> u32 {
        self.dropped
    }
}
