//! An entity as a polygon or a line.

use std::f64::consts::TAU;

use super::arc::{bulged, chords};
use super::pairs::{Pair, unescaped};
use crate::{DrawingError, MOST_CORNERS, Outline, Point, Shape, Why};

/// An entity of the drawing.
pub(super) struct Entity<'p, 'a> {
    /// What it is.
    pub(super) kind: &'a str,
    pub(super) pairs: &'p [Pair<'a>],
    /// Pairs of each vertex of a polyline.
    pub(super) vertices: Vec<&'p [Pair<'a>]>,
}

/// What became of it.
pub(super) struct Line {
    pub(super) shape: Shape,
    pub(super) has_arcs: bool,
}

/// Corners with their bulges, and whether the last is joined to the first.
struct Bulges {
    corners: Vec<(Point, f64)>,
    is_closed: bool,
}

fn first<'p, 'a>(pairs: &'p [Pair<'a>], code: i32) -> Option<&'p Pair<'a>> {
    pairs.iter().find(|pair| pair.code == code)
}

/// A number that has a default.
fn number(pairs: &[Pair<'_>], code: i32, otherwise: f64) -> Result<f64, DrawingError> {
    first(pairs, code).map_or(Ok(otherwise), Pair::number)
}

fn flags(pairs: &[Pair<'_>]) -> i32 {
    first(pairs, 70).map_or(0, Pair::flags)
}

impl Entity<'_, '_> {
    /// Name of its layer.
    pub(super) fn layer(&self) -> String {
        first(self.pairs, 8).map_or_else(|| "0".into(), |pair| unescaped(pair.value.trim()))
    }

    /// The line that it is, in metres; otherwise why it is left out.
    ///
    /// # Errors
    /// If a number of it makes no sense.
    pub(super) fn line(&self, metres: f64, chord_m: f64) -> Result<Result<Line, Why>, DrawingError> {
        if first(self.pairs, 67).is_some_and(|pair| pair.flags() == 1) {
            return Ok(Err(Why::other("it is on a sheet, not in the model")));
        }
        if let Some(why) = self.plane()? {
            return Ok(Err(why));
        }
        let near = chord_m / metres;
        let found = match self.kind {
            "LINE" => Ok(self.straight()?),
            "LWPOLYLINE" => Ok(bent(&self.light()?, near)),
            "POLYLINE" if flags(self.pairs) & (16 | 64) != 0 => Err(Why::shape("it is a mesh")),
            "POLYLINE" => Ok(bent(&self.heavy()?, near)),
            "ARC" => Ok(self.arc(near)?),
            "CIRCLE" => Ok(self.circle(near)?),
            "INSERT" => Err(Why::shape("it is a block; explode it")),
            "HATCH" => Err(Why::other("hatches are not read; their outline is")),
            "SPLINE" | "ELLIPSE" => {
                Err(Why::shape("curves other than arcs are not read; make it a polyline"))
            }
            "TEXT" | "MTEXT" | "DIMENSION" | "LEADER" | "MULTILEADER" => {
                Err(Why::other("texts are not read"))
            }
            "POINT" => Err(Why::other("points are not read")),
            _ => Err(Why::shape("it is none of LINE, ARC, CIRCLE, LWPOLYLINE, POLYLINE")),
        };
        Ok(found.map(|(corners, outline, has_arcs)| {
            let corners = corners.into_iter().map(|[x, y]| [metres * x, metres * y]).collect();
            Line { shape: Shape { layer: self.layer(), corners, outline }, has_arcs }
        }))
    }

    /// Why it lies in another plane, if it does.
    fn plane(&self) -> Result<Option<Why>, DrawingError> {
        let normal =
            [(210, 0.0), (220, 0.0), (230, 1.0)].map(|(code, usual)| number(self.pairs, code, usual));
        let [x, y, z] = normal;
        let is_ours = x?.abs() < 1e-9 && y?.abs() < 1e-9 && z? > 0.0;
        Ok((!is_ours).then_some(Why::shape("it is drawn in another plane than x and y")))
    }

    fn straight(&self) -> Result<(Vec<Point>, Outline, bool), DrawingError> {
        let at = |x, y| -> Result<Point, DrawingError> {
            Ok([number(self.pairs, x, 0.0)?, number(self.pairs, y, 0.0)?])
        };
        Ok((vec![at(10, 20)?, at(11, 21)?], Outline::Open, false))
    }

    fn light(&self) -> Result<Bulges, DrawingError> {
        let mut corners: Vec<(Point, f64)> = Vec::new();
        for pair in self.pairs {
            match (pair.code, corners.last_mut()) {
                (10, _) => corners.push(([pair.number()?, 0.0], 0.0)),
                (20, Some((corner, _))) => corner[1] = pair.number()?,
                (42, Some((_, bulge))) => *bulge = pair.number()?,
                _ => {}
            }
        }
        Ok(Bulges { corners, is_closed: flags(self.pairs) & 1 == 1 })
    }

    fn heavy(&self) -> Result<Bulges, DrawingError> {
        // Points of the frame of a spline, which is beside the line.
        let is_frame = |vertex: &&[Pair<'_>]| flags(vertex) & 16 != 0;
        let mut corners = Vec::new();
        for vertex in self.vertices.iter().filter(|vertex| !is_frame(vertex)) {
            let point = [number(vertex, 10, 0.0)?, number(vertex, 20, 0.0)?];
            corners.push((point, number(vertex, 42, 0.0)?));
        }
        Ok(Bulges { corners, is_closed: flags(self.pairs) & 1 == 1 })
    }

    fn round(&self) -> Result<(Point, f64), DrawingError> {
        let centre = [number(self.pairs, 10, 0.0)?, number(self.pairs, 20, 0.0)?];
        Ok((centre, number(self.pairs, 40, 0.0)?.abs()))
    }

    fn arc(&self, near: f64) -> Result<(Vec<Point>, Outline, bool), DrawingError> {
        let (centre, radius) = self.round()?;
        let [from, to] = [number(self.pairs, 50, 0.0)?, number(self.pairs, 51, 360.0)?].map(f64::to_radians);
        // Counter-clockwise, whatever turns the angles have.
        let over = (to - from).rem_euclid(TAU);
        let over = if over == 0.0 { TAU } else { over };
        let start = [centre[0] + radius * libm::cos(from), centre[1] + radius * libm::sin(from)];
        let mut corners = vec![start];
        corners.extend(chords(centre, radius, from, over, near));
        Ok((corners, Outline::Open, true))
    }

    fn circle(&self, near: f64) -> Result<(Vec<Point>, Outline, bool), DrawingError> {
        let (centre, radius) = self.round()?;
        Ok((chords(centre, radius, 0.0, TAU, near), Outline::Closed, true))
    }
}

/// A polyline without bulges.
fn bent(line: &Bulges, near: f64) -> (Vec<Point>, Outline, bool) {
    let Bulges { corners, is_closed } = line;
    let mut points: Vec<Point> = corners.iter().take(1).map(|(point, _)| *point).collect();
    for two in corners.windows(2) {
        // Refused by whoever counts them, before arcs make more of it than there is memory.
        if points.len() > MOST_CORNERS {
            break;
        }
        points.extend(bulged(two[0].0, two[1].0, two[0].1, near));
    }
    if let (true, [(start, _), .., (end, bulge)]) = (is_closed, &corners[..]) {
        points.extend(bulged(*end, *start, *bulge, near));
        points.pop();
    }
    // Many draw the first corner once more instead of saying that it is closed.
    let returns = points.len() > 3 && points.first() == points.last();
    if returns {
        points.pop();
    }
    let outline = if *is_closed || returns { Outline::Closed } else { Outline::Open };
    (points, outline, corners.iter().any(|(_, bulge)| *bulge != 0.0))
}
