//! The answer of `diagnose --self-test-logs` in words.

use soilctl_app::diagnose::self_test_logs::{Answer, Part, Said};
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
            let each = |text: &dyn Fn(&Part) -> String| {
                let all: Vec<String> = of.hidden.iter().map(text).collect();
                if all.is_empty() { "-".to_owned() } else { all.join(", ") }
            };
            let found = |part: &Part| {
                let sizes = of.said.found.get(&part.name);
                sizes.map_or_else(|| "-".to_owned(), |(value, sd)| format!("{value:.3e} +- {sd:.1e}"))
            };
            rows.push(vec![
                of.number.to_string(),
                of.hidden_name(),
                each(&|part| format!("{:.3e}", part.amplitude)),
                of.said.in_words(),
                each(&found),
                of.follow_up.as_ref().map_or_else(|| "-".into(), Said::in_words),
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
