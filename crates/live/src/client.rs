use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::LiveError;
use crate::local::{Stream, connect};
use crate::protocol::{ClientMessage, Command, Hello, PROTOCOL_VERSION, ServerMessage};

/// Longest line that a session is believed to send.
const MOST_BYTES: usize = 1 << 20;

/// An operator's end of a session.
#[derive(Debug)]
pub struct Client {
    messages: Messages,
    hello: Hello,
}

/// What comes from a session, line by line.
#[derive(Debug)]
struct Messages {
    stream: Stream,
    path: PathBuf,
    bytes: Vec<u8>,
    /// Bytes of `bytes` in which there is no line end.
    searched: usize,
}

/// Sends commands to a session.
#[derive(Debug)]
pub struct Commander {
    stream: Stream,
    path: PathBuf,
    next_id: u64,
}

impl Commander {
    /// Sends a command; returns the id under which its answer comes.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if the session is gone.
    pub fn send(&mut self, command: Command) -> Result<u64, LiveError> {
        let id = self.next_id;
        self.next_id += 1;
        let line = crate::protocol::encode(&ClientMessage::Command { id, command });
        self.stream.write_all(line.as_bytes()).map_err(|error| LiveError::socket(&self.path, &error))?;
        Ok(id)
    }

    /// Asks what the session runs with; the answer comes as a message. A session that is too old to know the question
    /// answers with an error.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if the session is gone.
    pub fn describe(&mut self) -> Result<(), LiveError> {
        let line = crate::protocol::encode(&ClientMessage::Describe {});
        self.stream.write_all(line.as_bytes()).map_err(|error| LiveError::socket(&self.path, &error))
    }
}

impl Client {
    /// Connects and waits for the session's hello.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if nobody listens there, [`LiveError::Protocol`] if it is another protocol.
    pub fn connect(path: &Path) -> Result<Self, LiveError> {
        let stream = connect(path).map_err(|error| LiveError::socket(path, &error))?;
        let mut messages = Messages { stream, path: path.to_owned(), bytes: Vec::new(), searched: 0 };
        let other =
            |found: String| LiveError::Protocol { path: path.to_owned(), known: PROTOCOL_VERSION, found };
        match messages.next(Duration::from_secs(5))? {
            Some(ServerMessage::Hello(hello)) if hello.protocol == PROTOCOL_VERSION => {
                Ok(Self { messages, hello })
            }
            Some(ServerMessage::Hello(hello)) => Err(other(format!("it speaks {}", hello.protocol))),
            Some(_) => Err(other("it does not begin with a hello".to_owned())),
            None => Err(other("it says nothing".to_owned())),
        }
    }

    /// What the session said about itself.
    #[must_use]
    pub const fn hello(&self) -> &Hello {
        &self.hello
    }

    /// The other end, which sends commands; it may live in another thread.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if the system has no handle left.
    pub fn commander(&self) -> Result<Commander, LiveError> {
        let Messages { stream, path, .. } = &self.messages;
        let stream = stream.try_clone().map_err(|error| LiveError::socket(path, &error))?;
        Ok(Commander { stream, path: path.clone(), next_id: 1 })
    }

    /// The next message, or none within `timeout`.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if the session is gone, [`LiveError::Protocol`] for what is no message.
    pub fn next(&mut self, timeout: Duration) -> Result<Option<ServerMessage>, LiveError> {
        self.messages.next(timeout)
    }
}

impl Messages {
    fn next(&mut self, timeout: Duration) -> Result<Option<ServerMessage>, LiveError> {
        let deadline = Instant::now() + timeout;
        loop {
            if let Some(line) = self.line() {
                return serde_json::from_slice(&line).map(Some).map_err(|error| LiveError::Protocol {
                    path: self.path.clone(),
                    known: PROTOCOL_VERSION,
                    found: error.to_string(),
                });
            }
            let gone = |reason: &dyn std::fmt::Display| LiveError::socket(&self.path, reason);
            if self.bytes.len() > MOST_BYTES {
                return Err(gone(&"it sends no line ends"));
            }
            let left = deadline.saturating_duration_since(Instant::now()).max(Duration::from_micros(1));
            self.stream.set_read_timeout(Some(left)).map_err(|error| gone(&error))?;
            let mut bytes = [0; 1 << 14];
            match self.stream.read(&mut bytes) {
                Ok(0) => return Err(gone(&"the session has ended")),
                Ok(count) => self.bytes.extend_from_slice(bytes.get(..count).unwrap_or_default()),
                Err(error) => match error.kind() {
                    ErrorKind::WouldBlock | ErrorKind::TimedOut => return Ok(None),
                    ErrorKind::Interrupted => {}
                    _ => return Err(gone(&error)),
                },
            }
        }
    }

    fn line(&mut self) -> Option<Vec<u8>> {
        let fresh = self.bytes.get(self.searched..)?;
        let Some(end) = fresh.iter().position(|&byte| byte == b'\n') else {
            self.searched = self.bytes.len();
            return None;
        };
        let rest = self.bytes.split_off(self.searched + end + 1);
        self.searched = 0;
        Some(std::mem::replace(&mut self.bytes, rest))
    }
}
