use std::borrow::Cow;

use soilctl_columns::{Cell, Column, Columns, Kind};

use crate::cell::CellPlace;
use crate::{ReadOptions, StrokeRow, StrokesError, TextColumn};

/// A column of a stroke table with its cells.
#[derive(Debug, Clone)]
pub(crate) enum Stored {
    /// Numbers; NaN where nothing was measured.
    Numbers(&'static Column<StrokeRow>, Vec<f64>),
    /// Text, of a column of [`StrokeRow`] or of one that means nothing here.
    Texts(Option<&'static Column<StrokeRow>>, TextColumn),
}

impl Stored {
    /// An empty column of this name.
    pub(crate) fn new(name: &str) -> Self {
        match StrokeRow::column(name) {
            Some(column) if column.about.kind != Kind::Text => Self::Numbers(column, Vec::new()),
            known => Self::Texts(known, TextColumn::new(name)),
        }
    }

    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Numbers(column, _) => column.about.name,
            Self::Texts(_, texts) => texts.name(),
        }
    }

    pub(crate) const fn kind(&self) -> Kind {
        match self {
            Self::Numbers(..) => Kind::OptionalFloat,
            Self::Texts(..) => Kind::Text,
        }
    }

    /// Reads a cell and adds it.
    pub(crate) fn read(
        &mut self,
        bytes: &[u8],
        file: &str,
        line: usize,
        options: ReadOptions,
    ) -> Result<(), StrokesError> {
        match self {
            Self::Numbers(column, values) => {
                let place = CellPlace { file, line, column: column.about.name };
                let value = place.number(bytes, &column.about, options.allow_zero_sd)?;
                values.push(value.unwrap_or(f64::NAN));
            }
            Self::Texts(_, texts) => {
                let text = CellPlace { file, line, column: texts.name() }.text(bytes)?;
                texts.push(text);
            }
        }
        Ok(())
    }

    /// Adds the cell of a row, if the column is one of [`StrokeRow`].
    pub(crate) fn push(&mut self, row: &StrokeRow) {
        match self {
            Self::Numbers(column, values) => values.push((column.get)(row).number().unwrap_or(f64::NAN)),
            Self::Texts(Some(column), texts) => texts.push((column.get)(row).text().unwrap_or_default()),
            Self::Texts(None, _) => {}
        }
    }

    /// The cell of a row, counted from 0.
    pub(crate) fn cell(&self, row: usize) -> Cell<'_> {
        match self {
            Self::Numbers(_, values) => {
                values.get(row).filter(|value| !value.is_nan()).map_or(Cell::Missing, |v| Cell::Float(*v))
            }
            Self::Texts(_, texts) => {
                let text = texts.cell(row).filter(|text| !text.is_empty());
                text.map_or(Cell::Missing, |text| Cell::Text(Cow::Borrowed(text)))
            }
        }
    }

    /// Takes the cell of a row, counted from 0, over into `stroke`; nothing happens if the column means nothing here.
    pub(crate) fn put(&self, row: usize, stroke: &mut StrokeRow) {
        if let Self::Numbers(column, _) | Self::Texts(Some(column), _) = self {
            (column.set)(stroke, self.cell(row));
        }
    }
}
