use serde::Serialize;
use soilctl_soil::Angle;
use soilctl_stats::median;

use super::{RawRun, RawSettings};
use crate::degrees;
use crate::error::DirectShearError;

/// One point of a run after correction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TraceSample {
    /// Horizontal displacement in m.
    pub displacement_m: f64,
    /// Mobilised friction angle `atan(tau / sigma)`.
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    pub friction: Angle,
    /// Vertical movement since the first sample in m, upward positive.
    pub vertical_m: Option<f64>,
}

/// What one run shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunResult {
    /// Name of the run.
    pub run_id: String,
    /// Load in kg.
    pub load_kg: f64,
    /// Normal stress in Pa.
    pub normal_stress_pa: f64,
    /// Peak friction angle.
    #[serde(rename = "friction_angle_deg", serialize_with = "degrees::one")]
    pub friction: Angle,
    /// How far machine friction lowers the peak angle, in degrees; 0 without a friction loop.
    pub loop_correction_deg: f64,
    /// Displacement at the peak in m.
    pub peak_displacement_m: f64,
    /// Whether the peak is the last sample, so that the true peak may lie beyond the record.
    pub peak_at_end: bool,
    /// Vertical movement up to the peak in m, upward positive.
    pub peak_vertical_m: Option<f64>,
    /// Dilation angle `atan(dv/du)` at the peak, positive when the soil expands.
    #[serde(rename = "dilation_angle_deg", serialize_with = "degrees::option")]
    pub dilation: Option<Angle>,
    /// Whether the force was smoothed.
    pub smoothed: bool,
    /// The corrected record.
    pub trace: Vec<TraceSample>,
}

pub(crate) fn evaluate(
    run: &RawRun,
    machine_friction_n: f64,
    settings: &RawSettings,
) -> Result<RunResult, DirectShearError> {
    let refuse = |problem: String| DirectShearError::Run { run_id: run.run_id().to_owned(), problem };
    let sigma_pa = settings.shear_box.normal_stress_pa(run.load_kg());
    let normal_n = run.load_kg() * settings.shear_box.gravity_m_s2;
    let smoothed = sigma_pa < settings.low_stress_limit_pa;
    let corrected: Vec<f64> = run
        .samples()
        .iter()
        .map(|sample| sample.shear_force_n - settings.bias_n - machine_friction_n)
        .collect();
    let force = if smoothed { three_point_mean(&corrected) } else { corrected };
    let (peak, peak_n) = first_maximum(&force);
    let angle = (peak_n / normal_n).atan();
    if !(angle > 0.0 && angle < std::f64::consts::FRAC_PI_2 && sigma_pa.is_finite() && sigma_pa > 0.0) {
        return Err(refuse(format!(
            "peak shear force is {peak_n} N under a normal force of {normal_n} N after correction; both must be above \
             0 N and finite: check sign, bias and friction loop"
        )));
    }
    let samples = run.samples();
    let start_m = samples[0].vertical_m;
    let since_start = |vertical: Option<f64>| Some(vertical? - start_m?);
    let trace = samples.iter().zip(&force).map(|(sample, force)| TraceSample {
        displacement_m: sample.displacement_m,
        friction: Angle::from_radians((force / normal_n).atan()),
        vertical_m: since_start(sample.vertical_m),
    });
    let uncorrected = ((peak_n + machine_friction_n) / normal_n).atan();
    Ok(RunResult {
        run_id: run.run_id().to_owned(),
        load_kg: run.load_kg(),
        normal_stress_pa: sigma_pa,
        friction: Angle::from_radians(angle),
        loop_correction_deg: (uncorrected - angle).to_degrees(),
        peak_displacement_m: samples[peak].displacement_m,
        peak_at_end: peak + 1 == samples.len(),
        peak_vertical_m: since_start(samples[peak].vertical_m),
        dilation: dilation(run, peak, settings.dilation_half_window),
        smoothed,
        trace: trace.collect(),
    })
}

/// Mean of each value and its two neighbours; at the ends, where one is lacking, of two.
fn three_point_mean(values: &[f64]) -> Vec<f64> {
    (0..values.len())
        .map(|i| {
            let window = &values[i.saturating_sub(1)..(i + 2).min(values.len())];
            window.iter().sum::<f64>() / if window.len() == 3 { 3.0 } else { 2.0 }
        })
        .collect()
}

fn first_maximum(values: &[f64]) -> (usize, f64) {
    let mut best = (0, f64::NEG_INFINITY);
    for (index, value) in values.iter().enumerate() {
        if *value > best.1 {
            best = (index, *value);
        }
    }
    best
}

/// Median of the slopes of all pairs of samples near the peak (Theil & Sen): one stuck or jumping reading of the
/// dial gauge does not move it. `None` without vertical readings or if the displacement stands still.
fn dilation(run: &RawRun, peak: usize, half_window: usize) -> Option<Angle> {
    let samples = run.samples();
    let window = &samples[peak.saturating_sub(half_window)..(peak + half_window + 1).min(samples.len())];
    let mut slopes = Vec::new();
    for (index, a) in window.iter().enumerate() {
        for b in &window[index + 1..] {
            let advance = b.displacement_m - a.displacement_m;
            let slope = (b.vertical_m? - a.vertical_m?) / advance;
            if advance > 0.0 && slope.is_finite() {
                slopes.push(slope);
            }
        }
    }
    (!slopes.is_empty()).then(|| Angle::from_radians(median(&mut slopes).atan()))
}
