//! The file of published soils.

use serde::Deserialize;

use super::{Body, Soil};
use crate::AppError;

const FILE: &str = include_str!("../../../../data/published_soils.csv");

/// A row of it, whose columns say their units.
#[derive(Debug, Deserialize)]
struct Row {
    name: String,
    title: String,
    body: Body,
    phi_low_deg: f64,
    phi_high_deg: f64,
    cohesion_low_pa: f64,
    cohesion_high_pa: f64,
    density_low_kg_m3: f64,
    density_high_kg_m3: f64,
    stress_low_pa: Option<f64>,
    stress_high_pa: Option<f64>,
    method: String,
    source: String,
    note: String,
}

/// All of them.
///
/// # Errors
/// [`AppError::Request`] if the file makes no sense, which a test excludes.
pub(super) fn soils() -> Result<Vec<Soil>, AppError> {
    let mut reader = csv::Reader::from_reader(FILE.as_bytes());
    let rows: Result<Vec<Row>, _> = reader.deserialize().collect();
    let rows = rows.map_err(|error| AppError::Request(format!("the file of published soils: {error}")))?;
    Ok(rows.into_iter().map(Soil::from).collect())
}

impl From<Row> for Soil {
    fn from(row: Row) -> Self {
        Self {
            name: row.name,
            title: row.title,
            body: row.body,
            gravity_m_s2: row.body.gravity_m_s2(),
            phi_deg: [row.phi_low_deg, row.phi_high_deg],
            cohesion_pa: [row.cohesion_low_pa, row.cohesion_high_pa],
            density_kg_m3: [row.density_low_kg_m3, row.density_high_kg_m3],
            stress_pa: row.stress_low_pa.zip(row.stress_high_pa).map(|(low, high)| [low, high]),
            method: row.method,
            source: row.source,
            note: row.note,
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_row_is_a_soil_with_a_source() {
        let soils = soils().unwrap();
        let names: BTreeSet<_> = soils.iter().map(|soil| &soil.name).collect();
        assert_eq!(names.len(), soils.len(), "a name twice");
        for soil in &soils {
            let name = &soil.name;
            assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_'), "{name}");
            let is_within = |[low, high]: [f64; 2], least, most| least <= low && low <= high && high <= most;
            assert!(is_within(soil.phi_deg, 5.0, 70.0), "{name}");
            assert!(is_within(soil.cohesion_pa, 0.0, 2e4), "{name}");
            assert!(is_within(soil.density_kg_m3, 300.0, 2500.0), "{name}");
            assert!(soil.stress_pa.is_none_or(|stress| is_within(stress, 1.0, 1e6)), "{name}");
            assert!(!soil.title.is_empty() && !soil.method.is_empty() && !soil.source.is_empty(), "{name}");
        }
    }
}
