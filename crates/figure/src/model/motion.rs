//! A figure whose points move.

use super::outline::{bits, outline};
use super::{DataPoint, Figure, Paths, STEPS, Shade, Shades};
use crate::error::FigureError;
use crate::palette::{Rgb, shade};

/// A point and how far it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingPoint {
    /// Where it is at rest, in data units.
    pub at: DataPoint,
    /// By how much it has moved in the end, in data units.
    pub by: DataPoint,
}

impl MovingPoint {
    /// Where it is after a part of the way.
    fn after(self, part: f64) -> DataPoint {
        (self.at.0 + part * self.by.0, self.at.1 + part * self.by.1)
    }

    /// Points are the same where they are and go the same way.
    fn key(self) -> [u64; 4] {
        [self.at.0, self.at.1, self.by.0, self.by.1].map(bits)
    }
}

/// Lines of one style.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MovingLines {
    pub(crate) parts: Vec<Vec<MovingPoint>>,
    pub(crate) width: f64,
    pub(crate) color: Option<usize>,
}

/// A figure whose points move from where they are at rest along straight lines: areas, and lines over them.
///
/// On a page it plays; a file, a print and a page without scripts show its end.
///
/// ```
/// use soilctl_figure::{Axis, Figure, Motion, MovingPoint};
///
/// # fn main() -> Result<(), soilctl_figure::FigureError> {
/// let axis = |label: &str| Axis::linear(label).range(-1.0, 3.0);
/// let mut motion = Motion::new(Figure::new("a block slides", axis("x (m)")?, axis("y (m)")?));
/// let corner = |x, y| MovingPoint { at: (x, y), by: (0.5, 0.0) };
/// let block = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
/// motion.areas(&[block.clone()]).outline(&[block], 1.0);
/// assert!(motion.at(1.0)?.to_csv().contains(",1.5,1.0,"));
/// # Ok(()) }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Title, axes, and layers that stand still.
    pub(crate) still: Figure,
    pub(crate) areas: Vec<Vec<MovingPoint>>,
    pub(crate) lines: Vec<MovingLines>,
}

/// Place of the areas' tone on the scale of shades.
const TONE: f64 = 0.25;

impl Motion {
    /// Title and axes, whose ranges had better be fixed, and layers that stand still below all others.
    pub fn new(still: Figure) -> Self {
        Self { still, areas: Vec::new(), lines: Vec::new() }
    }

    /// Adds areas without outlines: polygons, counter-clockwise. Neighbours whose corners are the same and move the same way
    /// become one.
    pub fn areas(&mut self, rings: &[Vec<MovingPoint>]) -> &mut Self {
        self.areas.extend(outline(rings.iter().map(Vec::as_slice), MovingPoint::key));
        self
    }

    /// Adds lines of a width in px, 0.2 to 12, in a palette colour or grey.
    pub fn lines(&mut self, parts: Vec<Vec<MovingPoint>>, width: f64, color: Option<usize>) -> &mut Self {
        if !parts.is_empty() {
            self.lines.push(MovingLines { parts, width, color });
        }
        self
    }

    /// Adds the outline of polygons, counter-clockwise, in the darkest ink: where they end, and where neighbours do not move
    /// the same way.
    pub fn outline(&mut self, rings: &[Vec<MovingPoint>], width: f64) -> &mut Self {
        let mut parts = outline(rings.iter().map(Vec::as_slice), MovingPoint::key);
        for ring in &mut parts {
            ring.extend(ring.first().copied());
        }
        self.lines(parts, width, Some(INK))
    }

    /// The title.
    pub fn title(&self) -> &str {
        self.still.title()
    }

    /// The colour of the areas.
    pub(crate) fn tone(&self) -> Rgb {
        let shades = Shades::new("", Vec::new(), 0.0, 1.0);
        let reached = (1..STEPS).filter(|&step| shades.threshold(step) <= TONE).max().unwrap_or(1);
        shade(reached as f64 / (STEPS - 1) as f64)
    }

    /// What is there after a part of the way; 1 is its end.
    ///
    /// # Errors
    ///
    /// [`FigureError`] for what cannot be drawn, as [`Figure::push`].
    pub fn at(&self, part: f64) -> Result<Figure, FigureError> {
        let moved = |points: &Vec<MovingPoint>| points.iter().map(|p| p.after(part)).collect::<Vec<_>>();
        let mut figure = self.still.clone();
        if !self.areas.is_empty() {
            let area = |ring| Shade { ring: moved(ring), value: TONE };
            let shades = Shades::new("", self.areas.iter().map(area).collect::<Vec<_>>(), 0.0, 1.0);
            figure.push(shades.without_bar())?;
        }
        for lines in &self.lines {
            let mut paths =
                Paths::new("", lines.parts.iter().map(moved).collect::<Vec<_>>()).width(lines.width);
            paths.color = lines.color;
            figure.push(paths)?;
        }
        Ok(figure)
    }
}

/// Black of the palette.
const INK: usize = 6;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Axis;

    fn square(x: f64, by: f64) -> Vec<MovingPoint> {
        let corner = |x, y| MovingPoint { at: (x, y), by: (by, 0.0) };
        vec![corner(x, 0.0), corner(x + 1.0, 0.0), corner(x + 1.0, 1.0), corner(x, 1.0)]
    }

    fn motion() -> Motion {
        Motion::new(Figure::new("t", Axis::linear("x"), Axis::linear("y")))
    }

    #[test]
    fn neighbours_that_move_together_are_one() {
        let mut together = motion();
        together.areas(&[square(0.0, 0.5), square(1.0, 0.5)]);
        assert_eq!(together.areas.iter().map(Vec::len).collect::<Vec<_>>(), [6]);
        let mut apart = motion();
        apart.areas(&[square(0.0, 0.0), square(1.0, 0.5)]);
        assert_eq!(apart.areas.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4]);
    }

    #[test]
    fn points_move_by_a_part_of_their_way() {
        let mut motion = motion();
        motion.outline(&[square(2.0, 0.5)], 1.0);
        for part in [0.0, 0.5, 1.0] {
            let csv = motion.at(part).unwrap().to_csv();
            let x: Vec<f64> =
                csv.lines().skip(1).map(|l| l.split(',').nth(5).unwrap().parse().unwrap()).collect();
            let ends = x.iter().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(*x), h.max(*x)));
            assert_eq!(ends, (2.0 + 0.5 * part, 3.0 + 0.5 * part));
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        let mut motion = motion();
        motion.outline(&[square(f64::NAN, 0.5)], 1.0);
        assert!(matches!(motion.at(1.0), Err(FigureError::NotFinite { .. })));
        assert!(matches!(
            self::motion().at(0.0).unwrap().to_svg(crate::Size::default()),
            Err(FigureError::EmptyFigure { .. })
        ));
    }
}
