//! CDR as ROS 2 uses it: four bytes that say "plain, little endian", then the message.

use byteorder::LittleEndian;
use serde::Serialize;
use serde::de::DeserializeOwned;

const ENCAPSULATION: [u8; 4] = [0, 1, 0, 0];

/// Replaces the content of `buffer` by the message.
///
/// # Errors
/// What the encoder says; a sequence of unknown length, which no message has.
pub(crate) fn encode<T: Serialize>(message: &T, buffer: &mut Vec<u8>) -> Result<(), cdr_encoding::Error> {
    buffer.clear();
    buffer.extend_from_slice(&ENCAPSULATION);
    cdr_encoding::to_writer::<T, LittleEndian, _>(buffer, message)
}

/// The message in these bytes.
///
/// # Errors
/// In words: another encapsulation, too few or too many bytes, or text that is not UTF-8.
pub(crate) fn decode<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let Some((head, body)) = bytes.split_first_chunk::<4>() else {
        return Err(format!("it has {} bytes, a message at least 4", bytes.len()));
    };
    if head[..2] != ENCAPSULATION[..2] {
        return Err(format!("its encoding is {:02x}{:02x}, not 0001 (CDR, little endian)", head[0], head[1]));
    }
    let (message, used) =
        cdr_encoding::from_bytes::<T, LittleEndian>(body).map_err(|error| error.to_string())?;
    // Recorders may pad a message to a multiple of four bytes.
    if body.len() - used > 3 {
        return Err(format!("{} bytes are left over", body.len() - used));
    }
    Ok(message)
}
