//! Cells in rows and columns, and the mesh made of them.

use super::super::MeshError;
use super::super::extract::{Mesh, Place, Triangle, Vertex};
use super::super::outline::Outline;
use super::super::vector::{Point, along, between, cross, dot, twice_area};

/// Most triangles.
const LIMIT: usize = 4_000_000;

/// Corners of cells.
pub(super) struct Cells {
    columns: usize,
    rows: usize,
    points: Vec<Point>,
}

/// Checks that a list has at least two values and that they ascend (`sign` 1) or descend (-1).
pub(super) fn check_ascending(what: &'static str, list: &[f64], sign: f64) -> Result<(), MeshError> {
    if list.len() < 2 {
        let allowed = "a list of at least two numbers";
        return Err(MeshError::BadGrid {
            what,
            index: 0,
            value: list.first().copied().unwrap_or(f64::NAN),
            allowed,
        });
    }
    let allowed = if sign > 0.0 {
        "finite and more than the one before"
    } else {
        "finite and less than the one before"
    };
    for (index, &value) in list.iter().enumerate() {
        let in_order = index == 0 || sign * value > sign * list[index - 1];
        if !(in_order && value.is_finite()) {
            return Err(MeshError::BadGrid { what, index, value, allowed });
        }
    }
    Ok(())
}

impl Cells {
    /// Cells between columns, which ascend, and rows, which descend; `at` says where a corner is.
    pub(super) fn new(
        columns: &[f64],
        rows: &[f64],
        at: impl Fn(f64, f64) -> Point,
    ) -> Result<Self, MeshError> {
        check_ascending("columns", columns, 1.0)?;
        check_ascending("rows", rows, -1.0)?;
        let count = 4usize.saturating_mul(columns.len() - 1).saturating_mul(rows.len() - 1);
        if count > LIMIT {
            return Err(MeshError::TooManyTriangles { count, limit: LIMIT });
        }
        let points = rows.iter().flat_map(|&y| columns.iter().map(move |&x| [x, y])).map(|[x, y]| at(x, y));
        Ok(Self { columns: columns.len(), rows: rows.len(), points: points.collect() })
    }

    /// Indices of the last column and of the last row.
    pub(super) fn last(&self) -> [usize; 2] {
        [self.columns - 1, self.rows - 1]
    }

    /// Number of the corner in a column and a row.
    pub(super) fn number(&self, column: usize, row: usize) -> usize {
        row * self.columns + column
    }

    /// Where it is.
    pub(super) fn at(&self, column: usize, row: usize) -> Point {
        self.points[self.number(column, row)]
    }

    /// The mesh. `chains` are the corners of cells on each line of the outline.
    pub(super) fn mesh(mut self, outline: &Outline, chains: Vec<Vec<usize>>) -> Result<Mesh, MeshError> {
        outline.check()?;
        let mut places = vec![Place::Inside; self.points.len()];
        for (line, chain) in chains.iter().enumerate() {
            let ends = outline.lines[line];
            let [a, b] = [ends.from, ends.to].map(|p| outline.points[p]);
            let way = between(a, b);
            for &v in &chain[1..chain.len() - 1] {
                let s = dot(between(a, self.points[v]), way) / dot(way, way);
                places[v] = Place::OnLine { line, s };
                self.points[v] = along(a, b, s);
            }
            for (v, point) in [(chain[0], ends.from), (chain[chain.len() - 1], ends.to)] {
                places[v] = Place::Corner(point);
                self.points[v] = outline.points[point];
            }
        }
        let [right, base] = self.last();
        let mut triangles = Vec::with_capacity(4 * right * base);
        for row in 0..base {
            for column in 0..right {
                let at = |i: usize, j: usize| self.number(column + i, row + j);
                let around = [at(0, 0), at(0, 1), at(1, 1), at(1, 0)];
                let centre = self.points.len();
                let corners = around.map(|v| self.points[v]);
                self.points.push(crossing(corners));
                for i in 0..4 {
                    let t = [around[i], around[(i + 1) % 4], centre];
                    let area = 0.5 * twice_area(t.map(|v| self.points[v]));
                    if area.is_nan() || area <= 0.0 {
                        let (what, allowed) =
                            ("area of a triangle in the cells", "positive: cells must be convex");
                        return Err(MeshError::BadGrid {
                            what,
                            index: row * right + column,
                            value: area,
                            allowed,
                        });
                    }
                    triangles.push(Triangle { corners: t, region: 0 });
                }
            }
        }
        places.resize(self.points.len(), Place::Inside);
        let vertices =
            self.points.into_iter().zip(places).map(|(position, place)| Vertex { position, place });
        Ok(Mesh { vertices: vertices.collect(), triangles, lines: chains, guide_edges: Vec::new() })
    }
}

/// Where the diagonals of a quadrilateral cross.
fn crossing([a, b, c, d]: [Point; 4]) -> Point {
    let (ac, bd) = (between(a, c), between(b, d));
    along(a, c, cross(between(a, b), bd) / cross(ac, bd))
}
