use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::Table;
use crate::SessionError;
use crate::fields::Cell;

/// Rows that are held in memory before they are written.
const GROUP_ROWS: usize = 10_000;

/// A table as Parquet.
pub(super) struct ParquetTable {
    path: PathBuf,
    file: SerializedFileWriter<File>,
    columns: Vec<Column>,
    rows: usize,
}

/// The cells of one column that wait.
enum Column {
    Float(Vec<f64>),
    Integer(Vec<i64>),
    Flag(Vec<bool>),
    Text(Vec<ByteArray>),
}

impl Column {
    fn of(cell: &Cell) -> Self {
        match cell {
            Cell::Float(_) => Self::Float(Vec::new()),
            Cell::Integer(_) => Self::Integer(Vec::new()),
            Cell::Flag(_) => Self::Flag(Vec::new()),
            Cell::Text(_) => Self::Text(Vec::new()),
        }
    }

    fn field(&self, name: &str) -> Result<Type, ParquetError> {
        let (physical, logical) = match self {
            Self::Float(_) => (Physical::DOUBLE, None),
            Self::Integer(_) => (Physical::INT64, None),
            Self::Flag(_) => (Physical::BOOLEAN, None),
            Self::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::REQUIRED)
            .with_logical_type(logical)
            .build()
    }

    /// An integer beyond 63 bits, which only a broken counter has, keeps its bits and becomes negative.
    #[allow(clippy::cast_possible_truncation, reason = "as documented")]
    fn push(&mut self, cell: &Cell) {
        match (self, cell) {
            (Self::Float(cells), Cell::Float(value)) => cells.push(*value),
            (Self::Integer(cells), Cell::Integer(value)) => cells.push(*value as i64),
            (Self::Flag(cells), Cell::Flag(value)) => cells.push(*value),
            (Self::Text(cells), cell) => cells.push(ByteArray::from(cell.to_string().into_bytes())),
            // A field has one type in all messages.
            _ => {}
        }
    }
}

impl ParquetTable {
    pub(super) fn create(path: &Path, first: &[(String, Cell)]) -> Result<Self, SessionError> {
        let columns: Vec<Column> = first.iter().map(|(_, cell)| Column::of(cell)).collect();
        let file = File::create(path).map_err(|error| SessionError::file(path, &error))?;
        let open = || {
            let fields =
                first.iter().zip(&columns).map(|((name, _), column)| column.field(name).map(Arc::new));
            let fields = fields.collect::<Result<Vec<_>, _>>()?;
            let schema = Type::group_type_builder("log").with_fields(fields).build()?;
            let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
            SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
        };
        let file = open().map_err(|error| SessionError::file(path, &error))?;
        Ok(Self { path: path.to_owned(), file, columns, rows: 0 })
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        if self.rows == 0 {
            return Ok(());
        }
        self.rows = 0;
        let mut group = self.file.next_row_group()?;
        for column in &mut self.columns {
            let Some(mut writer) = group.next_column()? else { break };
            match column {
                Column::Float(cells) => {
                    writer.typed::<DoubleType>().write_batch(cells, None, None)?;
                    cells.clear();
                }
                Column::Integer(cells) => {
                    writer.typed::<Int64Type>().write_batch(cells, None, None)?;
                    cells.clear();
                }
                Column::Flag(cells) => {
                    writer.typed::<BoolType>().write_batch(cells, None, None)?;
                    cells.clear();
                }
                Column::Text(cells) => {
                    writer.typed::<ByteArrayType>().write_batch(cells, None, None)?;
                    cells.clear();
                }
            }
            writer.close()?;
        }
        group.close()?;
        Ok(())
    }
}

impl Table for ParquetTable {
    fn row(&mut self, row: &[(String, Cell)]) -> Result<(), SessionError> {
        for (column, (_, cell)) in self.columns.iter_mut().zip(row) {
            column.push(cell);
        }
        self.rows += 1;
        if self.rows < GROUP_ROWS {
            return Ok(());
        }
        self.write_group().map_err(|error| SessionError::file(&self.path, &error))
    }

    fn finish(mut self: Box<Self>) -> Result<(), SessionError> {
        let path = self.path.clone();
        let close = || {
            self.write_group()?;
            self.file.close()
        };
        close().map(|_| ()).map_err(|error| SessionError::file(&path, &error))
    }
}
