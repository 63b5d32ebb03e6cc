//! Reads a stroke table and says what is in it: `cargo run -p soilctl-strokes --example summary -- STROKES.csv`.

use std::path::PathBuf;

use soilctl_columns::{Cell, Columns};
use soilctl_strokes::{
    Campaign, ReadOptions, StrokeRow, StrokeTable, StrokesError, Uncertainty, measurements,
};

fn main() -> Result<(), StrokesError> {
    let path = std::env::args().nth(1).map_or("data/campaigns/campaign_a/strokes.csv".into(), PathBuf::from);
    let table = StrokeTable::read(&path, ReadOptions::default())?;
    let rows: Vec<StrokeRow> = table.rows().collect();
    eprintln!("{}: {} strokes", table.name(), rows.len());
    for column in StrokeRow::COLUMNS {
        let measured = rows.iter().filter(|row| (column.get)(row) != Cell::Missing).count();
        eprintln!("  {:26} {measured:4} cells, {}", column.about.name, column.about.meaning);
    }
    for m in measurements(&table, Uncertainty::ExactAllowed)? {
        eprintln!(
            "{}: {:.2} N with a deviation of {:.2} N, {} strokes",
            m.label, m.force_n, m.force_sd_n, m.count
        );
    }
    let campaign = Campaign::read_beside(&path)?.unwrap_or_default();
    eprintln!("depths are known to {} m", campaign.depth_sd_m);
    Ok(())
}
