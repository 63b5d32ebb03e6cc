//! Bounds on the force of an embedded plate: `plate ALPHA PHI DELTA [SECONDS]`, angles in degrees.

use soilctl_limit_analysis::{EmbeddedPlate, LimitError, Options, bound};

#[allow(clippy::print_stdout, reason = "an example")]
fn main() -> Result<(), LimitError> {
    let numbers: Vec<f64> = std::env::args().skip(1).filter_map(|a| a.parse().ok()).collect();
    let at = |i: usize, default: f64| numbers.get(i).copied().unwrap_or(default);
    let plate = EmbeddedPlate {
        alpha_deg: at(0, 90.0),
        phi_deg: at(1, 30.0),
        delta_deg: at(2, 15.0),
        ..EmbeddedPlate::default()
    };
    let options = Options { max_seconds: Some(at(3, 10.0)), max_gap: 1e-4, ..Options::default() };
    let bounds = bound(&plate.problem()?, &options, &mut |level, gap| {
        println!("{level:?} gap {:.3} %", 100.0 * gap.unwrap_or(f64::NAN));
    })?;
    let slant = 2.0 / (plate.alpha_deg + plate.delta_deg).to_radians().sin();
    println!(
        "K between {:.4} and {:.4}, gap {:.2} %, {:.1} s, {:?}",
        slant * bounds.lower.value,
        slant * bounds.upper.value,
        100.0 * bounds.gap(),
        bounds.seconds,
        bounds.ended
    );
    Ok(())
}
