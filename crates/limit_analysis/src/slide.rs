//! Slopes that slide on a plane through their foot. With little cohesion the body that slides is thinner than any mesh would
//! make elements, so the mesh is cut along the plane.
//!
//! A plane at the angle `theta` bears soil of a slope at `beta` no more if `phi < theta < beta`; without cohesion any such angle
//! does, and with a little the middle is the worst (Culmann 1866).

use std::collections::BTreeMap;

use soilctl_certificate::{Place, Triangle, Vertex};

use crate::lower::surfaces::is_weak;
use crate::mesh::{Mesh, vertex_on_edge};
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::{Point, along, between, cross, distance};

/// A plane: the point of the statement at its foot, and its direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slide {
    foot: usize,
    way: Point,
    /// The slope, from its foot on.
    slope: [Point; 2],
    /// Cohesion over unit weight.
    bond: f64,
}

impl Slide {
    /// Wanted edge length at a point: little cohesion makes thin slides, whose stresses and strains only small elements show. Without
    /// any the surface's own polynomial does.
    pub(crate) fn size(&self, p: Point) -> f64 {
        let [a, b] = self.slope;
        let (way, from) = (between(a, b), between(a, p));
        let length = distance(a, b);
        let s = ((from[0] * way[0] + from[1] * way[1]) / (length * length)).clamp(0.0, 1.0);
        let thin = if self.bond > 0.0 { (BONDS * self.bond).max(THIN * length) } else { f64::INFINITY };
        thin + AWAY * distance(p, along(a, b, s))
    }
}

/// Elements on a slope are not larger than so many times the cohesion over the unit weight, unless that is less than this part of the
/// slope; and grow so fast with the distance.
const BONDS: f64 = 10.0;
const THIN: f64 = 0.03;
const AWAY: f64 = 0.4;

/// Cuts that come closer to a vertex than this part of an edge are not made.
const CLEAR: f64 = 1e-7;

/// One below each free side of soil with next to no cohesion that is steeper than its friction bears.
pub(crate) fn slides(problem: &Problem) -> Vec<Slide> {
    let statement = problem.statement();
    let free = statement.boundaries.iter().filter(|b| is_weak(problem, b.side()));
    free.filter_map(|b| {
        let soil = &problem.soils[problem.owner(b.side())?];
        let line = statement.lines[b.line];
        let [p, q] = problem.ends(b.line);
        let (foot, low, high) = if p[1] < q[1] { (line.from, p, q) } else { (line.to, q, p) };
        let beta = (high[1] - low[1]).atan2((high[0] - low[0]).abs());
        let phi = soil.tan.atan();
        // Seepage and earthquakes tilt what is level to the grains.
        let tilt = tilt(soil.effective_weight(statement.gravity), (high[0] - low[0]).signum());
        let steep = beta + tilt;
        let theta = 0.5 * (steep + phi) - tilt;
        let is_slope = phi > 0.0 && steep > phi && theta > 0.0 && beta < std::f64::consts::FRAC_PI_2;
        let gravity = statement.gravity[0].hypot(statement.gravity[1]);
        let cohesion = 0.5 * (soil.cohesion.at(low) + soil.cohesion.at(high));
        is_slope.then(|| Slide {
            foot,
            way: [(high[0] - low[0]).signum() * theta.cos(), theta.sin()],
            slope: [low, high],
            bond: cohesion / (soil.unit_weight * gravity),
        })
    })
    .collect()
}

/// By how much a body force leans out of a slope that rises to the right (`rises` 1) or to the left (-1), against the vertical.
fn tilt([x, y]: Point, rises: f64) -> f64 {
    if y < 0.0 { (-x * rises).atan2(-y) } else { 0.0 }
}

/// A mesh after it was cut.
pub(crate) struct Cut {
    pub(crate) mesh: Mesh,
    pub(crate) topology: Topology,
    /// The mesh before, and of which of its triangles each is a part; none if there was nothing to cut.
    pub(crate) uncut: Option<(Mesh, Vec<usize>)>,
}

/// Cuts a mesh along slides, on which velocities may then jump.
pub(crate) fn cut(problem: &Problem, (mesh, topology): (Mesh, Topology), slides: &[Slide]) -> Cut {
    let mut cut = Cut { mesh, topology, uncut: None };
    for slide in slides {
        let Some((mesh, part_of)) = cut_one(problem, &cut.mesh, &cut.topology, slide) else { continue };
        let topology = Topology::new(&mesh);
        let before = std::mem::replace(&mut cut.mesh, mesh);
        cut.topology = topology;
        cut.uncut = Some(match cut.uncut.take() {
            Some((uncut, parts)) => (uncut, part_of.into_iter().map(|whole| parts[whole]).collect()),
            None => (before, part_of),
        });
    }
    cut
}

/// Where the cut enters or leaves a triangle: at a corner, or at a new vertex on an edge.
struct Step {
    triangle: usize,
    /// Edge by which it came in, with its new vertex; none at the foot, which is this corner.
    from: Result<(usize, usize), usize>,
    /// Edge by which it goes out, with its new vertex.
    to: (usize, usize),
}

/// The mesh after a cut, and of which triangle each is a part. None if the cut comes too near a vertex, or there is nothing to cut.
fn cut_one(problem: &Problem, mesh: &Mesh, topology: &Topology, slide: &Slide) -> Option<(Mesh, Vec<usize>)> {
    let start = mesh.vertices.iter().position(|v| v.place == Place::Corner { point: slide.foot })?;
    let foot = mesh.vertices[start].position;
    let side = |v: usize| cross(slide.way, between(foot, mesh.vertices[v].position));
    // The triangle at the foot that the cut goes into.
    let (mut triangle, corner) = (0..mesh.triangles.len()).find_map(|t| {
        let corners = mesh.triangles[t].corners;
        let k = corners.iter().position(|v| *v == start)?;
        let [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        (side(a) < 0.0 && side(b) > 0.0 && ahead(slide, foot, mesh, a, b)).then_some((t, k))
    })?;
    let mut vertices = mesh.vertices.clone();
    let mut steps: Vec<Step> = Vec::new();
    let (mut from, mut edge) = (Err(corner), corner);
    for _ in 0..mesh.triangles.len() {
        let corners = mesh.triangles[triangle].corners;
        let [a, b] = [corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
        let s = side(a) / (side(a) - side(b));
        if !(s > CLEAR && s < 1.0 - CLEAR) {
            return None;
        }
        let new = vertices.len();
        let line = topology.line[triangle][edge].map(|side| side.line);
        let ends = [a, b].map(|v| mesh.vertices[v]);
        vertices.push(vertex_on_edge(problem.statement(), line, ends, s));
        steps.push(Step { triangle, from, to: (edge, new) });
        let Some(next) = topology.across[triangle][edge] else {
            return Some(built(problem, mesh, vertices, &steps, start));
        };
        if topology.line[triangle][edge].is_some_and(|line| problem.condition(line).is_some()) {
            return Some(built(problem, mesh, vertices, &steps, start));
        }
        triangle = next.triangle;
        from = Ok((next.corner, new));
        // It leaves by the edge at whose ends the sides differ: the corner opposite to the one it came in by tells.
        let opposite = side(mesh.triangles[triangle].corners[next.corner]);
        let at_next = side(mesh.triangles[triangle].corners[(next.corner + 1) % 3]);
        let changes = (opposite > 0.0) != (at_next > 0.0);
        edge = if changes { (next.corner + 2) % 3 } else { (next.corner + 1) % 3 };
    }
    None
}

/// Whether the edge opposite to the foot is ahead.
fn ahead(slide: &Slide, foot: Point, mesh: &Mesh, a: usize, b: usize) -> bool {
    let [p, q] = [a, b].map(|v| between(foot, mesh.vertices[v].position));
    let along = |p: Point| p[0] * slide.way[0] + p[1] * slide.way[1];
    along(p).max(along(q)) > 0.0
}

fn built(
    problem: &Problem,
    mesh: &Mesh,
    vertices: Vec<Vertex>,
    steps: &[Step],
    start: usize,
) -> (Mesh, Vec<usize>) {
    let mut triangles = mesh.triangles.clone();
    let mut part_of: Vec<usize> = (0..triangles.len()).collect();
    let mut guides = mesh.guide_edges.clone();
    let mut halved: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let key = |a: usize, b: usize| [a.min(b), a.max(b)];
    for step in steps {
        let Triangle { corners, region } = mesh.triangles[step.triangle];
        let (edge, out) = step.to;
        let [a, b] = [corners[(edge + 1) % 3], corners[(edge + 2) % 3]];
        halved.insert(key(a, b), out);
        let parts: Vec<[usize; 3]> = match step.from {
            Err(corner) => {
                guides.push(key(start, out));
                vec![[corners[corner], a, out], [corners[corner], out, b]]
            }
            Ok((came, into)) => {
                guides.push(key(into, out));
                // The corner that both edges have in common, and the other two in the triangle's sense.
                let alone = 3 - came - edge;
                let [q, r, p] = [0, 1, 2].map(|i| corners[(alone + i) % 3]);
                // On the edges from `q` to `r` and from `p` to `q`.
                let [on_qr, on_pq] = if came == (alone + 2) % 3 { [into, out] } else { [out, into] };
                let at = |v: usize| vertices[v].position;
                let quad = if distance(at(on_qr), at(p)) < distance(at(on_pq), at(r)) {
                    [[on_qr, r, p], [on_qr, p, on_pq]]
                } else {
                    [[on_qr, r, on_pq], [r, p, on_pq]]
                };
                [[q, on_qr, on_pq]].into_iter().chain(quad).collect()
            }
        };
        let mut parts = parts.into_iter().map(|corners| Triangle { corners, region });
        if let Some(first) = parts.next() {
            triangles[step.triangle] = first;
        }
        triangles.extend(parts);
        part_of.resize(triangles.len(), step.triangle);
    }
    let guides = guides.into_iter().flat_map(|[a, b]| match halved.get(&[a, b]) {
        Some(middle) => vec![key(a, *middle), key(*middle, b)],
        None => vec![[a, b]],
    });
    let mut guides: Vec<[usize; 2]> = guides.collect();
    guides.sort_unstable();
    (Mesh::new(problem.statement(), vertices, triangles, guides), part_of)
}
