//! From a request and a stroke table to the estimator's setup.

use std::path::PathBuf;

use soilctl_earth_pressure::ForceModel;
use soilctl_effects::{Active, EffectId, Loaded};
use soilctl_estimator::{Observation, Setup};
use soilctl_soil::{Angle, Plate};
use soilctl_strokes::{
    Campaign, Measurement, PooledBand, ReadOptions, StrokeRow, StrokeTable, Uncertainty as Deviations,
    measurements,
};

use super::bands::{self, Bands};
use super::law;
use super::request::{BandKind, Request, Uncertainty};
use crate::request::NumberOrColumn;
use crate::{AppError, terms};

/// What a request knows: measurements, and what is known beside them.
#[derive(Debug, Clone)]
pub struct Inputs {
    /// Strokes of one geometry together, as the stroke table has them, or those of one kind at their reference.
    pub measurements: Vec<Measurement>,
    /// Bands of strokes of one kind, one a measurement; `None` if each measurement has a band by its own deviation.
    pub bands: Option<Bands>,
    /// Accuracies of the campaign, or the defaults.
    pub campaign: Campaign,
    /// Interval of the interface friction (deg).
    pub delta_deg: (f64, f64),
    /// Interval of the density (kg/m3); `None` if it is unknown.
    pub density_kg_m3: Option<(f64, f64)>,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

/// What was read, once: a file may be a pipe.
pub(super) struct Files {
    /// Strokes without the effects of a model file.
    table: StrokeTable,
    campaign: Campaign,
    /// The model file, if one took the effect of ends out of the forces.
    pub(super) without_ends: Option<PathBuf>,
    /// That strokes lie beyond those from which its empirical terms were made.
    beyond_terms: Option<String>,
}

impl Files {
    /// A table and its campaign, with nothing taken out of the forces.
    #[cfg(not(target_family = "wasm"))]
    pub(super) const fn of(table: StrokeTable, campaign: Campaign) -> Self {
        Self { table, campaign, without_ends: None, beyond_terms: None }
    }

    pub(super) fn read(request: &Request, exact: bool) -> Result<Self, AppError> {
        let mut table = request.file.strokes(ReadOptions { allow_zero_sd: exact })?;
        let (mut without_ends, mut beyond_terms) = (None, None);
        if let Some(path) = &request.model_file {
            let model = Loaded::read(path)?;
            beyond_terms = terms::beyond(&model, table.rows());
            table = without_effects(&table, &model)?;
            let is_of_ends = |active: &Active| active.effect.id == EffectId::SideEffects3d;
            without_ends = model.effects().iter().any(is_of_ends).then(|| path.clone());
        }
        Ok(Self { table, campaign: request.file.campaign()?, without_ends, beyond_terms })
    }
}

/// Tool angles from which failure is mostly gradual, in degrees.
const HIGH_ANGLE_DEG: f64 = 90.0;

impl Inputs {
    /// What is known by a force model. Exact data need no standard deviations.
    pub(super) fn new(
        request: &Request,
        files: &Files,
        exact: bool,
        model: &dyn ForceModel,
    ) -> Result<Self, AppError> {
        let Files { table, campaign, .. } = files;
        let confidence = match request.band_kind()? {
            BandKind::Joint(confidence) => Some(confidence),
            BandKind::AsTold(confidence) => bands::tells_scatter(request, table).then_some(confidence),
            BandKind::Own => None,
        };
        let bands = match confidence {
            Some(confidence) => Some(bands::bands(request, table, campaign, model, confidence)?),
            None => None,
        };
        let measurements = match &bands {
            Some(bands) => bands.measurements.clone(),
            None => with_depth(table, exact)?,
        };
        let mut warnings = bands.as_ref().map(|bands| bands.warnings.clone()).unwrap_or_default();
        let (low, high) = match (request.delta_deg, bands.as_ref().and_then(|bands| bands.friction_deg)) {
            (NumberOrColumn::Column, Some(friction_deg)) => (friction_deg, friction_deg),
            _ => spread(request, request.delta_deg, "delta", &measurements, |m| m.delta_set_deg)?,
        };
        let mut delta_deg = (low - request.delta_tol_deg, high + request.delta_tol_deg);
        if low < 0.0 {
            return Err(AppError::Request(format!("--delta is {low} deg; it must be at least 0 deg")));
        }
        if delta_deg.0 < 0.0 {
            delta_deg.0 = 0.0;
            warnings.push("the interval of delta is cut at 0 deg: friction is not negative".into());
        }
        let density_kg_m3 = match request.density_kg_m3 {
            None => None,
            Some(choice) => {
                let (low, high) = spread(request, choice, "density", &measurements, |m| m.density_kg_m3)?;
                Some((low * (1.0 - request.density_tol), high * (1.0 + request.density_tol)))
            }
        };
        let of_one_angle =
            |m: &Measurement| (m.alpha_deg - measurements[0].alpha_deg).abs() <= bands::SAME_ALPHA_DEG;
        if measurements.iter().all(of_one_angle) {
            warnings.push(
                "all strokes are at one tool angle, which cannot tell friction angle from density; add strokes at \
                 other tool angles"
                    .into(),
            );
        }
        warnings.extend(files.beyond_terms.clone());
        Ok(Self { measurements, bands, campaign: campaign.clone(), delta_deg, density_kg_m3, warnings })
    }

    /// The setup of the estimator.
    pub(super) fn setup<'m>(
        &self,
        request: &Request,
        model: &'m dyn ForceModel,
    ) -> Result<Setup<'m>, AppError> {
        let all = self.measurements.iter().enumerate();
        let observations = all.map(|(place, m)| observation(request, m, self.band(place)));
        let observations = observations.collect::<Result<_, _>>()?;
        let mut setup = Setup::new(model, observations, self.delta_deg);
        setup.density_kg_m3 = self.density_kg_m3;
        setup.phi_search_deg = request.phi_range_deg;
        setup.gravity_m_s2 = request.loads.gravity_m_s2;
        setup.loads = request.loads.into();
        setup.unknowns = request.intervals.unknowns(&request.loads);
        setup.end_tolerance = request.end_tolerance;
        law::add(&mut setup, request)?;
        Ok(setup)
    }

    /// The band of a measurement, where strokes of one kind are taken together.
    pub(super) fn band(&self, place: usize) -> Option<&PooledBand> {
        self.bands.as_ref().and_then(|bands| bands.pool.bands.get(place))
    }

    /// What a band is, in words.
    #[must_use]
    pub fn band_in_words(&self, request: &Request) -> String {
        match (&self.bands, request.uncertainty) {
            (Some(bands), _) => {
                format!("bands of {} % together", crate::text::number(100.0 * bands.confidence))
            }
            (None, Uncertainty::Sigma) => {
                format!("bands of {} σ", crate::text::number(request.deviations()))
            }
            (None, Uncertainty::Bounds) => "bands between hard bounds".into(),
        }
    }

    /// Deltas at which sections are shown.
    pub(super) fn sections(&self, request: &Request) -> Vec<f64> {
        if !request.sections_deg.is_empty() {
            return request.sections_deg.clone();
        }
        let (low, high) = self.delta_deg;
        if low == high { vec![low] } else { vec![low, f64::midpoint(low, high), high] }
    }
}

/// The forces that would have been read without the effects of a model file.
fn without_effects(table: &StrokeTable, model: &Loaded) -> Result<StrokeTable, AppError> {
    let rows = table
        .rows()
        .map(|row| {
            let ratio = model.plain_force_n(&row)? / model.force_n(&row)?;
            let force_sd_n = row.force_sd_n.map(|sd| sd * ratio);
            Ok(StrokeRow { force_n: row.force_n * ratio, force_sd_n, ..row })
        })
        .collect::<Result<Vec<_>, AppError>>()?;
    Ok(StrokeTable::new(table.name(), &rows)?)
}

/// Measurements by their own deviations. What a table says of the uncertainty of its depths belongs to them.
fn with_depth(table: &StrokeTable, exact: bool) -> Result<Vec<Measurement>, AppError> {
    if exact {
        return Ok(measurements(table, Deviations::ExactAllowed)?);
    }
    let mut rows: Vec<StrokeRow> = table.rows().collect();
    if rows.iter().all(|row| row.depth_sd_m.is_none()) {
        return Ok(measurements(table, Deviations::Required)?);
    }
    for row in &mut rows {
        // The force goes with the square of the depth.
        let by_depth_n = 2.0 * row.force_n * row.depth_sd_m.unwrap_or(0.0) / row.depth_m;
        row.force_sd_n = row.force_sd_n.map(|sd| sd.hypot(by_depth_n));
    }
    Ok(measurements(&StrokeTable::new(table.name(), &rows)?, Deviations::Required)?)
}

fn observation(
    request: &Request,
    m: &Measurement,
    band: Option<&PooledBand>,
) -> Result<Observation, AppError> {
    let alpha = Angle::from_degrees(m.alpha_deg);
    let plate = Plate::new(alpha, Angle::from_degrees(request.loads.beta_deg), m.depth_m, m.width_m)?;
    let observation = match (band, request.uncertainty) {
        (Some(band), _) => Observation::from_bounds(&m.label, plate, band.force_n, band.low_n, band.high_n)?,
        (None, Uncertainty::Sigma) => {
            Observation::new(&m.label, plate, m.force_n, request.deviations() * m.force_sd_n)?
        }
        (None, Uncertainty::Bounds) if m.count == 1 => {
            Observation::new(&m.label, plate, m.force_n, m.force_sd_n)?
        }
        (None, Uncertainty::Bounds) => {
            Observation::from_bounds(&m.label, plate, m.force_n, m.force_min_n, m.force_max_n)?
        }
    };
    let high = m.alpha_deg >= HIGH_ANGLE_DEG && request.adjust_high_angles > 0.0;
    Ok(if high { observation.read_low_by(request.adjust_high_angles) } else { observation })
}

/// Least and greatest value of an option, or of the column that it names.
fn spread(
    request: &Request,
    choice: NumberOrColumn,
    option: &str,
    measurements: &[Measurement],
    column: impl Fn(&Measurement) -> Option<f64>,
) -> Result<(f64, f64), AppError> {
    if let Some(value) = choice.number() {
        return Ok((value, value));
    }
    let mut ends: Option<(f64, f64)> = None;
    for m in measurements {
        let value = column(m).ok_or_else(|| {
            AppError::Request(format!(
                "{}, line {}: --{option} column, which is the default of --delta, needs a value in every row of that column; \
                 fill the cell or give a number, such as --{option} {}",
                request.file.name(),
                m.lines.first().copied().unwrap_or_default(),
                if option == "delta" { "23" } else { "1600" }
            ))
        })?;
        ends = Some(ends.map_or((value, value), |(low, high)| (low.min(value), high.max(value))));
    }
    ends.ok_or_else(|| AppError::Request(format!("{} has no rows", request.file.name())))
}
