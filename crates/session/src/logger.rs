use std::collections::BTreeMap;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use rtrb::{Consumer, Producer, PushError, RingBuffer};
use soilctl_controller::{Commands, Outputs, Sensed, State};

use crate::record::{Entry, KEYFRAME_STEPS};
use crate::{LogWriter, SessionError, SessionSetup, StepRecord, Truth};

/// Places in the ring in real time: 8 s of steps and key frames.
const REAL_TIME_PLACES: usize = 4096;
/// Places when the control thread waits anyway.
const SIMULATED_PLACES: usize = 1024;
/// How long either side sleeps when it has nothing to do. A step takes 2 ms.
const NAP: Duration = Duration::from_micros(200);
/// Time between two flushes in real time: a little less than the second that may be lost, since a flush takes time too.
const FLUSH_INTERVAL: Duration = Duration::from_millis(800);

/// Who waits for whom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pace {
    /// The control thread waits for the logger: nothing is lost, and the file is flushed every 500 steps, at which point
    /// the control thread waits until it is. The same steps give the same bytes.
    Simulated,
    /// The control thread never waits: what the ring cannot hold is counted and lost. The file is flushed every second
    /// of wall time.
    RealTime,
}

/// How a log ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LogReport {
    /// Steps in the file.
    pub steps: u64,
    /// Steps that are not in it, because the disk was too slow.
    pub dropped_steps: u64,
}

#[derive(Debug, Default)]
struct Shared {
    /// Entries that are safe in the file.
    flushed: AtomicU64,
    /// The control thread will send no more.
    closed: AtomicBool,
    /// The logger gave up; its thread returns why.
    failed: AtomicBool,
    /// Steps that did not fit into the ring.
    dropped: AtomicU64,
    /// What the end record says beside the numbers of steps. Nobody waits for it: it is set once, at the end.
    notes: Mutex<BTreeMap<String, String>>,
}

/// The control thread's end: takes steps.
///
/// In real time nothing here allocates, locks, waits or fails.
#[derive(Debug)]
pub struct Recorder {
    ring: Producer<Entry>,
    shared: Arc<Shared>,
    pace: Pace,
    step: u64,
    sent: u64,
}

/// The thread that writes.
#[derive(Debug)]
pub struct Logger {
    thread: JoinHandle<Result<u64, SessionError>>,
    shared: Arc<Shared>,
}

impl Logger {
    /// Begins a log in a new file; one that is there is replaced.
    ///
    /// # Errors
    /// [`SessionError::File`] if it cannot be made, otherwise as [`Logger::start`].
    pub fn create(path: &Path, setup: &SessionSetup, pace: Pace) -> Result<(Self, Recorder), SessionError> {
        let file = File::create(path).map_err(|error| SessionError::file(path, &error))?;
        Self::start(file, setup, pace)
    }

    /// Begins a log in `sink`.
    ///
    /// # Errors
    /// Those of [`LogWriter::new`], or [`SessionError::Thread`].
    pub fn start<W: Write + Send + 'static>(
        sink: W,
        setup: &SessionSetup,
        pace: Pace,
    ) -> Result<(Self, Recorder), SessionError> {
        let writer = LogWriter::new(sink, setup)?;
        let places = if pace == Pace::RealTime { REAL_TIME_PLACES } else { SIMULATED_PLACES };
        let (producer, mut consumer) = RingBuffer::new(places);
        let shared = Arc::new(Shared::default());
        let theirs = Arc::clone(&shared);
        let thread = std::thread::Builder::new()
            .name("logger".to_owned())
            .spawn(move || {
                // The ring outlives the flag: a recorder that finds it abandoned must find the failure said.
                let done = write(writer, &mut consumer, &theirs, pace);
                if done.is_err() {
                    theirs.failed.store(true, Ordering::Release);
                }
                done
            })
            .map_err(SessionError::Thread)?;
        let recorder = Recorder { ring: producer, shared: Arc::clone(&shared), pace, step: 0, sent: 0 };
        Ok((Self { thread, shared }, recorder))
    }

    /// Waits until everything is written. Give the [`Recorder`] back first, by dropping it.
    ///
    /// # Errors
    /// [`SessionError::Write`] if the log could not be written to its end.
    pub fn finish(self) -> Result<LogReport, SessionError> {
        self.finish_with(BTreeMap::new())
    }

    /// As [`Logger::finish`], with texts of one's own by name in the end record, such as the jitter of a run in real
    /// time. Here the [`Recorder`] is to be dropped afterwards: a log whose recorder is gone does not wait for texts.
    ///
    /// # Errors
    /// As [`Logger::finish`].
    pub fn finish_with(self, notes: BTreeMap<String, String>) -> Result<LogReport, SessionError> {
        *self.shared.notes.lock().unwrap_or_else(PoisonError::into_inner) = notes;
        self.shared.closed.store(true, Ordering::Release);
        let lost = || SessionError::Write { steps: 0, reason: "its thread ended unexpectedly".to_owned() };
        let steps = self.thread.join().map_err(|_| lost())??;
        Ok(LogReport { steps, dropped_steps: self.shared.dropped.load(Ordering::Acquire) })
    }

    /// Whether the log could not be written any further; [`Logger::finish`] says why.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.shared.failed.load(Ordering::Acquire)
    }

    /// Steps lost so far.
    #[must_use]
    pub fn dropped_steps(&self) -> u64 {
        self.shared.dropped.load(Ordering::Acquire)
    }
}

impl Recorder {
    /// To be called before each step with the state that it will change: every 500 steps it becomes a key frame.
    ///
    /// Says whether the log goes on: in a simulated run `false` means that it failed and the run should end.
    pub fn before(&mut self, state: &State) -> bool {
        if !self.step.is_multiple_of(KEYFRAME_STEPS) {
            return true;
        }
        let sent = self.send(Entry::Keyframe { step: self.step, state: *state });
        match self.pace {
            Pace::Simulated => sent && self.wait_for_flush(),
            // A key frame that does not fit is no lost step; a replay then goes on from the next one.
            Pace::RealTime => true,
        }
    }

    /// To be called after each step.
    ///
    /// Says whether the log goes on, as [`Recorder::before`].
    pub fn after(
        &mut self,
        sensed: &Sensed,
        commands: &Commands,
        outputs: &Outputs,
        state: &State,
        truth: Option<Truth>,
    ) -> bool {
        let record = StepRecord::new(sensed, commands, outputs, state, truth);
        let sent = self.send(Entry::Step { step: self.step, record });
        self.step += 1;
        if !sent {
            self.shared.dropped.fetch_add(1, Ordering::AcqRel);
        }
        sent || self.pace == Pace::RealTime
    }

    /// Steps lost so far.
    #[must_use]
    pub fn dropped_steps(&self) -> u64 {
        self.shared.dropped.load(Ordering::Relaxed)
    }

    /// Steps recorded or lost.
    #[must_use]
    pub const fn steps(&self) -> u64 {
        self.step
    }

    fn send(&mut self, mut entry: Entry) -> bool {
        loop {
            match self.ring.push(entry) {
                Ok(()) => {
                    self.sent += 1;
                    return true;
                }
                Err(PushError::Full(back)) => {
                    if self.pace == Pace::RealTime || self.gave_up() {
                        return false;
                    }
                    entry = back;
                    std::thread::sleep(NAP);
                }
            }
        }
    }

    /// Waits until all but the key frame that was just sent is in the file, so that a killed run loses fewer than 500
    /// steps.
    fn wait_for_flush(&self) -> bool {
        while self.shared.flushed.load(Ordering::Acquire) + 1 < self.sent {
            if self.gave_up() {
                return false;
            }
            std::thread::sleep(NAP);
        }
        true
    }

    fn gave_up(&self) -> bool {
        self.shared.failed.load(Ordering::Acquire) || self.ring.is_abandoned()
    }
}

/// The logger's thread: the number of steps written.
fn write<W: Write>(
    mut writer: LogWriter<W>,
    ring: &mut Consumer<Entry>,
    shared: &Shared,
    pace: Pace,
) -> Result<u64, SessionError> {
    let mut written = 0;
    let mut last_flush = Instant::now();
    loop {
        // Asked before the ring is: what was sent before it closed is still there.
        let closed = shared.closed.load(Ordering::Acquire) || ring.is_abandoned();
        match ring.pop() {
            Ok(entry) => {
                if pace == Pace::Simulated && matches!(entry, Entry::Keyframe { .. }) {
                    writer.flush()?;
                    shared.flushed.store(written, Ordering::Release);
                }
                writer.entry(&entry)?;
                written += 1;
                if written == 1 {
                    // The first key frame: even a run that is killed at once can be replayed as far as it came.
                    writer.flush()?;
                }
            }
            Err(_) if closed => break,
            Err(_) => std::thread::sleep(NAP),
        }
        if pace == Pace::RealTime && last_flush.elapsed() >= FLUSH_INTERVAL {
            writer.flush()?;
            last_flush = Instant::now();
        }
    }
    let steps = writer.steps();
    let notes = std::mem::take(&mut *shared.notes.lock().unwrap_or_else(PoisonError::into_inner));
    writer.finish_with(shared.dropped.load(Ordering::Acquire), notes)?;
    Ok(steps)
}
