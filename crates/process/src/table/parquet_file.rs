use std::io::Write;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use super::StrokeRecord;
use crate::ProcessError;

/// Rows of one group.
const GROUP_ROWS: usize = 10_000;

/// Writes the stroke table as Parquet: texts, then numbers, which are null where nothing was measured.
///
/// # Errors
/// [`ProcessError::Log`] if the writer fails.
pub fn write_parquet(strokes: &[StrokeRecord], output: impl Write + Send) -> Result<(), ProcessError> {
    write(strokes, output).map_err(|error| ProcessError::Log(format!("the stroke table: {error}")))
}

fn write(strokes: &[StrokeRecord], output: impl Write + Send) -> Result<(), ParquetError> {
    let pattern = StrokeRecord::default();
    let (texts, numbers) = (pattern.texts(), pattern.numbers());
    let field = |name: &str, physical, repetition, logical| {
        let built = Type::primitive_type_builder(name, physical);
        built.with_repetition(repetition).with_logical_type(logical).build().map(Arc::new)
    };
    let mut fields = Vec::new();
    for (name, _) in &texts {
        fields.push(field(name, Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String))?);
    }
    for (name, _) in &numbers {
        fields.push(field(name, Physical::DOUBLE, Repetition::OPTIONAL, None)?);
    }
    let schema = Type::group_type_builder("strokes").with_fields(fields).build()?;
    let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
    let mut file = SerializedFileWriter::new(output, Arc::new(schema), Arc::new(properties))?;
    for strokes in strokes.chunks(GROUP_ROWS) {
        let mut group = file.next_row_group()?;
        for column in 0..texts.len() {
            let Some(mut writer) = group.next_column()? else { break };
            let cells: Vec<ByteArray> =
                strokes.iter().map(|s| ByteArray::from(s.texts()[column].1)).collect();
            writer.typed::<ByteArrayType>().write_batch(&cells, None, None)?;
            writer.close()?;
        }
        for column in 0..numbers.len() {
            let Some(mut writer) = group.next_column()? else { break };
            let cells: Vec<Option<f64>> =
                strokes.iter().map(|s| s.numbers().get(column).and_then(|cell| cell.1)).collect();
            let levels: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
            let values: Vec<f64> = cells.into_iter().flatten().collect();
            writer.typed::<DoubleType>().write_batch(&values, Some(&levels), None)?;
            writer.close()?;
        }
        group.close()?;
    }
    file.close().map(|_| ())
}
