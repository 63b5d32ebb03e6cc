//! Triangles that adjoin share what makes the stress function and its slopes the same on both sides.

use super::{ends, is_apex};
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::Interval;
use crate::problem::Problem;
use crate::statement::Condition;
use crate::tiling::{Beyond, Tiling};

fn bad(place: String, problem: &'static str) -> CertificateError {
    CertificateError::BadField { place, problem }
}

/// Checks how vertex copies are used.
pub(super) fn check(
    problem: &Problem,
    tiling: &Tiling,
    field: &LowerField,
    apexes: bool,
) -> Result<(), CertificateError> {
    for (i, (copies, t)) in field.corners.iter().zip(&field.mesh.triangles).enumerate() {
        if copies.map(|c| field.copies[c].vertex) != t.corners {
            return Err(bad(format!("triangle {i}"), "its vertex copies are not copies of its corners"));
        }
        check_apexes(field, *copies, apexes).map_err(|problem| bad(format!("triangle {i}"), problem))?;
    }
    for side in tiling.sides() {
        let here = ends(field, side);
        match tiling.beyond(side) {
            Beyond::Soil(other) => {
                let [end, start] = ends(field, other);
                if here != [start, end] {
                    let problem =
                        "the triangle beyond it has other vertex copies, but there is no boundary between";
                    return Err(bad(side.to_string(), problem));
                }
            }
            Beyond::Boundary(_, Condition::Free) => {
                let [a, b] = here.map(|copy| field.copies[copy].jet);
                if a != b || !matches!(a, Jet::Chain { .. }) {
                    return Err(bad(side.to_string(), "both ends of a free edge must belong to one chain"));
                }
            }
            Beyond::Boundary(..) => {}
        }
    }
    for (i, copy) in field.copies.iter().enumerate() {
        let depth = tiling.position(copy.vertex).y - Interval::point(problem.statement.datum);
        if is_apex(field, apexes, i) && !depth.is_zero() {
            return Err(bad(
                format!("vertex copy {i}"),
                "it belongs to a chain, but is not exactly at the datum",
            ));
        }
    }
    Ok(())
}

/// Checks what a triangle with an apex needs: the coefficient next to each other corner on the edge to the apex must
/// vanish, for all apexes.
fn check_apexes(field: &LowerField, copies: [usize; 3], apexes: bool) -> Result<(), &'static str> {
    for apex in copies.into_iter().filter(|c| is_apex(field, apexes, *c)) {
        let Jet::Chain { chain } = field.copies[apex].jet else { continue };
        for copy in copies {
            let suits = match field.copies[copy].jet {
                Jet::Chain { chain: base } | Jet::Zero { base } | Jet::ManyApexes { base, .. } => {
                    base == chain
                }
                Jet::OneApex { base, apex: only, .. } => base == chain && only == apex,
                Jet::Free { .. } | Jet::OneLine { .. } | Jet::TwoLines { .. } => false,
            };
            if !suits {
                return Err(
                    "a corner beside one at the free surface, where stress must vanish, does not allow for that",
                );
            }
        }
    }
    Ok(())
}
