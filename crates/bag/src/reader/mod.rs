//! Reading messages by the definitions of their types.

mod cells;
mod cursor;
mod parts;
mod pass;
mod plan;
mod points;
mod readers;

use soilctl_columns::Cell;
use soilctl_session::read::Channel;

use self::cursor::Cursor;
use self::plan::Plan;
pub use self::readers::Readers;
use crate::definition::{Definition, Ros};

/// How the messages of a channel are encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// CDR, as in ROS 2.
    Cdr,
    /// That of ROS 1: no alignment, no zero after text.
    Ros1,
}

/// What the messages of a topic tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Kind {
    /// Positions of named joints.
    Joints,
    /// A force and a torque.
    Wrench,
    /// Text.
    Text,
    /// A cloud of points.
    Points,
}

impl Kind {
    /// In one word: `joints`, `wrench`, `text` or `points`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Joints => "joints",
            Self::Wrench => "wrench",
            Self::Text => "text",
            Self::Points => "points",
        }
    }
}

impl std::fmt::Display for Kind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Joints => "joint states (a type with `string[] name` and `float64[] position`)",
            Self::Wrench => "wrenches (a type with `force` and `torque`)",
            Self::Text => "text (`std_msgs/String`)",
            Self::Points => {
                "points (a type with `fields`, `point_step` and `data`, as `sensor_msgs/PointCloud2`)"
            }
        })
    }
}

/// What a message says.
#[derive(Debug, Clone, PartialEq)]
pub enum Reading {
    /// Positions of joints.
    Joints {
        /// The stamp in ns, if it was set.
        stamp_ns: Option<i64>,
        /// Names of the joints.
        names: Vec<String>,
        /// As many positions, in rad or m.
        positions: Vec<f64>,
    },
    /// A wrench.
    Wrench {
        /// The stamp in ns, if it was set.
        stamp_ns: Option<i64>,
        /// The frame that the header names; empty if there is none.
        frame: String,
        /// Force in N and torque in N m.
        wrench: [f64; 6],
    },
    /// Text.
    Text(String),
    /// A cloud of points.
    Points {
        /// The stamp in ns, if it was set.
        stamp_ns: Option<i64>,
        /// The frame that the header names; empty if there is none.
        frame: String,
        /// Finite points `x, y, z`, in m.
        points: Vec<[f64; 3]>,
        /// How many points are left out because a coordinate is not finite.
        missing: usize,
    },
}

/// Reads the messages of a channel.
#[derive(Debug, Clone)]
pub struct Reader {
    definition: Definition,
    encoding: Encoding,
    reading: Option<(Kind, Plan)>,
    stamp: Option<Plan>,
}

impl Reader {
    /// For the messages of this channel.
    ///
    /// # Errors
    /// In words: an encoding that is not read, or a definition that is missing or malformed.
    pub fn of(channel: &Channel) -> Result<Self, String> {
        let message_type = &channel.message_type;
        let (encoding, ros) = match channel.message_encoding.as_str() {
            "cdr" => (Encoding::Cdr, Ros::Two),
            "ros1" => (Encoding::Ros1, Ros::One),
            other => {
                return Err(format!("messages encoded as `{other}` are not read, only `cdr` and `ros1`"));
            }
        };
        let text = match channel.schema_encoding.as_str() {
            "ros2msg" | "ros1msg" => std::str::from_utf8(&channel.schema)
                .map_err(|_| format!("the definition of {message_type} is not UTF-8 text"))?,
            // Nothing is said, or in a way that is not read: then it must be one of the common types.
            _ => "",
        };
        let definition = Definition::parse(ros, message_type, text).map_err(|problem| {
            match channel.schema_encoding.as_str() {
                "" | "ros2msg" | "ros1msg" => format!("{message_type} cannot be read: {problem}"),
                other => format!(
                    "{message_type} is defined in `{other}`, which is not read, only `ros2msg` and `ros1msg`"
                ),
            }
        })?;
        let reading = parts::reading(&definition);
        let stamp = parts::stamp(&definition);
        Ok(Self { definition, encoding, reading, stamp })
    }

    /// What the messages tell, if it is one of the kinds that are known by their fields.
    #[must_use]
    pub fn kind(&self) -> Option<Kind> {
        self.reading.as_ref().map(|(kind, _)| *kind)
    }

    /// The definition of the messages.
    #[must_use]
    pub const fn definition(&self) -> &Definition {
        &self.definition
    }

    /// What a message says; nothing if its type is of no kind.
    #[must_use]
    pub fn read(&self, data: &[u8]) -> Option<Result<Reading, String>> {
        let (kind, plan) = self.reading.as_ref()?;
        Some(plan.read(*kind, &self.definition, self.encoding, data))
    }

    /// Whether messages have a stamp, set or not.
    #[must_use]
    pub fn has_stamp(&self) -> bool {
        self.stamp.is_some()
    }

    /// The stamp of a message in ns: of its header, or its field `stamp`; nothing if it has none or was not set. What comes after it in
    /// the message is not looked at.
    ///
    /// # Errors
    /// In words, if the message is not of its type.
    pub fn stamp_ns(&self, data: &[u8]) -> Result<Option<i64>, String> {
        match &self.stamp {
            Some(plan) => plan.stamp_ns(&self.definition, self.encoding, data),
            None => Ok(None),
        }
    }

    /// A message as named cells, as in the tables of a log: arrays of fixed length have a cell an element, `name_0` and so on; lists
    /// are one cell of text, their elements parted by `; `. Times are in s, their names end with `_s`, and the stamp of the header is
    /// `stamp_s`. The lists of a joint state become `<joint>_position` and so on.
    ///
    /// # Errors
    /// In words, if the message is not of its type or has more cells than a table has columns.
    pub fn cells(&self, data: &[u8]) -> Result<Vec<(String, Cell<'static>)>, String> {
        cells::cells(&self.definition, Cursor::of(self.encoding, data)?, self.encoding == Encoding::Cdr)
    }
}
