//! Stroke tables as they are written.
#![allow(clippy::unwrap_used)]

use std::path::Path;

use soilctl_columns::markdown;
use soilctl_process::table::{FailureRow, Form, StrokeRecord, write_table};
use soilctl_strokes::{ReadOptions, StrokeRow, StrokeTable};

fn stroke(name: &str) -> StrokeRecord {
    let row = StrokeRow {
        stroke_id: Some(name.into()),
        order: Some(3),
        time_s: Some(0.5),
        alpha_deg: 80.0,
        depth_m: 0.02,
        width_m: 0.127,
        force_n: 5.25,
        ..StrokeRow::default()
    };
    let failure = FailureRow { method: "drop".into(), log: "a, b.mcap".into(), ..FailureRow::default() };
    StrokeRecord { row, failure }
}

#[test]
fn csv_has_what_is_filled_and_all_that_is_said_of_the_failure() {
    let mut file = Vec::new();
    write_table(Form::Csv, &[stroke("a"), stroke("b")], &mut file).unwrap();
    let text = String::from_utf8(file).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "stroke_id,order,time_s,alpha_deg,depth_m,width_m,force_n,failure_time_s,lift_deg,lift_sd_deg,\
         two_lines_force_n,mobilised,method,failure,flags,log"
    );
    assert_eq!(lines[1], "a,3,0.5,80,0.02,0.127,5.25,,,,,,drop,,,\"a, b.mcap\"");
    let table = StrokeTable::from_reader(text.as_bytes(), "s.csv", ReadOptions::default()).unwrap();
    assert_eq!(table.rows().next().unwrap().order, Some(3));
    assert!(write_table(Form::Csv, &[stroke("a"), stroke("a")], Vec::new()).is_err());
}

#[test]
fn json_has_every_column_that_logs_tell_and_reads_back() {
    let text = serde_json::to_string(&stroke("a")).unwrap();
    assert!(
        text.starts_with(
            "{\"stroke_id\":\"a\",\"batch\":null,\"order\":3,\"alpha_deg\":80.0,\"depth_m\":0.02,\"width_m\":0.127,\
             \"force_n\":5.25,\"time_s\":0.5,"
        ),
        "{text}"
    );
    assert!(!text.contains("heap_height_m") && !text.contains("\"line\""), "{text}");
    assert!(
        text.ends_with("\"method\":\"drop\",\"failure\":\"\",\"flags\":\"\",\"log\":\"a, b.mcap\"}"),
        "{text}"
    );
    assert_eq!(serde_json::from_str::<StrokeRecord>(&text).unwrap(), stroke("a"));
}

#[test]
fn the_documentation_lists_the_columns() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/process.md");
    let (page, text) = (std::fs::read_to_string(&path).unwrap(), markdown::<FailureRow>());
    assert!(
        page.contains(&text),
        "the table in {} is not that of the columns; paste\n\n{text}",
        path.display()
    );
}
