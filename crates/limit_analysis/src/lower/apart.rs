//! Meshes at surfaces of soil without cohesion: no vertex may be next to two surfaces in different directions, each of which says
//! what the stress function is there. Edges are halved until none is.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_certificate::{LineUse, Triangle};

use super::loads::Loads;
use super::reference::ReferenceStress;
use super::surfaces::{AT_REST, is_weak, numbers};
use crate::mesh::{Mesh, vertex_on_edge};
use crate::problem::Problem;

/// Rounds of halving; a few are needed.
const ROUNDS: usize = 12;

/// An edge, its lower vertex first.
type Edge = [usize; 2];

fn edge(a: usize, b: usize) -> Edge {
    [a.min(b), a.max(b)]
}

/// The mesh, with edges halved where vertices are next to two surfaces.
pub(crate) fn apart(problem: &Problem, mesh: Mesh) -> Mesh {
    let reference = ReferenceStress::new(problem, None);
    let mut numbers = numbers(problem, &Loads::new(problem, &reference));
    add_weak(problem, &mut numbers);
    if numbers.iter().all(|(_, number)| *number == AT_REST) {
        return mesh;
    }
    let mut mesh = mesh;
    for _ in 0..ROUNDS {
        let halved = Surroundings::new(problem, &mesh, &numbers).wrong();
        if halved.is_empty() {
            break;
        }
        mesh = halve(problem, mesh, &halved);
    }
    mesh
}

/// Adds sides of soil with so little cohesion that stresses nearly vanish there too. Those at one height are one.
fn add_weak(problem: &Problem, numbers: &mut Vec<(LineUse, usize)>) {
    let mut heights: Vec<(f64, usize)> = Vec::new();
    for b in problem.statement().boundaries.iter().filter(|b| is_weak(problem, b.side())) {
        if numbers.iter().any(|(side, _)| *side == b.side()) {
            continue;
        }
        let [p, q] = problem.ends(b.line);
        let next = 1 + numbers.iter().map(|(_, number)| *number).max().unwrap_or(AT_REST);
        let level = heights.iter().find(|(y, _)| p[1] == q[1] && *y == p[1]);
        let number = level.map_or(next, |(_, number)| *number);
        if p[1] == q[1] {
            heights.push((p[1], number));
        }
        numbers.push((b.side(), number));
    }
}

/// What the vertices of a mesh adjoin.
struct Surroundings<'a> {
    problem: &'a Problem,
    mesh: &'a Mesh,
    /// Numbers of the surfaces at each vertex.
    at: Vec<Vec<usize>>,
    /// Lines of given tractions or given shear at each vertex.
    given: Vec<Vec<usize>>,
    sheared: Vec<Vec<usize>>,
}

impl<'a> Surroundings<'a> {
    fn new(problem: &'a Problem, mesh: &'a Mesh, numbers: &[(LineUse, usize)]) -> Self {
        let mut this = Self {
            problem,
            mesh,
            at: vec![Vec::new(); mesh.vertices.len()],
            given: vec![Vec::new(); mesh.vertices.len()],
            sheared: vec![Vec::new(); mesh.vertices.len()],
        };
        for (side, number) in numbers {
            for vertex in &mesh.lines[side.line] {
                if !this.at[*vertex].contains(number) {
                    this.at[*vertex].push(*number);
                }
            }
        }
        for b in &problem.statement().boundaries {
            let lists = match b.condition {
                c if c.traction_is_given() => &mut this.given,
                c if c.shear_is_given() => &mut this.sheared,
                _ => continue,
            };
            mesh.lines[b.line].iter().for_each(|vertex| lists[*vertex].push(b.line));
        }
        this
    }

    /// Whether two vertices are on one line.
    fn share(list: &[Vec<usize>], a: usize, b: usize) -> bool {
        list[a].iter().any(|line| list[b].contains(line))
    }

    /// Edges to be halved.
    fn wrong(&self) -> BTreeSet<Edge> {
        let mut next_to: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
        let mut wrong = BTreeSet::new();
        for t in &self.mesh.triangles {
            for (i, j) in [(0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)] {
                let (a, v) = (t.corners[i], t.corners[j]);
                if self.at[a].is_empty() {
                    continue;
                }
                if self.given[v].is_empty() {
                    next_to.entry(v).or_default().insert(a);
                } else if !Self::share(&self.given, a, v) {
                    wrong.insert(edge(a, v));
                }
            }
        }
        for (v, apexes) in next_to {
            let keep = self.kept(v, &apexes);
            wrong.extend(apexes.into_iter().filter(|a| !keep(*a)).map(|a| edge(a, v)));
        }
        wrong
    }

    /// Which of the surfaces' vertices next to `v` may stay so.
    fn kept(&self, v: usize, apexes: &BTreeSet<usize>) -> Box<dyn Fn(usize) -> bool + '_> {
        if !self.sheared[v].is_empty() {
            let level = self.is_level_at(v, apexes);
            let on_line = apexes.iter().copied().find(|a| Self::share(&self.sheared, *a, v));
            return match on_line {
                Some(_) if level => Box::new(|_| true),
                one => Box::new(move |a| Some(a) == one),
            };
        }
        let mut counts: BTreeMap<usize, usize> = BTreeMap::new();
        for number in apexes.iter().flat_map(|a| &self.at[*a]) {
            *counts.entry(*number).or_default() += 1;
        }
        let most = counts.into_iter().max_by_key(|(number, count)| (*count, usize::MAX - number));
        let most = most.map_or(AT_REST, |(number, _)| number);
        Box::new(move |a| self.at[a].contains(&most))
    }

    /// Whether all vertices of surfaces next to one on a vertical line of given shear are as high, and nothing shears there.
    fn is_level_at(&self, v: usize, apexes: &BTreeSet<usize>) -> bool {
        let statement = self.problem.statement();
        let mut heights = apexes.iter().map(|a| self.mesh.vertices[*a].position[1]);
        let first = heights.next();
        let upright = self.sheared[v].iter().all(|line| {
            let [p, q] = self.problem.ends(*line);
            p[0] == q[0]
        });
        let body = match statement.objective {
            soilctl_certificate::Objective::Body { gravity } => gravity[0],
            _ => 0.0,
        };
        upright && statement.gravity[0] == 0.0 && body == 0.0 && heights.all(|y| Some(y) == first)
    }
}

/// The mesh with edges halved.
fn halve(problem: &Problem, mesh: Mesh, edges: &BTreeSet<Edge>) -> Mesh {
    let Mesh { mut vertices, mut triangles, lines, mut guide_edges } = mesh;
    let mut line_of: BTreeMap<Edge, usize> = BTreeMap::new();
    for (line, along) in lines.iter().enumerate() {
        line_of.extend(along.windows(2).map(|pair| (edge(pair[0], pair[1]), line)));
    }
    for &[a, b] in edges {
        let middle = vertices.len();
        let line = line_of.get(&[a, b]).copied();
        vertices.push(vertex_on_edge(problem.statement(), line, [vertices[a], vertices[b]], 0.5));
        for i in 0..triangles.len() {
            let Triangle { corners, region } = triangles[i];
            let Some(k) = (0..3).find(|k| edge(corners[(k + 1) % 3], corners[(k + 2) % 3]) == [a, b]) else {
                continue;
            };
            let (mut one, mut other) = (corners, corners);
            one[(k + 1) % 3] = middle;
            other[(k + 2) % 3] = middle;
            triangles[i].corners = one;
            triangles.push(Triangle { corners: other, region });
        }
        if let Some(at) = guide_edges.iter().position(|e| *e == [a, b]) {
            guide_edges[at] = edge(a, middle);
            guide_edges.push(edge(b, middle));
        }
    }
    guide_edges.sort_unstable();
    Mesh::new(problem.statement(), vertices, triangles, guide_edges)
}
