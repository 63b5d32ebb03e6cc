//! Table files that are wrong: every one is an error that says where and what, and none ends the program.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::PathBuf;

use soilctl_earth_pressure::table::{
    Cell, CellStatus, Form, MAX_NODES, PredictionTable, Quantity, read_csv, read_parquet, write_table,
};
use soilctl_earth_pressure::{ChenLiu, EarthPressureError};
use tempfile::TempDir;

fn table() -> PredictionTable {
    let axes = [vec![70.0, 85.0], vec![30.0, 37.5], vec![0.0, 15.0]];
    PredictionTable::fill(&ChenLiu, axes).unwrap()
}

/// A good table as CSV: lines of text, to be spoilt.
struct Csv {
    _dir: TempDir,
    path: PathBuf,
    lines: Vec<String>,
}

impl Csv {
    fn new() -> Self {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("t.csv");
        write_table(Form::Csv, &table(), "Chen & Liu", &path).unwrap();
        let lines = std::fs::read_to_string(&path).unwrap().lines().map(str::to_owned).collect();
        Self { _dir: dir, path, lines }
    }

    /// Replaces a cell of a line, counted from 1 as editors do.
    fn with(mut self, line: usize, column: usize, text: &str) -> Self {
        let mut fields: Vec<&str> = self.lines[line - 1].split(',').collect();
        fields[column] = text;
        self.lines[line - 1] = fields.join(",");
        self
    }

    fn error(self) -> String {
        let text = self.lines.join("\n");
        self.error_of(text.as_bytes())
    }

    fn error_of(self, bytes: &[u8]) -> String {
        std::fs::write(&self.path, bytes).unwrap();
        read_csv(&self.path).unwrap_err().to_string()
    }
}

#[track_caller]
fn says(error: &str, parts: &[&str]) {
    for part in parts {
        assert!(error.contains(part), "no {part:?} in {error:?}");
    }
}

#[test]
fn bad_cells_are_named_with_their_line() {
    says(&Csv::new().with(4, 3, "NaN").error(), &["t.csv, line 4", "k_net is NaN", "above 0"]);
    says(&Csv::new().with(4, 3, "-2.5").error(), &["line 4", "k_net is -2.5"]);
    says(&Csv::new().with(5, 0, "NaN").error(), &["line 5", "alpha_deg is NaN", "finite"]);
    says(&Csv::new().with(6, 2, "inf").error(), &["line 6", "delta_deg is inf", "finite"]);
    says(&Csv::new().with(3, 1, "3o").error(), &["line 3", "phi_deg is \"3o\"", "a number"]);
    says(&Csv::new().with(2, 1, "").error(), &["line 2", "phi_deg is missing"]);
    says(&Csv::new().with(2, 4, "guessed").error(), &["line 2", "guessed", "\"solved\" or"]);
}

#[test]
fn blank_and_quoted_lines_do_not_shift_the_count() {
    let mut csv = Csv::new().with(4, 3, "NaN");
    csv.lines.insert(2, String::new());
    csv.lines[1] = csv.lines[1].replace("solved", "\"solved\"");
    says(&csv.error(), &["line 5", "NaN"]);
}

#[test]
fn bad_columns_are_named() {
    says(&Csv::new().with(1, 3, "k").error(), &["line 1", "column k_net is missing", "alpha_deg, phi_deg"]);
    says(&Csv::new().with(1, 1, "alpha_deg").error(), &["line 1", "column alpha_deg is given twice"]);
    says(&Csv::new().error_of(b""), &["line 1", "column alpha_deg is missing"]);
    let mut csv = Csv::new();
    csv.lines[4] = "70.0,30.0".into();
    says(&csv.error(), &["line 5", "delta_deg is missing"]);
}

#[test]
fn a_node_given_twice_names_both_lines() {
    let mut csv = Csv::new();
    csv.lines[6] = csv.lines[2].clone();
    says(&csv.error(), &["t.csv, line 7", "given twice", "first in", "t.csv, line 3", "alpha 70 deg"]);
}

#[test]
fn text_that_is_not_utf8_is_named_with_its_line() {
    for line in [0, 3] {
        let csv = Csv::new();
        let mut text = csv.lines.clone();
        text[line].push_str(",@");
        let bytes: Vec<u8> = text.join("\n").bytes().map(|b| if b == b'@' { 0xe9 } else { b }).collect();
        says(&csv.error_of(&bytes), &[&format!("line {}", line + 1), "not UTF-8"]);
    }
}

#[test]
fn columns_in_another_order_and_a_byte_order_mark_are_read() {
    let csv = Csv::new();
    let turned = csv.lines.iter().map(|line| {
        let mut fields: Vec<&str> = line.split(',').collect();
        fields.reverse();
        format!("{}, note", fields.join(", "))
    });
    let text = format!("\u{feff}{}", turned.collect::<Vec<_>>().join("\r\n"));
    std::fs::write(&csv.path, text).unwrap();
    assert_eq!(read_csv(&csv.path).unwrap().0, table());
}

#[test]
fn too_many_nodes_are_refused_before_memory_is_asked_for() {
    let axis = |n: u32| (0..n).map(|i| 1e-4 * f64::from(i)).collect::<Vec<_>>();
    // 1e15 nodes: 24 PB if they were asked for.
    let error = PredictionTable::new("t", Quantity::Estimate, [axis(100_000), axis(100_000), axis(100_000)])
        .unwrap_err();
    assert!(matches!(error, EarthPressureError::TooLarge { limit: MAX_NODES, .. }));
    says(&error.to_string(), &["100000 x 100000 x 100000", "4000000", "larger steps"]);
    assert!(PredictionTable::new("t", Quantity::Estimate, [axis(200), axis(200), axis(100)]).is_ok());
    assert!(PredictionTable::new("t", Quantity::Estimate, [axis(200), axis(200), axis(101)]).is_err());
}

#[test]
fn scattered_angles_in_a_file_are_too_many_nodes_too() {
    let csv = Csv::new();
    let rows = (0..400).map(|i| format!("{0},{0},{0},1.0,solved", 20.0 + 0.1 * f64::from(i)));
    let text: Vec<String> = csv.lines[..1].iter().cloned().chain(rows).collect();
    let sidecar = csv.path.with_extension("csv.json");
    let json = std::fs::read_to_string(&sidecar).unwrap();
    std::fs::write(&sidecar, json.replace("\"cells\": 8", "\"cells\": 400")).unwrap();
    says(&csv.error_of(text.join("\n").as_bytes()), &["400 x 400 x 400 nodes", "at most 4000000"]);
}

#[test]
fn bad_axes_are_named_without_being_printed() {
    let new = |axis: Vec<f64>| {
        PredictionTable::new("t", Quantity::Estimate, [vec![70.0, 80.0], axis, vec![0.0, 10.0]])
            .unwrap_err()
            .to_string()
    };
    says(&new(vec![30.0, f64::NAN]), &["axis phi", "NaN", "finite"]);
    says(&new(vec![30.0, 35.0, 35.0]), &["axis phi", "from 35 to 35 deg", "ascend"]);
    says(&new(vec![29.999_999_999_999_996]), &["one node only, 30 deg", "two"]);
    says(&new(vec![]), &["axis phi is empty"]);
}

#[test]
fn bad_cells_of_a_parquet_file_are_named_with_their_row() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("t.parquet");
    write_table(Form::Parquet, &table(), "Chen & Liu", &path).unwrap();
    let first_k = table().filled().next().unwrap().1.k_net.to_le_bytes();
    let mut bytes = std::fs::read(&path).unwrap();
    let place = bytes.windows(8).position(|w| w == first_k).expect("short pages are stored as they are");
    bytes[place..place + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    std::fs::write(&path, &bytes).unwrap();
    says(&read_parquet(&path).unwrap_err().to_string(), &["t.parquet, row 1", "k_net is NaN", "above 0"]);
}

#[test]
fn a_point_off_the_grid_and_a_cell_given_twice_are_refused() {
    let mut table = table();
    let cell = Cell { k_net: 1.0, status: CellStatus::Solved };
    let error = table.insert([70.0, 33.0, 0.0], cell).unwrap_err().to_string();
    says(&error, &["alpha 70 deg, phi 33 deg, delta 0 deg", "not a node"]);
    // A unit conversion away from a node is that node.
    let error = table.insert([70.0, 29.999_999_999_999_996, 0.0], cell).unwrap_err().to_string();
    says(&error, &["phi 30 deg", "given twice"]);
}
