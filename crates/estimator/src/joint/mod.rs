//! The estimate with more unknowns: cohesion, adhesion, surcharge and the slope of the surface beside friction and density.
//!
//! At given angles the force is linear in density, cohesion, adhesion and surcharge, so that all measurements together leave a polytope of them. The angles
//! (friction, interface friction, slope) are cut into simplices, over each of which the consistent set is enclosed in a polytope of angles and
//! linear quantities together (`simplex.rs`); bounds on it are proven by multipliers of linear programs (`linear.rs`). Cells that are proven to be
//! empty are dropped, the others cut finer as long as a budget of simplices allows (`cover.rs`), and what is left is projected (`shadow.rs`). Nothing
//! consistent is ever lost, whatever the budget: a coarse cover is a wider one.

mod cover;
mod factors;
mod linear;
mod shadow;
mod simplex;
mod unknowns;

use cover::Cover;
pub use unknowns::{Adhesion, Quantity, Unknowns};

use crate::region::Region;
use crate::{EstimatorError, Setup};

/// What measurements leave of all unknowns together.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Least and greatest value of each quantity that is not known, angles first; empty if no soil is consistent.
    pub ranges: Vec<(Quantity, [f64; 2])>,
    /// The region of each pair of them: the first one along x, the second along y. Of two quantities that are no angles it is the convex hull.
    pub pairs: Vec<(Quantity, Quantity, Region)>,
}

impl Joint {
    /// Least and greatest value of a quantity that is not known; `None` if no soil is consistent.
    #[must_use]
    pub fn range(&self, quantity: Quantity) -> Option<[f64; 2]> {
        self.ranges.iter().find(|(of, _)| *of == quantity).map(|(_, range)| *range)
    }

    /// The region of two quantities, in the order of [`Quantity`]; empty if one of them is known, or no soil is consistent.
    #[must_use]
    pub fn pair(&self, x: Quantity, y: Quantity) -> Region {
        let found = self.pairs.iter().find(|(a, b, _)| (*a, *b) == (x, y));
        found.map_or_else(Region::default, |(_, _, region)| region.clone())
    }
}

/// What a setup with unknowns leaves of them.
pub(crate) fn joint(setup: &Setup<'_>, unknowns: &Unknowns) -> Result<Joint, EstimatorError> {
    let mut cover = Cover::new(setup, unknowns)?;
    let shadows = cover.shadows()?;
    cover.refusal()?;
    let Some(ranges) = shadows.ranges() else { return Ok(Joint { ranges: Vec::new(), pairs: Vec::new() }) };
    Ok(Joint { ranges, pairs: shadows.regions() })
}

/// Whether any soil may be consistent.
pub(crate) fn may_be_consistent(setup: &Setup<'_>, unknowns: &Unknowns) -> Result<bool, EstimatorError> {
    let cover = Cover::new(setup, unknowns)?;
    let found = !cover.is_empty();
    cover.refusal()?;
    Ok(found)
}
