//! Solutions for ParaView.

use soilctl_certificate::{FlowPiece, Material, Statement};

use super::Point;
use super::finder::{at, centroid};
use super::flow::{FlowResults, area, value};
use super::stress::{Principal, StressResults};
use super::units::Units;
use super::vtu_file::{Cells, Field, Shape, write};
use super::work::shear_work;
use crate::error::LimitError;
use crate::mesh::Mesh;
use crate::vector::along;

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
/// [`LimitError::NotFinite`] if a number is too large to be written; [`LimitError::NotCovered`] without flow and stress.
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
    let points: Vec<[Point; 6]> = (0..mesh.triangles.len()).map(|t| six(&mesh.corners(t))).collect();
    let mut columns: Vec<Field> = Vec::new();
    let mut cells = soil(statement, &mesh);
    if let Some(flow) = flow {
        let velocities = flow.pieces().iter().flat_map(|pieces| six_velocities(pieces)).flatten();
        columns.push(Field { name: "velocity", components: 2, values: velocities.collect() });
        let mean = |of: Vec<Vec<f64>>, factor: f64| {
            let pieces = flow.pieces().iter().zip(of);
            pieces.map(|(p, values)| factor * mean(p.iter().map(area).zip(values))).collect()
        };
        let power = units.stress / units.length;
        cells.push(Field::scalar("dissipation", mean(flow.dissipation(), power)));
        cells.push(Field::scalar("shear_rate", mean(flow.shear_rate(), 1.0 / units.length)));
        if let Some(stress) = stress {
            cells.push(Field::scalar("shear_work", mean(shear_work(flow, stress), power)));
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
    let nodes = |t: usize| {
        let [a, b, c] = mesh.corners(t);
        [a, b, c, along(a, b, 0.5), along(b, c, 0.5), along(c, a, 0.5)].map(|[x, y]| [x, y, 0.0])
    };
    let triangles = Cells {
        shape: Shape::QuadraticTriangle,
        points: (0..mesh.triangles.len()).flat_map(nodes).collect(),
        number: ("region", mesh.triangles.iter().map(|t| t.region).collect()),
    };
    write(&triangles, &columns, &cells)
}

fn soil(statement: &Statement, mesh: &Mesh) -> Vec<Field> {
    let of = |name, value: fn(&Material, Point) -> f64| {
        let values = mesh
            .triangles
            .iter()
            .enumerate()
            .map(|(i, t)| value(&statement.regions[t.region].material, centroid(&mesh.corners(i))));
        Field::scalar(name, values.collect())
    };
    vec![
        of("phi_deg", |m, _| m.phi_deg),
        of("unit_weight", |m, _| m.unit_weight),
        of("cohesion", |m, p| m.cohesion.at(p).max(0.0)),
    ]
}

/// Corners, then the middles of edges from corner 0 to 1, 1 to 2, and 2 to 0.
const SIX: [[f64; 3]; 6] =
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]];

fn six(v: &[Point; 3]) -> [Point; 6] {
    SIX.map(|l| along(at(v, l), centroid(v), INWARD))
}

/// Velocities at the same six points.
fn six_velocities(pieces: &[FlowPiece]) -> [Point; 6] {
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

fn stresses(stress: &StressResults, points: &[[Point; 6]], unit: f64) -> Vec<Field> {
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
        Field { name: "stress", components: 9, values: tensors },
        Field::scalar("principal_major", major),
        Field::scalar("principal_minor", minor),
    ]
}
