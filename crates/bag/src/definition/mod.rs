//! What a message type consists of, from the definitions that a recording carries.

mod known;
mod line;
mod resolve;
mod sections;

/// Which ROS a definition is of. They differ in `byte`, in `std_msgs/Header`, and in what a type without fields takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ros {
    /// ROS 1.
    One,
    /// ROS 2.
    Two,
}

/// A message type with all types inside it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Definition {
    /// The type itself comes first. None of them contains itself, and none has no fields, except the first.
    structures: Vec<Structure>,
}

/// One type: its fields in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Structure {
    /// Package and name, as `sensor_msgs/JointState`.
    pub name: String,
    /// The fields; constants are none.
    pub fields: Vec<Field>,
}

/// One field of a type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// What it holds.
    pub base: Base,
    /// How many of them.
    pub shape: Shape,
}

/// What a field holds, or each element of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Base {
    /// A flag of one byte.
    Bool,
    /// A signed byte.
    Int8,
    /// A byte.
    Uint8,
    /// Two bytes, signed.
    Int16,
    /// Two bytes.
    Uint16,
    /// Four bytes, signed.
    Int32,
    /// Four bytes.
    Uint32,
    /// Eight bytes, signed.
    Int64,
    /// Eight bytes.
    Uint64,
    /// A number of four bytes.
    Float32,
    /// A number of eight bytes.
    Float64,
    /// Text.
    Text,
    /// Seconds and nanoseconds since an origin.
    Time,
    /// Seconds and nanoseconds.
    Duration,
    /// Another type, by its number in the definition.
    Structure(usize),
}

/// How many values a field has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// One.
    One,
    /// Always so many, at least one.
    Fixed(usize),
    /// As many as the message says, at most so many.
    Bounded(usize),
    /// As many as the message says.
    List,
}

impl Definition {
    /// Parses a definition as it stands in a recording: that of the type, then, after lines of `=` with `MSG: package/Type`,
    /// those of the types inside it. What is not there, all of it or one of the types inside, is looked up among the common types
    /// of ROS.
    ///
    /// # Errors
    /// In words: a line that is none, a type that is not known, a ring of types, or more of anything than any message has.
    pub fn parse(ros: Ros, message_type: &str, text: &str) -> Result<Self, String> {
        resolve::resolve(ros, message_type, &sections::sections(text)?)
    }

    /// The type itself.
    #[must_use]
    pub fn root(&self) -> &Structure {
        // There is always a first one.
        self.structures.first().unwrap_or(&EMPTY)
    }

    /// A type inside it, by its number.
    #[must_use]
    pub fn structure(&self, number: usize) -> &Structure {
        self.structures.get(number).unwrap_or(&EMPTY)
    }

    /// How many types there are.
    pub(crate) fn count(&self) -> usize {
        self.structures.len()
    }
}

static EMPTY: Structure = Structure { name: String::new(), fields: Vec::new() };

impl Structure {
    /// The field of this name, with its place.
    pub(crate) fn field(&self, name: &str) -> Option<(usize, &Field)> {
        self.fields.iter().enumerate().find(|(_, field)| field.name == name)
    }
}

impl Base {
    /// Bytes of one value, where all values have the same number.
    pub(crate) const fn size(self) -> Option<usize> {
        match self {
            Self::Bool | Self::Int8 | Self::Uint8 => Some(1),
            Self::Int16 | Self::Uint16 => Some(2),
            Self::Int32 | Self::Uint32 | Self::Float32 => Some(4),
            Self::Int64 | Self::Uint64 | Self::Float64 => Some(8),
            Self::Text | Self::Time | Self::Duration | Self::Structure(_) => None,
        }
    }
}

/// `package/Type` of `package/msg/Type`, `package::msg::dds_::Type_` and the like; other names stay as they are.
#[must_use]
pub fn short_name(message_type: &str) -> String {
    let parts: Vec<&str> = message_type.split(['/', ':']).filter(|part| !part.is_empty()).collect();
    match parts.as_slice() {
        [package, .., "dds_", name] => format!("{package}/{}", name.strip_suffix('_').unwrap_or(name)),
        [package, .., name] => format!("{package}/{name}"),
        _ => message_type.to_owned(),
    }
}
