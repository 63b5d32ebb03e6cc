//! What does not move: the arm's shape, the box and where its sand begins.

use std::collections::BTreeMap;

use soilctl_campaign::Plan;
use soilctl_controller::laws::SafeForceSet;
use soilctl_controller::{ControllerConfig, TICK_S};
use soilctl_kinematics::Arm;
use soilctl_live::protocol::{COMMANDS, Configuration, SafeForce};
use soilctl_plant::PlantParams;
use soilctl_robot::Urdf;
use soilctl_session::{Content, SessionSetup};

use crate::MonitorError;
use crate::arm::ArmMessage;
use crate::messages::{HandRange, PlateSize, Sandbox, SceneMessage};

/// Angle of repose in degrees where nobody says which soil it is.
const REPOSE_DEG: f64 = 35.0;
/// That of cohesive soil, which stands steeper than its friction.
const COHESIVE_DEG: f64 = 80.0;

/// The event of an arm that has found the sand by touch; its value is the level.
pub(crate) const SURFACE_FOUND: &str = "surface_found";

/// The scene behind states.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    pub(crate) arm: Arm,
    pub(crate) sandbox: Sandbox,
    /// Slant lengths ahead of the plate over which moved soil is heaped.
    pub(crate) heap_length: f64,
    pub(crate) repose_deg: f64,
    pub(crate) safe_force: SafeForce,
    safe_set: SafeForceSet,
    pub(crate) strokes: usize,
    soil: String,
    hand: HandRange,
}

impl Scene {
    /// From what a session runs with. The box is that of the plan, or of the default plant where the plan cannot be read
    /// without the files that it names.
    pub(crate) fn new(configuration: &Configuration) -> Result<Self, MonitorError> {
        let refused = |error: &dyn std::fmt::Display| MonitorError::Scene(error.to_string());
        let setup = SessionSetup {
            arm: configuration.arm.clone(),
            controller: configuration.controller.clone(),
            plan: configuration.plan.clone(),
            seed: 0,
            model: configuration.model.clone(),
            notes: BTreeMap::new(),
            content: Content::Whole,
        };
        let params = setup.params().map_err(|error| refused(&error))?;
        let plan = Plan::from_record(&configuration.plan);
        let thesis = PlantParams::thesis();
        let plant = plan.as_ref().map_or(thesis.config(), |plan| plan.plant().config());
        let controller: &ControllerConfig = params.config();
        let soil = plan.as_ref().map(Plan::soil);
        let repose_deg =
            soil.map_or(REPOSE_DEG, |soil| if soil.cohesion_pa > 0.0 { COHESIVE_DEG } else { soil.phi_deg });
        let table = &controller.stroke.safe_force;
        Ok(Self {
            arm: Arm::from_toml(&configuration.arm, "arm").map_err(|error| refused(&error))?,
            sandbox: Sandbox {
                x_m: plant.sandbox.x_m,
                y_m: plant.sandbox.y_m,
                floor_z_m: plant.sandbox.floor_z_m,
                top_z_m: plant.sandbox.top_z_m,
                surface_z_m: controller.site.surface_z_m,
                cell_m: plant.ground.cell_m,
            },
            heap_length: plant.ground.heap_length,
            repose_deg,
            safe_force: SafeForce { angle_deg: table.angle_deg.clone(), force_n: table.force_n.clone() },
            safe_set: *params.safe_force(),
            strokes: params.plan().strokes().len(),
            soil: soil.map(|soil| soil.title.clone()).unwrap_or_default(),
            hand: hand(controller),
        })
    }

    /// Largest force in N at an angle to the plate's normal that the soil bears safely; none without a table.
    pub(crate) fn safe_force_n(&self, angle_deg: f64) -> Option<f64> {
        self.safe_set.largest_n(angle_deg.to_radians())
    }

    /// The scene for a page.
    pub(crate) fn message(&self, name: &str, live: bool, commands: bool) -> SceneMessage {
        let plate = self.arm.config().plate;
        let urdf = soilctl_kinematics::urdf(&self.arm);
        SceneMessage {
            name: name.to_owned(),
            live,
            commands,
            words: COMMANDS.iter().map(|word| [word.name, word.help]).collect(),
            // Ours can be read.
            arm: Urdf::parse(&urdf).map(|urdf| ArmMessage::of(&urdf, &BTreeMap::new())).unwrap_or_default(),
            urdf,
            tip_link: "plate_tip".to_owned(),
            plate: Some(PlateSize {
                width_m: plate.width_m,
                height_m: plate.height_m,
                thickness_m: plate.thickness_m,
            }),
            sandbox: Some(self.sandbox),
            soil: self.soil.clone(),
            joints: Vec::new(),
            ground_z_m: Some(self.sandbox.surface_z_m),
            tip_box_m: None,
            space_m: None,
            has_force: true,
            hand: Some(self.hand),
        }
    }
}

fn hand(controller: &ControllerConfig) -> HandRange {
    let (safety, hand) = (&controller.safety, &controller.hand);
    let within = |[low, high]: [f64; 2]| [low + hand.margin_m, high - hand.margin_m];
    HandRange {
        radius_m: within(safety.radius_m),
        height_m: within(safety.height_m),
        base_deg: safety.base_deg,
        speed_m_s: hand.speed_m_s,
        force_n: hand.force_n,
        lease_s: f64::from(hand.lease_ticks) * TICK_S,
    }
}
