//! Effects on readings.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use soilctl_controller::Sensed;
use soilctl_effects::SensorSite;
use soilctl_kinematics::Joint;

use crate::{Plan, step};

/// What the readings get wrong, by the sums of all effects.
pub(super) struct Sensors {
    scale: f64,
    bias_n: f64,
    drift_n: f64,
    crosstalk: f64,
    wrist_counts: [i32; 2],
    quantum_counts: i32,
    strokes: usize,
    stroke: Arc<AtomicUsize>,
}

impl Sensors {
    /// Readings without effects.
    pub(super) fn new(plan: &Plan, stroke: Arc<AtomicUsize>) -> Self {
        Self {
            scale: 1.0,
            bias_n: 0.0,
            drift_n: 0.0,
            crosstalk: 0.0,
            wrist_counts: [0; 2],
            quantum_counts: 1,
            strokes: plan.strokes().strokes().len(),
            stroke,
        }
    }

    /// One more effect.
    pub(super) fn add(&mut self, site: SensorSite, amplitude: f64, plan: &Plan) {
        match site {
            SensorSite::ForceGain => self.scale *= 1.0 + amplitude,
            SensorSite::ForceZero => self.bias_n += amplitude,
            SensorSite::ForceZeroDrift => self.drift_n += amplitude,
            SensorSite::Crosstalk => self.crosstalk += amplitude,
            SensorSite::ToolAngle => {
                let encoders = &plan.plant().config().encoders;
                let wrist = Joint::Wrist.index();
                // The wrist bends towards the base with a falling tool angle: what is read is set, what is true is off.
                self.wrist_counts =
                    [encoders.motor_counts_per_turn[wrist], encoders.external_counts_per_turn[wrist]]
                        .map(|per_turn| rounded(amplitude / 360.0 * per_turn));
            }
            SensorSite::EncoderStep => {
                let count_m = step::at_plate_m(plan).filter(|step| *step > 0.0);
                self.quantum_counts = rounded(count_m.map_or(1.0, |count| amplitude / count)).max(1);
            }
        }
    }

    pub(super) fn change(&self, sensed: &mut Sensed) {
        let last = self.strokes.saturating_sub(1).max(1);
        #[allow(clippy::cast_precision_loss, reason = "at most 1024 strokes")]
        let time = self.stroke.load(Ordering::Relaxed).min(last) as f64 / last as f64;
        let [x, _, z, ..] = sensed.wrench;
        // The plate's force along itself points downwards where x points to the tip, the soil's upwards.
        sensed.wrench[0] = x - self.crosstalk * z;
        for value in &mut sensed.wrench {
            *value *= self.scale;
        }
        sensed.wrench[2] += self.bias_n + self.drift_n * time;
        let wrist = Joint::Wrist.index();
        let [motor, external] = self.wrist_counts;
        sensed.motor_counts[wrist] = sensed.motor_counts[wrist].saturating_add(motor);
        sensed.external_counts[wrist] = sensed.external_counts[wrist].saturating_add(external);
        if self.quantum_counts > 1 {
            for joint in [Joint::Shoulder.index(), Joint::Elbow.index(), Joint::Twist.index()] {
                let count = &mut sensed.external_counts[joint];
                *count -= count.rem_euclid(self.quantum_counts);
            }
        }
    }
}

fn rounded(counts: f64) -> i32 {
    #[allow(clippy::cast_possible_truncation, reason = "saturates, as a counter does")]
    let counts = counts.round() as i32;
    counts
}
