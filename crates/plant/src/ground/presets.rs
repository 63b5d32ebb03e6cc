use serde::{Deserialize, Serialize};
use soilctl_soil::{Angle, Interface, Soil};

use super::FrictionLaw;
use crate::PlantError;
use crate::rules::Rules;

const SOILS: &str = include_str!("../../../../data/plant/soils.toml");
const FILE: &str = "data/plant/soils.toml";

/// A soil with what its preparation scatters.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SoilPreset {
    /// Name in files and options.
    pub name: String,
    /// Name for people.
    pub title: String,
    /// Friction angle in degrees; 1 to 60.
    pub phi_deg: f64,
    /// How friction falls with stress; without it, it is the same everywhere. Only of soil without cohesion.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction_law: Option<FrictionLaw>,
    /// Friction angle between soil and plate in degrees; 0 to `phi_deg`.
    pub delta_deg: f64,
    /// Cohesion in Pa; 0 to 1e5.
    pub cohesion_pa: f64,
    /// Bulk density in kg/m3; 100 to 10 000.
    pub density_kg_m3: f64,
    /// Density of the loosest packing in kg/m3.
    pub loosest_kg_m3: f64,
    /// Density of the densest packing in kg/m3; above the loosest.
    pub densest_kg_m3: f64,
    /// Standard deviation of the density between preparations, relative; 0 to 0.2.
    pub density_sd_rel: f64,
    /// Gravity in m/s2; above 0, at most 30. The same as the arm's.
    pub gravity_m_s2: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct SoilFile {
    #[serde(rename = "version")]
    _version: u32,
    soils: Vec<SoilPreset>,
}

/// The soils of `data/plant/soils.toml`: the thesis's four, Martian ones from its section 2.1, and a lunar one.
///
/// # Panics
/// Never: a test reads the same text.
#[must_use]
pub fn presets() -> Vec<SoilPreset> {
    match toml::from_str::<SoilFile>(SOILS) {
        Ok(file) => file.soils,
        Err(error) => unreachable!("{error}"),
    }
}

impl SoilPreset {
    /// The preset of this name.
    ///
    /// # Errors
    /// [`PlantError::UnknownSoil`] if there is none.
    pub fn named(name: &str) -> Result<Self, PlantError> {
        let all = presets();
        let known = all.iter().map(|soil| soil.name.as_str()).collect::<Vec<_>>().join(", ");
        all.into_iter()
            .find(|soil| soil.name == name)
            .ok_or_else(|| PlantError::UnknownSoil { name: name.to_owned(), known })
    }

    /// Relative density, 0 (loosest) to 1 (densest), of a bulk density in kg/m3.
    #[must_use]
    pub fn relative_density(&self, density_kg_m3: f64) -> f64 {
        let share = (density_kg_m3 - self.loosest_kg_m3) / (self.densest_kg_m3 - self.loosest_kg_m3);
        // Void ratios, not densities, are interpolated.
        (share * self.densest_kg_m3 / density_kg_m3).clamp(0.0, 1.0)
    }

    /// Soil and interface at the preset's density.
    ///
    /// # Errors
    /// [`PlantError::Config`] or [`PlantError::Soil`] for numbers out of their range.
    pub fn soil(&self) -> Result<(Soil, Interface), PlantError> {
        self.check(FILE)?;
        let soil = Soil::new(Angle::from_degrees(self.phi_deg), self.density_kg_m3)?
            .with_cohesion(self.cohesion_pa)?
            .with_gravity(self.gravity_m_s2)?;
        let interface = Interface::new(Angle::from_degrees(self.delta_deg), 0.0)?;
        interface.check_against(&soil)?;
        Ok((soil, interface))
    }

    /// Whether all numbers are in their range; `file` is named in messages.
    ///
    /// # Errors
    /// [`PlantError::Config`] naming the first key that is not allowed.
    pub fn check(&self, file: &str) -> Result<(), PlantError> {
        let rules = Rules { file };
        rules.range("phi_deg", self.phi_deg, "deg", 1.0, 60.0)?;
        rules.range("delta_deg", self.delta_deg, "deg", 0.0, self.phi_deg)?;
        rules.range("cohesion_pa", self.cohesion_pa, "Pa", 0.0, 1e5)?;
        if let Some(law) = &self.friction_law {
            law.check(&rules)?;
            let allowed = "0 Pa where `friction_law` says how friction falls with stress".to_owned();
            rules.check("cohesion_pa", self.cohesion_pa, "Pa", self.cohesion_pa == 0.0, allowed)?;
        }
        rules.range("density_kg_m3", self.density_kg_m3, "kg/m3", 100.0, 1e4)?;
        rules.range("loosest_kg_m3", self.loosest_kg_m3, "kg/m3", 100.0, 1e4)?;
        let above = self.loosest_kg_m3 + 1.0;
        rules.range("densest_kg_m3", self.densest_kg_m3, "kg/m3", above, 1.1e4)?;
        rules.range("density_sd_rel", self.density_sd_rel, "", 0.0, 0.2)?;
        rules.positive("gravity_m_s2", self.gravity_m_s2, "m/s2", 30.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_presets_are_soils() {
        for preset in presets() {
            let (soil, interface) = preset.soil().unwrap();
            assert!(interface.friction() <= soil.friction(), "{}", preset.name);
            let relative = preset.relative_density(preset.density_kg_m3);
            assert!((0.0..=1.0).contains(&relative));
        }
        assert!(SoilPreset::named("ticino").unwrap_err().to_string().contains("ticino_rained"));
    }
}
