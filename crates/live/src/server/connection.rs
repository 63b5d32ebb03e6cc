use std::io::{ErrorKind, Read, Write};
use std::time::Instant;

use crate::local::Stream;
use crate::protocol::{
    ClientMessage, LINES_PER_SECOND, Line, LineReader, MOST_LINE_BYTES, Outbox, Problem, Rate,
    read_client_message,
};

/// Most bytes that are read from a client in one round.
const ROUND_BYTES: usize = 16 << 10;

/// What a client's line was: a message, or what is wrong with it.
pub(super) type Understood = Result<ClientMessage, (Option<u64>, Problem, String)>;

/// A client.
pub(super) struct Connection {
    stream: Stream,
    reader: LineReader,
    rate: Rate,
    pub(super) outbox: Outbox,
    hung_up: bool,
    /// It was told that it is too fast, and not since.
    warned: bool,
}

impl Connection {
    pub(super) fn new(stream: Stream) -> std::io::Result<Self> {
        stream.set_nonblocking(true)?;
        let (reader, outbox) = (LineReader::default(), Outbox::default());
        Ok(Self { stream, reader, rate: Rate::new(Instant::now()), outbox, hung_up: false, warned: false })
    }

    /// Closes the connection once everything is sent.
    pub(super) const fn hang_up(&mut self) {
        self.hung_up = true;
    }

    /// Takes what the client has sent; says whether it is still there.
    pub(super) fn read(&mut self, now: Instant, take: &mut dyn FnMut(&mut Self, Understood)) -> bool {
        let mut bytes = [0; ROUND_BYTES];
        let count = match self.stream.read(&mut bytes) {
            Ok(0) => return false,
            Ok(count) => count,
            Err(error) => return matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted),
        };
        let mut lines = Vec::new();
        self.reader.read(bytes.get(..count).unwrap_or_default(), |line| lines.push(line));
        for line in lines {
            if self.hung_up {
                break;
            }
            let allowed = self.rate.allow(now);
            if allowed {
                self.warned = false;
                let read = understand(&line);
                take(self, read);
            } else if !self.warned {
                self.warned = true;
                let text = format!(
                    "more than {LINES_PER_SECOND} lines a second; the rest is left out, wait a second"
                );
                take(self, Err((None, Problem::TooFast, text)));
            }
        }
        true
    }

    /// Sends what the client takes; says whether it is still there.
    pub(super) fn write(&mut self) -> bool {
        let stream = &mut self.stream;
        let sent = self.outbox.drain(|bytes| match stream.write(bytes) {
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted) => Ok(0),
            other => other,
        });
        sent.is_ok() && !(self.hung_up && self.outbox.is_empty())
    }
}

fn understand(line: &Line) -> Understood {
    match line {
        Line::Text(text) => read_client_message(text),
        Line::TooLong => Err((None, Problem::TooLong, format!("a line has at most {MOST_LINE_BYTES} bytes"))),
        Line::NotText => Err((None, Problem::Malformed, "the line is not UTF-8".to_owned())),
    }
}
