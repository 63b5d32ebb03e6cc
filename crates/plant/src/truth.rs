use serde::{Deserialize, Serialize};
use soilctl_kinematics::{JointAngles, JointVelocities};

/// What a simulated run knows and no sensor tells.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Truth {
    /// Joint angles.
    pub joints: JointAngles,
    /// Their speeds.
    pub joint_rates: JointVelocities,
    /// Middle of the plate's lower edge in m, base frame.
    pub tip_m: [f64; 3],
    /// Load of the force sensor in its frame in N and N m, without bias and noise; the plate's weight is part of it.
    pub wrench: [f64; 6],
    /// The soil at the plate.
    pub soil: SoilTruth,
}

impl Truth {
    /// Force of the soil on the plate in N along the tip's radius, along its tangent (counter-clockwise) and upwards. On the
    /// vertical axis, where no radius has a direction, along x and y.
    #[must_use]
    pub fn force_rtz_n(&self) -> [f64; 3] {
        let [[tip_x, tip_y, _], [x, y, z]] = [self.tip_m, self.soil.force_n];
        let radius = libm::hypot(tip_x, tip_y);
        let [cos, sin] = if radius > 0.0 { [tip_x / radius, tip_y / radius] } else { [1.0, 0.0] };
        [cos * x + sin * y, cos * y - sin * x, z]
    }
}

/// The soil at the plate; all zero outside it.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct SoilTruth {
    /// Depth of the plate's lower edge below the surface that it went into in m; negative above it.
    pub depth_m: f64,
    /// Mean height of what is heaped ahead of the plate above that surface in m.
    pub heap_m: f64,
    /// Tool angle in rad.
    pub tool_angle_rad: f64,
    /// Force of the force model in N at which the soil fails now, at full friction on the plate.
    pub limit_force_n: f64,
    /// The same with the present force along the plate, and what is left of the strength after the peak.
    pub limit_force_now_n: f64,
    /// Force of the soil on the plate in N, base frame.
    pub force_n: [f64; 3],
    /// Force across the plate in N, positive when the plate presses towards the base.
    pub normal_n: f64,
    /// Force of the soil along the plate in N, positive upwards.
    pub tangent_n: f64,
    /// Force along the plate's edge in N.
    pub lateral_n: f64,
    /// Share of the failure force that is mobilised, -1 to 1.
    pub mobilisation: f64,
    /// Whether the soil fails in this tick.
    pub failing: bool,
    /// Way of the plate since the soil failed in m.
    pub slip_m: f64,
    /// Way ahead to a buried block in m that is not below the plate; below 0 by how far it was entered. `None` if there is none.
    pub block_gap_m: Option<f64>,
}
