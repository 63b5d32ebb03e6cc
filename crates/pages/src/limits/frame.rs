//! What part of the soil figures show, and what they all show: ground and structures.

use soilctl_app::limits::Fields;
use soilctl_certificate::{Condition, LineUse, Statement};
use soilctl_figure::{Axis, Figure, Paths, Size};
use soilctl_limit_analysis::results::{FlowResults, MOVING, Point};

use super::interfaces::{between_soils, water_table};
use crate::PageError;

/// Black.
pub(super) const INK: usize = 6;
/// Light blue.
const WATER: usize = 5;

/// Green, and vermilion.
const MEMBER: usize = 2;
const YIELDING: usize = 1;

/// Soil round what moves, over the size of what moves.
const MARGIN: f64 = 0.12;
/// Pixels that axes, title and legend take.
const AROUND: [f64; 2] = [90.0, 150.0];
const WIDTH: f64 = 900.0;

/// The part of the soil that is fields, in the units of the statement.
pub(super) struct Window {
    pub(super) low: Point,
    pub(super) high: Point,
    pub(super) size: Size,
}

impl Window {
    pub(super) fn new(fields: &Fields) -> Result<Self, PageError> {
        let statement = fields.statement()?;
        let mut points = on_lines(statement, |c| matches!(c, Condition::Face { .. }));
        if let Some(flow) = &fields.flow {
            points.extend(flow.failure_surface(MOVING));
            points.extend(flow.moving_ground(MOVING).iter().map(|s| vec![s.from, s.to]));
        }
        let [low, high] = bounds(points.iter().flatten());
        let soil = bounds(statement.points.iter());
        // Without flow and structure there is nothing to look at in particular.
        let [low, high] = if low[0] < high[0] || low[1] < high[1] { [low, high] } else { soil };
        let margin = MARGIN * (high[0] - low[0]).max(high[1] - low[1]);
        let [low, high] = [
            [0, 1].map(|i| (low[i] - margin).max(soil[0][i] - 0.3 * margin)),
            [0, 1].map(|i| (high[i] + margin).min(soil[1][i] + 0.5 * margin)),
        ];
        let wide = (high[1] - low[1]) / (high[0] - low[0]);
        let height = ((WIDTH - AROUND[0]) * wide + AROUND[1]).clamp(360.0, 1100.0);
        Ok(Self { low, high, size: Size::new(WIDTH as u32, height as u32)? })
    }

    /// With as much more of what is above.
    pub(super) fn with_room_above(&self, height: f64) -> Self {
        let high = [self.high[0], self.high[1] + height];
        Self { low: self.low, high, size: self.size }
    }

    /// Whether a triangle may be seen.
    pub(super) fn shows(&self, t: &[Point; 3]) -> bool {
        let [low, high] = bounds(t.iter());
        (0..2).all(|i| high[i] >= self.low[i] && low[i] <= self.high[i])
    }

    /// What of these lines may be seen.
    fn shown(&self, lines: Vec<Vec<Point>>) -> Vec<Vec<Point>> {
        let is_seen = |line: &Vec<Point>| {
            let [low, high] = bounds(line.iter());
            (0..2).all(|i| high[i] >= self.low[i] && low[i] <= self.high[i])
        };
        lines.into_iter().filter(is_seen).collect()
    }

    /// About so many points on a square grid, and the distance between them.
    pub(super) fn grid(&self, wanted: usize) -> (Vec<Point>, f64) {
        let [width, height] = [0, 1].map(|i| self.high[i] - self.low[i]);
        let step = (width * height / wanted as f64).sqrt();
        let count = |i: usize| ((self.high[i] - self.low[i]) / step) as usize;
        let at = |i: usize, n: usize| self.low[i] + (n as f64 + 0.5) * step;
        let points = (0..=count(1)).flat_map(|j| (0..=count(0)).map(move |i| (i, j)));
        (points.map(|(i, j)| [at(0, i), at(1, j)]).collect(), step)
    }

    /// An empty figure of this part of the soil.
    pub(super) fn figure(&self, fields: &Fields, what: &str) -> Result<Figure, PageError> {
        let unit = &fields.units.length_name;
        let [low, high] = [self.low, self.high].map(|p| fields.units.point(p));
        let title =
            if fields.title.is_empty() { what.to_owned() } else { format!("{what}: {}", fields.title) };
        let x = Axis::linear(format!("x ({unit})")).range(low[0], high[0])?;
        let y = Axis::linear(format!("y ({unit})")).range(low[1], high[1])?;
        Ok(Figure::new(title, x, y).with_equal_aspect()?)
    }
}

fn bounds<'a>(points: impl Iterator<Item = &'a Point>) -> [Point; 2] {
    points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
        [[0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i]))]
    })
}

/// Lines of a statement one of whose sides has a condition that is wanted.
fn on_lines(statement: &Statement, wanted: impl Fn(Condition) -> bool) -> Vec<Vec<Point>> {
    let is_wanted = |line: usize| statement.boundaries.iter().any(|b| b.line == line && wanted(b.condition));
    let lines = statement.lines.iter().enumerate().filter(|(i, _)| is_wanted(*i));
    lines.map(|(_, l)| vec![statement.points[l.from], statement.points[l.to]]).collect()
}

/// Faces of structures.
pub(super) fn face_lines(statement: &Statement) -> Vec<[Point; 2]> {
    let lines = on_lines(statement, |c| matches!(c, Condition::Face { .. }));
    lines.into_iter().filter_map(|line| line.try_into().ok()).collect()
}

/// Lines as a figure has them.
pub(super) fn drawn(fields: &Fields, lines: Vec<Vec<Point>>) -> Vec<Vec<(f64, f64)>> {
    let place = |p: Point| fields.units.point(p).into();
    lines.into_iter().map(|line| line.into_iter().map(place).collect()).collect()
}

/// Adds ground, where soils meet, the water table, bars and sheets, and structures.
pub(super) fn add_outline(figure: &mut Figure, fields: &Fields, window: &Window) -> Result<(), PageError> {
    let statement = fields.statement()?;
    let ground = |c| !matches!(c, Condition::Far | Condition::Face { .. });
    let mut add = |lines: Vec<Vec<Point>>, name: &str, width: f64, color: usize| -> Result<(), PageError> {
        if !lines.is_empty() {
            figure.push(Paths::new(name, drawn(fields, lines)).width(width).color(color))?;
        }
        Ok(())
    };
    let water = water_table(statement).into_iter().map(Vec::from).collect();
    add(window.shown(between_soils(statement)), "where soils meet", 1.0, INK)?;
    add(window.shown(water), "water table", 1.8, WATER)?;
    let member = |side: &LineUse| {
        let line = statement.lines[side.line];
        vec![statement.points[line.from], statement.points[line.to]]
    };
    let members = statement.members.iter().flat_map(|m| m.path.iter().map(member)).collect();
    add(window.shown(members), "bars, sheets, beams", 2.0, MEMBER)?;
    let yielding = fields.flow.as_ref().map_or_else(Vec::new, FlowResults::yielding);
    let yielding = yielding.into_iter().map(Vec::from).collect();
    add(window.shown(yielding), "where these yield", 4.5, YIELDING)?;
    add(on_lines(statement, ground), "", 1.4, INK)?;
    add(on_lines(statement, |c| matches!(c, Condition::Face { .. })), "structure", 3.5, INK)
}
