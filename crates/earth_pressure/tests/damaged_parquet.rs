//! Parquet files of other writers, whole and damaged. A damaged file may read as another good one (a flipped bit in
//! a number), but it never ends the program.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, Encoding};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::file::properties::{WriterProperties, WriterVersion};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::parser::parse_message_type;
use soilctl_earth_pressure::ChenLiu;
use soilctl_earth_pressure::table::{Cell, Form, PredictionTable, read_parquet, write_table};

fn table() -> PredictionTable {
    let axes = [vec![70.0, 85.0, 90.0], vec![30.0, 37.5], vec![0.0, 15.0, 20.0]];
    PredictionTable::fill(&ChenLiu, axes).unwrap()
}

/// The table as another program may write it: columns in another order, in small pages.
fn foreign(optional: bool, dictionary: bool, version: WriterVersion, compression: Compression) -> Vec<u8> {
    let is = if optional { "optional" } else { "required" };
    let schema = format!(
        "message t {{ {is} binary status (UTF8); {is} double k_net; {is} double delta_deg; {is} double phi_deg;
         required int32 remark; {is} double alpha_deg; }}"
    );
    let properties = WriterProperties::builder()
        .set_compression(compression)
        .set_dictionary_enabled(dictionary)
        .set_writer_version(version)
        .set_encoding(Encoding::PLAIN)
        .set_data_page_row_count_limit(6)
        .set_write_batch_size(3);
    let mut bytes = Vec::new();
    let schema = Arc::new(parse_message_type(&schema).unwrap());
    let mut file = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties.build())).unwrap();
    let mut group = file.next_row_group().unwrap();
    let table = table();
    let rows: Vec<_> = table.filled().collect();
    let levels = vec![1; rows.len()];
    let levels = optional.then_some(&levels[..]);
    for i in 0..6 {
        let mut column = group.next_column().unwrap().unwrap();
        match i {
            0 => {
                let words: Vec<_> = rows.iter().map(|(_, c)| ByteArray::from(c.status.word())).collect();
                column.typed::<ByteArrayType>().write_batch(&words, levels, None).unwrap();
            }
            4 => {
                let remarks = vec![7; rows.len()];
                column.typed::<Int32Type>().write_batch(&remarks, None, None).unwrap();
            }
            _ => {
                let number = |(n, c): &([f64; 3], Cell)| [n[0], 0.0, n[1], n[2], c.k_net][5 - i];
                let numbers: Vec<f64> = rows.iter().map(number).collect();
                column.typed::<DoubleType>().write_batch(&numbers, levels, None).unwrap();
            }
        }
        column.close().unwrap();
    }
    group.close().unwrap();
    file.close().unwrap();
    bytes
}

/// Steele, Lea & Flood's SplitMix64.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % limit as u64) as usize
    }
}

/// Reads the file with one byte changed, at a number of seeded places one after the other; counts the errors.
fn refused(path: &Path, good: &[u8], places: usize) -> usize {
    let mut random = Random(20_010_607);
    (0..places)
        .filter(|_| {
            let mut bytes = good.to_vec();
            bytes[random.below(good.len())] ^= 1 + random.below(255) as u8;
            std::fs::write(path, &bytes).unwrap();
            read_parquet(path).is_err()
        })
        .count()
}

#[test]
fn one_wrong_byte_is_never_a_panic() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.parquet");
    write_table(Form::Parquet, &table(), "Chen & Liu", &path).unwrap();
    let refused = refused(&path, &std::fs::read(&path).unwrap(), 300);
    assert!(refused > 100, "{refused} of 300 damaged files were noticed");
}

#[test]
fn files_of_other_writers_are_read_and_their_damage_is_never_a_panic() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.parquet");
    write_table(Form::Parquet, &table(), "Chen & Liu", &path).unwrap();
    for optional in [false, true] {
        for dictionary in [false, true] {
            for version in [WriterVersion::PARQUET_1_0, WriterVersion::PARQUET_2_0] {
                for compression in [Compression::UNCOMPRESSED, Compression::SNAPPY] {
                    let good = foreign(optional, dictionary, version, compression);
                    std::fs::write(&path, &good).unwrap();
                    let read = read_parquet(&path).unwrap().0;
                    assert!(read.filled().eq(table().filled()), "{optional} {dictionary} {version:?}");
                    assert!(refused(&path, &good, 100) > 30);
                }
            }
        }
    }
}

#[test]
fn a_cut_or_alien_file_is_an_error() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.parquet");
    write_table(Form::Parquet, &table(), "Chen & Liu", &path).unwrap();
    let good = std::fs::read(&path).unwrap();
    for length in 0..good.len() {
        std::fs::write(&path, &good[..length]).unwrap();
        assert!(read_parquet(&path).is_err(), "{length}");
    }
    std::fs::write(&path, b"alpha_deg,phi_deg,delta_deg,k_net,status\n").unwrap();
    assert!(read_parquet(&path).unwrap_err().to_string().contains("t.parquet"));
}
