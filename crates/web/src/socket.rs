use std::io::ErrorKind;
use std::net::{SocketAddr, TcpStream};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use soilctl_live::protocol::{LINES_PER_SECOND, Rate};
use tungstenite::error::ProtocolError;
use tungstenite::protocol::frame::CloseFrame;
use tungstenite::protocol::frame::coding::CloseCode;
use tungstenite::protocol::{WebSocket, WebSocketConfig};
use tungstenite::{Error, Message};

use crate::serving::Shared;
use crate::{Feed, Heard};

/// Messages that are read before the page is told anything again.
const ROUND: usize = 32;
/// What may wait inside the connection: a greeting and some more.
const MOST_BUFFERED: usize = 8 << 20;
/// How long a page may take nothing.
const PATIENCE: Duration = Duration::from_secs(20);
/// After so long without anything to tell a page is told that all is well; the page waits for three times as long.
const HEARTBEAT: Duration = Duration::from_secs(5);
/// Messages beyond the rate after which a page is sent away.
const MOST_TOO_FAST: u32 = 5000;
/// What a page is told then.
const ALL_IS_WELL: &str = "{\"type\":\"heartbeat\"}";

/// Limits of a connection.
pub(crate) fn config(most_message_bytes: usize) -> WebSocketConfig {
    WebSocketConfig::default()
        .read_buffer_size(8 << 10)
        .write_buffer_size(0)
        .max_write_buffer_size(MOST_BUFFERED)
        .max_message_size(Some(most_message_bytes))
        .max_frame_size(Some(most_message_bytes))
}

/// A page's connection.
pub(crate) struct Page<'a> {
    socket: WebSocket<TcpStream>,
    feed: Box<dyn Feed>,
    peer: SocketAddr,
    shared: &'a Shared,
    rate: Rate,
    too_fast: u32,
    warned: bool,
    /// Since when it takes nothing.
    stuck: Option<Instant>,
    /// When it was told something.
    told: Instant,
}

/// Why a page's connection ends.
enum End {
    /// It is gone.
    Gone,
    /// It is sent away.
    Close(CloseCode, &'static str),
}

impl<'a> Page<'a> {
    pub(crate) fn new(
        socket: WebSocket<TcpStream>,
        feed: Box<dyn Feed>,
        peer: SocketAddr,
        shared: &'a Shared,
    ) -> Self {
        let told = Instant::now();
        let rate = Rate::new(told);
        Self { socket, feed, peer, shared, rate, too_fast: 0, warned: false, stuck: None, told }
    }

    pub(crate) fn run(mut self) {
        let end = self.serve();
        if let End::Close(code, reason) = end {
            if code != CloseCode::Away {
                self.shared.refuse(self.peer, reason);
            }
            let _ = self.socket.close(Some(CloseFrame { code, reason: reason.into() }));
            // The page's answer, if it comes soon.
            for _ in 0..10 {
                match self.socket.read() {
                    Err(Error::Io(error)) if is_wait(error.kind()) => {}
                    Err(_) => break,
                    Ok(_) => {}
                }
            }
        }
    }

    fn serve(&mut self) -> End {
        loop {
            if self.shared.stop.load(Ordering::Relaxed) {
                return End::Close(CloseCode::Away, "the program ends");
            }
            let turn = self.tell().and_then(|()| self.listen());
            if let Err(end) = turn {
                return end;
            }
        }
    }

    /// Tells what there is to tell, unless what was told before is still on its way.
    fn tell(&mut self) -> Result<(), End> {
        if self.stuck.is_some() {
            return self.flush();
        }
        let mut messages = Vec::new();
        self.feed.poll(Instant::now(), &mut |message| messages.push(message));
        if messages.is_empty() && self.told.elapsed() > HEARTBEAT {
            messages.push(ALL_IS_WELL.to_owned());
        }
        messages.into_iter().try_for_each(|message| self.send(message))
    }

    fn send(&mut self, message: String) -> Result<(), End> {
        self.told = Instant::now();
        match self.socket.write(Message::text(message)) {
            Ok(()) => self.flush(),
            Err(Error::WriteBufferFull(_)) => {
                self.shared.dropped.fetch_add(1, Ordering::Relaxed);
                Ok(())
            }
            Err(error) => self.flushed(error),
        }
    }

    fn flush(&mut self) -> Result<(), End> {
        match self.socket.flush() {
            Ok(()) => {
                self.stuck = None;
                Ok(())
            }
            Err(error) => self.flushed(error),
        }
    }

    /// What an error of a write means: it is on its way, or the page is gone.
    fn flushed(&mut self, error: Error) -> Result<(), End> {
        match error {
            Error::Io(error) if is_wait(error.kind()) => {
                let since = *self.stuck.get_or_insert_with(Instant::now);
                if since.elapsed() > PATIENCE {
                    // There is no use in telling it.
                    self.shared.refuse(self.peer, "the page takes nothing any more");
                    return Err(End::Gone);
                }
                Ok(())
            }
            _ => Err(End::Gone),
        }
    }

    fn listen(&mut self) -> Result<(), End> {
        for _ in 0..ROUND {
            match self.socket.read() {
                Ok(message) => self.hear(message)?,
                Err(Error::Io(error)) if is_wait(error.kind()) => return Ok(()),
                Err(Error::Capacity(_)) => {
                    let most = self.shared.site.most_message_bytes();
                    self.shared.refuse(self.peer, &format!("a message has at most {most} bytes"));
                    return Err(End::Close(CloseCode::Size, "a message is too large"));
                }
                Err(Error::Utf8(_)) => return Err(End::Close(CloseCode::Invalid, "a message is not UTF-8")),
                // A page that is closed need not take its leave; that is nothing to refuse.
                Err(Error::Protocol(ProtocolError::ResetWithoutClosingHandshake)) => return Err(End::Gone),
                Err(Error::Protocol(_)) => {
                    return Err(End::Close(CloseCode::Protocol, "the page broke the WebSocket protocol"));
                }
                Err(_) => return Err(End::Gone),
            }
        }
        Ok(())
    }

    /// Pings and the like cost an answer, too, so that all messages are counted.
    fn hear(&mut self, message: Message) -> Result<(), End> {
        if !self.rate.allow(Instant::now()) {
            self.too_fast += 1;
            if self.too_fast > MOST_TOO_FAST {
                return Err(End::Close(CloseCode::Policy, "too many messages"));
            }
            if std::mem::replace(&mut self.warned, true) {
                return Ok(());
            }
            let words = format!("more than {LINES_PER_SECOND} messages a second; the rest is left out");
            return self.answer(self.feed.refuse(&words, true));
        }
        self.warned = false;
        let heard = match message {
            Message::Text(line) => self.feed.obey(&line),
            Message::Binary(_) => self.feed.refuse("the message is binary; messages are text", false),
            _ => return Ok(()),
        };
        self.answer(heard)
    }

    fn answer(&mut self, heard: Heard) -> Result<(), End> {
        if let Some(what) = heard.refused {
            self.shared.refuse(self.peer, &what);
        }
        heard.answer.map_or(Ok(()), |answer| self.send(answer))?;
        heard.send_away.map_or(Ok(()), |reason| Err(End::Close(CloseCode::Policy, reason)))
    }
}

fn is_wait(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}
