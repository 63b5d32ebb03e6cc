//! The answer of `diagnose --self-test-logs` in words.

use soilctl_app::diagnose::self_test_logs::Answer;
use soilctl_app::text::columns;

use super::self_test::{confusion, rates};
use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        let mut rows = vec![
            ["campaign", "hidden", "amplitude", "said", "found", "after its follow-up"]
                .map(str::to_owned)
                .to_vec(),
        ];
        for of in &self.campaigns {
            let found =
                of.said.found.map_or_else(|| "-".into(), |(value, sd)| format!("{value:.3e} +- {sd:.1e}"));
            rows.push(vec![
                of.number.to_string(),
                of.hidden.clone().unwrap_or_else(|| "none".into()),
                of.amplitude.map_or_else(|| "-".into(), |size| format!("{size:.3e}")),
                of.said.in_words(),
                found,
                of.follow_up
                    .as_ref()
                    .map_or_else(|| "-".into(), soilctl_app::diagnose::self_test_logs::Said::in_words),
            ]);
        }
        let mut text =
            format!("{} campaigns, model {}, seed {}\n", self.campaigns.len(), self.model, self.seed);
        text += &columns(&rows);
        text += "\n";
        text += &rates(&self.rates);
        text += "\nhidden -> said\n";
        text += &confusion(&self.confusion);
        text
    }
}
