use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::RowAccessor;
use parquet::schema::parser::parse_message_type;

use super::sidecar::{Sidecar, file_error};
use super::{Cell, CellStatus, PredictionTable};
use crate::EarthPressureError;

const SCHEMA: &str = "message prediction_table {
    required double alpha_deg; required double phi_deg; required double delta_deg;
    required double k_net; required binary status (UTF8);
}";

/// Writes a table as Parquet (the columns of the CSV form, Snappy) with its sidecar.
///
/// # Errors
/// [`EarthPressureError::File`] if a file cannot be written.
pub fn write_parquet(table: &PredictionTable, source: &str, path: &Path) -> Result<(), EarthPressureError> {
    write_columns(table, path).map_err(|e| file_error(path, &e))?;
    Sidecar::of(table, source).write(path)
}

fn write_columns(table: &PredictionTable, path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let schema = Arc::new(parse_message_type(SCHEMA)?);
    let properties = Arc::new(WriterProperties::builder().set_compression(Compression::SNAPPY).build());
    let mut file = SerializedFileWriter::new(File::create(path)?, schema, properties)?;
    let mut group = file.next_row_group()?;
    let rows: Vec<_> = table.filled().collect();
    let numbers: [Vec<f64>; 4] = [
        rows.iter().map(|(n, _)| n[0]).collect(),
        rows.iter().map(|(n, _)| n[1]).collect(),
        rows.iter().map(|(n, _)| n[2]).collect(),
        rows.iter().map(|(_, c)| c.k_net).collect(),
    ];
    for column in &numbers {
        let mut writer = group.next_column()?.ok_or("the schema has five columns")?;
        writer.typed::<DoubleType>().write_batch(column, None, None)?;
        writer.close()?;
    }
    let words: Vec<ByteArray> = rows.iter().map(|(_, c)| ByteArray::from(c.status.word())).collect();
    let mut writer = group.next_column()?.ok_or("the schema has five columns")?;
    writer.typed::<ByteArrayType>().write_batch(&words, None, None)?;
    writer.close()?;
    group.close()?;
    file.close()?;
    Ok(())
}

/// Reads a table and its sidecar.
///
/// # Errors
/// [`EarthPressureError::File`] if a file is missing or malformed, [`EarthPressureError::BadTable`] if its content
/// is wrong or another version's.
pub fn read_parquet(path: &Path) -> Result<(PredictionTable, Sidecar), EarthPressureError> {
    let sidecar = Sidecar::read(path)?;
    let cells = read_cells(path).map_err(|e| file_error(path, &e))?;
    sidecar.check_count(path, cells.len())?;
    Ok((PredictionTable::from_cells(&sidecar.name, sidecar.quantity, &cells)?, sidecar))
}

fn read_cells(path: &Path) -> Result<Vec<([f64; 3], Cell)>, Box<dyn std::error::Error>> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let mut cells = Vec::new();
    for row in reader.get_row_iter(Some(parse_message_type(SCHEMA)?))? {
        let row = row?;
        let number = |i: usize| row.get_double(i);
        let word = row.get_string(4)?;
        let status = CellStatus::from_word(word)
            .ok_or_else(|| format!("status is {word:?}; it must be \"solved\" or \"interpolated\""))?;
        cells.push(([number(0)?, number(1)?, number(2)?], Cell { k_net: number(3)?, status }));
    }
    Ok(cells)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ChenLiu;
    use crate::table::{read_csv, write_csv};

    #[test]
    fn both_formats_read_back_the_same_bits_and_notice_a_cut() {
        let axes = [vec![70.0, 85.0], vec![30.0, 37.5], vec![0.0, 15.0]];
        let table = PredictionTable::fill(&ChenLiu, axes).unwrap();
        let dir = tempfile::tempdir().unwrap();
        let (csv, parquet) = (dir.path().join("t.csv"), dir.path().join("t.parquet"));
        write_csv(&table, "Chen & Liu", &csv).unwrap();
        write_parquet(&table, "Chen & Liu", &parquet).unwrap();
        assert_eq!(read_csv(&csv).unwrap().0, table);
        assert_eq!(read_parquet(&parquet).unwrap().0, table);

        let text = std::fs::read_to_string(&csv).unwrap();
        let cut = text.lines().take(4).collect::<Vec<_>>().join("\n");
        std::fs::write(&csv, cut).unwrap();
        assert!(read_csv(&csv).unwrap_err().to_string().contains("sidecar says"));
    }
}
