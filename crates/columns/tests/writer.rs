//! Tables as they are written: what reads back, and what is refused.
#![allow(clippy::unwrap_used)]

use std::fs::File;
use std::io::Write as _;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use proptest::prelude::*;
use soilctl_columns::{Cell, Columns, ColumnsError, Form, Kind, Range, TableWriter, columns, markdown};

columns! {
    /// A made row.
    #[derive(Debug, Default, Clone, PartialEq)]
    pub struct Made {
        /// Not in any file.
        pub line: usize,
    } columns {
        name: Option<String>, "text", Range::Text, "Name", [report], Logs;
        count: Option<u32>, "1", Range::Whole, "Count", [], Logs;
        depth_m: f64, "m", Range::Positive, "Depth", [report draw], Logs;
        slope: Option<f64>, "1", Range::Signed, "Slope", [], Hand;
    }
}

fn written(form: Form, rows: &[Made]) -> Vec<u8> {
    let columns = Made::COLUMNS.iter().map(|column| (column.about.name, column.about.kind));
    let mut table = TableWriter::new(form, Vec::new(), "made", columns).unwrap();
    for row in rows {
        table.row(Made::COLUMNS.iter().map(|column| (column.get)(row))).unwrap();
    }
    table.finish().unwrap()
}

fn parquet(rows: &[Made]) -> SerializedFileReader<File> {
    let mut file = tempfile::tempfile().unwrap();
    file.write_all(&written(Form::Parquet, rows)).unwrap();
    SerializedFileReader::new(file).unwrap()
}

fn rows() -> impl Strategy<Value = Vec<Made>> {
    let float = || any::<f64>().prop_filter("a number", |x| !x.is_nan());
    let row = ("(?s).{0,6}", proptest::option::of(any::<u32>()), float(), proptest::option::of(float()));
    let made = |(name, count, depth_m, slope)| Made { line: 0, name: Some(name), count, depth_m, slope };
    prop::collection::vec(row.prop_map(made), 1..20)
}

proptest! {
    #[test]
    fn csv_reads_back_to_the_same_bits(rows in rows()) {
        let bytes = written(Form::Csv, &rows);
        let mut reader = csv::Reader::from_reader(&bytes[..]);
        for (row, record) in rows.iter().zip(reader.records()) {
            let record = record.unwrap();
            let mut back = Made::default();
            for (column, text) in Made::COLUMNS.iter().zip(&record) {
                let cell = match column.about.kind {
                    Kind::Text => Cell::Text(text.into()),
                    _ => text.parse().map_or(Cell::Missing, Cell::Float),
                };
                (column.set)(&mut back, cell);
            }
            prop_assert_eq!(back.depth_m.to_bits(), row.depth_m.to_bits());
            prop_assert_eq!(back.slope.map(f64::to_bits), row.slope.map(f64::to_bits));
            prop_assert_eq!((back.name, back.count), (row.name.clone(), row.count));
        }
    }

    #[test]
    fn parquet_reads_back_to_the_same_bits(rows in rows()) {
        let reader = parquet(&rows);
        prop_assert_eq!(reader.metadata().file_metadata().num_rows(), rows.len() as i64);
        for (row, record) in rows.iter().zip(reader.get_row_iter(None).unwrap()) {
            let number = |value: Option<f64>| value.map_or(Field::Null, Field::Double);
            let fields: Vec<Field> = record.unwrap().get_column_iter().map(|(_, field)| field.clone()).collect();
            let expected = [
                Field::Str(row.name.clone().unwrap_or_default()),
                number(row.count.map(f64::from)),
                number(Some(row.depth_m)),
                number(row.slope),
            ];
            prop_assert_eq!(fields, expected);
        }
    }
}

#[test]
fn groups_of_a_long_table_hold_all_its_rows() {
    let rows: Vec<Made> =
        (0..25_000_u32).map(|i| Made { count: Some(i), depth_m: f64::from(i), ..Made::default() }).collect();
    let reader = parquet(&rows);
    assert_eq!((reader.num_row_groups(), reader.metadata().file_metadata().num_rows()), (3, 25_000));
}

#[test]
fn decimals_keep_their_point_and_other_numbers_do_not() {
    let columns = [("a", Kind::Decimal), ("b", Kind::Float), ("c", Kind::Integer), ("d", Kind::Flag)];
    let mut table = TableWriter::new(Form::Csv, Vec::new(), "t", columns).unwrap();
    table.row([Cell::Float(70.0), Cell::Float(70.0), Cell::Integer(-3), Cell::Flag(true)]).unwrap();
    assert_eq!(table.finish().unwrap(), b"a,b,c,d\n70.0,70,-3,true\n");
}

#[test]
fn rows_that_do_not_fit_are_refused_with_their_place() {
    for form in [Form::Csv, Form::Parquet] {
        let columns = [("a", Kind::Float), ("b", Kind::OptionalFloat)];
        let mut table = TableWriter::new(form, Vec::new(), "t", columns).unwrap();
        let short = table.row([Cell::Float(1.0)]).unwrap_err();
        assert!(matches!(short, ColumnsError::Width { row: 1, found: 1, expected: 2 }), "{short}");
        let missing = table.row([Cell::Missing, Cell::Missing]).unwrap_err().to_string();
        assert!(missing.contains("row 2, column 1"), "{missing}");
    }
}

#[test]
fn the_documentation_follows_from_the_table() {
    let text = markdown::<Made>();
    assert!(
        text.contains(
            "| `depth_m` | m | **required**, above 0 m (from 1e-9 to 1e9) | Depth | report, draw |"
        )
    );
    assert_eq!(text.lines().count(), 2 + Made::COLUMNS.len());
}
