//! Solutions for ParaView.

use soilctl_certificate::{Material, Statement};

use super::Point;
use super::finder::{at, centroid};
use super::flow::{FlowResults, area, value};
use super::stress::{Principal, StressResults};
use super::units::Units;
use super::work::shear_work;
use crate::error::LimitError;
use crate::mesh::files::{Encoding, Field, Layout, Vtu};
use crate::mesh::{Mesh, Triangle};
use crate::problem::value as linear;

/// Where fields are looked up: this part of the way from a node to the middle of its cell, so that next to a jump the
/// cell's own side counts.
const INWARD: f64 = 1e-6;

/// A solution in ParaView's format. With a flow the mesh is that of the flow, without one that of the stress field, cut
/// into the parts on which stresses are linear. Nothing but quadratic triangles; points are not shared, so fields may
/// jump.
///
/// At points: `velocity` (in units of the structure's), and, from the stress field wherever the point is in it, the total
/// `stress` (a tensor of 9, tension positive), `principal_major` and `principal_minor` (compression positive), in
/// units of stress. In cells: `region`, `phi_deg`, `unit_weight`, `cohesion` (in the middle; stress), `dissipation` (stress
/// times velocity over length), `shear_rate` (velocity over length) and, with a stress field, `shear_work` (like
/// dissipation).
///
/// # Errors
///
/// [`LimitError::File`] if a number is too large to be written; [`LimitError::NotCovered`] without flow and stress.
pub fn write_vtu(
    flow: Option<&FlowResults>,
    stress: Option<&StressResults>,
    units: &Units,
) -> Result<String, LimitError> {
    let (statement, mut mesh) = match (flow, stress) {
        (Some(flow), _) => (flow.statement(), flow.restored()),
        (None, Some(stress)) => (&stress.statement, stress.thirds()),
        (None, None) => {
            let what = "a solution without a flow and without a stress field";
            return Err(LimitError::NotCovered { what, advice: "give one of them" });
        }
    };
    let points: Vec<[Point; 6]> = mesh.triangles.iter().map(|t| six(&mesh, t)).collect();
    let mut columns: Vec<Column> = Vec::new();
    let mut cells = soil(statement, &mesh);
    if let Some(flow) = flow {
        let velocities = flow.pieces().iter().flat_map(|pieces| six_velocities(pieces)).flatten();
        columns.push(Column { name: "velocity", components: 2, values: velocities.collect() });
        let mean = |of: Vec<Vec<f64>>, factor: f64| {
            let pieces = flow.pieces().iter().zip(of);
            pieces.map(|(p, values)| factor * mean(p.iter().map(area).zip(values))).collect()
        };
        let power = units.stress / units.length;
        cells.push(Column { name: "dissipation", components: 1, values: mean(flow.dissipation(), power) });
        cells.push(Column {
            name: "shear_rate",
            components: 1,
            values: mean(flow.shear_rate(), 1.0 / units.length),
        });
        if let Some(stress) = stress {
            cells.push(Column {
                name: "shear_work",
                components: 1,
                values: mean(shear_work(flow, stress), power),
            });
        }
    }
    if let Some(stress) = stress {
        columns.extend(stresses(stress, &points, units.stress));
    }
    for c in &mut cells {
        let factor = match c.name {
            "unit_weight" => units.stress / units.length,
            "cohesion" => units.stress,
            _ => continue,
        };
        c.values.iter_mut().for_each(|x| *x *= factor);
    }
    for v in &mut mesh.vertices {
        v.position = units.point(v.position);
    }
    let (points, cells): (Vec<Field>, Vec<Field>) =
        (columns.iter().map(Column::field).collect(), cells.iter().map(Column::field).collect());
    let file = Vtu {
        mesh: &mesh,
        layout: Layout::Quadratic,
        point_data: &points,
        cell_data: &cells,
        encoding: Encoding::Base64,
    };
    Ok(file.write()?)
}

struct Column {
    name: &'static str,
    components: usize,
    values: Vec<f64>,
}

impl Column {
    fn field(&self) -> Field<'_> {
        Field { name: self.name, components: self.components, values: &self.values }
    }
}

fn soil(statement: &Statement, mesh: &Mesh) -> Vec<Column> {
    let of = |name, value: fn(&Material, Point) -> f64| {
        let values = mesh.triangles.iter().map(|t| {
            let middle = centroid(&t.corners.map(|v| mesh.vertices[v].position));
            value(&statement.regions[t.region].material, middle)
        });
        Column { name, components: 1, values: values.collect() }
    };
    vec![
        of("phi_deg", |m, _| m.phi_deg),
        of("unit_weight", |m, _| m.unit_weight),
        of("cohesion", |m, p| linear(&m.cohesion, p).max(0.0)),
    ]
}

/// Corners, then the middles of edges from corner 0 to 1, 1 to 2, and 2 to 0.
const SIX: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]];

fn six(mesh: &Mesh, t: &Triangle) -> [Point; 6] {
    let v = t.corners.map(|c| mesh.vertices[c].position);
    let middle = centroid(&v);
    SIX.map(|l| {
        let p = at(&v, l);
        [0, 1].map(|axis| p[axis] + INWARD * (middle[axis] - p[axis]))
    })
}

/// Velocities at the same six points.
fn six_velocities(pieces: &[soilctl_certificate::FlowPiece]) -> [Point; 6] {
    match pieces {
        [whole] => SIX.map(|l| value(&whole.control, l)),
        // Part k lies at edge k, from corner k + 1 to corner k + 2; edge 2 comes first.
        parts => {
            let on = |part: usize, node: usize| value(&parts[part].control, SIX[node]);
            [on(2, 0), on(2, 1), on(0, 1), on(2, 3), on(0, 3), on(1, 3)]
        }
    }
}

/// Mean of values, each with its weight.
fn mean(values: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (sum, weight) = values.fold((0.0, 0.0), |(s, w), (weight, value)| (s + weight * value, w + weight));
    sum / weight
}

fn stresses(stress: &StressResults, points: &[[Point; 6]], unit: f64) -> Vec<Column> {
    let (mut tensors, mut major, mut minor) = (Vec::new(), Vec::new(), Vec::new());
    let mut found = 0;
    for p in points.iter().flatten() {
        let [xx, yy, xy] = stress.stress_from(*p, found).map_or([0.0; 3], |(triangle, s)| {
            found = triangle;
            s.map(|x| unit * x)
        });
        let principal = Principal::of([xx, yy, xy]);
        tensors.extend([xx, xy, 0.0, xy, yy, 0.0, 0.0, 0.0, 0.0]);
        major.push(principal.major);
        minor.push(principal.minor);
    }
    vec![
        Column { name: "stress", components: 9, values: tensors },
        Column { name: "principal_major", components: 1, values: major },
        Column { name: "principal_minor", components: 1, values: minor },
    ]
}
