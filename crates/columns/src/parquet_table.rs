use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;

use crate::{Cell, Kind};

/// Rows that are held in memory before they are written, as one group.
const GROUP_ROWS: usize = 10_000;

/// A table as Parquet.
pub(crate) struct ParquetTable<W: Write + Send> {
    file: SerializedFileWriter<W>,
    columns: Vec<Waiting>,
    rows: usize,
}

/// The cells of one column that wait.
enum Waiting {
    Float(Vec<f64>),
    /// What is there, and for each row 1 if it is.
    Optional(Vec<f64>, Vec<i16>),
    Integer(Vec<i64>),
    Flag(Vec<bool>),
    Text(Vec<ByteArray>),
}

impl Waiting {
    const fn new(kind: Kind) -> Self {
        match kind {
            Kind::Float | Kind::Decimal => Self::Float(Vec::new()),
            Kind::OptionalFloat | Kind::OptionalWhole => Self::Optional(Vec::new(), Vec::new()),
            Kind::Integer => Self::Integer(Vec::new()),
            Kind::Flag => Self::Flag(Vec::new()),
            Kind::Text => Self::Text(Vec::new()),
        }
    }

    fn field(&self, name: &str) -> Result<Type, ParquetError> {
        let (physical, repetition, logical) = match self {
            Self::Float(_) => (Physical::DOUBLE, Repetition::REQUIRED, None),
            Self::Optional(..) => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Self::Integer(_) => (Physical::INT64, Repetition::REQUIRED, None),
            Self::Flag(_) => (Physical::BOOLEAN, Repetition::REQUIRED, None),
            Self::Text(_) => (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String)),
        };
        Type::primitive_type_builder(name, physical)
            .with_repetition(repetition)
            .with_logical_type(logical)
            .build()
    }

    /// Takes a cell of its kind.
    #[allow(clippy::cast_possible_truncation, reason = "as `Kind::Integer` says")]
    fn push(&mut self, cell: &Cell<'_>) {
        match self {
            Self::Float(cells) => cells.extend(cell.number()),
            Self::Optional(cells, levels) => {
                cells.extend(cell.number());
                levels.push(i16::from(cell.number().is_some()));
            }
            Self::Integer(cells) => cells.extend(cell.integer().map(|value| value as i64)),
            Self::Flag(cells) => cells.extend(cell.flag()),
            Self::Text(cells) => cells.push(ByteArray::from(cell.text().unwrap_or_default())),
        }
    }

    fn write<W: Write + Send>(
        &mut self,
        group: &mut SerializedRowGroupWriter<'_, W>,
    ) -> Result<(), ParquetError> {
        match self {
            Self::Float(cells) => write::<DoubleType, W>(group, cells, None),
            Self::Optional(cells, levels) => write::<DoubleType, W>(group, cells, Some(levels)),
            Self::Integer(cells) => write::<Int64Type, W>(group, cells, None),
            Self::Flag(cells) => write::<BoolType, W>(group, cells, None),
            Self::Text(cells) => write::<ByteArrayType, W>(group, cells, None),
        }
    }
}

fn write<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    cells: &mut Vec<T::T>,
    levels: Option<&mut Vec<i16>>,
) -> Result<(), ParquetError> {
    // The schema has as many columns as there are cells in a row.
    let Some(mut writer) = group.next_column()? else { return Ok(()) };
    writer.typed::<T>().write_batch(cells, levels.as_ref().map(|levels| levels.as_slice()), None)?;
    cells.clear();
    if let Some(levels) = levels {
        levels.clear();
    }
    writer.close()
}

impl<W: Write + Send> ParquetTable<W> {
    pub(crate) fn new<'n>(
        output: W,
        name: &str,
        columns: impl Iterator<Item = (&'n str, &'n Kind)>,
    ) -> Result<Self, ParquetError> {
        let (mut fields, mut waiting) = (Vec::new(), Vec::new());
        for (name, kind) in columns {
            let column = Waiting::new(*kind);
            fields.push(Arc::new(column.field(name)?));
            waiting.push(column);
        }
        let schema = Type::group_type_builder(name).with_fields(fields).build()?;
        let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
        let file = SerializedFileWriter::new(output, Arc::new(schema), Arc::new(properties))?;
        Ok(Self { file, columns: waiting, rows: 0 })
    }

    /// Takes the cell of a column, which is of its kind.
    pub(crate) fn push(&mut self, column: usize, cell: &Cell<'_>) {
        if let Some(column) = self.columns.get_mut(column) {
            column.push(cell);
        }
    }

    /// Ends a row of which every cell was taken.
    pub(crate) fn end_row(&mut self) -> Result<(), ParquetError> {
        self.rows += 1;
        if self.rows < GROUP_ROWS { Ok(()) } else { self.write_group() }
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        if self.rows == 0 {
            return Ok(());
        }
        self.rows = 0;
        let mut group = self.file.next_row_group()?;
        for column in &mut self.columns {
            column.write(&mut group)?;
        }
        group.close().map(|_| ())
    }

    pub(crate) fn finish(mut self) -> Result<W, ParquetError> {
        self.write_group()?;
        self.file.into_inner()
    }
}
