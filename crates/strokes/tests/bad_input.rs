//! Every way in which a stroke table can be wrong, and what the reader says about it.

use soilctl_strokes::{ReadOptions, StrokeRow, StrokeTable, StrokesError, Uncertainty, measurements};

const HEADER: &str = "alpha_deg,depth_m,width_m,force_n,force_sd_n,batch\n";

fn read(text: &str) -> Result<StrokeTable, StrokesError> {
    StrokeTable::from_reader(text.as_bytes(), "s.csv", ReadOptions::default())
}

fn refused(text: &str, parts: &[&str]) {
    let Err(error) = read(text) else { panic!("accepted: {text}") };
    let message = error.to_string();
    for part in parts {
        assert!(message.contains(part), "{part:?} is not in: {message}");
    }
}

fn row_refused(row: &str, parts: &[&str]) {
    refused(&format!("{HEADER}80,0.025,0.127,5,0.1,a\n{row}\n"), parts);
    // The line is the same where lines end in CRLF and where blank lines come before.
    let dos = format!("{HEADER}80,0.025,0.127,5,0.1,a\n\n{row}\n").replace('\n', "\r\n");
    let fourth: Vec<String> = parts.iter().map(|part| part.replace("line 3", "line 4")).collect();
    refused(&dos, &fourth.iter().map(String::as_str).collect::<Vec<_>>());
}

#[test]
fn a_wrong_number_is_reported_with_place_text_and_range() {
    row_refused("80,0.025,0.127,abc,0.1,a", &["s.csv, line 3, column force_n is \"abc\"", "above 0 N"]);
    row_refused("80,0.025,0.127,\"5,1\",0.1,a", &["line 3, column force_n", "5,1"]);
    row_refused("80,0.025,0.127,NaN,0.1,a", &["line 3, column force_n is NaN", "above 0 N"]);
    row_refused("80,inf,0.127,5,0.1,a", &["line 3, column depth_m is inf", "above 0 m"]);
    row_refused("80,1e999,0.127,5,0.1,a", &["line 3, column depth_m is 1e999"]);
    row_refused("80,0.025,0.127,-5,0.1,a", &["line 3, column force_n is -5", "above 0 N"]);
    row_refused("80,0.025,0.127,0,0.1,a", &["line 3, column force_n is 0"]);
    row_refused("80,0,0.127,5,0.1,a", &["line 3, column depth_m is 0", "above 0 m"]);
    row_refused("80,0.025,-1,5,0.1,a", &["line 3, column width_m is -1", "above 0 m"]);
    row_refused("180,0.025,0.127,5,0.1,a", &["line 3, column alpha_deg is 180", "above 0 and below 180 deg"]);
    row_refused("0,0.025,0.127,5,0.1,a", &["line 3, column alpha_deg is 0"]);
    row_refused("80,0.025,0.127,,0.1,a", &["line 3, column force_n is empty", "above 0 N"]);
}

#[test]
fn a_force_without_uncertainty_has_its_own_message() {
    row_refused("80,0.025,0.127,5,0,a", &["line 3, column force_sd_n is 0", "--exact", "in N"]);
    row_refused("80,0.025,0.127,5,-0.1,a", &["line 3, column force_sd_n is -0.1", "positive"]);
    let exact = ReadOptions { allow_zero_sd: true };
    let zero = format!("{HEADER}80,0.025,0.127,5,0,a\n");
    let table = StrokeTable::from_reader(zero.as_bytes(), "s.csv", exact).unwrap();
    assert_eq!(measurements(&table, Uncertainty::ExactAllowed).unwrap()[0].force_sd_n, 0.0);
    let message = measurements(&table, Uncertainty::Required).unwrap_err().to_string();
    assert!(message.contains("line 2, column force_sd_n is 0"), "{message}");
    let negative = format!("{HEADER}80,0.025,0.127,5,-1,a\n");
    assert!(StrokeTable::from_reader(negative.as_bytes(), "s.csv", exact).is_err());
}

#[test]
fn rows_of_the_wrong_length_are_reported_with_both_lengths() {
    row_refused("80,0.025,0.127,5,0.1", &["line 3 has 5 cells", "header has 6"]);
    row_refused("80,0.025,0.127,5,0.1,a,b", &["line 3 has 7 cells"]);
}

#[test]
fn headers_are_checked() {
    refused("alpha_deg,depth_m,force_n\n80,1,1\n", &["no column width_m", "alpha_deg, depth_m, force_n"]);
    refused("alpha_deg;depth_m;width_m;force_n\n", &["no column alpha_deg", "semicolons"]);
    refused("alpha_deg\tdepth_m\n", &["tabs"]);
    refused(
        "alpha_deg,depth_m,width_m,force_n, depth_m\n",
        &["line 1", "\"depth_m\" appears twice", "2 and 5"],
    );
    refused("", &["s.csv is empty", "alpha_deg"]);
    refused("\n\r\n\n", &["s.csv is empty"]);
    refused("\u{feff}", &["s.csv is empty"]);
    refused("alpha_deg,depth_m,width_m,force_n\n", &["no strokes"]);
}

#[test]
fn two_strokes_of_one_name_are_refused_with_both_lines() {
    let header = "alpha_deg,depth_m,width_m,force_n,stroke_id\n";
    refused(
        &format!("{header}80,1,1,1,a\n\n80,1,1,2,b\n80,1,1,2,a\n"),
        &["lines 2 and 5", "stroke_id \"a\""],
    );
    // Strokes without a name are not of one name.
    assert!(read(&format!("{header}80,1,1,1,\n80,1,1,2,\n80,1,1,2,c\n")).is_ok());
    let row = StrokeRow {
        stroke_id: Some("s".into()),
        alpha_deg: 80.0,
        depth_m: 0.02,
        width_m: 0.1,
        force_n: 5.0,
        ..StrokeRow::default()
    };
    let made = StrokeTable::new("s.csv", &[row.clone(), row]).unwrap_err().to_string();
    assert!(made.contains("lines 2 and 3"), "{made}");
}

#[test]
fn bytes_that_are_not_text_are_reported_with_line_and_byte() {
    for (row, column) in
        [(&b"80,0.025,0.127,\xff5,0.1,a"[..], "force_n"), (b"80,0.025,0.127,5,0.1,m\xfcd", "batch")]
    {
        let mut bytes = HEADER.as_bytes().to_vec();
        bytes.extend_from_slice(row);
        let message =
            StrokeTable::from_reader(&bytes[..], "s.csv", ReadOptions::default()).unwrap_err().to_string();
        assert!(
            message.contains("line 2") && message.contains(column) && message.contains("0xf"),
            "{message}"
        );
    }
    let header = b"alpha_deg,\xe4\n";
    let message =
        StrokeTable::from_reader(&header[..], "s.csv", ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("line 1: byte 1 of the name of column 2 is 0xe4"), "{message}");
}

#[test]
fn lines_are_right_after_quoted_line_breaks_and_blank_lines() {
    let text = "\n\nalpha_deg,depth_m,width_m,force_n,note\n80,1,1,1,\"a\nb\n\"\n\n80,1,1,1,x\n\n\n80,1,1,2,\"c\nd\"";
    let table = read(text).unwrap();
    let lines: Vec<usize> = table.rows().map(|row| row.line).collect();
    assert_eq!(lines, [4, 8, 11]);
    assert_eq!(table.unknown_columns().next().unwrap().cell(0), Some("a\nb\n"));
    assert_eq!(table.unknown_columns().next().unwrap().cell(3), None);
}

#[test]
fn byte_order_mark_crlf_and_spaces_are_accepted() {
    let text =
        "\u{feff}width_m, force_n ,alpha_deg,depth_m,note\r\n0.127, 5.5 ,80,0.025,x\r\n0.127,6,80,0.025,y";
    let table = read(text).unwrap();
    assert_eq!(table.rows().next().unwrap().force_n, 5.5);
    assert_eq!(table.unknown_columns().next().unwrap().cell(0), Some("x"));
    assert_eq!(table.rows().nth(1).unwrap().line, 3);
}

#[test]
fn groups_without_uncertainty_say_what_to_do() {
    let lone =
        read("alpha_deg,depth_m,width_m,force_n\n80,0.025,0.127,5\n70,0.025,0.127,3\n80,0.025,0.127,6\n");
    let message = measurements(&lone.unwrap(), Uncertainty::Required).unwrap_err().to_string();
    assert!(message.contains("line 3: the only stroke at 70 deg, 25 mm has no force_sd_n"), "{message}");
    let equal = read(
        "alpha_deg,depth_m,width_m,force_n\n80,0.025,0.127,0.1\n80,0.025,0.127,0.1\n80,0.025,0.127,0.1\n",
    )
    .unwrap();
    let message = measurements(&equal, Uncertainty::Required).unwrap_err().to_string();
    assert!(message.contains("lines 2, 3, 4") && message.contains("--exact"), "{message}");
    assert_eq!(measurements(&equal, Uncertainty::ExactAllowed).unwrap()[0].force_sd_n, 0.0);
}

#[test]
fn an_endless_line_is_refused_before_it_fills_the_memory() {
    let message =
        StrokeTable::from_reader(std::io::repeat(0), "zero", ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("zero: ") && message.contains("1 MiB"), "{message}");
}

#[test]
fn a_missing_file_is_named() {
    let message = StrokeTable::read("no/such.csv".as_ref(), ReadOptions::default()).unwrap_err().to_string();
    assert!(message.starts_with("no/such.csv: "), "{message}");
}

/// Numbers go into their columns, which are added where they are not there, and what means nothing here stays.
#[test]
fn numbers_are_put_into_a_row() {
    let table = read("stroke_id,alpha_deg,depth_m,width_m,force_n,force_sd_n,remark\na,80,0.02,0.1,5,0.1,wet\nb,70,0.02,0.1,4,0.1,\n").unwrap();
    let put = |row, numbers: &[(&str, f64)]| table.clone().with_numbers(row, numbers);
    let changed = put(1, &[("break_distance_m", 0.06), ("force_n", 4.5), ("remark", 1.0)]).unwrap();
    let rows: Vec<_> = changed.rows().collect();
    assert_eq!((rows[0].break_distance_m, rows[1].break_distance_m), (None, Some(0.06)));
    assert_eq!((rows[0].force_n, rows[1].force_n), (5.0, 4.5));
    let remarks = changed.unknown_columns().next().unwrap();
    assert_eq!((remarks.cell(0), remarks.cell(1)), (Some("wet"), Some("")));
    let problem = put(0, &[("break_distance_m", -0.06)]).unwrap_err().to_string();
    assert!(problem.contains("line 2") && problem.contains("break_distance_m"), "{problem}");
    assert_eq!(put(7, &[("force_n", 9.0)]).unwrap().rows().map(|row| row.force_n).sum::<f64>(), 9.0);
}
