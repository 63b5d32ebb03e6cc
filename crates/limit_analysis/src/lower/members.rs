//! What members bear: along themselves, and on their faces.

use soilctl_certificate::Member;
use soilctl_conic::Form;

use super::{Lower, Stress, traction};
use crate::members::{MemberEdge, bears_force, velocity_at_end};
use crate::mesh::Mesh;
use crate::problem::{Problem, Soil};
use crate::vector::{Point, between, length, midpoint, turned};

/// A strength of so many times what the soil around bears over an edge is never needed.
const MORE_THAN_ENOUGH: f64 = 1e6;

/// What a member bears along an edge.
#[derive(Debug, Clone)]
pub(crate) struct SectionForces {
    /// The axial force: Bernstein coefficients.
    pub(crate) axial: [Form; 3],
    /// Of a beam.
    pub(crate) bent: Option<Bent>,
}

/// Bernstein coefficients of what a beam bears by bending.
#[derive(Debug, Clone)]
pub(crate) struct Bent {
    pub(crate) moment: [Form; 4],
    pub(crate) shear: [Form; 3],
}

impl Lower {
    /// What a member bears along an edge.
    pub(crate) fn section_forces(&self, problem: &Problem, edge: &MemberEdge) -> SectionForces {
        let none = Form::default;
        // A quadratic's coefficients from its values.
        let bernstein = |[a, middle, b]: [Form; 3]| {
            let between = none().plus(2.0, &middle).plus(-0.5, &a).plus(-0.5, &b);
            [a, between, b]
        };
        if !problem.bends(edge.member) {
            return SectionForces { axial: bernstein(self.function.axial_force(edge)), bent: None };
        }
        let (ends, middle) = self.function.jump_at_beam(problem, edge);
        let (t, third) = (edge.along(), edge.length() / 3.0);
        let along = |d: Point, jump: &[Form; 3]| none().plus(d[0], &jump[1]).plus(d[1], &jump[2]);
        let [v0, v1] = [0, 1].map(|i| along(t, &ends[i]));
        let [a, b] = [0, 1].map(|i| along(turned(t), &ends[i]));
        let moment = [
            ends[0][0].clone(),
            ends[0][0].clone().plus(third, &v0),
            ends[1][0].clone().plus(-third, &v1),
            ends[1][0].clone(),
        ];
        let between = none().plus(1.0 / third, &moment[2]).plus(-1.0 / third, &moment[1]);
        let bent = Bent { moment, shear: [v0, between, v1] };
        SectionForces { axial: bernstein([a, middle, b]), bent: Some(bent) }
    }

    /// Limits the forces in all members, at Bernstein coefficients; adds those of ends that are attached to the structure to
    /// its force.
    pub(super) fn add_members(&mut self, problem: &Problem, mesh: &Mesh) {
        for edge in self.members.clone() {
            let m = &problem.members()[edge.member];
            if !bears_force(m) {
                continue;
            }
            let forces = self.section_forces(problem, &edge);
            let region = mesh.triangles[edge.first().triangle].region;
            let h = edge.length();
            let scale = 1.0 / problem.stress_scale(region, midpoint(edge.ends[0], edge.ends[1]), h);
            for force in &forces.axial {
                self.limit(force, [m.tension, m.compression], scale);
            }
            if let (Some(bent), Some(most)) = (&forces.bent, m.bending) {
                for moment in &bent.moment {
                    self.limit(moment, [most.moment; 2], scale / h);
                }
                for shear in &bent.shear {
                    self.limit(shear, [most.shear; 2], scale);
                }
            }
            if let Some(gripped) = edge.gripped(m).filter(|_| !edge.is_free(problem, mesh)) {
                let [a, b, c] = &forces.axial;
                let half = 0.5 * h;
                for ((from, to), most) in [(a, b), (b, c)].into_iter().zip(gripped.most) {
                    self.limit(&to.clone().plus(-1.0, from), [half * most; 2], scale);
                }
            }
            if problem.has_factor() {
                continue;
            }
            // The structure pulls the start backwards and the end forwards.
            let [a, _, b] = &forces.axial;
            for (end, (force, sign)) in [(a, -1.0), (b, 1.0)].into_iter().enumerate() {
                if let Some(velocity) =
                    velocity_at_end(problem, edge.member, end).filter(|_| edge.is_end[end])
                {
                    self.force.add(sign * velocity, force);
                }
            }
        }
    }

    /// Limits a force from above and from below.
    fn limit(&mut self, force: &Form, [most, least]: [f64; 2], scale: f64) {
        for (limit, sign) in [(most, -1.0), (least, 1.0)] {
            if !force.terms.is_empty() && limit * scale < MORE_THAN_ENOUGH {
                let row = Form::default().plus(scale * limit, &self.strength()).plus(sign * scale, force);
                self.program.non_negative(row);
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
        let [forwards, backwards] = soil.ellipse.both_ways(t);
        for (stress, p) in part.iter().zip(ends) {
            let Some(stress) = stress else { continue };
            let (normal, shear) = traction(stress, t);
            let by = scale(p);
            let own = (soil.tan, soil.cohesion.at(p).max(0.0));
            let further = soil.envelope.iter().flat_map(|envelope| &envelope.inside);
            let lines = further.map(|line| (line.tan(), line.cohesion)).chain([own]);
            for (tan, cohesion) in lines {
                let friction = by * member.bond * tan;
                let strength = self.strength();
                let hold = |way: f64| {
                    Form::constant(-friction * soil.pore_pressure.at(p))
                        .plus(by * member.bond * cohesion * way, &strength)
                        .plus(-friction, &normal)
                };
                // The traction is that on the right.
                self.program.non_negative(hold(forwards).plus(by, &shear));
                self.program.non_negative(hold(backwards).plus(-by, &shear));
            }
        }
    }
}
