//! The kinematic program: the least force, or the least factor on loads, over kinematically admissible velocities.
//!
//! Soil with friction dilates as much as it demands: velocities are quadratic on six-node triangles and may jump across
//! guides, interfaces and structure faces (Makrodimopoulos & Martin 2007, 2008). Soil without friction keeps its volume:
//! its velocity is that of a stream function.

mod beams;
mod edge_velocity;
mod edges;
mod freedom;
mod isochoric;
mod members;
mod meshed;
mod nodes;
mod power;
mod quadratic;
mod stream;
mod strength;
#[cfg(test)]
mod tests;
mod toes;
mod walls;

use std::collections::BTreeMap;

use soilctl_certificate::{Flow, Objective, Side, UpperField, Velocity as Saved};
use soilctl_conic::{Cone, Form, Program};

pub(crate) use isochoric::shear_rates;
pub(crate) use members::{MemberPiece, bond};
pub(crate) use meshed::{Edge, MeshedProblem};
pub(crate) use nodes::Element;
pub(crate) use quadratic::gradients;
pub(crate) use strength::Limit;
pub(crate) use toes::Toes;

use beams::BeamMotion;
use freedom::{Freedom, freedoms};
use nodes::Elements;
use power::{Power, live_size, objective_unit};
use stream::{Depending, StreamFunction};

use crate::anisotropy::Ellipse;
use crate::mesh::Mesh;
use crate::problem::Problem;
use crate::topology::Topology;
use crate::vector::{Point, distance};

/// Velocity of a node.
pub(crate) type Velocity = [Form; 2];

#[derive(Debug)]
pub(crate) struct Upper {
    pub(crate) program: Program,
    /// What the program minimises: the force on the structure, or the factor on the loads.
    #[cfg(test)]
    pub(crate) force: Form,
    pub(crate) elements: Vec<Element>,
    freedoms: Vec<Freedom>,
    pub(crate) velocities: Vec<Velocity>,
    stream: StreamFunction,
    /// How members move.
    pub(crate) members: Vec<MemberPiece>,
    /// Velocities of the control points of the triangles that have a stream function, which are exact along the edges.
    pub(crate) control: Vec<Option<[Velocity; 6]>>,
    pub(crate) corners: Vec<[Point; 3]>,
    /// Power of the live loads; one if there are none.
    pub(crate) live: f64,
    /// Which limit of each triangle's strength counts.
    pub(crate) limits: Vec<Limit>,
    /// How each triangle's strength depends on the direction.
    pub(crate) ellipses: Vec<Ellipse>,
}

/// A program in the making.
struct Builder<'a> {
    meshed: MeshedProblem<'a>,
    elements: Vec<Element>,
    velocities: Vec<Velocity>,
    stream: StreamFunction,
    /// How beams move across themselves.
    beams: BTreeMap<usize, BeamMotion>,
    program: Program,
    power: Power,
    tighten: f64,
    /// Whether the factor on everything that acts is bounded.
    all: bool,
}

impl Upper {
    pub(crate) fn new(
        problem: &Problem,
        mesh: &Mesh,
        topology: &Topology,
        still: &[bool],
        tighten: f64,
    ) -> Self {
        let toes = Toes::new(problem, mesh, topology);
        let meshed = MeshedProblem { problem, mesh, topology, toes: &toes };
        let mut program = Program::default();
        let Elements { of: elements, control_points, copies, kinks, slips } = Elements::new(&meshed, still);
        let freedoms = freedoms(&meshed, &elements, control_points, still, &mut program);
        let velocities: Vec<Velocity> = freedoms.iter().map(|m| m.velocity(problem)).collect();
        let mut beams = beams::motions(&meshed, &mut program);
        let stream = StreamFunction::new(
            &meshed,
            &elements,
            copies,
            Depending { kinks, slips },
            &mut beams,
            &mut program,
        );
        let power = Power::default();
        let all = problem.statement().objective == Objective::Everything;
        let mut builder =
            Builder { meshed, elements, velocities, stream, beams, program, power, tighten, all };
        for triangle in 0..mesh.triangles.len() {
            builder.add_triangle(triangle);
            for corner in 0..3 {
                builder.add_edge(Side { triangle, corner });
            }
        }
        let members = builder.add_members();
        let control = (0..mesh.triangles.len()).map(|t| builder.stream_control(t)).collect();
        let live = live_size(problem);
        let force = builder.power.bound(live);
        let Builder { elements, velocities, stream, mut program, power, .. } = builder;
        let mut unit = 1.0;
        if problem.has_factor() {
            program.rows.push(power.normalised(live));
            program.cones.push(Cone::Zero);
            unit = objective_unit(problem, live);
        }
        program.objective.extend(force.terms.iter().map(|(index, c)| (*index, c * unit)));
        let corners: Vec<[Point; 3]> = (0..mesh.triangles.len()).map(|t| meshed.corners(t)).collect();
        let ellipses = (0..corners.len()).map(|t| meshed.soil(t).ellipse).collect();
        let limits = (0..corners.len()).map(|t| Limit::around(meshed.soil(t), &corners[t])).collect();
        Self {
            program,
            elements,
            freedoms,
            velocities,
            stream,
            members,
            control,
            corners,
            live,
            limits,
            ellipses,
            #[cfg(test)]
            force,
        }
    }

    /// Values and slopes of the stream function of a triangle, if it has one: see [`StreamFunction::local`].
    pub(crate) fn stream_values(&self, triangle: usize, x: &[f64]) -> Option<[f64; 12]> {
        match self.elements[triangle] {
            Element::Quadratic(_) | Element::Rest => None,
            Element::Stream(copies) => {
                Some(self.stream.local(triangle, copies).each_ref().map(|f| f.value(x)))
            }
        }
    }

    /// The flow of a solution, as a certificate stores it.
    pub(crate) fn saved(&self, mesh: &Mesh, x: &[f64]) -> UpperField {
        let mut velocities: Vec<Saved> = self
            .freedoms
            .iter()
            .map(|freedom| match *freedom {
                Freedom::Still => Saved::Zero,
                Freedom::Slide { line, index, unit } => Saved::Slide { line, value: unit * x[index] },
                Freedom::Free { x: i, y: j } => Saved::Free { x: x[i], y: x[j] },
            })
            .collect();
        let at_rest = velocities.len();
        if self.elements.contains(&Element::Rest) {
            velocities.push(Saved::Zero);
        }
        let flow = |(triangle, element): (usize, &Element)| match *element {
            Element::Quadratic(nodes) => Flow::Quadratic(nodes),
            Element::Stream(corners) => {
                Flow::Stream { corners, slopes: self.stream.saved_slopes(triangle, x) }
            }
            Element::Rest => Flow::Quadratic([at_rest; 6]),
        };
        let (stream, walls) = self.stream.saved(x);
        let flows = self.elements.iter().enumerate().map(flow).collect();
        let members = self.members.iter().map(|piece| piece.saved(x)).collect();
        UpperField { mesh: mesh.saved(), flows, velocities, stream, walls, members }
    }
}

impl Builder<'_> {
    /// Control points of the velocity along the edges of a triangle with a stream function.
    fn stream_control(&self, triangle: usize) -> Option<[Velocity; 6]> {
        let Element::Stream(copies) = self.elements[triangle] else { return None };
        Some(std::array::from_fn(|i| {
            let jet = &self.stream.jets[copies[i % 3]];
            if i < 3 {
                return [jet[2].clone(), Form::default().plus(-1.0, &jet[1])];
            }
            let side = Side { triangle, corner: i - 3 };
            let [p, q] = self.meshed.ends(side);
            let length = distance(q, p);
            let [tx, ty] = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
            let slide = self.stream_slide(side, copies);
            let (slip, opening) = (&slide.slip[1], &slide.opening[1]);
            [
                Form::default().plus(tx, slip).plus(-ty, opening),
                Form::default().plus(ty, slip).plus(tx, opening),
            ]
        }))
    }
}
