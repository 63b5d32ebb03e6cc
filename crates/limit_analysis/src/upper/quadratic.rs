//! Quadratic flows of soil that dilates: the flow rule at the corners, which makes it hold everywhere, and the power.

use soilctl_conic::Form;

use super::nodes::Element;
use super::strength::{Limit, over_triangle};
use super::{Builder, Velocity};
use crate::vector::{Point, twice_area};

/// Gradients at corner `k` of the Bernstein polynomials that belong to the control points.
pub(crate) fn gradients(v: &[[f64; 2]; 3], k: usize) -> [[f64; 2]; 6] {
    let double = twice_area(*v);
    let g: [[f64; 2]; 3] = std::array::from_fn(|i| {
        let (a, b) = (v[(i + 1) % 3], v[(i + 2) % 3]);
        [(a[1] - b[1]) / double, (b[0] - a[0]) / double]
    });
    let mut rows = [[0.0; 2]; 6];
    for axis in 0..2 {
        rows[k][axis] = 2.0 * g[k][axis];
        for i in (0..3).filter(|i| *i != k) {
            // The edge between corners k and i lies opposite to the third.
            rows[3 + (3 - k - i)][axis] = 2.0 * g[i][axis];
        }
    }
    rows
}

impl Builder<'_> {
    pub(super) fn add_quadratic(&mut self, triangle: usize, nodes: [usize; 6]) {
        let v = self.meshed.corners(triangle);
        let soil = self.meshed.soil(triangle);
        let area = 0.5 * twice_area(v);
        let h = (2.0 * area).sqrt();
        let limit = Limit::around(soil, &v);
        let tension = over_triangle(v.map(|p| limit.tension(soil, p)));
        let radius = over_triangle(v.map(|p| limit.radius(soil, p)));
        let water = over_triangle(v.map(|p| soil.pore_pressure.at(p)));
        for k in 0..3 {
            let g = gradients(&v, k);
            let [mut volume, mut difference, mut shear] = [Form::default(), Form::default(), Form::default()];
            for (node, [gx, gy]) in g.iter().enumerate() {
                let [vx, vy] = &self.velocities[nodes[node]];
                volume.add(h * gx, vx);
                volume.add(h * gy, vy);
                difference.add(h * gx, vx);
                difference.add(-h * gy, vy);
                shear.add(h * gy, vx);
                shear.add(h * gx, vy);
            }
            if volume.terms.is_empty() {
                continue;
            }
            self.power.dissipate(tension[k] * area / 3.0 / h, &volume);
            self.power.load(water[k] * area / 3.0 / h, &volume, self.all);
            if let Limit::Envelope(circles) = &limit {
                self.add_envelope(circles, soil.flow_sin(), [volume, difference, shear], area / 3.0 / h);
                continue;
            }
            if matches!(limit, Limit::Tension(_)) {
                let beyond = Form::unknown(self.program.unknown(), 1.0);
                self.power.dissipate(radius[k] * area / 3.0 / h, &beyond);
                self.program.non_negative(beyond.clone());
                let most = beyond.plus(1.0, &volume);
                self.program.second_order([most, difference.clone(), shear.clone()]);
            }
            let margin = Form::constant(-self.tighten);
            if soil.has_friction() {
                let bounded = margin.plus(1.0 / soil.sin, &volume);
                self.program.second_order([bounded, difference, shear]);
            } else {
                self.program.non_negative(margin.plus(1.0, &volume));
            }
        }
        let integral = |axis: usize| {
            let mut sum = Form::default();
            nodes.iter().for_each(|n| sum.add(1.0, &self.velocities[*n][axis]));
            sum
        };
        let flow = [integral(0), integral(1)];
        self.add_body(triangle, [area, 6.0], &flow);
    }

    /// What soil with an envelope dissipates at `cost` for one unit, and its flow rule.
    pub(super) fn add_envelope(
        &mut self,
        circles: &[Point],
        flow_sin: f64,
        [volume, difference, shear]: [Form; 3],
        cost: f64,
    ) {
        let shearing = Form::unknown(self.program.unknown(), 1.0);
        self.program.second_order([shearing.clone(), difference, shear]);
        self.program
            .non_negative(Form::constant(-self.tighten).plus(1.0, &volume).plus(-flow_sin, &shearing));
        self.add_greatest(circles, &volume, &shearing, cost);
    }

    /// The greatest power of some stresses, for opening or dilation and the second kind of rate, at `cost` for one unit. Pressure does the
    /// less work the more it opens, so an unknown that is not above the opening does for it, which keeps rows short.
    pub(super) fn add_greatest(&mut self, stresses: &[Point], opening: &Form, rate: &Form, cost: f64) {
        let [power, least] = [0; 2].map(|_| Form::unknown(self.program.unknown(), 1.0));
        self.power.dissipate(cost, &power);
        self.program.non_negative(opening.clone().plus(-1.0, &least));
        for [mean, radius] in stresses {
            let opening = if *mean > 0.0 { opening } else { &least };
            self.program.non_negative(power.clone().plus(-mean, opening).plus(-radius, rate));
        }
    }

    /// Velocities of the control points on an edge, in the triangle's sense.
    pub(super) fn on_edge(&self, nodes: [usize; 6], corner: usize) -> [Velocity; 3] {
        [(corner + 1) % 3, 3 + corner, (corner + 2) % 3].map(|node| self.velocities[nodes[node]].clone())
    }

    /// Power of body forces on a triangle. The integral of the velocity is `times` the flow over `by`.
    pub(super) fn add_body(&mut self, triangle: usize, [times, by]: [f64; 2], flow: &Velocity) {
        let weight = self.meshed.soil(triangle).unit_weight;
        let statement = self.meshed.problem.statement();
        let live = match statement.objective {
            soilctl_certificate::Objective::Body { gravity } => Some(gravity),
            _ => None,
        };
        let dead = Some(statement.gravity);
        for (gravity, is_live) in [(dead, self.all), (live, true)] {
            for axis in 0..2 {
                let force = gravity.map_or(0.0, |g| g[axis]) * weight * times / by;
                self.power.load(force, &flow[axis], is_live);
            }
        }
    }

    pub(super) fn add_triangle(&mut self, triangle: usize) {
        match self.elements[triangle] {
            Element::Quadratic(nodes) => self.add_quadratic(triangle, nodes),
            Element::Stream(copies) => self.add_stream(triangle, copies),
            Element::Rest => {}
        }
    }
}
