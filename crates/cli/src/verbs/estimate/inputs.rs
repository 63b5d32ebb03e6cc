//! From options and a stroke table to the estimator's setup.

use soilctl_earth_pressure::{ForceModel, Loads};
use soilctl_effects::Loaded;
use soilctl_estimator::{Observation, Setup};
use soilctl_soil::{Angle, Plate};
use soilctl_strokes::{
    Campaign, Measurement, ReadOptions, StrokeRow, StrokeTable, Uncertainty as Deviations, measurements,
};

use super::args::{EstimateArgs, Uncertainty};
use crate::args::NumberOrColumn;
use crate::error::CliError;

/// What was read.
pub(crate) struct Inputs {
    pub(crate) measurements: Vec<Measurement>,
    pub(crate) campaign: Campaign,
    pub(crate) delta_deg: (f64, f64),
    pub(crate) density_kg_m3: Option<(f64, f64)>,
    pub(crate) warnings: Vec<String>,
}

/// Tool angles from which failure is mostly gradual, in degrees.
const HIGH_ANGLE_DEG: f64 = 90.0;

impl Inputs {
    /// Reads the table and what is known beside it. Exact data need no standard deviations.
    pub(crate) fn read(args: &EstimateArgs, exact: bool) -> Result<Self, CliError> {
        at_least("delta-tol", args.delta_tol, 0.0, "deg")?;
        at_least("adjust-high-angles", args.adjust_high_angles, 0.0, "")?;
        args.sigma()?;
        if !(0.0..1.0).contains(&args.density_tol) {
            return Err(CliError::Usage(format!(
                "--density-tol is {}; it must be at least 0 and below 1 (0.04 is 4 %)",
                args.density_tol
            )));
        }
        let mut table = StrokeTable::read(&args.file, ReadOptions { allow_zero_sd: exact })?;
        if let Some(path) = &args.model_file {
            table = without_effects(&table, &Loaded::read(path)?)?;
        }
        let wanted = if exact { Deviations::ExactAllowed } else { Deviations::Required };
        let measurements = measurements(&table, wanted)?;
        let campaign = Campaign::read_beside(&args.file)?.unwrap_or_default();
        let mut warnings = Vec::new();
        let (low, high) = spread(args, args.delta, "delta", &measurements, |m| m.delta_set_deg)?;
        let mut delta_deg = (low - args.delta_tol, high + args.delta_tol);
        if low < 0.0 {
            return Err(CliError::Usage(format!("--delta is {low} deg; it must be at least 0 deg")));
        }
        if delta_deg.0 < 0.0 {
            delta_deg.0 = 0.0;
            warnings.push("the interval of delta is cut at 0 deg: friction is not negative".into());
        }
        let density_kg_m3 = match args.density {
            None => None,
            Some(choice) => {
                let (low, high) = spread(args, choice, "density", &measurements, |m| m.density_kg_m3)?;
                Some((low * (1.0 - args.density_tol), high * (1.0 + args.density_tol)))
            }
        };
        let angle = |m: &Measurement| m.alpha_deg.to_bits();
        if measurements.iter().all(|m| angle(m) == angle(&measurements[0])) {
            warnings.push(
                "all strokes are at one tool angle, which cannot tell friction angle from density; add strokes at \
                 other tool angles"
                    .into(),
            );
        }
        Ok(Self { measurements, campaign, delta_deg, density_kg_m3, warnings })
    }

    /// The setup of the estimator.
    pub(crate) fn setup<'m>(
        &self,
        args: &EstimateArgs,
        model: &'m dyn ForceModel,
    ) -> Result<Setup<'m>, CliError> {
        let observations =
            self.measurements.iter().map(|m| observation(args, m)).collect::<Result<_, _>>()?;
        let mut setup = Setup::new(model, observations, self.delta_deg);
        setup.density_kg_m3 = self.density_kg_m3;
        setup.phi_search_deg = args.phi_range;
        setup.gravity_m_s2 = args.loads.gravity;
        setup.loads = Loads {
            cohesion_pa: args.loads.cohesion,
            adhesion_pa: args.loads.adhesion,
            surcharge_pa: args.loads.surcharge,
        };
        Ok(setup)
    }

    /// Deltas at which sections are shown.
    pub(crate) fn sections(&self, args: &EstimateArgs) -> Vec<f64> {
        if !args.sections.is_empty() {
            return args.sections.clone();
        }
        let (low, high) = self.delta_deg;
        if low == high { vec![low] } else { vec![low, f64::midpoint(low, high), high] }
    }
}

/// The forces that would have been read without the effects of a model file.
fn without_effects(table: &StrokeTable, model: &Loaded) -> Result<StrokeTable, CliError> {
    let rows = table
        .rows()
        .map(|row| {
            let ratio = model.plain_force_n(&row)? / model.force_n(&row)?;
            let force_sd_n = row.force_sd_n.map(|sd| sd * ratio);
            Ok(StrokeRow { force_n: row.force_n * ratio, force_sd_n, ..row })
        })
        .collect::<Result<Vec<_>, CliError>>()?;
    Ok(StrokeTable::new(table.name(), &rows)?)
}

fn observation(args: &EstimateArgs, m: &Measurement) -> Result<Observation, CliError> {
    let alpha = Angle::from_degrees(m.alpha_deg);
    let plate = Plate::new(alpha, Angle::from_degrees(args.loads.beta), m.depth_m, m.width_m)?;
    let observation = match args.uncertainty {
        Uncertainty::Sigma => Observation::new(&m.label, plate, m.force_n, args.sigma()? * m.force_sd_n)?,
        Uncertainty::Bounds if m.count == 1 => Observation::new(&m.label, plate, m.force_n, m.force_sd_n)?,
        Uncertainty::Bounds => {
            Observation::from_bounds(&m.label, plate, m.force_n, m.force_min_n, m.force_max_n)?
        }
    };
    let high = m.alpha_deg >= HIGH_ANGLE_DEG && args.adjust_high_angles > 0.0;
    Ok(if high { observation.read_low_by(args.adjust_high_angles) } else { observation })
}

/// Least and greatest value of an option, or of the column that it names.
fn spread(
    args: &EstimateArgs,
    choice: NumberOrColumn,
    option: &str,
    measurements: &[Measurement],
    column: impl Fn(&Measurement) -> Option<f64>,
) -> Result<(f64, f64), CliError> {
    if let Some(value) = choice.number() {
        return Ok((value, value));
    }
    let mut ends: Option<(f64, f64)> = None;
    for m in measurements {
        let value = column(m).ok_or_else(|| {
            CliError::Usage(format!(
                "{}, line {}: --{option} column needs a value in every row of that column; fill the cell or give \
                 a number",
                args.file.display(),
                m.lines.first().copied().unwrap_or_default()
            ))
        })?;
        ends = Some(ends.map_or((value, value), |(low, high)| (low.min(value), high.max(value))));
    }
    ends.ok_or_else(|| CliError::Usage(format!("{} has no rows", args.file.display())))
}

fn at_least(option: &str, value: f64, least: f64, unit: &str) -> Result<(), CliError> {
    if value >= least {
        return Ok(());
    }
    Err(CliError::Usage(format!("--{option} is {value} {unit}; it must be at least {least}")))
}
