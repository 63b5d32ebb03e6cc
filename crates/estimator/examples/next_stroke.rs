//! Strokes drawn from a soil, what they say about it, and the stroke that would say most.

use soilctl_earth_pressure::{Case, ChenLiu, ForceModel, model};
use soilctl_estimator::{Observation, Setup, StrokeMenu, estimate, next_strokes};
use soilctl_soil::{Angle, Plate, STANDARD_GRAVITY_M_S2};

const WIDTH_M: f64 = 0.127;
const DEPTH_M: f64 = 0.0254;
/// Uncertainty of a force.
const RELATIVE: f64 = 0.05;

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (phi_deg, delta_deg, density_kg_m3) = (38.0, 22.0, 1550.0);
    let table = model("table")?;
    let mut observations = Vec::new();
    for alpha_deg in [75.0_f64, 85.0, 95.0] {
        // The truth comes from another model than the one that estimates.
        let k = ChenLiu.predict(&Case::level_deg(alpha_deg, phi_deg, delta_deg))?.k_net().0;
        let alpha = Angle::from_degrees(alpha_deg);
        let slant_m = DEPTH_M / alpha.sin();
        let force_n = 0.5 * density_kg_m3 * STANDARD_GRAVITY_M_S2 * slant_m * slant_m * WIDTH_M * k;
        let plate = Plate::new(alpha, Angle::ZERO, DEPTH_M, WIDTH_M)?;
        observations.push(Observation::new(format!("{alpha_deg} deg"), plate, force_n, RELATIVE * force_n)?);
    }
    let setup = Setup::new(&*table, observations, (21.0, 23.0));
    let found = estimate(&setup)?;
    let ([phi_low, phi_high], [low, high]) =
        found.phi_deg.zip(found.density_kg_m3).ok_or("no soil explains these forces")?;
    println!("truth: {phi_deg} deg, {density_kg_m3} kg/m3");
    println!("found: {phi_low:.1} to {phi_high:.1} deg, {low:.0} to {high:.0} kg/m3");
    let menu = StrokeMenu {
        tool_angles_deg: vec![50.0, 70.0, 90.0, 110.0],
        depths_m: vec![DEPTH_M],
        widths_m: vec![WIDTH_M],
        force_scatter: RELATIVE,
        depth_error_m: 0.0,
        force_limit_n: Some(100.0),
    };
    let next = next_strokes(&setup, &found, &menu, &ChenLiu)?;
    let best = next.first().ok_or("no candidate")?;
    println!("next:  {} deg would leave {:.0} % of the region", best.alpha_deg, 100.0 * best.area_left);
    Ok(())
}
