use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use soilctl_live::Client;
use soilctl_live::protocol::{Configuration, Event, Problem, ServerMessage};

use super::Hub;
use crate::MonitorError;
use crate::messages::{PageMessage, text};
use crate::scene::{SURFACE_FOUND, Scene};
use crate::soil::Surface;

/// How long a session may take to say what it runs with.
const ANSWER: Duration = Duration::from_secs(3);
/// Between two attempts to reach it again.
const RETRY: Duration = Duration::from_millis(500);

/// A session, and what is known of it.
struct Connection {
    client: Client,
    scene: Scene,
    surface: Surface,
    /// Whether the level of the sand is one that was touched.
    touched: bool,
}

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

    fn run(&self, first: Connection) {
        let mut connection = Some(first);
        while !self.stop.load(Ordering::Relaxed) {
            let reason = match connection.take() {
                Some(connection) => self.listen(connection),
                None => match self.connect() {
                    Ok(fresh) => {
                        connection = Some(fresh);
                        continue;
                    }
                    Err(error) => error.to_string(),
                },
            };
            self.hub.connect(None);
            let mut inner = self.hub.lock();
            inner.give_up(Problem::Unavailable, "the session is gone; whether it did this is not known");
            inner.set_link(false, reason);
            drop(inner);
            std::thread::sleep(RETRY);
        }
    }

    fn connect(&self) -> Result<Connection, MonitorError> {
        let mut client = Client::connect(&self.path)?;
        let mut commander = client.commander()?;
        commander.describe()?;
        let scene = Scene::new(&configuration(&mut client)?)?;
        let surface = Surface::new(&scene)?;
        let connection = Connection { client, scene, surface, touched: false };
        self.hub.connect(Some(commander));
        let mut inner = self.hub.lock();
        inner.begin(self.greeting(&connection));
        inner.set_link(true, String::new());
        inner.set_soil(&connection.surface);
        drop(inner);
        Ok(connection)
    }

    /// What pages are told of a session first.
    fn greeting(&self, connection: &Connection) -> Arc<[String]> {
        let name = self.path.display().to_string();
        Arc::new([
            text(&ServerMessage::Hello(connection.client.hello().clone())),
            text(&PageMessage::Scene(Box::new(connection.scene.message(&name, true, self.commands)))),
        ])
    }

    /// Hands on what the session says, until it says no more; returns why.
    fn listen(&self, mut connection: Connection) -> String {
        let mut ended = None;
        while !self.stop.load(Ordering::Relaxed) {
            match connection.client.next(Duration::from_millis(200)) {
                Ok(None) => {}
                Ok(Some(ServerMessage::End { reason })) => ended = Some(reason),
                Ok(Some(message)) => self.hand_on(message, &mut connection),
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

    fn hand_on(&self, message: ServerMessage, connection: &mut Connection) {
        match message {
            ServerMessage::State(state) => {
                let surface = &mut connection.surface;
                let tip_m = state.plate.map(|plate| [plate.x_m, plate.y_m, plate.z_m]);
                surface.follow(state.joints_deg, tip_m, state.homed, state.waiting);
                let words = text(&ServerMessage::State(state.clone()));
                let mut inner = self.hub.lock();
                inner.set_soil(surface);
                inner.note_state(*state, words);
            }
            ServerMessage::Event(event) => {
                self.touch(&event, connection);
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

    /// The sand is where the arm first touched it, rather than where the settings say.
    fn touch(&self, event: &Event, connection: &mut Connection) {
        if event.kind != SURFACE_FOUND || !event.value.is_finite() || connection.touched {
            return;
        }
        let mut scene = connection.scene.clone();
        scene.sandbox.surface_z_m = event.value;
        if let Ok(surface) = Surface::new(&scene) {
            (connection.scene, connection.surface, connection.touched) = (scene, surface, true);
            let mut inner = self.hub.lock();
            inner.greet(self.greeting(connection));
            inner.set_soil(&connection.surface);
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
