use soilctl_soil::units::inches_to_m;
use soilctl_strokes::StrokeRow;

use crate::Reference;

/// A stroke as effects see it. `None` means not recorded: effects that need it leave the stroke alone.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Tool angle, deg.
    pub alpha_deg: f64,
    /// Recorded vertical depth, m.
    pub depth_m: f64,
    /// Width, m.
    pub width_m: f64,
    /// Set-point of the interface friction angle, deg.
    pub delta_set_deg: Option<f64>,
    /// ln of the speed over the geometric mean of the campaign.
    pub ln_speed: Option<f64>,
    /// Radius as a fraction of the way from 12 in to 17 in.
    pub radius_position: Option<f64>,
    /// Base angle, deg.
    pub base_deg: Option<f64>,
    /// Base angle from -1 (least of the campaign) to 1 (greatest).
    pub base_position: Option<f64>,
    /// Edge distance to the nearest earlier stroke, m; `None` if there was none.
    pub gap_prior_m: Option<f64>,
    /// Distance to the nearest wall, m.
    pub wall_m: Option<f64>,
    /// Campaign clock from 0 (first stroke) to 1 (last).
    pub time_fraction: Option<f64>,
    /// Batch from 0 (first) to 1 (last).
    pub batch_fraction: Option<f64>,
}

impl Stroke {
    /// A row of a stroke table, seen from the reference of a campaign.
    #[must_use]
    pub fn new(row: &StrokeRow, reference: &Reference) -> Self {
        let (near, far) = (inches_to_m(12.0), inches_to_m(17.0));
        let between = |value: Option<f64>, ends: Option<(f64, f64)>| {
            let (low, high) = ends?;
            Some((value? - low) / (high - low))
        };
        let batch = row.batch.as_deref().and_then(|name| reference.batches.iter().position(|b| b == name));
        let last = reference.batches.len().saturating_sub(1);
        let speed = row.speed_mps.filter(|v| *v > 0.0);
        Self {
            alpha_deg: row.alpha_deg,
            depth_m: row.depth_m,
            width_m: row.width_m,
            delta_set_deg: row.delta_set_deg,
            ln_speed: speed.zip(reference.speed_mps).map(|(v, mean)| libm::log(v / mean)),
            radius_position: row.radius_m.map(|r| (r - near) / (far - near)),
            base_deg: row.base_deg,
            base_position: between(row.base_deg, reference.base_deg).map(|x| 2.0 * x - 1.0),
            gap_prior_m: row.gap_prior_m,
            wall_m: row.wall_m,
            time_fraction: between(row.time_s, reference.time_s),
            batch_fraction: batch.filter(|_| last > 0).map(|i| i as f64 / last as f64),
        }
    }
}
