use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use soilctl_controller::Sensed;
use soilctl_plant::{Drive, Hardware};

use super::frames::{DriveFrame, READINGS_BYTES, ReadingsFrame};
use crate::LiveError;
use crate::local::{Stream, connect};

/// A driver that is silent for so long, or for ten time-outs if that is longer, is taken to be gone.
const SILENCE: Duration = Duration::from_secs(1);

/// Hardware behind the socket of a driver.
///
/// A driver that does not answer in time costs its readings: the last ones are handed out again, with their sequence numbers,
/// so that the controller sees silent sensors and goes to the safe state. Nothing here waits longer than the time-out.
#[derive(Debug)]
pub struct SocketDriver {
    path: PathBuf,
    stream: Stream,
    timeout: Duration,
    tick: u64,
    last: Sensed,
    frame: [u8; READINGS_BYTES],
    /// Bytes of `frame` that have come.
    filled: usize,
    exchanges: Exchanges,
    gone: Option<String>,
    /// When it answered last.
    heard: Instant,
}

/// Counts of a [`SocketDriver`].
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Exchanges {
    /// Ticks with readings in time.
    pub answered: u64,
    /// Ticks without.
    pub missed: u64,
    /// Readings that came too late, and were thrown away.
    pub late: u64,
}

impl SocketDriver {
    /// Connects to a driver that listens at `path`; `timeout` is for each tick.
    ///
    /// # Errors
    /// [`LiveError::Socket`] if nobody listens there.
    pub fn connect(path: &Path, timeout: Duration) -> Result<Self, LiveError> {
        let stream = connect(path).map_err(|error| LiveError::socket(path, &error))?;
        // A driver that does not take its frames must not stop the controller either.
        stream.set_write_timeout(Some(timeout)).map_err(|error| LiveError::socket(path, &error))?;
        Ok(Self {
            path: path.to_owned(),
            stream,
            timeout,
            tick: 0,
            last: Sensed::default(),
            frame: [0; READINGS_BYTES],
            filled: 0,
            exchanges: Exchanges::default(),
            gone: None,
            heard: Instant::now(),
        })
    }

    /// How the exchanges went.
    #[must_use]
    pub const fn exchanges(&self) -> Exchanges {
        self.exchanges
    }

    /// Whether there will be no more readings.
    #[must_use]
    pub const fn is_gone(&self) -> bool {
        self.gone.is_some()
    }

    /// Why there will be no more readings, if there won't.
    #[must_use]
    pub fn gone(&self) -> Option<LiveError> {
        let reason = self.gone.clone()?;
        Some(LiveError::Driver { path: self.path.clone(), reason })
    }

    fn send(&mut self, drive: &Drive) -> Result<(), String> {
        let frame = DriveFrame { tick: self.tick, drive: *drive }.encode();
        // Half a frame would shift all that follow, so a time-out in the middle is the end too.
        self.stream.write_all(&frame).map_err(|error| match error.kind() {
            ErrorKind::WouldBlock | ErrorKind::TimedOut => "does not take its frames".to_owned(),
            ErrorKind::BrokenPipe | ErrorKind::ConnectionReset => "has closed the connection".to_owned(),
            _ => format!("cannot be written to: {error}"),
        })
    }

    /// The readings of this tick, or none in time.
    fn receive(&mut self) -> Result<Option<Sensed>, String> {
        let deadline = Instant::now() + self.timeout;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Ok(None);
            }
            let broken = |error: std::io::Error| format!("cannot be read: {error}");
            self.stream.set_read_timeout(Some(left)).map_err(broken)?;
            let room = self.frame.get_mut(self.filled..).unwrap_or_default();
            match self.stream.read(room) {
                Ok(0) => return Err("has closed the connection".to_owned()),
                Ok(count) => self.filled += count,
                Err(error) => match error.kind() {
                    ErrorKind::WouldBlock | ErrorKind::TimedOut => return Ok(None),
                    ErrorKind::Interrupted => {}
                    ErrorKind::ConnectionReset => return Err("has closed the connection".to_owned()),
                    _ => return Err(broken(error)),
                },
            }
            if self.filled == READINGS_BYTES {
                self.filled = 0;
                let sensed = ReadingsFrame::decode(&self.frame).map_err(|error| error.to_string())?.sensed;
                if sensed.tick == self.tick {
                    return Ok(Some(sensed));
                }
                if sensed.tick > self.tick {
                    return Err(format!("answered tick {} before it was asked", sensed.tick));
                }
                self.exchanges.late += 1;
            }
        }
    }
}

impl Hardware for SocketDriver {
    type Error = LiveError;

    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, LiveError> {
        self.tick += 1;
        if self.tick == 1 {
            self.heard = Instant::now();
        }
        let answer = match self.gone {
            Some(_) => None,
            None => self.send(drive).and_then(|()| self.receive()).unwrap_or_else(|reason| {
                self.gone = Some(reason);
                None
            }),
        };
        match answer {
            Some(sensed) => {
                self.exchanges.answered += 1;
                self.last = sensed;
                self.heard = Instant::now();
            }
            None => {
                self.exchanges.missed += 1;
                self.last.tick = self.tick;
                let silent = self.heard.elapsed();
                if self.gone.is_none() && silent > SILENCE.max(10 * self.timeout) {
                    self.gone = Some(format!("has not answered for {:.1} s", silent.as_secs_f64()));
                }
            }
        }
        Ok(self.last)
    }
}
