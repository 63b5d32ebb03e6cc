use std::collections::VecDeque;

use serde::Serialize;

use super::lines::encode;

/// Most bytes that wait for a slow reader.
pub const MOST_OUTBOX_BYTES: usize = 256 << 10;

/// Lines on their way to a reader that may be slow. What does not fit is left out and counted, so that memory stays bounded
/// and nobody waits.
#[derive(Debug, Default)]
pub struct Outbox {
    bytes: VecDeque<u8>,
    dropped: u64,
}

impl Outbox {
    /// Adds a message as a line, if there is room.
    pub fn push<T: Serialize>(&mut self, message: &T) {
        self.push_line(&encode(message));
    }

    /// Adds a line with its end, if there is room.
    pub fn push_line(&mut self, line: &str) {
        if self.bytes.len() + line.len() > MOST_OUTBOX_BYTES {
            self.dropped += 1;
        } else {
            self.bytes.extend(line.as_bytes());
        }
    }

    /// Hands bytes to `write`, which says how many it took, until it takes no more.
    ///
    /// # Errors
    /// Those of `write`.
    pub fn drain<E>(&mut self, mut write: impl FnMut(&[u8]) -> Result<usize, E>) -> Result<(), E> {
        while !self.bytes.is_empty() {
            let (front, _) = self.bytes.as_slices();
            let taken = write(front)?;
            if taken == 0 {
                break;
            }
            self.bytes.drain(..taken.min(self.bytes.len()));
        }
        Ok(())
    }

    /// Whether everything is on its way.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// Whether more than half of the room is taken.
    #[must_use]
    pub fn is_crowded(&self) -> bool {
        self.bytes.len() > MOST_OUTBOX_BYTES / 2
    }

    /// Counts a message that was left out on purpose, because the reader is slow.
    pub const fn skip(&mut self) {
        self.dropped += 1;
    }

    /// Messages left out so far.
    #[must_use]
    pub const fn dropped(&self) -> u64 {
        self.dropped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reader_that_stopped_costs_bounded_memory() {
        let mut outbox = Outbox::default();
        for _ in 0..100_000 {
            outbox.push_line("0123456789\n");
        }
        let mut taken = Vec::new();
        assert!(outbox.dropped() > 0);
        outbox
            .drain(|bytes| {
                taken.extend_from_slice(&bytes[..bytes.len().min(7)]);
                Ok::<_, ()>(bytes.len().min(7))
            })
            .unwrap();
        assert!(taken.len() <= MOST_OUTBOX_BYTES && outbox.is_empty());
        // Lines stay whole.
        assert_eq!(taken.len() as u64 / 11 + outbox.dropped(), 100_000);
        assert!(taken.chunks(11).all(|line| line == b"0123456789\n"));
    }
}
