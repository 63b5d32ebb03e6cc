//! Problems made of blocks: cells of a grid, with a line of the statement for each side of a cell that is not inside a
//! region.

use crate::{
    Boundary, Condition, Line, LineUse, Material, Mesh, Objective, Place, Region, Statement, Triangle, Vertex,
};

/// A grid of cells and what is on them.
pub(crate) struct Blocks<'a> {
    pub(crate) xs: &'a [f64],
    pub(crate) ys: &'a [f64],
    /// The region of the cell in column `i`, row `j` from below.
    pub(crate) cell: &'a dyn Fn(usize, usize) -> Option<usize>,
    pub(crate) materials: &'a [Material],
    /// What holds on a boundary side: middle before the shift, outward normal.
    pub(crate) condition: &'a dyn Fn([f64; 2], [i32; 2]) -> Condition,
    pub(crate) objective: Objective,
    pub(crate) gravity: [f64; 2],
    pub(crate) datum: f64,
    pub(crate) surcharge: f64,
    /// How much everything is shifted up for each unit to the right.
    pub(crate) slope: f64,
}

/// A unit step between nodes of the grid with the cell on its left, and the cell's region.
type Step = ([[usize; 2]; 2], usize);

impl Blocks<'_> {
    fn region(&self, i: isize, j: isize) -> Option<usize> {
        let inside =
            (0..self.xs.len() as isize - 1).contains(&i) && (0..self.ys.len() as isize - 1).contains(&j);
        if inside { (self.cell)(i as usize, j as usize) } else { None }
    }

    fn shifted(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x, y + self.slope * x]
    }

    /// The steps around all cells, with the region of the cell beyond.
    fn steps(&self) -> Vec<(Step, Option<usize>, [i32; 2])> {
        let mut steps = Vec::new();
        for j in 0..self.ys.len() - 1 {
            for i in 0..self.xs.len() - 1 {
                let Some(region) = (self.cell)(i, j) else { continue };
                let ring = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                for (k, out) in [[0, -1], [1, 0], [0, 1], [-1, 0]].into_iter().enumerate() {
                    let beyond = self.region(i as isize + out[0] as isize, j as isize + out[1] as isize);
                    if beyond != Some(region) {
                        steps.push((([ring[k], ring[(k + 1) % 4]], region), beyond, out));
                    }
                }
            }
        }
        steps
    }

    pub(crate) fn statement(&self) -> Statement {
        let steps = self.steps();
        let (mut nodes, mut ends): (Vec<[usize; 2]>, Vec<[usize; 2]>) = (Vec::new(), Vec::new());
        let mut boundaries = Vec::new();
        let mut uses: Vec<(Step, LineUse)> = Vec::new();
        for ((step, region), beyond, out) in &steps {
            let [a, b] = step.map(|node| match nodes.iter().position(|n| *n == node) {
                Some(at) => at,
                None => {
                    nodes.push(node);
                    nodes.len() - 1
                }
            });
            let known = ends.iter().position(|e| *e == [a, b] || *e == [b, a]);
            let line = known.unwrap_or_else(|| {
                // Some walked forwards, some backwards.
                ends.push(if (a + b) % 2 == 0 { [a, b] } else { [b, a] });
                ends.len() - 1
            });
            let side = LineUse { line, forward: ends[line] == [a, b] };
            uses.push(((*step, *region), side));
            if beyond.is_none() {
                let middle = [0, 1].map(|k| {
                    let values = if k == 0 { self.xs } else { self.ys };
                    (values[step[0][k]] + values[step[1][k]]) / 2.0
                });
                let condition = (self.condition)(middle, *out);
                boundaries.push(Boundary { line, forward: side.forward, condition });
            }
        }
        let regions = self.materials.iter().enumerate().map(|(region, material)| {
            let mut rest: Vec<_> = uses.iter().filter(|((_, r), _)| *r == region).collect();
            let mut loops = Vec::new();
            while let Some(((start, _), side)) = rest.pop() {
                let (mut uses, mut here) = (vec![*side], start[1]);
                while let Some(at) = rest.iter().position(|((step, _), _)| step[0] == here) {
                    let ((step, _), side) = rest.swap_remove(at);
                    uses.push(*side);
                    here = step[1];
                }
                loops.push(uses);
            }
            Region { loops, material: material.clone() }
        });
        Statement {
            regions: regions.collect(),
            points: nodes.iter().map(|[i, j]| self.shifted([self.xs[*i], self.ys[*j]])).collect(),
            lines: ends.iter().map(|[from, to]| Line { from: *from, to: *to }).collect(),
            gravity: self.gravity,
            datum: self.datum,
            surcharge: self.surcharge,
            objective: self.objective,
            width: None,
            members: Vec::new(),
            boundaries,
        }
    }

    /// Each cell cut in four by four, each in two.
    pub(crate) fn mesh(&self, statement: &Statement) -> Mesh {
        const PARTS: usize = 4;
        let mut mesh = Mesh::default();
        let mut found: Vec<[usize; 2]> = Vec::new();
        let fine = |values: &[f64], i: usize| {
            let (cell, part) = (i / PARTS, (i % PARTS) as f64 / PARTS as f64);
            if part == 0.0 { values[cell] } else { values[cell] + part * (values[cell + 1] - values[cell]) }
        };
        for j in 0..PARTS * (self.ys.len() - 1) {
            for i in 0..PARTS * (self.xs.len() - 1) {
                let Some(region) = (self.cell)(i / PARTS, j / PARTS) else { continue };
                let ring = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|node| {
                    found.iter().position(|n| *n == node).unwrap_or_else(|| {
                        found.push(node);
                        let position = self.shifted([fine(self.xs, node[0]), fine(self.ys, node[1])]);
                        mesh.vertices.push(Vertex { position, place: place(statement, position) });
                        found.len() - 1
                    })
                });
                let [ll, lr, ur, ul] = ring;
                let halves = if (i + j) % 2 == 0 {
                    [[ll, lr, ur], [ll, ur, ul]]
                } else {
                    [[ll, lr, ul], [lr, ur, ul]]
                };
                mesh.triangles.extend(halves.map(|corners| Triangle { corners, region }));
            }
        }
        mesh
    }
}

/// Whether a position is on a line or point, but for rounding.
fn place(statement: &Statement, p: [f64; 2]) -> Place {
    let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-9;
    if let Some(point) = statement.points.iter().position(|q| near(*q, p)) {
        return Place::Corner { point };
    }
    let on = statement.lines.iter().enumerate().find_map(|(line, ends)| {
        let [a, b] = [ends.from, ends.to].map(|p| statement.points[p]);
        let fractions = [0.25, 0.5, 0.75];
        let s = fractions.into_iter().find(|s| near([0, 1].map(|k| a[k] + s * (b[k] - a[k])), p))?;
        Some(Place::OnLine { line, s })
    });
    on.unwrap_or(Place::Inside)
}
