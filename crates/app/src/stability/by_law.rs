//! Bounds for soils whose friction falls with stress.
//!
//! The strength `sigma tan(phi(sigma))` of such a soil is a curve that bends downwards. A stress field that was found for one friction angle proves a lower
//! bound for the curve if each of its stresses is borne by the friction at that very stress, which is looked at. A mechanism proves an upper bound for
//! every soil whose strength is below a straight line if it does so for the line, which has a friction angle and a cohesion.

use super::answer::{FrictionBasis, SlopeAnswer, Trial};
use super::factor::Found;
use super::search::{Outcome, Search};
use super::site::Soil;
use crate::AppError;
use crate::solve::Asked;

/// Friction angles for which fields are found: at so many stresses, each twice the last.
const FIELDS: i32 = 7;
/// Friction angles that differ by less give the same field, in degrees.
const SAME_DEG: f64 = 0.1;
/// Ratio of the stresses at which a straight line is kept above the strength.
const STEP: f64 = 1.01;
/// Least stress looked at over that where the line meets the strength.
const NO_STRESS: f64 = 1e-6;

/// What fields prove.
#[derive(Debug, Clone)]
struct Lower {
    /// The angle for which the field was found.
    phi_deg: f64,
    /// The bound for that angle.
    of_field: f64,
    /// Of all soils.
    least: Option<f64>,
    /// Stress (Pa) at which the field leaves least of their strength.
    decisive_pa: Option<f64>,
    /// Of the soils of each slice.
    of_slices: Vec<Option<f64>>,
}

/// The lesser of two bounds; none if either is missing.
fn lesser(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.zip(b).map(|(a, b)| a.min(b))
}

impl Lower {
    /// What holds for both of two densities.
    fn and(self, other: Self) -> Self {
        let decides = other.least < self.least;
        Self {
            of_field: self.of_field.min(other.of_field),
            least: lesser(self.least, other.least),
            decisive_pa: if decides { other.decisive_pa } else { self.decisive_pa },
            of_slices: self.of_slices.into_iter().zip(other.of_slices).map(|(a, b)| lesser(a, b)).collect(),
            ..self
        }
    }

    /// The better of two fields, for all soils and for those of each slice.
    fn or(self, other: Self) -> Self {
        let of_slices = self.of_slices.iter().zip(&other.of_slices);
        let of_slices = of_slices.map(|(a, b)| if b > a { *b } else { *a }).collect();
        Self { of_slices, ..if other.least > self.least { other } else { self } }
    }
}

impl Search<'_> {
    /// With friction as a law of stress.
    pub(super) fn by_law(&self, stress_pa: Option<[f64; 2]>) -> Result<Outcome, AppError> {
        let Some([mean, heavy]) = stress_pa else {
            return Err(AppError::Request(format!(
                "{} does not slip in this problem, so that its friction at the stresses of the problem is not known and does not decide; choose the \
                 soil that fails by --soil",
                self.site.soil_name()
            )));
        };
        let mut trials = Vec::new();
        let found = self.fields(heavy, &mut trials)?;
        let (strongest, cohesion_kpa) = self.line_above(mean);
        let upper = self.upper(strongest, cohesion_kpa)?;
        trials.push(Trial { phi_deg: strongest, lower: None, upper });
        let weakest = found.as_ref().map_or_else(|| self.soils.weakest_deg(heavy), |found| found.phi_deg);
        let bounds = self.cut(found.as_ref().and_then(|found| found.least), upper);
        let mut outcome = Outcome::new([weakest, strongest], FrictionBasis::Law, stress_pa, bounds, trials);
        let Some(found) = found else { return Ok(outcome) };
        outcome.decisive_pa = found.decisive_pa;
        for (slice, lower) in found.of_slices.into_iter().enumerate() {
            if let Some(slope_deg_per_decade) = self.soils.slopes(slice) {
                let [lower, _] = self.cut(lower, None);
                outcome.by_slope.push(SlopeAnswer { slope_deg_per_decade, lower });
            }
        }
        Ok(outcome)
    }

    /// Fields of the soil in layers, then of weaker and weaker soil, from the friction at a stress (Pa) on, until nothing is gained.
    fn fields(&self, from_pa: f64, trials: &mut Vec<Trial>) -> Result<Option<Lower>, AppError> {
        let at_first = self.soils.weakest_deg(from_pa);
        let mut best = self.field(at_first, |density_kg_m3| Ok(self.in_layers(density_kg_m3)))?;
        if let Some(found) = &best {
            trials.push(Trial { phi_deg: found.phi_deg, lower: found.least, upper: None });
            if self.is_enough(found.least) {
                return Ok(best);
            }
        }
        let mut last = f64::INFINITY;
        for i in 0..FIELDS {
            let phi_deg = self.soils.weakest_deg(from_pa * f64::powi(2.0, i));
            if last - phi_deg < SAME_DEG {
                continue;
            }
            last = phi_deg;
            let of_angle = |density_kg_m3| {
                let soil = Soil { phi_deg, density_kg_m3, cohesion_kpa: 0.0 };
                self.bounds("weakest soil", soil, &self.part()).map(Some)
            };
            let Some(found) = self.field(phi_deg, of_angle)? else { break };
            trials.push(Trial { phi_deg, lower: found.least, upper: None });
            // A field that is borne with all that it was found for leaves nothing to weaker soil.
            let is_whole = found.least >= Some(found.of_field);
            let gains = best.as_ref().is_none_or(|best| found.least > best.least || found.least.is_none());
            best = Some(match best {
                Some(best) => best.or(found),
                None => found,
            });
            if is_whole || !gains || self.is_stopped() {
                break;
            }
        }
        Ok(best)
    }

    /// What the fields found for a density (kg/m3) prove, for all densities; `None` without a field. The angle is told of them.
    fn field(
        &self,
        phi_deg: f64,
        of_density: impl Fn(f64) -> Result<Option<Found>, AppError>,
    ) -> Result<Option<Lower>, AppError> {
        let mut whole: Option<Lower> = None;
        for density_kg_m3 in self.densities() {
            let Some(found) = of_density(density_kg_m3)? else { return Ok(None) };
            let (Some(of_field), Some((described, stress))) = (found.lower, &found.field) else {
                return Ok(None);
            };
            let reserve =
                |friction_deg: &dyn Fn(f64) -> f64| self.site.reserve(described, stress, friction_deg);
            let proves = |reserve: Option<(f64, f64)>| {
                let reserve = reserve.map(|(factor, _)| factor);
                match self.site.asked() {
                    // What else has strength bears the field with its own.
                    Asked::FactorOfSafety if self.site.has_other_strength() => {
                        Some(reserve.map_or(of_field, |reserve| reserve.min(of_field)))
                    }
                    Asked::FactorOfSafety => reserve,
                    Asked::LoadFactor
                    | Asked::WeightFactor
                    | Asked::ForceKnPerM
                    | Asked::AccelerationOverG => {
                        reserve.is_none_or(|reserve| reserve >= 1.0).then_some(of_field)
                    }
                }
            };
            let of_all = reserve(&|pa| self.soils.weakest_deg(pa));
            let of_slice = |slice| proves(reserve(&|pa| self.soils.weakest_of_deg(slice, pa)));
            let lower = Lower {
                phi_deg,
                of_field,
                least: proves(of_all),
                decisive_pa: of_all.map(|(_, stress)| stress),
                of_slices: (0..self.soils.slices()).map(of_slice).collect(),
            };
            whole = Some(match whole {
                Some(whole) => whole.and(lower),
                None => lower,
            });
        }
        Ok(whole)
    }

    /// Friction angle (deg) and cohesion (kPa) of a straight line that is above the strength of all soils at all stresses, and meets that of the strongest
    /// at a stress (Pa).
    fn line_above(&self, stress_pa: f64) -> (f64, f64) {
        let strength = |stress: f64| stress * self.soils.strongest_deg(stress).to_radians().tan();
        let phi_deg = self.soils.strongest_deg(stress_pa);
        let tan = phi_deg.to_radians().tan();
        let mut above: f64 = 0.0;
        // Above this stress friction is less, or the same.
        let mut stress = stress_pa;
        while stress > NO_STRESS * stress_pa {
            let next = stress / STEP;
            // Strength grows with stress: between the two it is at most that of the greater.
            above = above.max(strength(stress) - next * tan);
            stress = next;
        }
        (phi_deg, 1e-3 * above)
    }
}
