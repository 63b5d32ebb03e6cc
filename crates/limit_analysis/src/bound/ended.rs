//! Why runs end.

use std::fmt;

use schemars::JsonSchema;
use serde::Serialize;

/// Why a run ended. Unless it is [`Time`](Self::Time) or [`Stopped`](Self::Stopped), the same run ends in the same way, with
/// the same bits, whatever the load of the machine and the number of threads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Ended {
    /// The gap asked for is reached.
    Gap,
    /// The user's time is up, or the next level would not fit into it.
    Time,
    /// The next mesh would have too many elements.
    Elements,
    /// The next level would take more work than is left.
    Work,
    /// The next program may not fit into the memory allowed.
    Memory,
    /// The user asked.
    Stopped,
}

/// What kind of limit ended a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StoppedBy {
    /// The gap asked for is reached.
    Goal,
    /// The budget of elements or of work is spent, which does not depend on the machine.
    Work,
    /// The memory allowed is too small for the next mesh, which does not depend on the machine either.
    Memory,
    /// The user's limit on time: another run may end elsewhere.
    Seconds,
    /// The user, by Ctrl-C or a signal.
    User,
}

impl Ended {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Gap, Self::Time, Self::Elements, Self::Work, Self::Memory, Self::Stopped];

    /// The kind of limit.
    #[must_use]
    pub const fn stopped_by(self) -> StoppedBy {
        match self {
            Self::Gap => StoppedBy::Goal,
            Self::Elements | Self::Work => StoppedBy::Work,
            Self::Memory => StoppedBy::Memory,
            Self::Time => StoppedBy::Seconds,
            Self::Stopped => StoppedBy::User,
        }
    }

    /// In one word, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Gap => "gap",
            Self::Time => "time",
            Self::Elements => "elements",
            Self::Work => "work",
            Self::Memory => "memory",
            Self::Stopped => "stopped",
        }
    }
}

impl StoppedBy {
    /// In one word, as in JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Goal => "goal",
            Self::Work => "work",
            Self::Memory => "memory",
            Self::Seconds => "seconds",
            Self::User => "user",
        }
    }
}

/// In words that end a sentence on the run.
impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Gap => "ended by the gap asked for",
            Self::Time => "ended by the time allowed, so another run may end elsewhere",
            Self::Elements => "ended by the elements allowed",
            Self::Work => "ended by the work allowed",
            Self::Memory => "ended by the memory allowed",
            Self::Stopped => "ended by the user",
        })
    }
}
