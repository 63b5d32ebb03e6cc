//! Traces of strokes from CSV.

#![allow(clippy::unwrap_used)]

use soilctl_strokes::{StrokesError, TraceTable};

fn read(csv: &str) -> Result<TraceTable, StrokesError> {
    TraceTable::from_reader(csv.as_bytes(), "traces.csv")
}

#[test]
fn columns_in_any_order_with_holes() {
    let table = read(
        "force_n,other,t_s,stroke_id,x_ext_m,x_mtr_m\n1,a,0,s1,0.1,\n2,b,1,s1,0.2,0.25\r\n3,c,0,s2,0,0\n",
    )
    .unwrap();
    assert_eq!(table.len(), 2);
    let s1 = table.get("s1").unwrap();
    assert_eq!((s1.len(), s1[1].force_n, s1[1].x_mtr_m, s1[0].x_mtr_m), (2, 2.0, Some(0.25), None));
    assert_eq!((s1[0].z_m, table.get("s3")), (None, None));
}

#[test]
fn what_cannot_be_meant_is_refused_with_its_place() {
    let head = "stroke_id,t_s,x_ext_m,force_n\n";
    for (csv, words) in [
        (String::new(), vec!["empty", "stroke_id"]),
        ("stroke_id,t_s,force_n\n".into(), vec!["x_ext_m", "required"]),
        ("t_s,t_s\n".into(), vec!["stroke_id"]),
        (format!("{head}s1,0,0\n"), vec!["line 2", "3 cells", "4"]),
        (format!("{head},0,0,1\n"), vec!["line 2", "stroke_id", "empty"]),
        (format!("{head}s1,0,0,x\n"), vec!["line 2", "force_n", "\"x\""]),
        (format!("{head}s1,0,0,1e999\n"), vec!["line 2", "force_n", "finite"]),
        (format!("{head}s1,1,0,1\ns2,0,0,1\ns1,1,0,1\n"), vec!["line 4", "t_s", "above the 1 s"]),
    ] {
        let problem = read(&csv).unwrap_err().to_string();
        for word in words {
            assert!(problem.contains(word), "{problem}: {word}");
        }
    }
}
