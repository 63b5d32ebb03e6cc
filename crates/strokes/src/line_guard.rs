use std::io::{Error, ErrorKind, Read, Result};

/// Longest line that is let through.
const MAX_LINE: usize = 1 << 20;

/// A reader that fails on an endless line, so that a file that is no table at all cannot fill the memory.
pub(crate) struct LineGuard<R> {
    inner: R,
    /// Bytes since the last line end.
    since_end: usize,
}

impl<R> LineGuard<R> {
    pub(crate) const fn new(inner: R) -> Self {
        Self { inner, since_end: 0 }
    }

    pub(crate) const fn inner(&self) -> &R {
        &self.inner
    }
}

impl<R: Read> Read for LineGuard<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.inner.read(buffer)?;
        let end = buffer[..count].iter().rposition(|byte| *byte == b'\n');
        self.since_end = end.map_or(self.since_end + count, |at| count - at - 1);
        if self.since_end > MAX_LINE {
            let problem = "a line is longer than 1 MiB; this is not a stroke table with one stroke a line";
            return Err(Error::new(ErrorKind::InvalidData, problem));
        }
        Ok(count)
    }
}
