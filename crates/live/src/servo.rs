use std::sync::atomic::Ordering;
use std::time::Duration;

use soilctl_controller::{
    Commands, EventKind, HandLimit, Mode, Outputs, Params, Refusal, Request, Sensed, State, Trajectory, step,
};
use soilctl_plant::{Drive, Hardware};
use soilctl_session::Recorder;

use crate::clock::Clock;
use crate::ending::Ending;
use crate::hand::{DEVICE_HAND, HandFlags, TouchFrame};
use crate::links::{HandEnds, Led, ServoEnds, Snapshot, What};
use crate::timing::Timing;
use crate::{LiveError, Rig};

/// Ticks between two states: some 31 a second.
const STATE_TICKS: u64 = 16;
/// Ticks after which a session whose driver is gone ends, if the controller has not found out by then.
const GONE_TICKS: u32 = 500;
/// How long the servo of a simulated run sleeps while nothing is to be done.
const NAP: Duration = Duration::from_micros(500);

/// The control loop.
pub(crate) struct Servo {
    pub(crate) rig: Rig,
    pub(crate) params: Params,
    pub(crate) state: State,
    pub(crate) recorder: Option<Recorder>,
    pub(crate) ends: ServoEnds,
    /// A device that leads the plate by hand.
    pub(crate) device: Option<HandEnds>,
    pub(crate) real_time: bool,
    /// Ends after so many ticks. A simulated run without it stands still while nothing is to be done.
    pub(crate) most_ticks: Option<u64>,
    drive: Drive,
    sensed: Sensed,
    outputs: Outputs,
    commands: Commands,
    ticks: u64,
    /// Ticks for which simulated time goes on though nothing is to be done.
    advance: u32,
    /// Who asked for it, and hears when it is over.
    advance_for: Option<u64>,
    gone_ticks: u32,
    /// The log of a simulated run failed.
    log_failed: bool,
    /// It was told that time stands still.
    paused_shown: bool,
    /// What the device is told beside what every tick tells: number of its last frame, and whether that was refused.
    device_heard: (u32, bool),
    /// Ticks by which real time is ahead.
    behind_ticks: u64,
}

/// What the loop leaves behind.
pub(crate) struct ServoReport {
    pub(crate) ending: Ending,
    pub(crate) ticks: u64,
    pub(crate) fault: Option<soilctl_controller::FaultRecord>,
    pub(crate) timing: Option<Timing>,
    pub(crate) failed: Option<LiveError>,
    /// Lives until the log has heard what its end record shall say.
    pub(crate) recorder: Option<Recorder>,
}

impl Servo {
    pub(crate) fn new(rig: Rig, params: Params, state: State, ends: ServoEnds, real_time: bool) -> Self {
        Self {
            rig,
            params,
            state,
            recorder: None,
            ends,
            device: None,
            real_time,
            most_ticks: None,
            drive: Drive::default(),
            sensed: Sensed::default(),
            outputs: Outputs::default(),
            commands: Commands::default(),
            ticks: 0,
            advance: 0,
            advance_for: None,
            gone_ticks: 0,
            log_failed: false,
            paused_shown: false,
            device_heard: (0, false),
            behind_ticks: 0,
        }
    }

    /// Runs until it shall end, and then brings the arm to the safe state.
    pub(crate) fn run(mut self) -> ServoReport {
        let mut clock = self.real_time.then(Clock::start);
        let ending = loop {
            if let Some(ending) = self.shall_end() {
                break ending;
            }
            if self.stands_still() {
                std::thread::sleep(NAP);
                continue;
            }
            let asked = self.take_ask();
            // Operators go first; the hand says again where it is.
            let led = if asked.is_none() { self.take_hand() } else { None };
            if let Err(error) = self.tick(asked.map(|(_, request)| request).or(led), clock.as_mut()) {
                // There is nothing left that could be brought anywhere.
                return self.report(Ending::HardwareFailed, Some(error), clock.as_ref());
            }
            if let Some((token, _)) = asked {
                let refused = self.refusal();
                self.ends.answer(token, self.outputs.tick, refused);
            }
            if led.is_some() {
                self.device_heard.1 = self.refusal().is_some();
            }
            self.show_touch();
        };
        // Off, and once more so that the hardware hears of it and the log holds it.
        let off = (self.state.mode == Mode::Ready).then_some(Request::Disable);
        let failed = self.tick(off, clock.as_mut()).and_then(|()| self.tick(None, clock.as_mut())).err();
        self.publish(false);
        let failed = failed.or_else(|| self.rig.gone());
        self.report(ending, failed, clock.as_ref())
    }

    fn report(self, ending: Ending, failed: Option<LiveError>, clock: Option<&Clock>) -> ServoReport {
        ServoReport {
            ending,
            ticks: self.ticks,
            fault: self.state.fault,
            timing: clock.map(|clock| *clock.timing()),
            failed,
            recorder: self.recorder,
        }
    }

    fn shall_end(&self) -> Option<Ending> {
        if self.ends.shared.stop.load(Ordering::Acquire) {
            Some(Ending::Asked)
        } else if self.most_ticks.is_some_and(|most| self.ticks >= most) {
            Some(Ending::TimeIsUp)
        } else if self.log_failed {
            Some(Ending::LogFailed)
        } else if self.gone_ticks >= GONE_TICKS || (self.gone_ticks > 2 && self.state.mode != Mode::Ready) {
            Some(Ending::DriverGone)
        } else {
            None
        }
    }

    /// In a simulated run without an end, time stands still while nothing is to be done, so that the ticks at which
    /// commands come do not depend on how fast the operator is.
    fn stands_still(&mut self) -> bool {
        let state = &self.state;
        let resting = state.idle && state.ring.is_empty() && !state.machine.is_running();
        let waits = state.machine.waits() && state.idle && state.ring.is_empty();
        let busy = state.mode == Mode::Ready && !resting && !waits;
        let stopped = self.ends.shared.emergency_stop.load(Ordering::Acquire);
        let still = !self.real_time
            && self.most_ticks.is_none()
            && self.rig.is_simulated()
            && self.ticks > 0
            && self.advance == 0
            && !busy
            && state.filters.bias_left == 0
            && stopped == self.commands.emergency_stop
            && self.ends.asks.is_empty();
        if still && !self.paused_shown {
            self.publish(true);
        }
        self.paused_shown = still;
        still
    }

    /// The next request, with its token.
    fn take_ask(&mut self) -> Option<(u64, Request)> {
        let ask = self.ends.asks.pop().ok()?;
        match ask.what {
            What::Request(request) => {
                if request == Request::Continue && self.state.machine.waits() {
                    self.rig.prepare_soil();
                }
                Some((ask.token, request))
            }
            What::Advance(ticks) => {
                self.advance = self.advance.max(ticks);
                if let Some(earlier) = self.advance_for.replace(ask.token) {
                    self.ends.answer(earlier, self.outputs.tick, None);
                }
                None
            }
        }
    }

    /// Where the device's hand is, if it holds the plate.
    fn take_hand(&mut self) -> Option<Request> {
        let device = self.device.as_mut()?;
        let mut last = None;
        while let Ok(frame) = device.hands.pop() {
            last = Some(frame);
        }
        let frame = last?;
        self.device_heard = (frame.number, false);
        frame.target.map(|target| Request::Push(Trajectory::Follow { hand: DEVICE_HAND, target }))
    }

    /// Tells the device of this tick; what it does not take is left out.
    fn show_touch(&mut self) {
        let led = self.led();
        let Some(device) = self.device.as_mut() else { return };
        let (telemetry, limit) = (&self.outputs.telemetry, led.map(|led| led.limit));
        let [x_m, y_m, z_m] = telemetry.pose.position_m();
        let [r, t, z] = telemetry.force_rtz_n;
        let radius_m = libm::hypot(x_m, y_m);
        let [cos, sin] = if radius_m > 0.0 { [x_m / radius_m, y_m / radius_m] } else { [1.0, 0.0] };
        let flags = HandFlags {
            ready: self.state.mode == Mode::Ready && self.state.homed,
            leads: led.is_some_and(|led| led.hand == DEVICE_HAND),
            reach: limit == Some(HandLimit::Reach),
            force: limit == Some(HandLimit::Force),
            torque: limit == Some(HandLimit::Torque),
            refused: self.device_heard.1,
        };
        let touch = TouchFrame {
            tick: self.outputs.tick,
            flags,
            number: self.device_heard.0,
            place_m: [x_m, y_m, z_m],
            tool_angle_rad: telemetry.pose.tool_angle_rad(),
            force_n: [r * cos - t * sin, r * sin + t * cos, z],
        };
        let _ = device.touches.push(touch);
    }

    /// The hand that leads the plate.
    fn led(&self) -> Option<Led> {
        let active = self.state.active?;
        match active.trajectory {
            Trajectory::Follow { hand, target } => {
                Some(Led { hand, target, limit: active.hand.limit, load: active.hand.load })
            }
            Trajectory::Hold { .. }
            | Trajectory::JointMove { .. }
            | Trajectory::CartesianMove { .. }
            | Trajectory::JointTouch { .. }
            | Trajectory::CartesianTouch { .. }
            | Trajectory::Insert { .. }
            | Trajectory::Stroke { .. }
            | Trajectory::JointVelocity { .. } => None,
        }
    }

    fn tick(&mut self, request: Option<Request>, clock: Option<&mut Clock>) -> Result<(), LiveError> {
        let shared = &self.ends.shared;
        // Simulated time does not know how long the server takes, so there the loop is its own operator.
        let heartbeat = if self.real_time {
            shared.heartbeat.load(Ordering::Relaxed)
        } else {
            self.commands.heartbeat.wrapping_add(1)
        };
        let emergency_stop = shared.emergency_stop.load(Ordering::Acquire);
        self.commands = Commands { heartbeat, emergency_stop, request };
        if let Some(recorder) = &mut self.recorder {
            self.log_failed |= !recorder.before(&self.state);
        }
        if let Some(clock) = clock {
            clock.wait();
            self.behind_ticks = clock.timing().skipped;
        }
        self.sensed = self.rig.exchange(&self.drive)?;
        self.outputs = step(&self.params, &mut self.state, &self.sensed, &self.commands);
        self.drive = Drive::from(&self.outputs);
        if let Some(recorder) = &mut self.recorder {
            let truth = self.rig.truth();
            let goes_on = recorder.after(&self.sensed, &self.commands, &self.outputs, &self.state, truth);
            self.log_failed |= !goes_on;
            shared.log_dropped.store(recorder.dropped_steps(), Ordering::Relaxed);
        }
        self.ticks += 1;
        self.advance = self.advance.saturating_sub(1);
        if self.advance == 0
            && let Some(token) = self.advance_for.take()
        {
            self.ends.answer(token, self.outputs.tick, None);
        }
        self.gone_ticks = if self.rig.is_gone() { self.gone_ticks + 1 } else { 0 };
        self.ends.shared.tick.store(self.outputs.tick, Ordering::Relaxed);
        for event in self.outputs.events.as_slice() {
            self.ends.event(self.outputs.tick, *event);
        }
        if self.ticks.is_multiple_of(STATE_TICKS) {
            self.publish(false);
        }
        Ok(())
    }

    fn refusal(&self) -> Option<Refusal> {
        self.outputs.events.as_slice().iter().find_map(|event| match event.kind {
            EventKind::Refused(refusal) => Some(refusal),
            _ => None,
        })
    }

    fn publish(&mut self, paused: bool) {
        let (state, led) = (&self.state, self.led());
        let stroke = state.active.filter(|_| {
            self.outputs.telemetry.trajectory == Some(soilctl_controller::TrajectoryKind::Stroke)
        });
        self.ends.state(Snapshot {
            sensed: self.sensed,
            commands: self.commands,
            outputs: self.outputs,
            homed: state.homed,
            waiting: state.machine.waits(),
            paused,
            led,
            behind_ticks: self.behind_ticks,
            fault: state.fault,
            stroke_radius_m: stroke.map(|active| active.stroke.start_radius_m),
            safe_force_n: stroke.and_then(|active| {
                self.params.safe_force().largest_n(active.stroke.force_rad - active.stroke.plate_rad)
            }),
        });
    }
}
