//! The two ends of the mechanism. A block is all that its face towards the plate sweeps when it moves in any direction
//! within phi of the block's velocity: then all its sides separate from the soil that stands still at phi or more, as
//! the rule of flow demands.
//!
//! Faces lie in planes through the plate's top edge. Sweeping and cutting by such a plane do not care for a strip of
//! width w in the middle, so a face is that strip between the two halves of an end face that is the same for every
//! width: what the ends add to the force is a fixed amount.
//!
//! The circular cone of directions is replaced by a polyhedral one around it. Its facets touch the circular one, two of
//! them along the plane of symmetry, so the slip line below stays where it is in the plane.

use std::f64::consts::PI;

use super::fan::Block;

/// A corner of half an end face: distance from the top edge along the ray, distance sideways.
pub(super) type Corner = [f64; 2];
type Vector = [f64; 3];

/// What the two ends add to a mechanism, for a slant length of 1.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ends {
    /// Volume of each block times its upward speed, summed.
    pub(super) lifted: f64,
    /// Area of the last face, which is the surface that heaves.
    pub(super) heaved_area: f64,
}

/// Both ends of these blocks, with this many facets to a cone (even).
pub(super) fn ends(blocks: &[Block], phi: f64, facets: usize) -> Ends {
    let mut face = FIRST_FACE.to_vec();
    let mut lifted = 0.0;
    for block in blocks {
        let swept = Swept::new(&face, block, &edges(block.heading, phi, facets));
        lifted += 2.0 * swept.volume(block) * block.rise();
        face = swept.face(block);
    }
    let half: f64 = face.windows(2).map(|c| 0.5 * (c[0][1] + c[1][1]) * (c[1][0] - c[0][0])).sum();
    Ends { lifted, heaved_area: 2.0 * half }
}

/// The edge of the plate: half of an end face without area.
pub(super) const FIRST_FACE: [Corner; 2] = [[0.0, 0.0], [1.0, 0.0]];

/// Edges on one side of the polyhedral cone about a heading: the unit vector plus `tan(phi) / cos(pi / facets)` across.
pub(super) fn edges(heading: f64, phi: f64, facets: usize) -> Vec<Vector> {
    let step = PI / facets as f64;
    let across = libm::tan(phi) / libm::cos(step);
    let (rise, ahead) = libm::sincos(heading);
    (0..facets / 2)
        .map(|k| {
            let (sideways, up) = libm::sincos(step * (2 * k + 1) as f64);
            [ahead - across * up * rise, across * sideways, rise + across * up * ahead]
        })
        .collect()
}

/// What a half end face sweeps up to the next ray.
pub(super) struct Swept {
    /// Corners of the face.
    start: Vec<Vector>,
    /// Corners of the next face, each with the index of the corner from which an edge of the cone leads there. The first is
    /// the one at the plate's top, which both faces share.
    images: Vec<(Vector, usize)>,
}

/// A corner of a facet between two faces.
#[derive(Debug, Clone, Copy)]
pub(super) enum Rim {
    /// Of the face that sweeps.
    Before(usize),
    /// Of the next face.
    After(usize),
}

impl Swept {
    /// Sweeps a face along the edges of a cone.
    pub(super) fn new(face: &[Corner], block: &Block, edges: &[Vector]) -> Self {
        let [from, to] = block.rays.map(libm::sincos);
        // Normal of the plane of the ray towards the surface.
        let normal = [to.0, 0.0, to.1];
        let start: Vec<Vector> = face.iter().map(|c| [c[0] * from.1, c[1], -c[0] * from.0]).collect();
        // Where the edges from each corner cross that plane; the corner at the top edge is its own image.
        let mut images: Vec<(Vector, usize)> = vec![([0.0; 3], 0)];
        for (corner, &at) in start.iter().enumerate().skip(1) {
            for &edge in edges {
                let reach = -dot(at, normal) / dot(edge, normal);
                images.push((std::array::from_fn(|k| at[k] + reach * edge[k]), corner));
            }
        }
        let flat = |image: &(Vector, usize)| flat(block, image.0);
        images.sort_by(|a, b| flat(a).partial_cmp(&flat(b)).unwrap_or(std::cmp::Ordering::Equal));
        let mut hull: Vec<(Vector, usize)> = Vec::new();
        for image in images {
            let [x, y] = flat(&image);
            while let [.., before, last] = hull.as_slice() {
                let (a, b) = (flat(before), flat(last));
                if (b[0] - a[0]) * (y - a[1]) < (b[1] - a[1]) * (x - a[0]) {
                    break;
                }
                hull.pop();
            }
            hull.push(image);
        }
        Self { start, images: hull }
    }

    /// The next half face.
    pub(super) fn face(&self, block: &Block) -> Vec<Corner> {
        self.images.iter().map(|image| flat(block, image.0)).collect()
    }

    /// The facets between the rims of both faces.
    pub(super) fn facets(&self) -> Vec<[Rim; 3]> {
        let mut facets = Vec::new();
        let mut walk = |from: usize, to: usize, after: usize| {
            facets.extend((from..to).map(|k| [Rim::Before(k), Rim::Before(k + 1), Rim::After(after)]));
        };
        let corner = |after: usize| self.images[after].1;
        let last = self.images.len() - 1;
        for after in 1..=last {
            walk(corner(after - 1), corner(after), after);
        }
        walk(corner(last), self.start.len() - 1, last);
        // The first corner is on both rims.
        facets.extend(
            (2..=last)
                .map(|after| [Rim::Before(corner(after - 1)), Rim::After(after - 1), Rim::After(after)]),
        );
        facets
    }

    fn at(&self, corner: Rim) -> Vector {
        match corner {
            Rim::Before(k) => self.start[k],
            Rim::After(k) => self.images[k].0,
        }
    }

    /// Volume between the faces. The block is convex and has the plate's top as a corner: it is the tetrahedra from there to
    /// its facets.
    fn volume(&self, block: &Block) -> f64 {
        let between: f64 =
            self.facets().into_iter().map(|[a, b, c]| tetrahedron(self.at(a), self.at(b), self.at(c))).sum();
        // Below, there is the slip line's plane.
        let on_plane_of_symmetry = |v: Vector| [v[0], 0.0, v[2]];
        let (Some(&(q, _)), Some(&tip)) = (self.images.last(), self.start.last()) else { return 0.0 };
        let (sin, cos) = libm::sincos(block.rays[1]);
        let below = [block.radii[1] * cos, 0.0, -block.radii[1] * sin];
        between + tetrahedron(tip, q, below) + tetrahedron(tip, below, on_plane_of_symmetry(tip))
    }
}

/// A point in the plane of the ray towards the surface.
fn flat(block: &Block, at: Vector) -> Corner {
    let (sin, cos) = libm::sincos(block.rays[1]);
    [at[0] * cos - at[2] * sin, at[1]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Volume of the tetrahedron from the origin to three points.
fn tetrahedron(a: Vector, b: Vector, c: Vector) -> f64 {
    let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    dot(a, cross).abs() / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each facet of the cone separates at phi exactly: its inner normal and the velocity make `90 deg - phi`.
    #[test]
    fn facets_touch_the_circular_cone() {
        for (heading, phi, facets) in [(0.3, 0.5, 8), (0.9, 0.7, 16), (1.2, 0.2, 64)] {
            let (up, ahead) = libm::sincos(heading);
            let edges = edges(heading, phi, facets);
            let mirrored = |v: Vector| [v[0], -v[1], v[2]];
            // The facets across the plane of symmetry, above and below, and those between.
            let mut pairs = vec![
                (mirrored(edges[0]), edges[0]),
                (edges[edges.len() - 1], mirrored(edges[edges.len() - 1])),
            ];
            pairs.extend(edges.windows(2).map(|pair| (pair[0], pair[1])));
            for (a, b) in pairs {
                let normal =
                    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let sine = dot(normal, [ahead, 0.0, up]).abs() / dot(normal, normal).sqrt();
                assert!((sine - libm::sin(phi)).abs() < 1e-12, "{sine} {phi}");
            }
        }
    }

    /// The first block against a count of points: one belongs to it if some point of the plate lies within phi of the
    /// velocity behind it.
    #[test]
    fn volume_of_a_first_block_by_counting() {
        let (phi, heading, rays): (f64, f64, [f64; 2]) = (0.6, 0.7, [1.5, 0.8]);
        let base = heading - phi;
        let radius = libm::sin(rays[0] + base) / libm::sin(rays[1] + base);
        let block = Block { rays, radii: [1.0, radius], heading, speed: 1.0 };
        let volume = 0.5 * ends(&[block], phi, 128).lifted / block.rise();
        let (velocity, tip) =
            ([libm::cos(heading), 0.0, libm::sin(heading)], [libm::cos(rays[0]), 0.0, -libm::sin(rays[0])]);
        let inside = |p: Vector| {
            let dip = libm::atan2(-p[2], p[0]);
            dip <= rays[0]
                && dip >= rays[1]
                && (0..=200).any(|k| {
                    let from: Vector = std::array::from_fn(|i| p[i] - tip[i] * f64::from(k) / 200.0);
                    dot(from, velocity) >= libm::cos(phi) * dot(from, from).sqrt()
                })
        };
        let (cells, size) = (60, 2.0);
        let at = |k: i32| (f64::from(k) + 0.5) * size / f64::from(cells);
        let mut count = 0;
        for i in 0..cells {
            for j in 0..cells {
                for k in 0..cells {
                    count += i32::from(inside([at(i), at(j), -at(k)]));
                }
            }
        }
        let counted = f64::from(count) * (size / f64::from(cells)).powi(3);
        assert!((counted / volume - 1.0).abs() < 0.03, "{counted} {volume}");
    }
}
