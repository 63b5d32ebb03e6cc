//! A campaign as the diagnosis sees it.

use std::collections::BTreeMap;

use soilctl_effects::{Channel, Reading, Reference, Stroke};
use soilctl_soil::STANDARD_GRAVITY_M_S2;
use soilctl_strokes::{Campaign, StrokeRow};

use crate::DiagnosisError;

/// Density that dry sand has if nobody weighed it, kg/m3, and its relative standard deviation.
const USUAL_DENSITY: (f64, f64) = (1550.0, 0.1);
/// Friction angle of soils nobody tested, deg, and its standard deviation.
const USUAL_PHI: (f64, f64) = (38.0, 6.0);
/// Interface friction if there was no set-point, deg, and its standard deviation.
const USUAL_DELTA: (f64, f64) = (22.0, 5.0);

/// A value with its standard deviation, before the strokes are looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prior {
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub sd: f64,
}

/// Strokes and all that is known beside them.
#[derive(Debug, Clone)]
pub struct Data {
    /// Name of the stroke table, for messages.
    pub name: String,
    /// Rows as they were read.
    pub rows: Vec<StrokeRow>,
    /// What was known of the campaign.
    pub campaign: Campaign,
    /// Means and ends that parameters refer to.
    pub reference: Reference,
    /// The strokes as effects see them.
    pub strokes: Vec<Stroke>,
    /// ln of the failure force in N.
    pub ln_force: Vec<f64>,
    /// Index of the batch of each stroke; all 0 without batches.
    pub batch: Vec<usize>,
    /// Number of batches, at least 1.
    pub batches: usize,
    /// Index of the tool angle of each stroke among the different ones.
    pub level: Vec<usize>,
    /// Different tool angles, ascending, in deg.
    pub levels_deg: Vec<f64>,
    /// Trace-derived columns that have at least one cell.
    pub channels: BTreeMap<Channel, Vec<Option<f64>>>,
    /// Friction angle, deg.
    pub phi: Prior,
    /// Interface friction minus its set-point, deg.
    pub delta: Prior,
    /// Mean density, kg/m3, with a relative standard deviation.
    pub density: Prior,
    /// Gravity, m/s2.
    pub gravity_m_s2: f64,
}

impl Data {
    /// Prepares a campaign.
    ///
    /// # Errors
    /// [`DiagnosisError::NoStrokes`] without rows.
    pub fn new(name: &str, rows: Vec<StrokeRow>, campaign: Campaign) -> Result<Self, DiagnosisError> {
        let none = || DiagnosisError::NoStrokes { file: name.into() };
        let reference = Reference::of(&rows).ok_or_else(none)?;
        let strokes: Vec<Stroke> = rows.iter().map(|row| Stroke::new(row, &reference)).collect();
        let batch: Vec<usize> = rows
            .iter()
            .map(|row| {
                let name = row.batch.as_deref();
                reference
                    .batches
                    .iter()
                    .position(|b| Some(b.as_str()) == name)
                    .unwrap_or(reference.batches.len())
            })
            .collect();
        let batches = batch.iter().max().map_or(1, |last| last + 1);
        let mut levels_deg: Vec<f64> = rows.iter().map(|row| row.alpha_deg).collect();
        levels_deg.sort_by(f64::total_cmp);
        levels_deg.dedup_by(|a, b| (*a - *b).abs() < 1.0);
        let level = rows.iter().map(|row| nearest(&levels_deg, row.alpha_deg)).collect();
        let mut channels = BTreeMap::new();
        for channel in Channel::ALL {
            let cells: Vec<Option<f64>> = rows.iter().map(|row| channel.of(row)).collect();
            if cells.iter().any(Option::is_some) {
                channels.insert(channel, cells);
            }
        }
        let densities: Vec<f64> = rows.iter().filter_map(|row| row.density_kg_m3).collect();
        let density = if densities.is_empty() {
            Prior { mean: USUAL_DENSITY.0, sd: USUAL_DENSITY.1 }
        } else {
            let mean = densities.iter().sum::<f64>() / densities.len() as f64;
            Prior { mean, sd: campaign.density_sd_rel.max(0.005) }
        };
        let phi = match (campaign.phi_independent_deg, campaign.phi_independent_sd) {
            (Some(mean), sd) => Prior { mean, sd: sd.unwrap_or(1.0).max(0.1) },
            _ => Prior { mean: USUAL_PHI.0, sd: USUAL_PHI.1 },
        };
        let delta = if reference.delta_set_deg.is_some() {
            Prior { mean: 0.0, sd: campaign.delta_sd_deg.max(0.1) }
        } else {
            Prior { mean: 0.0, sd: USUAL_DELTA.1 }
        };
        Ok(Self {
            name: name.into(),
            ln_force: rows.iter().map(|row| row.force_n.ln()).collect(),
            rows,
            campaign,
            reference,
            strokes,
            batch,
            batches,
            level,
            levels_deg,
            channels,
            phi,
            delta,
            density,
            gravity_m_s2: STANDARD_GRAVITY_M_S2,
        })
    }

    /// Number of strokes.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a campaign is never empty")]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Set-point of the interface friction of a stroke, deg; the mean set-point where the cell is empty.
    #[must_use]
    pub fn delta_set_deg(&self, stroke: usize) -> f64 {
        self.rows[stroke].delta_set_deg.or(self.reference.delta_set_deg).unwrap_or(USUAL_DELTA.0)
    }

    /// What shifts of channels depend on.
    pub(crate) fn reading(&self, stroke: usize) -> Reading {
        Reading {
            force_n: self.rows[stroke].force_n,
            delta_deg: self.delta_set_deg(stroke),
            unit_weight_n_m3: self.density.mean * self.gravity_m_s2,
            encoder_step_m: self.campaign.instrument.encoder_step_m,
        }
    }
}

fn nearest(levels: &[f64], value: f64) -> usize {
    let mut best = (f64::INFINITY, 0);
    for (i, level) in levels.iter().enumerate() {
        let distance = (level - value).abs();
        if distance < best.0 {
            best = (distance, i);
        }
    }
    best.1
}
