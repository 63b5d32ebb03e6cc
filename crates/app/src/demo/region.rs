//! From measurements to every friction angle and density that explains them.

use std::path::Path;

use super::answer::{Region, Truth};
use crate::estimate::{self, Estimation};
use crate::request::{Ends, Loads, NumberOrColumn};
use crate::{AppError, Unwatched};

/// Half width of what is known of the inclination at failure, in deg.
const INCLINATION_DEG: f64 = 1.0;
/// A weighed box is right within this share.
const WEIGHED: f64 = 0.01;

/// Everything that the estimate may know.
pub(super) struct Known<'a> {
    pub(super) measurements: &'a Path,
    pub(super) model: &'a str,
    pub(super) ends: Ends,
    pub(super) cohesion_pa: f64,
    pub(super) gravity_m_s2: f64,
    pub(super) density_sd_rel: f64,
}

impl Known<'_> {
    /// What an estimate is asked, with the density as weighed in kg/m3 or unknown.
    pub(super) fn request(&self, weighed_kg_m3: Option<f64>) -> estimate::Request {
        estimate::Request {
            file: self.measurements.into(),
            model: self.model.to_owned(),
            ends: Some(self.ends),
            delta_deg: NumberOrColumn::Column,
            delta_tol_deg: INCLINATION_DEG,
            density_kg_m3: weighed_kg_m3.map(NumberOrColumn::Number),
            density_tol: WEIGHED + self.density_sd_rel,
            loads: Loads {
                cohesion_pa: self.cohesion_pa,
                gravity_m_s2: self.gravity_m_s2,
                ..Loads::default()
            },
            ..estimate::Request::default()
        }
    }
}

/// An estimate, or in words why there is none.
///
/// # Errors
/// Only those of files: that forces allow no estimate is an answer.
pub(super) fn estimate(request: &estimate::Request) -> Result<Result<Estimation, String>, AppError> {
    match estimate::run(request, &Unwatched) {
        Ok(work) => Ok(Ok(work)),
        Err(problem) if problem.is_of_a_file() => Err(problem),
        Err(problem) => Ok(Err(problem.to_string())),
    }
}

/// The estimate beside the truth.
pub(super) fn region(work: &Estimation, truth: &Truth) -> Region {
    let found = &work.answer;
    let holds =
        |range: Option<[f64; 2]>, value: f64| range.is_some_and(|[low, high]| (low..=high).contains(&value));
    Region {
        consistent: found.consistent,
        confidence: found.confidence,
        phi_deg: found.phi_deg,
        density_kg_m3: found.density_kg_m3,
        density_known_kg_m3: found.density_known_kg_m3,
        phi_holds_truth: holds(found.phi_deg, truth.phi_deg),
        density_holds_truth: holds(found.density_kg_m3, truth.density_kg_m3),
        holds_truth: work.estimate.region.contains([truth.phi_deg, truth.density_kg_m3]),
        verdict: found.verdict.clone(),
    }
}
