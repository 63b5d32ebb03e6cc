//! Whether a field has what it must have, and a statement only what is covered.

use crate::CertificateError;
use crate::fields::{Flow, MemberMotion, StreamJet, UpperField, Velocity};
use crate::interval::Vector;
use crate::problem::{Problem, exists, finite};
use crate::statement::{Condition, Statement};
use crate::tiling::Tiling;

/// Whether the soil of a region has no friction.
pub(super) fn is_frictionless(statement: &Statement, region: usize) -> bool {
    statement.regions[region].material.phi_deg == 0.0
}

/// Checks that the structure has no ends, at which a flow in the plane would not end.
pub(super) fn plane(statement: &Statement) -> Result<(), CertificateError> {
    if statement.width.is_none() {
        return Ok(());
    }
    let what = "a flow in the plane proves nothing about a structure with ends; a mechanism in space does";
    Err(CertificateError::NotCovered { place: "the upper bound".into(), what })
}

/// Checks that faces are such that their slip can be accounted for.
pub(super) fn faces(problem: &Problem) -> Result<(), CertificateError> {
    for (i, boundary) in problem.statement.boundaries.iter().enumerate() {
        let Condition::Face { delta_deg, adhesion } = boundary.condition else { continue };
        let Some(region) = problem.owner(boundary.side()) else { continue };
        let what = match (is_frictionless(problem.statement, region), delta_deg == 0.0) {
            (true, false) => "interface friction on soil without friction",
            (false, true) if adhesion > 0.0 => "adhesion without interface friction on soil with friction",
            _ => continue,
        };
        return Err(CertificateError::NotCovered { place: format!("boundary {i}"), what });
    }
    Ok(())
}

/// Checks that all numbers of a field are finite and all indices point at something.
pub(super) fn numbers(problem: &Problem, field: &UpperField) -> Result<(), CertificateError> {
    let (found, needed) = (field.flows.len(), field.mesh.triangles.len());
    if found != needed {
        return Err(CertificateError::Length { list: "flows", found, needed, each: "triangle" });
    }
    for (i, flow) in field.flows.iter().enumerate() {
        let place = || format!("triangle {i}");
        match flow {
            Flow::Quadratic(nodes) => nodes
                .iter()
                .try_for_each(|node| exists(place, "control point", *node, field.velocities.len()))?,
            Flow::Stream { corners, slopes } => {
                corners.iter().try_for_each(|c| exists(place, "vertex copy", *c, field.stream.len()))?;
                slopes.iter().try_for_each(|slope| finite("slope", place, *slope, ""))?;
            }
        }
    }
    let lines = problem.statement.lines.len();
    for (i, velocity) in field.velocities.iter().enumerate() {
        let place = || format!("control point {i}");
        match *velocity {
            Velocity::Zero => {}
            Velocity::Slide { line, value } => {
                exists(place, "line", line, lines)?;
                finite("velocity", place, value, "")?;
            }
            Velocity::Free { x, y } => {
                finite("velocity along x", place, x, "")?;
                finite("velocity along y", place, y, "")?;
            }
        }
    }
    for (i, copy) in field.stream.iter().enumerate() {
        let place = || format!("vertex copy {i}");
        exists(place, "vertex", copy.vertex, field.mesh.vertices.len())?;
        match copy.jet {
            StreamJet::Free { s, sx, sy } => {
                [s, sx, sy].into_iter().try_for_each(|x| finite("value or slope", place, x, ""))?;
            }
            StreamJet::Wall { wall, line, across } => {
                exists(place, "wall", wall, field.walls.len())?;
                exists(place, "line", line, lines)?;
                finite("slope across", place, across, "")?;
            }
            StreamJet::Slip { copy, towards, jump } => {
                exists(place, "vertex copy", copy, field.stream.len())?;
                exists(place, "vertex", towards, field.mesh.vertices.len())?;
                finite("jump of the slope", place, jump, "")?;
            }
            StreamJet::SlipAtWall { copy, towards } => {
                exists(place, "vertex copy", copy, field.stream.len())?;
                exists(place, "vertex", towards, field.mesh.vertices.len())?;
            }
            StreamJet::Corner { wall } => exists(place, "wall", wall, field.walls.len())?,
            StreamJet::Kinked { copy, line, jump } => {
                exists(place, "vertex copy", copy, field.stream.len())?;
                exists(place, "line", line, lines)?;
                finite("jump of the slope", place, jump, "")?;
            }
        }
    }
    for (i, piece) in field.members.iter().enumerate() {
        let place = || format!("piece {i} of the members");
        exists(place, "triangle", piece.triangle, field.flows.len())?;
        exists(place, "edge", piece.corner, 3)?;
        for motion in piece.motion {
            let numbers = match motion {
                MemberMotion::Soil => [0.0; 2],
                MemberMotion::Along { along } => [along, 0.0],
                MemberMotion::Free { along, across } => [along, across],
            };
            numbers.into_iter().try_for_each(|x| finite("velocity", place, x, ""))?;
        }
        piece.slip.into_iter().try_for_each(|x| finite("slip", place, x, ""))?;
    }
    field.walls.iter().enumerate().try_for_each(|(i, x)| finite("value", || format!("wall {i}"), *x, ""))
}

/// Checks that each triangle has the kind of flow that its soil needs.
pub(super) fn flows(
    problem: &Problem,
    tiling: &Tiling,
    field: &UpperField,
    velocities: &[Vector],
) -> Result<(), CertificateError> {
    for (i, flow) in field.flows.iter().enumerate() {
        let at_rest = |node: &usize| velocities[*node].is_zero();
        let region = tiling.region(i);
        let may_tear = problem.statement.regions[region].material.tension.is_some();
        let problem = match (is_frictionless(problem.statement, region), flow) {
            (true, Flow::Quadratic(nodes)) if !may_tear && !nodes.iter().all(at_rest) => {
                "soil without friction and of unlimited tension that is not at rest needs a stream function"
            }
            (false, Flow::Stream { .. }) => "soil with friction needs a quadratic flow",
            (true, Flow::Stream { corners, .. })
                if corners.map(|c| field.stream[c].vertex) != field.mesh.triangles[i].corners =>
            {
                "its vertex copies are not copies of its corners"
            }
            _ => continue,
        };
        return Err(CertificateError::BadField { place: format!("triangle {i}"), problem });
    }
    Ok(())
}
