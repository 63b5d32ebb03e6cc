//! The trajectory handler: one trajectory is active, the ring holds those to come, and an empty ring means holding still.

use soilctl_kinematics::MotorTorques;

use crate::estimate::Estimate;
use crate::events::EventKind;
use crate::laws::joint_integral;
use crate::trajectory::{Active, Law, Setpoint, View};
use crate::{Events, Finish, Params, State, Trajectory};

/// Share of its torque that a joint keeps after it has touched its stop.
const TOUCH_SHARE: f64 = 0.2;

/// One tick of the active trajectory.
pub(crate) fn advance(state: &mut State, params: &Params, est: &Estimate, events: &mut Events) -> Setpoint {
    let tuning = state.tuning;
    let strain = strain(state, params, est);
    let view = View { params, est, tuning: &tuning, saturated_ticks: saturated_ticks(state), strain };
    // A step that queued something does not wait for the endless hold to end.
    let holding = state.idle || state.active.is_none_or(|active| is_endless_hold(&active));
    if holding && (!state.ring.is_empty() || state.active.is_none()) {
        begin_next(state, view, events);
    }
    let Some(mut active) = state.active else { return Setpoint::still(est.motor) };
    let held_by = active.hand.limit;
    let (setpoint, finish) = active.update(view);
    if active.hand.limit != held_by {
        events.push(EventKind::HandLimit(active.hand.limit), 0, active.hand.load, 1.0);
    }
    state.active = Some(active);
    let new_law = setpoint.law != state.setpoint.law;
    if setpoint.law == Law::Joint && (new_law || state.rebased.is_some()) {
        let share = state.rebased.unwrap_or(1.0);
        let torques = last_torques(state, params).map(|torque| share * torque);
        state.integral_nm = joint_integral(params, &setpoint, est, &torques);
    } else if new_law {
        state.integral_nm = [0.0; 5];
    }
    state.rebased = None;
    state.setpoint = setpoint;
    if let Some(finish) = finish {
        end(state, &active, view, finish, events);
    }
    setpoint
}

fn saturated_ticks(state: &State) -> u32 {
    state.monitors.saturated.into_iter().fold(0, u32::max)
}

/// Largest share of its limit that a torque of the tick before takes, of motor or joint, or that a joint's error of tracking takes of half of
/// what would be a fault.
fn strain(state: &State, params: &Params, est: &Estimate) -> f64 {
    let motors = params.config().motors.max_torque_nm;
    let joints = last_torques(state, params);
    (0..5).fold(0.0, |most: f64, i| {
        let error = state.setpoint.joints.0[i] - est.motor.0[i];
        most.max((state.motor_torques_nm[i] / motors[i]).abs())
            .max((joints[i] / params.max_joint_torque_nm[i]).abs())
            .max((2.0 * error / params.tracking_error_rad[i]).abs())
    })
}

/// Joint torques of the tick before in N m.
fn last_torques(state: &State, params: &Params) -> [f64; 5] {
    let motors = MotorTorques(state.motor_torques_nm);
    params.arm().transmission().joint_torques(&motors).unwrap_or_default().0
}

fn is_endless_hold(active: &Active) -> bool {
    active.trajectory == Trajectory::Hold { ticks: None }
}

fn end(state: &mut State, active: &Active, view: View<'_>, finish: Finish, events: &mut Events) {
    let kind = active.trajectory.kind();
    events.push(EventKind::TrajectoryEnded(kind, finish), 0, f64::from(active.ticks), 0.0);
    state.last_finish = Some(finish);
    match active.trajectory {
        Trajectory::Stroke { .. } => state.last_stroke = active.stroke,
        Trajectory::CartesianTouch { .. } => state.touched_m = active.onset_m,
        _ => {}
    }
    // What did not reach its wanted joints goes on from where the arm is, with the torques that it has there.
    // A hand that lets go in free air leaves the motors where they are: the links hang in their free play.
    let stays = finish == Finish::Completed || (finish == Finish::LetGo && state.setpoint.rests);
    if !stays || state.setpoint.law != Law::Joint {
        state.setpoint.joints = view.est.joints;
        // A joint need not stay pressed against its stop as hard as it was to find it.
        let touched = matches!(active.trajectory, Trajectory::JointTouch { .. });
        state.rebased = Some(if touched { TOUCH_SHARE } else { 1.0 });
    }
    if !finish.is_success() {
        state.ring.clear();
    }
    begin_next(state, view, events);
    if let Some(next) = state.active.as_mut().filter(|_| state.idle && finish == Finish::LetGo) {
        next.hand.holds = true;
    }
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
    state.setpoint = Setpoint::still(est.joints);
    state.rebased = Some(1.0);
    hold(state, View { params, est, tuning: &tuning, saturated_ticks: 0, strain: 0.0 }, est.joints);
}
