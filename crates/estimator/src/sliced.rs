//! The cover of the consistent set, slice by slice of the slope of a law of stress.

use crate::constraint::{Constraint, merged};
use crate::law::FrictionLaw;
use crate::piece::Piece;
use crate::{EstimatorError, Setup};

/// The pieces of one slice, and its law.
pub(crate) type Slices = Vec<(Option<FrictionLaw>, Vec<Piece>)>;

/// Pieces of the consistent set: one list without a law, otherwise one for each slice of its slope.
pub(crate) fn sliced<F>(setup: &Setup<'_>, cover: F) -> Result<Slices, EstimatorError>
where
    F: Fn(&Setup<'_>, &[Constraint<'_>]) -> Result<Vec<Piece>, EstimatorError>,
{
    let mut constraints = merged(setup)?;
    let Some(law) = setup.friction_law else { return Ok(vec![(None, cover(setup, &constraints)?)]) };
    let mut found = Vec::new();
    let decades = constraints.iter().filter_map(|constraint| constraint.decades(setup.delta_deg.0));
    let farthest = decades.fold(0.0, f64::max);
    for slice in law.slices(farthest) {
        let Some(phi_deg) = phi_range_deg(setup, &slice) else { continue };
        for constraint in &mut constraints {
            constraint.follow(slice);
        }
        let setup = Setup { phi_search_deg: Some(phi_deg), friction_law: Some(slice), ..setup.clone() };
        found.push((Some(slice), cover(&setup, &constraints)?));
    }
    Ok(found)
}

/// Friction angles at the reference stress that the search and shear tests leave for slopes of a slice; `None` if there are none.
fn phi_range_deg(setup: &Setup<'_>, slice: &FrictionLaw) -> Option<(f64, f64)> {
    let (mut low, mut high) = setup.phi_range_deg();
    for test in &setup.shear_tests {
        // phi_ref is phi plus the fall from the reference to the stress of the test.
        let (slope, decades) = (slice.slope_deg_per_decade, slice.decades(test.stress_pa));
        let falls = [slope.0 * decades, slope.1 * decades];
        low = low.max(test.friction_deg[0] + falls[0].min(falls[1]));
        high = high.min(test.friction_deg[1] + falls[0].max(falls[1]));
    }
    (low < high).then_some((low, high))
}

/// What tests in direct shear say alone: ranges of the friction angle at the reference stress in degrees and of the slope in degrees a
/// decade; `None` if no law passes through all of them, or the setup has no law.
#[must_use]
pub fn shear_alone(setup: &Setup<'_>) -> Option<([f64; 2], [f64; 2])> {
    let mut hull: Option<([f64; 2], [f64; 2])> = None;
    let law = setup.friction_law?;
    let decades = setup.shear_tests.iter().map(|test| law.decades(test.stress_pa).abs());
    for slice in law.slices(decades.fold(0.0, f64::max)) {
        let Some((low, high)) = phi_range_deg(setup, &slice) else { continue };
        let slope = slice.slope_deg_per_decade;
        let (phi, slopes) = hull.unwrap_or(([low, high], [slope.0, slope.1]));
        hull = Some(([phi[0].min(low), phi[1].max(high)], [slopes[0].min(slope.0), slopes[1].max(slope.1)]));
    }
    hull
}
