use std::fs::File;
use std::path::Path;

use parquet::errors::ParquetError;
use parquet::file::metadata::ParquetStatisticsPolicy;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::serialized_reader::ReadOptionsBuilder;
use parquet::schema::types::SchemaDescriptor;

use super::sidecar::{Sidecar, file_error};
use super::{COLUMNS, Cell, CellStatus, MAX_NODES, Placed, PredictionTable, parquet_pages};
use crate::EarthPressureError;

/// Reads a table and its sidecar. The columns may stand in any order and among others.
///
/// # Errors
/// [`EarthPressureError::File`] if a file is missing or malformed, [`EarthPressureError::BadTable`] if its content
/// is wrong or another version's, [`EarthPressureError::TooLarge`] if it has more than [`MAX_NODES`] rows.
pub fn read_parquet(path: &Path) -> Result<(PredictionTable, Sidecar), EarthPressureError> {
    let sidecar = Sidecar::read(path)?;
    let cells = read_cells(path)?;
    sidecar.check_count(path, cells.len())?;
    let whence = |i: usize| format!("{}, row {}", path.display(), i + 1);
    Ok((PredictionTable::from_cells(&sidecar.name, sidecar.quantity, &cells, whence)?, sidecar))
}

fn read_cells(path: &Path) -> Result<Vec<Placed>, EarthPressureError> {
    let malformed = |e: ParquetError| file_error(path, &e);
    let file = File::open(path).map_err(|e| file_error(path, &e))?;
    let file_bytes = file.metadata().map_err(|e| file_error(path, &e))?.len();
    // Statistics are not needed, and one thing less that may be damaged.
    let options = ReadOptionsBuilder::new()
        .with_column_stats_policy(ParquetStatisticsPolicy::SkipAll)
        .with_size_stats_policy(ParquetStatisticsPolicy::SkipAll)
        .build();
    let reader = SerializedFileReader::new_with_options(file, options).map_err(malformed)?;
    let places = places(reader.metadata().file_metadata().schema_descr())
        .map_err(|problem| EarthPressureError::BadTable { table: path.display().to_string(), problem })?;
    let mut cells = Vec::new();
    for i in 0..reader.num_row_groups() {
        let group = reader.get_row_group(i).map_err(malformed)?;
        let rows = usize::try_from(group.metadata().num_rows()).map_err(|e| file_error(path, &e))?;
        if rows > MAX_NODES - cells.len() {
            return Err(EarthPressureError::TooLarge {
                table: path.display().to_string(),
                size: format!("more than {MAX_NODES} rows"),
                limit: MAX_NODES,
            });
        }
        let number = |place| parquet_pages::numbers(&*group, place, rows, file_bytes).map_err(malformed);
        let [alpha, phi, delta, k_net, status] = places;
        let node = [number(alpha)?, number(phi)?, number(delta)?];
        let k_net = number(k_net)?;
        let words = parquet_pages::texts(&*group, status, rows, file_bytes).map_err(malformed)?;
        for (row, word) in words.iter().enumerate() {
            let status = CellStatus::parse(&String::from_utf8_lossy(word.data())).map_err(|problem| {
                let table = format!("{}, row {}", path.display(), cells.len() + 1);
                EarthPressureError::BadTable { table, problem }
            })?;
            cells.push(([0, 1, 2].map(|d: usize| node[d][row]), Cell { k_net: k_net[row], status }));
        }
    }
    Ok(cells)
}

/// Where each of [`COLUMNS`] stands.
fn places(schema: &SchemaDescriptor) -> Result<[usize; 5], String> {
    let mut places = [0; 5];
    for (place, column) in places.iter_mut().zip(COLUMNS) {
        let found = (0..schema.num_columns()).find(|&i| schema.column(i).path().string() == column);
        *place = found
            .filter(|&i| schema.column(i).max_rep_level() == 0)
            .ok_or_else(|| format!("column {column} is missing; there must be {}", COLUMNS.join(", ")))?;
    }
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ChenLiu;
    use crate::table::{Form, read_csv, write_table};

    #[test]
    fn both_formats_read_back_the_same_bits_and_notice_a_cut() {
        let axes = [vec![70.0, 85.0], vec![30.0, 37.5], vec![0.0, 15.0]];
        let table = PredictionTable::fill(&ChenLiu, axes).unwrap();
        let dir = tempfile::tempdir().unwrap();
        let (csv, parquet) = (dir.path().join("t.csv"), dir.path().join("t.parquet"));
        write_table(Form::Csv, &table, "Chen & Liu", &csv).unwrap();
        write_table(Form::Parquet, &table, "Chen & Liu", &parquet).unwrap();
        assert_eq!(read_csv(&csv).unwrap().0, table);
        assert_eq!(read_parquet(&parquet).unwrap().0, table);

        let text = std::fs::read_to_string(&csv).unwrap();
        let cut = text.lines().take(4).collect::<Vec<_>>().join("\n");
        std::fs::write(&csv, cut).unwrap();
        assert!(read_csv(&csv).unwrap_err().to_string().contains("sidecar says"));
    }
}
