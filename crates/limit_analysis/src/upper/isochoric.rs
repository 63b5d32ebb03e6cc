//! Dissipation of soil without friction, whose velocity is that of a stream function.

use soilctl_conic::Form;

use super::Builder;
use super::strength::over_triangle;
use crate::anisotropy::Ellipse;
use crate::lower::macro_element::{Curvature, curvatures};
use crate::vector::{centroid, twice_area};

/// `exx - eyy` and `2 exy` from the second derivatives of the stream function.
pub(crate) fn shear_rates(c: &Curvature) -> [[f64; 12]; 2] {
    let [xx, yy, xy] = c;
    [std::array::from_fn(|i| 2.0 * xy[i]), std::array::from_fn(|i| yy[i] - xx[i])]
}

impl Builder<'_> {
    /// The shear rate `g` is convex and the cohesion not negative, so the linear function through the values of `g` at the
    /// nodes of each part, times the cohesion, is an upper bound on the dissipation. All parts have the same strain rate
    /// at the centroid.
    pub(super) fn add_stream(&mut self, triangle: usize, copies: [usize; 3]) {
        let v = self.meshed.corners(triangle);
        let soil = self.meshed.soil(triangle);
        let centre = centroid(&v);
        let area = 0.5 * twice_area(v);
        let h = (2.0 * area).sqrt();
        let local = self.stream.local(triangle, copies);
        let curvature = curvatures(&v, [false; 3]);
        let cohesion = |p: [f64; 2]| soil.cohesion.at(p).max(0.0);
        let mut at_centre = 0.0;
        for (k, part) in curvature.iter().enumerate() {
            let [a, b, c] = over_triangle([v[(k + 1) % 3], v[(k + 2) % 3], centre].map(cohesion));
            let share = area / 9.0 / h;
            self.add_rate(&soil.ellipse, &part[0], &local, h, a * share);
            self.add_rate(&soil.ellipse, &part[1], &local, h, b * share);
            at_centre += c * share;
        }
        self.add_rate(&soil.ellipse, &curvature[0][2], &local, h, at_centre);

        // With Gauss the integral of the velocity is the sum, over the edges, of the function's mean times the edge vector,
        // with the sign changed; the mean of a cubic follows from values and slopes at the ends.
        let mut flow = [Form::default(), Form::default()];
        for k in 0..3 {
            let (a, b) = ((k + 1) % 3, (k + 2) % 3);
            let d = [v[b][0] - v[a][0], v[b][1] - v[a][1]];
            let mut mean = Form::default();
            for (corner, sign) in [(a, 1.0), (b, -1.0)] {
                mean.add(0.5, &local[3 * corner]);
                mean.add(sign * d[0] / 12.0, &local[3 * corner + 1]);
                mean.add(sign * d[1] / 12.0, &local[3 * corner + 2]);
            }
            flow[0].add(-d[0], &mean);
            flow[1].add(-d[1], &mean);
        }
        self.add_body(triangle, [1.0; 2], &flow);
    }

    /// A shear rate times `h`, with its cost.
    fn add_rate(&mut self, of: &Ellipse, curvature: &Curvature, local: &[Form; 12], h: f64, cost: f64) {
        let [difference, shear] = shear_rates(curvature).map(|row| {
            let mut form = Form::default();
            row.iter().zip(local).for_each(|(r, l)| form.add(h * r, l));
            form
        });
        if cost > 0.0 && !(difference.terms.is_empty() && shear.terms.is_empty()) {
            let rate = Form::unknown(self.program.unknown(), 1.0);
            self.power.dissipate(cost, &rate);
            let round = [(of.level, &difference), (of.shear, &shear)];
            let [level, across] = round.map(|(times, form)| Form::default().plus(times, form));
            self.program.second_order([rate.plus(-of.middle, &difference), level, across]);
        }
    }
}
