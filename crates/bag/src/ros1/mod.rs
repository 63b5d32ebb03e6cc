//! Bags of ROS 1, read from beginning to end. The index at their end is not needed, so a bag that was never closed is read too.
//! The format: <https://wiki.ros.org/Bags/Format/2.0>.

mod content;
mod record;

use std::io::Read;
use std::path::Path;

use soilctl_session::read::{Ending, Item};

use self::content::Content;
use self::record::{Flaw, Header, op};
use crate::BagError;
use crate::damage::note;
use crate::scan::{Halt, Visit};

/// First line of the file.
const MAGIC: &[u8] = b"#ROSBAG V2.0\n";
/// Largest record, in bytes. `rosbag record` writes chunks of 768 kB.
const MOST_BYTES: u32 = 256 << 20;

/// Shows what a bag holds.
pub(crate) fn show(source: &mut dyn Read, path: &Path, visit: &mut Visit<'_>) -> Result<Ending, Halt> {
    let failed = |error: &std::io::Error| BagError::file(path, error);
    let mut magic = Vec::new();
    source.take(MAGIC.len() as u64).read_to_end(&mut magic).map_err(|error| failed(&error))?;
    if magic != MAGIC {
        return Err(BagError::not_a_recording(path, "it does not begin with `#ROSBAG V2.0`").into());
    }
    let mut ending = Ending { bytes: MAGIC.len() as u64, ..Ending::default() };
    let (mut header, mut data) = (Vec::new(), Vec::new());
    let mut content = Content::default();
    let mut told: Option<Told> = None;
    let (mut chunks, mut listed) = (0, Told::default());
    loop {
        match record::read(source, &mut header, &mut data, MOST_BYTES, &mut ending.bytes) {
            Ok(true) => {}
            Ok(false) => break,
            Err(Flaw::System(error)) => return Err(failed(&error).into()),
            Err(Flaw::Cut) => {
                let bytes = ending.bytes;
                let cut =
                    format!("the file ends after {bytes} bytes in the middle, as after a kill or a crash");
                ending.damage.push(cut);
                break;
            }
            Err(Flaw::Words(problem)) => {
                ending.damage.push(format!("within the first {} bytes: {problem}", ending.bytes));
                break;
            }
        }
        let header = Header(&header);
        match header.op() {
            Some(op::BAG) if told.is_none() => {
                if header.text("encryptor").is_some_and(|name| !name.is_empty()) {
                    return Err(BagError::not_a_recording(path, "it is encrypted").into());
                }
                let number = |name: &str| header.u32(name).unwrap_or(0);
                told = Some(Told { chunks: number("chunk_count"), connections: number("conn_count") });
                visit(Item::Header { profile: "ros1", library: "" })?;
                if header.u64("index_pos") == Some(0) {
                    note(&mut ending.damage, "it has no index: the recording did not end well".to_owned());
                }
            }
            _ if told.is_none() => {
                return Err(BagError::not_a_recording(path, "it does not begin with a header").into());
            }
            Some(op::CHUNK) => {
                chunks += 1;
                content.chunk(header, &data, &mut ending, visit)?;
            }
            Some(op) => {
                listed.connections += u32::from(op == op::CONNECTION);
                listed.chunks += u32::from(op == op::CHUNK_INFO);
                content.record(header, &data, &mut ending.damage, visit)?;
            }
            None => note(&mut ending.damage, "a record does not say what it is".to_owned()),
        }
    }
    let Some(told) = told else {
        return Err(BagError::not_a_recording(path, "it ends before its header").into());
    };
    if told.chunks > chunks {
        let missing = told.chunks - chunks;
        note(&mut ending.damage, format!("{missing} of its {} chunks are not there", told.chunks));
    } else if (told.connections > listed.connections || told.chunks > listed.chunks) && ending.is_whole() {
        note(&mut ending.damage, "the file was cut within its index; its messages are there".to_owned());
    }
    Ok(ending)
}

/// What the header counts, and the index at the end of the file lists.
#[derive(Debug, Default)]
struct Told {
    chunks: u32,
    connections: u32,
}
