//! What has ends: thin sheets in a half-space of one soil, of which lower bounds may be of any shape; and, for mechanisms and fields in space, the one
//! straight plate from the surface downwards.

use crate::CertificateError;
use crate::interval::{Angle, Interval, Vector, angle};
use crate::problem::{Problem, Strength};
use crate::statement::{Condition, Line, LineUse, Linear, Material, Objective};

/// Friction and adhesion of a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Face {
    pub(super) friction: Angle,
    pub(super) adhesion: Interval,
}

/// Thin sheets that move together in a half-space of one soil: a tool of finite width, in section. Coordinates are those of [`EndedPlate`].
#[derive(Debug)]
pub(super) struct EndedTool<'a> {
    pub(super) soil: &'a Strength,
    pub(super) cohesion: Interval,
    pub(super) material: &'a Material,
    velocity: [f64; 2],
    width: f64,
    /// At least one, each with the faces on the left and on the right of the line.
    sheets: Vec<(usize, Line, [Face; 2])>,
}

/// A plate of finite width in a half-space of one soil.
///
/// Coordinates: x and z as x and y of the statement, y across. The soil is where z is at most the datum, except in
/// the plate, which has the width of the statement, half of it on either side of y = 0.
#[derive(Debug)]
pub(super) struct EndedPlate<'a> {
    pub(super) soil: &'a Strength,
    pub(super) cohesion: Interval,
    pub(super) material: &'a Material,
    pub(super) gravity: Vector,
    pub(super) datum: f64,
    pub(super) surcharge: Interval,
    /// The plate's upper edge, which is at the datum.
    pub(super) top: Vector,
    /// From the upper edge to the lower one.
    pub(super) down: Vector,
    /// The faces on the left and on the right of the way down.
    pub(super) faces: [Face; 2],
    pub(super) velocity: Vector,
    pub(super) half_width: f64,
}

fn not_covered(place: impl Into<String>, what: &'static str) -> CertificateError {
    CertificateError::NotCovered { place: place.into(), what }
}

/// The soil of a statement with a width, and its material: it must be one soil, the same everywhere, without water.
fn only_soil<'a>(problem: &'a Problem) -> Result<(&'a Strength, &'a Material, Interval), CertificateError> {
    let ([region], [strength]) = (problem.statement.regions.as_slice(), problem.strengths.as_slice()) else {
        return Err(not_covered("the regions", "with a width there is one soil only"));
    };
    let Linear { at_origin, gradient } = region.material.cohesion;
    let what = match &region.material {
        m if m.tension.is_some() => "with a width the soil has no limit to its tension",
        m if !m.pore_pressure.is_zero() => "with a width there is no water in the pores",
        _ if gradient != [0.0; 2] => "with a width the cohesion is the same everywhere",
        m if m.phi_deg == 0.0 => "with a width the soil has friction",
        material => return Ok((strength, material, Interval::point(at_origin))),
    };
    Err(not_covered("region 0", what))
}

impl<'a> EndedTool<'a> {
    /// Reads the tool from a statement.
    ///
    /// # Errors
    ///
    /// [`CertificateError::NotCovered`] if that is not what it states.
    pub(super) fn new(problem: &'a Problem) -> Result<Self, CertificateError> {
        let statement = problem.statement;
        let Some(width) = statement.width else {
            return Err(not_covered(
                "the statement",
                "a mechanism in space needs the width of the structure",
            ));
        };
        let Objective::Structure { velocity } = statement.objective else {
            return Err(not_covered("the objective", "with a width it is the force of a structure"));
        };
        let (soil, material, cohesion) = only_soil(problem)?;
        if !(problem.far.left && problem.far.right && problem.far.below) {
            return Err(not_covered("the far lines", "with a width the soil goes on left, right and below"));
        }
        let mut sheets = Vec::new();
        for (i, line) in statement.lines.iter().enumerate() {
            let sides = [true, false].map(|forward| LineUse { line: i, forward });
            let at_datum = [line.from, line.to].map(|p| statement.points[p][1] == statement.datum);
            match sides.map(|side| problem.condition(side)) {
                // Far lines frame the soil, and what lies along its top is at the datum.
                [Some(Condition::Far), None] | [None, Some(Condition::Far)] => {}
                [Some(Condition::Free), None] | [None, Some(Condition::Free)] if at_datum == [true; 2] => {}
                [
                    Some(Condition::Face { delta_deg: left, adhesion: holds_left }),
                    Some(Condition::Face { delta_deg: right, adhesion: holds_right }),
                ] => sheets.push((i, *line, [face(left, holds_left)?, face(right, holds_right)?])),
                _ => {
                    let what =
                        "with a width, lines are far, free along the datum, or thin sheets of one tool";
                    return Err(not_covered(format!("line {i}"), what));
                }
            }
        }
        if sheets.is_empty() {
            return Err(not_covered("the lines", "with a width one of them is a sheet of a tool"));
        }
        Ok(Self { soil, cohesion, material, velocity, width, sheets })
    }
}

impl<'a> EndedPlate<'a> {
    /// Reads the plate from a statement.
    ///
    /// # Errors
    ///
    /// [`CertificateError::NotCovered`] if that is not what it states.
    pub(super) fn new(problem: &'a Problem) -> Result<Self, CertificateError> {
        let statement = problem.statement;
        let EndedTool { soil, cohesion, material, velocity, width, sheets } = EndedTool::new(problem)?;
        let (line, faces) = match sheets.as_slice() {
            [] => return Err(not_covered("the lines", "with a width one of them is a plate")),
            [(i, line, [left, right])] => {
                match [line.from, line.to].map(|p| statement.points[p][1] == statement.datum) {
                    [true, false] => (*line, [*left, *right]),
                    [false, true] => (Line { from: line.to, to: line.from }, [*right, *left]),
                    [true, true] | [false, false] => {
                        let what = "a mechanism in space is of one thin plate that hangs from the datum";
                        return Err(not_covered(format!("line {i}"), what));
                    }
                }
            }
            [_, (i, _, _), ..] => {
                let what = "a mechanism in space is of one thin plate that hangs from the datum";
                return Err(not_covered(format!("line {i}"), what));
            }
        };
        let [top, tip] = [line.from, line.to].map(|p| Vector::point(statement.points[p]));
        Ok(Self {
            soil,
            cohesion,
            material,
            gravity: Vector::point(statement.gravity),
            datum: statement.datum,
            surcharge: Interval::point(statement.surcharge),
            top,
            down: tip - top,
            faces,
            velocity: Vector::point(velocity),
            half_width: 0.5 * width,
        })
    }
}

fn face(delta_deg: f64, adhesion: f64) -> Result<Face, CertificateError> {
    if delta_deg == 0.0 && adhesion > 0.0 {
        return Err(not_covered("the plate", "adhesion without interface friction on soil with friction"));
    }
    Ok(Face { friction: angle(delta_deg), adhesion: Interval::point(adhesion) })
}
