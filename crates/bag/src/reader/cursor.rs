use super::Encoding;

/// Walks over the bytes of a message, and never past their end.
#[derive(Debug)]
pub(super) struct Cursor<'a> {
    body: &'a [u8],
    place: usize,
    big: bool,
    /// Whether values stand at multiples of their size.
    aligned: bool,
}

impl<'a> Cursor<'a> {
    /// At the beginning of a message.
    ///
    /// # Errors
    /// In words, for a form of CDR that ROS does not write.
    pub(super) fn of(encoding: Encoding, data: &'a [u8]) -> Result<Self, String> {
        if encoding == Encoding::Ros1 {
            return Ok(Self { body: data, place: 0, big: false, aligned: false });
        }
        let Some((&[high, low, ..], body)) = data.split_first_chunk::<4>() else {
            return Err(format!("it has {} bytes, a message in CDR at least 4", data.len()));
        };
        match (high, low) {
            (0, 0 | 1) => Ok(Self { body, place: 0, big: low == 0, aligned: true }),
            (0, 2 | 3) => Err("it is a parameter list (PL_CDR); only plain CDR is read".to_owned()),
            (0, 6..=13) => Err(format!(
                "it is encoded in version 2 of XCDR ({high:02x}{low:02x}); only plain CDR is read"
            )),
            _ => Err(format!("it begins with {high:02x}{low:02x}, which is no encoding of CDR")),
        }
    }

    fn left(&self) -> usize {
        self.body.len().saturating_sub(self.place)
    }

    #[cold]
    fn short(&self, need: usize) -> String {
        format!("it ends after {} bytes of content, where {need} more are needed", self.body.len())
    }

    fn align(&mut self, size: usize) {
        if self.aligned {
            self.place = self.place.next_multiple_of(size.max(1));
        }
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let end = self.place.saturating_add(count);
        let taken = self.body.get(self.place..end).ok_or_else(|| self.short(count))?;
        self.place = end;
        Ok(taken)
    }

    fn number<const N: usize>(&mut self) -> Result<[u8; N], String> {
        self.align(N);
        let rest = self.body.get(self.place..).unwrap_or_default();
        let mut bytes = *rest.first_chunk::<N>().ok_or_else(|| self.short(N))?;
        self.place += N;
        if self.big {
            bytes.reverse();
        }
        Ok(bytes)
    }

    pub(super) fn u8(&mut self) -> Result<u8, String> {
        self.number().map(u8::from_le_bytes)
    }

    pub(super) fn i8(&mut self) -> Result<i8, String> {
        self.number().map(i8::from_le_bytes)
    }

    pub(super) fn u16(&mut self) -> Result<u16, String> {
        self.number().map(u16::from_le_bytes)
    }

    pub(super) fn i16(&mut self) -> Result<i16, String> {
        self.number().map(i16::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Result<u32, String> {
        self.number().map(u32::from_le_bytes)
    }

    pub(super) fn i32(&mut self) -> Result<i32, String> {
        self.number().map(i32::from_le_bytes)
    }

    pub(super) fn u64(&mut self) -> Result<u64, String> {
        self.number().map(u64::from_le_bytes)
    }

    pub(super) fn i64(&mut self) -> Result<i64, String> {
        self.number().map(i64::from_le_bytes)
    }

    pub(super) fn f32(&mut self) -> Result<f32, String> {
        self.number().map(f32::from_le_bytes)
    }

    pub(super) fn f64(&mut self) -> Result<f64, String> {
        self.number().map(f64::from_le_bytes)
    }

    /// Seconds and nanoseconds as ns. Seconds of a time in ROS 1 have no sign.
    pub(super) fn ns(&mut self, signed: bool) -> Result<i64, String> {
        let seconds = if signed { i64::from(self.i32()?) } else { i64::from(self.u32()?) };
        // In a duration of ROS 1 the nanoseconds have a sign, but are never negative.
        Ok(seconds * 1_000_000_000 + i64::from(self.u32()?))
    }

    /// The length of a list. Each value takes a byte at least, so none can be longer than what is left.
    pub(super) fn length(&mut self, most: usize) -> Result<usize, String> {
        let length = self.u32()? as usize;
        if length > self.left() {
            return Err(format!(
                "a list of {length} values does not fit into the {} bytes left",
                self.left()
            ));
        }
        if length > most {
            return Err(format!("a list has {length} values; its definition allows {most}"));
        }
        Ok(length)
    }

    /// The bytes of a text.
    pub(super) fn text(&mut self) -> Result<&'a [u8], String> {
        let length = self.u32()? as usize;
        let text = self.take(length)?;
        match text.split_last() {
            // In CDR the zero at the end counts; some leave it out of an empty text.
            Some((&0, text)) if self.aligned => Ok(text),
            Some(_) if self.aligned => Err("a text does not end with a zero".to_owned()),
            _ => Ok(text),
        }
    }

    /// A list of bytes.
    pub(super) fn bytes(&mut self, most: usize) -> Result<&'a [u8], String> {
        let length = self.length(most)?;
        self.take(length)
    }

    /// Passes over values of one size.
    pub(super) fn pass(&mut self, size: usize, count: usize) -> Result<(), String> {
        if count > 0 {
            self.align(size);
            self.take(size.saturating_mul(count))?;
        }
        Ok(())
    }

    /// Checks that the message ends here. Recorders may pad one in CDR to a multiple of four bytes.
    pub(super) fn end(&self) -> Result<(), String> {
        let padding = if self.aligned { 3 } else { 0 };
        if self.left() > padding {
            return Err(format!("{} bytes are left over", self.left()));
        }
        Ok(())
    }
}
