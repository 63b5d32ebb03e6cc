//! Reading columns of a Parquet file that may be damaged.
//!
//! The parquet crate panics on some contradictions between a file's headers, and asks for as much memory as they
//! say. What it would trip over is checked here first: the footer before a column is opened, and each page header
//! between the crate's page reader and its decoder.

use parquet::basic::{Encoding, Type};
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
    match open(group, place, file_bytes)? {
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
    match open(group, place, file_bytes)? {
        ColumnReader::ByteArrayColumnReader(reader) => values(reader, rows),
        _ => Err(wrong_type(group, place, "binary")),
    }
}

fn wrong_type(group: &dyn RowGroupReader, place: usize, wanted: &str) -> ParquetError {
    let column = group.metadata().column(place);
    let (name, found) = (column.column_path().string(), column.column_type());
    ParquetError::General(format!("column {name} is of type {found}; it must be {wanted}"))
}

fn open(group: &dyn RowGroupReader, place: usize, file_bytes: u64) -> Result<ColumnReader> {
    let column = group.metadata().column(place);
    inside_file(column, file_bytes)?;
    let descriptor = column.column_descr_ptr();
    let pages = CheckedPages {
        pages: group.get_column_page_reader(place)?,
        text: descriptor.physical_type() == Type::BYTE_ARRAY,
        optional: descriptor.max_def_level() > 0,
        dictionary: false,
    };
    Ok(get_column_reader(descriptor, Box::new(pages)))
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
    /// Texts rather than doubles.
    text: bool,
    /// Whether levels before the values say which rows have one.
    optional: bool,
    /// Whether a dictionary was passed on.
    dictionary: bool,
}

impl CheckedPages {
    fn check(&mut self, page: &Page) -> Result<()> {
        let data = page.buffer();
        let values = match page {
            Page::DictionaryPage { .. } => {
                self.dictionary = true;
                return self.check_plain(data, page.num_values());
            }
            Page::DataPage { def_level_encoding, .. } if self.optional => {
                if *def_level_encoding != Encoding::RLE {
                    return Err(damaged("levels in an encoding that is not RLE"));
                }
                let (length, rest) =
                    data.split_first_chunk().ok_or_else(|| damaged("a page without levels"))?;
                self.check_levels(rest, u32::from_le_bytes(*length))?
            }
            Page::DataPage { .. } => data,
            Page::DataPageV2 { def_levels_byte_len, rep_levels_byte_len: 0, .. } => {
                self.check_levels(data, *def_levels_byte_len)?
            }
            Page::DataPageV2 { .. } => return Err(damaged("levels of repetition in a column without any")),
        };
        match (page.encoding(), values.split_first()) {
            (Encoding::PLAIN, _) => self.check_plain(values, page.num_values()),
            (Encoding::PLAIN_DICTIONARY | Encoding::RLE_DICTIONARY, Some((&width, indices))) => {
                if self.dictionary && width <= 32 && runs_are_readable(indices, width) {
                    return Ok(());
                }
                Err(damaged("values that refer to a dictionary which is not there"))
            }
            (other, _) => Err(ParquetError::General(format!(
                "values are in encoding {other}; write the file with encoding PLAIN or with dictionaries"
            ))),
        }
    }

    /// What follows the levels, which take the first `length` bytes.
    fn check_levels<'d>(&self, data: &'d [u8], length: u32) -> Result<&'d [u8]> {
        let split = data.split_at_checked(length as usize).filter(|_| self.optional || length == 0);
        let (levels, values) = split.ok_or_else(|| damaged("levels beyond the end of a page"))?;
        if runs_are_readable(levels, 1) { Ok(values) } else { Err(damaged("levels without an end")) }
    }

    /// Refuses values in plain encoding that do not fit into their bytes. A value in every row is asked for, so
    /// `count` does not stand for fewer.
    fn check_plain(&self, mut data: &[u8], count: u32) -> Result<()> {
        let too_short = || damaged(format!("{count} values do not fit into their page"));
        if !self.text {
            let fits = u64::from(count) * 8 <= data.len() as u64;
            return if fits { Ok(()) } else { Err(too_short()) };
        }
        for _ in 0..count {
            let (length, rest) = data.split_first_chunk().ok_or_else(too_short)?;
            data = rest.get(u32::from_le_bytes(*length) as usize..).ok_or_else(too_short)?;
        }
        Ok(())
    }
}

/// Whether every run of the RLE and bit-packing hybrid has a header of at most five bytes: the decoder does not
/// survive one of more than ten.
fn runs_are_readable(mut data: &[u8], width: u8) -> bool {
    while !data.is_empty() {
        let Some(end) = data.iter().take(5).position(|byte| byte & 0x80 == 0) else { return false };
        let header = data[..=end].iter().rev().fold(0_u64, |sum, byte| (sum << 7) | u64::from(byte & 0x7f));
        let bits = if header & 1 == 1 { (header >> 1) * 8 * u64::from(width) } else { u64::from(width) };
        let bytes = usize::try_from(bits.div_ceil(8)).unwrap_or(usize::MAX);
        // The last run may be cut where the values end.
        data = data[end + 1..].get(bytes..).unwrap_or_default();
    }
    true
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
