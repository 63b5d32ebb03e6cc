//! Limits on what is sensed, and how long each was broken.

use serde::{Deserialize, Serialize};
use soilctl_kinematics::Joint;

use crate::estimate::Estimate;
use crate::{Commands, Events, Fault, Mode, Params, Sensed, State};

/// Counters, in ticks.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Monitors {
    /// Last sequence numbers: motor encoders, external encoders, force, amplifiers.
    pub sequences: [u32; 4],
    /// Ticks since each changed.
    pub silent: [u32; 4],
    /// The last finite wrench.
    pub wrench: [f64; 6],
    /// Ticks for which fresh wrenches had the same bits.
    pub same_wrench: u32,
    /// The last heartbeat.
    pub heartbeat: u32,
    /// Ticks since it changed.
    pub heartbeat_silent: u32,
    /// Ticks with a joint torque at its limit.
    pub saturated: [u32; 5],
    /// Ticks with too large a current.
    pub over_current: [u32; 5],
    /// Ticks with a current that was not commanded.
    pub current_mismatch: [u32; 5],
    /// Ticks with a bad voltage.
    pub voltage: [u32; 5],
}

impl Monitors {
    /// Forgets what only counts while the arm is driven.
    pub(crate) fn quieten(&mut self) {
        self.heartbeat_silent = 0;
        self.saturated = [0; 5];
        self.over_current = [0; 5];
        self.current_mismatch = [0; 5];
        self.voltage = [0; 5];
    }
}

/// One more tick if `broken`, else none; says whether that is too many.
fn lasts(counter: &mut u32, broken: bool, most: u32) -> bool {
    *counter = if broken { counter.saturating_add(1) } else { 0 };
    *counter >= most
}

/// Checks readings before they are used. Says whether they may be used.
pub(crate) fn check_sensed(
    params: &Params,
    state: &mut State,
    sensed: &Sensed,
    commands: &Commands,
    ticks: u64,
    events: &mut Events,
) -> bool {
    let safety = &params.config().safety;
    if commands.emergency_stop {
        state.raise(events, Fault::EmergencyStop, 0, 1.0, 0.0);
    }
    #[allow(clippy::cast_precision_loss, reason = "for a message")]
    if ticks == 0 || ticks - 1 > u64::from(safety.dropped_ticks) {
        let missed = ticks as f64 - 1.0;
        state.raise(events, Fault::DroppedTicks, 0, missed, f64::from(safety.dropped_ticks));
    }
    check_silence(params, state, sensed, commands, events);

    let mut usable = true;
    let sensor = &params.config().force_sensor;
    for (i, &value) in sensed.wrench.iter().enumerate() {
        let range = match i {
            0 | 1 => sensor.shear_range_n,
            2 => sensor.normal_range_n,
            _ => sensor.moment_range_nm,
        };
        if !value.is_finite() {
            state.raise(events, Fault::ForceNotFinite, i, value, 0.0);
            usable = false;
        } else if value.abs() > range {
            state.raise(events, Fault::ForceRange, i, value, range);
            usable = false;
        }
    }
    if sensed.wrench_overload {
        state.raise(events, Fault::ForceOverload, 0, 1.0, 0.0);
    }
    if usable {
        check_frozen(params, state, sensed, events);
    }
    if state.filters.primed {
        #[allow(clippy::cast_precision_loss, reason = "a few ticks")]
        let time_s = ticks.max(1) as f64 * crate::TICK_S;
        for i in 0..5 {
            let jump = (f64::from(sensed.motor_counts[i]) - f64::from(state.filters.last_counts[i]))
                * params.motor_rad_per_count[i];
            // A motor of the differential moves with two joints and the shoulder's coupling.
            let most = 4.0 * params.max_joint_speed_rad_s[i] * time_s;
            if jump.abs() > most {
                state.raise(events, Fault::EncoderJump, i, jump, most);
                usable = false;
            }
        }
    }
    check_amplifiers(params, state, sensed, events);
    usable
}

fn check_silence(
    params: &Params,
    state: &mut State,
    sensed: &Sensed,
    commands: &Commands,
    events: &mut Events,
) {
    let safety = &params.config().safety;
    let sensors = [
        (sensed.motor_sequence, safety.motor_encoder_stale_ticks, Fault::MotorEncoderStale),
        (sensed.external_sequence, safety.external_encoder_stale_ticks, Fault::ExternalEncoderStale),
        (sensed.wrench_sequence, safety.force_stale_ticks, Fault::ForceStale),
        (sensed.amplifier_sequence, safety.amplifier_stale_ticks, Fault::AmplifierStale),
    ];
    for (i, (sequence, most, fault)) in sensors.into_iter().enumerate() {
        let silent = state.started && sequence == state.monitors.sequences[i];
        state.monitors.sequences[i] = sequence;
        if lasts(&mut state.monitors.silent[i], silent, most) {
            let ticks = f64::from(state.monitors.silent[i]);
            state.raise(events, fault, 0, ticks, f64::from(most));
        }
    }
    let silent = state.mode == Mode::Ready && commands.heartbeat == state.monitors.heartbeat;
    state.monitors.heartbeat = commands.heartbeat;
    if lasts(&mut state.monitors.heartbeat_silent, silent, safety.heartbeat_ticks) {
        let (ticks, most) = (f64::from(state.monitors.heartbeat_silent), f64::from(safety.heartbeat_ticks));
        state.raise(events, Fault::Watchdog, 0, ticks, most);
    }
}

fn check_frozen(params: &Params, state: &mut State, sensed: &Sensed, events: &mut Events) {
    let most = params.config().safety.force_frozen_ticks;
    let fresh = state.monitors.silent[2] == 0;
    let same = sensed.wrench.map(f64::to_bits) == state.monitors.wrench.map(f64::to_bits);
    state.monitors.wrench = sensed.wrench;
    if most > 0 && fresh && lasts(&mut state.monitors.same_wrench, same, most) {
        state.raise(events, Fault::ForceFrozen, 0, f64::from(state.monitors.same_wrench), f64::from(most));
    }
}

fn check_amplifiers(params: &Params, state: &mut State, sensed: &Sensed, events: &mut Events) {
    let (config, safety) = (params.config(), &params.config().safety);
    let [low, high] = safety.supply_voltage_v;
    for i in 0..5 {
        let (current, voltage) = (sensed.amplifier_current_a[i], sensed.amplifier_voltage_v[i]);
        if !current.is_finite() || !voltage.is_finite() {
            state.raise(events, Fault::AmplifierNotFinite, i, 0.0, 0.0);
            continue;
        }
        if state.mode != Mode::Ready {
            continue;
        }
        let most = safety.max_current_a[i];
        if lasts(&mut state.monitors.over_current[i], current.abs() > most, safety.amplifier_ticks) {
            state.raise(events, Fault::OverCurrent, i, current, most);
        }
        let wrong = current - state.motor_torques_nm[i] * config.motors.current_a_per_nm[i];
        let mismatch = wrong.abs() > safety.current_error_a;
        if lasts(&mut state.monitors.current_mismatch[i], mismatch, safety.amplifier_ticks) {
            state.raise(events, Fault::CurrentMismatch, i, wrong, safety.current_error_a);
        }
        let bad = voltage < low || voltage > high;
        if lasts(&mut state.monitors.voltage[i], bad, safety.amplifier_ticks) {
            let limit = if voltage < low { low } else { high };
            state.raise(events, Fault::SupplyVoltage, i, voltage, limit);
        }
    }
}

/// Checks what the readings mean, while the arm is driven.
pub(crate) fn check_estimate(params: &Params, state: &mut State, est: &Estimate, events: &mut Events) {
    for i in 0..5 {
        let difference = est.motor.0[i] - est.external.0[i];
        let most = params.disagreement_rad[i];
        if difference.abs() > most {
            state.raise(events, Fault::EncoderDisagreement, i, difference, most);
        }
        let (rate, most) = (est.rates.0[i], params.max_joint_speed_rad_s[i]);
        if rate.abs() > most {
            state.raise(events, Fault::JointSpeed, i, rate, most);
        }
    }
    let [x, y, z] = state.filters.wrench.first_chunk::<3>().copied().unwrap_or_default();
    let (force, most) = (libm::hypot(libm::hypot(x, y), z), params.config().safety.tip_force_n);
    if force > most {
        state.raise(events, Fault::TipForce, 0, force, most);
    }
    if est.homed {
        check_place(params, state, est, events);
    }
}

fn check_place(params: &Params, state: &mut State, est: &Estimate, events: &mut Events) {
    let safety = &params.config().safety;
    let (lower, upper) = (params.arm().lower_limits().0, params.arm().upper_limits().0);
    let margin = params.joint_margin_rad;
    let mut angles = est.motor.0;
    // The elbow may press against its stop with its motor well beyond.
    angles[Joint::Elbow.index()] -= state.driven_stretch_rad(params);
    for (i, angle) in angles.into_iter().enumerate() {
        if angle < lower[i] - margin {
            state.raise(events, Fault::JointLimit, i, angle, lower[i] - margin);
        } else if angle > upper[i] + margin {
            state.raise(events, Fault::JointLimit, i, angle, upper[i] + margin);
        }
    }
    // While a sequence homes the arm again it leaves the places where it works.
    if state.machine.is_homing() {
        return;
    }
    let radius = libm::hypot(est.pose.x_m, est.pose.y_m);
    let base = libm::atan2(est.pose.y_m, est.pose.x_m);
    let base_limits = safety.base_deg.map(f64::to_radians);
    for (fault, value, [low, high]) in [
        (Fault::WorkspaceRadius, radius, safety.radius_m),
        (Fault::WorkspaceHeight, est.pose.z_m, safety.height_m),
        (Fault::WorkspaceBase, base, base_limits),
    ] {
        if value < low {
            state.raise(events, fault, 0, value, low);
        } else if value > high {
            state.raise(events, fault, 0, value, high);
        }
    }
}
