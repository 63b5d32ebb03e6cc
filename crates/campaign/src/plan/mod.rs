//! What is to be done: a plan file, read and checked.

mod apart;
mod blocks;
mod by_hand;
mod demonstration;
pub mod file;
mod further;
mod live;
mod logged;

use std::ops::Range;
use std::path::Path;

use soilctl_controller::{ControllerConfig, Params, StrokePlan};
use soilctl_earth_pressure::plane_model;
use soilctl_kinematics::Arm;
use soilctl_plant::config::PlantConfig;
use soilctl_plant::{FrictionLaw, PlantParams, SoilPreset};

use crate::CampaignError;
use file::{PlanFile, SoilEntry};

pub use demonstration::demonstration;

/// A campaign, complete and checked: every stroke can be reached, soil and model go together.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    text: String,
    file: PlanFile,
    params: Params,
    plant: PlantParams,
    soil: SoilPreset,
}

impl Plan {
    /// A plan from a TOML file.
    ///
    /// # Errors
    /// [`CampaignError::File`] if it cannot be read, otherwise as [`Plan::from_toml`].
    pub fn read(path: &Path) -> Result<Self, CampaignError> {
        let text = std::fs::read_to_string(path).map_err(|error| CampaignError::file(path, &error))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Self::from_toml(&text, &path.display().to_string(), folder)
    }

    /// A plan from the text of a TOML file; `name` stands for it in messages, and files that it names are looked for
    /// from `folder` on.
    ///
    /// # Errors
    /// [`CampaignError::Plan`] for what is no plan, and whatever arm, controller, plant, soil and force model refuse.
    pub fn from_toml(text: &str, name: &str, folder: &Path) -> Result<Self, CampaignError> {
        let refused = |problem: String| CampaignError::Plan { file: name.to_owned(), problem };
        let file: PlanFile =
            toml::from_str(text).map_err(|error| refused(error.to_string().trim_end().to_owned()))?;
        if file.version != 1 {
            return Err(refused(format!("`version` is {}; it must be 1", file.version)));
        }
        if file.batches.is_empty() {
            return Err(refused("`batches` is empty; give at least one batch".to_owned()));
        }
        if let Some(empty) = file.batches.iter().position(|batch| batch.strokes.is_empty()) {
            return Err(refused(format!("`batches[{empty}].strokes` is empty; give at least one stroke")));
        }
        if !(0.0..=1.0).contains(&file.end_factor) {
            return Err(refused(format!("`end_factor` is {}; it must be from 0 to 1", file.end_factor)));
        }
        let soil = soil(&file, name)?;
        let strokes = StrokePlan::from_toml(text, name)?;
        let arm = match file.arm.as_str() {
            "thesis" => Arm::thesis(),
            path => Arm::read(&folder.join(path))?,
        };
        let plant = match file.plant.as_str() {
            "default" => PlantParams::new(arm, PlantParams::thesis().config().clone())?,
            path => PlantParams::read(arm, &folder.join(path))?,
        };
        let plant = plant.under_gravity(soil.gravity_m_s2)?;
        blocks::check(&file, name, plant.arm().config().plate.width_m)?;
        let arm = plant.arm().clone();
        let params = match file.controller.as_str() {
            "default" => Params::new(arm, Params::thesis().config().clone(), strokes)?,
            path => Params::read(arm, &folder.join(path), strokes)?,
        };
        plane_model(&file.model)?;
        Ok(Self { text: text.to_owned(), file, params, plant, soil })
    }

    /// The same plan with another force model, soil and plant; `name` stands for where they come from in messages.
    pub(crate) fn change(
        &mut self,
        name: &str,
        model_name: &str,
        change: impl FnOnce(&mut SoilPreset, &mut PlantConfig),
    ) -> Result<(), CampaignError> {
        let mut plant = self.plant.config().clone();
        change(&mut self.soil, &mut plant);
        self.soil.check(name)?;
        let arm = self.plant.arm().clone();
        self.plant = PlantParams::new(arm, plant)?.under_gravity(self.soil.gravity_m_s2)?;
        let config = self.params.config().clone();
        self.params = Params::new(self.plant.arm().clone(), config, self.params.plan().clone())?;
        plane_model(model_name)?;
        model_name.clone_into(&mut self.file.model);
        Ok(())
    }

    /// The same plan with other settings of the controller, which its text does not name.
    ///
    /// # Errors
    /// [`CampaignError::Controller`] for settings that make no sense, or with which a stroke cannot be reached.
    pub fn with_controller(&self, config: ControllerConfig) -> Result<Self, CampaignError> {
        let params = Params::new(self.plant.arm().clone(), config, self.params.plan().clone())?;
        Ok(Self { params, ..self.clone() })
    }

    /// The text that it was made from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The file behind it.
    #[must_use]
    pub const fn file(&self) -> &PlanFile {
        &self.file
    }

    /// Arm, settings and strokes of the controller.
    #[must_use]
    pub const fn params(&self) -> &Params {
        &self.params
    }

    /// Settings of the controller.
    #[must_use]
    pub const fn controller(&self) -> &ControllerConfig {
        self.params.config()
    }

    /// All strokes in order.
    #[must_use]
    pub const fn strokes(&self) -> &StrokePlan {
        self.params.plan()
    }

    /// Arm and description of the simulated plant.
    #[must_use]
    pub const fn plant(&self) -> &PlantParams {
        &self.plant
    }

    /// The soil, with its scatter between preparations.
    #[must_use]
    pub const fn soil(&self) -> &SoilPreset {
        &self.soil
    }

    /// How many batches there are.
    #[must_use]
    pub fn batches(&self) -> usize {
        self.file.batches.len()
    }

    /// Numbers of a batch's strokes in the plan; empty for a batch that is not there.
    #[must_use]
    pub fn strokes_of(&self, batch: usize) -> Range<usize> {
        let before: usize = self.file.batches.iter().take(batch).map(|batch| batch.strokes.len()).sum();
        before..before + self.file.batches.get(batch).map_or(0, |batch| batch.strokes.len())
    }
}

fn soil(file: &PlanFile, name: &str) -> Result<SoilPreset, CampaignError> {
    let mut soil = match &file.soil {
        SoilEntry::Preset(preset) => SoilPreset::named(preset)?,
        SoilEntry::Soil(table) => SoilPreset {
            name: "plan".to_owned(),
            title: "the soil of the plan".to_owned(),
            phi_deg: table.phi_deg,
            friction_law: table.friction_law.map(|law| FrictionLaw {
                slope_deg_per_decade: law.slope_deg_per_decade,
                reference_stress_pa: law.reference_stress_pa,
            }),
            delta_deg: table.delta_deg,
            cohesion_pa: table.cohesion_pa,
            density_kg_m3: table.density_kg_m3,
            loosest_kg_m3: table.loosest_kg_m3,
            densest_kg_m3: table.densest_kg_m3,
            density_sd_rel: 0.02,
            gravity_m_s2: table.gravity_m_s2,
        },
    };
    if let Some(scatter) = file.preparation.density_sd_rel {
        soil.density_sd_rel = scatter;
    }
    soil.check(name)?;
    Ok(soil)
}
