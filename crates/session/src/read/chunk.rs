use mcap::records::ChunkHeader;
use std::borrow::Cow;
use std::io::Read;

use super::MOST_BYTES;

/// The records inside a chunk, decompressed and compared with their checksum.
///
/// # Errors
/// In words.
pub(super) fn unpack<'a>(header: &ChunkHeader, data: &'a [u8]) -> Result<Cow<'a, [u8]>, String> {
    let size = usize::try_from(header.uncompressed_size).unwrap_or(usize::MAX);
    if size > MOST_BYTES {
        return Err(format!("a chunk of {size} bytes is too large; the largest allowed is {MOST_BYTES}"));
    }
    let records = match header.compression.as_str() {
        "" => Cow::Borrowed(data),
        "zstd" => Cow::Owned(
            unzstd(data, size).map_err(|error| format!("a chunk cannot be decompressed: {error}"))?,
        ),
        other => return Err(format!("a chunk is compressed with `{other}`; only zstd is known")),
    };
    if records.len() != size {
        return Err(format!("a chunk has {} bytes instead of {size}", records.len()));
    }
    let found = crc32fast::hash(&records);
    if header.uncompressed_crc != 0 && header.uncompressed_crc != found {
        return Err("the checksum of a chunk does not hold".to_owned());
    }
    Ok(records)
}

/// Decompresses at most one byte more than `size`, in memory that grows with what is there.
fn unzstd(data: &[u8], size: usize) -> std::io::Result<Vec<u8>> {
    let mut records = Vec::new();
    zstd::stream::read::Decoder::new(data)?.take(size as u64 + 1).read_to_end(&mut records)?;
    Ok(records)
}

/// Takes the next record off the front: opcode and content.
///
/// # Errors
/// In words.
pub(super) fn next<'a>(records: &mut &'a [u8]) -> Result<Option<(u8, &'a [u8])>, String> {
    let cut = || "a chunk ends in the middle of a record".to_owned();
    let Some((&opcode, rest)) = records.split_first() else { return Ok(None) };
    let (length, rest) = rest.split_first_chunk::<8>().ok_or_else(cut)?;
    let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| cut())?;
    let (content, rest) = rest.split_at_checked(length).ok_or_else(cut)?;
    *records = rest;
    Ok(Some((opcode, content)))
}
