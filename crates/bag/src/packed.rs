//! What is compressed as a whole: files, and messages one by one.

use std::borrow::Cow;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use soilctl_session::read::decompress;
use tempfile::NamedTempFile;

use crate::BagError;

/// First bytes of what is compressed with zstd. No message in CDR begins so.
pub(crate) const ZSTD: [u8; 4] = [0x28, 0xb5, 0x2f, 0xfd];
/// Largest message after decompression, in bytes.
pub(crate) const MOST_BYTES: usize = 256 << 20;
/// Recordings shrink to a third or a tenth. A file that grows a thousandfold was made to fill the disk.
const MOST_GROWTH: u64 = 1000;
const ALWAYS_ALLOWED: u64 = 64 << 20;

/// What a compressed file holds, as it is read.
pub(crate) fn zstd(file: File) -> std::io::Result<impl Read> {
    zstd::stream::read::Decoder::with_buffer(BufReader::new(file))
}

/// Ends where its source fails, and keeps what was said: what came before is still good.
pub(crate) struct Lenient<R> {
    pub(crate) source: R,
    pub(crate) problem: Option<String>,
}

impl<R: Read> Read for Lenient<R> {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        match self.source.read(into) {
            Err(error) if error.kind() != std::io::ErrorKind::Interrupted => {
                self.problem = Some(format!("it cannot be decompressed to its end: {error}"));
                Ok(0)
            }
            other => other,
        }
    }
}

/// What a compressed file holds, in a file that is gone once it is dropped; and what is wrong with the end of it. It is made where temporary
/// files belong, since a folder of recordings may be on a medium that cannot be written to.
pub(crate) fn unpacked(path: &Path) -> Result<(NamedTempFile, Option<String>), BagError> {
    let failed = |error: &std::io::Error| BagError::file(path, error);
    let file = File::open(path).map_err(|error| failed(&error))?;
    let packed = file.metadata().map_err(|error| failed(&error))?.len();
    let most = packed.saturating_mul(MOST_GROWTH).max(ALWAYS_ALLOWED);
    let source = zstd(file).map_err(|error| failed(&error))?;
    let mut source = Lenient { source, problem: None };
    let mut plain = NamedTempFile::new().map_err(|error| no_room(path, &error))?;
    // Its own errors are of the temporary file, since the source has none.
    let size = std::io::copy(&mut (&mut source).take(most.saturating_add(1)), &mut plain)
        .map_err(|error| no_room(path, &error))?;
    if size > most {
        return Err(BagError::TooLarge { file: path.display().to_string(), packed, most });
    }
    Ok((plain, source.problem))
}

fn no_room(path: &Path, error: &std::io::Error) -> BagError {
    let folder = std::env::temp_dir();
    BagError::file(
        path,
        &format!(
            "it cannot be decompressed into {}: {error}; set TMPDIR to a folder with more room",
            folder.display()
        ),
    )
}

/// A message as it was before the recorder compressed it, if it did; nothing if it did not.
///
/// # Errors
/// In words.
pub(crate) fn message<'a>(encoding: &str, data: &'a [u8]) -> Option<Result<Cow<'a, [u8]>, String>> {
    if encoding != "cdr" || !data.starts_with(&ZSTD) {
        return None;
    }
    Some(match decompress("zstd", data, MOST_BYTES) {
        Ok(plain) if plain.len() > MOST_BYTES => {
            Err(format!("a message has more than {MOST_BYTES} bytes once it is decompressed"))
        }
        Ok(plain) => Ok(plain),
        Err(problem) => Err(format!("a message {problem}")),
    })
}
