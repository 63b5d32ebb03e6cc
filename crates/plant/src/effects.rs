use soilctl_controller::Sensed;

/// Where and when the plate is in the soil, for an effect to depend on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Contact {
    /// Tick of the run.
    pub tick: u64,
    /// Preparations of the soil so far, from 0.
    pub preparation: u32,
    /// Middle of the plate's lower edge in m, base frame.
    pub tip_m: [f64; 3],
    /// Depth of the lower edge in m.
    pub depth_m: f64,
    /// Mean height of what is heaped ahead of the plate in m.
    pub heap_m: f64,
    /// Tool angle in rad.
    pub tool_angle_rad: f64,
    /// Speed of the tip in m/s.
    pub speed_m_s: f64,
    /// Distance from the plate's nearer end to the nearest wall in m.
    pub wall_m: f64,
}

/// What an effect may change about the soil. As made by `default` it changes nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoilChange {
    /// Factor on the limit force.
    pub limit_force: f64,
    /// Added to the friction angle between soil and plate in rad; below 0 it stops at a smooth plate.
    pub interface_rad: f64,
    /// Factor on the way to failure.
    pub mobilisation_way: f64,
    /// Factor on the resistance of the plate's edge.
    pub bearing: f64,
    /// Added in m to the depth of a plate that is well in the soil; see [`SoilChange::true_depth_m`].
    pub depth_m: f64,
}

impl SoilChange {
    /// Ways of the size of an offset of the depth within which it comes about.
    const COMES_ABOUT: f64 = 4.0;

    /// Depth in m of a plate that its place puts at `depth_m`: a touch that was taken wrongly leaves the place where the plate meets soil as
    /// it is, and shows below it.
    #[must_use]
    pub fn true_depth_m(&self, depth_m: f64) -> f64 {
        if self.depth_m == 0.0 || depth_m <= 0.0 {
            return depth_m;
        }
        depth_m + self.depth_m * (depth_m / (Self::COMES_ABOUT * self.depth_m.abs())).min(1.0)
    }
}

impl Default for SoilChange {
    fn default() -> Self {
        Self { limit_force: 1.0, interface_rad: 0.0, mobilisation_way: 1.0, bearing: 1.0, depth_m: 0.0 }
    }
}

/// Effects that an experiment can hide: changes of the soil and of the readings.
///
/// Both methods are called in a fixed order, once a tick, so that an effect may have a state and stay deterministic.
pub trait Effects: Send {
    /// Changes the soil at the plate; called only while the plate is in it.
    fn soil(&mut self, contact: &Contact, change: &mut SoilChange) {
        let _ = (contact, change);
    }

    /// Changes what the sensors report.
    fn sensed(&mut self, sensed: &mut Sensed) {
        let _ = sensed;
    }
}

/// No effect at all.
pub(crate) struct None;

impl Effects for None {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_depth_that_is_off_is_so_below_the_touch() {
        for offset in [0.002, -0.002] {
            let change = SoilChange { depth_m: offset, ..SoilChange::default() };
            assert_eq!(change.true_depth_m(-0.01), -0.01);
            assert!((change.true_depth_m(0.025) - (0.025 + offset)).abs() < 1e-15);
            let near = change.true_depth_m(1e-4);
            assert!(near > 0.0 && (near - 1e-4).abs() < 0.3e-4, "{near}");
        }
        assert_eq!(SoilChange::default().true_depth_m(0.02), 0.02);
    }
}
