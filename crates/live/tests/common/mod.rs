//! Sessions of the simulated arm without soil, and sinks for their logs.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use soilctl_controller::{Params, State};
use soilctl_kinematics::JointAngles;
use soilctl_live::protocol::{Command, Event, Problem, ServerMessage, StateMessage};
use soilctl_live::{Client, Commander, Host, Report, Rig, Session};
use soilctl_plant::{Plant, PlantParams};
use soilctl_session::SessionSetup;
use soilctl_session::messages::ControllerStep;
use soilctl_session::read::{Item, scan};

pub const START_DEG: [f64; 5] = [0.0, 40.0, 90.0, 0.0, 30.0];
/// Longer than anything takes on a busy machine.
pub const LONG: Duration = Duration::from_secs(60);

pub fn plant(seed: u64) -> Plant {
    Plant::new(PlantParams::thesis(), None, &JointAngles::from_degrees(START_DEG), seed).unwrap()
}

pub fn setup() -> SessionSetup {
    let thesis = Params::thesis();
    SessionSetup::new(thesis.arm().config(), thesis.config(), "", 1, "none").unwrap()
}

/// The memory of a controller whose encoders are referenced.
pub fn homed(setup: &SessionSetup) -> State {
    let mut state = State::new(&setup.params().unwrap());
    let encoders = PlantParams::thesis().config().encoders;
    (state.homed, state.filters.offset_known) = (true, true);
    state.filters.motor_zero = encoders.motor_offset_counts;
    state.filters.external_zero = encoders.external_offset_counts;
    state
}

pub fn session(rig: Rig) -> Session {
    let setup = setup();
    Session { rig, state: homed(&setup), setup, real_time: false, most_ticks: None, device: None }
}

pub fn simulated() -> Session {
    session(Rig::Plant(Box::new(plant(3))))
}

/// A running session with its folder.
pub struct Running {
    pub host: Option<Host>,
    pub log: Shelf,
    pub dir: tempfile::TempDir,
}

impl Running {
    pub fn new(session: Session) -> Self {
        Self::with_log(session, Shelf::default())
    }

    pub fn with_log(session: Session, log: Shelf) -> Self {
        let dir = tempfile::tempdir().unwrap();
        let host = Host::start(session, &dir.path().join("live"), Some(log.clone())).unwrap();
        Self { host: Some(host), log, dir }
    }

    pub fn socket(&self) -> PathBuf {
        self.dir.path().join("live")
    }

    pub fn operator(&self) -> Operator {
        Operator::new(&self.socket())
    }

    /// Ends the session.
    pub fn end(&mut self) -> Report {
        let host = self.host.take().unwrap();
        host.stopper().stop();
        host.wait().unwrap()
    }

    /// The log as a file.
    pub fn log_file(&self) -> PathBuf {
        let path = self.dir.path().join("run.mcap");
        std::fs::write(&path, &self.log.0.lock().unwrap().bytes).unwrap();
        path
    }

    /// Every step in the log.
    pub fn steps(&self) -> Vec<ControllerStep> {
        let mut steps = Vec::new();
        let ending = scan::<soilctl_session::SessionError>(&self.log_file(), &mut |item| {
            if let Item::Message(message) = item
                && message.channel.topic == "/controller/step"
            {
                steps.push(soilctl_session::messages::decode::<ControllerStep>(message.data).unwrap());
            }
            Ok(())
        })
        .unwrap();
        assert!(ending.is_whole(), "{:?}", ending.damage);
        steps
    }
}

/// A client with its own memory of what came.
pub struct Operator {
    pub client: Client,
    pub commander: Commander,
    pub events: Vec<Event>,
    pub state: Option<StateMessage>,
}

impl Operator {
    pub fn new(socket: &Path) -> Self {
        let client = Client::connect(socket).unwrap();
        let commander = client.commander().unwrap();
        Self { client, commander, events: Vec::new(), state: None }
    }

    pub fn next(&mut self) -> ServerMessage {
        let message = self.client.next(LONG).unwrap().expect("the session is silent");
        match &message {
            ServerMessage::State(state) => self.state = Some((**state).clone()),
            ServerMessage::Event(event) => self.events.push(event.clone()),
            _ => {}
        }
        message
    }

    /// Sends a command and waits for its answer: the tick, or what is wrong.
    pub fn ask(&mut self, command: Command) -> Result<u64, (Problem, String)> {
        let id = self.commander.send(command).unwrap();
        loop {
            match self.next() {
                ServerMessage::Ack { id: of, tick } if of == id => return Ok(tick),
                ServerMessage::Error { id: Some(of), problem, message } if of == id => {
                    return Err((problem, message));
                }
                _ => {}
            }
        }
    }

    /// Waits for an event that is not known yet.
    pub fn wait(&mut self, kind: &str) -> Event {
        let begin = Instant::now();
        while begin.elapsed() < LONG {
            if let ServerMessage::Event(event) = self.next()
                && event.kind.starts_with(kind)
            {
                return event;
            }
        }
        panic!("no {kind}, but {:?}", self.events);
    }

    /// Waits for a state of this kind.
    pub fn wait_state(&mut self, is: impl Fn(&StateMessage) -> bool) -> StateMessage {
        loop {
            if let ServerMessage::State(state) = self.next()
                && is(&state)
            {
                return *state;
            }
        }
    }
}

/// A sink whose content can be looked at, and which can be full.
#[derive(Clone, Default)]
pub struct Shelf(pub Arc<Mutex<Content>>);

#[derive(Default)]
pub struct Content {
    pub bytes: Vec<u8>,
    /// Bytes for which there is room, or as many as wanted.
    pub room: Option<usize>,
    /// How long every write takes.
    pub delay: Duration,
}

impl Write for Shelf {
    fn write(&mut self, data: &[u8]) -> std::io::Result<usize> {
        let delay = self.0.lock().unwrap().delay;
        std::thread::sleep(delay);
        let mut content = self.0.lock().unwrap();
        let left = content.room.map_or(data.len(), |room| room.saturating_sub(content.bytes.len()));
        if left == 0 && !data.is_empty() {
            return Err(std::io::Error::new(std::io::ErrorKind::StorageFull, "no space left on device"));
        }
        let taken = left.min(data.len());
        content.bytes.extend_from_slice(&data[..taken]);
        Ok(taken)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
