//! The plan of a campaign, from one of its logs.

use std::path::Path;

use soilctl_session::read::{Early, Item, scan};
use soilctl_session::{CONFIGURATION_RECORD, SESSION_RECORD, SessionError};

use crate::{CampaignError, Plan};

impl Plan {
    /// The plan that a log was made by, and the seed of its campaign. Files that the plan names are looked for from the
    /// log's folder on. Soil and effects are those of the plan, whatever a model file changed.
    ///
    /// # Errors
    /// [`CampaignError::Session`] if the log cannot be read or holds no plan, otherwise as [`Plan::from_toml`].
    pub fn from_log(log: &Path) -> Result<(Self, u64), CampaignError> {
        let (mut text, mut seed) = (None, None);
        let read = scan::<Early>(log, &mut |item| {
            match item {
                Item::Metadata { name: SESSION_RECORD, content } => {
                    seed = content.get("seed").and_then(|seed| seed.parse().ok());
                }
                Item::Metadata { name: CONFIGURATION_RECORD, content } => {
                    text = content.get("plan").filter(|text| !text.is_empty()).cloned();
                }
                // Both records come before the first message.
                Item::Message(_) => return Err(Early::Enough),
                _ => {}
            }
            Ok(())
        });
        if let Err(Early::Failed(problem)) = read {
            return Err(problem.into());
        }
        let name = log.display().to_string();
        let (Some(text), Some(seed)) = (text, seed) else {
            let what = format!("{CONFIGURATION_RECORD}: plan");
            let advice = "only campaigns of soilctl can be simulated again";
            return Err(SessionError::Missing { file: name, what, advice }.into());
        };
        Ok((Self::from_toml(&text, &name, log.parent().unwrap_or(Path::new("")))?, seed))
    }

    /// The plan in a log's configuration, from its text alone, to be looked at. What it names by file stands in the log (arm,
    /// controller) or is not at hand (plant): then the default stands in for it. None if it cannot be read even so.
    #[must_use]
    pub fn from_record(text: &str) -> Option<Self> {
        let read = |text: &str| Self::from_toml(text, "plan", Path::new("")).ok();
        let mut table = text.parse::<toml::Table>().ok()?;
        read(text).or_else(|| {
            for keys in [&["arm", "controller"][..], &["plant"]] {
                keys.iter().for_each(|key| {
                    table.remove(*key);
                });
                if let Some(plan) = toml::to_string(&table).ok().and_then(|text| read(&text)) {
                    return Some(plan);
                }
            }
            None
        })
    }
}
