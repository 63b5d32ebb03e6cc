//! Frames of fixed length: little endian, with four letters and a version at the beginning.

use thiserror::Error;

/// Version of the frames.
pub(crate) const FRAME_VERSION: u16 = 1;

/// What is wrong with a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FrameError {
    /// It does not begin as a frame should.
    #[error(
        "sent a frame that begins with {0:02x?}, not with its four letters; frames are little endian and without gaps"
    )]
    Magic([u8; 4]),
    /// It is of another version.
    #[error("speaks version {0} of the frames, not {FRAME_VERSION}")]
    Version(u16),
}

/// Fills the bytes of a frame.
pub(crate) struct Writer<'a> {
    bytes: &'a mut [u8],
    at: usize,
}

impl<'a> Writer<'a> {
    pub(crate) const fn new(bytes: &'a mut [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub(crate) fn put(&mut self, part: &[u8]) {
        if let Some(place) = self.bytes.get_mut(self.at..self.at + part.len()) {
            place.copy_from_slice(part);
        }
        self.at += part.len();
    }

    pub(crate) fn floats(&mut self, numbers: &[f64]) {
        numbers.iter().for_each(|number| self.put(&number.to_le_bytes()));
    }
}

/// Takes the bytes of a frame.
pub(crate) struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Reader<'a> {
    pub(crate) const fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub(crate) fn take<const N: usize>(&mut self) -> [u8; N] {
        let part = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>());
        self.at += N;
        part.copied().unwrap_or([0; N])
    }

    pub(crate) fn floats<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| f64::from_le_bytes(self.take()))
    }

    pub(crate) fn head(&mut self, magic: [u8; 4]) -> Result<(), FrameError> {
        let found = self.take();
        if found != magic {
            return Err(FrameError::Magic(found));
        }
        let version = u16::from_le_bytes(self.take());
        if version != FRAME_VERSION {
            return Err(FrameError::Version(version));
        }
        let _: [u8; 2] = self.take();
        Ok(())
    }
}
