//! Sand: the force on the plate, and the heaps and furrows that it leaves.

mod limit;
mod plate;
mod presets;
mod strength;
mod surface;

use soilctl_earth_pressure::ForceModel;
use soilctl_kinematics::{Arm, Frame};
use soilctl_soil::{Interface, Soil};

pub use presets::{SoilPreset, presets};

use crate::bodies::PointForce;
use crate::config::{BoxConfig, GroundConfig};
use crate::effects::{Contact, Effects, SoilChange};
use crate::noise::Noise;
use crate::truth::SoilTruth;
use crate::{PlantError, PlantParams};
use plate::Plate;
use strength::Strength;
use surface::{Strip, Surface};

/// The sand in the box.
///
/// The limit force is that of a force model at the plate's true depth below the surface ahead of it, heap included, and so
/// goes with the square of the depth; what is mobilised of it follows the way of the plate. Passive and active side are both
/// in the model's net force. The force's inclination is limited by friction on the plate, which slips along it otherwise.
pub struct Ground {
    config: GroundConfig,
    sandbox: BoxConfig,
    preset: SoilPreset,
    soil: Soil,
    interface: Interface,
    strength: Strength,
    width_m: f64,
    thickness_m: f64,
    surface_z_m: f64,
    surface: Surface,
    noise: Noise,
    preparations: u32,
    change: SoilChange,
    /// Height of the surface ahead of the plate in m, once a tick.
    ahead_z_m: f64,
    plate: Plate,
}

impl Ground {
    /// Level sand with its surface at `surface_z_m` in the base frame, whose limit forces are those of `model`.
    ///
    /// # Errors
    /// [`PlantError::Force`] if the model has no answer for this soil or lacks its cohesion, [`PlantError::Soil`] or
    /// [`PlantError::Config`] for numbers out of their range.
    pub fn new(
        params: &PlantParams,
        preset: &SoilPreset,
        model: &dyn ForceModel,
        surface_z_m: f64,
        seed: u64,
    ) -> Result<Self, PlantError> {
        let (config, sandbox) = (params.config().ground, params.config().sandbox);
        let (soil, interface) = preset.soil()?;
        let rules = crate::rules::Rules { file: "ground" };
        rules.range("surface_z_m", surface_z_m, "m", sandbox.floor_z_m, sandbox.top_z_m)?;
        let shape = &params.arm().config().plate;
        let surface = Surface::level(sandbox.x_m, sandbox.y_m, config.cell_m, surface_z_m);
        Ok(Self {
            strength: Strength::new(&config, preset, model, &soil, &interface)?,
            width_m: shape.width_m,
            thickness_m: shape.thickness_m,
            noise: Noise::new(seed),
            preparations: 0,
            change: SoilChange::default(),
            ahead_z_m: surface_z_m,
            plate: Plate::default(),
            preset: preset.clone(),
            config,
            sandbox,
            soil,
            interface,
            surface_z_m,
            surface,
        })
    }

    /// Level sand again, with a density that scatters as the preset says. To be called while the plate is out of it.
    pub fn prepare(&mut self) {
        self.surface.rake(self.surface_z_m);
        self.preparations = self.preparations.saturating_add(1);
        let scatter = 1.0 + self.preset.density_sd_rel * self.noise.normal();
        let density = self.preset.density_kg_m3 * scatter.max(0.5);
        self.strength.set_density(&self.preset, density);
        self.plate = Plate::default();
    }

    /// The soil at the preset's density.
    #[must_use]
    pub const fn soil(&self) -> &Soil {
        &self.soil
    }

    /// Friction between soil and plate.
    #[must_use]
    pub const fn interface(&self) -> &Interface {
        &self.interface
    }

    /// Bulk density of the present preparation in kg/m3.
    #[must_use]
    pub const fn density_kg_m3(&self) -> f64 {
        self.strength.density_kg_m3
    }

    /// How often the soil was prepared since it was made.
    #[must_use]
    pub const fn preparations(&self) -> u32 {
        self.preparations
    }

    /// Volume of soil above the table's height in m3 (negative): kept by all strokes.
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        self.surface.volume_m3()
    }

    /// Failure force in N at full friction for a plate at a tool angle (rad) and depth (m), without effects.
    #[must_use]
    pub fn limit_force_n(&self, tool_angle_rad: f64, depth_m: f64) -> f64 {
        self.strength.limit_n(tool_angle_rad, depth_m, self.width_m, 1.0)
    }

    pub(crate) const fn truth(&self) -> SoilTruth {
        self.plate.truth
    }

    /// Once a tick: the surface ahead, what the last tick has moved, and effects.
    pub(crate) fn survey(&mut self, hand: &Frame, tip_m: [f64; 3], tick: u64, effects: &mut dyn Effects) {
        let ahead = [hand.rotation[0][0], hand.rotation[1][0]];
        let length = libm::hypot(ahead[0], ahead[1]);
        // A plate that lies flat has nothing ahead.
        if length < 0.1 {
            self.ahead_z_m = self.surface_z_m;
            return;
        }
        let ahead = ahead.map(|part| part / length);
        let deep_m = (self.ahead_z_m - tip_m[2]).max(0.005);
        let strip = |half_width_m: f64, near: f64, far: f64| Strip {
            middle_m: [tip_m[0], tip_m[1]],
            ahead,
            half_width_m,
            along_m: [near, far],
        };
        let (half, cell_m) = (0.5 * self.width_m, self.config.cell_m);
        if self.plate.moved_m > 0.0 {
            let volume = self.plate.moved_m * deep_m * self.width_m;
            // A cell's distance, so that the plate's own cell is neither.
            let behind = strip(half, -2.0 * cell_m, -cell_m);
            // The heap spills over the plate's ends.
            let heap = strip(half + deep_m, cell_m, cell_m + self.config.heap_length * deep_m);
            self.surface.shift(&behind, &heap, volume, tip_m[2]);
            self.plate.moved_m = 0.0;
        }
        self.ahead_z_m = self.surface.mean_height_m(&strip(half, cell_m, cell_m + deep_m));
        self.plate.truth.heap_m = self.ahead_z_m - self.surface_z_m;
        if self.plate.truth.depth_m > 0.0 {
            let mut change = SoilChange::default();
            effects.soil(&self.contact(hand, tip_m, tick), &mut change);
            self.change = change;
        }
    }

    fn contact(&self, hand: &Frame, tip_m: [f64; 3], tick: u64) -> Contact {
        let truth = &self.plate.truth;
        let reach: [f64; 2] = std::array::from_fn(|i| 0.5 * self.width_m * hand.rotation[i][1].abs());
        let [x, y] = [self.sandbox.x_m, self.sandbox.y_m];
        let gap = |at: f64, [low, high]: [f64; 2], reach: f64| (at - reach - low).min(high - at - reach);
        Contact {
            tick,
            preparation: self.preparations,
            tip_m,
            depth_m: truth.depth_m,
            heap_m: truth.heap_m,
            tool_angle_rad: truth.tool_angle_rad,
            speed_m_s: self.plate.speed_m_s,
            wall_m: gap(tip_m[0], x, reach[0]).min(gap(tip_m[1], y, reach[1])),
        }
    }

    /// Once a substep: the force on the plate.
    pub(crate) fn press(
        &mut self,
        hand: &Frame,
        tip_m: [f64; 3],
        velocity_m_s: [f64; 3],
        dt_s: f64,
    ) -> PointForce {
        let depth_m = self.ahead_z_m - tip_m[2];
        let size = [self.width_m, self.thickness_m];
        self.plate.press(&self.config, &self.strength, &self.change, size, hand, depth_m, velocity_m_s, dt_s);
        let force_n = self.plate.force_n(hand);
        // Pressure grows with depth, so that its resultant lies a third of the way up.
        let up_m = -self.plate.slant_m / 3.0;
        PointForce { force_n, point_m: std::array::from_fn(|i| tip_m[i] + up_m * hand.rotation[i][2]) }
    }
}

impl PlantParams {
    /// The arm of a ground test: the same arm with gravity in m/s2, for soils of another planet.
    ///
    /// # Errors
    /// [`PlantError::Kinematics`] if the gravity is not from 0 to 30 m/s2.
    pub fn under_gravity(&self, gravity_m_s2: f64) -> Result<Self, PlantError> {
        let mut config = self.arm().config().clone();
        config.gravity_m_s2 = gravity_m_s2;
        Self::new(Arm::new(config)?, self.config().clone())
    }
}
