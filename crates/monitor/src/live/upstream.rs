use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use soilctl_live::Client;
use soilctl_live::protocol::{Configuration, ServerMessage};

use super::Hub;
use crate::MonitorError;
use crate::feed::text;
use crate::messages::PageMessage;
use crate::scene::Scene;
use crate::soil::Surface;

/// How long a session may take to say what it runs with.
const ANSWER: Duration = Duration::from_secs(3);
/// Between two attempts to reach it again.
const RETRY: Duration = Duration::from_millis(500);

/// The connection to a session; it is made again whenever it breaks.
pub(crate) struct Upstream {
    path: PathBuf,
    commands: bool,
    hub: Arc<Hub>,
    stop: Arc<AtomicBool>,
}

impl Upstream {
    /// Connects, and listens in a thread of its own until `stop`.
    pub(crate) fn start(
        path: PathBuf,
        commands: bool,
        hub: Arc<Hub>,
        stop: Arc<AtomicBool>,
    ) -> Result<JoinHandle<()>, MonitorError> {
        let upstream = Self { path, commands, hub, stop };
        let first = upstream.connect()?;
        std::thread::Builder::new()
            .name("upstream".to_owned())
            .spawn(move || upstream.run(first))
            .map_err(|reason| MonitorError::Thread { thread: "upstream", reason })
    }

    fn run(&self, first: (Client, Surface)) {
        let mut connection = Some(first);
        while !self.stop.load(Ordering::Relaxed) {
            let reason = match connection.take() {
                Some((client, surface)) => self.listen(client, surface),
                None => match self.connect() {
                    Ok(fresh) => {
                        connection = Some(fresh);
                        continue;
                    }
                    Err(error) => error.to_string(),
                },
            };
            self.hub.connect(None);
            self.hub.lock().set_link(false, reason);
            std::thread::sleep(RETRY);
        }
    }

    fn connect(&self) -> Result<(Client, Surface), MonitorError> {
        let mut client = Client::connect(&self.path)?;
        let mut commander = client.commander()?;
        commander.describe()?;
        let scene = Scene::new(&configuration(&mut client)?)?;
        let surface = Surface::new(&scene)?;
        let name = self.path.display().to_string();
        let greeting = [
            text(&ServerMessage::Hello(client.hello().clone())),
            text(&PageMessage::Scene(scene.message(&name, true, self.commands))),
        ];
        self.hub.connect(Some(commander));
        let mut inner = self.hub.lock();
        inner.begin(Arc::new(greeting));
        inner.set_link(true, String::new());
        (inner.soil, inner.soils) = (Some((surface.grid(), surface.heights().into())), inner.soils + 1);
        drop(inner);
        Ok((client, surface))
    }

    /// Hands on what the session says, until it says no more; returns why.
    fn listen(&self, mut client: Client, mut surface: Surface) -> String {
        let mut ended = None;
        while !self.stop.load(Ordering::Relaxed) {
            match client.next(Duration::from_millis(200)) {
                Ok(None) => {}
                Ok(Some(ServerMessage::End { reason })) => ended = Some(reason),
                Ok(Some(message)) => self.hand_on(message, &mut surface),
                Err(error) => {
                    return ended.map_or_else(
                        || error.to_string(),
                        |reason| format!("the session has ended: {reason}"),
                    );
                }
            }
        }
        "the monitor ends".to_owned()
    }

    fn hand_on(&self, message: ServerMessage, surface: &mut Surface) {
        match message {
            ServerMessage::State(state) => {
                surface.follow(state.joints_deg, state.homed, state.waiting);
                let (grid, heights) = (surface.grid(), surface.heights());
                let words = text(&ServerMessage::State(state.clone()));
                let mut inner = self.hub.lock();
                if inner.soil.as_ref().is_none_or(|(_, old)| **old != *heights) {
                    (inner.soil, inner.soils) = (Some((grid, heights.into())), inner.soils + 1);
                }
                inner.note_state(*state, words);
            }
            ServerMessage::Event(event) => {
                let words = text(&ServerMessage::Event(event.clone()));
                let mut inner = self.hub.lock();
                inner.note_event(event);
                inner.tell_all(&words);
            }
            ServerMessage::Ack { id, tick } => {
                let mut inner = self.hub.lock();
                if let Some((page, id)) = inner.answered(id) {
                    inner.tell(page, &text(&ServerMessage::Ack { id, tick }));
                }
            }
            ServerMessage::Error { id: Some(id), problem, message } => {
                let mut inner = self.hub.lock();
                if let Some((page, id)) = inner.answered(id) {
                    let error = ServerMessage::Error { id: Some(id), problem, message };
                    inner.tell(page, &text(&error));
                }
            }
            ServerMessage::Error { id: None, problem, message } => self.hub.lock().give_up(problem, &message),
            _ => {}
        }
    }
}

/// What the session runs with.
fn configuration(client: &mut Client) -> Result<Configuration, MonitorError> {
    let deadline = Instant::now() + ANSWER;
    while let Some(left) = deadline.checked_duration_since(Instant::now()) {
        match client.next(left)? {
            Some(ServerMessage::Configuration(configuration)) => return Ok(*configuration),
            Some(ServerMessage::End { reason }) => return Err(MonitorError::Ended(reason)),
            _ => {}
        }
    }
    Err(MonitorError::Silent)
}
