use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::read::{Item, scan};
use crate::{CONFIGURATION_RECORD, SESSION_RECORD, SessionError};

/// Messages after which a log that says nothing of itself is of another program.
const PATIENCE: u32 = 1000;
/// How the types of our messages are called.
const OUR_TYPES: &str = "soilctl_msgs/";

/// What ends the look.
enum Seen {
    Own,
    Foreign,
}

impl From<SessionError> for Seen {
    fn from(_: SessionError) -> Self {
        // What it is and why it cannot be read is said by those who read it then.
        Self::Foreign
    }
}

/// Whether soilctl wrote a log: it has a record of ours, or a message of one of our types, near its beginning. What is no log, or cannot be
/// read, is of others; so is everything once `stop` is set.
#[must_use]
pub fn is_own(path: &Path, stop: &AtomicBool) -> bool {
    let mut messages = 0;
    let seen = scan::<Seen>(path, &mut |item| match item {
        _ if stop.load(Ordering::Relaxed) => Err(Seen::Foreign),
        Item::Metadata { name: SESSION_RECORD | CONFIGURATION_RECORD, .. } => Err(Seen::Own),
        Item::Message(message) if message.channel.message_type.starts_with(OUR_TYPES) => Err(Seen::Own),
        Item::Message(_) => {
            messages += 1;
            if messages < PATIENCE { Ok(()) } else { Err(Seen::Foreign) }
        }
        Item::Header { .. } | Item::Metadata { .. } | Item::Attachment { .. } => Ok(()),
    });
    matches!(seen, Err(Seen::Own))
}
