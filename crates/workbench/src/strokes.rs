//! Measured strokes on a page: the band of each, the soils that explain all of them, and which stroke would tell most.

use serde::{Deserialize, Serialize};
use soilctl_app::estimate::{self, Answer, Estimation, NextStroke, Request};
use soilctl_app::request::NumberOrColumn;
use soilctl_app::{AppError, TableSource, Unwatched};
use soilctl_estimator::Ring;
use soilctl_pages::estimate::extent;
use soilctl_strokes::Measurement;

/// Most strokes of a table on a page: so many are estimated while one waits.
const MOST_STROKES: usize = 200;
/// Most depths and widths of the table that are considered for the next stroke; each is tried at eight tool angles.
const MOST_SIZES: usize = 3;

/// Strokes to begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub(crate) struct Example {
    csv: &'static str,
    source: &'static str,
}

/// Four tool angles in one dense sand, as published.
pub(crate) const EXAMPLE: Example = Example {
    csv: include_str!("../../../data/soils/ticino_rained/strokes.csv"),
    source: "Rained Ticino sand, means over accepted strokes (Hong 2001, section 6.4.3).",
};

/// A table of strokes, and what is known beside it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Given {
    /// The table as text.
    csv: String,
    model: String,
    /// Interface friction; null: what the table says of it.
    delta_deg: Option<f64>,
    delta_tol_deg: f64,
    /// Bulk density; null: unknown.
    density_kg_m3: Option<f64>,
    density_tol: f64,
    /// Greatest force that the arm can exert.
    force_limit_n: Option<f64>,
}

/// What is shown of it.
#[derive(Debug, Serialize)]
pub(crate) struct Shown {
    answer: Answer,
    /// Interface friction at which bands are shown.
    delta_deg: f64,
    /// In the order of the measurements.
    bands: Vec<Band>,
    /// What all bands share there: polygons, each an outer ring and its holes, of [phi, density].
    shared: Vec<Vec<Ring>>,
    /// Friction angles and densities that are worth to be seen.
    extent: [[f64; 2]; 2],
}

/// The soils that one measurement leaves.
#[derive(Debug, Serialize)]
struct Band {
    /// Its lines in the table.
    lines: Vec<usize>,
    width_m: f64,
    /// Polygons as of `shared`.
    polygons: Vec<Vec<Ring>>,
}

/// Estimates as `soilctl estimate` does.
///
/// # Errors
/// [`AppError`] if the table or what is known beside it makes no sense. That no soil explains the strokes is an answer.
pub(crate) fn shown(given: Given) -> Result<Shown, AppError> {
    Shown::of(estimate::run(&given.request()?, &Unwatched)?)
}

/// Which stroke would shrink the region most, the best first; none if no soil explains those that were made.
///
/// # Errors
/// As [`shown`].
pub(crate) fn next(given: Given) -> Result<Vec<NextStroke>, AppError> {
    let mut request = given.request()?;
    let work = estimate::run(&request, &Unwatched)?;
    let sizes = |of: fn(&Measurement) -> f64| few(work.inputs.measurements.iter().map(of).collect());
    (request.next_depth_m, request.next_width_m) = (sizes(|m| m.depth_m), sizes(|m| m.width_m));
    request.next_strokes = true;
    Ok(estimate::run(&request, &Unwatched)?.answer.next_strokes.unwrap_or_default())
}

impl Given {
    fn request(self) -> Result<Request, AppError> {
        let strokes = self.csv.lines().filter(|line| !line.trim().is_empty()).count().saturating_sub(1);
        if strokes > MOST_STROKES {
            return Err(AppError::Request(format!(
                "the table has {strokes} strokes; a page estimates from at most {MOST_STROKES}, `soilctl estimate` from more"
            )));
        }
        let number_or_column =
            |value: Option<f64>| value.map_or(NumberOrColumn::Column, NumberOrColumn::Number);
        Ok(Request {
            file: TableSource::Text { csv: self.csv },
            model: self.model,
            delta_deg: number_or_column(self.delta_deg),
            delta_tol_deg: self.delta_tol_deg,
            density_kg_m3: self.density_kg_m3.map(NumberOrColumn::Number),
            density_tol: self.density_tol,
            force_limit_n: self.force_limit_n,
            ..Request::default()
        })
    }
}

impl Shown {
    fn of(work: Estimation) -> Result<Self, AppError> {
        let setup = work.setup()?;
        let delta_deg = f64::midpoint(work.inputs.delta_deg.0, work.inputs.delta_deg.1);
        let regions = soilctl_estimator::bands(&setup, delta_deg)?;
        let shared = soilctl_estimator::section(&setup, delta_deg)?.polygons().to_vec();
        let extent = extent(&work, &setup, &regions);
        let bands = regions.iter().zip(&work.inputs.measurements).map(|(region, measurement)| Band {
            lines: measurement.lines.clone(),
            width_m: measurement.width_m,
            polygons: region.polygons().to_vec(),
        });
        let bands = bands.collect();
        drop(setup);
        Ok(Self { answer: work.answer, delta_deg, bands, shared, extent })
    }
}

/// A few of many values, the least and the greatest among them, to the millimetre.
fn few(mut lengths_m: Vec<f64>) -> Vec<f64> {
    for length in &mut lengths_m {
        *length = (*length * 1e3).round().max(1.0) / 1e3;
    }
    lengths_m.sort_by(f64::total_cmp);
    lengths_m.dedup();
    let last = lengths_m.len().saturating_sub(1);
    if last < MOST_SIZES {
        return lengths_m;
    }
    (0..MOST_SIZES).filter_map(|k| lengths_m.get(k * last / (MOST_SIZES - 1)).copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_sizes_keep_the_least_and_the_greatest() {
        assert_eq!(few(vec![0.0254, 0.0254, 0.02]), [0.02, 0.025]);
        assert_eq!(few(vec![0.05, 0.01, 0.02, 0.03, 0.04]), [0.01, 0.03, 0.05]);
        assert_eq!(few(vec![1e-5]), [0.001]);
    }
}
