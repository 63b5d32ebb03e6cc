//! Net coefficients of all models over the tool angle, in one soil.

use soilctl_earth_pressure::{Case, MODEL_IDS, model};

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (phi_deg, delta_deg) = (38.0, 20.0);
    let angles_deg = [70.0, 80.0, 90.0, 100.0];
    println!("passive minus active, by slant length; phi {phi_deg} deg, delta {delta_deg} deg");
    for id in MODEL_IDS {
        let model = model(id)?;
        print!("{id:<18}");
        for alpha_deg in angles_deg {
            match model.predict(&Case::level_deg(alpha_deg, phi_deg, delta_deg)) {
                Ok(prediction) => print!("{:>9.3}", prediction.k_net().0),
                Err(_) => print!("{:>9}", "-"),
            }
        }
        println!();
    }
    Ok(())
}
