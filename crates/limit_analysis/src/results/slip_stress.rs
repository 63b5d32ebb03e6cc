//! The normal stress where soil slips.

use super::Point;
use super::finder::centroid;
use super::flow::{FlowResults, area};
use super::jumps::Jump;
use super::strength::Strength;
use super::stress::StressResults;

/// The effective normal stress on slip surfaces of a mechanism, compression positive, in the stress of the statement.
///
/// A small change of friction, different from place to place, changes the limit load by the work that it does: by the normal stress times the rate of
/// slip, summed over all slip surfaces. So friction that follows a law in the logarithm of stress acts, to first order, like that at the
/// equivalent stress below.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipStress {
    /// Mean, weighted by the rate of slip.
    pub mean: f64,
    /// The equivalent stress `exp(mean of ln(sigma))`, weighted by sigma times the rate of slip. By Jensen's inequality it lies between the
    /// two others.
    pub equivalent: f64,
    /// Mean, weighted by sigma times the rate of slip.
    pub heavy: f64,
}

#[derive(Default)]
struct Sums {
    rate: f64,
    work: f64,
    log: f64,
    square: f64,
}

impl Sums {
    fn add(&mut self, rate: f64, stress: f64) {
        if rate > 0.0 && stress > 0.0 {
            self.rate += rate;
            self.work += rate * stress;
            self.log += rate * stress * stress.ln();
            self.square += rate * stress * stress;
        }
    }
}

/// The normal stress where soil slips: rates of the upper bound's flow, stresses of the lower bound's field, in the soil at which a choice is true.
/// `None` if none of it slips under compression.
#[must_use]
pub fn slip_stress(
    flow: &FlowResults,
    stress: &StressResults,
    is_chosen: impl Fn(Point) -> bool,
) -> Option<SlipStress> {
    let mut sums = Sums::default();
    let mut near = 0;
    let mut at = |triangle: usize, p: Point| {
        if !is_chosen(p) {
            return 0.0;
        }
        let Some((found, [xx, yy, _])) = stress.stress_from(p, near) else { return 0.0 };
        near = found;
        let material = flow.material(triangle);
        let mean = 0.5 * (xx + yy) + material.pore_pressure.at(p);
        Strength::of_soil(material).on_slip_surface(mean, p)
    };
    let rates = flow.shear_rate();
    for (triangle, pieces) in flow.pieces().iter().enumerate() {
        for (piece, rate) in pieces.iter().zip(&rates[triangle]) {
            sums.add(rate * area(piece), at(triangle, centroid(&piece.corners)));
        }
    }
    for jump in flow.jumps().iter().filter(|jump| !jump.at_structure) {
        let Jump { ends: [a, b], triangle, slip, .. } = jump;
        let rate = slip.iter().sum::<f64>().abs() / 3.0;
        sums.add(rate * jump.length(), at(*triangle, [0, 1].map(|i| f64::midpoint(a[i], b[i]))));
    }
    (sums.work > 0.0).then(|| SlipStress {
        mean: sums.work / sums.rate,
        equivalent: (sums.log / sums.work).exp(),
        heavy: sums.square / sums.work,
    })
}
