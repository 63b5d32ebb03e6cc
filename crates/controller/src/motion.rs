//! The trajectory handler: one trajectory is active, the ring holds those to come, and an empty ring means holding still.

use crate::estimate::Estimate;
use crate::events::EventKind;
use crate::trajectory::{Active, Law, Setpoint, View};
use crate::{Events, Finish, Params, State, Trajectory};

/// One tick of the active trajectory.
pub(crate) fn advance(state: &mut State, params: &Params, est: &Estimate, events: &mut Events) -> Setpoint {
    let tuning = state.tuning;
    let view = View { params, est, tuning: &tuning };
    // A step that queued something does not wait for the endless hold to end.
    let holding = state.idle || state.active.is_none_or(|active| is_endless_hold(&active));
    if holding && (!state.ring.is_empty() || state.active.is_none()) {
        begin_next(state, view, events);
    }
    let Some(mut active) = state.active else { return Setpoint::still(est.motor) };
    let (setpoint, finish) = active.update(view);
    state.active = Some(active);
    if setpoint.law != state.setpoint.law {
        state.integral_nm = [0.0; 5];
    }
    state.setpoint = setpoint;
    if let Some(finish) = finish {
        end(state, &active, view, finish, events);
    }
    setpoint
}

fn is_endless_hold(active: &Active) -> bool {
    active.trajectory == Trajectory::Hold { ticks: None }
}

fn end(state: &mut State, active: &Active, view: View<'_>, finish: Finish, events: &mut Events) {
    let kind = active.trajectory.kind();
    events.push(EventKind::TrajectoryEnded(kind, finish), 0, f64::from(active.ticks), 0.0);
    state.last_finish = Some(finish);
    if matches!(active.trajectory, Trajectory::Stroke { .. }) {
        state.last_stroke = active.stroke;
    }
    // What did not reach its wanted joints goes on from where the arm is, so that nothing stays wound up.
    if finish != Finish::Completed || state.setpoint.law != Law::Joint {
        state.setpoint.joints = view.est.motor;
    }
    if !finish.is_success() {
        state.ring.clear();
    }
    begin_next(state, view, events);
}

fn begin_next(state: &mut State, view: View<'_>, events: &mut Events) {
    let from = state.setpoint.joints;
    if let Some(trajectory) = state.ring.pop() {
        match Active::start(trajectory, view, from) {
            Ok(active) => {
                state.active = Some(active);
                state.idle = false;
                events.say(EventKind::TrajectoryStarted(trajectory.kind()));
                return;
            }
            Err(finish) => {
                events.say(EventKind::TrajectoryEnded(trajectory.kind(), finish));
                state.last_finish = Some(finish);
                state.ring.clear();
            }
        }
    }
    hold(state, view, from);
}

/// Holds still at these joints until something else is to be done.
fn hold(state: &mut State, view: View<'_>, joints: soilctl_kinematics::JointAngles) {
    state.active = Active::start(Trajectory::Hold { ticks: None }, view, joints).ok();
    state.idle = true;
}

/// Ends everything and holds the arm where it is.
pub(crate) fn stop_here(state: &mut State, params: &Params, est: &Estimate) {
    let tuning = state.tuning;
    state.ring.clear();
    state.setpoint = Setpoint::still(est.motor);
    state.integral_nm = [0.0; 5];
    hold(state, View { params, est, tuning: &tuning }, est.motor);
}
