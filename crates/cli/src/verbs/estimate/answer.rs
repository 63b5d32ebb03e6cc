//! What `estimate` answers.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_estimator::{Candidate, Fit, LocalMinimum, Observation, Optimiser, Ring};

/// A section of the consistent set at one interface friction.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Section {
    /// Interface friction (deg).
    pub(crate) delta_deg: f64,
    /// Rings of [phi (deg), density (kg/m3)], by the even-odd rule; the first point is not repeated.
    pub(crate) polygons: Vec<Ring>,
}

/// One measurement as the estimator saw it.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Measured {
    /// Name.
    pub(crate) label: String,
    /// Tool angle (deg).
    pub(crate) alpha_deg: f64,
    /// Vertical depth (m).
    pub(crate) depth_m: f64,
    /// Failure force (N).
    pub(crate) force_n: f64,
    /// Lower end of its interval (N).
    pub(crate) force_low_n: f64,
    /// Upper end of its interval (N).
    pub(crate) force_high_n: f64,
    /// Strokes behind it.
    pub(crate) strokes: usize,
}

impl Measured {
    pub(crate) fn of(observation: &Observation, strokes: usize) -> Self {
        Self {
            label: observation.label().into(),
            alpha_deg: observation.plate().tool_angle().degrees(),
            depth_m: observation.plate().depth_m(),
            force_n: observation.force_n(),
            force_low_n: observation.low_n(),
            force_high_n: observation.high_n(),
            strokes,
        }
    }
}

/// A single soil.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub(crate) struct Point {
    /// Friction angle (deg).
    pub(crate) phi_deg: f64,
    /// Bulk density (kg/m3).
    pub(crate) density_kg_m3: f64,
    /// Interface friction (deg).
    pub(crate) delta_deg: f64,
    /// Sum of squared relative force errors (Hong 2001, eq. 7.1).
    pub(crate) misfit: f64,
}

impl From<Fit> for Point {
    fn from(fit: Fit) -> Self {
        Self {
            phi_deg: fit.phi_deg,
            density_kg_m3: fit.density_kg_m3,
            delta_deg: fit.delta_deg,
            misfit: fit.misfit,
        }
    }
}

/// Centroid of the region and how far the region reaches from it.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub(crate) struct Centre {
    /// Friction angle (deg).
    pub(crate) phi_deg: f64,
    /// Half width that covers the region (deg).
    pub(crate) phi_half_width_deg: f64,
    /// Bulk density (kg/m3).
    pub(crate) density_kg_m3: f64,
    /// Half width that covers the region (kg/m3).
    pub(crate) density_half_width_kg_m3: f64,
}

/// What breaks consistency; names of measurements.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Disagreement {
    /// Measurements without which all others agree.
    pub(crate) culprits: Vec<String>,
    /// Pairs that no soil explains together.
    pub(crate) pairs: Vec<[String; 2]>,
    /// Measurements that no soil explains even alone.
    pub(crate) alone: Vec<String>,
    /// Factor on all uncertainties at which the measurements just agree; null if 10 is not enough.
    pub(crate) uncertainty_factor: Option<f64>,
}

/// Where a local optimiser started and ended.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Minimum {
    /// `downhill-simplex` or `levenberg-marquardt`.
    pub(crate) optimiser: &'static str,
    /// Start: phi (deg), density (kg/m3), delta (deg).
    pub(crate) start: [f64; 3],
    /// End.
    pub(crate) end: Point,
    /// Whether the end lies in the consistent region.
    pub(crate) inside: bool,
}

impl Minimum {
    pub(crate) fn of(found: &LocalMinimum, inside: bool) -> Self {
        let optimiser = match found.optimiser {
            Optimiser::DownhillSimplex => "downhill-simplex",
            Optimiser::LevenbergMarquardt => "levenberg-marquardt",
        };
        Self { optimiser, start: found.start, end: found.end.into(), inside }
    }

    /// Optimiser, friction angle, density, interface friction, misfit and whether it lies in the region.
    pub(crate) fn cells(&self) -> [String; 6] {
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

/// A stroke that might be made next.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct NextStroke {
    /// Tool angle (deg).
    pub(crate) alpha_deg: f64,
    /// Vertical depth (m).
    pub(crate) depth_m: f64,
    /// Expected area of the region after it, relative to now.
    pub(crate) area_left: f64,
    /// Expected width of the friction range after it (deg).
    pub(crate) phi_width_deg: f64,
    /// Expected width of the density range after it (kg/m3).
    pub(crate) density_width_kg_m3: f64,
    /// Force to expect at most (N).
    pub(crate) force_n: f64,
    /// Model that predicts it.
    pub(crate) model: &'static str,
}

impl From<&Candidate> for NextStroke {
    fn from(c: &Candidate) -> Self {
        Self {
            alpha_deg: c.alpha_deg,
            depth_m: c.depth_m,
            area_left: c.area_left,
            phi_width_deg: c.phi_width_deg,
            density_width_kg_m3: c.density_width_kg_m3,
            force_n: c.force_n,
            model: c.model,
        }
    }
}

/// The answer.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct EstimateAnswer {
    /// Force model.
    pub(crate) model: String,
    /// Whether any soil explains all measurements.
    pub(crate) consistent: bool,
    /// Range of the friction angle (deg) over the whole interval of delta; null if inconsistent.
    pub(crate) phi_deg: Option<[f64; 2]>,
    /// Range of the density (kg/m3) over the whole interval of delta; null if inconsistent.
    pub(crate) density_kg_m3: Option<[f64; 2]>,
    /// Sections at chosen deltas; empty if inconsistent.
    pub(crate) regions: Vec<Section>,
    /// Union over the whole interval of delta: polygons, each an outer ring and its holes, of [phi, density].
    pub(crate) region: Vec<Vec<Ring>>,
    /// Consistent [delta, density], the same form; empty if delta is known exactly.
    pub(crate) delta_density: Vec<Vec<Ring>>,
    /// Consistent [phi, delta], the same form; empty if delta is known exactly.
    pub(crate) phi_delta: Vec<Vec<Ring>>,
    /// Area of the region (deg kg/m3).
    pub(crate) area_deg_kg_m3: f64,
    /// Volume of the consistent set (deg2 kg/m3).
    pub(crate) volume_deg2_kg_m3: f64,
    /// What was known of delta (deg).
    pub(crate) delta_deg: [f64; 2],
    /// What was known of the density (kg/m3).
    pub(crate) density_known_kg_m3: Option<[f64; 2]>,
    /// Centroid of the region.
    pub(crate) centre: Option<Centre>,
    /// Soil of least misfit inside the region.
    pub(crate) best_estimate: Option<Point>,
    /// Limits of the search that the region touches: it may reach further.
    pub(crate) cut_by: Vec<&'static str>,
    /// The measurements.
    pub(crate) measurements: Vec<Measured>,
    /// What breaks consistency; null if nothing does.
    pub(crate) disagreement: Option<Disagreement>,
    /// The result in words.
    pub(crate) verdict: String,
    /// Strokes that would shrink the region most, the best first; null if not asked for.
    pub(crate) next_strokes: Option<Vec<NextStroke>>,
    /// What local optimisers find; null if not asked for.
    pub(crate) optimisers: Option<Vec<Minimum>>,
    /// Results for exact data; null unless `--exact`.
    pub(crate) exact: Option<super::exact::ExactAnswer>,
    /// What to keep in mind.
    pub(crate) warnings: Vec<String>,
}
