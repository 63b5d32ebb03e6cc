//! A workbench, and a page that is a program.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used, clippy::panic)]

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use soilctl_workbench::{Settings, Workbench};
use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{Message, WebSocket};

/// Nothing takes so long, also on a busy machine.
pub const LONG: Duration = Duration::from_secs(120);

/// What a workbench noted.
pub type Notes = Arc<Mutex<Vec<String>>>;

/// A workbench on a free port.
pub fn workbench(file: Option<&Path>) -> (Workbench, Notes) {
    let notes = Notes::default();
    let theirs = Arc::clone(&notes);
    let note = Box::new(move |text: &str| theirs.lock().unwrap().push(text.to_owned()));
    (Workbench::start(file, Settings { port: 0, note }).unwrap(), notes)
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

/// A strip load on clay, whose bearing capacity is (2 + pi) c.
pub fn strip_load() -> Value {
    json!({
        "title": "strip",
        "default_boundary": "free",
        "objective": {"kind": "load"},
        "soil": [{"name": "clay", "phi_deg": 0, "cohesion_kpa": 10, "unit_weight_kn_m3": 18}],
        "region": [{"soil": "clay", "polygon": [[-8, -6], [8, -6], [8, 0], [-8, 0]]}],
        "boundary": [
            {"kind": "far", "sides": ["left", "right", "bottom"]},
            {"kind": "load", "line": [[-1, 0], [1, 0]], "pressure_kpa": 1, "live": true},
        ],
    })
}

/// A page.
pub struct Page {
    pub socket: WebSocket<TcpStream>,
}

impl Page {
    /// A page that was greeted.
    pub fn open(workbench: &Workbench) -> Self {
        let at = workbench.address();
        let mut page = Self::from_origin(at, Some(&format!("http://{at}"))).unwrap();
        assert_eq!(page.next()["type"], "hello");
        page
    }

    /// The status that it is refused with, or a page.
    pub fn from_origin(address: SocketAddr, origin: Option<&str>) -> Result<Self, u16> {
        let stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(Some(LONG)).unwrap();
        let mut request = format!("ws://{address}/socket").into_client_request().unwrap();
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

    /// With the token; the answer.
    pub fn authorize(&mut self, workbench: &Workbench) -> Value {
        self.ask(&json!({"type": "authorize", "token": workbench.token()}), "file")
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

    /// The next message of a type.
    pub fn wait(&mut self, kind: &str) -> Value {
        let begin = Instant::now();
        loop {
            let message = self.next();
            if message["type"] == kind {
                return message;
            }
            assert!(begin.elapsed() < LONG, "no {kind}");
        }
    }

    /// Says something and waits for a type of answer.
    pub fn ask(&mut self, message: &Value, kind: &str) -> Value {
        self.say(message);
        self.wait(kind)
    }

    /// What is understood of a problem.
    pub fn check(&mut self, problem: &Value) -> Value {
        self.ask(&json!({"type": "check", "id": 7, "problem": problem}), "checked")
    }
}
