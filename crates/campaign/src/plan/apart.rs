//! The kinds of strokes of a plan, each alone in soil of its own.

use soilctl_controller::StrokePlan;

use super::file::{Batch, PlanFile, Stroke};
use crate::{CampaignError, Plan};

/// Strokes whose tool angles differ by less, in deg, are of one kind.
const SAME_ANGLE_DEG: f64 = 1.0;
/// The same of their radii in m.
const SAME_RADIUS_M: f64 = 0.02;

impl Plan {
    /// The plan with one stroke of each tool angle and radius, the first that it has, each in a preparation of its own: a few strokes that
    /// have no history, to see what an effect makes of strokes like those of the plan. The posture of the arm, and with it the radius, counts as
    /// much as the tool angle for what its controller makes of an effect.
    ///
    /// # Errors
    /// [`CampaignError::Plan`] if the plan cannot be written down again.
    pub fn apart(&self) -> Result<Self, CampaignError> {
        let refused =
            |problem: String| CampaignError::Plan { file: "plan of single strokes".to_owned(), problem };
        let mut kept: Vec<Batch> = Vec::new();
        for batch in &self.file.batches {
            for stroke in &batch.strokes {
                let stroke = Stroke { radius_m: stroke.radius_m.or(batch.radius_m), ..*stroke };
                let same = |other: &Stroke| {
                    let radius = other
                        .radius_m
                        .zip(stroke.radius_m)
                        .is_none_or(|(a, b)| (a - b).abs() < SAME_RADIUS_M);
                    radius && (other.alpha_deg - stroke.alpha_deg).abs() < SAME_ANGLE_DEG
                };
                if !kept.iter().flat_map(|batch| &batch.strokes).any(same) {
                    kept.push(Batch { radius_m: None, strokes: vec![stroke] });
                }
            }
        }
        let mut table: toml::Table =
            self.text.parse().map_err(|error: toml::de::Error| refused(error.to_string()))?;
        let batches = toml::Value::try_from(&kept).map_err(|error| refused(error.to_string()))?;
        table.insert("batches".to_owned(), batches);
        // What an effect makes of strokes is not to be mixed up with what is buried.
        table.remove("blocks");
        let text = toml::to_string(&table).map_err(|error| refused(error.to_string()))?;
        let mut plan = self.clone();
        let strokes = StrokePlan::from_toml(&text, "plan of single strokes")?;
        plan.params =
            soilctl_controller::Params::new(self.plant.arm().clone(), self.params.config().clone(), strokes)?;
        plan.file = PlanFile { batches: kept, blocks: Vec::new(), ..self.file.clone() };
        plan.text = text;
        Ok(plan)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::path::Path;

    use crate::Plan;

    /// Table 6.2 has four tool angles, three of them at both radii and 70 deg at the inner one.
    #[test]
    fn one_stroke_of_each_tool_angle_and_radius() {
        let text = include_str!("../../../../data/plans/table_6_2.toml");
        let plan = Plan::from_toml(text, "plan", Path::new("")).unwrap().apart().unwrap();
        let strokes = plan.strokes().strokes();
        let mut kinds: Vec<(i32, i32)> = strokes
            .iter()
            .map(|s| (s.tool_angle_rad.to_degrees().round() as i32, (1e3 * s.radius_m).round() as i32))
            .collect();
        kinds.sort_unstable();
        assert_eq!(kinds, [(70, 305), (80, 305), (80, 432), (90, 305), (90, 432), (100, 305), (100, 432)]);
        assert_eq!(plan.batches(), 7);
        // It is a plan as any other.
        let again = Plan::from_toml(plan.text(), "again", Path::new("")).unwrap();
        assert_eq!(again.strokes().strokes(), strokes);
    }
}
