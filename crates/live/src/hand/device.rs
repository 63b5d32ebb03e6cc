use std::io::{ErrorKind, Read, Write};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;

use super::frames::{HAND_BYTES, HandFrame, TOUCH_BYTES};
use crate::links::{DeviceEnds, Shared};
use crate::local::{Listener, Stream};

/// How long the thread sleeps between two rounds: a quarter of a tick.
const NAP: Duration = Duration::from_micros(500);
/// The same while there is no device.
const LONG_NAP: Duration = Duration::from_millis(10);
/// Most bytes that are read in one round: some hundred frames.
const ROUND_BYTES: usize = 100 * HAND_BYTES;
/// Most bytes that wait for a device; a frame for which there is no room is left out, and the next one is as good.
const MOST_WAITING: usize = 4 * TOUCH_BYTES;

/// What a device's thread leaves behind.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct DeviceReport {
    /// Devices that connected.
    pub(crate) devices: u64,
    /// Those that were sent away: another one was there, or they sent what is no frame.
    pub(crate) refused: u64,
}

/// The thread of the socket for devices: one at a time.
pub(crate) struct Devices {
    pub(crate) listener: Listener,
    pub(crate) path: PathBuf,
    pub(crate) ends: DeviceEnds,
    pub(crate) shared: Arc<Shared>,
}

/// A device.
struct Device {
    stream: Stream,
    /// Bytes of frames that have not come whole.
    bytes: Vec<u8>,
    /// Bytes that it has not taken.
    waiting: Vec<u8>,
}

impl Devices {
    /// Serves until the servo has ended.
    pub(crate) fn run(mut self) -> DeviceReport {
        let (mut report, mut device) = (DeviceReport::default(), None::<Device>);
        while !self.shared.ended.load(Ordering::Acquire) {
            while let Some(stream) = self.listener.poll() {
                // A second one is hung up on.
                let fresh = device.is_none().then(|| Device::new(stream)).and_then(Result::ok);
                report.devices += u64::from(fresh.is_some());
                report.refused += u64::from(fresh.is_none());
                device = device.or(fresh);
            }
            device = device.and_then(|mut device| match device.round(&mut self.ends) {
                Round::Goes => Some(device),
                Round::Gone => None,
                Round::NoFrame => {
                    report.refused += 1;
                    None
                }
            });
            if device.is_none() {
                while self.ends.touches.pop().is_ok() {}
            }
            std::thread::sleep(if device.is_some() { NAP } else { LONG_NAP });
        }
        let _ = std::fs::remove_file(&self.path);
        report
    }
}

/// How a round went.
enum Round {
    Goes,
    Gone,
    NoFrame,
}

impl Device {
    fn new(stream: Stream) -> std::io::Result<Self> {
        stream.set_nonblocking(true)?;
        Ok(Self { stream, bytes: Vec::new(), waiting: Vec::new() })
    }

    fn round(&mut self, ends: &mut DeviceEnds) -> Round {
        let mut bytes = [0; ROUND_BYTES];
        match self.stream.read(&mut bytes) {
            Ok(0) => return Round::Gone,
            Ok(count) => self.bytes.extend_from_slice(bytes.get(..count).unwrap_or_default()),
            Err(error) if is_later(&error) => {}
            Err(_) => return Round::Gone,
        }
        // Of several only the last says where the hand is now.
        let mut last = None;
        let (frames, rest) = self.bytes.as_chunks::<HAND_BYTES>();
        for bytes in frames {
            match HandFrame::decode(bytes) {
                Ok(frame) => last = Some(frame),
                Err(_) => return Round::NoFrame,
            }
        }
        self.bytes = rest.to_vec();
        if let Some(frame) = last {
            // A servo that has not taken the ones before will take those.
            let _ = ends.hands.push(frame);
        }
        while let Ok(touch) = ends.touches.pop() {
            if self.waiting.len() + TOUCH_BYTES <= MOST_WAITING {
                self.waiting.extend_from_slice(&touch.encode());
            }
        }
        while !self.waiting.is_empty() {
            match self.stream.write(&self.waiting) {
                Ok(0) => return Round::Gone,
                Ok(count) => drop(self.waiting.drain(..count.min(self.waiting.len()))),
                Err(error) if is_later(&error) => break,
                Err(_) => return Round::Gone,
            }
        }
        Round::Goes
    }
}

fn is_later(error: &std::io::Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted)
}
