//! Triangles for the flow, smaller where the pressure bends.

use soilctl_certificate::{Line, LineUse, Linear, Material, Objective, Region, Statement};

use std::collections::BTreeMap;

use super::super::faces::Face;
use super::super::ground::Map;
use crate::mesh::{Mesh, MeshError, Request, generate};
use crate::vector::{Point, twice_area};

/// Triangles that are aimed at; each wet one becomes a region of the statement.
const AIMED: f64 = 110.0;

/// Most triangles, where many short lines ask for small ones.
const MOST: usize = 1500;

/// How much smaller or larger triangles may get from one round to the next.
const CHANGE: [f64; 2] = [0.3, 2.0];

/// Steps of that to one.
const STEPS: f64 = 16.0;

/// Area of an equilateral triangle over the square of its side.
const EQUILATERAL: f64 = 0.433_012_701_892_219_3;

/// The outline alone, in the units of the description; lines are numbered as edges are.
pub(super) fn outline(map: &Map, faces: &[Face]) -> Statement {
    let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
    let mut points = Vec::new();
    let mut number = |p: usize| {
        *numbers.entry(p).or_insert_with(|| {
            points.push(map.arrangement.points[p]);
            points.len() - 1
        })
    };
    let lines: Vec<Line> = map
        .arrangement
        .edges
        .iter()
        .map(|e| Line { from: number(e.ends[0]), to: number(e.ends[1]) })
        .collect();
    let material = Material {
        phi_deg: 0.0,
        cohesion: Linear::uniform(1.0),
        unit_weight: 0.0,
        pore_pressure: Linear::default(),
        tension: None,
        envelope: None,
        anisotropy: None,
    };
    let region = |face: &Face| Region { loops: face.loops.clone(), material: material.clone() };
    Statement {
        points,
        lines,
        regions: faces.iter().map(region).collect(),
        gravity: [0.0, -1.0],
        datum: 0.0,
        surcharge: 0.0,
        objective: Objective::Everything,
        boundaries: Vec::new(),
        width: None,
        members: Vec::new(),
    }
}

/// A size for each triangle of a mesh; of one size at first.
pub(super) struct Sizes {
    triangles: Vec<[Point; 3]>,
    sizes: Vec<f64>,
    other: f64,
}

impl Sizes {
    /// The same everywhere.
    pub(super) fn uniform(area: f64) -> Self {
        Self { triangles: Vec::new(), sizes: Vec::new(), other: (area / (AIMED * EQUILATERAL)).sqrt() }
    }

    /// Such that what is missed would be the same in all triangles, if it goes with their area, and no less than is worth a triangle.
    pub(super) fn of_missed(triangles: Vec<[Point; 3]>, missed: &[f64], least: f64, area: f64) -> Self {
        let other = Self::uniform(area).other;
        let share = (missed.iter().sum::<f64>() / AIMED).max(least);
        let size = |(triangle, missed): (&[Point; 3], &f64)| {
            let size = (0.5 * twice_area(*triangle) / EQUILATERAL).sqrt();
            let change = if *missed > 0.0 { (share / missed).sqrt() } else { CHANGE[1] };
            // In steps, so that the last bits of the flow, which depend on the processor, do not move the mesh.
            size * (change.clamp(CHANGE[0], CHANGE[1]) * STEPS).round() / STEPS
        };
        Self { sizes: triangles.iter().zip(missed).map(size).collect(), triangles, other }
    }

    fn at(&self, p: Point) -> f64 {
        let holds = |t: &[Point; 3]| (0..3).all(|k| twice_area([t[k], t[(k + 1) % 3], p]) >= 0.0);
        self.triangles.iter().position(holds).map_or(self.other, |i| self.sizes[i])
    }
}

/// A mesh of the outline.
pub(super) fn mesh(outline: &Statement, sizes: &Sizes) -> Result<Mesh, MeshError> {
    generate(&Request {
        statement: outline,
        guides: &[],
        fans: &[],
        size: &|p| sizes.at(p),
        max_triangles: MOST,
    })
}

/// The side of a line on which each edge of a triangle is; none inside.
pub(super) fn sides(mesh: &Mesh) -> Vec<[Option<LineUse>; 3]> {
    let mut on: BTreeMap<[usize; 2], LineUse> = BTreeMap::new();
    for (line, vertices) in mesh.lines.iter().enumerate() {
        for step in vertices.windows(2) {
            on.insert([step[0], step[1]], LineUse { line, forward: true });
            on.insert([step[1], step[0]], LineUse { line, forward: false });
        }
    }
    let side = |t: &soilctl_certificate::Triangle| {
        [0, 1, 2].map(|k| on.get(&[t.corners[(k + 1) % 3], t.corners[(k + 2) % 3]]).copied())
    };
    mesh.triangles.iter().map(side).collect()
}
