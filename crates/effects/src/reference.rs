use serde::{Deserialize, Serialize};
use soilctl_strokes::StrokeRow;

/// What the parameters of effects refer to: means and ends of the campaign in which they were found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Mean vertical depth, m.
    pub depth_m: f64,
    /// Mean tool angle, deg.
    pub alpha_deg: f64,
    /// Mean interface friction angle of the set-points, deg; `None` if none was recorded.
    pub delta_set_deg: Option<f64>,
    /// Geometric mean of the speeds, m/s; `None` if none was recorded.
    pub speed_mps: Option<f64>,
    /// First and last time on the campaign clock, s.
    pub time_s: Option<(f64, f64)>,
    /// Least and greatest base angle, deg.
    pub base_deg: Option<(f64, f64)>,
    /// Names of the batches in the order in which they were made.
    pub batches: Vec<String>,
}

impl Reference {
    /// Place of a batch in the order in which they were made, from 0; `None` if there is none of that name.
    #[must_use]
    pub fn place_of(&self, batch: &str) -> Option<f64> {
        self.batches.iter().position(|name| name == batch).map(|place| place as f64)
    }

    /// The reference of a campaign; `None` without strokes.
    #[must_use]
    pub fn of(rows: &[StrokeRow]) -> Option<Self> {
        let mean =
            |values: Vec<f64>| (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64);
        let ends = |values: Vec<f64>| {
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            (low < high).then_some((low, high))
        };
        let speeds = rows.iter().filter_map(|row| row.speed_mps).filter(|v| *v > 0.0).map(f64::ln);
        Some(Self {
            depth_m: mean(rows.iter().map(|row| row.depth_m).collect())?,
            alpha_deg: mean(rows.iter().map(|row| row.alpha_deg).collect())?,
            delta_set_deg: mean(rows.iter().filter_map(|row| row.delta_set_deg).collect()),
            speed_mps: mean(speeds.collect()).map(f64::exp),
            time_s: ends(rows.iter().filter_map(|row| row.time_s).collect()),
            base_deg: ends(rows.iter().filter_map(|row| row.base_deg).collect()),
            batches: batches(rows),
        })
    }
}

/// Batches by the time of their first stroke, or in the order of the file where there is no clock.
fn batches(rows: &[StrokeRow]) -> Vec<String> {
    let mut found: Vec<(f64, &str)> = Vec::new();
    for row in rows {
        let Some(name) = row.batch.as_deref() else { continue };
        let time = row.time_s.unwrap_or(f64::INFINITY);
        match found.iter_mut().find(|(_, known)| *known == name) {
            Some((first, _)) => *first = first.min(time),
            None => found.push((time, name)),
        }
    }
    // Stable, so that batches without a clock keep the order of the file.
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(_, name)| name.to_owned()).collect()
}
