use soilctl_certificate::FlowPiece;

use super::finder::centroid;
use super::flow::{FlowResults, strain_rates};
use super::strength::Strength;
use super::stress::StressResults;

/// Power of shearing per area in the middle of each piece of each triangle of a flow (stress over time): the greatest shear
/// stress that the soil bears at the mean effective stress of the lower bound's stress field, `c cos(phi) - p sin(phi)`,
/// times the greatest shear strain rate of the upper bound's flow.
///
/// This shows where soil without cohesion fails, which on the whole dissipates nothing: what shearing costs, dilation
/// against the pressure takes back. Zero where the stress field has no soil.
#[must_use]
pub fn shear_work(flow: &FlowResults, stress: &StressResults) -> Vec<Vec<f64>> {
    let mut found = 0;
    let mut of = |triangle: usize, piece: &FlowPiece| {
        let [a, b, c] = strain_rates(piece);
        let rate = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
        let p = centroid(&piece.corners);
        let Some((near, [xx, yy, _])) = stress.stress_from(p, found) else { return 0.0 };
        found = near;
        let material = flow.material(triangle);
        let mean = 0.5 * (xx + yy) + material.pore_pressure.at(p);
        let strength = Strength::of_soil(material);
        strength.shear(mean, p) * strength.shear_rate(rate)
    };
    let all = flow.pieces().iter().enumerate();
    all.map(|(t, pieces)| pieces.iter().map(|piece| of(t, piece)).collect()).collect()
}
