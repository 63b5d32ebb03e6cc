//! The problem, with one of the soils in it that are asked about.

use soilctl_limit_analysis::describe::{Aim, Kind};
use soilctl_limit_analysis::results::{
    FlowResults, StressResults, least_reserve, problem_units, slip_stress,
};
use soilctl_limit_analysis::{Described, Description, LimitError};

use super::Request;
use super::layers::layered;
use super::region::Soils;
use crate::AppError;
use crate::solve::Asked;
use crate::text::number;

/// Least friction angle of a soil that is asked about, in degrees: weaker soil without cohesion carries nothing.
const LEAST_DEG: f64 = 0.5;
/// Least factor with which something stands, unless more is asked for.
const FACTOR: f64 = 1.0;
/// Greatest, in degrees: the solver's limit.
const MOST_DEG: f64 = 69.0;

/// One of the soils that are asked about.
#[derive(Debug, Clone, Copy)]
pub(super) struct Soil {
    pub(super) phi_deg: f64,
    pub(super) density_kg_m3: f64,
    /// Beside that of the problem: what is published, or what a straight line above a curved strength starts from.
    pub(super) cohesion_kpa: f64,
}

/// The problem and which of its soils is asked about.
#[derive(Debug, Clone)]
pub(super) struct Site {
    description: Description,
    soil: usize,
    required: f64,
    gravity_m_s2: f64,
    keep_weight: bool,
}

impl Site {
    pub(super) fn read(request: &Request, soils: &Soils) -> Result<Self, AppError> {
        let description = Description::read(&request.problem).map_err(LimitError::from)?;
        Self::new(description, &request.problem.display().to_string(), request, soils)
    }

    /// A problem of this name in messages.
    pub(super) fn new(
        mut description: Description,
        name: &str,
        request: &Request,
        soils: &Soils,
    ) -> Result<Self, AppError> {
        let refused = |words: String| Err(AppError::Request(format!("{name}: {words}")));
        let soil = match (&request.soil, description.soils.len()) {
            (Some(wanted), _) => description.soils.iter().position(|soil| soil.name == *wanted),
            (None, 1) => Some(0),
            (None, _) => None,
        };
        let Some(soil) = soil else {
            let names: Vec<_> = description.soils.iter().map(|soil| soil.name.as_str()).collect();
            return refused(format!("--soil must be one of its soils: {}", names.join(", ")));
        };
        if !description.cases().map_err(LimitError::from)?.is_empty() {
            return refused("it has cases or sweeps; ask about one problem at a time".into());
        }
        let required = match (&description.objective, request.required) {
            (Aim::Load {} | Aim::UnitWeight {} | Aim::StrengthReduction {}, required) => {
                required.unwrap_or(FACTOR)
            }
            (Aim::Structure { .. }, Some(required)) => required,
            (Aim::Structure { .. }, None) => {
                return refused(
                    "it asks for the force of a structure; say with --required which (kN/m) it must bear"
                        .into(),
                );
            }
            (Aim::Seismic { .. }, _) => {
                return refused(
                    "it asks for an acceleration; to stand is a matter of a factor or a force: set the objective to strength-reduction, load, \
                     unit-weight or structure"
                        .into(),
                );
            }
        };
        if soils.cohesion_pa.is_some() {
            let soil = &mut description.soils[soil];
            (soil.cohesion_kpa, soil.cohesion_gradient_kpa_per_m, soil.cohesion_level_m) = (0.0, 0.0, None);
        }
        let gravity_m_s2 = request.gravity_m_s2.unwrap_or(soils.gravity_m_s2);
        let site = Self { description, soil, required, gravity_m_s2, keep_weight: request.keep_weight };
        if site.is_wet() && !request.keep_weight {
            return refused(
                "it has water, and the density of the strokes is that of the soil as they found it; give the unit weight with water in the file, and \
                 --keep-weight"
                    .into(),
            );
        }
        Ok(site)
    }

    /// The same where gravity is so great across the surface (m/s2).
    pub(super) fn under_gravity(self, gravity_m_s2: f64) -> Self {
        Self { gravity_m_s2, ..self }
    }

    /// Whether the ground goes on beyond the mesh for ever, where no field is looked at.
    pub(super) fn has_far_sides(&self) -> bool {
        let Description { boundaries, default_boundary, .. } = &self.description;
        boundaries.iter().map(|boundary| boundary.kind).chain(*default_boundary).any(|kind| kind == Kind::Far)
    }

    /// Whether there is water in the problem.
    pub(super) fn is_wet(&self) -> bool {
        self.description.water.is_some() || self.description.soils[self.soil].pore_pressure_ratio > 0.0
    }

    /// Least factor with which it stands, or least force (kN/m) that the soil must bear.
    pub(super) const fn required(&self) -> f64 {
        self.required
    }

    /// Gravity at the problem (m/s2).
    pub(super) const fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// Whether the density of the strokes matters.
    pub(super) const fn takes_density(&self) -> bool {
        !self.keep_weight
    }

    /// Whether anything but this soil has strength: other soils, cohesion, faces, members.
    pub(super) fn has_other_strength(&self) -> bool {
        let Description { soils, plates, structures, members, .. } = &self.description;
        let has_cohesion = self.kept().is_some();
        let has_bodies = !plates.is_empty() || !structures.is_empty() || !members.is_empty();
        soils.len() > 1 || has_cohesion || has_bodies
    }

    /// What is bounded.
    pub(super) fn asked(&self) -> Asked {
        match self.description.objective {
            Aim::Load {} => Asked::LoadFactor,
            Aim::UnitWeight {} => Asked::WeightFactor,
            Aim::StrengthReduction {} => Asked::FactorOfSafety,
            Aim::Structure { .. } => Asked::ForceKnPerM,
            Aim::Seismic { .. } => Asked::AccelerationOverG,
        }
    }

    /// Title of the file.
    pub(super) fn title(&self) -> Option<String> {
        self.description.title.clone()
    }

    /// Name of the soil.
    pub(super) fn soil_name(&self) -> &str {
        &self.description.soils[self.soil].name
    }

    /// What of the file's soil is kept although the strokes say nothing of it.
    pub(super) fn kept(&self) -> Option<String> {
        let soil = &self.description.soils[self.soil];
        let cohesion = soil.cohesion_kpa > 0.0 || soil.cohesion_gradient_kpa_per_m != 0.0;
        cohesion.then(|| {
            format!(
                "the cohesion of {} in the file, {} kPa, is kept; strokes in soil without cohesion say nothing of it",
                soil.name,
                number(soil.cohesion_kpa)
            )
        })
    }

    /// The problem with a soil of the strokes, and more cohesion (kPa) than the file says.
    ///
    /// # Errors
    /// [`AppError`] if its friction angle is beyond what can be bounded.
    pub(super) fn with_soil(&self, soil: Soil) -> Result<Description, AppError> {
        let Soil { phi_deg, density_kg_m3, cohesion_kpa } = soil;
        if !(LEAST_DEG..=MOST_DEG).contains(&phi_deg) {
            return Err(AppError::Request(format!(
                "the law of stress makes phi {} deg at the stresses of this problem; bounds are for {LEAST_DEG} to {MOST_DEG} deg: a law carried so \
                 far says nothing, so test the soil nearer to these stresses",
                number(phi_deg)
            )));
        }
        let mut description = self.description.clone();
        let soil = &mut description.soils[self.soil];
        soil.phi_deg = Some(phi_deg);
        soil.cohesion_kpa += cohesion_kpa;
        if !self.keep_weight {
            soil.unit_weight_kn_m3 = 1e-3 * density_kg_m3 * self.gravity_m_s2;
        }
        Ok(description)
    }

    /// The problem with this soil in layers along its surface, whose friction angle (deg) is a function of normal stress (Pa); `None` if it cannot be cut so,
    /// or a layer has a friction angle beyond what can be bounded.
    pub(super) fn with_layers(
        &self,
        density_kg_m3: f64,
        friction_deg: impl Fn(f64) -> f64,
    ) -> Option<Description> {
        let whole = Soil { phi_deg: friction_deg(0.0), density_kg_m3, cohesion_kpa: 0.0 };
        let description = self.with_soil(whole).ok()?;
        let found = layered(&description, self.soil, friction_deg)?;
        found
            .soils
            .iter()
            .all(|soil| soil.phi_deg.is_some_and(|deg| (LEAST_DEG..=MOST_DEG).contains(&deg) || deg == 0.0))
            .then_some(found)
    }

    /// Normal stresses (Pa) at which this soil slips in a solution: those between which the equivalent stress lies; `None` if it does not slip.
    pub(super) fn slip_stress_pa(
        &self,
        described: &Described,
        flow: &FlowResults,
        stress: &StressResults,
    ) -> Option<[f64; 2]> {
        let found = slip_stress(flow, stress, self.is_ours(described))?;
        Some([found.mean, found.heavy].map(|stress| 1e3 * described.stress_kpa * stress))
    }

    /// The factor by which the strength of this soil may be divided so that it bears a stress field, if its friction angle (deg) is a function of
    /// normal stress (Pa), and the stress (Pa) where no more may be; `None` if the soil is not in the field.
    pub(super) fn reserve(
        &self,
        described: &Described,
        stress: &StressResults,
        friction_deg: impl Fn(f64) -> f64,
    ) -> Option<(f64, f64)> {
        let pa = 1e3 * described.stress_kpa;
        let found = least_reserve(stress, self.is_ours(described), |mean| friction_deg(pa * mean))?;
        Some((found.factor, pa * found.stress))
    }

    /// Whether a point of a statement lies in this soil.
    fn is_ours(&self, described: &Described) -> impl Fn([f64; 2]) -> bool {
        let units = problem_units(&self.description, described);
        let name = self.soil_name();
        let areas: Vec<&[[f64; 2]]> = (self.description.regions.iter())
            .filter(|region| region.soil == name)
            .map(|region| &region.polygon[..])
            .collect();
        move |p| {
            let p = units.point(p);
            areas.iter().any(|polygon| contains(polygon, p))
        }
    }
}

/// Whether a point lies inside, by the parity of crossings on a ray.
fn contains(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            inside = !inside;
        }
    }
    inside
}
