use std::io::Read;

/// Longest header of a record, in bytes. Headers have some hundred.
const MOST_HEADER: u32 = 1 << 20;

/// Kinds of records.
pub(super) mod op {
    pub(in crate::ros1) const MESSAGE: u8 = 2;
    pub(in crate::ros1) const BAG: u8 = 3;
    pub(in crate::ros1) const CHUNK: u8 = 5;
    pub(in crate::ros1) const CHUNK_INFO: u8 = 6;
    pub(in crate::ros1) const CONNECTION: u8 = 7;
}

/// The header of a record: fields of the form `name=value`, each with its length before it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Header<'a>(pub(super) &'a [u8]);

impl<'a> Header<'a> {
    /// The fields, as far as they can be made out.
    pub(super) fn fields(self) -> impl Iterator<Item = (&'a [u8], &'a [u8])> {
        let mut rest = self.0;
        std::iter::from_fn(move || {
            let field = part(&mut rest)?;
            let place = field.iter().position(|&byte| byte == b'=')?;
            let (name, value) = field.split_at_checked(place)?;
            Some((name, value.get(1..)?))
        })
    }

    pub(super) fn get(self, name: &str) -> Option<&'a [u8]> {
        self.fields().find(|(known, _)| *known == name.as_bytes()).map(|(_, value)| value)
    }

    pub(super) fn op(self) -> Option<u8> {
        self.get("op").and_then(|value| value.first().copied())
    }

    pub(super) fn u32(self, name: &str) -> Option<u32> {
        self.get(name)?.first_chunk().map(|bytes| u32::from_le_bytes(*bytes))
    }

    pub(super) fn u64(self, name: &str) -> Option<u64> {
        self.get(name)?.first_chunk().map(|bytes| u64::from_le_bytes(*bytes))
    }

    /// Seconds and nanoseconds as ns.
    pub(super) fn ns(self, name: &str) -> Option<u64> {
        let (seconds, ns) = self.get(name)?.first_chunk::<8>()?.split_first_chunk::<4>()?;
        let ns = u32::from_le_bytes(*ns.first_chunk()?);
        Some(u64::from(u32::from_le_bytes(*seconds)) * 1_000_000_000 + u64::from(ns))
    }

    pub(super) fn text(self, name: &str) -> Option<String> {
        self.get(name).map(|value| String::from_utf8_lossy(value).into_owned())
    }
}

/// Takes what has its length before it off the front.
fn part<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let (length, after) = rest.split_first_chunk::<4>()?;
    let (taken, after) = after.split_at_checked(usize::try_from(u32::from_le_bytes(*length)).ok()?)?;
    *rest = after;
    Some(taken)
}

/// Takes the next record off the front of a chunk: header and data.
///
/// # Errors
/// In words.
pub(super) fn next<'a>(rest: &mut &'a [u8]) -> Result<Option<(Header<'a>, &'a [u8])>, String> {
    if rest.is_empty() {
        return Ok(None);
    }
    let cut = || "a chunk ends in the middle of a record".to_owned();
    let header = part(rest).ok_or_else(cut)?;
    Ok(Some((Header(header), part(rest).ok_or_else(cut)?)))
}

/// Why a record cannot be read.
pub(super) enum Flaw {
    /// The system says so.
    System(std::io::Error),
    /// The file ends in the middle of it.
    Cut,
    /// In words.
    Words(String),
}

/// Reads the next record of the file into the buffers, which grow with what is there, and counts its bytes. Says whether there was one.
pub(super) fn read(
    source: &mut dyn Read,
    header: &mut Vec<u8>,
    data: &mut Vec<u8>,
    most_data: u32,
    bytes: &mut u64,
) -> Result<bool, Flaw> {
    let Some(length) = length(source, bytes)? else { return Ok(false) };
    if length > MOST_HEADER {
        return Err(Flaw::Words(format!(
            "a record has a header of {length} bytes; the longest allowed has {MOST_HEADER}"
        )));
    }
    exactly(source, length, header, bytes)?;
    let length = self::length(source, bytes)?.ok_or(Flaw::Cut)?;
    if length > most_data {
        return Err(Flaw::Words(format!(
            "a record of {length} bytes is too large; the largest allowed is {most_data}"
        )));
    }
    exactly(source, length, data, bytes)?;
    Ok(true)
}

fn length(source: &mut dyn Read, bytes: &mut u64) -> Result<Option<u32>, Flaw> {
    let mut length = Vec::with_capacity(4);
    source.take(4).read_to_end(&mut length).map_err(Flaw::System)?;
    *bytes += length.len() as u64;
    match length.first_chunk::<4>() {
        Some(length) => Ok(Some(u32::from_le_bytes(*length))),
        None if length.is_empty() => Ok(None),
        None => Err(Flaw::Cut),
    }
}

fn exactly(source: &mut dyn Read, count: u32, into: &mut Vec<u8>, bytes: &mut u64) -> Result<(), Flaw> {
    into.clear();
    let read = source.take(count.into()).read_to_end(into).map_err(Flaw::System)?;
    *bytes += read as u64;
    if read < count as usize { Err(Flaw::Cut) } else { Ok(()) }
}
