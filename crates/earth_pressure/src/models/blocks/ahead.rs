//! The blocks ahead of a plate alone, while the soil behind it stays where it is and the plate leaves it.
//!
//! Whatever else moves along with the plate behind it has no part in this: so the bound also holds for any rigid body and soil that fill the
//! plate's front, as long as what stays at rest separates from them at the friction angle or more.

use soilctl_certificate::{Claim, Mechanism, Statement, prove_mechanism};
use soilctl_soil::WidthRatio;

use super::{Blocks, FACETS, WEIGHT, best, check, passive, polyhedra, proven};
use crate::{Case, EarthPressureError};

impl Blocks {
    /// The coefficient per slant length and width of the blocks ahead alone, by weight, found but not proven.
    ///
    /// # Errors
    ///
    /// As [`crate::ForceModel::predict`].
    pub fn ahead(&self, case: &Case) -> Result<f64, EarthPressureError> {
        check(case)?;
        Ok(passive(case, &best(case, WEIGHT)?, FACETS).weight)
    }

    /// As [`Blocks::proven`], by the blocks ahead alone, under the weight of the soil. The plate must not be flatter than its friction angle.
    ///
    /// # Errors
    ///
    /// As [`Blocks::proven`].
    pub fn proven_ahead(
        &self,
        case: &Case,
        statement: &Statement,
    ) -> Result<Claim<Mechanism>, EarthPressureError> {
        let width = statement.width.unwrap_or(f64::NAN);
        let case = case.with_width_ratio(WidthRatio::new(width / case.tool_angle.sin())?);
        proven(&case, WEIGHT, |harder, blocks, _| {
            let field = polyhedra::polyhedra(harder, 0.5 * width, blocks, None, FACETS);
            let claimed = prove_mechanism(statement, &field)?;
            Ok(Claim { field, claimed, computed: None })
        })
    }
}
