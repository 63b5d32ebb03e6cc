//! Every soil that explains the measurements, as plain data.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_estimator::{Candidate, Estimate, Fit, LocalMinimum, Observation, Optimiser, Ring};
use soilctl_strokes::PooledBand;

use super::{ExactAnswer, LawAnswer, UnknownsAnswer};
use crate::Outcome;
use crate::request::Ends;

/// A section of the consistent set at one interface friction.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Section {
    /// Interface friction (deg).
    pub delta_deg: f64,
    /// Rings of [phi (deg), density (kg/m3)], by the even-odd rule; the first point is not repeated.
    pub polygons: Vec<Ring>,
}

/// One measurement as the estimator saw it.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Measured {
    /// Name.
    pub label: String,
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Vertical depth (m).
    pub depth_m: f64,
    /// Failure force (N).
    pub force_n: f64,
    /// Lower end of its interval (N).
    pub force_low_n: f64,
    /// Upper end of its interval (N).
    pub force_high_n: f64,
    /// Strokes behind it.
    pub strokes: usize,
    /// Equivalent normal stress on its slip surfaces (Pa), at which the soil has the friction that it measured; null if no soil is
    /// consistent, or no mechanism fits the tool angle, or loads or slope are unknowns.
    pub slip_stress_pa: Option<[f64; 2]>,
    /// How the band came about, where strokes of one kind are taken together; otherwise null.
    pub pooled: Option<Pooled>,
}

/// How a band of strokes of one kind came about. Deviations are relative.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Pooled {
    /// Standard deviation of one stroke by the scatter of these; null of a single stroke.
    pub scatter: Option<f64>,
    /// Standard deviation of one stroke by what the table says of force, depth and friction on the plate; null if it says nothing.
    pub stated: Option<f64>,
    /// Standard error of the mean.
    pub mean: f64,
    /// Standard deviation of what the strokes share: the sensor's gain, the datum of depths, density, the soil ahead.
    pub common: f64,
    /// So many of both together the band reaches on either side, in the logarithm of the force.
    pub deviations: f64,
}

impl Pooled {
    /// Its deviations in the order of the fields, as tables show them; nothing where one is not known.
    #[must_use]
    pub const fn shares(&self) -> [Option<f64>; 4] {
        [self.scatter, self.stated, Some(self.mean), Some(self.common)]
    }
}

impl Measured {
    pub(super) fn of(
        observation: &Observation,
        strokes: usize,
        slip_stress_pa: Option<[f64; 2]>,
        band: Option<&PooledBand>,
    ) -> Self {
        let pooled = band.map(|band| Pooled {
            scatter: band.scatter_rel,
            stated: band.stated_rel,
            mean: band.mean_rel,
            common: band.common_rel,
            deviations: band.deviations,
        });
        Self {
            label: observation.label().into(),
            alpha_deg: observation.plate().tool_angle().degrees(),
            depth_m: observation.plate().depth_m(),
            force_n: observation.force_n(),
            force_low_n: observation.low_n(),
            force_high_n: observation.high_n(),
            strokes,
            slip_stress_pa,
            pooled,
        }
    }
}

/// A stroke that does not count.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LeftOut {
    /// Its line in the stroke table.
    pub line: usize,
    /// Its name; null if it has none.
    pub stroke_id: Option<String>,
    /// Why.
    pub reason: String,
}

/// A single soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Point {
    /// Friction angle (deg).
    pub phi_deg: f64,
    /// Bulk density (kg/m3).
    pub density_kg_m3: f64,
    /// Interface friction (deg).
    pub delta_deg: f64,
    /// Fall of the friction angle (deg a decade of stress); null without a law of stress.
    pub slope_deg_per_decade: Option<f64>,
    /// Sum of squared relative force errors (Hong 2001, eq. 7.1).
    pub misfit: f64,
}

impl From<Fit> for Point {
    fn from(fit: Fit) -> Self {
        Self {
            phi_deg: fit.phi_deg,
            density_kg_m3: fit.density_kg_m3,
            delta_deg: fit.delta_deg,
            slope_deg_per_decade: fit.slope_deg_per_decade,
            misfit: fit.misfit,
        }
    }
}

/// Centroid of the region and how far the region reaches from it.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Centre {
    /// Friction angle (deg).
    pub phi_deg: f64,
    /// Half width that covers the region (deg).
    pub phi_half_width_deg: f64,
    /// Bulk density (kg/m3).
    pub density_kg_m3: f64,
    /// Half width that covers the region (kg/m3).
    pub density_half_width_kg_m3: f64,
}

/// What breaks consistency; names of measurements.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Disagreement {
    /// Measurements without which all others agree.
    pub culprits: Vec<String>,
    /// Pairs that no soil explains together.
    pub pairs: Vec<[String; 2]>,
    /// Measurements that no soil explains even alone.
    pub alone: Vec<String>,
    /// Factor on all uncertainties at which the measurements just agree; null if 10 is not enough.
    pub uncertainty_factor: Option<f64>,
}

/// Where a local optimiser started and ended.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Minimum {
    /// `downhill-simplex` or `levenberg-marquardt`.
    pub optimiser: &'static str,
    /// Start: phi (deg), density (kg/m3), delta (deg).
    pub start: [f64; 3],
    /// End.
    pub end: Point,
    /// Whether the end lies in the consistent region.
    pub inside: bool,
}

impl Minimum {
    pub(super) fn of(found: &LocalMinimum, inside: bool) -> Self {
        let optimiser = match found.optimiser {
            Optimiser::DownhillSimplex => "downhill-simplex",
            Optimiser::LevenbergMarquardt => "levenberg-marquardt",
        };
        Self { optimiser, start: found.start, end: found.end.into(), inside }
    }

    /// Optimiser, friction angle, density, interface friction, misfit and whether it lies in the region, in words.
    #[must_use]
    pub fn cells(&self) -> [String; 6] {
        [
            self.optimiser.to_owned(),
            format!("{:.2}", self.end.phi_deg),
            format!("{:.0}", self.end.density_kg_m3),
            format!("{:.2}", self.end.delta_deg),
            format!("{:.2e}", self.end.misfit),
            if self.inside { "yes" } else { "no" }.to_owned(),
        ]
    }
}

/// Ends that differ by more than 0.05 deg or 0.5 % in density, each with the number of starts that led there.
#[must_use]
pub fn distinct(minima: &[Minimum]) -> Vec<(&Minimum, usize)> {
    let mut kept: Vec<(&Minimum, usize)> = Vec::new();
    for m in minima {
        let same = |k: &Minimum| {
            k.optimiser == m.optimiser
                && (k.end.phi_deg - m.end.phi_deg).abs() < 0.05
                && (k.end.density_kg_m3 / m.end.density_kg_m3 - 1.0).abs() < 0.005
        };
        match kept.iter_mut().find(|(k, _)| same(k)) {
            Some((_, count)) => *count += 1,
            None => kept.push((m, 1)),
        }
    }
    kept
}

/// A stroke that might be made next.
#[derive(Debug, Serialize, JsonSchema)]
pub struct NextStroke {
    /// Tool angle (deg).
    pub alpha_deg: f64,
    /// Vertical depth (m).
    pub depth_m: f64,
    /// Plate width (m).
    pub width_m: f64,
    /// Expected area of the region after it, relative to now.
    pub area_left: f64,
    /// Expected width of the friction range after it (deg).
    pub phi_width_deg: f64,
    /// Expected width of the density range after it (kg/m3).
    pub density_width_kg_m3: f64,
    /// Force to expect at most (N).
    pub force_n: f64,
    /// Model that predicts it.
    pub model: &'static str,
}

impl From<&Candidate> for NextStroke {
    fn from(c: &Candidate) -> Self {
        Self {
            alpha_deg: c.alpha_deg,
            depth_m: c.depth_m,
            width_m: c.width_m,
            area_left: c.area_left,
            phi_width_deg: c.phi_width_deg,
            density_width_kg_m3: c.density_width_kg_m3,
            force_n: c.force_n,
            model: c.model,
        }
    }
}

/// What the same measurements say if ends are forgotten: plates as parts of endless ones.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlaneStrain {
    /// Whether any soil explains all measurements.
    pub consistent: bool,
    /// Range of the friction angle (deg); null if inconsistent.
    pub phi_deg: Option<[f64; 2]>,
    /// Range of the density (kg/m3); null if inconsistent.
    pub density_kg_m3: Option<[f64; 2]>,
    /// Consistent [phi, density]: polygons, each an outer ring and its holes.
    pub region: Vec<Vec<Ring>>,
}

impl From<&Estimate> for PlaneStrain {
    fn from(estimate: &Estimate) -> Self {
        Self {
            consistent: estimate.is_consistent(),
            phi_deg: estimate.phi_deg,
            density_kg_m3: estimate.density_kg_m3,
            region: estimate.region.polygons().to_vec(),
        }
    }
}

/// The answer.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Force model.
    pub model: String,
    /// Whether plates have ends.
    pub ends: Ends,
    /// Least and greatest width of a plate over its vertical depth.
    pub width_ratio: [f64; 2],
    /// Consistent values of the end factor that strokes share, the part of what ends add at most; null if they share none, or no soil is
    /// consistent.
    pub end_factor: Option<[f64; 2]>,
    /// The same without ends, for comparison; null if plates have none, and for exact data.
    pub plane_strain: Option<PlaneStrain>,
    /// Whether any soil explains all measurements.
    pub consistent: bool,
    /// Range of the friction angle (deg) over the whole interval of delta; null if inconsistent. With a law of stress it is that at
    /// `reference_stress_pa`, otherwise that at the stresses of `slip_stress_pa`.
    pub phi_deg: Option<[f64; 2]>,
    /// Normal stress (Pa) at which `phi_deg` holds under a law of stress; null without one.
    pub reference_stress_pa: Option<f64>,
    /// Least and greatest normal stress (Pa) on slip surfaces of all strokes; null as that of a measurement.
    pub slip_stress_pa: Option<[f64; 2]>,
    /// Friction as a law of stress; null unless asked for.
    pub friction_law: Option<LawAnswer>,
    /// What is left of cohesion, adhesion, surcharge, slope and all others together; null if those four are known.
    pub unknowns: Option<UnknownsAnswer>,
    /// Gravity (m/s2) under which the strokes were made.
    pub gravity_m_s2: f64,
    /// Range of the density (kg/m3) over the whole interval of delta; null if inconsistent.
    pub density_kg_m3: Option<[f64; 2]>,
    /// Sections at chosen deltas; empty if inconsistent, or where loads or slope are unknowns.
    pub regions: Vec<Section>,
    /// Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi, density].
    pub region: Vec<Vec<Ring>>,
    /// Consistent [delta, density], the same form; empty if delta is known exactly.
    pub delta_density: Vec<Vec<Ring>>,
    /// Consistent [phi, delta], the same form; empty if delta is known exactly.
    pub phi_delta: Vec<Vec<Ring>>,
    /// Area of the region (deg kg/m3).
    pub area_deg_kg_m3: f64,
    /// Volume of the consistent set (deg2 kg/m3); null with a law of stress or other unknowns more.
    pub volume_deg2_kg_m3: Option<f64>,
    /// What was known of delta (deg).
    pub delta_deg: [f64; 2],
    /// What was known of the density (kg/m3).
    pub density_known_kg_m3: Option<[f64; 2]>,
    /// Centroid of the region.
    pub centre: Option<Centre>,
    /// Soil of least misfit inside the region; null where loads or slope are unknowns.
    pub best_estimate: Option<Point>,
    /// Limits of the search that the region touches: it may reach further.
    pub cut_by: Vec<&'static str>,
    /// Probability with which all bands together hold their true forces; null if strokes of one kind are not taken together.
    pub confidence: Option<f64>,
    /// Probability of each band, by Šidák's correction; null if strokes of one kind are not taken together.
    pub confidence_each: Option<f64>,
    /// Scatter of repeated strokes over what the table states of them; above 1 the bands are wider for it. Null if nothing was repeated,
    /// stated, or taken together.
    pub scatter_over_stated: Option<f64>,
    /// The measurements.
    pub measurements: Vec<Measured>,
    /// Strokes in which the soil did not fail as models have it; empty unless strokes of one kind are taken together.
    pub left_out: Vec<LeftOut>,
    /// What breaks consistency; null if nothing does.
    pub disagreement: Option<Disagreement>,
    /// The result in words.
    pub verdict: String,
    /// Strokes that would shrink the region most, the best first; null if not asked for.
    pub next_strokes: Option<Vec<NextStroke>>,
    /// What local optimisers find; null if not asked for.
    pub optimisers: Option<Vec<Minimum>>,
    /// Results for exact data; null unless `--exact`.
    pub exact: Option<ExactAnswer>,
    /// What to keep in mind.
    pub warnings: Vec<String>,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.estimate/1";

    fn outcome(&self) -> Outcome {
        let found = match &self.exact {
            Some(exact) => exact.best.is_some(),
            None => self.consistent,
        };
        if found { Outcome::Done } else { Outcome::Negative }
    }
}
