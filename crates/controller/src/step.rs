use soilctl_kinematics::{Joint, JointTorques, MotorTorques};

use crate::estimate::Estimate;
use crate::events::EventKind;
use crate::laws::{joint_pid, stiffness, velocity_pi};
use crate::trajectory::{Law, Setpoint};
use crate::{
    Commands, Events, Fault, Mode, Outputs, Params, Sensed, State, TICK_S, Telemetry, monitor, motion,
    requests, sequence,
};

/// One tick of the controller: from what is sensed and commanded to torques.
///
/// Pure: the outputs and the new state are functions of the arguments alone. It allocates nothing, reads no clock, takes no
/// lock, does not panic on any input, and does a bounded amount of work. Whatever is wrong is an event; a broken limit
/// leads to the safe state ([`Mode::Fault`]) in the same tick.
pub fn step(params: &Params, state: &mut State, sensed: &Sensed, commands: &Commands) -> Outputs {
    let mut events = Events::default();
    let ticks = if state.started { sensed.tick.saturating_sub(state.tick) } else { 1 };
    if ticks > 0 {
        state.tick = sensed.tick;
    }
    if state.pending_home {
        set_home(params, state, sensed, &mut events);
    }
    let usable = monitor::check_sensed(params, state, sensed, commands, ticks, &mut events);
    state.started = true;
    if usable {
        // More than a few ticks are a fault anyway.
        let ticks = u32::try_from(ticks.clamp(1, 1000)).map_or(1.0, f64::from);
        if state.filters.update(params, sensed, ticks) {
            let [x, y, z] = state.filters.bias.first_chunk::<3>().copied().unwrap_or_default();
            events.push(EventKind::BiasTaken, 0, libm::hypot(libm::hypot(x, y), z), 0.0);
        }
    }
    let mut estimate = Estimate::new(params, &state.filters, state.homed).ok();
    match &estimate {
        Some(est) if state.mode == Mode::Ready => monitor::check_estimate(params, state, est, &mut events),
        Some(_) => {}
        None => state.raise(&mut events, Fault::Kinematics, 0, 0.0, 0.0),
    }
    requests::answer(state, params, estimate.as_ref(), commands, &mut events);

    let mut torques = JointTorques::default();
    if let (Some(est), Mode::Ready) = (&mut estimate, state.mode) {
        let before = state.setpoint;
        sequence::advance(state, params, est, &mut events);
        let setpoint = motion::advance(state, params, est, &mut events);
        if setpoint.law == Law::Stiffness && est.locate_motor_tip(params).is_err() {
            state.raise(&mut events, Fault::Kinematics, 0, 0.0, 0.0);
        }
        check_setpoint(params, state, est, &before, &setpoint, &mut events);
        if state.mode == Mode::Ready {
            torques = servo(params, state, est, &setpoint, &mut events);
        }
    }
    store(state, &mut events);
    outputs(params, state, estimate.as_ref(), torques, events)
}

/// The posture of this tick becomes that of the stops, and is held.
///
/// The elbow's encoders sit before its cables, which the motor that presses against the stop has stretched: they stand
/// beyond the stop by the torque over the cables' stiffness, up to 3 deg.
fn set_home(params: &Params, state: &mut State, sensed: &Sensed, events: &mut Events) {
    let map = params.arm().transmission();
    let mut home = map.home();
    home.0[Joint::Elbow.index()] += state.driven_stretch_rad(params);
    state.pending_home = false;
    state.homed = true;
    state.filters.reference(params, sensed, &map.motor_angles(&home).unwrap_or_default());
    state.setpoint = Setpoint::still(home);
    state.integral_nm = [0.0; 5];
    if let Some(active) = &mut state.active {
        active.hold_at(home);
    }
    events.say(EventKind::Homed);
}

fn check_setpoint(
    params: &Params,
    state: &mut State,
    est: &Estimate,
    before: &Setpoint,
    wanted: &Setpoint,
    events: &mut Events,
) {
    if wanted.law == Law::Stiffness {
        let [x, y, z]: [f64; 3] = std::array::from_fn(|i| wanted.position_m[i] - est.motor_position_m[i]);
        let (error, most) = (libm::hypot(libm::hypot(x, y), z), params.config().safety.stiffness_error_m);
        if error > most {
            state.raise(events, Fault::StiffnessError, 0, error, most);
        }
    }
    if wanted.law != Law::Joint {
        return;
    }
    for i in 0..5 {
        let error = wanted.joints.0[i] - est.motor.0[i];
        if error.abs() > params.tracking_error_rad[i] {
            state.raise(events, Fault::TrackingError, i, error, params.tracking_error_rad[i]);
        }
        let change = wanted.joints.0[i] - before.joints.0[i];
        if before.law == Law::Joint && change.abs() > params.setpoint_step_rad {
            state.raise(events, Fault::SetpointRate, i, change, params.setpoint_step_rad);
        }
    }
}

/// Law, weight, limits; motor torques are left in the state.
fn servo(
    params: &Params,
    state: &mut State,
    est: &Estimate,
    wanted: &Setpoint,
    events: &mut Events,
) -> JointTorques {
    let law = match wanted.law {
        Law::Joint => Ok(joint_pid(params, wanted, est, &state.saturated, &mut state.integral_nm)),
        Law::Velocity => Ok(velocity_pi(params, wanted, est, &state.saturated, &mut state.integral_nm)),
        Law::Stiffness => stiffness(params, wanted, est),
    };
    let Ok(mut torques) = law else {
        state.raise(events, Fault::Kinematics, 0, 0.0, 0.0);
        return JointTorques::default();
    };
    let settings = params.config();
    for (i, torque) in torques.iter_mut().enumerate() {
        // A wrist that is off hangs on its worm gear and needs no help against its weight.
        let off = wanted.law == Law::Stiffness && i == Joint::Wrist.index();
        *torque += if off { 0.0 } else { est.gravity.0[i] };
        // Limits turn a NaN into full torque, so it has to be found before.
        if !torque.is_finite() {
            state.raise(events, Fault::OutputNotFinite, i, 0.0, 0.0);
            return JointTorques::default();
        }
        let most = params.max_joint_torque_nm[i];
        state.saturated[i] = i8::from(*torque > most) - i8::from(*torque < -most);
        *torque = torque.max(-most).min(most);
        let counter = &mut state.monitors.saturated[i];
        *counter = if state.saturated[i] == 0 { 0 } else { counter.saturating_add(1) };
        let (ticks, longest) = (*counter, settings.safety.saturated_ticks);
        if ticks >= longest {
            state.raise(events, Fault::TorqueSaturated, i, f64::from(ticks), f64::from(longest));
            return JointTorques::default();
        }
    }
    let joint_torques = JointTorques(torques);
    let Ok(MotorTorques(motors)) = params.arm().transmission().motor_torques(&joint_torques) else {
        state.raise(events, Fault::OutputNotFinite, 0, 0.0, 0.0);
        return JointTorques::default();
    };
    for (i, torque) in motors.into_iter().enumerate() {
        let most = settings.motors.max_torque_nm[i];
        let change = settings.motors.max_torque_rate_nm_s[i] * TICK_S;
        let last = state.motor_torques_nm[i];
        state.motor_torques_nm[i] = torque.max(-most).min(most).max(last - change).min(last + change);
    }
    joint_torques
}

/// Storage by request, by the step of a sequence, or by the trajectory.
fn store(state: &mut State, events: &mut Events) {
    use crate::TrajectoryKind::{Insert, Stroke};
    let by_trajectory =
        state.active.is_some_and(|active| matches!(active.trajectory.kind(), Insert | Stroke));
    let by_step = state.machine.step().is_some_and(|step| step.store);
    let store = state.store_requested || by_step || by_trajectory;
    if store && !state.storing {
        state.storage_segment = state.storage_segment.wrapping_add(1);
        let index = usize::try_from(state.storage_segment % 0x1_0000).unwrap_or(0);
        events.push(EventKind::StorageOn, index, 0.0, 0.0);
    } else if !store && state.storing {
        events.say(EventKind::StorageOff);
    }
    state.storing = store;
}

fn outputs(
    params: &Params,
    state: &State,
    est: Option<&Estimate>,
    joint_torques: JointTorques,
    events: Events,
) -> Outputs {
    let driven = state.mode == Mode::Ready;
    let motor_torques = MotorTorques(if driven { state.motor_torques_nm } else { [0.0; 5] });
    let per_nm = params.config().motors.current_a_per_nm;
    let mut telemetry = Telemetry {
        trajectory: state.active.map(|active| active.trajectory.kind()),
        sequence: state.machine.top().map(|frame| (frame.sequence, frame.step)),
        joint_torques: if driven { joint_torques } else { JointTorques::default() },
        desired_joints: state.setpoint.joints,
        desired_position_m: state.setpoint.position_m,
        ..Telemetry::default()
    };
    if let Some(est) = est {
        telemetry.motor_joints = est.motor;
        telemetry.external_joints = est.external;
        telemetry.joint_rates = est.rates;
        telemetry.pose = est.pose;
        telemetry.force_rtz_n = est.force_rtz_n;
    }
    match state.active {
        Some(active) if telemetry.trajectory == Some(crate::TrajectoryKind::Stroke) => {
            telemetry.force_inclination_rad = active.stroke.force_rad;
            telemetry.desired_inclination_rad = active.stroke.wanted_rad;
            telemetry.lead_inclination_rad = active.stroke.lead_rad;
            telemetry.lead_m = active.stroke.lead_m;
        }
        Some(active) if telemetry.trajectory == Some(crate::TrajectoryKind::Insert) => {
            telemetry.accommodation_m = active.offset_m;
        }
        _ => {}
    }
    Outputs {
        tick: state.tick,
        mode: state.mode,
        amplifiers_enabled: driven,
        motor_torques,
        motor_currents_a: std::array::from_fn(|i| motor_torques.0[i] * per_nm[i]),
        store: state.storing,
        storage_segment: state.storage_segment,
        events,
        telemetry,
    }
}
