//! Direct shear at the stresses of the strokes, beside the estimate (Hong 2001, Table 7.3 and figure 7-12).

use std::path::Path;

use soilctl_direct_shear::{
    LogLogFit, PointDepth, ShearSeries, StrokeLoad, friction_at_stroke, read_shear_points,
};
use soilctl_soil::{Angle, Stroke};

use crate::AppError;
use crate::estimate::Estimation;

/// Depths of the points considered, as fractions of the plate's depth.
const FRACTIONS: [(f64, &str); 2] = [(0.5, "1/2"), (2.0 / 3.0, "2/3")];

/// Friction angles of direct shear at the stresses of all strokes.
#[derive(Debug, Clone)]
pub struct ShearRange {
    /// Depth of the point beside the plate as a fraction of the plate's, in words.
    pub fraction: &'static str,
    /// Lowest and highest friction angle (deg).
    pub friction_deg: [f64; 2],
    /// Whether it shares an angle with the estimate.
    pub overlaps: bool,
}

/// Direct shear beside the estimate.
#[derive(Debug, Clone)]
pub struct ShearComparison {
    /// The power law through the tests.
    pub fit: LogLogFit,
    /// Range of the estimate (deg).
    pub estimate_deg: [f64; 2],
    /// Ranges of direct shear, by depth of the point.
    pub ranges: Vec<ShearRange>,
    /// Lowest tested normal stress (Pa) if a stroke's stresses lie outside the tested ones.
    pub extrapolated_below_pa: Option<f64>,
}

/// `None` if no soil is consistent.
pub(super) fn compare(
    file: &Path,
    soil: Option<&String>,
    estimation: &Estimation,
) -> Result<Option<ShearComparison>, AppError> {
    let series = chosen(file, soil)?;
    let fit = LogLogFit::fit(&series.points)?;
    let (Some(phi), Some(centre)) = (estimation.answer.phi_deg, estimation.answer.centre) else {
        return Ok(None);
    };
    let setup = estimation.setup()?;
    let delta = Angle::from_degrees(f64::midpoint(setup.delta_deg.0, setup.delta_deg.1));
    let unit_weight = centre.density_kg_m3 * setup.gravity_m_s2;
    let (mut ranges, mut extrapolated) = (Vec::new(), false);
    for (depth, fraction) in FRACTIONS {
        let [mut low, mut high] = [f64::MAX, f64::MIN];
        for o in &setup.observations {
            let stroke = Stroke::new(*o.plate(), o.force_n())?;
            let load = StrokeLoad::new(&stroke, unit_weight, delta, PointDepth::FractionOfPlate(depth))?;
            let found = friction_at_stroke(&fit, &load, Angle::from_degrees(centre.phi_deg))?;
            low = low.min(found.lowest_friction.degrees());
            high = high.max(found.highest_friction.degrees());
            extrapolated |= found.low_extrapolated || found.high_extrapolated;
        }
        let overlaps = low <= phi[1] && phi[0] <= high;
        ranges.push(ShearRange { fraction, friction_deg: [low, high], overlaps });
    }
    let lowest_tested = series.points.iter().map(|p| p.normal_stress_pa()).fold(f64::MAX, f64::min);
    let extrapolated_below_pa = extrapolated.then_some(lowest_tested);
    Ok(Some(ShearComparison { fit, estimate_deg: phi, ranges, extrapolated_below_pa }))
}

fn chosen(file: &Path, soil: Option<&String>) -> Result<ShearSeries, AppError> {
    let series = read_shear_points(file)?;
    let names: Vec<String> = series.iter().filter_map(|s| s.soil.clone()).collect();
    let found = match soil {
        None if series.len() == 1 => series.into_iter().next(),
        None => None,
        Some(name) => series.into_iter().find(|s| s.soil.as_ref() == Some(name)),
    };
    found.ok_or_else(|| {
        AppError::Request(format!(
            "{} holds the soils {}; choose one of them with --soil",
            file.display(),
            names.join(", ")
        ))
    })
}
