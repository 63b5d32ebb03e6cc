//! What members bear: along themselves, and on their faces.

use soilctl_certificate::Member;
use soilctl_conic::Form;

use super::{Lower, Stress, traction};
use crate::members::{bears_force, velocity_at_end};
use crate::mesh::Mesh;
use crate::problem::{Problem, Soil};
use crate::vector::{Point, between, length, midpoint};

/// A strength of so many times what the soil around bears over an edge is never needed.
const MORE_THAN_ENOUGH: f64 = 1e6;

impl Lower {
    /// Limits the axial forces of all members, at Bernstein coefficients; adds those of ends that are attached to the structure to
    /// its force.
    pub(super) fn add_members(&mut self, problem: &Problem, mesh: &Mesh) {
        for edge in self.members.clone() {
            let m = &problem.members()[edge.member];
            if !bears_force(m) {
                continue;
            }
            let [a, middle, b] = self.function.axial_force(&edge);
            let region = mesh.triangles[edge.side.triangle].region;
            let scale =
                1.0 / problem.stress_scale(region, midpoint(edge.ends[0], edge.ends[1]), edge.length());
            let between = Form::default().plus(2.0, &middle).plus(-0.5, &a).plus(-0.5, &b);
            for force in [&a, &between, &b] {
                for (limit, sign) in [(m.tension, -1.0), (m.compression, 1.0)] {
                    if !force.terms.is_empty() && limit * scale < MORE_THAN_ENOUGH {
                        let row =
                            Form::default().plus(scale * limit, &self.strength()).plus(sign * scale, force);
                        self.program.non_negative(row);
                    }
                }
            }
            if problem.has_factor() {
                continue;
            }
            // The structure pulls the start backwards and the end forwards.
            for (end, (force, sign)) in [(&a, -1.0), (&b, 1.0)].into_iter().enumerate() {
                if let Some(velocity) =
                    velocity_at_end(problem, edge.member, end).filter(|_| edge.is_end[end])
                {
                    self.force.add(sign * velocity, force);
                }
            }
        }
    }

    /// Limits the traction on the face of a member, of the part of a triangle at edge `k`, to a part of what the soil bears.
    pub(super) fn add_bond(
        &mut self,
        member: &Member,
        soil: &Soil,
        part: &[Option<Stress>; 3],
        v: &[Point; 3],
        k: usize,
        scale: &impl Fn(Point) -> f64,
    ) {
        if member.bond == 1.0 {
            return;
        }
        let ends = [v[(k + 1) % 3], v[(k + 2) % 3]];
        let along = between(ends[0], ends[1]);
        let t = along.map(|x| x / length(along));
        for (stress, p) in part.iter().zip(ends) {
            let Some(stress) = stress else { continue };
            let (normal, shear) = traction(stress, t);
            let by = scale(p);
            let friction = by * member.bond * soil.tan;
            let hold = Form::constant(-friction * soil.pore_pressure.at(p))
                .plus(by * member.bond * soil.cohesion.at(p).max(0.0), &self.strength())
                .plus(-friction, &normal);
            self.program.non_negative(hold.clone().plus(by, &shear));
            self.program.non_negative(hold.plus(-by, &shear));
        }
    }
}
