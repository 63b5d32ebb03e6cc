use soilctl_certificate::LineUse;

use super::Point;
use super::boundary::{edges_by_side, face_runs};
use super::stress::StressResults;
use crate::vector::distance;

/// Stresses between the structure and the soil along a face, which may bend, from one end to the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The sides of lines that it consists of, in this order.
    pub sides: Vec<LineUse>,
    /// Whether it leads back to where it starts, all around a buried structure.
    pub closed: bool,
    /// The two ends of each edge of the mesh; between them stresses are linear, from edge to edge they may jump.
    pub points: Vec<ContactPoint>,
}

/// Stresses at a point of a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactPoint {
    /// Distance along the face (length), from its upper end, or from the highest point if it is closed.
    pub arc: f64,
    /// Where it is (length).
    pub at: Point,
    /// Total pressure between structure and soil (stress); negative if the face holds tension.
    pub pressure: f64,
    /// Shear stress of the structure on the soil (stress), positive towards growing `arc`.
    pub shear: f64,
    /// Normal into the soil.
    pub inward: Point,
}

impl Contact {
    /// Length of the face.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.points.last().map_or(0.0, |p| p.arc)
    }

    /// The pressure's resultant, per unit width (stress times length).
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.sum(|a, b| 0.5 * (a.pressure + b.pressure))
    }

    /// The shear stress's resultant, per unit width (stress times length).
    #[must_use]
    pub fn shear_force(&self) -> f64 {
        self.sum(|a, b| 0.5 * (a.shear + b.shear))
    }

    /// The force of the structure on the soil, per unit width (stress times length).
    #[must_use]
    pub fn force(&self) -> Point {
        [0, 1].map(|axis| {
            // Shear acts along the face: the normal turned away from the side on which `arc` grows.
            self.sum(|a, b| {
                let along = [b.at[0] - a.at[0], b.at[1] - a.at[1]];
                let length = b.arc - a.arc;
                0.5 * ((a.pressure + b.pressure) * a.inward[axis]
                    + (a.shear + b.shear) * along[axis] / length)
            })
        })
    }

    /// The `arc` of the pressure's resultant; none if there is no resultant.
    #[must_use]
    pub fn centre(&self) -> Option<f64> {
        let force = self.normal_force();
        let moment = self.sum(|a, b| {
            let ends = 2.0 * (a.pressure * a.arc + b.pressure * b.arc);
            (ends + a.pressure * b.arc + b.pressure * a.arc) / 6.0
        });
        (force != 0.0).then(|| moment / force)
    }

    /// How much of its area the face turns towards a direction, beyond that turned away from it (length).
    #[must_use]
    pub fn turned_towards(&self, direction: Point) -> f64 {
        self.sum(|a, _| a.inward[0] * direction[0] + a.inward[1] * direction[1])
    }

    /// The sum of a mean value of each edge times its length.
    fn sum(&self, mean: impl Fn(&ContactPoint, &ContactPoint) -> f64) -> f64 {
        self.points.chunks_exact(2).map(|p| mean(&p[0], &p[1]) * (p[1].arc - p[0].arc)).sum()
    }

    fn reverse(&mut self) {
        let length = self.length();
        self.sides.reverse();
        self.points.reverse();
        for point in &mut self.points {
            point.arc = length - point.arc;
            point.shear = -point.shear;
        }
    }
}

impl StressResults {
    /// Stresses along all faces of structures and plates. Each side of a plate is a face of its own.
    #[must_use]
    pub fn contacts(&self) -> Vec<Contact> {
        let edges = edges_by_side(&self.shown.adjoins);
        let mut contacts = Vec::new();
        for run in face_runs(&self.statement) {
            let mut contact = Contact { sides: run.sides, closed: run.closed, points: Vec::new() };
            let mut arc = 0.0;
            for side in &contact.sides {
                for &(triangle, corner) in edges.get(side).map_or(&[][..], Vec::as_slice) {
                    let pair = self.on_edge(triangle, corner, arc);
                    arc = pair[1].arc;
                    contact.points.extend(pair);
                }
            }
            let ends = (contact.points.first(), contact.points.last());
            if let (Some(first), Some(last)) = ends {
                if !contact.closed && last.at[1] > first.at[1] {
                    contact.reverse();
                }
                contacts.push(contact);
            }
        }
        contacts
    }

    fn on_edge(&self, triangle: usize, corner: usize, arc: f64) -> [ContactPoint; 2] {
        let v = &self.shown.corners[triangle];
        let [a, b] = [1, 2].map(|i| v[(corner + i) % 3]);
        let length = distance(b, a);
        let t = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
        let inward = [-t[1], t[0]];
        let nodes = &self.shown.parts[triangle][corner];
        let point = |at: Point, [xx, yy, xy]: [f64; 3], arc: f64| {
            // On the soil's surface, whose normal points out of the soil.
            let traction = [-(xx * inward[0] + xy * inward[1]), -(xy * inward[0] + yy * inward[1])];
            ContactPoint {
                arc,
                at,
                pressure: traction[0] * inward[0] + traction[1] * inward[1],
                shear: traction[0] * t[0] + traction[1] * t[1],
                inward,
            }
        };
        [point(a, nodes[0], arc), point(b, nodes[1], arc + length)]
    }
}
