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
    let records =
        decompress(&header.compression, data, size).map_err(|problem| format!("a chunk {problem}"))?;
    if records.len() != size {
        return Err(format!("a chunk has {} bytes instead of {size}", records.len()));
    }
    let found = crc32fast::hash(&records);
    if header.uncompressed_crc != 0 && header.uncompressed_crc != found {
        return Err("the checksum of a chunk does not hold".to_owned());
    }
    Ok(records)
}

/// Undoes one of the compressions of MCAP, `zstd` or `lz4`; without a name the data are as they stand. At most one byte more than
/// `most` comes out, so that whoever knows the size can see that it is another, in memory that grows with what is there.
///
/// # Errors
/// In words, as the end of a sentence about what was compressed.
pub fn decompress<'a>(compression: &str, data: &'a [u8], most: usize) -> Result<Cow<'a, [u8]>, String> {
    let enough = (most as u64).saturating_add(1);
    let mut plain = Vec::new();
    let done = match compression {
        "" => return Ok(Cow::Borrowed(data)),
        "zstd" => zstd::stream::read::Decoder::new(data)
            .and_then(|decoder| decoder.take(enough).read_to_end(&mut plain)),
        "lz4" => lz4_flex::frame::FrameDecoder::new(data).take(enough).read_to_end(&mut plain),
        other => return Err(format!("is compressed with `{other}`; only zstd and lz4 are known")),
    };
    done.map_err(|error| format!("cannot be decompressed: {error}"))?;
    Ok(Cow::Owned(plain))
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
