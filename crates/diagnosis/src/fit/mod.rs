//! The most likely soil, scatter and amplitudes of one set of effects, and the evidence for it.

mod background;
mod problem;
mod report;
mod solve;
mod together;

use std::collections::BTreeSet;

pub(crate) use background::Background;
use problem::Problem;
use soilctl_effects::Channel;

use crate::setup::FitSetup;
use crate::spec::Spec;

/// Result of a fit.
#[derive(Debug, Clone)]
pub(crate) struct Fit {
    /// ln of the probability of the data, up to what all fits of the same data share.
    pub(crate) log_evidence: f64,
    /// Friction angle, offset of the interface friction (deg), ln of the density over its prior mean; the prior's
    /// values if forces took no part.
    pub(crate) soil: [f64; 3],
    /// Standard deviations of the same.
    pub(crate) soil_sd: [f64; 3],
    /// Amplitude and its standard deviation, by choice.
    pub(crate) amplitudes: Vec<(f64, f64)>,
    /// Coefficients of the nuisance regressors.
    pub(crate) nuisance: Vec<f64>,
    /// Coefficients of the regressors of a shape without a name, and their covariances.
    pub(crate) shape: Vec<f64>,
    pub(crate) shape_covariance: Vec<Vec<f64>>,
    /// Scatter of ln force of one stroke, without depth error.
    pub(crate) scatter: f64,
    /// Standard deviation of each ln force, batches aside.
    pub(crate) force_sd: Vec<f64>,
    /// ln force that soil, effects and model nuisance give, without batches, by stroke.
    pub(crate) ln_force: Vec<f64>,
    /// Standard deviation of that expectation.
    pub(crate) expectation_sd: Vec<f64>,
    /// Readings of the columns of strokes that took no part.
    pub(crate) readings: Vec<Reading>,
}

/// A cell of a column that a fit predicts without having seen it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reading {
    pub(crate) channel: Channel,
    pub(crate) stroke: usize,
    /// Reading minus expectation.
    pub(crate) residual: f64,
    /// Of the reading about its expectation, and of the expectation.
    pub(crate) sd: f64,
}

/// Which strokes take part.
pub(crate) fn everything(setup: &FitSetup<'_>) -> Vec<bool> {
    vec![true; setup.data.len()]
}

/// Fits one set of effects. `channels` are the channels whose readings take part, `with_force` says whether the forces
/// do. Strokes that are not included are predicted all the same. `None` if no finite answer exists.
pub(crate) fn fit(
    setup: &FitSetup<'_>,
    spec: &Spec,
    channels: &BTreeSet<Channel>,
    with_force: bool,
    include: &[bool],
) -> Option<Fit> {
    Problem::new(setup, spec, channels, with_force, include).solve()
}
