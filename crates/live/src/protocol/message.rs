use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_session::messages::EventMessage;

use super::{Command, StateMessage};

/// What a session says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum ServerMessage {
    /// The first message.
    Hello(Hello),
    /// A command was carried out, or begun.
    Ack {
        /// Id of the command.
        id: u64,
        /// The tick in which it took effect.
        tick: u64,
    },
    /// A command was not carried out, or a line not understood. Nothing was changed.
    Error {
        /// Id of the command; null if there is none.
        id: Option<u64>,
        /// The kind of problem.
        problem: Problem,
        /// What is wrong and what to do.
        message: String,
    },
    /// Something happened.
    Event(Event),
    /// How things are.
    State(Box<StateMessage>),
    /// What the session runs with, for who asked.
    Configuration(Box<Configuration>),
    /// The last message: the session is over.
    End {
        /// Why.
        reason: String,
    },
}

/// What a client says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum ClientMessage {
    /// Which protocol the client speaks; may be left out. With another version the session says so and hangs up.
    Hello {
        /// Version of the protocol.
        protocol: u32,
    },
    /// Asks what the session runs with; the answer is a [`Configuration`].
    Describe {},
    /// Asks for something.
    Command {
        /// Comes back in the answer; any number.
        id: u64,
        /// What.
        command: Command,
    },
}

/// The first message of a session.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hello {
    /// Version of the protocol.
    pub protocol: u32,
    /// Version of the program.
    pub program: String,
    /// Whether the session runs in real time.
    pub real_time: bool,
    /// Whether the arm is simulated by this session.
    pub simulated: bool,
    /// Length of a tick in s.
    pub tick_s: f64,
    /// Strokes in the plan.
    pub strokes: usize,
    /// Forces that the soil bears without failing; empty if they are not known.
    pub safe_force: SafeForce,
}

/// What a session runs with: the texts that its log begins with.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Configuration {
    /// The arm file as TOML.
    pub arm: String,
    /// The controller's settings as TOML.
    pub controller: String,
    /// The plan as TOML; empty for none.
    pub plan: String,
    /// Name of the force model of the simulated soil, or of the hardware.
    pub model: String,
}

/// Largest force that the soil bears without failing, against the angle between force and plate normal.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SafeForce {
    /// The angles in degrees, rising.
    pub angle_deg: Vec<f64>,
    /// The forces in N.
    pub force_n: Vec<f64>,
}

/// Kind of a problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Problem {
    /// The line is no message of this protocol.
    Malformed,
    /// The line is too long.
    TooLong,
    /// There were too many lines.
    TooFast,
    /// A name or number of the command is not allowed.
    Value,
    /// The controller refused.
    Refused,
    /// The session cannot do this, or not now.
    Unavailable,
    /// The client speaks another protocol.
    Protocol,
    /// The client may not do this.
    Forbidden,
}

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Event {
    /// The tick.
    pub tick: u64,
    /// Its time in s.
    pub time_s: f64,
    /// What happened, for example `fault/tip_force`.
    pub kind: String,
    /// Joint, motor, channel, step or stroke; 0 if none.
    pub index: u16,
    /// The number behind it, in the units of the controller's events.
    pub value: f64,
    /// Its limit, or 0.
    pub limit: f64,
}

impl Event {
    /// An event of the controller in a tick.
    #[must_use]
    pub fn new(tick: u64, event: &EventMessage) -> Self {
        let EventMessage { kind, index, value, limit } = event.clone();
        Self { tick, time_s: super::state::seconds(tick), kind, index, value, limit }
    }
}

/// The message in a client's line.
///
/// # Errors
/// The id, if one can be made out, the kind of problem, and what is wrong in words.
pub fn read_client_message(line: &str) -> Result<ClientMessage, (Option<u64>, Problem, String)> {
    serde_json::from_str(line).map_err(|error| {
        let id = serde_json::from_str::<serde_json::Value>(line).ok().and_then(|value| value["id"].as_u64());
        (id, Problem::Malformed, format!("this is no message of the protocol: {error}"))
    })
}
