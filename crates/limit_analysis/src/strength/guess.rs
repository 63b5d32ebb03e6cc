//! Where the search for the factor of safety begins: slopes that slide on a plane through their foot (Culmann 1866), without cohesion
//! on one along the slope, under weight and water.

use soilctl_certificate::Condition;

use super::search::Guess;
use crate::problem::Problem;
use crate::vector::{between, cross, dot};

/// Pressure where slopes slide, as a part of the weight of soil as high as they are.
const TYPICAL: f64 = 0.2;

/// The least factor of all free and submerged slopes, as if nothing acted but weight and, where there is no cohesion, water; none without
/// slopes and weight.
pub(super) fn guess(problem: &Problem) -> Option<Guess> {
    let statement = problem.statement();
    let gravity = statement.gravity[0].hypot(statement.gravity[1]);
    let is_free = |c: Condition| matches!(c, Condition::Free | Condition::Submerged);
    let free = statement.boundaries.iter().filter(|b| is_free(b.condition));
    let factors = free.filter_map(|b| {
        let [p, q] = problem.ends(b.line);
        let soil = &problem.soils[problem.owner(b.side())?];
        let down = if soil.cohesion.is_zero() {
            soil.effective_weight(statement.gravity)
        } else {
            statement.gravity
        };
        // Against what is level across gravity, which an earthquake tilts, and seepage.
        let along = between(p, q);
        let beta = dot(along, down).abs().atan2(cross(along, down).abs());
        if soil.cohesion.is_zero() && soil.envelope.is_none() {
            return (beta > 0.0 && soil.tan > 0.0).then(|| Guess::Good(soil.tan / beta.tan()));
        }
        let middle = [0, 1].map(|i| 0.5 * (p[i] + q[i]));
        let weight = soil.unit_weight * gravity * (q[1] - p[1]).abs();
        let [tan, cohesion] = soil.strength_at(TYPICAL * weight, middle);
        let strength = cohesion / weight;
        (beta > 0.0 && strength.is_finite() && strength > 0.0)
            .then(|| Guess::Rough(plane(beta, tan, strength)))
    });
    factors.min_by(|a, b| a.factor().total_cmp(&b.factor()))
}

/// The factor by which a slope at `beta` stands, from the tangent of its friction and its cohesion over weight and height: that at which
/// `4 c sin(beta) cos(phi) / (1 - cos(beta - phi))` is the height.
fn plane(beta: f64, tan: f64, strength: f64) -> f64 {
    let stands = |factor: f64| {
        let phi = (tan / factor).atan();
        let rest = 1.0 - (beta - phi).cos();
        phi >= beta || 4.0 * strength / factor * beta.sin() * phi.cos() > rest
    };
    let (mut low, mut high) = (1e-3, 1e3);
    for _ in 0..60 {
        let middle = f64::sqrt(low * high);
        if stands(middle) { low = middle } else { high = middle }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_of_a_vertical_cut_is_rankine_s() {
        // Without friction it stands to the height `4 c`.
        assert!((plane(std::f64::consts::FRAC_PI_2, 0.0, 0.5) - 2.0).abs() < 1e-9);
    }

    #[test]
    fn little_cohesion_leaves_the_ratio_of_tangents() {
        let beta = 0.5_f64;
        assert!((plane(beta, 0.8, 1e-9) - 0.8 / beta.tan()).abs() < 1e-3);
    }
}
