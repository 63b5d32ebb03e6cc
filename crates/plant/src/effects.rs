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
}

impl Default for SoilChange {
    fn default() -> Self {
        Self { limit_force: 1.0, interface_rad: 0.0, mobilisation_way: 1.0, bearing: 1.0 }
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
