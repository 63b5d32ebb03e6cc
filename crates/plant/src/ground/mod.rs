//! Sand: the force on the plate, and the heaps and furrows that it leaves.

mod buried;
mod limit;
mod plate;
mod presets;
mod strength;
mod surface;
mod under_stress;

use soilctl_earth_pressure::{EarthPressureError, ForceModel};
use soilctl_kinematics::{Arm, Frame};
use soilctl_soil::{Interface, Soil};

pub use buried::{BuriedBlock, block_gap_m};
pub use presets::{SoilPreset, presets};
pub use under_stress::FrictionLaw;

use crate::bodies::PointForce;
use crate::config::{BoxConfig, GroundConfig};
use crate::effects::{Contact, Effects, SoilChange};
use crate::noise::Noise;
use crate::truth::SoilTruth;
use crate::{PlantError, PlantParams};
use buried::{Frictions, Nearby, nearby};
use plate::PlateContact;
use strength::Strength;
use surface::Surface;

/// Ticks between two looks at the surface ahead: the plate moves by less than a millimetre.
const SURVEY_TICKS: u64 = 10;
/// Way in cells after which the surface hears of it; the rest of a stroke, which it never hears of, is shorter.
const PUSH_CELLS: f64 = 0.2;
/// Depths ahead over which the surface loads the failing wedge.
const WEDGE_LENGTH: f64 = 2.5;

/// The sand in the box.
///
/// The limit force is that of a force model at the plate's true depth below the surface, and so goes with the square of
/// the depth, with the heap ahead as a surcharge; what is mobilised of it follows the way of the plate. Passive and active side are both
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
    blocks: Vec<BuriedBlock>,
    noise: Noise,
    preparations: u32,
    change: SoilChange,
    /// Height of the surface that the plate is in, and of the heap above it, in m.
    level_z_m: f64,
    heap_m: f64,
    plate: PlateContact,
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
        let surface = Surface::new(&sandbox, config.cell_m, surface_z_m, &soil)?;
        Ok(Self {
            strength: Strength::new(&config, preset, model, &soil, &interface)?,
            width_m: shape.width_m,
            thickness_m: shape.thickness_m,
            blocks: Vec::new(),
            noise: Noise::new(seed),
            preparations: 0,
            change: SoilChange::default(),
            level_z_m: surface_z_m,
            heap_m: 0.0,
            plate: PlateContact::default(),
            preset: preset.clone(),
            config,
            sandbox,
            soil,
            interface,
            surface_z_m,
            surface,
        })
    }

    /// The same for a plate with ends, which add a part of what they add at most by the bracket of `model`: its end factor, 0 to 1.
    ///
    /// # Errors
    /// [`PlantError::Config`] for a factor out of its range, [`PlantError::Force`] if the model has no answer for this soil or does not
    /// say what ends add.
    pub fn with_ends(mut self, model: &dyn ForceModel, end_factor: f64) -> Result<Self, PlantError> {
        crate::rules::Rules { file: "ground" }.range("end_factor", end_factor, "", 0.0, 1.0)?;
        if !model.bounds_ends() {
            return Err(EarthPressureError::NoEnds { model: model.id() }.into());
        }
        self.strength = self.strength.with_ends(model, &self.soil, &self.interface, end_factor)?;
        Ok(self)
    }

    /// The same with rigid blocks buried in it, which stay where they are when it is prepared anew.
    ///
    /// # Errors
    /// [`PlantError::Config`] for a block whose numbers are out of their range, or in soil whose friction falls with stress: what blocks do is
    /// known for one friction angle.
    pub fn with_blocks(mut self, blocks: Vec<BuriedBlock>) -> Result<Self, PlantError> {
        if let Some(law) = self.preset.friction_law.filter(|_| !blocks.is_empty()) {
            let (key, slope) = ("friction_law.slope_deg_per_decade", law.slope_deg_per_decade);
            let allowed = "left out where blocks are buried".to_owned();
            crate::rules::Rules { file: "ground" }.check(key, slope, "deg/decade", false, allowed)?;
        }
        blocks.iter().try_for_each(|block| block.check("ground"))?;
        self.blocks = blocks;
        Ok(self)
    }

    /// Level sand again, with a density that scatters as the preset says. To be called while the plate is out of it.
    pub fn prepare(&mut self) {
        self.surface.rake();
        (self.level_z_m, self.heap_m) = (self.surface_z_m, 0.0);
        self.preparations = self.preparations.saturating_add(1);
        let scatter = 1.0 + self.preset.density_sd_rel * self.noise.normal();
        let density = self.preset.density_kg_m3 * scatter.max(0.5);
        self.strength.set_density(&self.preset, density);
        self.plate = PlateContact::default();
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
        self.strength.limit_n(tool_angle_rad, depth_m, 0.0, self.width_m, 1.0)
    }

    pub(crate) const fn truth(&self) -> SoilTruth {
        self.plate.truth
    }

    /// Once a tick: the surface ahead, what the last ticks have moved, and effects.
    pub(crate) fn survey(&mut self, hand: &Frame, tip_m: [f64; 3], tick: u64, effects: &mut dyn Effects) {
        let ahead = [hand.rotation[0][0], hand.rotation[1][0]];
        let length = libm::hypot(ahead[0], ahead[1]);
        // A plate that lies flat has nothing ahead.
        if length < 0.1 {
            return;
        }
        let ahead = ahead.map(|part| part / length);
        let inside = self.plate.truth.depth_m > 0.0;
        if inside && self.plate.moved_m >= PUSH_CELLS * self.config.cell_m {
            let heap_m = self.config.heap_length * self.plate.truth.depth_m;
            let heap = [heap_m, self.config.heap_past];
            self.surface.push(tip_m, ahead, self.plate.moved_m, self.width_m, heap);
            self.plate.moved_m = 0.0;
        }
        if !inside {
            self.surface.come_to_rest();
        }
        if tick.is_multiple_of(SURVEY_TICKS) {
            let wedge_m = WEDGE_LENGTH * self.plate.truth.depth_m.max(self.config.cell_m);
            let height_m = self.surface.ahead_m(tip_m, ahead, wedge_m, self.width_m);
            // What lies above the surface that the plate has met is a heap; where it is lower, the plate is less deep.
            self.level_z_m = if inside { self.level_z_m.min(height_m) } else { height_m };
            self.heap_m = height_m - self.level_z_m;
        }
        if inside {
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

    /// What the plate feels of buried blocks, by the friction that it has on the soil now.
    fn nearby(&self, hand: &Frame, tip_m: [f64; 3]) -> Nearby {
        let ahead = [hand.rotation[0][0], hand.rotation[1][0]];
        let length = libm::hypot(ahead[0], ahead[1]);
        if self.blocks.is_empty() || length < 0.1 {
            return Nearby::NOTHING;
        }
        let plate = buried::Plate {
            tip_m: [tip_m[0], tip_m[1]],
            ahead: ahead.map(|part| part / length),
            width_m: self.width_m,
            depth_m: self.surface_z_m - tip_m[2],
            tool_angle_rad: plate::tool_angle_rad(hand),
        };
        let plate_rad = (self.strength.delta_rad + self.change.interface_rad).max(0.0);
        nearby(&self.blocks, &plate, Frictions { soil_rad: self.strength.phi_rad, plate_rad })
    }

    /// Once a substep: the force on the plate.
    pub(crate) fn press(
        &mut self,
        hand: &Frame,
        tip_m: [f64; 3],
        velocity_m_s: [f64; 3],
        dt_s: f64,
    ) -> PointForce {
        let place = [self.change.true_depth_m(self.level_z_m - tip_m[2]), self.heap_m];
        let size = [self.width_m, self.thickness_m];
        let near = self.nearby(hand, tip_m);
        self.plate.press(
            &self.config,
            &self.strength,
            &self.change,
            &near,
            size,
            hand,
            place,
            velocity_m_s,
            dt_s,
        );
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
