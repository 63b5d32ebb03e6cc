//! Triangles that adjoin share what makes the stress function and its slopes the same on both sides.

use super::ends;
use super::loads::{Loads, Station, is_bare};
use super::members::kink;
use super::surfaces::along_free_side;
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::problem::Problem;
use crate::statement::Boundary;
use crate::tiling::{Beyond, Tiling};

fn bad(place: String, problem: &'static str) -> CertificateError {
    CertificateError::BadField { place, problem }
}

/// Checks how vertex copies are used. Returns where each is on free or loaded boundary, and whether it is an apex.
pub(super) fn check(
    problem: &Problem,
    tiling: &Tiling,
    field: &LowerField,
    loads: &Loads,
) -> Result<(Vec<Option<Station>>, Vec<bool>), CertificateError> {
    for (i, (copies, t)) in field.corners.iter().zip(&field.mesh.triangles).enumerate() {
        if copies.map(|c| field.copies[c].vertex) != t.corners {
            return Err(bad(format!("triangle {i}"), "its vertex copies are not copies of its corners"));
        }
    }
    let stations = loads.stations(tiling, field)?;
    let mut apexes = vec![false; field.copies.len()];
    for side in tiling.sides() {
        let here = ends(field, side);
        match tiling.beyond(side) {
            Beyond::Soil(other) => {
                let [end, start] = ends(field, other);
                if tiling.member(side).is_some_and(|on| problem.bends(on.piece.member)) {
                    // A beam bears whatever it is by which they differ.
                } else if let Some(on) = tiling.member(side) {
                    // Its two sides are checked with its force.
                    let pairs = if on.is_left { here } else { [start, end] };
                    let others = if on.is_left { [start, end] } else { here };
                    let is_kinked =
                        |(a, b): (usize, usize)| kink(problem, field, &stations, &on, [a, b]).is_some();
                    if !pairs.into_iter().zip(others).all(is_kinked) {
                        let problem = "the stress function is not the same on both sides of the member";
                        return Err(bad(side.to_string(), problem));
                    }
                } else if here != [start, end] && !are_branches(field, &stations, here, [start, end]) {
                    let problem =
                        "the triangle beyond it has other vertex copies, but there is no boundary between";
                    return Err(bad(side.to_string(), problem));
                }
            }
            Beyond::Boundary(on, condition) if condition.traction_is_given() => {
                let gauge = |copy: usize| match field.copies[copy].jet {
                    Jet::Gauge { gauge } => Some(gauge),
                    _ => None,
                };
                // That of the run, or a branch.
                let suits = |gauge: usize| loads.run(on.side) == Some(gauge) || gauge >= loads.count();
                if gauge(here[0]) != gauge(here[1]) || !gauge(here[0]).is_some_and(suits) {
                    let problem = "both ends of a free or loaded edge must belong to the chain of its run";
                    return Err(bad(side.to_string(), problem));
                }
                let boundary = Boundary { line: on.side.line, forward: on.side.forward, condition };
                if is_bare(problem, &boundary) {
                    here.into_iter().for_each(|copy| apexes[copy] = true);
                }
            }
            Beyond::Boundary(..) => {}
        }
    }
    for (i, (copy, station)) in field.copies.iter().zip(&stations).enumerate() {
        if let Jet::Gauge { gauge } = copy.jet
            && station.is_none_or(|s| s.run != gauge && gauge < loads.count())
        {
            return Err(bad(format!("vertex copy {i}"), "it belongs to a chain, but is not on its run"));
        }
    }
    let at_rest = |copy: usize| is_at_rest(loads, stations[copy]);
    for (i, copies) in field.corners.iter().enumerate() {
        let along = |apex: usize, other: usize| match (stations[apex], stations[other]) {
            (Some(apex), Some(other)) => along_free_side(problem, loads, apex, other),
            _ => false,
        };
        let fits = |apex: usize, other: usize| along(apex, other) || (at_rest(apex) && at_rest(other));
        check_apexes(field, *copies, &apexes, fits, || format!("triangle {i}"))?;
    }
    Ok((stations, apexes))
}

/// Whether the function beyond an edge differs by no more than an affine function, that of one gauge beyond that of
/// another: at both ends the copies are alike but for these gauges.
fn are_branches(
    field: &LowerField,
    stations: &[Option<Station>],
    here: [usize; 2],
    there: [usize; 2],
) -> bool {
    let bases = |copies: [usize; 2]| {
        let [a, b] = copies.map(|copy| field.copies[copy].jet.base());
        a.filter(|_| a == b)
    };
    let alike = |(a, b): (usize, usize)| {
        let [p, q] = [a, b].map(|copy| field.copies[copy]);
        p.vertex == q.vertex
            && match (p.jet, q.jet) {
                (Jet::Gauge { .. }, Jet::Gauge { .. }) => stations[a].is_some() && stations[a] == stations[b],
                (Jet::OneApex { apex, .. }, Jet::OneApex { apex: other, .. }) => {
                    let same = field.copies[apex].vertex == field.copies[other].vertex;
                    same && p.jet.on(0, apex) == q.jet.on(0, apex)
                }
                _ => p.jet.on(0, 0) == q.jet.on(0, 0),
            }
    };
    bases(here).is_some() && bases(there).is_some() && here.into_iter().zip(there).all(alike)
}

/// Checks that between branches no copy is next to an apex on a line of given shear, and that twins are relative to the polynomial
/// of one surface: what numbers mean may else differ between twins.
pub(super) fn check_branches(
    tiling: &Tiling,
    field: &LowerField,
    is_on_line: impl Fn(usize) -> bool,
    surface: impl Fn(usize) -> usize,
) -> Result<(), CertificateError> {
    for side in tiling.sides() {
        let Beyond::Soil(other) = tiling.beyond(side) else { continue };
        if tiling.member(side).is_some() {
            continue;
        }
        let [end, start] = ends(field, other);
        let here = ends(field, side);
        let depends = |copy: usize| matches!(field.copies[copy].jet, Jet::OneApex { .. }) && is_on_line(copy);
        if here != [start, end] && here.into_iter().any(depends) {
            let what = "branches that part at a line of given shear next to a free surface";
            return Err(CertificateError::NotCovered { place: side.to_string(), what });
        }
        if here.map(&surface) != [start, end].map(&surface) {
            return Err(bad(side.to_string(), "branches part at the surfaces of soil without cohesion"));
        }
    }
    Ok(())
}

/// Whether the function of the gauge is affine to first order at a place.
fn is_at_rest(loads: &Loads, station: Option<Station>) -> bool {
    station.is_some_and(|station| {
        let (f, slopes) = loads.jet(station);
        f.is_zero() && slopes.x.is_zero() && slopes.y.is_zero()
    })
}

/// Checks what a triangle with an apex needs: the coefficient next to each other corner on the edge to the apex must
/// vanish beyond the surface's polynomial, for all apexes. It does on edges along sides without loads.
fn check_apexes(
    field: &LowerField,
    copies: [usize; 3],
    apexes: &[bool],
    fits: impl Fn(usize, usize) -> bool,
    place: impl Fn() -> String,
) -> Result<(), CertificateError> {
    for apex in copies.into_iter().filter(|c| apexes[*c]) {
        let Jet::Gauge { gauge } = field.copies[apex].jet else { continue };
        for copy in copies {
            let suits = match field.copies[copy].jet {
                Jet::Gauge { gauge: base } => {
                    if !fits(apex, copy) {
                        let what =
                            "a load that begins beside bare soil without cohesion, which bears none there";
                        return Err(CertificateError::NotCovered { place: place(), what });
                    }
                    base == gauge
                }
                Jet::Zero { base } | Jet::ManyApexes { base, .. } => base == gauge,
                Jet::OneApex { base, apex: only, .. } => base == gauge && only == apex,
                Jet::Free { .. } | Jet::OneLine { .. } | Jet::TwoLines { .. } | Jet::Kinked { .. } => false,
            };
            if !suits {
                let problem = "a corner beside one at the free surface, where stress must vanish, does not allow for that";
                return Err(bad(place(), problem));
            }
        }
    }
    Ok(())
}
