//! A plan and what is to be done after it.

use std::path::Path;

use super::file::Batch;
use crate::{CampaignError, Plan};

impl Plan {
    /// The text of a plan with further batches after its own. A batch knows nothing of the others and has noise of its own, so that the
    /// simulated arm makes those that it has made again, bit for bit, under the same seed. Files that the plan names are looked for from
    /// `folder` on.
    ///
    /// # Errors
    /// [`CampaignError::Plan`] if there are too many strokes or one is out of its range, and whatever refuses a stroke, such as an arm that
    /// does not reach it.
    pub fn with_further(&self, further: &[Batch], folder: &Path) -> Result<String, CampaignError> {
        let refused =
            |problem: String| CampaignError::Plan { file: "plan of a follow-up".to_owned(), problem };
        let mut table: toml::Table =
            self.text.parse().map_err(|error: toml::de::Error| refused(error.to_string()))?;
        let batches: Vec<&Batch> = self.file.batches.iter().chain(further).collect();
        let batches = toml::Value::try_from(&batches).map_err(|error| refused(error.to_string()))?;
        table.insert("batches".to_owned(), batches);
        let text = toml::to_string(&table).map_err(|error| refused(error.to_string()))?;
        Self::from_toml(&text, "plan of a follow-up", folder)?;
        Ok(text)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::plan::file::Stroke;

    #[test]
    fn batches_are_added_after_those_that_are_there() {
        let text = include_str!("../../../../data/plans/table_6_2.toml");
        let plan = Plan::from_toml(text, "plan", Path::new("")).unwrap();
        let stroke = Stroke {
            radius_m: Some(0.4318),
            base_deg: 10.0,
            alpha_deg: 90.0,
            depth_m: 0.012,
            delta_set_deg: 21.0,
        };
        let further = [Batch { radius_m: None, strokes: vec![stroke] }];
        let text = plan.with_further(&further, Path::new("")).unwrap();
        let both = Plan::from_toml(&text, "both", Path::new("")).unwrap();
        assert_eq!(both.file().batches[..8], plan.file().batches[..]);
        assert_eq!(both.file().batches[8..], further);
        assert_eq!((both.soil(), both.strokes_of(8)), (plan.soil(), 48..49));
        let out_of_reach = Batch { radius_m: Some(2.0), strokes: vec![Stroke { radius_m: None, ..stroke }] };
        assert!(plan.with_further(&[out_of_reach], Path::new("")).is_err());
    }
}
