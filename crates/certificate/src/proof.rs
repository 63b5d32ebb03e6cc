use crate::ends::prove_mechanism;
use crate::fields::{LowerField, UpperField};
use crate::lower::prove_lower;
use crate::solution::{Claim, Solution};
use crate::statement::Statement;
use crate::upper::prove_upper;
use crate::{CertificateError, SCHEMA};

/// What a solution proves, in the units of its statement (force per unit width times velocity).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Proof {
    /// Lower bound, if the solution has a field for it.
    pub lower: Option<Bound>,
    /// Upper bound, likewise: by a flow in the plane, or by blocks in space.
    pub upper: Option<Bound>,
}

/// One bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// What is proven.
    pub proven: f64,
    /// What the solution claims, for comparison only.
    pub claimed: f64,
}

/// Proves all bounds of a solution.
///
/// # Errors
///
/// [`CertificateError::Schema`], and what [`prove_lower`], [`prove_upper`] and [`prove_mechanism`] return.
pub fn prove(solution: &Solution) -> Result<Proof, CertificateError> {
    fn bound<F>(
        statement: &Statement,
        claim: &Claim<F>,
        prove: impl Fn(&Statement, &F) -> Result<f64, CertificateError>,
    ) -> Result<Bound, CertificateError> {
        Ok(Bound { proven: prove(statement, &claim.field)?, claimed: claim.claimed })
    }
    if solution.schema != SCHEMA {
        return Err(CertificateError::Schema { found: solution.schema.clone(), expected: SCHEMA });
    }
    let statement = &solution.statement;
    let lower =
        solution.lower.as_ref().map(|c: &Claim<LowerField>| bound(statement, c, prove_lower)).transpose()?;
    let upper =
        solution.upper.as_ref().map(|c: &Claim<UpperField>| bound(statement, c, prove_upper)).transpose()?;
    let mechanism = solution.mechanism.as_ref().map(|c| bound(statement, c, prove_mechanism)).transpose()?;
    // A statement has a width, or it has not: only one of the two is proven.
    let upper = upper.or(mechanism);
    if let (Some(l), Some(u)) = (lower, upper)
        && l.proven > u.proven
    {
        return Err(CertificateError::Contradiction { lower: l.proven, upper: u.proven });
    }
    Ok(Proof { lower, upper })
}
