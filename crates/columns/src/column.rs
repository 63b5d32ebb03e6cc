use std::borrow::Cow;
use std::fmt::Write as _;

use crate::{Cell, Kind, Range};

/// What a column is, whatever row it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct About {
    /// Name in the header.
    pub name: &'static str,
    /// Unit; `1` for numbers without one, `text` for text.
    pub unit: &'static str,
    /// The values that it takes.
    pub range: Range,
    /// What it means.
    pub meaning: &'static str,
    /// The commands that read it.
    pub readers: &'static [&'static str],
    /// Who knows it.
    pub source: Source,
    /// What its cells are.
    pub kind: Kind,
    /// Whether every row needs it.
    pub required: bool,
}

/// Who knows what a column says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Logs tell it, so that a program can fill it.
    Logs,
    /// Only a person can fill it.
    Hand,
}

/// A column of a row, with access to its cell.
#[derive(Debug)]
pub struct Column<R: 'static> {
    /// What it is.
    pub about: About,
    /// The cell in a row.
    pub get: fn(&R) -> Cell<'_>,
    /// Sets the cell in a row. A cell that its kind does not take leaves the row as it is.
    pub set: fn(&mut R, Cell<'_>),
}

/// A row that was declared by [`columns!`](crate::columns).
pub trait Columns: Sized + 'static {
    /// Its columns, in the order in which a new table has them.
    const COLUMNS: &'static [Column<Self>];

    /// The column of a name.
    #[must_use]
    fn column(name: &str) -> Option<&'static Column<Self>> {
        Self::COLUMNS.iter().find(|column| column.about.name == name)
    }
}

/// A type that a column may have in its row.
pub trait Field {
    /// The kind of its cells.
    const KIND: Kind;
    /// Whether every row has one.
    const REQUIRED: bool;

    /// As a cell.
    fn cell(&self) -> Cell<'_>;

    /// Takes the value of a cell over; stays what it is if the cell is of another kind.
    fn put(&mut self, cell: Cell<'_>);
}

impl Field for f64 {
    const KIND: Kind = Kind::Float;
    const REQUIRED: bool = true;

    fn cell(&self) -> Cell<'_> {
        Cell::Float(*self)
    }

    fn put(&mut self, cell: Cell<'_>) {
        *self = cell.number().unwrap_or(*self);
    }
}

impl Field for Option<f64> {
    const KIND: Kind = Kind::OptionalFloat;
    const REQUIRED: bool = false;

    fn cell(&self) -> Cell<'_> {
        self.map_or(Cell::Missing, Cell::Float)
    }

    fn put(&mut self, cell: Cell<'_>) {
        *self = cell.number();
    }
}

impl Field for Option<u32> {
    const KIND: Kind = Kind::OptionalWhole;
    const REQUIRED: bool = false;

    fn cell(&self) -> Cell<'_> {
        self.map_or(Cell::Missing, |value| Cell::Integer(value.into()))
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the range holds it")]
    fn put(&mut self, cell: Cell<'_>) {
        *self = cell.number().filter(|value| Range::Whole.holds(*value)).map(|value| value as u32);
    }
}

impl Field for String {
    const KIND: Kind = Kind::Text;
    const REQUIRED: bool = true;

    fn cell(&self) -> Cell<'_> {
        Cell::Text(Cow::Borrowed(self))
    }

    fn put(&mut self, cell: Cell<'_>) {
        if let Cell::Text(text) = cell {
            *self = text.into_owned();
        }
    }
}

impl Field for Option<String> {
    const KIND: Kind = Kind::Text;
    const REQUIRED: bool = false;

    fn cell(&self) -> Cell<'_> {
        self.as_deref().map_or(Cell::Missing, |text| Cell::Text(Cow::Borrowed(text)))
    }

    fn put(&mut self, cell: Cell<'_>) {
        *self = cell.text().map(str::to_owned);
    }
}

/// The columns of a row as a table in Markdown, for the documentation.
#[must_use]
pub fn markdown<R: Columns>() -> String {
    let mut text = String::from("| column | unit | allowed | meaning | read by |\n|---|---|---|---|---|\n");
    for Column { about, .. } in R::COLUMNS {
        let need = if about.required { "**required**, " } else { "" };
        // What is written to a String never fails.
        let _ = writeln!(
            text,
            "| `{}` | {} | {need}{} | {} | {} |",
            about.name,
            about.unit,
            about.range.words(about.unit),
            about.meaning,
            about.readers.join(", ")
        );
    }
    text
}
