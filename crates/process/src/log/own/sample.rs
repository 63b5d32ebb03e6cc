use soilctl_kinematics::{Arm, Frame, JointAngles};
use soilctl_session::messages::ControllerStep;

use crate::ProcessError;

/// One step of our own controller, as far as strokes need it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    pub(super) t_s: f64,
    /// Soil on plate in `ft_sensor`, bias included.
    pub(super) wrench: [f64; 6],
    pub(super) motor: [f64; 5],
    pub(super) external: [f64; 5],
    pub(super) torques: [f64; 5],
    pub(super) phase: Phase,
}

/// Part of the sequence that makes one stroke.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    /// The force sensor's bias is taken in free air.
    Bias,
    /// Down to the soil.
    Touch,
    /// Into it.
    Insert,
    /// Along it.
    Stroke,
    /// Out of it.
    PullOut,
    /// Anything else.
    Other,
}

impl Sample {
    pub(super) fn new(step: &ControllerStep, tick_s: f64) -> Self {
        let phase = match (step.trajectory.as_str(), step.sequence.as_str(), step.sequence_step) {
            ("stroke", ..) => Phase::Stroke,
            (_, "insert_stroke_pullout", 0) => Phase::Bias,
            (_, "insert_stroke_pullout", 1) => Phase::Touch,
            (_, "insert_stroke_pullout", 2) => Phase::Insert,
            (_, "insert_stroke_pullout", _) => Phase::PullOut,
            _ => Phase::Other,
        };
        Self {
            t_s: step.tick as f64 * tick_s,
            wrench: step.wrench,
            motor: step.motor_joints_rad,
            external: step.external_joints_rad,
            torques: step.joint_torques_nm,
            phase,
        }
    }

    /// Whether all its numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        [&self.motor[..], &self.external, &self.wrench, &self.torques]
            .iter()
            .all(|part| part.iter().all(|value| value.is_finite()))
    }
}

/// Plate and sensor when the joints are at these angles in rad.
pub(super) fn tip_and_sensor(arm: &Arm, joints: &[f64; 5]) -> Result<(Frame, Frame), ProcessError> {
    let frames = arm.frames(&JointAngles(*joints)).map_err(ProcessError::arm)?;
    Ok((frames.plate_tip, frames.ft_sensor))
}

/// Mean of the samples' wrenches; `None` of fewer than ten.
pub(super) fn mean_wrench<'a>(samples: impl Iterator<Item = &'a Sample>) -> Option<[f64; 6]> {
    let (mut sum, mut count) = ([0.0; 6], 0.0);
    for sample in samples {
        for (total, part) in sum.iter_mut().zip(sample.wrench) {
            *total += part;
        }
        count += 1.0;
    }
    (count >= 10.0).then(|| sum.map(|total| total / count))
}
