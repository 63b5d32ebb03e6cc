//! The answer of `diagnose --self-test` in words.

use std::collections::BTreeMap;

use soilctl_app::diagnose::self_test::{Answer, Rate};
use soilctl_app::text::columns;

use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        let mut text =
            format!("{} hidden campaigns, model {}, seed {}\n", self.campaigns, self.model, self.seed);
        text += &rates(&self.rates);
        text += "\nhidden (lambda >= 25) -> first answer\n";
        text += &confusion(&self.confusion);
        text
    }
}

/// A table of rates.
pub(super) fn rates(rates: &[Rate]) -> String {
    let mut rows = vec![vec!["what".to_owned(), "rate".into(), "of".into()]];
    for rate in rates {
        let shown = rate.rate.map_or_else(|| "-".into(), |r| format!("{r:.3}"));
        rows.push(vec![rate.name.clone(), shown, rate.of.to_string()]);
    }
    columns(&rows)
}

/// A line for each hidden effect with what was said of it.
pub(super) fn confusion(confusion: &BTreeMap<String, BTreeMap<String, usize>>) -> String {
    let mut text = String::new();
    for (hidden, answers) in confusion {
        let counts: Vec<String> = answers.iter().map(|(given, n)| format!("{given} {n}")).collect();
        text += &format!("{hidden}: {}\n", counts.join(", "));
    }
    text
}
