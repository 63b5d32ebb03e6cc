use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::{Arc, OnceLock};
use std::thread::JoinHandle;

use soilctl_controller::{FaultRecord, Params, State, TICK_S};
use soilctl_session::{LogReport, Logger, Pace, SessionError, SessionSetup};

use crate::ending::Ending;
use crate::hand::{DeviceReport, Devices};
use crate::links::{Shared, device_links, links};
use crate::local::bind;
use crate::protocol::{Configuration, Hello, PROTOCOL_VERSION, SafeForce};
use crate::real_time::{SERVER_PRIORITY, fifo};
use crate::server::{Server, ServerReport};
use crate::servo::{Servo, ServoReport};
use crate::timing::Timing;
use crate::{LiveError, Rig};

/// What a session runs with.
pub struct Session {
    /// What drives: the simulated plant or a driver.
    pub rig: Rig,
    /// What the log begins with; the controller runs with its parameters.
    pub setup: SessionSetup,
    /// The controller's memory before the first step.
    pub state: State,
    /// Whether ticks keep to the wall clock; otherwise they come as fast as possible.
    pub real_time: bool,
    /// Ends after so many ticks. A simulated run without it stands still while nothing is to be done.
    pub most_ticks: Option<u64>,
    /// Where a device that leads the plate by hand may connect; only in real time.
    pub device: Option<PathBuf>,
}

/// How a session went.
#[derive(Debug)]
pub struct Report {
    /// Why it ended.
    pub ending: Ending,
    /// Ticks.
    pub ticks: u64,
    /// The fault in which it ended, if it did.
    pub fault: Option<FaultRecord>,
    /// How well it kept time, in real time.
    pub timing: Option<Timing>,
    /// What went wrong with hardware or driver.
    pub failed: Option<LiveError>,
    /// The log.
    pub log: Option<Result<LogReport, SessionError>>,
    /// Clients that connected.
    pub clients: u64,
    /// Messages that clients did not take in time.
    pub messages_dropped: u64,
    /// Lines of clients that were refused.
    pub lines_refused: u64,
    /// States that the server did not take in time.
    pub states_dropped: u64,
    /// Events that it did not take in time.
    pub events_dropped: u64,
    /// Devices that connected to lead the plate by hand.
    pub devices: u64,
    /// Devices that were sent away: another one was there, or they sent what is no frame.
    pub devices_refused: u64,
}

/// Ends a session from another thread or a signal handler.
#[derive(Debug, Clone)]
pub struct Stopper(Arc<Shared>);

impl Stopper {
    /// Brings the arm to the safe state and ends the session.
    pub fn stop(&self) {
        self.0.stop.store(true, Ordering::Release);
    }

    /// The last tick.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.0.tick.load(Ordering::Relaxed)
    }

    /// Whether the servo has ended.
    #[must_use]
    pub fn has_ended(&self) -> bool {
        self.0.ended.load(Ordering::Acquire)
    }
}

/// A session that runs.
pub struct Host {
    servo: JoinHandle<ServoReport>,
    server: JoinHandle<ServerReport>,
    devices: Option<JoinHandle<DeviceReport>>,
    logger: Option<Logger>,
    shared: Arc<Shared>,
}

impl Host {
    /// Starts servo, logger, server and what serves devices; operators connect to `socket`, and `log` takes the log.
    ///
    /// # Errors
    /// [`LiveError::Taken`] or [`LiveError::Socket`] for the socket, [`LiveError::Session`] if the log cannot be begun,
    /// [`LiveError::Thread`], [`LiveError::DeviceNeedsRealTime`].
    pub fn start<W: Write + Send + 'static>(
        session: Session,
        socket: &Path,
        log: Option<W>,
    ) -> Result<Self, LiveError> {
        let Session { rig, setup, state, real_time, most_ticks, device } = session;
        if device.is_some() && !real_time {
            return Err(LiveError::DeviceNeedsRealTime);
        }
        let params = setup.params()?;
        let listener = bind(socket)?;
        let device = device.map(|path| bind(&path).map(|listener| (listener, path))).transpose()?;
        let pace = if real_time { Pace::RealTime } else { Pace::Simulated };
        let (logger, recorder) = match log.map(|log| Logger::start(log, &setup, pace)).transpose()? {
            Some((logger, recorder)) => (Some(logger), Some(recorder)),
            None => (None, None),
        };
        let hello = hello(&params, real_time, rig.is_simulated());
        let SessionSetup { arm, controller, plan, model, .. } = setup;
        let configuration = Configuration { arm, controller, plan, model };
        let (servo_ends, server_ends) = links();
        let shared = Arc::clone(&server_ends.shared);
        let mut servo = Servo::new(rig, params, state, servo_ends, real_time);
        servo.most_ticks = most_ticks;
        servo.recorder = recorder;
        let device = device.map(|(listener, path)| {
            let (servo_ends, ends) = device_links();
            servo.device = Some(servo_ends);
            Devices { listener, path: socket_path(&path), ends, shared: Arc::clone(&shared) }
        });
        let ending = Arc::new(OnceLock::new());
        let (said, flag) = (Arc::clone(&ending), Arc::clone(&shared));
        let servo = spawn("servo", move || {
            let report = servo.run();
            let _ = said.set(report.ending);
            flag.ended.store(true, Ordering::Release);
            report
        })?;
        let server = Server::new(listener, socket_path(socket), hello, configuration, server_ends);
        let server = spawn("server", move || {
            if real_time {
                fifo(SERVER_PRIORITY);
            }
            server.run(|| ending.get().map_or("the servo failed", |ending| ending.words()).to_owned())
        });
        let server = match server {
            Ok(server) => server,
            Err(error) => {
                shared.stop.store(true, Ordering::Release);
                return Err(error);
            }
        };
        let devices = match device.map(|device| spawn("devices", move || device.run())).transpose() {
            Ok(devices) => devices,
            Err(error) => {
                shared.stop.store(true, Ordering::Release);
                return Err(error);
            }
        };
        Ok(Self { servo, server, devices, logger, shared })
    }

    /// Ends the session from elsewhere.
    #[must_use]
    pub fn stopper(&self) -> Stopper {
        Stopper(Arc::clone(&self.shared))
    }

    /// Waits for the end. The log is closed properly whatever ended the session.
    ///
    /// # Errors
    /// [`LiveError::Lost`] if a thread ended unexpectedly.
    pub fn wait(self) -> Result<Report, LiveError> {
        let servo = self.servo.join();
        // Also if it was lost: the server must end, and the log be closed.
        self.shared.ended.store(true, Ordering::Release);
        let notes = servo.as_ref().map_or_else(|_| BTreeMap::new(), |servo| notes(servo.timing.as_ref()));
        let log = self.logger.map(|logger| logger.finish_with(notes));
        let server = self.server.join().map_err(|_| LiveError::Lost("server"))?;
        let devices =
            self.devices.map(JoinHandle::join).transpose().map_err(|_| LiveError::Lost("devices"))?;
        let devices = devices.unwrap_or_default();
        let servo = servo.map_err(|_| LiveError::Lost("servo"))?;
        drop(servo.recorder);
        Ok(Report {
            ending: servo.ending,
            ticks: servo.ticks,
            fault: servo.fault,
            timing: servo.timing,
            failed: servo.failed,
            log,
            clients: server.clients,
            messages_dropped: server.messages_dropped,
            lines_refused: server.lines_refused,
            states_dropped: self.shared.states_dropped.load(Ordering::Relaxed),
            events_dropped: self.shared.events_dropped.load(Ordering::Relaxed),
            devices: devices.devices,
            devices_refused: devices.refused,
        })
    }
}

/// What the end record of a log in real time says about time. A simulated log says nothing about it.
fn notes(timing: Option<&Timing>) -> BTreeMap<String, String> {
    let Some(timing) = timing else { return BTreeMap::new() };
    let words = [
        ("overruns", timing.overruns.to_string()),
        ("skipped_ticks", timing.skipped.to_string()),
        ("lateness", timing.lateness.words()),
        ("busy", timing.busy.words()),
        ("fifo", timing.fifo.to_string()),
        ("memory_locked", timing.locked.to_string()),
    ];
    words.map(|(name, text)| (name.to_owned(), text)).into()
}

fn hello(params: &Params, real_time: bool, simulated: bool) -> Hello {
    let table = &params.config().stroke.safe_force;
    Hello {
        protocol: PROTOCOL_VERSION,
        program: format!("soilctl {}", env!("CARGO_PKG_VERSION")),
        real_time,
        simulated,
        tick_s: TICK_S,
        strokes: params.plan().strokes().len(),
        safe_force: SafeForce { angle_deg: table.angle_deg.clone(), force_n: table.force_n.clone() },
    }
}

/// The path from the root on, so that it can be removed whatever the folder is by then.
fn socket_path(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

fn spawn<T: Send + 'static>(
    thread: &'static str,
    body: impl FnOnce() -> T + Send + 'static,
) -> Result<JoinHandle<T>, LiveError> {
    std::thread::Builder::new()
        .name(thread.to_owned())
        .spawn(body)
        .map_err(|reason| LiveError::Thread { thread, reason })
}
