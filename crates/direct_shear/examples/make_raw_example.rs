//! Writes the synthetic shear-box records of `data/direct_shear_raw`: `runs.csv` and `loop.csv`.
//!
//! The records of the thesis's tests are lost; these have the same loads, box and procedure, and a known truth.
//! They are the same on every run. Give another folder as the only argument to write there.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Friction at and above the floor stress, degrees.
pub(crate) const FLOOR_DEG: f64 = 32.0;
/// Fall of the friction angle for each decade of stress below the floor stress, degrees.
pub(crate) const SLOPE_DEG_PER_DECADE: f64 = 6.0;
/// Normal stress at which the floor begins, Pa (5 psi).
pub(crate) const FLOOR_STRESS_PA: f64 = 34_474.0;
/// Displacement at which every run peaks, mm.
pub(crate) const PEAK_MM: f64 = 2.0;
/// Dilation angle at the peak, as a fraction of the friction above a sliding friction of 28 degrees.
pub(crate) const DILATION_FRACTION: f64 = 0.8;
/// Friction without dilation, degrees.
pub(crate) const SLIDING_DEG: f64 = 28.0;
/// Reading of the unloaded load cell, N.
pub(crate) const BIAS_N: f64 = 0.85;
/// Machine friction, N: half the height of the friction loop.
pub(crate) const MACHINE_FRICTION_N: f64 = 0.10;
/// The seven loads of the thesis, kg; the first four are tested four times, the others once.
pub(crate) const LOADS_KG: [f64; 7] = [0.4473, 0.921, 2.921, 5.891, 17.545, 27.545, 47.545];
/// Departure of the four repeated runs from the truth, degrees; the last one is the odd one out.
pub(crate) const RUN_OFFSETS_DEG: [f64; 4] = [-0.3, 0.1, 0.2, 1.7];

const AREA_M2: f64 = 35.6e-4;
const GRAVITY_M_S2: f64 = 9.806_65;
const STEP_MM: f64 = 0.1;
const SAMPLES: u32 = 51;
/// Standard deviations of the noise of force, N, and dial gauge, mm.
const FORCE_NOISE_N: f64 = 0.012;
const DIAL_NOISE_MM: f64 = 0.002;

/// The true peak friction angle in degrees under a load in kg.
pub(crate) fn true_friction_deg(load_kg: f64) -> f64 {
    let stress_pa = load_kg * GRAVITY_M_S2 / AREA_M2;
    FLOOR_DEG + SLOPE_DEG_PER_DECADE * (FLOOR_STRESS_PA / stress_pa).log10().max(0.0)
}

/// The true dilation angle at the peak in degrees for a peak friction angle.
pub(crate) fn true_dilation_deg(friction_deg: f64) -> f64 {
    DILATION_FRACTION * (friction_deg - SLIDING_DEG)
}

/// The text of `runs.csv`.
pub(crate) fn runs_csv() -> String {
    let mut noise = Noise(2001);
    let mut text = "run_id,load_kg,displacement_mm,shear_force_n,vertical_mm\n".to_owned();
    for load_kg in LOADS_KG {
        let low = load_kg < 10.0;
        for (number, offset) in RUN_OFFSETS_DEG.iter().enumerate().take(if low { 4 } else { 1 }) {
            let friction_deg = true_friction_deg(load_kg) + if low { *offset } else { 0.0 };
            let letter = ["a", "b", "c", "d"][number];
            one_run(&mut text, &format!("{load_kg}kg-{letter}"), load_kg, friction_deg, &mut noise);
        }
    }
    text
}

fn one_run(text: &mut String, run_id: &str, load_kg: f64, friction_deg: f64, noise: &mut Noise) {
    let peak_n = load_kg * GRAVITY_M_S2 * friction_deg.to_radians().tan();
    let steepest = true_dilation_deg(friction_deg).to_radians().tan();
    let mut vertical_mm = 0.0;
    for sample in 0..SAMPLES {
        let displacement_mm = STEP_MM * f64::from(sample);
        let x = displacement_mm / PEAK_MM;
        let force_n = peak_n * mobilised(x) + BIAS_N + MACHINE_FRICTION_N + FORCE_NOISE_N * noise.normal();
        let reading_mm = vertical_mm + DIAL_NOISE_MM * noise.normal();
        writeln!(text, "{run_id},{load_kg},{displacement_mm:.1},{force_n:.3},{reading_mm:.4}").unwrap_or(());
        let midway = (displacement_mm + STEP_MM / 2.0) / PEAK_MM;
        vertical_mm += STEP_MM * steepest * dilating(midway);
    }
}

/// Share of the peak strength that is mobilised at `x` peak displacements: up to 1, then down towards 0.85.
fn mobilised(x: f64) -> f64 {
    let hump = 2.0 * x / (1.0 + x * x);
    if x < 1.0 { hump } else { 0.85 + 0.15 * hump }
}

/// Rate of dilation in terms of that at the peak: contraction at first, most dilation at the peak.
fn dilating(x: f64) -> f64 {
    if x < 1.0 { 1.0 - 1.5 * (x - 1.0).powi(2) } else { (-(x - 1.0).powi(2)).exp() }
}

/// The text of `loop.csv`: the empty box forward and back.
pub(crate) fn loop_csv() -> String {
    let mut noise = Noise(1776);
    let mut text = "displacement_mm,shear_force_n,direction\n".to_owned();
    let steps: Vec<u32> = (0..SAMPLES).collect();
    for (direction, sign) in [("forward", 1.0), ("reverse", -1.0)] {
        let order: Vec<u32> = if sign > 0.0 { steps.clone() } else { steps.iter().rev().copied().collect() };
        for sample in order {
            let force_n = BIAS_N + sign * MACHINE_FRICTION_N + FORCE_NOISE_N * noise.normal();
            let displacement_mm = STEP_MM * f64::from(sample);
            writeln!(text, "{displacement_mm:.1},{force_n:.3},{direction}").unwrap_or(());
        }
    }
    text
}

/// `SplitMix64` with the sum of twelve uniform numbers as a normal one: the same on every machine.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        f64::from(u32::try_from(z >> 32).unwrap_or(0)) / 4_294_967_296.0
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform()).sum::<f64>() - 6.0
    }
}

fn main() -> std::io::Result<()> {
    let folder = std::env::args_os().nth(1).map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/direct_shear_raw"),
        PathBuf::from,
    );
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("runs.csv"), runs_csv())?;
    std::fs::write(folder.join("loop.csv"), loop_csv())
}
