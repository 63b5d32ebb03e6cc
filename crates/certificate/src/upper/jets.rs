//! What the numbers of the stream function's vertex copies mean.

use super::slips;
use super::walls::{WallSide, Walls, way};
use crate::CertificateError;
use crate::fields::{StreamCopy, StreamJet, UpperField};
use crate::interval::{Interval, Vector};
use crate::problem::Problem;
use crate::tiling::{Tiling, fraction};

/// Value and slopes of the stream function.
#[derive(Debug, Clone, Copy)]
pub(super) struct StreamValue {
    pub(super) value: Interval,
    pub(super) slopes: Vector,
}

impl StreamValue {
    /// `(s_y, -s_x)`.
    pub(super) fn velocity(&self) -> Vector {
        -self.slopes.turned()
    }
}

/// Values and slopes at all vertex copies. Numbers and indices have been checked.
pub(super) fn values(
    problem: &Problem,
    tiling: &Tiling,
    field: &UpperField,
    walls: &Walls,
) -> Result<Vec<StreamValue>, CertificateError> {
    let beside = (0..field.stream.len())
        .map(|copy| {
            let value = match (field.stream[copy].jet, walls.at(copy)) {
                (StreamJet::Free { s, sx, sy }, [None, None]) => {
                    Ok(StreamValue { value: s.into(), slopes: Vector::point([sx, sy]) })
                }
                // Once the other copy is known.
                (StreamJet::Kinked { .. } | StreamJet::Slip { .. }, [None, None])
                | (StreamJet::SlipAtWall { .. }, [Some(_), None]) => {
                    Ok(StreamValue { value: Interval::ZERO, slopes: Vector::ZERO })
                }
                (jet, [Some(side), other]) => on_wall(problem, field, copy, jet, side, other),
                (
                    StreamJet::Wall { .. } | StreamJet::Corner { .. } | StreamJet::SlipAtWall { .. },
                    [None, _],
                ) => Err("no edge on its wall ends there"),
                (
                    StreamJet::Free { .. } | StreamJet::Kinked { .. } | StreamJet::Slip { .. },
                    [None, Some(_)],
                ) => Err("it is on a wall"),
            };
            value.map_err(|problem| CertificateError::BadField {
                place: format!("vertex copy {copy}"),
                problem,
            })
        })
        .collect::<Result<Vec<_>, _>>()?;
    let beside = (0..field.stream.len())
        .map(|copy| kinked(problem, field, &beside, copy))
        .collect::<Result<Vec<_>, _>>()?;
    (0..field.stream.len()).map(|copy| slips::value(problem, tiling, field, walls, &beside, copy)).collect()
}

/// Value and slopes of a copy, given those of all that depend on no other.
fn kinked(
    problem: &Problem,
    field: &UpperField,
    beside: &[StreamValue],
    copy: usize,
) -> Result<StreamValue, CertificateError> {
    let StreamCopy { vertex, jet: StreamJet::Kinked { copy: other, line, jump } } = field.stream[copy] else {
        return Ok(beside[copy]);
    };
    let bad = |problem| CertificateError::BadField { place: format!("vertex copy {copy}"), problem };
    let across = field.stream[other];
    if !matches!(across.jet, StreamJet::Free { .. }) || across.vertex != vertex {
        return Err(bad("it must depend on a free copy of the same vertex"));
    }
    let is_on_it = fraction(problem, field.mesh.vertices[vertex].place, line).is_some();
    if problem.piece(line).is_none() || !is_on_it {
        return Err(bad("it depends on a line that is no member on which it is"));
    }
    let StreamValue { value, slopes } = beside[other];
    Ok(StreamValue { value, slopes: slopes + problem.direction(line).turned() * Interval::point(jump) })
}

fn on_wall(
    problem: &Problem,
    field: &UpperField,
    copy: usize,
    jet: StreamJet,
    side: WallSide,
    other: Option<WallSide>,
) -> Result<StreamValue, &'static str> {
    let (wall, slopes) = match (jet, other) {
        (StreamJet::Free { .. } | StreamJet::Kinked { .. } | StreamJet::Slip { .. }, _) => {
            return Err("it is on a wall, which says what its value is");
        }
        (StreamJet::Corner { wall }, Some(other)) => (wall, corner(problem, &side, &other)?),
        (StreamJet::SlipAtWall { .. }, _) => return Err("it slips, and two sides of a wall meet here"),
        (StreamJet::Corner { .. }, None) => return Err("there is only one side of a wall here"),
        (StreamJet::Wall { wall, line, across }, _) => {
            let on = [Some(side), other].into_iter().flatten().find(|s| s.side.line == line);
            let Some(on) = on else { return Err("it is not on the side of a wall that it names") };
            let slopes = along(problem, &on, across);
            for s in [Some(side), other].into_iter().flatten() {
                if !agrees(problem, &on, slopes, &s) {
                    return Err("two sides of a wall meet here, so its slopes follow from them");
                }
            }
            (wall, slopes)
        }
    };
    if wall != side.wall {
        return Err("it is on another wall than the one that it names");
    }
    let place = field.mesh.vertices[field.stream[copy].vertex].place;
    // Where two sides meet, both give the same value.
    let s = way(problem, place, &side).ok_or("it is not on the line of its wall")?;
    Ok(StreamValue { value: Interval::point(field.walls[wall]) + side.value(problem, s), slopes })
}

/// Slopes on a side: along it, as its velocity says, and `across` times the line's vector turned left.
fn along(problem: &Problem, side: &WallSide, across: f64) -> Vector {
    let d = problem.direction(side.side.line);
    let over = d.turned() * Interval::point(across);
    let flow = side.flow(problem);
    if flow.is_zero() { over } else { d * (flow / d.square()) + over }
}

/// Whether slopes that are right for one side are also proven to be for another.
fn agrees(problem: &Problem, on: &WallSide, slopes: Vector, other: &WallSide) -> bool {
    let [a, b] = [on, other].map(|s| problem.direction(s.side.line));
    let parallel = on.side.line == other.side.line || a.cross(b).is_zero();
    let same = on.velocity == other.velocity || [on, other].iter().all(|s| s.flow(problem).is_zero());
    (parallel && same) || (slopes.is_zero() && other.flow(problem).is_zero())
}

/// Slopes where two sides meet.
fn corner(problem: &Problem, first: &WallSide, second: &WallSide) -> Result<Vector, &'static str> {
    let [a, b] = [first, second].map(|s| s.flow(problem));
    if a.is_zero() && b.is_zero() {
        return Ok(Vector::ZERO);
    }
    // The soil moves as the wall does, or as both sides demand.
    if first.velocity == second.velocity {
        return Ok(first.velocity.turned());
    }
    let [p, q] = [first, second].map(|s| problem.direction(s.side.line));
    let area = p.cross(q);
    if area.is_not_zero() {
        Ok((p.turned() * b - q.turned() * a) * (Interval::ONE / area))
    } else {
        Err("two sides of a wall meet here that are not proven to have different directions")
    }
}
