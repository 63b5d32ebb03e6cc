//! The plan of a session in which the plate is led by hand.

use std::path::Path;

use crate::{CampaignError, Plan, SoilPreset};

/// Force model of the soil: a closed form that knows cohesion, so that all soils have the same one.
const MODEL: &str = "chen";

impl Plan {
    /// The thesis's arm over a preset soil, under the gravity of the place where that lies. Its one stroke is there for who wants to make it
    /// beside what the hand does: one inch deep, upright, at 17 inches from the base axis, as most of the thesis's.
    ///
    /// # Errors
    /// [`CampaignError::Plant`] if there is no such soil.
    pub fn by_hand(soil: &str, seed: u64) -> Result<Self, CampaignError> {
        // The name is looked up before it gets into a text.
        let preset = SoilPreset::named(soil)?;
        let text = format!(
            "# Led by hand.\n\nversion = 1\ndesign = \"led by hand\"\nsoil = \"{}\"\nmodel = \"{MODEL}\"\nseed = {seed}\n\n\
             [[batches]]\nstrokes = [\n    {{ radius_m = 0.4318, base_deg = 0.0, alpha_deg = 90.0, depth_m = 0.0254, \
             delta_set_deg = {:.1} }},\n]\n",
            preset.name, preset.delta_deg
        );
        Self::from_toml(&text, "the plan of a session by hand", Path::new("."))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::presets;

    #[test]
    fn every_soil_can_be_dug_under_its_gravity() {
        for soil in presets() {
            let plan = Plan::by_hand(&soil.name, 3).unwrap();
            assert_eq!(plan.params().arm().config().gravity_m_s2, soil.gravity_m_s2);
            plan.simulated_plant(3, 0).unwrap();
        }
        assert!(Plan::by_hand("cheese", 1).unwrap_err().to_string().contains("ticino_rained"));
    }
}
