//! A box of eight cubes about the end of a plate, each of twelve tetrahedra about its centre.

use std::collections::{BTreeMap, BTreeSet};

use super::super::field::{SpaceSection, SpaceStress};

/// Stress as a function of place.
pub(super) type Stress<'a> = &'a dyn Fn([f64; 3]) -> [[f64; 3]; 3];

#[derive(Debug, Clone)]
pub(super) struct Small {
    pub(super) vertices: Vec<[f64; 3]>,
    pub(super) tetrahedra: Vec<[usize; 4]>,
}

pub(super) const SIDES: [[f64; 3]; 3] = [[-1.0, 0.0, 2.0], [-0.5, 0.0, 1.0], [-2.0, -1.0, 0.0]];

impl Small {
    /// Without centres there are six about a diagonal of each cube, some with two faces in planes of the box.
    pub(super) fn new(cut: bool) -> Self {
        let at = |i: usize, j: usize, k: usize| (i * 3 + j) * 3 + k;
        let mut vertices = Vec::new();
        for x in SIDES[0] {
            for s in SIDES[1] {
                vertices.extend(SIDES[2].map(|z| [x, s, z]));
            }
        }
        let mut tetrahedra = Vec::new();
        for cube in 0..8 {
            let corner = [cube / 4, cube / 2 % 2, cube % 2];
            let centre = vertices.len();
            if cut {
                vertices.push(std::array::from_fn(|k| 0.5 * (SIDES[k][corner[k]] + SIDES[k][corner[k] + 1])));
            }
            for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                let mut way = corner;
                let mut cell = vec![at(way[0], way[1], way[2])];
                for axis in order {
                    way[axis] += 1;
                    cell.push(at(way[0], way[1], way[2]));
                }
                if !cut {
                    tetrahedra.push([cell[0], cell[1], cell[2], cell[3]]);
                    continue;
                }
                tetrahedra.push([cell[0], cell[1], cell[2], centre]);
                tetrahedra.push([centre, cell[1], cell[2], cell[3]]);
            }
        }
        Self { vertices, tetrahedra }
    }

    pub(super) fn faces(&self) -> Vec<[usize; 3]> {
        let faces = self.tetrahedra.iter().flat_map(|t| {
            [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]].map(|k| {
                let mut face = k.map(|k| t[k]);
                face.sort_unstable();
                face
            })
        });
        faces.collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The field with these stresses, and others behind the plate.
    pub(super) fn field(&self, stress: Stress, behind: Stress) -> SpaceStress {
        let faces = self.faces();
        let traction = |face: &[usize; 3], stress: Stress| {
            let [a, b, c] = face.map(|v| self.vertices[v]);
            let (u, v): ([f64; 3], [f64; 3]) =
                (std::array::from_fn(|k| b[k] - a[k]), std::array::from_fn(|k| c[k] - a[k]));
            let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let long = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
            face.map(|v| stress(self.vertices[v]).map(|row| (0..3).map(|k| row[k] * normal[k] / long).sum()))
        };
        let all =
            |face: &[usize; 3], is: &dyn Fn([f64; 3]) -> bool| face.iter().all(|&v| is(self.vertices[v]));
        let plate: Vec<&[usize; 3]> =
            faces.iter().filter(|f| all(f, &|[x, s, z]| x == 0.0 && s <= 0.0 && z >= -1.0)).collect();
        let (mut numbers, mut middles) = (BTreeMap::new(), BTreeMap::new());
        let mut section = SpaceSection {
            vertices: vec![],
            triangles: vec![],
            parents: vec![],
            tractions: vec![],
            behind: vec![],
        };
        for (number, face) in faces.iter().enumerate().filter(|(_, f)| all(f, &|p| p[1] == SIDES[1][0])) {
            let corners = face.map(|v| {
                *numbers.entry(v).or_insert_with(|| {
                    section.vertices.push([self.vertices[v][0], self.vertices[v][2]]);
                    section.vertices.len() - 1
                })
            });
            let mut middle = |a: usize, b: usize| {
                *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let [[ax, az], [bx, bz]] = [section.vertices[a], section.vertices[b]];
                    section.vertices.push([0.5 * (ax + bx), 0.5 * (az + bz)]);
                    section.vertices.len() - 1
                })
            };
            let [a, b, c] = corners;
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            section.triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            section.parents.extend([number; 4]);
        }
        let edges: BTreeSet<[usize; 2]> = section
            .triangles
            .iter()
            .flat_map(|t| [[0, 1], [0, 2], [1, 2]].map(|[a, b]| [t[a].min(t[b]), t[a].max(t[b])]))
            .collect();
        let plane = |edge: &[usize; 2], stress: Stress| {
            let [a, b] = edge.map(|v| section.vertices[v]);
            let normal = [b[1] - a[1], a[0] - b[0]];
            let long = normal[0].hypot(normal[1]);
            [a, b].map(|[x, z]| {
                let p = stress([x, SIDES[1][0], z]);
                [0, 2].map(|k| (p[k][0] * normal[0] + p[k][2] * normal[1]) / long)
            })
        };
        let at_plate = |edge: &&[usize; 2]| {
            edge.iter().all(|&v| section.vertices[v][0] == 0.0 && section.vertices[v][1] >= -1.0)
        };
        section.tractions = edges.iter().map(|edge| plane(edge, stress)).collect();
        section.behind = edges.iter().filter(at_plate).map(|edge| plane(edge, behind)).collect();
        SpaceStress {
            vertices: self.vertices.clone(),
            tetrahedra: self.tetrahedra.clone(),
            tractions: faces.iter().map(|face| traction(face, stress)).collect(),
            behind: plate.into_iter().map(|face| traction(face, behind)).collect(),
            section,
        }
    }
}

/// The ground with other pressures along x and s than at rest.
pub(super) fn ground(x: f64, s: f64) -> impl Fn([f64; 3]) -> [[f64; 3]; 3] {
    move |[_, _, z]| [[-x * z, 0.0, 0.0], [0.0, -s * z, 0.0], [0.0, 0.0, -z]]
}
