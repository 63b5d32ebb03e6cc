//! What happens at the edges of triangles: jumps, faces and loads.

use soilctl_certificate::{Condition, Objective, Place, Side};
use soilctl_conic::Form;

use super::Builder;
use super::edge_velocity::EdgeVelocity;
use super::meshed::Edge;
use super::nodes::Element;
use super::strength::{Limit, over_edge};
use crate::vector::Point;

type Ends = [f64; 2];

/// What a layer between two bodies bears, at both ends of an edge.
struct Layer<'a> {
    /// Opening over slip that it demands.
    tan: f64,
    /// Cost of opening.
    tension: Ends,
    /// Pressure of the water that opens it.
    water: Ends,
    /// Cost of what slip and opening together are more than the opening.
    radius: Option<Ends>,
    /// The circles of an envelope, of which one gives the greatest power.
    circles: Option<&'a [Point]>,
}

impl Builder<'_> {
    pub(super) fn add_edge(&mut self, side: Side) {
        match self.meshed.edge(side) {
            // Members are looked at from end to end.
            Edge::Glued | Edge::Member { .. } => {}
            Edge::Slip { other } if other.triangle < side.triangle => {}
            Edge::Slip { other } => self.add_slip(side, other),
            Edge::Jump { other, .. } if other.triangle < side.triangle => {}
            Edge::Jump { other, region } => self.add_jump(side, other, region),
            Edge::Boundary(Condition::Face { delta_deg, adhesion }) => {
                self.add_face(side, delta_deg, adhesion)
            }
            Edge::Boundary(Condition::Free) => {
                self.add_load(side, [self.meshed.problem.statement().surcharge; 2], [0.0; 2], self.all)
            }
            Edge::Boundary(Condition::Loaded { pressure, shear, live }) => {
                let live =
                    self.all || (live && self.meshed.problem.statement().objective == Objective::Loads);
                let [pressure, shear] = [pressure, shear].map(|at_ends| self.between(side, at_ends));
                self.add_load(side, pressure, shear, live);
            }
            Edge::Boundary(Condition::Submerged) => {
                let problem = self.meshed.problem;
                let line = self.meshed.topology.line[side.triangle][side.corner];
                let water = line.map_or([0.0; 2], |used| problem.statement().pore_pressure(used));
                let pressure = self.between(side, water);
                self.add_load(side, pressure, [0.0; 2], self.all);
            }
            // What lines the soil is added with the members.
            Edge::Boundary(
                Condition::Fixed | Condition::Smooth | Condition::Far | Condition::Lined { .. },
            ) => {}
        }
    }

    fn vector(&self, side: Side) -> ([f64; 2], f64) {
        let [p, q] = self.meshed.ends(side);
        let d = [q[0] - p[0], q[1] - p[1]];
        (d, d[0].hypot(d[1]))
    }

    /// Velocity of a triangle along its edge.
    pub(super) fn slide(&self, side: Side) -> EdgeVelocity {
        let (d, length) = self.vector(side);
        match self.elements[side.triangle] {
            Element::Quadratic(nodes) => {
                EdgeVelocity::new(d.map(|x| x / length), &self.on_edge(nodes, side.corner))
            }
            Element::Stream(copies) => self.stream_slide(side, copies),
            Element::Rest => EdgeVelocity::default(),
        }
    }

    pub(super) fn stream_slide(&self, side: Side, copies: [usize; 3]) -> EdgeVelocity {
        let ends = [1, 2].map(|i| &self.stream.jets[copies[(side.corner + i) % 3]]);
        EdgeVelocity::of_stream(self.vector(side).0, ends, &self.stream.slopes[side.triangle][side.corner])
    }

    fn add_jump(&mut self, side: Side, other: Side, region: usize) {
        let (d, length) = self.vector(side);
        let jump = match [side, other].map(|s| self.elements[s.triangle]) {
            [Element::Quadratic(here), Element::Quadratic(there)] => {
                let mut jump = self.on_edge(here, side.corner);
                let [end, middle, start] = self.on_edge(there, other.corner);
                for (v, minus) in jump.iter_mut().zip([start, middle, end]) {
                    v.iter_mut().zip(&minus).for_each(|(v, m)| v.add(-1.0, m));
                }
                EdgeVelocity::new(d.map(|x| x / length), &jump)
            }
            _ => self.slide(side).less(&self.slide(other).reversed()),
        };
        let soil = &self.meshed.problem.soils[region];
        let ends = self.meshed.ends(side);
        let limit = Limit::around(soil, &ends);
        let radius = matches!(limit, Limit::Tension(_)).then(|| ends.map(|p| limit.radius(soil, p)));
        let water = ends.map(|p| soil.pore_pressure.at(p));
        let tension = ends.map(|p| limit.tension(soil, p));
        let circles = soil.envelope.as_ref().map(|envelope| &*envelope.circles);
        let layer = Layer { tan: soil.flow_tan(), tension, water, radius, circles };
        self.add_layer(&layer, &jump, length);
    }

    /// Slip along an edge in soil without friction, which opens nowhere.
    fn add_slip(&mut self, side: Side, other: Side) {
        let (d, length) = self.vector(side);
        let jump = self.slide(side).less(&self.slide(other).reversed());
        let soil = self.meshed.soil(side.triangle);
        let cohesion = over_edge(self.meshed.ends(side).map(|p| soil.cohesion.at(p).max(0.0)));
        for (slip, cohesion) in jump.slip.iter().zip(cohesion) {
            let cost = cohesion * length / 3.0;
            if cost > 0.0 && !slip.terms.is_empty() {
                let most = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(cost, &most);
                let [forwards, backwards] = [1.0, -1.0].map(|slip| soil.ellipse.along(d, slip));
                self.program.non_negative(most.clone().plus(-forwards, slip));
                self.program.non_negative(most.plus(backwards, slip));
            }
        }
    }

    fn add_face(&mut self, side: Side, delta_deg: f64, adhesion: f64) {
        let (d, length) = self.vector(side);
        let t = d.map(|x| x / length);
        let rigid = || self.meshed.problem.velocity().map(Form::constant);
        let rigid = [rigid(), rigid(), rigid()];
        let tan = delta_deg.to_radians().tan();
        let tension = if tan > 0.0 { adhesion / tan } else { 0.0 };
        let relative = match self.elements[side.triangle] {
            Element::Quadratic(nodes) => {
                let mut relative = self.on_edge(nodes, side.corner);
                for (v, minus) in relative.iter_mut().zip(&rigid) {
                    v.iter_mut().zip(minus).for_each(|(v, m)| v.add(-1.0, m));
                }
                EdgeVelocity::new(t, &relative)
            }
            Element::Stream(_) | Element::Rest => self.slide(side).less(&EdgeVelocity::new(t, &rigid)),
        };
        if self.meshed.is_isochoric(side.triangle) && tan == 0.0 && adhesion > 0.0 {
            return self.add_adhesion(&relative, adhesion * length / 3.0);
        }
        let water = self.meshed.ends(side).map(|p| self.meshed.soil(side.triangle).pore_pressure.at(p));
        let layer = Layer { tan, tension: [tension; 2], water, radius: None, circles: None };
        self.add_layer(&layer, &relative, length);
    }

    /// Slip along a wall.
    fn add_adhesion(&mut self, relative: &EdgeVelocity, cost: f64) {
        for slip in &relative.slip {
            if slip.terms.is_empty() {
                self.power.dissipate(cost, &Form::constant(slip.constant.abs()));
                continue;
            }
            let most = Form::unknown(self.program.unknown(), 1.0);
            self.power.dissipate(cost, &most);
            self.program.non_negative(most.clone().plus(1.0, slip));
            self.program.non_negative(most.plus(-1.0, slip));
        }
    }

    /// Where the coefficients of a quadratic keep a sign, it does.
    fn add_layer(&mut self, layer: &Layer, slide: &EdgeVelocity, length: f64) {
        let (tension, water) = (over_edge(layer.tension), over_edge(layer.water));
        for (i, n) in slide.opening.iter().enumerate() {
            self.power.dissipate(tension[i] * length / 3.0, n);
            self.power.load(water[i] * length / 3.0, n, self.all);
        }
        let radius = layer.radius.map(over_edge);
        for (i, (n, s)) in slide.opening.iter().zip(&slide.slip).enumerate() {
            if n.terms.is_empty() && s.terms.is_empty() && n.constant == 0.0 {
                continue;
            }
            if let Some(radius) = radius {
                let beyond = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(radius[i] * length / 3.0, &beyond);
                self.program.non_negative(beyond.clone());
                self.program.second_order([beyond.plus(1.0, n), n.clone(), s.clone()]);
            }
            if let Some(circles) = layer.circles {
                let sliding = Form::unknown(self.program.unknown(), 1.0);
                self.program.second_order([sliding.clone(), n.clone(), s.clone()]);
                self.add_greatest(circles, n, &sliding, length / 3.0);
            }
            let open = Form::constant(-self.tighten).plus(1.0, n);
            if layer.tan == 0.0 {
                self.program.non_negative(open);
            } else {
                self.program.non_negative(open.clone().plus(layer.tan, s));
                self.program.non_negative(open.plus(-layer.tan, s));
            }
        }
    }

    /// Values at the ends of an edge of what is linear along its line, from the values at the line's ends.
    fn between(&self, side: Side, [from, to]: Ends) -> Ends {
        let Some(used) = self.meshed.topology.line[side.triangle][side.corner] else { return [from, to] };
        let corners = self.meshed.mesh.triangles[side.triangle].corners;
        [1, 2].map(|i| match self.meshed.mesh.vertices[corners[(side.corner + i) % 3]].place {
            Place::OnLine { s, .. } => from + s * (to - from),
            Place::Corner { point } if self.meshed.problem.statement().lines[used.line].from == point => from,
            Place::Corner { .. } | Place::Inside => to,
        })
    }

    /// Pressure acts on the soil along the normal that points into it.
    fn add_load(&mut self, side: Side, pressure: Ends, shear: Ends, live: bool) {
        if pressure == [0.0; 2] && shear == [0.0; 2] {
            return;
        }
        self.add_load_on(side, &self.slide(side), [pressure, shear], live);
    }

    /// Loads on a beam that lines the soil.
    pub(super) fn add_load_on_beam(
        &mut self,
        side: Side,
        velocity: &EdgeVelocity,
        [pressure, shear]: [Ends; 2],
        live: bool,
    ) {
        let live = self.all || (live && self.meshed.problem.statement().objective == Objective::Loads);
        let loads = [pressure, shear].map(|load| self.between(side, load));
        self.add_load_on(side, velocity, loads, live);
    }

    /// The same, of what moves like this along the edge.
    fn add_load_on(&mut self, side: Side, slide: &EdgeVelocity, [pressure, shear]: [Ends; 2], live: bool) {
        let length = self.vector(side).1;
        for (load, velocity) in [(pressure, &slide.opening), (shear, &slide.slip)] {
            for (weight, v) in over_edge(load).iter().zip(velocity) {
                self.power.load(weight * length / 3.0, v, live);
            }
        }
    }
}
