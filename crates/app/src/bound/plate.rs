//! The plate of a request in the units of the solver, and back.

use soilctl_certificate::{SCHEMA, Scale, Solution};
use soilctl_earth_pressure::{Case, LoadFactors};
use soilctl_limit_analysis::results::Units;
use soilctl_limit_analysis::{Bounds, EmbeddedPlate, EndLevel, LimitError, Problem, StressLaw};
use soilctl_soil::{Angle, Interface, Plate, Soil};

use super::Request;
use super::end::{EndBudget, EndField, find_end};
use crate::AppError;
use crate::text::number;

/// Stands in for a quantity that was not given, so that the others are checked all the same.
const ANY: f64 = 1.0;

/// A plate of unit slant length in soil of unit weight one, and what the units stand for.
#[derive(Debug)]
pub(crate) struct ScaledPlate {
    plate: EmbeddedPlate,
    /// Slant length in m and unit weight in N/m3, if they are known.
    units: Option<(f64, f64)>,
    /// Width in m.
    width_m: Option<f64>,
    /// What makes a coefficient of a force along the surface.
    coefficient: f64,
    /// How its friction falls with stress, if it does.
    law: Option<StressLaw>,
}

impl ScaledPlate {
    /// A plate of which only the coefficients are asked for.
    pub(crate) fn unit(plate: EmbeddedPlate) -> Self {
        let coefficient = 2.0 / (plate.alpha_deg + plate.delta_deg).to_radians().sin();
        Self { plate, units: None, width_m: None, coefficient, law: None }
    }

    pub(super) fn new(request: &Request) -> Result<Self, AppError> {
        let loads = &request.loads;
        // The types refuse what is out of range.
        let plate = Plate::new(
            Angle::from_degrees(request.alpha_deg),
            Angle::from_degrees(loads.beta_deg),
            request.depth_m.unwrap_or(ANY),
            request.width_m.unwrap_or(ANY),
        )?;
        let soil = Soil::new(Angle::from_degrees(request.phi_deg), request.density_kg_m3.unwrap_or(ANY))?
            .with_cohesion(loads.cohesion_pa)?
            .with_gravity(loads.gravity_m_s2)?;
        Interface::new(Angle::from_degrees(request.delta_deg), loads.adhesion_pa)?;
        let units = match (request.depth_m, request.density_kg_m3) {
            (Some(_), Some(_)) => Some((plate.slant_length_m(), soil.unit_weight_n_m3())),
            _ => None,
        };
        let in_units = |option: &str, stress_pa: f64| match units {
            Some((length, weight)) => Ok(stress_pa / (length * weight)),
            None if stress_pa == 0.0 => Ok(0.0),
            None => Err(AppError::Request(format!(
                "--{option} is {stress_pa} Pa, but how much that is depends on depth and density; give --depth M and \
                 --density KG/M3 too"
            ))),
        };
        let plate = EmbeddedPlate {
            alpha_deg: request.alpha_deg,
            beta_deg: loads.beta_deg,
            phi_deg: request.phi_deg,
            delta_deg: request.delta_deg,
            cohesion: in_units("cohesion", loads.cohesion_pa)?,
            adhesion: in_units("adhesion", loads.adhesion_pa)?,
            surcharge: in_units("surcharge", loads.surcharge_pa)?,
        };
        let law = match (request.friction_law, request.reference_stress_pa) {
            (None, None) => None,
            (Some(slope_deg_per_decade), Some(stress_pa)) => {
                Some(StressLaw { slope_deg_per_decade, reference: in_units("reference-stress", stress_pa)? })
            }
            _ => {
                return Err(AppError::Request(
                    "--friction-law and --reference-stress go together: how much friction falls a decade of stress, and at which stress it is --phi".into(),
                ));
            }
        };
        Ok(Self { units, width_m: request.width_m, law, ..Self::unit(plate) })
    }

    /// The plate as a problem for the solver.
    pub(crate) fn problem(&self) -> Result<Problem, LimitError> {
        self.law.map_or_else(|| self.plate.problem(), |law| self.plate.problem_under(law))
    }

    /// The same with ends, for a width over vertical depth.
    pub(super) fn problem_with_ends(&self, width_ratio: f64) -> Result<Problem, LimitError> {
        self.plate.problem_with_ends(self.slant_width(width_ratio))
    }

    /// Lower and upper coefficient; rounding is outwards.
    pub(crate) fn coefficients(&self, bounds: &Bounds) -> [f64; 2] {
        self.of_forces([bounds.lower.value, bounds.upper.value])
    }

    /// The same of any two bounds on the force.
    pub(crate) fn of_forces(&self, [lower, upper]: [f64; 2]) -> [f64; 2] {
        // The factor and the product are each good to a rounding or two.
        let slack = 4.0 * f64::EPSILON;
        let (l, u) = (self.coefficient * lower, self.coefficient * upper);
        [l - slack * l.abs(), u + slack * u.abs()]
    }

    /// Width in slant lengths of a plate with this width over vertical depth.
    pub(crate) fn slant_width(&self, width_ratio: f64) -> f64 {
        width_ratio * Angle::from_degrees(self.plate.alpha_deg).sin()
    }

    /// A stress field in space about the ends at a width over vertical depth, or why there is none.
    pub(super) fn end(
        &self,
        width_ratio: f64,
        budget: &EndBudget,
        progress: &mut dyn FnMut(&EndLevel),
    ) -> Result<EndField, String> {
        find_end(&self.plate, self.slant_width(width_ratio), budget, progress)
    }

    /// The same plate, asked about by a force model, and the loads on it.
    pub(crate) fn case(&self) -> (Case, LoadFactors) {
        let p = &self.plate;
        let loads =
            LoadFactors { weight: 0.5, surcharge: p.surcharge, cohesion: p.cohesion, adhesion: p.adhesion };
        (Case::from_deg(p.alpha_deg, p.beta_deg, p.phi_deg, p.delta_deg), loads)
    }

    /// Newtons for a coefficient of one.
    pub(super) fn newtons(&self) -> Option<f64> {
        let (length, weight) = self.units?;
        Some(0.5 * weight * length * length * self.width_m?)
    }

    /// What figures and results are in: slant lengths and their weight if nothing else is known.
    pub(super) fn shown_in(&self) -> Units {
        let known = self.units.map(|(length, weight)| (length, 1e-3 * length * weight, "m", "kPa"));
        let (length, stress, length_name, stress_name) = known.unwrap_or((1.0, 1.0, "L", "γL"));
        Units {
            origin: [0.0; 2],
            length,
            length_name: length_name.to_owned(),
            stress,
            stress_name: stress_name.to_owned(),
        }
    }

    /// The plate in a few words.
    pub(super) fn title(&self) -> String {
        let p = &self.plate;
        let slope = if p.beta_deg == 0.0 { String::new() } else { format!("β {}°, ", p.beta_deg) };
        let law = self.law.map_or(String::new(), |law| {
            format!(
                " at {} γL, less by {}° a decade of stress",
                number(law.reference),
                law.slope_deg_per_decade
            )
        });
        format!("α {}°, {slope}φ {}°{law}, δ {}°", p.alpha_deg, p.phi_deg, p.delta_deg)
    }

    /// The solution in plane strain, for a file.
    pub(crate) fn solution(&self, problem: &Problem, bounds: &Bounds) -> Solution {
        let p = &self.plate;
        Solution {
            schema: SCHEMA.to_owned(),
            program: format!("soilctl {}", env!("CARGO_PKG_VERSION")),
            statement: problem.statement().clone(),
            scale: Scale {
                length_m: self.units.map(|u| u.0),
                unit_weight_n_per_m3: self.units.map(|u| u.1),
                description: Some(format!(
                    "embedded plate: alpha {} deg, beta {} deg, phi {} deg{}, delta {} deg; the coefficient per slant \
                     length is the bound times 2 / sin(alpha + delta)",
                    p.alpha_deg,
                    p.beta_deg,
                    p.phi_deg,
                    self.law.map_or(String::new(), |law| format!(
                        " at a normal stress of {}, less by {} deg a decade",
                        number(law.reference),
                        law.slope_deg_per_decade
                    )),
                    p.delta_deg
                )),
            },
            lower: Some(bounds.lower.claim()),
            upper: Some(bounds.upper.claim()),
            mechanism: None,
            space: None,
        }
    }
}
