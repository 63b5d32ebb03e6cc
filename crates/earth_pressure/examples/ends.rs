//! Plates of several widths by the models that know ends: `cargo run -p soilctl-earth-pressure --example ends`.

use soilctl_earth_pressure::{Case, model};
use soilctl_soil::WidthRatio;

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ids = ["mckyes", "perumpral", "godwin-spoor", "ovesen", "blocks-3d"];
    println!("{:>12} {:>5} {}", "phi, delta", "w/H", ids.map(|id| format!("{id:>13}")).join(""));
    for (phi, delta) in [(30.0, 15.0), (40.0, 25.0)] {
        for ratio in [f64::INFINITY, 10.0, 5.0, 3.0, 2.0, 1.0] {
            let case = Case::level_deg(90.0, phi, delta).with_width_ratio(WidthRatio::new(ratio)?);
            let mut line = format!("{:>12} {ratio:>5}", format!("{phi}, {delta}"));
            for id in ids {
                line += &format!("{:>13.3}", model(id)?.predict(&case)?.k_net().0);
            }
            println!("{line}");
        }
    }
    Ok(())
}
