//! Properties over random tables: writing and reading keeps every bit, grouping equals a plain reference.

use proptest::prelude::*;
use soilctl_strokes::{ReadOptions, StrokeRow, StrokeTable, Uncertainty, measurements};

fn signed() -> impl Strategy<Value = Option<f64>> {
    prop_oneof![Just(None), any::<f64>().prop_filter("in range", |x| x.abs() <= 1e12).prop_map(Some)]
}

fn name() -> impl Strategy<Value = Option<String>> {
    prop_oneof![Just(None), "(?s).{1,6}".prop_map(Some)]
}

prop_compose! {
    fn row()(
        stroke_id in name(),
        order in proptest::option::of(any::<u32>()),
        alpha_deg in 1.0..179.0_f64,
        depth_m in 1e-9..10.0_f64,
        force_n in 1e-9..1e9_f64,
        force_sd_n in proptest::option::of(0.0..1e3_f64),
        time_s in signed(),
        residual_ratio in signed(),
    ) -> StrokeRow {
        StrokeRow {
            stroke_id, order, alpha_deg, depth_m, width_m: 0.127, force_n, force_sd_n, time_s, residual_ratio,
            ..StrokeRow::default()
        }
    }
}

fn bits(row: &StrokeRow) -> Vec<Option<u64>> {
    [Some(row.alpha_deg), Some(row.depth_m), Some(row.width_m), Some(row.force_n), row.force_sd_n]
        .into_iter()
        .chain([row.time_s, row.residual_ratio])
        .map(|value| value.map(f64::to_bits))
        .collect()
}

/// Writes a cell with quotes, as a spreadsheet would.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}

proptest! {
    #[test]
    fn what_is_written_reads_back_to_the_same_bits(mut rows in prop::collection::vec(row(), 1..20)) {
        // No two strokes have one name.
        for (i, row) in rows.iter_mut().enumerate() {
            row.stroke_id = row.stroke_id.take().map(|id| format!("{id}{i}"));
        }
        let table = StrokeTable::new("s.csv", &rows).unwrap();
        let mut file = Vec::new();
        table.to_writer(&mut file).unwrap();
        let options = ReadOptions { allow_zero_sd: true };
        let back = StrokeTable::from_reader(&file[..], "s.csv", options).unwrap();
        for (a, b) in table.rows().zip(back.rows()) {
            prop_assert_eq!(bits(&a), bits(&b));
            prop_assert_eq!((&a.stroke_id, a.order), (&b.stroke_id, b.order));
        }
        prop_assert_eq!(table.rows().len(), back.rows().len());
    }

    #[test]
    fn unknown_columns_survive(cells in prop::collection::vec(("(?s).{0,8}", "(?s).{0,8}"), 1..10), last in any::<bool>()) {
        let header = if last { "alpha_deg,x,depth_m,width_m,force_n,y z" } else { "x,y z,alpha_deg,depth_m,width_m,force_n" };
        let mut text = header.to_owned() + "\n";
        for (x, y) in &cells {
            let (x, y) = (quoted(x), quoted(y));
            text += &if last { format!("80,{x},0.02,0.1,5,{y}\n") } else { format!("{x},{y},80,0.02,0.1,5\n") };
        }
        let table = StrokeTable::from_reader(text.as_bytes(), "s.csv", ReadOptions::default()).unwrap();
        let mut file = Vec::new();
        table.to_writer(&mut file).unwrap();
        prop_assert!(file.starts_with(header.as_bytes()));
        let back = StrokeTable::from_reader(&file[..], "s.csv", ReadOptions::default()).unwrap();
        for (i, (x, y)) in cells.iter().enumerate() {
            prop_assert_eq!(back.unknown_columns().next().unwrap().cell(i), Some(x.as_str()));
            prop_assert_eq!(back.unknown_columns().nth(1).unwrap().cell(i), Some(y.as_str()));
        }
        prop_assert_eq!(back.unknown_columns().nth(1).unwrap().name(), "y z");
    }

    #[test]
    fn no_input_panics(bytes in prop::collection::vec(any::<u8>(), 0..200), tail in "[0-9,.\n\"a\r-]{0,80}") {
        let _ = StrokeTable::from_reader(&bytes[..], "s.csv", ReadOptions::default());
        let text = format!("alpha_deg,depth_m,width_m,force_n\n{tail}");
        if let Ok(table) = StrokeTable::from_reader(text.as_bytes(), "s.csv", ReadOptions::default()) {
            let _ = measurements(&table, Uncertainty::Required);
        }
    }

    #[test]
    fn grouping_equals_a_plain_reference(
        strokes in prop::collection::vec((0_u8..3, 0_u8..2, 0_u8..2, 1.0..9.0_f64, -1e-12..1e-12_f64, any::<bool>()), 1..40)
    ) {
        let rows: Vec<StrokeRow> = strokes
            .iter()
            .map(|&(alpha, depth, width, force_n, jitter, own)| StrokeRow {
                alpha_deg: 70.0 + 5.0 * f64::from(alpha) + jitter,
                depth_m: 0.02 + 0.005 * f64::from(depth) + jitter,
                width_m: 0.1 + 0.027 * f64::from(width),
                force_n,
                force_sd_n: own.then_some(0.25),
                ..StrokeRow::default()
            })
            .collect();
        let found = measurements(&StrokeTable::new("s.csv", &rows).unwrap(), Uncertainty::ExactAllowed).unwrap();

        let near = |a: &StrokeRow, b: &StrokeRow| {
            (a.alpha_deg - b.alpha_deg).abs() < 1e-9 && (a.depth_m - b.depth_m).abs() < 1e-9 && a.width_m == b.width_m
        };
        let mut expected: Vec<Vec<usize>> = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            let home = expected.iter_mut().find(|group| {
                row.force_sd_n.is_none() && rows[group[0]].force_sd_n.is_none() && near(&rows[group[0]], row)
            });
            match home {
                Some(group) => group.push(i),
                None => expected.push(vec![i]),
            }
        }
        prop_assert_eq!(found.len(), expected.len());
        for (one, group) in found.iter().zip(&expected) {
            let n = group.len() as f64;
            let mean = group.iter().map(|&i| rows[i].force_n).sum::<f64>() / n;
            let variance = group.iter().map(|&i| (rows[i].force_n - mean).powi(2)).sum::<f64>() / (n - 1.0).max(1.0);
            prop_assert_eq!(&one.lines, &group.iter().map(|i| i + 2).collect::<Vec<_>>());
            prop_assert!((one.force_n - mean).abs() < 1e-12);
            let sd = rows[group[0]].force_sd_n.unwrap_or(variance.sqrt());
            prop_assert!((one.force_sd_n - sd).abs() < 1e-7, "{} {}", one.force_sd_n, sd);
            prop_assert!(one.force_min_n <= one.force_n && one.force_n <= one.force_max_n);
        }
    }
}
