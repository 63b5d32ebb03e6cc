//! The outline of a tool: turned, put into the ground, and cut off at the surface.

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::AppError;

pub(super) type Point = [f64; 2];

/// What an angle of a whole tool is the angle of.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum AlphaOf {
    /// The straight line from the tip to the top
    #[default]
    Chord,
    /// The piece at the tip
    Tip,
}

/// A straight piece of a tool from its lower end, as seen along the tool, to its upper one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    pub(super) ends: [Point; 2],
    pub(super) delta_deg: f64,
    pub(super) adhesion_pa: f64,
}

impl Piece {
    /// Its tool angle: from the horizontal, below 90 where its lower end is ahead.
    pub(super) fn alpha_deg(&self) -> f64 {
        alpha_deg(self.ends)
    }

    fn has_interface_of(&self, other: &Self) -> bool {
        self.delta_deg == other.delta_deg && self.adhesion_pa == other.adhesion_pa
    }
}

/// The tool angle of a line from tip to top, above -180 up to 180; exact where the line is upright.
fn alpha_deg([tip, top]: [Point; 2]) -> f64 {
    let [x, y] = [tip[0] - top[0], top[1] - tip[1]];
    if x == 0.0 { 90.0f64.copysign(y) } else { y.atan2(x).to_degrees() }
}

/// A thin rigid tool: straight pieces, each from the end of the one before.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    pieces: Vec<Piece>,
    /// How far the arc that they stand for is away at most.
    pub(super) off_arc_m: f64,
    /// Corners of the hull of the side plates, as seen from the side; none without them.
    pub(super) side_plates: Vec<Point>,
}

impl Shape {
    pub(super) fn new(pieces: Vec<Piece>, off_arc_m: f64) -> Result<Self, AppError> {
        let wrong = |words: String| Err(AppError::Request(words));
        for (index, Piece { ends: [a, b], .. }) in pieces.iter().enumerate() {
            let number = index + 1;
            if a.iter().chain(b).any(|x| !x.is_finite() || x.abs() > 1e6) {
                return wrong(format!("piece {number} of the tool reaches beyond 1e6 m, or is no number"));
            }
            if a == b {
                return wrong(format!(
                    "piece {number} of the tool has no length: both its ends are at ({}, {})",
                    a[0], a[1]
                ));
            }
        }
        if pieces.is_empty() {
            return wrong("the tool has no piece".into());
        }
        for (i, one) in pieces.iter().enumerate() {
            for (j, other) in pieces.iter().enumerate().skip(i + 1) {
                let meets = if j == i + 1 { folds(one.ends, other.ends) } else { meet(one.ends, other.ends) };
                if meets {
                    return wrong(format!(
                        "pieces {} and {} of the tool meet; a tool does not cross itself",
                        i + 1,
                        j + 1
                    ));
                }
            }
        }
        Ok(Self { pieces, off_arc_m, side_plates: Vec::new() })
    }

    pub(super) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    pub(super) fn tip(&self) -> Point {
        self.pieces.first().map_or([0.0; 2], |piece| piece.ends[0])
    }

    pub(super) fn top(&self) -> Point {
        self.pieces.last().map_or([0.0; 2], |piece| piece.ends[1])
    }

    pub(super) fn points(&self) -> impl Iterator<Item = Point> + '_ {
        std::iter::once(self.tip()).chain(self.pieces.iter().map(|piece| piece.ends[1]))
    }

    /// Tool angle of the chord, from the tip to the top.
    pub(super) fn chord_alpha_deg(&self) -> f64 {
        alpha_deg([self.tip(), self.top()])
    }

    pub(super) fn chord_m(&self) -> f64 {
        let ([x0, y0], [x1, y1]) = (self.tip(), self.top());
        (x1 - x0).hypot(y1 - y0)
    }

    /// Tool angle of the piece at the tip.
    pub(super) fn tip_alpha_deg(&self) -> f64 {
        self.pieces.first().map_or(90.0, Piece::alpha_deg)
    }

    /// Whether it is one straight line with one interface, which is what `bound` is about.
    pub(super) fn is_flat(&self) -> bool {
        let (tip, top) = (self.tip(), self.top());
        let near = 1e-9 * self.chord_m();
        let off =
            |p: Point| ((top[0] - tip[0]) * (p[1] - tip[1]) - (top[1] - tip[1]) * (p[0] - tip[0])).abs();
        self.pieces.iter().all(|piece| piece.has_interface_of(&self.pieces[0]))
            && self.points().all(|p| off(p) <= near * self.chord_m())
    }

    /// Pieces in runs of one interface, as points.
    pub(super) fn runs(&self) -> Vec<(Piece, Vec<Point>)> {
        let mut runs: Vec<(Piece, Vec<Point>)> = Vec::new();
        for piece in &self.pieces {
            match runs.last_mut() {
                Some((first, points)) if first.has_interface_of(piece) => points.push(piece.ends[1]),
                _ => runs.push((*piece, piece.ends.to_vec())),
            }
        }
        runs
    }

    fn map(&self, place: impl Fn(Point) -> Point) -> Self {
        let piece = |piece: &Piece| Piece { ends: piece.ends.map(&place), ..*piece };
        Self {
            pieces: self.pieces.iter().map(piece).collect(),
            off_arc_m: self.off_arc_m,
            side_plates: self.side_plates.iter().map(|p| place(*p)).collect(),
        }
    }

    /// The same with side plates of these corners.
    pub(super) fn with_side_plates(self, corners: &[Point]) -> Self {
        Self { side_plates: corners.to_vec(), ..self }
    }

    /// Turned so that its chord or its tip has a tool angle.
    pub(super) fn turned_to(&self, wanted_deg: f64, of: AlphaOf) -> Self {
        let own = match of {
            AlphaOf::Chord => self.chord_alpha_deg(),
            AlphaOf::Tip => self.tip_alpha_deg(),
        };
        // A greater tool angle is a turn against the clock, seen with the motion to the right, less that angles run from the other side.
        let (sin, cos) = (own - wanted_deg).to_radians().sin_cos();
        if own == wanted_deg {
            return self.clone();
        }
        self.map(|[x, y]| [x * cos - y * sin, x * sin + y * cos])
    }

    /// Put into the ground with its lowest point at a depth below the surface, vertically; by default so that its highest point is at the
    /// surface. The result is in axes along and across a surface of the given slope; its origin is where the tool, walked from its top,
    /// first goes through the surface, or straight above the top of a buried one. What sticks out is cut off.
    pub(super) fn placed(&self, depth_m: Option<f64>, beta_deg: f64) -> Result<Self, AppError> {
        let height = |pick: fn(f64, f64) -> f64, from: f64| self.points().map(|p| p[1]).fold(from, pick);
        let low = height(f64::min, f64::INFINITY);
        let high = height(f64::max, f64::NEG_INFINITY);
        let level = depth_m.map_or(high, |depth| low + depth);
        let anchor = if level >= high {
            let highest = self.points().filter(|p| p[1] == high).last();
            [highest.map_or(0.0, |p| p[0]), level]
        } else {
            let crossing = |piece: &Piece| {
                let [a, b] = piece.ends;
                let is_across = (a[1] - level) * (b[1] - level) <= 0.0 && a[1] != b[1];
                is_across.then(|| [a[0] + (b[0] - a[0]) * (level - a[1]) / (b[1] - a[1]), level])
            };
            self.pieces.iter().rev().find_map(crossing).unwrap_or([self.top()[0], level])
        };
        let (sin, cos) = beta_deg.to_radians().sin_cos();
        let near = 1e-9 * (high - low).max(self.chord_m());
        let along = |p: Point| {
            let [x, y] = [p[0] - anchor[0], p[1] - anchor[1]];
            let [x, y] = [x * cos + y * sin, y * cos - x * sin];
            // The surface is exactly level.
            [x, if y.abs() <= near { 0.0 } else { y }]
        };
        let placed = self.map(along);
        let pieces: Vec<Piece> = placed.pieces.iter().filter_map(cut_off).collect();
        if pieces.is_empty() {
            return Err(AppError::Request(
                "no part of the tool is in the ground; give a greater --depth".into(),
            ));
        }
        if pieces.windows(2).any(|pair| pair[0].ends[1] != pair[1].ends[0]) {
            return Err(AppError::Request(
                "the tool goes through the surface in the middle, so that it is in the ground in several parts; put it deeper, or turn it".into(),
            ));
        }
        Ok(Self { pieces, off_arc_m: self.off_arc_m, side_plates: below_surface(&placed.side_plates) })
    }
}

/// Corners of the part below y = 0 of the hull of some points, and perhaps points inside it.
fn below_surface(corners: &[Point]) -> Vec<Point> {
    let [above, mut below]: [Vec<Point>; 2] =
        [true, false].map(|is_above| corners.iter().copied().filter(|p| (p[1] > 0.0) == is_above).collect());
    let sunk = below.len();
    for [xa, ya] in above {
        for index in 0..sunk {
            let [xb, yb] = below[index];
            below.push([xb + (xa - xb) * yb / (yb - ya), 0.0]);
        }
    }
    below
}

/// The part of a piece that is in the ground below y = 0.
fn cut_off(piece: &Piece) -> Option<Piece> {
    let [a, b] = piece.ends;
    let at_surface = || [a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1]), 0.0];
    let ends = match (a[1] > 0.0, b[1] > 0.0) {
        _ if a[1] >= 0.0 && b[1] >= 0.0 => return None,
        (true, _) => [at_surface(), b],
        (_, true) => [a, at_surface()],
        (false, false) => [a, b],
    };
    Some(Piece { ends, ..*piece })
}

fn cross(o: Point, a: Point, b: Point) -> f64 {
    (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])
}

/// Whether a piece goes back along the one before.
fn folds([a, b]: [Point; 2], [_, c]: [Point; 2]) -> bool {
    let forward = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    let long = (b[0] - a[0]).hypot(b[1] - a[1]) * (c[0] - b[0]).hypot(c[1] - b[1]);
    forward < 0.0 && cross(a, b, c).abs() <= 1e-6 * long
}

/// Whether two lines have a point in common.
pub(crate) fn meet([a, b]: [Point; 2], [c, d]: [Point; 2]) -> bool {
    let within = |p: Point, [u, v]: [Point; 2]| {
        (0..2).all(|axis| p[axis] >= u[axis].min(v[axis]) && p[axis] <= u[axis].max(v[axis]))
    };
    let [c_side, d_side] = [cross(a, b, c), cross(a, b, d)];
    let [a_side, b_side] = [cross(c, d, a), cross(c, d, b)];
    (c_side * d_side < 0.0 && a_side * b_side < 0.0)
        || (c_side == 0.0 && within(c, [a, b]))
        || (d_side == 0.0 && within(d, [a, b]))
        || (a_side == 0.0 && within(a, [c, d]))
        || (b_side == 0.0 && within(b, [c, d]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(points: &[Point]) -> Result<Shape, AppError> {
        let piece = |ends: &[Point]| Piece { ends: [ends[0], ends[1]], delta_deg: 20.0, adhesion_pa: 0.0 };
        Shape::new(points.windows(2).map(piece).collect(), 0.0)
    }

    fn close(found: Point, wanted: Point) {
        assert!(found.iter().zip(wanted).all(|(f, w)| (f - w).abs() < 1e-12), "{found:?}, wanted {wanted:?}");
    }

    #[test]
    fn turning_gives_the_angle_of_chord_or_tip_and_keeps_lengths() {
        let bent = shape(&[[0.2, 0.0], [0.0, 0.1], [-0.05, 0.3]]).unwrap();
        for (of, wanted) in [(AlphaOf::Chord, 60.0), (AlphaOf::Tip, 15.0), (AlphaOf::Chord, 120.0)] {
            let turned = bent.turned_to(wanted, of);
            let found = match of {
                AlphaOf::Chord => turned.chord_alpha_deg(),
                AlphaOf::Tip => turned.tip_alpha_deg(),
            };
            assert!((found - wanted).abs() < 1e-9, "{found}");
            assert!((turned.chord_m() - bent.chord_m()).abs() < 1e-12);
            let kink = |s: &Shape| s.pieces()[1].alpha_deg() - s.pieces()[0].alpha_deg();
            assert!((kink(&turned) - kink(&bent)).abs() < 1e-9);
        }
    }

    #[test]
    fn what_sticks_out_is_cut_off() {
        let plate = shape(&[[0.0, 0.0], [-0.3, 0.4]]).unwrap();
        let whole = plate.placed(None, 0.0).unwrap();
        close(whole.top(), [0.0, 0.0]);
        close(whole.tip(), [0.3, -0.4]);
        let half = plate.placed(Some(0.2), 0.0).unwrap();
        close(half.top(), [0.0, 0.0]);
        close(half.tip(), [0.15, -0.2]);
        let buried = plate.placed(Some(1.0), 0.0).unwrap();
        close(buried.top(), [0.0, -0.6]);
        close(buried.tip(), [0.3, -1.0]);
    }

    #[test]
    fn side_plates_go_along_and_are_cut_off_too() {
        let plate =
            shape(&[[0.0, 0.0], [0.0, 0.4]]).unwrap().with_side_plates(&[[0.0, 0.0], [0.2, 0.0], [0.0, 0.4]]);
        let placed = plate.placed(Some(0.2), 0.0).unwrap();
        assert_eq!(placed.side_plates.len(), 4);
        for (found, wanted) in
            placed.side_plates.iter().zip([[0.0, -0.2], [0.2, -0.2], [0.0, 0.0], [0.1, 0.0]])
        {
            close(*found, wanted);
        }
    }

    #[test]
    fn on_a_slope_the_angle_against_the_surface_is_the_sum() {
        let plate = shape(&[[0.0, 0.0], [-0.5, 0.5]]).unwrap();
        let placed = plate.placed(None, 10.0).unwrap();
        assert!((placed.chord_alpha_deg() - 55.0).abs() < 1e-9);
        assert!((placed.chord_m() - plate.chord_m()).abs() < 1e-12);
    }

    #[test]
    fn tools_that_meet_themselves_or_come_out_in_the_middle_are_refused() {
        for (points, words) in [
            (&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, -1.0]][..], "pieces 1 and 3"),
            (&[[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]], "pieces 1 and 2"),
            (&[[0.0, 0.0], [0.0, 0.0]], "no length"),
            (&[[0.0, 0.0], [0.0, f64::NAN]], "no number"),
        ] {
            assert!(shape(points).unwrap_err().to_string().contains(words));
        }
        let arch = shape(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.5]]).unwrap();
        assert!(arch.placed(Some(0.8), 0.0).unwrap_err().to_string().contains("in several parts"));
    }

    #[test]
    fn collinear_pieces_are_flat_only_with_one_interface() {
        let mut flat = shape(&[[0.3, 0.0], [0.2, 0.1], [0.0, 0.3]]).unwrap();
        assert!(flat.is_flat());
        assert_eq!(flat.runs().len(), 1);
        flat.pieces[1].delta_deg = 10.0;
        assert!(!flat.is_flat());
        assert_eq!(flat.runs().len(), 2);
        assert!(!shape(&[[0.3, 0.0], [0.2, 0.2], [0.0, 0.3]]).unwrap().is_flat());
    }
}
