//! Reading columns of a Parquet file that may be damaged.
//!
//! The parquet crate panics on some contradictions between a file's headers, and asks for as much memory as they
//! say. What it would trip over is checked here first: the footer before a column is opened, and each page header
//! between the crate's page reader and its decoder.

use parquet::basic::Encoding;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::RowGroupReader;

fn damaged(what: impl std::fmt::Display) -> ParquetError {
    ParquetError::General(format!("the file is damaged: {what}; write it again"))
}

/// Column of numbers at a place, `rows` long.
pub(super) fn numbers(
    group: &dyn RowGroupReader,
    place: usize,
    rows: usize,
    file_bytes: u64,
) -> Result<Vec<f64>> {
    match open(group, place, file_bytes, 8)? {
        ColumnReader::DoubleColumnReader(reader) => values(reader, rows),
        _ => Err(wrong_type(group, place, "double")),
    }
}

/// Column of texts at a place, `rows` long.
pub(super) fn texts(
    group: &dyn RowGroupReader,
    place: usize,
    rows: usize,
    file_bytes: u64,
) -> Result<Vec<ByteArray>> {
    match open(group, place, file_bytes, 4)? {
        ColumnReader::ByteArrayColumnReader(reader) => values(reader, rows),
        _ => Err(wrong_type(group, place, "binary")),
    }
}

fn wrong_type(group: &dyn RowGroupReader, place: usize, wanted: &str) -> ParquetError {
    let column = group.metadata().column(place);
    let (name, found) = (column.column_path().string(), column.column_type());
    ParquetError::General(format!("column {name} is of type {found}; it must be {wanted}"))
}

/// A reader of one column; `width` is the fewest bytes that a plain value takes.
fn open(group: &dyn RowGroupReader, place: usize, file_bytes: u64, width: u64) -> Result<ColumnReader> {
    let column = group.metadata().column(place);
    inside_file(column, file_bytes)?;
    let pages = CheckedPages { pages: group.get_column_page_reader(place)?, width, dictionary: false };
    Ok(get_column_reader(column.column_descr_ptr(), Box::new(pages)))
}

/// Refuses a column whose bytes are not all in the file.
fn inside_file(column: &ColumnChunkMetaData, file_bytes: u64) -> Result<()> {
    let start = column.dictionary_page_offset().unwrap_or(column.data_page_offset());
    let end = start.checked_add(column.compressed_size());
    let inside = start >= 0
        && column.compressed_size() >= 0
        && end.and_then(|end| u64::try_from(end).ok()).is_some_and(|end| end <= file_bytes);
    if inside {
        return Ok(());
    }
    let name = column.column_path().string();
    Err(damaged(format!(
        "column {name} should be {} bytes from byte {start} on, in a file of {file_bytes} bytes",
        column.compressed_size()
    )))
}

fn values<T: DataType>(mut reader: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<T::T>> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    let (_, found, _) = reader.read_records(rows, Some(&mut levels), None, &mut values)?;
    if found == rows && values.len() == rows {
        return Ok(values);
    }
    Err(ParquetError::General(format!("a column has {found} values in {rows} rows; every row must have one")))
}

/// Passes on the pages that the decoders can take.
struct CheckedPages {
    pages: Box<dyn PageReader>,
    width: u64,
    /// Whether a dictionary was passed on.
    dictionary: bool,
}

impl CheckedPages {
    fn check(&mut self, page: &Page) -> Result<()> {
        let bytes = page.buffer().len() as u64;
        match page {
            Page::DictionaryPage { num_values, .. } => {
                if u64::from(*num_values) * self.width > bytes {
                    return Err(damaged(format!("{num_values} values of a dictionary in {bytes} bytes")));
                }
                self.dictionary = true;
                return Ok(());
            }
            Page::DataPage { def_level_encoding, rep_level_encoding, .. } => {
                if [def_level_encoding, rep_level_encoding].iter().any(|&&e| e != Encoding::RLE) {
                    return Err(damaged("levels in an encoding that is not RLE"));
                }
            }
            Page::DataPageV2 { def_levels_byte_len, rep_levels_byte_len, .. } => {
                if u64::from(*def_levels_byte_len) + u64::from(*rep_levels_byte_len) > bytes {
                    return Err(damaged(format!("levels beyond the {bytes} bytes of a page")));
                }
            }
        }
        match page.encoding() {
            Encoding::PLAIN => {}
            Encoding::PLAIN_DICTIONARY | Encoding::RLE_DICTIONARY => {
                // Its first byte is the width of the indices, which the decoder does not check.
                let width = page.buffer().first().copied().unwrap_or(u8::MAX);
                if !self.dictionary || width > 32 {
                    return Err(damaged("values that refer to a dictionary which is not there"));
                }
            }
            other => {
                return Err(ParquetError::General(format!(
                    "values are in encoding {other}; write the file with encoding PLAIN or with dictionaries"
                )));
            }
        }
        Ok(())
    }
}

impl PageReader for CheckedPages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.pages.get_next_page()?;
        page.as_ref().map_or(Ok(()), |page| self.check(page))?;
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.pages.skip_next_page()
    }
}

impl Iterator for CheckedPages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}
