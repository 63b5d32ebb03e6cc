use crate::ends::{prove_mechanism, prove_space};
use crate::lower::prove_lower;
use crate::solution::{Claim, Solution};
use crate::statement::Statement;
use crate::upper::prove_upper;
use crate::{CertificateError, SCHEMA};

/// What a solution proves, in the units of its statement (force per unit width times velocity).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Proof {
    /// Lower bound, if the solution has a field for it: a stress field in the plane, or in space.
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

/// A bound that a solution claims, and what its field proves.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The claim.
    pub claimed: f64,
    /// The bound proven, or why there is none.
    pub proven: Result<f64, CertificateError>,
}

impl Checked {
    fn new<F>(
        statement: &Statement,
        claim: &Claim<F>,
        prove: impl Fn(&Statement, &F) -> Result<f64, CertificateError>,
    ) -> Self {
        Self { claimed: claim.claimed, proven: prove(statement, &claim.field) }
    }

    fn bound(self) -> Result<Bound, CertificateError> {
        Ok(Bound { proven: self.proven?, claimed: self.claimed })
    }
}

/// Checks the lower bound of a solution, if it has one: by a stress field in the plane, or by one in space where the structure has
/// ends. Of a solution with both the greater bound counts, and neither if one of them is not proven.
#[must_use]
pub fn check_lower(solution: &Solution) -> Option<Checked> {
    let statement = &solution.statement;
    let plane = solution.lower.as_ref().map(|claim| Checked::new(statement, claim, prove_lower));
    let space = solution.space.as_ref().map(|claim| Checked::new(statement, claim, prove_space));
    match (plane, space) {
        (Some(plane), Some(space)) => Some(Checked {
            claimed: plane.claimed.max(space.claimed),
            proven: plane.proven.and_then(|plane| Ok(space.proven?.max(plane))),
        }),
        (plane, space) => plane.or(space),
    }
}

/// Checks the upper bound of a solution, if it has one: by a flow in the plane, or by blocks in space where the structure has
/// ends. A solution with both proves neither: one of them cannot be about its statement.
#[must_use]
pub fn check_upper(solution: &Solution) -> Option<Checked> {
    let statement = &solution.statement;
    match (&solution.upper, &solution.mechanism) {
        (None, None) => None,
        (Some(claim), None) => Some(Checked::new(statement, claim, prove_upper)),
        (None, Some(claim)) => Some(Checked::new(statement, claim, prove_mechanism)),
        (Some(flow), Some(blocks)) => {
            let problem = "has a flow in the plane and blocks in space, of which only one can be meant";
            let proven = Err(CertificateError::BadField { place: "the upper bound".into(), problem });
            Some(Checked { claimed: flow.claimed.min(blocks.claimed), proven })
        }
    }
}

/// Proves all bounds of a solution.
///
/// # Errors
///
/// [`CertificateError::Schema`], and what [`prove_lower`], [`prove_space`], [`prove_upper`] and
/// [`prove_mechanism`] return.
pub fn prove(solution: &Solution) -> Result<Proof, CertificateError> {
    if solution.schema != SCHEMA {
        return Err(CertificateError::Schema { found: solution.schema.clone(), expected: SCHEMA });
    }
    let (lower, upper) = check(solution)?;
    let bound = |checked: Option<Checked>| checked.map(Checked::bound).transpose();
    Ok(Proof { lower: bound(lower)?, upper: bound(upper)? })
}

/// Checks both bounds of a solution, each as far as it has one.
///
/// # Errors
///
/// [`CertificateError::Contradiction`] if both are proven and exclude each other.
pub fn check(solution: &Solution) -> Result<(Option<Checked>, Option<Checked>), CertificateError> {
    together(check_lower(solution), check_upper(solution))
}

fn together(
    lower: Option<Checked>,
    upper: Option<Checked>,
) -> Result<(Option<Checked>, Option<Checked>), CertificateError> {
    let proven = |checked: &Option<Checked>| checked.as_ref().and_then(|c| c.proven.as_ref().ok().copied());
    match (proven(&lower), proven(&upper)) {
        (Some(lower), Some(upper)) if lower > upper => Err(CertificateError::Contradiction { lower, upper }),
        _ => Ok((lower, upper)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No file makes the checker prove such a pair, so it is made here.
    #[test]
    fn bounds_that_exclude_each_other_are_no_result() {
        let bound = |proven: f64| Some(Checked { claimed: proven, proven: Ok(proven) });
        let crossed = together(bound(2.0), bound(1.0));
        assert_eq!(crossed, Err(CertificateError::Contradiction { lower: 2.0, upper: 1.0 }));
        for (lower, upper) in [(bound(1.0), bound(1.0)), (bound(2.0), None), (None, bound(1.0))] {
            assert_eq!(together(lower.clone(), upper.clone()), Ok((lower, upper)));
        }
    }
}
