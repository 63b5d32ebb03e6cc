//! Hidden campaigns, and how often the diagnosis is right.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_diagnosis::self_test::{SelfTest, Tally, cases, run_case, tally};

use crate::{AppError, Interrupted, Outcome, Watch};

/// Diagnoses hidden campaigns, and counts how often that is right.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
#[group(skip)]
pub struct Request {
    /// Force model without effects
    #[arg(long, value_name = "NAME", default_value_t = Request::default().model)]
    pub model: String,

    /// Rounds of the self-test; one round is about 80 campaigns
    #[arg(long, value_name = "N", default_value_t = Request::default().rounds)]
    pub rounds: u64,

    /// Seed of the self-test
    #[arg(long, value_name = "N", default_value_t = Request::default().seed)]
    pub seed: u64,
}

impl Default for Request {
    fn default() -> Self {
        Self { model: "table".into(), rounds: 1, seed: 1 }
    }
}

/// How often the diagnosis was right on hidden campaigns.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// Force model.
    pub model: String,
    /// Seed.
    pub seed: u64,
    /// Campaigns diagnosed.
    pub campaigns: usize,
    /// Rates by name, each with the number of campaigns behind it.
    pub rates: Vec<Rate>,
    /// How often each hidden effect (lambda of at least 25) was answered by which first effect or status.
    pub confusion: BTreeMap<String, BTreeMap<String, usize>>,
    /// Whether the work was stopped before the last campaign.
    #[serde(skip)]
    pub stopped: bool,
}

/// A rate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Rate {
    /// What is counted.
    pub name: String,
    /// The rate; null without campaigns.
    pub rate: Option<f64>,
    /// Campaigns behind it.
    pub of: usize,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.diagnose-self-test/1";

    fn outcome(&self) -> Outcome {
        if self.stopped { Outcome::Partial } else { Outcome::Done }
    }
}

/// Diagnoses hidden campaigns; those that are done when it is stopped are counted.
///
/// # Errors
/// [`AppError`] if there is no such force model, or a campaign has no diagnosis.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let test = SelfTest::new(&request.model, request.seed)?;
    let cases = cases(request.rounds);
    let stop = watch.stop(Interrupted::KeepsResults);
    let mut done = 0;
    let mut outcomes = Vec::new();
    watch.begin(cases.len() as u64, "campaigns");
    for case in cases.iter().take_while(|_| !stop.load(Ordering::Relaxed)) {
        if let Some(outcome) = run_case(&test, case)? {
            outcomes.push((case.clone(), outcome));
        }
        done += 1;
        watch.advance(1);
    }
    watch.end();
    let stopped = done < cases.len();
    if stopped {
        watch.note(&format!("stopped after {done} of {} campaigns", cases.len()));
    }
    let Tally { rates, confusion } = tally(&outcomes);
    Ok(Answer {
        model: request.model.clone(),
        seed: request.seed,
        campaigns: outcomes.len(),
        rates: rates.into_iter().map(|r| Rate { name: r.name.into(), rate: r.rate, of: r.of }).collect(),
        confusion,
        stopped,
    })
}
