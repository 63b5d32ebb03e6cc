//! What a plane stress field must obey besides yield, so that its bound holds for a structure of any width: the certificate's
//! `splice` has the argument.

use soilctl_conic::Form;

use super::Stress;
use crate::problem::Problem;
use crate::vector::Point;

/// Pressures of the ground at rest, and by how much those between the ends may differ from them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Splice {
    surcharge: f64,
    /// Change of the greatest and the least pressure with depth.
    change: [f64; 2],
    datum: f64,
    /// `K^2` and `c cot(phi)`.
    ratio: f64,
    apex: f64,
}

impl Splice {
    /// For the one soil of a problem.
    pub(crate) fn new(problem: &Problem) -> Self {
        let (statement, soil) = (problem.statement(), &problem.soils[0]);
        let [gx, gy] = statement.gravity.map(|g| soil.unit_weight * g);
        let t = if gx == 0.0 { 0.0 } else { gx / gy };
        let mean = -gy * (1.0 + t * t);
        let radius = (gx * gx + (t * t * gy).powi(2)).sqrt();
        Self {
            surcharge: statement.surcharge,
            change: [mean + radius, mean - radius],
            datum: statement.datum,
            ratio: ((1.0 + soil.sin) / (1.0 - soil.sin)).powi(2),
            apex: if soil.cohesion.is_zero() { 0.0 } else { soil.tension([0.0; 2]) },
        }
    }

    /// The two cones at a point, scaled.
    pub(super) fn cones(&self, [xx, yy, xy]: &Stress, at: Point, scale: f64) -> [[Form; 3]; 2] {
        let depth = self.datum - at[1];
        let [greatest, least] = self.change.map(|change| self.surcharge + change * depth + self.apex);
        let limits = [(self.ratio * least - self.apex, 0.5), (self.apex - greatest / self.ratio, -0.5)];
        limits.map(|(constant, of_mean)| {
            [
                Form::constant(scale * constant).plus(scale * of_mean, xx).plus(scale * of_mean, yy),
                Form::default().plus(0.5 * scale, xx).plus(-0.5 * scale, yy),
                Form::default().plus(scale, xy),
            ]
        })
    }
}
