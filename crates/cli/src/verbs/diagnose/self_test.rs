//! The answer of `diagnose --self-test` in words.

use soilctl_app::diagnose::self_test::Answer;
use soilctl_app::text::columns;

use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        let mut rows = vec![vec!["what".to_owned(), "rate".into(), "of".into()]];
        for rate in &self.rates {
            let shown = rate.rate.map_or_else(|| "-".into(), |r| format!("{r:.3}"));
            rows.push(vec![rate.name.clone(), shown, rate.of.to_string()]);
        }
        let mut text =
            format!("{} hidden campaigns, model {}, seed {}\n", self.campaigns, self.model, self.seed);
        text += &columns(&rows);
        text += "\nhidden (lambda >= 25) -> first answer\n";
        for (hidden, answers) in &self.confusion {
            let counts: Vec<String> = answers.iter().map(|(given, n)| format!("{given} {n}")).collect();
            text += &format!("{hidden}: {}\n", counts.join(", "));
        }
        text
    }
}
