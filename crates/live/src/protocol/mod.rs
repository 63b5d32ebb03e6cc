//! What a session and its operators say to each other: one JSON object a line, in both directions, whatever carries the
//! lines. The reference is `docs/live.md`.

mod command;
mod lines;
mod message;
mod outbox;
mod rate;
mod scales;
mod state;
mod words;

pub(crate) use command::ticks;
pub use command::{Command, Value};
pub(crate) use lines::encode;
pub use lines::{Line, LineReader, MOST_LINE_BYTES};
pub use message::{
    ClientMessage, Configuration, Event, Hello, Problem, SafeForce, ServerMessage, read_client_message,
};
pub use outbox::{MOST_OUTBOX_BYTES, Outbox};
pub use rate::{BURST_LINES, LINES_PER_SECOND, Rate};
pub use scales::{FORCE_M_PER_N, LEAD_SCALE};
pub(crate) use state::seconds;
pub use state::{Dropped, FaultState, LedState, Memory, Pose, StateMessage};
pub use words::{COMMANDS, CommandWord, parse_command};

/// Version of the protocol. It rises when something that is there changes its meaning or goes away.
pub const PROTOCOL_VERSION: u32 = 1;
