use std::sync::atomic::Ordering;
use std::time::Duration;

use soilctl_controller::{Commands, EventKind, Mode, Outputs, Params, Refusal, Request, Sensed, State, step};
use soilctl_plant::{Drive, Hardware};
use soilctl_session::Recorder;

use crate::clock::Clock;
use crate::ending::Ending;
use crate::links::{ServoEnds, Snapshot, What};
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
            if let Err(error) = self.tick(asked.map(|(_, request)| request), clock.as_mut()) {
                // There is nothing left that could be brought anywhere.
                return self.report(Ending::HardwareFailed, Some(error), clock.as_ref());
            }
            if let Some((token, _)) = asked {
                let refused = self.refusal();
                self.ends.answer(token, self.outputs.tick, refused);
            }
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
        let state = &self.state;
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
            fault: state.fault,
            stroke_radius_m: stroke.map(|active| active.stroke.start_radius_m),
            safe_force_n: stroke.and_then(|active| {
                self.params.safe_force().largest_n(active.stroke.force_rad - active.stroke.plate_rad)
            }),
        });
    }
}
