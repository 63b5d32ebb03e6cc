//! `soilctl diagnose --self-test`: hidden campaigns, and how often the diagnosis is right.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_diagnosis::self_test::{SelfTest, Tally, cases, run_case, tally};

use super::Args;
use crate::error::CliError;
use crate::output::{Output, Words};
use crate::text::columns;
use crate::verbs::Outcome;

/// How often the diagnosis was right on hidden campaigns.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct SelfTestAnswer {
    /// Force model.
    model: String,
    /// Seed.
    seed: u64,
    /// Campaigns diagnosed.
    campaigns: usize,
    /// Rates by name, each with the number of campaigns behind it.
    rates: Vec<Rate>,
    /// How often each hidden effect (lambda of at least 25) was answered by which first effect or status.
    confusion: BTreeMap<String, BTreeMap<String, usize>>,
}

/// A rate.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Rate {
    /// What is counted.
    name: String,
    /// The rate; null without campaigns.
    rate: Option<f64>,
    /// Campaigns behind it.
    of: usize,
}

pub(super) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let test = SelfTest::new(&args.model, args.seed)?;
    let cases = cases(args.rounds);
    let bar = output.bar(cases.len() as u64, "campaigns");
    let mut done = 0;
    let mut outcomes = Vec::new();
    let stop = output.interrupt();
    for case in &cases {
        if stop.load(Ordering::Relaxed) {
            break;
        }
        if let Some(outcome) = run_case(&test, case)? {
            outcomes.push((case.clone(), outcome));
        }
        done += 1;
        bar.inc(1);
    }
    bar.finish();
    let stopped = done < cases.len();
    if stopped {
        output.note(&format!("stopped after {done} of {} campaigns", cases.len()));
    }
    let Tally { rates, confusion } = tally(&outcomes);
    output.answer(&SelfTestAnswer {
        model: args.model.clone(),
        seed: args.seed,
        campaigns: outcomes.len(),
        rates: rates.into_iter().map(|r| Rate { name: r.name.into(), rate: r.rate, of: r.of }).collect(),
        confusion,
    })?;
    Ok(if stopped { Outcome::Partial } else { Outcome::Done })
}

impl soilctl_app::Answer for SelfTestAnswer {
    const SCHEMA: &'static str = "soilctl.diagnose-self-test/1";
}

impl Words for SelfTestAnswer {
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
