//! Proven bounds on the factor of a problem with one soil, or with soils of one friction angle and densities of an interval.
//!
//! To bear more is never harder with more friction or cohesion, since every stress field that the weaker soil bears the stronger one bears too. So a lower
//! bound at the least of both holds for all soils, and an upper bound at the greatest likewise.
//!
//! With the density it is otherwise: weight may help or harm. But a mixture of stress fields that two densities bear is borne by the mixed density, so the
//! factor between two densities is at least the lesser of theirs. And a mechanism does work that is linear in the density, so one mechanism that is
//! proven at both densities bounds all between them.

use soilctl_certificate::{UpperField, prove_upper};
use soilctl_limit_analysis::describe::Aim;
use soilctl_limit_analysis::results::{FlowResults, StressResults};
use soilctl_limit_analysis::{
    Described, Description, LimitError, OneSide, Options, bound, factor_of_safety, falls,
};

use super::site::{Site, Soil};
use crate::AppError;

/// Element steps for a proof that the ground falls before any load.
const FALL_WORK: u64 = 300_000;

/// Bounds on a factor, or on a force in kN/m, with one soil.
#[derive(Debug)]
pub(super) struct Found {
    pub(super) lower: Option<f64>,
    pub(super) upper: Option<f64>,
    /// The mechanism behind the upper bound; strength over this factor.
    mechanism: Option<(f64, UpperField)>,
    /// Normal stresses at which the soil slips (Pa).
    pub(super) stress_pa: Option<[f64; 2]>,
    /// The stress field behind the lower bound.
    pub(super) field: Option<(Described, StressResults)>,
    /// Whether the ground is proven to fall before any load, which then has no factor.
    falls: bool,
}

/// Bounds the factor with one soil. A run that proves one side only is an answer.
pub(super) fn with_soil(
    site: &Site,
    soil: Soil,
    options: &Options,
    say: &mut dyn FnMut(usize),
) -> Result<Found, AppError> {
    of_description(site, &site.with_soil(soil)?, options, say)
}

/// The same for a problem with the soil in it as it is.
pub(super) fn of_description(
    site: &Site,
    description: &Description,
    options: &Options,
    say: &mut dyn FnMut(usize),
) -> Result<Found, AppError> {
    // A force has the units of the statement until it is told.
    let one_side = |error: LimitError, told: &dyn Fn([f64; 2]) -> [f64; 2]| match error {
        LimitError::NothingProven { proven: Some(side), .. } => Ok(Found {
            lower: if let OneSide::Lower(value) = side { Some(told([value; 2])[0]) } else { None },
            upper: if let OneSide::Upper(value) = side { Some(told([value; 2])[1]) } else { None },
            mechanism: None,
            stress_pa: None,
            field: None,
            falls: false,
        }),
        other => Err(other.into()),
    };
    if description.objective == (Aim::StrengthReduction {}) {
        let safety =
            match factor_of_safety(description, options, &mut |_, level, _| say(level.upper.elements)) {
                Ok(safety) => safety,
                Err(error) => return one_side(error, &|bounds| bounds),
            };
        let (lower, upper) = (&safety.lower, &safety.upper);
        let flow = FlowResults::new(&upper.described.statement, &upper.bound.field)?;
        let stress = StressResults::new(&lower.described.statement, &lower.bound.field)?;
        return Ok(Found {
            lower: Some(lower.factor),
            upper: Some(upper.factor),
            stress_pa: site.slip_stress_pa(&upper.described, &flow, &stress),
            field: Some((safety.lower.described, stress)),
            mechanism: Some((upper.factor, safety.upper.bound.field)),
            falls: false,
        });
    }
    let described = description.described()?;
    let problem = described.problem()?;
    let is_force = matches!(description.objective, Aim::Structure { .. });
    let bounds = match bound(&problem, options, &mut |level, _| say(level.upper.elements)) {
        Ok(bounds) => bounds,
        // Ground that falls before any load carries none.
        Err(_) if !is_force && falls(&problem, options, FALL_WORK)?.is_some() => {
            return Ok(Found {
                lower: None,
                upper: Some(0.0),
                mechanism: None,
                stress_pa: None,
                field: None,
                falls: true,
            });
        }
        Err(error) => return one_side(error, &|bounds| described.in_units(bounds)),
    };
    let [lower, upper] = described.in_units([bounds.lower.value, bounds.upper.value]);
    let flow = FlowResults::new(&described.statement, &bounds.upper.field)?;
    let stress = StressResults::new(&described.statement, &bounds.lower.field)?;
    Ok(Found {
        lower: Some(lower),
        upper: Some(upper),
        stress_pa: site.slip_stress_pa(&described, &flow, &stress),
        field: Some((described, stress)),
        mechanism: Some((1.0, bounds.upper.field)),
        falls: false,
    })
}

impl Found {
    /// The upper bound for all densities between two, by the mechanism found at one; `None` if it proves nothing there.
    pub(super) fn upper_between(
        &self,
        site: &Site,
        soil: Soil,
        densities_kg_m3: [f64; 2],
    ) -> Result<Option<f64>, AppError> {
        // A slope without load falls at any density.
        if self.falls || !site.takes_density() || densities_kg_m3[0] == densities_kg_m3[1] {
            return Ok(self.upper);
        }
        let Some((factor, field)) = &self.mechanism else { return Ok(None) };
        let mut most = f64::NEG_INFINITY;
        for density_kg_m3 in densities_kg_m3 {
            let description = site.with_soil(Soil { density_kg_m3, ..soil })?;
            let Some(upper) = at(&description, *factor, field)? else { return Ok(None) };
            most = most.max(upper);
        }
        Ok(Some(most))
    }
}

/// What a mechanism proves of a problem; `None` if nothing. Of a factor of safety it is the factor, if the mechanism fails the soil whose strength is divided by
/// it. To divide by more would not help: the mechanism dissipates `c cot(phi)` times what it dilates, of which the factor cancels.
fn at(description: &Description, factor: f64, field: &UpperField) -> Result<Option<f64>, AppError> {
    let is_safety = description.objective == (Aim::StrengthReduction {});
    let described =
        if is_safety { description.reduced(factor).described()? } else { description.described()? };
    Ok(match prove_upper(&described.statement, field).ok() {
        Some(upper) if is_safety => (upper < 1.0).then_some(factor),
        upper => upper.map(|upper| described.in_units([upper; 2])[1]),
    })
}
