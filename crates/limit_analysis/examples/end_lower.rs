//! A stress field in space about the ends of an upright plate: `end_lower PHI DELTA W [STEPS [SIZE [FILE]]]`, angles in degrees,
//! the width over the depth, steps of adaptation, tetrahedra of the last one, and a file that `end`, an example of the
//! certificate, proves.

use soilctl_limit_analysis::{EndOptions, end_lower};

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let number = |i: usize, default: f64| words.get(i).map_or(Ok(default), |word| word.parse());
    let (phi_deg, delta_deg, width) = (number(0, 30.0)?, number(1, 15.0)?, number(2, 5.0)?);
    let default = EndOptions::default();
    let options = EndOptions {
        steps: number(3, default.steps as f64)? as usize,
        tetrahedra: number(4, default.tetrahedra as f64)? as usize,
        ..default
    };
    // The force is that along x; the coefficient is of what is inclined at delta to it.
    let coefficient = 2.0 / delta_deg.to_radians().cos();
    let lower = end_lower(phi_deg, delta_deg, width, &options, &mut |level| {
        let [whole, between] = [level.value, level.between].map(|force| coefficient * force);
        println!(
            "{} tetrahedra, {} triangles: K = {whole:.4}, between the ends {between:.4}; {:?}, {} iterations, {:.1} s",
            level.tetrahedra, level.triangles, level.status, level.iterations, level.seconds
        );
    })?;
    println!("K = {:.4}", coefficient * lower.value);
    if let Some(path) = words.get(5) {
        let file = serde_json::json!({ "phi_deg": phi_deg, "delta_deg": delta_deg, "stress": lower.field });
        std::fs::write(path, serde_json::to_string(&file)?)?;
    }
    Ok(())
}
