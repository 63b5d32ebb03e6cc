//! The state machine: sequences of steps as tables, and what runs them.

mod actions;
mod machine;
mod tables;

use serde::{Deserialize, Serialize};
use soilctl_kinematics::Joint;

pub use machine::{Frame, MOST_NESTED, Machine};
pub(crate) use machine::{advance, start};
pub use tables::table;

/// A sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SequenceId {
    /// Each joint against its stop, then the encoders are referenced and the arm is parked.
    Homing,
    /// The box's walls, from where the plate is: +x, -x, +y, -y.
    WallSensing,
    /// One stroke, from above the soil.
    InsertStrokePullout,
    /// All strokes of the plan; waits for the soil between batches.
    Campaign,
    /// Strokes with a growing friction angle until the plate no longer lifts (section 5.4).
    FrictionSweep,
}

impl SequenceId {
    /// All sequences.
    pub const ALL: [Self; 5] =
        [Self::Homing, Self::WallSensing, Self::InsertStrokePullout, Self::Campaign, Self::FrictionSweep];
}

/// A sequence as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sequence {
    /// Its name in logs and commands.
    pub name: &'static str,
    /// Its steps; it begins with the first.
    pub steps: &'static [Step],
}

/// A step: what is done on entering it, and where it leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    /// Its name in logs.
    pub name: &'static str,
    /// What is done on entering it.
    pub action: Action,
    /// Whether the ticks of this step are stored.
    pub store: bool,
    /// Where it leads: the first condition that holds, at most one a tick.
    pub next: &'static [Transition],
}

/// Where a step leads and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// When.
    pub when: Condition,
    /// Where to.
    pub go: Goto,
}

/// When a step is left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// At once.
    Always,
    /// Its trajectories are done.
    Done,
    /// Its last trajectory ended with a contact.
    Contact,
    /// One of its trajectories failed.
    Failed,
    /// The sequence it called succeeded.
    CallSucceeded,
    /// The sequence it called failed.
    CallFailed,
    /// There is a stroke to make in the same preparation of the soil.
    StrokeLeft,
    /// There is a stroke to make, but the soil must be prepared first.
    NewSoil,
    /// The soil failed in the last stroke, and the plate did not lift.
    NoLift,
    /// The operator said so.
    Continued,
}

/// Where to go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Goto {
    /// To the step of this number.
    Step(u8),
    /// Back to the caller, well done.
    Succeed,
    /// Back to the caller, in vain.
    Fail,
}

/// What a step does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// Nothing: hold.
    Wait,
    /// Move a joint against its stop.
    TouchStop(Joint),
    /// All joints are at their stops: reference the encoders.
    SetHome,
    /// Move to the parking posture.
    Park,
    /// Average the force sensor's bias.
    Bias,
    /// Down to the soil.
    TouchSoil,
    /// Push the plate in.
    Insert,
    /// Pull it.
    Stroke,
    /// Straight up to the transit height.
    PullOut,
    /// Remember the pose.
    Remember,
    /// Move the tip to a wall: 0 to 3 for +x, -x, +y, -y.
    TouchWall(u8),
    /// Back to the remembered pose.
    Return,
    /// Run another sequence.
    Call(SequenceId),
    /// Take the stroke at which the plan stands.
    PlanFirst,
    /// Take the next stroke of the plan.
    PlanNext,
    /// Take the first stroke of the friction sweep.
    SweepFirst,
    /// Take its next stroke.
    SweepNext,
    /// Over the place of the stroke, at the clearance height, by way of the transit height.
    GoToStroke,
}
