use std::borrow::Cow;

use serde::{Serialize, Serializer};

/// One cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell<'a> {
    /// Nothing was measured.
    Missing,
    /// A number, bit for bit.
    Float(f64),
    /// A whole number.
    Integer(i128),
    /// A flag.
    Flag(bool),
    /// Text.
    Text(Cow<'a, str>),
}

/// What the cells of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A number in every row.
    Float,
    /// The same, written with a decimal point or an exponent in CSV also if it is whole.
    Decimal,
    /// A number that may be missing.
    OptionalFloat,
    /// A whole number that may be missing; a double in Parquet, as the other numbers.
    OptionalWhole,
    /// A whole number in every row. One beyond 63 bits keeps its lowest 64 bits in Parquet.
    Integer,
    /// A flag in every row.
    Flag,
    /// Text; what is missing is empty.
    Text,
}

impl Kind {
    /// Whether a column of this kind has such cells.
    #[must_use]
    pub const fn takes(self, cell: &Cell<'_>) -> bool {
        match self {
            Self::Float | Self::Decimal => matches!(cell, Cell::Float(_)),
            Self::OptionalFloat => matches!(cell, Cell::Float(_) | Cell::Missing),
            Self::OptionalWhole => matches!(cell, Cell::Integer(_) | Cell::Missing),
            Self::Integer => matches!(cell, Cell::Integer(_)),
            Self::Flag => matches!(cell, Cell::Flag(_)),
            Self::Text => matches!(cell, Cell::Text(_) | Cell::Missing),
        }
    }
}

impl Cell<'_> {
    /// Whether both are the same bit for bit.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Float(a), Self::Float(b)) => a.to_bits() == b.to_bits(),
            _ => self == other,
        }
    }

    /// The kind of column that has such a cell in every row; text if nothing is there.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Float(_) => Kind::Float,
            Self::Integer(_) => Kind::Integer,
            Self::Flag(_) => Kind::Flag,
            Self::Missing | Self::Text(_) => Kind::Text,
        }
    }

    /// The value of a number.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "whole numbers of tables are counts, far below 2^53")]
    pub const fn number(&self) -> Option<f64> {
        match self {
            Self::Float(value) => Some(*value),
            Self::Integer(value) => Some(*value as f64),
            Self::Missing | Self::Flag(_) | Self::Text(_) => None,
        }
    }

    /// The value of a whole number.
    #[must_use]
    pub const fn integer(&self) -> Option<i128> {
        if let Self::Integer(value) = self { Some(*value) } else { None }
    }

    /// The value of a flag.
    #[must_use]
    pub const fn flag(&self) -> Option<bool> {
        if let Self::Flag(value) = self { Some(*value) } else { None }
    }

    /// The text of a text.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }
}

/// As in CSV: the shortest digits that read back to the same bits, and nothing where nothing was measured.
impl std::fmt::Display for Cell<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Missing => Ok(()),
            Self::Float(value) => write!(f, "{value}"),
            Self::Integer(value) => write!(f, "{value}"),
            Self::Flag(value) => write!(f, "{value}"),
            Self::Text(text) => f.write_str(text),
        }
    }
}

/// As in JSON: `null` where nothing was measured.
impl Serialize for Cell<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Missing => serializer.serialize_none(),
            Self::Float(value) => serializer.serialize_f64(*value),
            Self::Integer(value) => match i64::try_from(*value) {
                Ok(value) => serializer.serialize_i64(value),
                Err(_) => serializer.serialize_i128(*value),
            },
            Self::Flag(value) => serializer.serialize_bool(*value),
            Self::Text(text) => serializer.serialize_str(text),
        }
    }
}
