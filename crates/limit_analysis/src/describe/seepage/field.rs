//! The flow, and what is kept of it.

use soilctl_certificate::LineUse;
use soilctl_seepage::{Boundary, Condition, Flow, Ground, SeepageError, Triangle};

use std::collections::BTreeMap;

use super::super::error::DescriptionError;
use super::super::faces::Face;
use super::super::ground::{Map, inside};
use super::super::holds::Holds;
use super::super::input::Description;
use super::super::segments::{Cut, Owner, Segment};
use super::flowed::{FlowUnit, Flowed, HeadFlow};
use super::mesh::{Sizes, mesh, outline, sides};
use crate::error::LimitError;
use crate::mesh::Mesh;
use crate::vector::{Point, between, centroid, cross, dot, length, midpoint};

/// Meshes that are made one after another.
const ROUNDS: usize = 3;

/// How often triangles are cut into four for the flow that is kept, and where there are more than so many: it takes seconds then.
const CUTS: u32 = 3;
const MANY: usize = 400;

/// What may be missed of the pressure in any triangle, as a part of the greatest one.
const LEAST: f64 = 5e-3;

/// Pressures are kept in steps of this part of a power of two near the greatest one.
const GRAIN: f64 = 1.0 / (1 << 30) as f64;

/// A triangle with water in its pores.
#[derive(Debug, Clone, PartialEq)]
struct Wet {
    corners: [Point; 3],
    /// Pore pressures there in kPa.
    kpa: [f64; 3],
}

/// Pore pressures of water that flows: continuous but across walls, linear in triangles, zero elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PoreField {
    wet: Vec<Wet>,
    /// The flow in numbers.
    pub(crate) flowed: Flowed,
}

/// The ground as it is before it is cut for the flow.
pub(in crate::describe) struct Uncut<'a> {
    pub(in crate::describe) description: &'a Description,
    pub(in crate::describe) map: &'a Map,
    pub(in crate::describe) faces: &'a [Face],
    pub(in crate::describe) holds: &'a BTreeMap<LineUse, Holds>,
    /// Entries of given heads by the sides they are on.
    pub(in crate::describe) heads: &'a BTreeMap<LineUse, usize>,
}

impl Uncut<'_> {
    /// Finds the flow.
    pub(in crate::describe) fn pore_field(&self) -> Result<PoreField, LimitError> {
        let outline = outline(self.map, self.faces);
        let area = self.area();
        let (mut mesh_now, mut round) = (mesh(&outline, &Sizes::uniform(area))?, 1);
        loop {
            let ground = self.ground(&mesh_now);
            let cuts = if ground.triangles.len() > MANY { CUTS - 1 } else { CUTS };
            let found = self.found(&ground, cuts - 1)?;
            if round == ROUNDS {
                return Ok(self.kept(&mesh_now, &self.found(&ground, cuts)?, &found));
            }
            let triangles = (0..mesh_now.triangles.len()).map(|t| mesh_now.corners(t)).collect();
            let least = LEAST * found.greatest();
            let sizes = Sizes::of_missed(triangles, &found.missed, least, area);
            (mesh_now, round) = (mesh(&outline, &sizes)?, round + 1);
        }
    }

    fn area(&self) -> f64 {
        let ring = |ring: &Vec<LineUse>| {
            super::super::faces::area(&ring.iter().map(|w| self.map.walked_points(*w)[0]).collect::<Vec<_>>())
        };
        self.faces.iter().flat_map(|face| &face.loops).map(ring).sum()
    }

    fn ground(&self, mesh: &Mesh) -> Ground {
        let description = self.description;
        let triangle = |t: &soilctl_certificate::Triangle| {
            let soil = &description.soils[description.soil_of(self.faces[t.region].region)];
            let down = soil.permeability_m_per_s.unwrap_or(1.0);
            Triangle {
                corners: t.corners,
                permeability: [down * soil.permeability_ratio.unwrap_or(1.0), down],
            }
        };
        let mut ground = Ground {
            points: mesh.vertices.iter().map(|v| v.position).collect(),
            triangles: mesh.triangles.iter().map(triangle).collect(),
            ..Ground::default()
        };
        for (triangle, sides) in sides(mesh).into_iter().enumerate() {
            for (opposite, side) in sides.into_iter().enumerate() {
                let Some((side, holds)) = side.and_then(|s| Some((s, self.holds.get(&s)?))) else { continue };
                let ends = [1, 2].map(|i| mesh.triangles[triangle].corners[(opposite + i) % 3]);
                if self.map.left_of(side.reversed()).is_soil() {
                    // A plate.
                    if side.forward {
                        ground.walls.push(ends);
                    }
                    continue;
                }
                let [a, b] = ends.map(|v| mesh.vertices[v].position);
                let head = self.heads.get(&side).map(|entry| (*entry, description.heads[*entry].head_m));
                let condition = match (head, holds) {
                    (Some((entry, head)), _) if midpoint(a, b)[1] <= head => Condition::Head { head, entry },
                    (_, Holds::Free | Holds::Load { .. }) => Condition::Air,
                    (_, Holds::Fixed | Holds::Smooth | Holds::Far | Holds::Face(_)) => continue,
                };
                ground.boundaries.push(Boundary { triangle, opposite, condition });
            }
        }
        ground
    }

    fn error(&self, error: SeepageError) -> LimitError {
        DescriptionError::entry(self.description.head_title(0), error.to_string()).into()
    }

    /// The flow on finer triangles.
    fn found(&self, ground: &Ground, cuts: u32) -> Result<Found, LimitError> {
        let mut fine = ground.clone();
        for _ in 0..cuts {
            fine = fine.refined().map_err(|e| self.error(e))?;
        }
        let flow = fine.flow().map_err(|e| self.error(e))?;
        let weight = self.description.seepage.unwrap_or_default().unit_weight_kn_m3;
        let pressure = |t: usize, i: usize| {
            (weight * (flow.heads[t][i] - fine.points[fine.triangles[t].corners[i]][1])).max(0.0)
        };
        let parts = 4_usize.pow(cuts);
        let mut corners = Vec::with_capacity(ground.triangles.len());
        let mut missed = Vec::with_capacity(ground.triangles.len());
        for (t, triangle) in ground.triangles.iter().enumerate() {
            // The first of four, again and again, stays at the first corner.
            let at = |i: usize| pressure((0..cuts).fold(t, |t, _| 4 * t + i), i);
            let kpa = [0, 1, 2].map(at);
            let v = triangle.corners.map(|c| ground.points[c]);
            let mut most: f64 = 0.0;
            for part in parts * t..parts * (t + 1) {
                for i in 0..3 {
                    let p = fine.points[fine.triangles[part].corners[i]];
                    most = most.max((pressure(part, i) - linear(&v, &kpa, p)).abs());
                }
            }
            corners.push(kpa);
            missed.push(most);
        }
        Ok(Found { fine, flow, corners, missed })
    }

    /// What is kept of a flow; `less` is the same on larger triangles.
    fn kept(&self, mesh: &Mesh, found: &Found, less: &Found) -> PoreField {
        let greatest = found.greatest();
        // In steps, so that the last bits of the flow, which depend on the processor, are not in the statement.
        let step = GRAIN * 2.0_f64.powi(greatest.max(f64::MIN_POSITIVE).log2().floor() as i32);
        let kpa = found.corners.iter().map(|kpa| kpa.map(|p| (p / step).round() * step));
        let all = kpa.enumerate().map(|(t, kpa)| Wet { corners: mesh.corners(t), kpa });
        let wet: Vec<Wet> = all.filter(|wet| wet.kpa != [0.0; 3]).collect();
        let coarser = found.corners.iter().flatten().zip(less.corners.iter().flatten());
        let apart = coarser.map(|(fine, coarse)| (fine - coarse).abs());
        let description = self.description;
        let entries = description.heads.iter().enumerate().map(|(entry, head)| HeadFlow {
            name: head.name.clone(),
            head_m: head.head_m,
            inflow: found.flow.inflow.get(entry).copied().unwrap_or(0.0),
        });
        let is_known = description.soils.iter().any(|s| {
            s.permeability_m_per_s.is_some() && description.regions.iter().any(|r| r.soil == s.name)
        });
        let flowed = Flowed {
            heads: entries.collect(),
            seepage: -found.flow.air,
            unit: if is_known { FlowUnit::M2PerS } else { FlowUnit::OverPermeability },
            exit_gradient: found.exit_gradient(),
            free_surface: found.contours(&[0.0], Contoured::Pressure),
            equipotentials: found.equipotentials(),
            triangles: wet.len(),
            greatest_kpa: greatest,
            kept_within_kpa: found.missed.iter().copied().fold(0.0, f64::max),
            found_within_kpa: apart.fold(0.0, f64::max),
        };
        PoreField { wet, flowed }
    }
}

/// A flow with what is kept of it.
struct Found {
    fine: Ground,
    flow: Flow,
    /// Pore pressures at the corners of the large triangles in kPa.
    corners: Vec<[f64; 3]>,
    /// Greatest difference between those of the small triangles and linear ones in the large.
    missed: Vec<f64>,
}

impl Found {
    /// Greatest pore pressure in kPa.
    fn greatest(&self) -> f64 {
        self.corners.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// Where the head has values between the least and the greatest.
    fn equipotentials(&self) -> Vec<[Point; 2]> {
        let wet = self.fine.triangles.iter().zip(&self.flow.heads).flat_map(|(triangle, heads)| {
            let above = |i: &usize| heads[*i] >= self.fine.points[triangle.corners[*i]][1];
            (0..3).filter(above).map(|i| heads[i]).collect::<Vec<_>>()
        });
        let [low, high] =
            wet.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], head| [low.min(head), high.max(head)]);
        let levels: Vec<f64> = (1..10).map(|i| low + (high - low) * f64::from(i) / 10.0).collect();
        if high > low { self.contours(&levels, Contoured::Head) } else { Vec::new() }
    }

    /// Lines on which the head, where the pressure is above zero, or the pressure has some values.
    fn contours(&self, levels: &[f64], of: Contoured) -> Vec<[Point; 2]> {
        let mut pieces = Vec::new();
        for (triangle, heads) in self.fine.triangles.iter().zip(&self.flow.heads) {
            let v = triangle.corners.map(|c| self.fine.points[c]);
            let pressures = [0, 1, 2].map(|i| heads[i] - v[i][1]);
            let values = match of {
                Contoured::Head if pressures.iter().all(|p| *p < 0.0) => continue,
                Contoured::Head => *heads,
                Contoured::Pressure => pressures,
            };
            for level in levels {
                let crossing = |k: usize| {
                    let [i, j] = [(k + 1) % 3, (k + 2) % 3];
                    let is_between = (values[i] < *level) != (values[j] < *level);
                    let part = (level - values[i]) / (values[j] - values[i]);
                    is_between.then(|| [0, 1].map(|axis| v[i][axis] + part * (v[j][axis] - v[i][axis])))
                };
                let mut ends = (0..3).filter_map(crossing);
                if let (Some(a), Some(b)) = (ends.next(), ends.next()) {
                    pieces.push([a, b]);
                }
            }
        }
        pieces
    }

    /// Greatest loss of head over the way where water comes out.
    fn exit_gradient(&self) -> Option<(f64, Point)> {
        let gradient = |boundary: &Boundary| {
            let triangle = &self.fine.triangles[boundary.triangle];
            let v = triangle.corners.map(|c| self.fine.points[c]);
            let heads = self.flow.heads[boundary.triangle];
            let [a, b] = [1, 2].map(|i| v[(boundary.opposite + i) % 3]);
            let along = between(a, b);
            let outwards = [along[1] / length(along), -along[0] / length(along)];
            let loss = -dot(slope(&v, &heads), outwards);
            (loss > 0.0).then(|| (loss, midpoint(a, b)))
        };
        self.fine.boundaries.iter().filter_map(gradient).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// Of what contours are.
#[derive(Debug, Clone, Copy)]
enum Contoured {
    Head,
    Pressure,
}

/// What is linear in a triangle, by its values at the corners.
fn linear(v: &[Point; 3], values: &[f64; 3], p: Point) -> f64 {
    values[0] + dot(slope(v, values), between(v[0], p))
}

/// Its gradient.
fn slope(v: &[Point; 3], values: &[f64; 3]) -> [f64; 2] {
    let [ab, ac] = [between(v[0], v[1]), between(v[0], v[2])];
    let [b, c] = [values[1] - values[0], values[2] - values[0]];
    let turn = cross(ab, ac);
    [(b * ac[1] - c * ab[1]) / turn, (c * ab[0] - b * ac[0]) / turn]
}

/// A pressure in kPa that is linear: its value at a point and its gradient in kPa/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::describe) struct Plane {
    pub(in crate::describe) at: Point,
    pub(in crate::describe) kpa: f64,
    pub(in crate::describe) gradient: [f64; 2],
}

impl PoreField {
    /// Cuts along all edges of triangles with water.
    pub(in crate::describe) fn cuts(&self) -> Vec<Segment> {
        let mut edges: Vec<[Point; 2]> = self
            .wet
            .iter()
            .flat_map(|wet| [0, 1, 2].map(|k| [wet.corners[(k + 1) % 3], wet.corners[(k + 2) % 3]]))
            .map(|[a, b]| if before(a, b) { [a, b] } else { [b, a] })
            .collect();
        edges.sort_by(|a, b| compare(a[0], b[0]).then(compare(a[1], b[1])));
        edges.dedup();
        edges.into_iter().map(|ends| Segment { ends, owner: Owner::Cut(Cut::Flow), number: 0 }).collect()
    }

    /// The pore pressure in a piece of soil; none where it is zero.
    pub(in crate::describe) fn within(&self, loops: &[Vec<Point>]) -> Option<Plane> {
        let holds = |wet: &&Wet| {
            let middle = centroid(&wet.corners);
            loops.iter().filter(|ring| inside(ring, middle)).count() % 2 == 1
        };
        let wet = self.wet.iter().find(holds)?;
        // From the corner with the least pressure, which may be exactly none.
        let least = (0..3).min_by(|i, j| wet.kpa[*i].total_cmp(&wet.kpa[*j])).unwrap_or(0);
        Some(Plane { at: wet.corners[least], kpa: wet.kpa[least], gradient: slope(&wet.corners, &wet.kpa) })
    }
}

fn compare(a: Point, b: Point) -> std::cmp::Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))
}

fn before(a: Point, b: Point) -> bool {
    compare(a, b).is_lt()
}
