use crate::cover::{cover, cover_section};
use crate::end_factor::EndFactors;
use crate::joint::{self, Joint, Quantity, Unknowns};
use crate::piece::Piece;
use crate::region::Region;
use crate::sliced::sliced;
use crate::{EstimatorError, FrictionLaw, Setup};

/// Every soil that could have produced the measurements; the default is that none could.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Estimate {
    /// Consistent (phi in degrees, density in kg/m3), over the whole interval of delta.
    pub region: Region,
    /// Range of phi in degrees; `None` if no soil is consistent.
    pub phi_deg: Option<[f64; 2]>,
    /// Range of density in kg/m3; `None` if no soil is consistent.
    pub density_kg_m3: Option<[f64; 2]>,
    /// Where the region was cut by the limits of the search rather than by a measurement.
    pub limits: Limits,
    /// Consistent values of the end factor that strokes share, enclosed in steps of 1/32; `None` if they share none, or no soil
    /// is consistent.
    pub end_factor: Option<[f64; 2]>,
    /// The consistent set by slope of the law of stress, in slices of growing slope; empty without a law, or if no soil is consistent.
    pub slices: Vec<Slice>,
    /// What is left of all unknowns, where cohesion, adhesion, surcharge or slope are among them; otherwise `None`.
    pub joint: Option<Joint>,
}

/// The consistent soils whose friction falls with stress by slopes of an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// Slopes in degrees a decade.
    pub slope_deg_per_decade: [f64; 2],
    /// Range of the friction angle at the reference stress in degrees.
    pub phi_deg: [f64; 2],
    /// Range of density in kg/m3.
    pub density_kg_m3: [f64; 2],
    /// Consistent (phi at the reference stress in degrees, density in kg/m3).
    pub region: Region,
}

/// The consistent set seen along the other two axes, and its volume; empty and 0 if delta is known exactly.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Projections {
    /// Consistent (delta in degrees, density in kg/m3).
    pub delta_density: Region,
    /// Consistent (phi, delta) in degrees.
    pub phi_delta: Region,
    /// Volume of the consistent set in deg2 kg/m3; by quadrature where strokes share an end factor, otherwise exact for the cover. `None`
    /// under a law of stress, which has one unknown more.
    pub volume: Option<f64>,
}

/// Which limits of the search the region touches: its true extent there may be larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Limits {
    /// Least friction angle searched.
    pub phi_low: bool,
    /// Greatest friction angle searched.
    pub phi_high: bool,
    /// Least density searched, with the density unknown.
    pub density_low: bool,
    /// Greatest density searched, with the density unknown.
    pub density_high: bool,
}

impl Limits {
    /// Whether any limit is touched.
    #[must_use]
    pub const fn any(self) -> bool {
        self.phi_low || self.phi_high || self.density_low || self.density_high
    }
}

impl Estimate {
    /// Whether any soil is consistent with all measurements.
    #[must_use]
    pub fn is_consistent(&self) -> bool {
        !self.region.is_empty()
    }
}

/// Intersects the bands of all measurements (Hong 2001, section 7.3) over the whole interval of delta.
///
/// The result encloses the consistent set: boundaries are moved outwards by at most 0.03 % in density (0.003 deg
/// where forces grow by 10 % a degree), never inwards.
///
/// # Errors
/// [`EstimatorError`] if there is no measurement, an interval is not within the model's range, or the model refuses
/// a tool angle or a load.
pub fn estimate(setup: &Setup<'_>) -> Result<Estimate, EstimatorError> {
    setup.check()?;
    if let Some(unknowns) = &setup.unknowns {
        return with_unknowns(setup, unknowns);
    }
    let found = sliced(setup, cover)?;
    let pieces = || found.iter().flat_map(|(_, pieces)| pieces);
    let region = region_of(pieces());
    let bounds = region.bounds();
    Ok(Estimate {
        phi_deg: bounds.map(|b| b.0),
        density_kg_m3: bounds.map(|b| b.1),
        limits: bounds.map_or_else(Limits::default, |b| touched(setup, b)),
        end_factor: pieces()
            .map(Piece::ends)
            .reduce(EndFactors::hull)
            .filter(|_| setup.shares_ends())
            .map(|ends| [ends.low, ends.high]),
        slices: found.iter().filter_map(|(law, pieces)| slice(law.as_ref()?, pieces)).collect(),
        region,
        joint: None,
    })
}

/// The estimate of a setup with unknowns beside friction and density.
fn with_unknowns(setup: &Setup<'_>, unknowns: &Unknowns) -> Result<Estimate, EstimatorError> {
    let joint = joint::joint(setup, unknowns)?;
    let bounds = joint.range(Quantity::Friction).zip(joint.range(Quantity::Density));
    Ok(Estimate {
        region: joint.pair(Quantity::Friction, Quantity::Density),
        phi_deg: bounds.map(|b| b.0),
        density_kg_m3: bounds.map(|b| b.1),
        limits: bounds.map_or_else(Limits::default, |b| touched(setup, b)),
        joint: Some(joint),
        ..Estimate::default()
    })
}

fn slice(law: &FrictionLaw, pieces: &[Piece]) -> Option<Slice> {
    let region = region_of(pieces);
    let (phi_deg, density_kg_m3) = region.bounds()?;
    let (low, high) = law.slope_deg_per_decade;
    Some(Slice { slope_deg_per_decade: [low, high], phi_deg, density_kg_m3, region })
}

/// The other two projections of the set behind [`estimate`], and its volume.
///
/// # Errors
/// As [`estimate`].
pub fn projections(setup: &Setup<'_>) -> Result<Projections, EstimatorError> {
    setup.check()?;
    setup.check_known_loads("the volume of the consistent set")?;
    if setup.delta_deg.0 == setup.delta_deg.1 {
        return Ok(Projections::default());
    }
    let found = sliced(setup, cover)?;
    let pieces = || found.iter().flat_map(|(_, pieces)| pieces);
    // An empty sum is -0.
    let volume =
        |pieces: &[Piece]| pieces.chunk_by(Piece::beside).map(Piece::volume_together).sum::<f64>() + 0.0;
    Ok(Projections {
        delta_density: Region::of_angle_and_density(pieces().map(|p| (p.delta_strip(), p.shadow(1)))),
        phi_delta: Region::of_angles(pieces().map(|p| (p.phi_strip(), p.base().to_vec()))),
        volume: match &found[..] {
            [(None, pieces)] => Some(volume(pieces)),
            _ => None,
        },
    })
}

/// The consistent (phi, density) alone: what [`estimate`] calls `region`.
pub(crate) fn region_only(setup: &Setup<'_>) -> Result<Region, EstimatorError> {
    Ok(region_of(sliced(setup, cover)?.iter().flat_map(|(_, pieces)| pieces)))
}

fn region_of<'p>(pieces: impl IntoIterator<Item = &'p Piece>) -> Region {
    Region::of_angle_and_density(pieces.into_iter().map(|p| (p.phi_strip(), p.shadow(0))))
}

/// Whether any soil is consistent: the cheapest question.
pub(crate) fn is_consistent(setup: &Setup<'_>) -> Result<bool, EstimatorError> {
    if let Some(unknowns) = &setup.unknowns {
        return joint::may_be_consistent(setup, unknowns);
    }
    Ok(sliced(setup, cover)?.iter().any(|(_, pieces)| !pieces.is_empty()))
}

/// The consistent (phi, density) at one delta in degrees.
///
/// # Errors
/// As [`estimate`].
pub fn section(setup: &Setup<'_>, delta_deg: f64) -> Result<Region, EstimatorError> {
    let setup = Setup { delta_deg: (delta_deg, delta_deg), ..setup.clone() };
    setup.check()?;
    setup.check_known_loads("a section at one interface friction")?;
    let found = sliced(&setup, |setup, constraints| cover_section(setup, constraints, delta_deg))?;
    Ok(region_of(found.iter().flat_map(|(_, pieces)| pieces)))
}

/// The band of each measurement alone at one delta: consistent (phi, density), in the order of the observations.
///
/// # Errors
/// As [`estimate`].
pub fn bands(setup: &Setup<'_>, delta_deg: f64) -> Result<Vec<Region>, EstimatorError> {
    setup.check()?;
    setup
        .observations
        .iter()
        .map(|observation| {
            let alone = Setup { density_kg_m3: None, ..setup.with_observations(vec![observation.clone()]) };
            section(&alone, delta_deg)
        })
        .collect()
}

fn touched(setup: &Setup<'_>, (phi, density): ([f64; 2], [f64; 2])) -> Limits {
    let range = setup.phi_range_deg();
    let (low, high) = setup.density_range_kg_m3();
    let free = setup.density_kg_m3.is_none();
    let of_strokes = strokes_touch(setup, phi);
    Limits {
        phi_low: phi[0] <= range.0.max(setup.delta_deg.0) + 1e-5 || of_strokes[0],
        phi_high: phi[1] >= range.1 - 1e-5 || of_strokes[1],
        density_low: free && density[0] <= low * (1.0 + 1e-6),
        density_high: free && density[1] >= high * (1.0 - 1e-6),
    }
}

/// Whether the friction of a stroke, which under a law of stress is another than at the reference, touches the model's range.
fn strokes_touch(setup: &Setup<'_>, phi: [f64; 2]) -> [bool; 2] {
    let Some(law) = &setup.friction_law else { return [false; 2] };
    let model = setup.model.valid_range().phi_deg;
    let mut touched = [false; 2];
    for observation in &setup.observations {
        let level = setup.stress_level(observation);
        let at = |phi: f64| level.friction_deg(law, phi, setup.delta_deg.0);
        let (Some(low), Some(high)) = (at(phi[0]), at(phi[1])) else { return [true; 2] };
        touched[0] |= low[0] <= model.0 + 1e-5;
        touched[1] |= high[1] >= model.1 - 1e-5;
    }
    touched
}
