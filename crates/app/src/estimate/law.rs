//! Friction as a law of stress: what a request knows of it, and what an estimate says of it.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_direct_shear::{ShearPoint, ShearSeries};
use soilctl_estimator::{
    Estimate, FrictionLaw, Ring, Setup, ShearBand, Slice, estimate, shear_alone, slip_stress_pa,
};

use super::request::Request;
use crate::AppError;
use crate::text::to_two_digits;

/// Friction angle at which the stresses of strokes are judged where nothing else is known, in degrees: a sand's.
const SAND_DEG: f64 = 38.0;

/// Adds the law of a request to a setup; nothing if it has none.
///
/// # Errors
/// [`AppError`] if something is asked that needs a law, or knows none, or the tests in direct shear cannot be read.
pub(super) fn add(setup: &mut Setup<'_>, request: &Request) -> Result<(), AppError> {
    let Some(slope_deg_per_decade) = request.friction_law else {
        return needs_a_law(request);
    };
    let reference_stress_pa = match request.reference_stress_pa {
        Some(stress) => stress,
        None => middle_pa(setup)?,
    };
    setup.friction_law = Some(FrictionLaw { slope_deg_per_decade, reference_stress_pa });
    if let Some(table) = &request.shear_box {
        let series = table.shear_points()?;
        let points = chosen(&series, request.shear_soil.as_deref())?;
        let band = |point: &ShearPoint| {
            let phi = point.friction().degrees();
            let friction_deg = [phi - request.shear_tol_deg, phi + request.shear_tol_deg];
            ShearBand { stress_pa: point.normal_stress_pa(), friction_deg }
        };
        setup.shear_tests = points.iter().map(band).collect();
    }
    Ok(())
}

fn needs_a_law(request: &Request) -> Result<(), AppError> {
    let given = [
        ("--reference-stress", request.reference_stress_pa.is_some()),
        ("--shear-box", request.shear_box.is_some()),
        ("--shear-soil", request.shear_soil.is_some()),
    ];
    match given.iter().find(|(_, given)| *given) {
        Some((option, _)) => {
            Err(AppError::Request(format!("{option} has no meaning without --friction-law")))
        }
        None => Ok(()),
    }
}

/// The tests of one soil.
fn chosen<'s>(series: &'s [ShearSeries], soil: Option<&str>) -> Result<&'s [ShearPoint], AppError> {
    let names = || series.iter().filter_map(|s| s.soil.as_deref()).collect::<Vec<_>>().join(", ");
    let found = match soil {
        Some(name) => series.iter().find(|s| s.soil.as_deref() == Some(name)).ok_or_else(|| {
            format!("--shear-soil {name} is not in the table of direct shear; it has {}", names())
        }),
        None => match series {
            [only] => Ok(only),
            _ => Err(format!(
                "the table of direct shear has several soils; choose one by --shear-soil: {}",
                names()
            )),
        },
    };
    found.map(|series| &series.points[..]).map_err(AppError::Request)
}

/// The geometric middle of the stresses in the strokes, to two digits.
fn middle_pa(setup: &Setup<'_>) -> Result<f64, AppError> {
    let (low, high) = setup.phi_range_deg();
    let stresses = slip_stress_pa(setup, [SAND_DEG.clamp(low, high); 2]);
    let known: Vec<f64> = stresses.into_iter().flatten().flatten().map(libm::log10).collect();
    if known.is_empty() {
        return Err(AppError::Request(
            "the normal stress in these strokes is not known: no mechanism fits their tool angles; give --reference-stress"
                .into(),
        ));
    }
    let middle = known.iter().sum::<f64>() / known.len() as f64;
    Ok(to_two_digits(libm::pow(10.0, middle)))
}

/// Friction as a law of stress: `phi = phi_ref - slope log10(sigma / sigma_ref)`, and the soils that have it.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LawAnswer {
    /// Consistent slopes (deg a decade); null if no soil is consistent.
    pub slope_deg_per_decade: Option<[f64; 2]>,
    /// What was known of the slope (deg a decade).
    pub slope_known_deg_per_decade: [f64; 2],
    /// The consistent soils by slices of the slope, growing; empty if there are none.
    pub slices: Vec<LawSlice>,
    /// What the strokes say without the tests in direct shear; null without such tests.
    pub plates_alone: Option<LawRange>,
    /// What the tests in direct shear say without the strokes; null without such tests, or if no law of the known slopes passes through all.
    pub shear_alone: Option<LawRange>,
    /// Tests in direct shear that were taken.
    pub shear_tests: Vec<ShearTest>,
}

/// The consistent soils whose slope is in a slice.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LawSlice {
    /// Slopes of the slice (deg a decade).
    pub slope_deg_per_decade: [f64; 2],
    /// Range of the friction angle at the reference stress (deg).
    pub phi_deg: [f64; 2],
    /// Range of the density (kg/m3).
    pub density_kg_m3: [f64; 2],
    /// Consistent [phi at the reference stress, density]: polygons, each an outer ring and its holes.
    pub region: Vec<Vec<Ring>>,
}

/// Ranges of the unknowns of a law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LawRange {
    /// Friction angle at the reference stress (deg).
    pub phi_deg: [f64; 2],
    /// Slope (deg a decade).
    pub slope_deg_per_decade: [f64; 2],
}

/// A test in direct shear.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ShearTest {
    /// Normal stress (Pa).
    pub stress_pa: f64,
    /// Friction angles that it allows (deg).
    pub friction_deg: [f64; 2],
}

impl From<&Slice> for LawSlice {
    fn from(slice: &Slice) -> Self {
        Self {
            slope_deg_per_decade: slice.slope_deg_per_decade,
            phi_deg: slice.phi_deg,
            density_kg_m3: slice.density_kg_m3,
            region: slice.region.polygons().to_vec(),
        }
    }
}

fn range_of(estimate: &Estimate) -> Option<LawRange> {
    let (first, last) = (estimate.slices.first()?, estimate.slices.last()?);
    let slope_deg_per_decade = [first.slope_deg_per_decade[0], last.slope_deg_per_decade[1]];
    Some(LawRange { phi_deg: estimate.phi_deg?, slope_deg_per_decade })
}

impl LawAnswer {
    /// What an estimate says; `None` without a law.
    pub(super) fn of(setup: &Setup<'_>, found: &Estimate) -> Result<Option<Self>, AppError> {
        let Some(law) = &setup.friction_law else { return Ok(None) };
        let has_tests = !setup.shear_tests.is_empty();
        let plates_alone = if has_tests {
            range_of(&estimate(&Setup { shear_tests: Vec::new(), ..setup.clone() })?)
        } else {
            None
        };
        let of_shear = |(phi_deg, slope_deg_per_decade)| LawRange { phi_deg, slope_deg_per_decade };
        Ok(Some(Self {
            slope_deg_per_decade: range_of(found).map(|range| range.slope_deg_per_decade),
            slope_known_deg_per_decade: law.slope_deg_per_decade.into(),
            slices: found.slices.iter().map(LawSlice::from).collect(),
            plates_alone,
            shear_alone: if has_tests { shear_alone(setup).map(of_shear) } else { None },
            shear_tests: setup
                .shear_tests
                .iter()
                .map(|band| ShearTest { stress_pa: band.stress_pa, friction_deg: band.friction_deg })
                .collect(),
        }))
    }
}
