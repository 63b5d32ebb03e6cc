use serde::{Deserialize, Serialize};
use soilctl_kinematics::TaskPose;

use super::{Action, Condition, Goto, SequenceId, Step, table};
use crate::estimate::Estimate;
use crate::events::EventKind;
use crate::{Events, Finish, Params, State, StrokeSpec};

/// How deep sequences may call each other.
pub const MOST_NESTED: usize = 4;

/// A running sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// Which.
    pub sequence: SequenceId,
    /// Its step.
    pub step: u8,
}

/// The running sequences and what they work on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    stack: [Option<Frame>; MOST_NESTED],
    depth: u8,
    /// How the sequence ended that was called last.
    returned: Option<bool>,
    /// The operator said to go on.
    pub(super) continued: bool,
    /// The stroke to make.
    pub stroke: StrokeSpec,
    /// Its number in the plan or sweep, from 0.
    pub index: u16,
    /// The batch of the stroke before.
    pub(super) batch: u16,
    /// Whether there is a stroke to make.
    pub(super) stroke_left: bool,
    /// Pose to return to.
    pub(super) remembered: TaskPose,
}

impl Machine {
    pub(crate) fn new(params: &Params) -> Self {
        Self {
            stack: [None; MOST_NESTED],
            depth: 0,
            returned: None,
            continued: false,
            stroke: super::actions::sweep_stroke(params, 0).unwrap_or_default(),
            index: 0,
            batch: 0,
            stroke_left: false,
            remembered: TaskPose::default(),
        }
    }

    /// The innermost running sequence.
    #[must_use]
    pub fn top(&self) -> Option<Frame> {
        self.stack.get(usize::from(self.depth).checked_sub(1)?).copied().flatten()
    }

    /// Whether a sequence runs.
    #[must_use]
    pub fn is_running(&self) -> bool {
        self.top().is_some()
    }

    pub(crate) fn is_homing(&self) -> bool {
        self.top().is_some_and(|frame| frame.sequence == SequenceId::Homing)
    }

    /// The innermost step.
    pub(crate) fn step(&self) -> Option<Step> {
        self.top().and_then(find)
    }

    /// Whether a sequence waits for the operator.
    #[must_use]
    pub fn waits(&self) -> bool {
        self.step().is_some_and(|step| step.next.iter().any(|next| next.when == Condition::Continued))
    }

    pub(crate) fn resume(&mut self) {
        self.continued = true;
    }

    pub(crate) fn abort(&mut self) {
        self.stack = [None; MOST_NESTED];
        self.depth = 0;
        self.returned = None;
        self.continued = false;
    }

    fn push(&mut self, sequence: SequenceId) -> bool {
        let Some(place) = self.stack.get_mut(usize::from(self.depth)) else { return false };
        *place = Some(Frame { sequence, step: 0 });
        self.depth += 1;
        true
    }

    fn pop(&mut self) {
        self.depth = self.depth.saturating_sub(1);
        if let Some(place) = self.stack.get_mut(usize::from(self.depth)) {
            *place = None;
        }
    }

    fn set_step(&mut self, step: u8) {
        let top = usize::from(self.depth).checked_sub(1).and_then(|top| self.stack.get_mut(top));
        if let Some(Some(frame)) = top {
            frame.step = step;
        }
    }
}

fn find(frame: Frame) -> Option<Step> {
    table(frame.sequence).steps.get(usize::from(frame.step)).copied()
}

/// Starts a sequence from the outside or from a step; says whether there was room.
pub(crate) fn start(
    state: &mut State,
    params: &Params,
    est: &Estimate,
    events: &mut Events,
    sequence: SequenceId,
) -> bool {
    if !state.machine.push(sequence) {
        return false;
    }
    events.say(EventKind::SequenceStarted(sequence));
    enter(state, params, est, events);
    true
}

/// One tick: at most one transition.
pub(crate) fn advance(state: &mut State, params: &Params, est: &Estimate, events: &mut Events) {
    let Some((frame, step)) = state.machine.top().and_then(|frame| Some((frame, find(frame)?))) else {
        return;
    };
    let Some(transition) = step.next.iter().find(|next| holds(state, params, next.when)) else { return };
    super::actions::leave(state, est, params, step.action, events);
    let at = usize::from(frame.step);
    match transition.go {
        Goto::Step(next) => {
            state.machine.set_step(next);
            events.push(EventKind::SequenceStep(frame.sequence), usize::from(next), 0.0, 0.0);
            enter(state, params, est, events);
        }
        Goto::Succeed => {
            if transition.when == Condition::NoLift {
                let delta_deg = state.machine.stroke.delta_rad.to_degrees();
                events.push(EventKind::FrictionFound, usize::from(state.machine.index), delta_deg, 0.0);
            }
            state.machine.pop();
            state.machine.returned = Some(true);
            events.push(EventKind::SequenceSucceeded(frame.sequence), at, 0.0, 0.0);
        }
        Goto::Fail => {
            state.machine.pop();
            state.machine.returned = Some(false);
            events.push(EventKind::SequenceFailed(frame.sequence), at, 0.0, 0.0);
        }
    }
}

fn enter(state: &mut State, params: &Params, est: &Estimate, events: &mut Events) {
    state.last_finish = None;
    state.machine.returned = None;
    state.machine.continued = false;
    let Some(step) = state.machine.step() else { return };
    if step.next.iter().any(|next| next.when == Condition::Continued) {
        events.push(EventKind::Waiting, usize::from(state.machine.index), 0.0, 0.0);
    }
    if let Action::Call(sequence) = step.action {
        if !start(state, params, est, events, sequence) {
            state.machine.returned = Some(false);
        }
        return;
    }
    super::actions::enter(state, params, est, step.action);
}

fn holds(state: &State, params: &Params, condition: Condition) -> bool {
    let machine = &state.machine;
    let done = state.idle && state.ring.is_empty();
    let settings = &params.config().stroke;
    match condition {
        Condition::Always => true,
        Condition::Done => done,
        Condition::Contact => done && state.last_finish == Some(Finish::Contact),
        Condition::Failed => done && state.last_finish.is_some_and(|finish| !finish.is_success()),
        Condition::CallSucceeded => machine.returned == Some(true),
        Condition::CallFailed => machine.returned == Some(false),
        Condition::StrokeLeft => machine.stroke_left && machine.stroke.batch == machine.batch,
        Condition::NewSoil => machine.stroke_left,
        Condition::NoLift => {
            state.last_stroke.travel_m >= settings.failure_travel_m
                && state.last_stroke.lift_rad.to_degrees() <= settings.lift_deg
                && state.last_stroke.rise_m <= settings.lift_rise_m
        }
        Condition::Continued => machine.continued,
    }
}
