//! The kinds of strokes of a plan, each alone in soil of its own.

use soilctl_controller::StrokePlan;

use super::file::{Batch, PlanFile};
use crate::{CampaignError, Plan};

/// Strokes whose tool angles differ by less, in deg, are of one kind.
const SAME_ANGLE_DEG: f64 = 1.0;

impl Plan {
    /// The plan with one stroke of each tool angle, the first that it has, each in a preparation of its own: a few strokes that have no
    /// history, to see what an effect makes of strokes like those of the plan. Radii take turns, as far as the plan has several at an angle.
    ///
    /// # Errors
    /// [`CampaignError::Plan`] if the plan cannot be written down again.
    pub fn apart(&self) -> Result<Self, CampaignError> {
        let refused =
            |problem: String| CampaignError::Plan { file: "plan of single strokes".to_owned(), problem };
        let mut kept: Vec<Batch> = Vec::new();
        let strokes = self.file.batches.iter().flat_map(|batch| {
            batch.strokes.iter().map(move |stroke| {
                let mut stroke = *stroke;
                stroke.radius_m = stroke.radius_m.or(batch.radius_m);
                stroke
            })
        });
        let mut strokes: Vec<_> = strokes.collect();
        while let Some(first) = strokes.first().copied() {
            let same =
                |other: &super::file::Stroke| (other.alpha_deg - first.alpha_deg).abs() < SAME_ANGLE_DEG;
            let last = kept.last().and_then(|batch| batch.strokes.first()?.radius_m);
            let other = strokes.iter().copied().find(|stroke| same(stroke) && stroke.radius_m != last);
            kept.push(Batch { radius_m: None, strokes: vec![other.unwrap_or(first)] });
            strokes.retain(|other| !same(other));
        }
        let mut table: toml::Table =
            self.text.parse().map_err(|error: toml::de::Error| refused(error.to_string()))?;
        let batches = toml::Value::try_from(&kept).map_err(|error| refused(error.to_string()))?;
        table.insert("batches".to_owned(), batches);
        let text = toml::to_string(&table).map_err(|error| refused(error.to_string()))?;
        let mut plan = self.clone();
        let strokes = StrokePlan::from_toml(&text, "plan of single strokes")?;
        plan.params =
            soilctl_controller::Params::new(self.plant.arm().clone(), self.params.config().clone(), strokes)?;
        plan.file = PlanFile { batches: kept, ..self.file.clone() };
        plan.text = text;
        Ok(plan)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::path::Path;

    use crate::Plan;

    /// Table 6.2 has four tool angles at two radii.
    #[test]
    fn one_stroke_of_each_tool_angle_and_both_radii() {
        let text = include_str!("../../../../data/plans/table_6_2.toml");
        let plan = Plan::from_toml(text, "plan", Path::new("")).unwrap().apart().unwrap();
        let strokes = plan.strokes().strokes();
        let mut angles: Vec<i64> = strokes.iter().map(|s| s.alpha_rad.to_degrees().round() as i64).collect();
        angles.sort_unstable();
        assert_eq!((angles, plan.batches()), (vec![70, 80, 90, 100], 4));
        let radii: Vec<f64> = strokes.iter().map(|stroke| stroke.radius_m).collect();
        assert!(radii.windows(2).all(|pair| pair[0] != pair[1]), "{radii:?}");
        // It is a plan as any other.
        assert_eq!(Plan::from_toml(plan.text(), "again", Path::new("")).unwrap().strokes(), plan.strokes());
    }
}
