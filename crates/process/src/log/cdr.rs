//! A cursor over a message in CDR that copies nothing: of a log's bytes only few are needed.

/// Reads values one after the other, each aligned to its size from the beginning of the body. Every method is `None`
/// when the message is too short.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    body: &'a [u8],
    place: usize,
}

impl<'a> Cursor<'a> {
    /// The body of a message; `None` unless its first four bytes say "plain CDR, little endian".
    pub(super) fn new(message: &'a [u8]) -> Option<Self> {
        let (head, body) = message.split_first_chunk::<4>()?;
        (head[..2] == [0, 1]).then_some(Self { body, place: 0 })
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.place = self.place.next_multiple_of(N);
        let bytes = self.body.get(self.place..)?.first_chunk::<N>()?;
        self.place += N;
        Some(*bytes)
    }

    pub(super) fn u8(&mut self) -> Option<u8> {
        self.take::<1>().map(|[byte]| byte)
    }

    pub(super) fn u16(&mut self) -> Option<u16> {
        self.take().map(u16::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    pub(super) fn i32(&mut self) -> Option<i32> {
        self.take().map(i32::from_le_bytes)
    }

    pub(super) fn u64(&mut self) -> Option<u64> {
        self.take().map(u64::from_le_bytes)
    }

    pub(super) fn f64(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    pub(super) fn f64s<const N: usize>(&mut self) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for value in &mut values {
            *value = self.f64()?;
        }
        Some(values)
    }

    /// Passes over `N` numbers of eight bytes.
    pub(super) fn skip_f64s(&mut self, count: usize) -> Option<()> {
        if count > 0 {
            self.place = self.place.next_multiple_of(8).checked_add(count.checked_mul(8)?)?;
        }
        (self.place <= self.body.len()).then_some(())
    }

    /// Passes over `count` numbers of four bytes.
    pub(super) fn skip_u32s(&mut self, count: usize) -> Option<()> {
        if count > 0 {
            self.place = self.place.next_multiple_of(4).checked_add(count.checked_mul(4)?)?;
        }
        (self.place <= self.body.len()).then_some(())
    }

    /// A text without its closing zero.
    pub(super) fn text(&mut self) -> Option<&'a str> {
        let length = usize::try_from(self.u32()?).ok()?;
        let bytes = self.body.get(self.place..self.place.checked_add(length)?)?;
        self.place += length;
        std::str::from_utf8(bytes.strip_suffix(&[0]).unwrap_or(bytes)).ok()
    }

    /// Numbers of a list of variable length.
    pub(super) fn list(&mut self) -> Option<impl Iterator<Item = f64> + Clone + use<'a>> {
        let count = usize::try_from(self.u32()?).ok()?;
        let start = self.place.next_multiple_of(8);
        self.skip_f64s(count)?;
        let bytes: &'a [u8] = if count > 0 { self.body.get(start..self.place)? } else { &[] };
        let (numbers, _) = bytes.as_chunks::<8>();
        Some(numbers.iter().map(|number| f64::from_le_bytes(*number)))
    }

    /// Whether nothing is left but padding.
    pub(super) fn is_done(&self) -> bool {
        self.body.len() - self.place.min(self.body.len()) <= 3
    }
}

/// A stamp in ns; `None` if it was not set.
pub(super) fn stamp(cursor: &mut Cursor<'_>) -> Option<Option<i64>> {
    let (sec, nanosec) = (cursor.i32()?, cursor.u32()?);
    let ns = i64::from(sec) * 1_000_000_000 + i64::from(nanosec);
    Some((ns != 0).then_some(ns))
}
