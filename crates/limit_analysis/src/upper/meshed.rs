//! A problem on a mesh: what there is on both sides of an edge.

use soilctl_certificate::{Condition, Side};

use super::toes::Toes;
use crate::mesh::Mesh;
use crate::problem::{Problem, Soil};
use crate::topology::Topology;
use crate::vector::{Point, midpoint};

/// A problem on a mesh.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MeshedProblem<'a> {
    pub(crate) problem: &'a Problem,
    pub(crate) mesh: &'a Mesh,
    pub(crate) topology: &'a Topology,
    pub(crate) toes: &'a Toes,
}

/// What a flow meets at an edge.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Edge {
    Boundary(Condition),
    /// Nothing: it goes on beyond, if there is soil.
    Glued,
    /// It may jump, as a thin layer of the soil of a region.
    Jump {
        other: Side,
        region: usize,
    },
    /// It may slip, at the toe of a wall.
    Slip {
        other: Side,
    },
    /// A member, in which either soil may slide.
    Member {
        other: Side,
    },
}

impl<'a> MeshedProblem<'a> {
    pub(crate) fn soil(&self, triangle: usize) -> &'a Soil {
        &self.problem.soils[self.mesh.triangles[triangle].region]
    }

    /// Whether the flow is that of a stream function.
    pub(crate) fn is_isochoric(&self, triangle: usize) -> bool {
        self.soil(triangle).is_isochoric
    }

    pub(crate) fn corners(&self, triangle: usize) -> [Point; 3] {
        self.mesh.corners(triangle)
    }

    /// Ends of an edge, as the triangle's sense of rotation goes.
    pub(crate) fn ends(&self, side: Side) -> [Point; 2] {
        let v = self.corners(side.triangle);
        [v[(side.corner + 1) % 3], v[(side.corner + 2) % 3]]
    }

    pub(crate) fn edge(&self, side: Side) -> Edge {
        let Side { triangle, corner } = side;
        if let Some(condition) = self.topology.line[triangle][corner].and_then(|l| self.problem.condition(l))
        {
            return Edge::Boundary(condition);
        }
        let Some(other) = self.topology.across[triangle][corner] else { return Edge::Glued };
        if self.topology.line[triangle][corner].is_some_and(|l| self.problem.member_on(l.line).is_some()) {
            return Edge::Member { other };
        }
        let [here, there] = [triangle, other.triangle].map(|t| self.mesh.triangles[t].region);
        let jump = |region| Edge::Jump { other, region };
        match [triangle, other.triangle].map(|t| self.is_isochoric(t)) {
            [true, true] if self.toes.slips(side) => Edge::Slip { other },
            [true, true] => Edge::Glued,
            // Isochoric soil cannot open, dilatant soil must.
            [true, false] => jump(there),
            [false, true] => jump(here),
            [false, false] if !same_strength(self.soil(triangle), self.soil(other.triangle)) => {
                jump(self.weaker(side, here, there))
            }
            [false, false] if self.topology.guide[triangle][corner] => jump(here),
            [false, false] => Edge::Glued,
        }
    }

    /// The region of less friction, or else of less cohesion.
    fn weaker(&self, side: Side, here: usize, there: usize) -> usize {
        let [a, b] = self.ends(side);
        let middle = midpoint(a, b);
        let of = |region: usize| {
            let soil = &self.problem.soils[region];
            (soil.flow_tan(), soil.cohesion.at(middle))
        };
        let ((tan, cohesion), (other_tan, other_cohesion)) = (of(here), of(there));
        if tan < other_tan || (tan == other_tan && cohesion <= other_cohesion) { here } else { there }
    }
}

fn same_strength(a: &Soil, b: &Soil) -> bool {
    a.tan == b.tan
        && a.cohesion == b.cohesion
        && a.pore_pressure == b.pore_pressure
        && a.cut_off == b.cut_off
        && a.envelope == b.envelope
}
