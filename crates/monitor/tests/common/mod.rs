//! A session, a log, and a page that is a program.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::panic)]

use std::fs::File;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use soilctl_campaign::Plan;
use soilctl_live::protocol::{Command, ServerMessage};
use soilctl_live::{Client, Host, Rig, Session};
use soilctl_monitor::{BagSettings, Monitor, Settings, Source};
use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{Message, WebSocket};

/// Nothing takes so long, also on a busy machine.
pub const LONG: Duration = Duration::from_secs(120);

/// A simulated session at a socket.
pub fn session(socket: &Path, log: Option<File>) -> Host {
    let plan = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/plans/table_6_2.toml");
    let plan = Plan::read(&plan).unwrap();
    let setup = plan.setup(1).unwrap();
    let state = plan.first_state(&setup.params().unwrap());
    let rig = Rig::Plant(Box::new(plan.simulated_plant(1, 0).unwrap()));
    let session = Session { rig, setup, state, real_time: false, most_ticks: None, device: None };
    Host::start(session, socket, log).unwrap()
}

/// A log of an arm that moves for some seconds.
pub fn log(dir: &Path) -> PathBuf {
    let (socket, path) = (dir.join("maker"), dir.join("made.mcap"));
    let host = session(&socket, Some(File::create(&path).unwrap()));
    let mut client = Client::connect(&socket).unwrap();
    let mut commander = client.commander().unwrap();
    for command in [
        Command::Enable,
        Command::MoveJoints { joints_deg: [10.0, 40.0, 90.0, 0.0, 30.0] },
        Command::Advance { seconds: 4.0 },
        Command::End,
    ] {
        let wanted = commander.send(command).unwrap();
        loop {
            match client.next(LONG).unwrap().unwrap() {
                ServerMessage::Ack { id, .. } if id == wanted => break,
                ServerMessage::Error { message, .. } => panic!("{message}"),
                _ => {}
            }
        }
    }
    host.wait().unwrap();
    path
}

/// What a monitor noted.
pub type Notes = Arc<Mutex<Vec<String>>>;

/// A monitor on a free port.
pub fn monitor(source: Source, commands: bool) -> (Monitor, Notes) {
    let notes = Notes::default();
    let theirs = Arc::clone(&notes);
    let settings = Settings {
        listen: "127.0.0.1:0".parse().unwrap(),
        hosts: Vec::new(),
        commands,
        note: Box::new(move |text| theirs.lock().unwrap().push(text.to_owned())),
    };
    (Monitor::start(source, settings).unwrap(), notes)
}

pub fn play(path: &Path) -> Source {
    Source::Log { path: path.to_owned(), from_s: 0.0, bag: BagSettings::default() }
}

pub fn noted(notes: &Notes, words: &str) -> bool {
    notes.lock().unwrap().iter().any(|note| note.contains(words))
}

/// The whole answer to some bytes.
pub fn raw(address: SocketAddr, request: &[u8]) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(LONG)).unwrap();
    // It may be refused before it is complete.
    let _ = stream.write_all(request);
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).into_owned()
}

/// A page.
pub struct Page {
    pub socket: WebSocket<TcpStream>,
}

impl Page {
    pub fn open(address: SocketAddr) -> Self {
        Self::from_origin(address, Some(&format!("http://{address}"))).unwrap()
    }

    /// The status that it is refused with, or a page.
    pub fn from_origin(address: SocketAddr, origin: Option<&str>) -> Result<Self, u16> {
        Self::request(address, &address.to_string(), origin)
    }

    /// The same for a browser that knows the monitor by another host and port.
    pub fn through(address: SocketAddr, host: &str, origin: &str) -> Result<Self, u16> {
        Self::request(address, host, Some(origin))
    }

    fn request(address: SocketAddr, host: &str, origin: Option<&str>) -> Result<Self, u16> {
        let stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(LONG)).unwrap();
        let mut request = format!("ws://{host}/socket").into_client_request().unwrap();
        if let Some(origin) = origin {
            request.headers_mut().insert("Origin", HeaderValue::from_str(origin).unwrap());
        }
        match tungstenite::client(request, stream) {
            Ok((socket, _)) => Ok(Self { socket }),
            Err(tungstenite::HandshakeError::Failure(tungstenite::Error::Http(answer))) => {
                Err(answer.status().as_u16())
            }
            Err(other) => panic!("{other}"),
        }
    }

    pub fn say(&mut self, message: &Value) {
        self.socket.send(Message::text(message.to_string())).unwrap();
    }

    pub fn next(&mut self) -> Value {
        loop {
            if let Message::Text(text) = self.socket.read().unwrap() {
                return serde_json::from_str(&text).unwrap();
            }
        }
    }

    /// The next message of a type that is as wanted.
    pub fn wait(&mut self, kind: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        let begin = Instant::now();
        loop {
            let message = self.next();
            if message["type"] == kind && wanted(&message) {
                return message;
            }
            assert!(begin.elapsed() < LONG, "no {kind}");
        }
    }

    /// Sends a command as it is typed, and waits for the answer.
    pub fn line(&mut self, id: u64, text: &str) -> Value {
        self.say(&json!({"type": "line", "id": id, "text": text}));
        loop {
            let message = self.next();
            if message["id"] == id {
                return message;
            }
        }
    }

    /// The code that the monitor closes with.
    pub fn closed(&mut self) -> Option<u16> {
        loop {
            match self.socket.read() {
                Ok(Message::Close(frame)) => return frame.map(|frame| frame.code.into()),
                Ok(_) => {}
                Err(_) => return None,
            }
        }
    }
}
