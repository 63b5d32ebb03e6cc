//! What the operator's side asks for.

use soilctl_kinematics::KinematicsError;

use crate::estimate::Estimate;
use crate::events::{EventKind, Refusal};
use crate::sequence;
use crate::trajectory::Active;
use crate::{
    Commands, Events, Mode, Params, Request, SequenceId, State, StrokeSpec, Trajectory, Tunable, motion,
};

/// Answers the tick's request. What is refused changes nothing.
pub(crate) fn answer(
    state: &mut State,
    params: &Params,
    est: Option<&Estimate>,
    commands: &Commands,
    events: &mut Events,
) {
    let Some(request) = commands.request else { return };
    if let Err(refusal) = grant(state, params, est, commands, events, request) {
        events.say(EventKind::Refused(refusal));
    }
}

fn grant(
    state: &mut State,
    params: &Params,
    est: Option<&Estimate>,
    commands: &Commands,
    events: &mut Events,
    request: Request,
) -> Result<(), Refusal> {
    match request {
        Request::Enable => {
            let est = est.filter(|_| state.mode == Mode::Off).ok_or(Refusal::Mode)?;
            state.stop();
            state.mode = Mode::Ready;
            motion::stop_here(state, params, est);
            events.say(EventKind::Enabled);
        }
        Request::Disable => {
            require(state.mode == Mode::Ready, Refusal::Mode)?;
            state.stop();
            state.mode = Mode::Off;
            events.say(EventKind::Disabled);
        }
        Request::Reset => {
            require(state.mode == Mode::Fault, Refusal::Mode)?;
            require(!commands.emergency_stop, Refusal::EmergencyStop)?;
            state.stop();
            state.mode = Mode::Off;
            state.fault = None;
            state.reported = 0;
            // What the filters hold may stem from the fault.
            state.filters.primed = false;
            state.monitors.same_wrench = 0;
            events.say(EventKind::Reset);
        }
        Request::Start(id) => {
            let est = ready(state, est)?;
            require(!state.machine.is_running(), Refusal::Busy)?;
            require(state.homed || id == SequenceId::Homing, Refusal::NotHomed)?;
            motion::stop_here(state, params, est);
            sequence::start(state, params, est, events, id);
        }
        Request::Abort => {
            let est = ready(state, est)?;
            state.machine.abort();
            motion::stop_here(state, params, est);
        }
        Request::Push(trajectory @ Trajectory::Follow { hand, target }) => {
            ready(state, est)?;
            require(!state.machine.is_running(), Refusal::Busy)?;
            require(state.homed, Refusal::NotHomed)?;
            require(target.is_finite(), Refusal::Value)?;
            match &mut state.active {
                Some(Active { trajectory: Trajectory::Follow { hand: leads, .. }, .. }) if *leads != hand => {
                    return Err(Refusal::OtherHand);
                }
                Some(active @ Active { trajectory: Trajectory::Follow { .. }, .. }) => {
                    active.lead_to(trajectory)
                }
                // A hand does not wait for what else is to be done.
                _ => {
                    require(state.idle && state.ring.is_empty(), Refusal::Busy)?;
                    require(state.ring.push(trajectory), Refusal::RingFull)?;
                }
            }
        }
        Request::Push(trajectory) => {
            ready(state, est)?;
            require(!state.machine.is_running(), Refusal::Busy)?;
            let blind = matches!(
                trajectory,
                Trajectory::Hold { .. } | Trajectory::JointTouch { .. } | Trajectory::JointVelocity { .. }
            );
            require(state.homed || blind, Refusal::NotHomed)?;
            require(is_allowed(params, &trajectory), Refusal::Value)?;
            require(state.ring.push(trajectory), Refusal::RingFull)?;
        }
        Request::Continue => {
            require(state.machine.waits(), Refusal::NothingWaits)?;
            state.machine.resume();
        }
        Request::Store(store) => state.store_requested = store,
        Request::BiasForce => state.filters.start_bias(params),
        Request::Stroke(stroke) => {
            require(!state.machine.is_running(), Refusal::Busy)?;
            require(is_stroke(params, &stroke), Refusal::Value)?;
            state.machine.stroke = stroke;
        }
        Request::PlanIndex(index) => {
            require(!state.machine.is_running(), Refusal::Busy)?;
            require(usize::from(index) < params.plan().strokes().len(), Refusal::Value)?;
            state.machine.index = index;
        }
        Request::Tune(tunable) => tune(state, tunable)?,
    }
    Ok(())
}

fn require(ok: bool, refusal: Refusal) -> Result<(), Refusal> {
    if ok { Ok(()) } else { Err(refusal) }
}

fn ready<'a>(state: &State, est: Option<&'a Estimate>) -> Result<&'a Estimate, Refusal> {
    est.filter(|_| state.mode == Mode::Ready).ok_or(Refusal::Mode)
}

fn tune(state: &mut State, tunable: Tunable) -> Result<(), Refusal> {
    match tunable {
        Tunable::SpeedScale(scale) => {
            require((0.01..=1.0).contains(&scale), Refusal::Value)?;
            state.tuning.speed_scale = scale;
        }
        Tunable::LeadRate(rate) => {
            require(rate > 0.0 && rate <= 0.1, Refusal::Value)?;
            state.tuning.lead_rate_m_s = rate;
        }
        Tunable::Accommodate(accommodate) => state.tuning.accommodate = accommodate,
        Tunable::Law(law) => state.tuning.law = law,
    }
    Ok(())
}

fn is_stroke(params: &Params, stroke: &StrokeSpec) -> bool {
    let surface = params.config().site.surface_z_m;
    let reach = |height: f64| -> Result<_, KinematicsError> { params.arm().inverse(&stroke.pose(height)) };
    stroke.radius_m > 0.0
        && stroke.depth_m > 0.0
        && stroke.depth_m <= 1.0
        && (0.0..=60_f64.to_radians()).contains(&stroke.delta_rad)
        && reach(surface - stroke.depth_m).is_ok()
        && reach(surface + params.config().site.transit_m).is_ok()
}

fn is_allowed(params: &Params, trajectory: &Trajectory) -> bool {
    match trajectory {
        Trajectory::Hold { .. } | Trajectory::JointTouch { .. } => true,
        Trajectory::JointMove { target } => params.arm().check_limits(target).is_ok(),
        Trajectory::CartesianMove { target } => params.arm().inverse(target).is_ok(),
        Trajectory::CartesianTouch { direction, travel_m } => {
            let length = libm::hypot(libm::hypot(direction[0], direction[1]), direction[2]);
            (length - 1.0).abs() < 1e-6 && *travel_m > 0.0 && *travel_m <= 1.0
        }
        Trajectory::Follow { target, .. } => target.is_finite(),
        Trajectory::Insert { depth_m } => *depth_m > 0.0 && *depth_m <= 1.0,
        Trajectory::Stroke { delta_rad, .. } => (0.0..=60_f64.to_radians()).contains(delta_rad),
        Trajectory::JointVelocity { rates, .. } => {
            let most = &params.arm().config().joints.all();
            rates.0.iter().zip(most).all(|(rate, joint)| rate.abs() <= joint.max_speed_deg_s.to_radians())
        }
    }
}
